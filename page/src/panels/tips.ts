/** Short explanations of what is under the pointer or has the focus: elements with `data-tip`. */
import { h, text } from "./dom";

const WAIT = 350; // ms of rest before one is shown

export function tips(root: HTMLElement): void {
  const bubble = h("div", { class: "tip", role: "tooltip", id: "tip", hidden: true });
  root.append(bubble);
  let timer = 0;
  let subject: Element | null = null;
  const hide = (): void => {
    clearTimeout(timer);
    bubble.hidden = true;
    subject?.removeAttribute("aria-describedby");
    subject = null;
  };
  const show = (element: Element): void => {
    const words = element.getAttribute("data-tip");
    if (!words || !element.isConnected) return;
    text(bubble, words);
    // In a dialog only what is in it can be seen.
    (element.closest("dialog") ?? root).append(bubble);
    bubble.hidden = false;
    element.setAttribute("aria-describedby", "tip");
    const at = element.getBoundingClientRect();
    const own = bubble.getBoundingClientRect();
    const left = Math.min(Math.max(at.left + at.width / 2 - own.width / 2, 8), innerWidth - own.width - 8);
    const below = at.bottom + 8 + own.height < innerHeight;
    bubble.style.left = `${left}px`;
    bubble.style.top = `${below ? at.bottom + 8 : at.top - own.height - 8}px`;
  };
  const begin = (event: Event, wait: number): void => {
    const element = (event.target as Element | null)?.closest?.("[data-tip]") ?? null;
    if (element === subject) return;
    hide();
    if (!element) return;
    subject = element;
    timer = window.setTimeout(() => show(element), wait);
  };
  document.addEventListener("pointerover", (event) => {
    if (event.pointerType !== "touch") begin(event, WAIT);
  });
  document.addEventListener("focusin", (event) => {
    if ((event.target as Element).matches(":focus-visible")) begin(event, WAIT);
  });
  document.addEventListener("focusout", hide);
  document.addEventListener("pointerdown", hide, true);
  document.addEventListener("keydown", hide, true);
  document.addEventListener("scroll", hide, true);
}
