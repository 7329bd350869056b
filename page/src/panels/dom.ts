/** Building the page without a framework: elements, icons, and text that is written only when it changes. */

export type Child = Node | string | null | undefined | false;
type Props = Record<string, unknown>;

const SVG = "http://www.w3.org/2000/svg";

function furnish(element: Element, props: Props | null, children: readonly Child[]): void {
  for (const [name, value] of Object.entries(props ?? {})) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on") && typeof value === "function") {
      element.addEventListener(name.slice(2), value as EventListener);
    } else {
      element.setAttribute(name, value === true ? "" : String(value));
    }
  }
  for (const child of children) if (child) element.append(child);
}

/** An HTML element; properties that begin with "on" are listeners, all others attributes. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  props: Props | null = null,
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  furnish(element, props, children);
  return element;
}

/** The same in SVG. */
export function s<K extends keyof SVGElementTagNameMap>(
  tag: K,
  props: Props | null = null,
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG, tag);
  furnish(element, props, children);
  return element;
}

/** Writes text where it changed; untouched text costs no layout. */
export function text(element: Element, value: string): void {
  if (element.textContent !== value) element.textContent = value;
}

/** Sets or removes an attribute where it changed. */
export function attribute(element: Element, name: string, value: string | null): void {
  if (value === null) element.removeAttribute(name);
  else if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

/** Shows or hides. */
export function shown(element: HTMLElement, yes: boolean): void {
  if (element.hidden === yes) element.hidden = !yes;
}

// Drawn for this page on a grid of 16, lines 1.5 wide.
const ICONS = {
  good: "M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8M5.2 8.2l2 2 3.7-4.2",
  warn: "M8 2 1.8 13.2h12.4zM8 6.4v3.2M8 11.3v.3",
  bad: "M5.4 1.8h5.2l3.6 3.6v5.2l-3.6 3.6H5.4l-3.6-3.6V5.4zM5.8 5.8l4.4 4.4M10.2 5.8l-4.4 4.4",
  wait: "M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8M8 4.6V8l2.4 1.6",
  close: "m4 4 8 8M12 4l-8 8",
  cut: "M5.6 10.6 12.6 3M10.4 10.6 3.4 3M4.2 10.4a1.7 1.7 0 1 0 0 3.4 1.7 1.7 0 0 0 0-3.4M11.8 10.4a1.7 1.7 0 1 0 0 3.4 1.7 1.7 0 0 0 0-3.4",
  mend: "M6.6 9.4a2.6 2.6 0 0 0 3.8.2l2-2a2.6 2.6 0 0 0-3.7-3.7l-1 1M9.4 6.6a2.6 2.6 0 0 0-3.8-.2l-2 2a2.6 2.6 0 0 0 3.7 3.7l1-1",
  invite: "M6.4 2.4a2.6 2.6 0 1 0 0 5.2 2.6 2.6 0 0 0 0-5.2M1.8 13.6c.3-2.6 2-4 4.6-4s4.3 1.4 4.6 4M12.4 5v4M10.4 7h4",
  tour: "M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8m2.8 3.4L9.2 9.2l-4 1.6 1.6-4z",
  light: "M8 5.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6M8 1.4v1.4M8 13.2v1.4M1.4 8h1.4M13.2 8h1.4M3.3 3.3l1 1M11.7 11.7l1 1M12.7 3.3l-1 1M4.3 11.7l-1 1",
  dark: "M13.4 9.6A5.8 5.8 0 0 1 6.4 2.6a5.8 5.8 0 1 0 7 7z",
  auto: "M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8v12.4M8 5h3.6M8 8h5.6M8 11h3.6",
  record: "M8 4.6a3.4 3.4 0 1 0 0 6.8 3.4 3.4 0 0 0 0-6.8",
  stop: "M4.8 4.8h6.4v6.4H4.8z",
  save: "M8 2.4v7M5 6.8l3 3 3-3M2.8 13.2h10.4",
  pause: "M5.6 3.6v8.8M10.4 3.6v8.8",
  play: "m5.2 3.4 7 4.6-7 4.6z",
  keys: "M1.8 4.4h12.4v7.4H1.8zM4.4 7h.2M7 7h.2M9.6 7h.2M12 7h.2M5 9.4h6",
  reset: "M3 8a5 5 0 1 0 1.6-3.7M3 2.6v2.6h2.6",
  grab: "M5 8.4V4.6a1 1 0 0 1 2 0V7.4 3.4a1 1 0 0 1 2 0v4-3a1 1 0 0 1 2 0v3.4-1.6a1 1 0 0 1 2 0v3.4c0 3-1.6 4.6-4.2 4.6-2 0-2.8-.8-4-2.6L2.6 8.8c.6-.8 1.6-.8 2.4-.4",
  ball: "M6.2 6.2a3.6 3.6 0 1 0 0-.1M1.6 13.4c3.4 0 3.4-3.4 6.2-3.4s3 3.4 6.6 3.4",
  blade: "M2.4 13.6 12 4l1.6-1.6c.6 2.6-.4 5-2.4 7L8.6 7.4M5.4 10.6l2 2",
  ghosts: "M8 2.2c-2.6 0-4.2 2-4.2 4.4v6.6l1.6-1.2 1.4 1.2L8 12l1.2 1.2 1.4-1.2 1.6 1.2V6.6c0-2.4-1.6-4.4-4.2-4.4M6.4 6.4v.4M9.6 6.4v.4",
  side: "M2 3.4h5v9.2H2zM9 3.4h5v9.2H9z",
  overlay: "M2.4 2.4h7.8v7.8H2.4zM5.8 5.8h7.8v7.8H5.8z",
  minus: "M3.4 8h9.2",
  tick: "m3.4 8.4 3 3 6.2-6.8",
} as const;

export type IconName = keyof typeof ICONS;

/** A drawn sign; hidden from those who listen, because the words beside it say the same. */
export function icon(name: IconName, size = 16): SVGSVGElement {
  return s(
    "svg",
    { viewBox: "0 0 16 16", width: size, height: size, class: `icon icon-${name}`, "aria-hidden": "true" },
    s("path", { d: ICONS[name] }),
  );
}

/** Changes which sign is drawn. */
export function redraw(drawn: SVGSVGElement, name: IconName): void {
  attribute(drawn, "class", `icon icon-${name}`);
  const path = drawn.firstElementChild;
  if (path) attribute(path, "d", ICONS[name]);
}

/** A button with a sign, words, or both; `label` is what it is called where only the sign is seen. */
export function button(
  words: string,
  act: (event: MouseEvent) => void,
  options: { icon?: IconName; class?: string; label?: string; tip?: string; id?: string } = {},
): HTMLButtonElement {
  return h(
    "button",
    {
      type: "button",
      class: options.class ?? "button",
      id: options.id,
      "aria-label": options.label,
      "data-tip": options.tip,
      onclick: act,
    },
    options.icon && icon(options.icon),
    words && h("span", null, words),
  );
}

/** A choice of one among few, as a row of buttons; arrow keys move in it. */
export interface Choice<T extends string> {
  readonly element: HTMLElement;
  /** Marks what is chosen; null: nothing of it. */
  mark(value: string | null): void;
  /** Lets some be chosen, others not. */
  allow(value: T, yes: boolean): void;
  /** Names one anew. */
  say(value: T, words: string, tip: string): void;
}

export function choice<T extends string>(
  label: string,
  entries: readonly { value: T; words: string; icon?: IconName; tip?: string }[],
  chosen: (value: T) => void,
): Choice<T> {
  const buttons = new Map<T, HTMLButtonElement>();
  const element = h("div", { class: "choice", role: "radiogroup", "aria-label": label });
  for (const entry of entries) {
    const one = button(entry.words, () => chosen(entry.value), {
      class: "choice-one",
      ...(entry.icon ? { icon: entry.icon } : {}),
      ...(entry.tip ? { tip: entry.tip } : {}),
    });
    one.setAttribute("role", "radio");
    one.setAttribute("aria-checked", "false");
    one.dataset.value = entry.value;
    buttons.set(entry.value, one);
    element.append(one);
  }
  element.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) return;
    const all = [...buttons.values()].filter((one) => !one.disabled);
    const here = all.indexOf(document.activeElement as HTMLButtonElement);
    all[(here + step + all.length) % all.length]?.focus();
    event.preventDefault();
    event.stopPropagation();
  });
  const first = (): void => {
    const all = [...buttons.values()];
    const marked = all.find((one) => one.getAttribute("aria-checked") === "true") ?? all[0];
    for (const one of all) attribute(one, "tabindex", one === marked ? "0" : "-1");
  };
  first();
  return {
    element,
    mark(value) {
      for (const [key, one] of buttons) attribute(one, "aria-checked", String(key === value));
      first();
    },
    allow(value, yes) {
      const one = buttons.get(value);
      if (one) one.disabled = !yes;
    },
    say(value, words, tip) {
      const one = buttons.get(value);
      if (!one) return;
      if (one.lastElementChild) text(one.lastElementChild, words);
      attribute(one, "data-tip", tip);
    },
  };
}

let explained = 0;

/** A headed part of the page with a "?" that unfolds what it means. */
export function panel(
  id: string,
  title: string,
  explanation: string | Node,
  ...tools: Child[]
): { element: HTMLElement; body: HTMLElement; head: HTMLElement } {
  const key = `explained-${++explained}`;
  const words = h("div", { class: "explanation", id: key, hidden: true }, explanation);
  const ask = h(
    "button",
    { type: "button", class: "ask", "aria-expanded": "false", "aria-controls": key, "aria-label": `What ${title} shows` },
    "?",
  );
  ask.addEventListener("click", () => {
    words.hidden = !words.hidden;
    ask.setAttribute("aria-expanded", String(!words.hidden));
  });
  const head = h("div", { class: "panel-head" }, h("h2", { id: `${id}-title` }, title), ask, h("div", { class: "grow" }), ...tools);
  const body = h("div", { class: "panel-body" });
  const element = h("section", { id, class: "panel", "aria-labelledby": `${id}-title` }, head, words, body);
  return { element, body, head };
}
