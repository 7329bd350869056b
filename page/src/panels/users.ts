/** Who takes part: how each is doing, and what his hand shall do. */
import type { MoveHand } from "../messages";
import type { Vec } from "../protocol";
import { type Context, can, nameOf, pullTo } from "./context";
import { type Child, attribute, button, choice, h, icon, panel, redraw, shown, text } from "./dom";
import { type Confirmation, confirmation } from "./dialog";
import { NONE, count, hertz, newtons, percent } from "./format";
import { MODES, PRESENCE, presence } from "./words";

const EXPLANATION =
  "Every user moves a copy of the object in a separate process, at its own rate. A step that comes too late is " +
  "skipped; the next is then longer, and energy stays exact. Force is what the hand exerts on its copy. " +
  "Expand a user to tell the hand what to do, to stop the process, or to act as that user.";

const ORDERS: { value: MoveHand["mode"]; words: string; tip: string }[] = [
  { value: "script", words: "Script", tip: "Follow the session file’s script" },
  { value: "hold", words: "Hold", tip: "Keep what is held in its current place" },
  { value: "free", words: "Let go", tip: "Hold nothing" },
  { value: "wander", words: "Wander", tip: "Move it about slowly" },
  { value: "pull", words: "Pull …", tip: "Drag it to a place" },
];

const DIRECTIONS: { words: string; label: string; to: Vec; from: 1 | 2 | 3 }[] = [
  { words: "−x", label: "back, −x", to: [-1, 0, 0], from: 1 },
  { words: "+x", label: "forward, +x", to: [1, 0, 0], from: 1 },
  { words: "−y", label: "right, −y", to: [0, -1, 0], from: 2 },
  { words: "+y", label: "left, +y", to: [0, 1, 0], from: 2 },
  { words: "−z", label: "down, −z", to: [0, 0, -1], from: 3 },
  { words: "+z", label: "up, +z", to: [0, 0, 1], from: 3 },
];

function metric(label: string, tip: string): { element: HTMLElement; value: HTMLElement } {
  const value = h("dd", null, NONE);
  return { element: h("div", { class: "metric", "data-tip": tip }, h("dt", null, label), value), value };
}

/** The address of this page, for another user. */
export function addressFor(slot: number): string {
  const url = new URL(location.href);
  url.searchParams.set("user", String(slot + 1));
  return url.href;
}

function card(context: Context, slot: number, leaving: Confirmation): { element: HTMLElement; update: () => void } {
  const { store } = context;
  const own = !!store.scene?.own.includes(slot);
  const me = (): boolean => store.me === slot;
  const sign = icon("wait", 14);
  const state = h("span", { class: "presence-words" });
  const mine = h("span", { class: "chip chip-mine", hidden: true }, "you");
  const hand = h("span", { class: "hand-mode" });
  const rate = metric("rate", "Steps per second");
  const skipped = metric("missed", "Share of all due steps that came too late and were skipped, since the start");
  const force = metric("force", "Force of the hand on its copy");
  const folded = `user-${slot}-more`;
  const head = h(
    "button",
    { type: "button", class: "user-head", "aria-expanded": "false", "aria-controls": folded },
    h("span", { class: "badge", style: `--user:var(--user-${slot});--on-user:var(--on-user-${slot})` }, String(slot + 1)),
    h("span", { class: "user-name", style: `--user:var(--user-${slot})` }, nameOf(store, slot)),
    mine,
    h("span", { class: "grow" }),
    h("span", { class: "presence" }, sign, state),
  );
  head.addEventListener("click", () => context.opened.set(context.opened.get() === slot ? null : slot));

  const pulls = h("div", { class: "pulls", hidden: true });
  const ask = (mode: MoveHand["mode"], more: Pick<MoveHand, "node" | "to"> = {}): void => {
    context.aiming.set(null);
    void context.act({ what: "hand", slot, mode, ...more });
  };
  const orders = choice(`Hand of ${nameOf(store, slot)}`, ORDERS, (mode) => {
    if (mode !== "pull") {
      pulls.hidden = true;
      ask(mode);
    } else {
      pulls.hidden = !pulls.hidden;
      context.aiming.set(pulls.hidden ? null : { slot });
    }
  });
  pulls.append(
    h("p", { class: "hint" }, "Click in the picture where to pull to, or choose a direction:"),
    h(
      "div",
      { class: "directions", role: "group", "aria-label": "Direction to pull" },
      ...DIRECTIONS.filter((one) => one.from <= (store.scene?.dimension ?? 1)).map((one) =>
        button(one.words, () => {
          const goal = pullTo(context, slot, one.to);
          if (goal) ask("pull", goal);
        }, { class: "button small", label: `Pull ${one.label}` }),
      ),
    ),
  );
  const take = button("Take over", () => {
    store.take(slot);
    history.replaceState(null, "", addressFor(slot));
    context.say(`This page now acts as ${nameOf(store, slot)}.`);
  }, { class: "button small", tip: "Your pointer moves this user’s hand" });
  const window_ = button("New window", () => void open(addressFor(slot), "_blank", "noopener"), {
    class: "button small", tip: "Open another page that acts as this user",
  });
  const kill = button("Stop process", () => void context.act({ what: "kill", slot }), {
    class: "button small danger", icon: "stop", tip: "End this user’s process at once, as a crash would",
  });
  const away = button("Remove …", () => {
    const name = nameOf(store, slot);
    leaving.ask(`Remove ${name}?`, `${name} takes part from another computer. The slot becomes free at once, and whoever is removed cannot come back for the rest of the session.`, () => void context.act({ what: "expel", slot }));
  }, { class: "button small danger", icon: "stop", tip: "Remove whoever plays this user on another computer" });
  const revive = button("Restart process", () => void context.act({ what: "revive", slot }), { class: "button small", icon: "reset" });
  const actions: Child[] = [take, window_, kill, away, revive];
  const more = h("div", { class: "user-more", id: folded, hidden: true }, orders.element, pulls, h("div", { class: "actions" }, ...actions));
  const element = h(
    "li",
    { class: "user", "data-slot": slot },
    head,
    h("dl", { class: "metrics" }, rate.element, skipped.element, force.element),
    hand,
    more,
  );

  const update = (): void => {
    const member = store.state?.members[slot];
    const now = presence(store.state, slot);
    redraw(sign, PRESENCE[now].icon);
    text(state, PRESENCE[now].words);
    attribute(element, "data-presence", now);
    shown(mine, me());
    attribute(element, "data-mine", me() ? "" : null);
    const live = now === "here" || now === "over" ? member : undefined;
    text(rate.value, hertz(live?.rate));
    const missed = live?.missed ?? 0;
    const due = (live?.steps ?? 0) + missed;
    text(skipped.value, due ? percent(missed / due) : NONE);
    attribute(skipped.element, "data-tip", due ? `${count(missed)} of ${count(due)} due steps came too late and were skipped` : null);
    text(force.value, newtons(live?.force));
    text(hand, live ? (MODES[live.hand ?? "elsewhere"] ?? "") : "");
    orders.mark(live && own ? live.hand : null);
    const open = context.opened.get() === slot;
    attribute(head, "aria-expanded", String(open));
    shown(more, open);
    if (!open) {
      pulls.hidden = true;
      if (context.aiming.get()?.slot === slot) context.aiming.set(null);
    }
    const may = can(context, "hand") && own && now === "here";
    for (const order of ORDERS) orders.allow(order.value, may);
    take.disabled = !own || !context.connection.hasToken || store.slot === slot;
    window_.disabled = !own;
    const stopped = now === "stopped" || (now === "gone" && own);
    const elsewhere = !!member?.here && member.alive === null;
    shown(away, elsewhere && !!store.scene?.may.includes("expel"));
    away.disabled = !can(context, "expel");
    shown(kill, !stopped && !(own && elsewhere));
    shown(revive, stopped);
    kill.disabled = !can(context, "kill") || !own || now === "awaited";
    revive.disabled = !can(context, "revive") || !own;
  };
  return { element, update };
}

/** The panel of users. */
export function usersPanel(context: Context): HTMLElement {
  const { store } = context;
  const here = h("span", { class: "panel-note" });
  const { element, body } = panel("users", "Users", EXPLANATION, here);
  const list = h("ul", { class: "users" });
  const leaving = confirmation("Remove");
  body.append(list);
  let cards: { element: HTMLElement; update: () => void }[] = [];
  const update = (): void => {
    for (const one of cards) one.update();
    const all = store.scene?.users ?? [];
    text(here, all.length ? `${all.filter((user) => ["here", "over"].includes(presence(store.state, user.slot))).length} of ${all.length} here` : "");
  };
  let built = "";
  const build = (): void => {
    const scene = store.scene;
    // The server may say its scene again; what is unfolded stays so.
    const key = scene ? JSON.stringify([scene.started, scene.users, scene.own, scene.dimension]) : "";
    if (key === built) return update();
    built = key;
    cards = (scene?.users ?? []).map((user) => card(context, user.slot, leaving));
    list.replaceChildren(...cards.map((one) => one.element));
    update();
  };
  store.on("scene", build);
  for (const kind of ["state", "slot", "connection"] as const) store.on(kind, update);
  context.opened.on(update);
  build();
  return element;
}
