/** Single keys that do what buttons do, and a page that tells them. */
import { turnTheme } from "../theme";
import { type Context, nameOf } from "./context";
import { h } from "./dom";
import { dialog } from "./dialog";
import { addressFor } from "./users";

const OFF = "cotouch.keys";

export interface Deeds {
  tour: () => void;
  invite: () => void;
  record: () => void;
  freeze: () => void;
  reset: () => void;
}

const COLOURS = ["displacement", "stress", "plain"] as const;

const TABLE: [string, string][] = [
  ["1 … 8", "act as this user"],
  ["G", "grab the nearest point; arrows move it, Esc lets go"],
  ["B", "switch tools: grab, ball or blade"],
  ["Shift", "while holding a rigid tool: drag and wheel turn it"],
  ["S", "show copies overlaid or side by side"],
  ["C", "change what colours show"],
  ["0", "reset the view"],
  ["F", "freeze the plots"],
  ["R", "start or stop recording"],
  ["I", "invite"],
  ["T", "tour: ← → change steps, Esc leaves"],
  ["D", "change the theme"],
  ["Tab, Enter", "move to and open anything, including links"],
  ["+ −", "change the focused link’s delay"],
  ["?", "show these shortcuts"],
];

/** Whether somebody types text or sets a value, so that keys are his. */
function typing(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest("input, textarea, select, [contenteditable]") !== null;
}

export function keyboard(context: Context, deeds: Deeds): { open: () => void } {
  const { store } = context;
  let off = false;
  try {
    off = localStorage.getItem(OFF) === "off";
  } catch {
    // Without storage keys are on.
  }
  const single = h("input", { type: "checkbox" });
  single.checked = !off;
  single.addEventListener("change", () => {
    off = !single.checked;
    try {
      localStorage.setItem(OFF, off ? "off" : "on");
    } catch {
      // Then it holds until the page is left.
    }
  });
  const box = dialog("Keyboard", [
    h("dl", { class: "keys" }, ...TABLE.flatMap(([keys, does]) => [h("dt", null, ...keys.split(" ").map((key) => (key === "…" ? " … " : h("kbd", null, key)))), h("dd", null, does)])),
    h("label", { class: "check" }, single, h("span", null, "Enable single-key shortcuts")),
  ], []);
  const act: Record<string, () => void> = {
    b: () => store.set({ tool: store.tools[(store.tools.indexOf(store.tool) + 1) % store.tools.length] ?? "grab" }),
    s: () => store.set({ layout: store.settings.layout === "overlay" ? "side" : "overlay" }),
    c: () => store.set({ colour: COLOURS[(COLOURS.indexOf(store.colour) + 1) % COLOURS.length] ?? "plain" }),
    "0": deeds.reset,
    f: deeds.freeze,
    r: deeds.record,
    i: deeds.invite,
    t: deeds.tour,
    d: () => turnTheme(store),
  };
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || event.repeat || typing(event.target)) return;
    if (document.querySelector("dialog[open]")) return;
    if (event.key === "?") {
      event.preventDefault();
      return box.open();
    }
    if (off) return;
    const slot = Number(event.key) - 1;
    if (event.key.length === 1 && slot >= 0 && slot < 8) {
      if (!store.scene?.own.includes(slot)) {
        if (store.scene?.users.some((user) => user.slot === slot)) context.say(`${nameOf(store, slot)} is moved from elsewhere; this page cannot act for that user.`, "warn");
        return;
      }
      store.take(slot);
      history.replaceState(null, "", addressFor(slot));
      context.say(`This page now acts as ${nameOf(store, slot)}.`);
      return;
    }
    act[event.key.toLowerCase()]?.();
  });
  return { open: box.open };
}
