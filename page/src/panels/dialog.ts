/** Windows in the page that ask or tell one thing; the browser keeps the focus in them and gives it back. */
import { button, h, text } from "./dom";

export interface Action {
  words: string;
  class: string;
  act: () => void;
  /** Gets the focus when it opens. */
  focus?: boolean;
}

let made = 0;

export function dialog(
  title: string,
  content: (Node | string)[],
  actions: readonly Action[],
): { element: HTMLDialogElement; open: () => void; close: () => void } {
  const key = `dialog-${++made}`;
  const element = h("dialog", { class: "dialog", "aria-labelledby": key });
  const close = (): void => element.close();
  element.append(
    h("div", { class: "panel-head" }, h("h2", { id: key }, title), h("div", { class: "grow" }), button("", close, { icon: "close", class: "button bare", label: "Close" })),
    h("div", { class: "dialog-body" }, ...content),
    h(
      "div",
      { class: "dialog-actions" },
      ...actions.map((action) => {
        const one = button(action.words, () => {
          close();
          action.act();
        }, { class: action.class });
        if (action.focus) one.autofocus = true;
        return one;
      }),
    ),
  );
  // A click beside it closes it.
  element.addEventListener("click", (event) => {
    if (event.target === element) close();
  });
  document.body.append(element);
  return {
    element,
    close,
    open: () => {
      if (!element.open) element.showModal();
    },
  };
}

export interface Confirmation {
  /** Asks, and does it if the answer is yes. */
  ask(title: string, words: string, act: () => void): void;
}

/** A dialog that asks before something is done that cannot be taken back. */
export function confirmation(yes: string): Confirmation {
  const question = h("p", null);
  let does = (): void => undefined;
  const box = dialog(yes, [question], [
    { words: yes, class: "button danger", act: () => does() },
    { words: "Cancel", class: "button primary", act: () => undefined, focus: true },
  ]);
  const title = box.element.querySelector("h2");
  return {
    ask(asked, words, act) {
      if (title) text(title, asked);
      text(question, words);
      does = act;
      box.open();
    },
  };
}
