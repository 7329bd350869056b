/** What happened, newest first. */
import type { Context } from "./context";
import { h, panel, shown } from "./dom";
import { clock } from "./format";

const KEPT = 200;

export function eventsPanel(context: Context): HTMLElement {
  const { store } = context;
  const { element, body } = panel("events", "Events", "What happened in the session: who joined and left, which links were guarded, and what was requested. Newest first.");
  const list = h("ol", { class: "events tabular" });
  const empty = h("p", { class: "hint" }, "Nothing has happened yet.");
  body.append(empty, list);
  let newest = -Infinity;
  let seen = new Set<string>();
  let run = "";
  const update = (): void => {
    const started = store.scene?.started ?? "";
    if (started !== run) {
      run = started;
      [newest, seen] = [-Infinity, new Set()];
      list.replaceChildren();
    }
    for (const event of store.state?.events ?? []) {
      const key = `${event.time} ${event.text}`;
      if (event.time < newest || seen.has(key)) continue;
      if (event.time > newest) seen.clear();
      newest = event.time;
      seen.add(key);
      list.prepend(h("li", null, h("time", null, clock(event.time)), h("span", null, event.text)));
    }
    while (list.children.length > KEPT) list.lastElementChild?.remove();
    shown(empty, !list.children.length);
  };
  store.on("state", update);
  update();
  return element;
}
