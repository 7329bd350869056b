/** Who takes part: how each is doing, and what his hand shall do. */
import type { HandMode, Vec } from "../protocol";
import { type Context, can, nameOf, pullTo } from "./context";
import { type Child, attribute, button, choice, h, icon, panel, redraw, shown, text } from "./dom";
import { NONE, count, hertz, newtons, percent } from "./format";
import { MODES, PRESENCE, presence } from "./words";

const EXPLANATION =
  "Every user moves a copy of the object in a process of its own, at its own rate. Late steps came more than half a period " +
  "after they were due; the next step is then longer, and energy stays exact. Force is what the hand exerts on its copy. " +
  "Unfold a user to tell its hand what to do, to stop its process, or to act as that user.";

const ORDERS: { value: HandMode; words: string; tip: string }[] = [
  { value: "script", words: "Script", tip: "Move as the session’s file says" },
  { value: "hold", words: "Hold", tip: "Keep what is held where it is now" },
  { value: "free", words: "Let go", tip: "Hold nothing" },
  { value: "wander", words: "Wander", tip: "Draw it about slowly" },
  { value: "pull", words: "Pull …", tip: "Draw it to a place" },
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
export function addressFor(seat: number): string {
  const url = new URL(location.href);
  url.searchParams.set("user", String(seat + 1));
  return url.href;
}

function card(context: Context, seat: number): { element: HTMLElement; update: () => void } {
  const { store } = context;
  const own = !!store.scene?.own.includes(seat);
  const sign = icon("wait", 14);
  const state = h("span", { class: "presence-words" });
  const mine = h("span", { class: "chip chip-mine", hidden: true }, "you");
  const hand = h("span", { class: "hand-mode" });
  const rate = metric("rate", "Steps per second");
  const late = metric("late", "Share of steps that came late, since the start");
  const force = metric("force", "Of the hand on its copy");
  const folded = `user-${seat}-more`;
  const head = h(
    "button",
    { type: "button", class: "user-head", "aria-expanded": "false", "aria-controls": folded },
    h("span", { class: "badge", style: `--user:var(--user-${seat})` }, String(seat + 1)),
    h("span", { class: "user-name", style: `--user:var(--user-${seat})` }, nameOf(store, seat)),
    mine,
    h("span", { class: "grow" }),
    h("span", { class: "presence" }, sign, state),
  );
  head.addEventListener("click", () => context.opened.set(context.opened.get() === seat ? null : seat));

  const pulls = h("div", { class: "pulls", hidden: true });
  const ask = (mode: HandMode, more: object = {}): void => {
    context.aiming.set(null);
    void context.act("hand", { seat, mode, ...more });
  };
  const orders = choice(`Hand of ${nameOf(store, seat)}`, ORDERS, (mode) => {
    if (mode !== "pull") {
      pulls.hidden = true;
      ask(mode);
    } else {
      pulls.hidden = !pulls.hidden;
      context.aiming.set(pulls.hidden ? null : { seat });
    }
  });
  pulls.append(
    h("p", { class: "hint" }, "Click in the picture where to pull, or choose a direction:"),
    h(
      "div",
      { class: "directions", role: "group", "aria-label": "Direction to pull" },
      ...DIRECTIONS.filter((one) => one.from <= (store.scene?.dimension ?? 1)).map((one) =>
        button(one.words, () => {
          const goal = pullTo(context, seat, one.to);
          if (goal) ask("pull", goal);
        }, { class: "button small", label: `Pull ${one.label}` }),
      ),
    ),
  );
  const take = button("Take over", () => {
    store.take(seat);
    history.replaceState(null, "", addressFor(seat));
    context.say(`This page now acts as ${nameOf(store, seat)}.`);
  }, { class: "button small", tip: "Your pointer moves this user’s hand" });
  const window_ = button("New window", () => void open(addressFor(seat), "_blank", "noopener"), {
    class: "button small", tip: "Open another page that acts as this user",
  });
  const kill = button("Stop process", () => void context.act("kill", { seat }), {
    class: "button small danger", icon: "stop", tip: "Ends this user’s process at once, as a crash would",
  });
  const revive = button("Bring back", () => void context.act("revive", { seat }), { class: "button small", icon: "reset" });
  const actions: Child[] = [take, window_, kill, revive];
  const more = h("div", { class: "user-more", id: folded, hidden: true }, orders.element, pulls, h("div", { class: "actions" }, ...actions));
  const element = h(
    "li",
    { class: "user", "data-seat": seat },
    head,
    h("dl", { class: "metrics" }, rate.element, late.element, force.element),
    hand,
    more,
  );

  const update = (): void => {
    const member = store.state?.members[seat];
    const now = presence(store.state, seat);
    redraw(sign, PRESENCE[now].icon);
    text(state, PRESENCE[now].words);
    attribute(element, "data-presence", now);
    shown(mine, store.seat === seat && own);
    attribute(element, "data-mine", store.seat === seat && own ? "" : null);
    const live = now === "here" ? member : undefined;
    text(rate.value, hertz(live?.rate));
    text(late.value, live?.steps ? percent((live.missed ?? 0) / live.steps) : NONE);
    attribute(late.element, "data-tip", live?.steps ? `${count(live.missed ?? 0)} of ${count(live.steps)} steps came late` : null);
    text(force.value, newtons(live?.force));
    text(hand, live ? (MODES[live.hand ?? "elsewhere"] ?? "") : "");
    orders.mark(live && own ? live.hand : null);
    const open = context.opened.get() === seat;
    attribute(head, "aria-expanded", String(open));
    shown(more, open);
    if (!open) {
      pulls.hidden = true;
      if (context.aiming.get()?.seat === seat) context.aiming.set(null);
    }
    const may = can(context, "hand") && own && now === "here";
    for (const order of ORDERS) orders.allow(order.value, may);
    take.disabled = !own || store.seat === seat;
    window_.disabled = !own;
    const stopped = now === "stopped" || (now === "gone" && own);
    shown(kill, !stopped);
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
  body.append(list);
  let cards: { element: HTMLElement; update: () => void }[] = [];
  const update = (): void => {
    for (const one of cards) one.update();
    const all = store.scene?.users ?? [];
    text(here, all.length ? `${all.filter((user) => presence(store.state, user.seat) === "here").length} of ${all.length} here` : "");
  };
  let built = "";
  const build = (): void => {
    const scene = store.scene;
    // The server may say its scene again; what is unfolded stays so.
    const key = scene ? JSON.stringify([scene.started, scene.users, scene.own, scene.dimension]) : "";
    if (key === built) return update();
    built = key;
    cards = (scene?.users ?? []).map((user) => card(context, user.seat));
    list.replaceChildren(...cards.map((one) => one.element));
    update();
  };
  store.on("scene", build);
  for (const kind of ["state", "seat", "connection"] as const) store.on(kind, update);
  context.opened.on(update);
  build();
  return element;
}
