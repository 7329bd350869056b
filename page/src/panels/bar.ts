/** The line on top: what the session is, how it stands, and what can be done with all of it. */
import type { Context } from "./context";
import { can } from "./context";
import { attribute, button, h, icon, redraw, s, shown, text } from "./dom";
import { clock } from "./format";
import type { ConnectionState } from "../store";
import { themeButton } from "../theme";

const LEVELS = { good: "good", warn: "attention", bad: "not guaranteed" } as const;

const WORDS: Record<ConnectionState, string> = {
  connecting: "Connecting …", open: "Waiting for the copies …", silent: "No response", lost: "Connection lost", refused: "Refused",
};

function mark(): SVGSVGElement {
  return s(
    "svg",
    { viewBox: "0 0 24 24", width: 24, height: 24, class: "mark", "aria-hidden": "true" },
    s("circle", { cx: 8, cy: 9, r: 5.4, class: "mark-a" }),
    s("circle", { cx: 16, cy: 9, r: 5.4, class: "mark-b" }),
    s("circle", { cx: 12, cy: 15.6, r: 5.4, class: "mark-c" }),
  );
}

const FETCH = 10_000; // ms for the server to say that it has the recording

/** Record, stop and download; what came of it is said. */
function recorder(context: Context): { element: HTMLElement; toggle: () => void } {
  const { store, connection } = context;
  const busy = (): boolean => store.state?.recording.state === "ending";
  const toggle = (): void => {
    if (can(context, "record") && !busy()) void context.act({ what: "record", on: store.state?.recording.state !== "on" });
  };
  const words = h("span", { class: "tabular" }, "Record");
  const record = h("button", { type: "button", class: "button", id: "record", "data-tip": "Record every copy, to audit or replay later (R)" }, icon("record"), words);
  record.addEventListener("click", toggle);
  const save = button("", () => void fetched(context), { icon: "save", class: "button", id: "download", label: "Download the recording" });
  save.append(h("span", { class: "label" }, "Download"));
  /** Number of the last recording whose end was said, or was before this page came; -1: not known yet. */
  let told = -1;
  const update = (): void => {
    const now = store.state?.recording;
    const on = now?.state === "on";
    const wrong = !!now?.troubles.length && now.state !== "off";
    attribute(record, "data-on", on ? "" : null);
    attribute(record, "data-wrong", wrong ? "" : null);
    attribute(record, "aria-pressed", String(on));
    const does = on ? "Stop recording" : busy() ? "Finishing the recording" : "Record";
    attribute(record, "aria-label", wrong ? `${does}; the recording is incomplete` : does);
    const drawn = record.querySelector("svg");
    if (drawn) redraw(drawn, on ? (wrong ? "warn" : "stop") : busy() ? "wait" : now?.state === "failed" ? "warn" : "record");
    text(words, on ? clock(now.seconds) : busy() ? "Finishing …" : "Record");
    record.disabled = !can(context, "record") || busy();
    shown(record, !!store.scene?.may.includes("record"));
    shown(save, now?.state === "done" && connection.hasToken);
    save.disabled = store.connection !== "open";
    if (now?.state === "done") attribute(save, "data-tip", `${now.text}, as a ZIP of MCAP files`);
    const over = now?.state === "done" || now?.state === "failed" ? now.number : 0;
    // What was over before this page came is no news.
    if (now && over > told && told >= 0) context.say(now.state === "done" ? `Recorded: ${now.text}.` : "Nothing was recorded.", now.troubles.length ? "bad" : "good");
    if (now) told = over || Math.max(0, now.number - 1);
  };
  for (const kind of ["scene", "state", "connection"] as const) store.on(kind, update);
  update();
  return { element: h("div", { class: "recorder" }, record, save), toggle };
}

/** Asks whether the recording is there, so that one that is not is said, and lets the browser save it. */
async function fetched(context: Context): Promise<void> {
  const address = context.connection.link("recording.zip");
  try {
    const there = await fetch(address, { method: "HEAD", cache: "no-store", signal: AbortSignal.timeout(FETCH) });
    if (!there.ok) return context.say("The server no longer has the recording.", "bad");
  } catch {
    return context.say("The server did not respond; the recording is still there. Try again.", "bad");
  }
  h("a", { href: address, download: "cotouch-recording.zip" }).click();
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
  const invite = button("Invite", does.invite, { icon: "invite", class: "button", id: "invite", tip: "Invite somebody to take part from another computer (I)" });
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
      button("Tour", does.tour, { icon: "tour", class: "button", id: "tour-open", tip: "A two-minute tour of everything (T)" }),
      button("", does.keys, { icon: "keys", class: "button bare", label: "Keyboard shortcuts", tip: "Keyboard shortcuts (?)" }),
      themeButton(store),
    ),
  );
  const update = (): void => {
    text(title, store.scene?.title ?? "");
    attribute(title, "title", store.scene ? `${store.scene.title} · cotouch ${store.scene.version}` : null);
    const now = store.live || store.state?.ended ? store.state?.verdict : undefined;
    attribute(verdict, "data-level", now?.level ?? "none");
    redraw(sign, now?.level ?? "wait");
    text(level, now ? `${LEVELS[now.level]}: ` : "");
    const sentence = now?.text ?? WORDS[store.stalled ? "silent" : store.connection];
    const said = sentence && sentence[0]?.toUpperCase() + sentence.slice(1);
    text(words, said);
    attribute(verdict, "data-tip", `${said}. Safe (passive) means that nobody can take out energy that nobody put in. Click to see the margin of every link.`);
    const named = [store.scene?.title, "cotouch"].filter(Boolean).join(" · ");
    if (document.title !== named) document.title = named;
    invite.hidden = !store.scene?.invitation;
  };
  for (const kind of ["scene", "state", "connection"] as const) store.on(kind, update);
  update();
  return { element, record: recording.toggle };
}
