/** The line on top: what the session is, how it stands, and what can be done with all of it. */
import type { Context } from "./context";
import { can } from "./context";
import { attribute, button, h, icon, redraw, s, shown, text } from "./dom";
import { clock } from "./format";
import { themeButton } from "../theme";

const LEVELS = { good: "good", warn: "take note", bad: "not guaranteed" } as const;

function mark(): SVGSVGElement {
  return s(
    "svg",
    { viewBox: "0 0 24 24", width: 24, height: 24, class: "mark", "aria-hidden": "true" },
    s("circle", { cx: 8, cy: 9, r: 5.4, class: "mark-a" }),
    s("circle", { cx: 16, cy: 9, r: 5.4, class: "mark-b" }),
    s("circle", { cx: 12, cy: 15.6, r: 5.4, class: "mark-c" }),
  );
}

/** Record, stop and download. */
function recorder(context: Context): { element: HTMLElement; toggle: () => void } {
  const { store, connection } = context;
  const toggle = (): void => {
    if (can(context, "record")) void context.act("record", { on: store.state?.recording == null });
  };
  const words = h("span", { class: "tabular" }, "Record");
  const record = h("button", { type: "button", class: "button", id: "record", "data-tip": "Record what every copy does, to audit or replay it (R)" }, icon("record"), words);
  record.addEventListener("click", toggle);
  const save = h("a", { class: "button", download: "recording.zip", hidden: true, id: "download", "data-tip": "The last recording, as a ZIP of MCAP files" }, icon("save"), h("span", { class: "label" }, "Download"));
  const update = (): void => {
    const seconds = store.state?.recording ?? null;
    const on = seconds !== null;
    attribute(record, "data-on", on ? "" : null);
    attribute(record, "aria-pressed", String(on));
    attribute(record, "aria-label", on ? "Stop recording" : "Record");
    const drawn = record.querySelector("svg");
    if (drawn) redraw(drawn, on ? "stop" : "record");
    text(words, on ? clock(seconds) : "Record");
    record.disabled = !can(context, "record");
    shown(record, !!store.scene?.may.includes("record"));
    const ready = !!store.state?.recorded && !on && connection.hasToken;
    shown(save, ready);
    if (ready) attribute(save, "href", connection.link("recording.zip"));
  };
  for (const kind of ["scene", "state", "connection"] as const) store.on(kind, update);
  update();
  return { element: h("div", { class: "recorder" }, record, save), toggle };
}

export function topBar(
  context: Context,
  does: { tour: () => void; keys: () => void; invite: () => void },
): { element: HTMLElement; record: () => void } {
  const { store } = context;
  const title = h("span", { class: "session" });
  const sign = icon("wait", 18);
  const level = h("span", { class: "unseen" });
  const words = h("span", { class: "verdict-words" }, "Connecting …");
  const verdict = h("button", { type: "button", class: "verdict", id: "verdict",  }, sign, level, words);
  verdict.addEventListener("click", () => context.tab.set("margin"));
  const invite = button("Invite", does.invite, { icon: "invite", class: "button", id: "invite", tip: "Let somebody take part from another computer (I)" });
  const recording = recorder(context);
  const element = h(
    "header",
    { class: "bar" },
    h("h1", { class: "brand" }, mark(), h("span", null, "cotouch"), title),
    verdict,
    h(
      "div",
      { class: "bar-tools" },
      recording.element,
      invite,
      button("Tour", does.tour, { icon: "tour", class: "button", id: "tour-open", tip: "Two minutes through everything (T)" }),
      button("", does.keys, { icon: "keys", class: "button bare", label: "Keyboard shortcuts", tip: "Keyboard shortcuts (?)" }),
      themeButton(store),
    ),
  );
  const update = (): void => {
    text(title, store.scene?.title ?? "");
    attribute(title, "title", store.scene ? `${store.scene.title} · cotouch ${store.scene.version}` : null);
    const now = store.connection === "open" ? store.state?.verdict : undefined;
    attribute(verdict, "data-level", now?.level ?? "none");
    redraw(sign, now?.level ?? "wait");
    text(level, now ? `${LEVELS[now.level]}: ` : "");
    const sentence = now?.text ?? (store.connection === "open" ? "Waiting for the copies …" : store.connection === "lost" ? "Connection lost" : "Connecting …");
    const said = sentence && sentence[0]?.toUpperCase() + sentence.slice(1);
    text(words, said);
    attribute(verdict, "data-tip", `${said}. Opens the margin of every link.`);
    const named = [store.scene?.title, "cotouch"].filter(Boolean).join(" · ");
    if (document.title !== named) document.title = named;
    invite.hidden = !store.scene?.invitation;
  };
  for (const kind of ["scene", "state", "connection"] as const) store.on(kind, update);
  update();
  return { element, record: recording.toggle };
}
