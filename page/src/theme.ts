/** Light, dark, or as the system is. colours.ts puts it into effect. */
import type { Theme } from "./colours";
import { button, redraw } from "./panels/dom";
import type { Store } from "./store";

const NEXT: Record<Theme, Theme> = { auto: "light", light: "dark", dark: "auto" };
const WORDS: Record<Theme, string> = { auto: "system", light: "light", dark: "dark" };

/** The next of system, light and dark. */
export function turnTheme(store: Store): void {
  store.set({ theme: NEXT[store.settings.theme] });
}

export function themeButton(store: Store): HTMLButtonElement {
  const element = button("", () => turnTheme(store), { icon: "auto", class: "button bare", label: "Theme", id: "theme" });
  const update = (): void => {
    const { theme } = store.settings;
    const drawn = element.querySelector("svg");
    if (drawn) redraw(drawn, theme);
    element.setAttribute("aria-label", `Theme: ${WORDS[theme]}`);
    element.setAttribute("data-tip", `Theme: ${WORDS[theme]} (D)`);
  };
  store.on("settings", update);
  update();
  return element;
}
