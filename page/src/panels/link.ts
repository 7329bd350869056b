/** One link: what is done to it, and what both its ends say. */
import type { LinkStatus } from "../protocol";
import { type Context, type Pair, can, nameOf } from "./context";
import { attribute, button, h, icon, redraw, shown, text } from "./dom";
import { count, hertz, lengthOf, linkName, ms, newtons, number, percent, si } from "./format";
import { paced } from "./network";
import { CONDITIONS, condition, endCondition, isCut, meaning, spare } from "./words";

const ROWS: { words: string; tip: string; show: (end: LinkStatus) => string }[] = [
  { words: "state", tip: "State of this end’s spring", show: (end) => CONDITIONS[endCondition(end)].words },
  { words: "age", tip: "Age of the newest sample in the last step, up to the offset between the two clocks", show: (end) => ms(end.age) },
  { words: "age sum", tip: "Largest recent sum of the ages at both ends, in which clock offsets cancel", show: (end) => ms(end.age_sum) },
  { words: "budget", tip: "Largest sum of ages that the damping covers", show: (end) => ms(end.budget) },
  { words: "path", tip: "Shortest round trip, and whether the path is direct or relayed", show: (end) => `${ms(end.round_trip)} ${end.path_state}` },
  { words: "loss", tip: "Share of the neighbour’s samples that did not arrive", show: (end) => percent(end.loss) },
  { words: "samples", tip: "Samples sent to the neighbour per second", show: (end) => hertz(end.rate) },
  { words: "data", tip: "Data and datagrams sent to the neighbour per second, and what the perceptual codec saved", show: (end) => `${si(end.byte_rate, "B/s")} in ${number(end.datagram_rate)}${end.saved > 0 ? `, ${percent(end.saved, 0)} saved` : ""}` },
  { words: "force", tip: "Force of the link’s spring on this copy", show: (end) => newtons(end.force) },
  { words: "work", tip: "Work of the link on this copy since the start", show: (end) => si(end.work, "J") },
  { words: "apart", tip: "Largest difference between the copies, as far as known", show: (end) => lengthOf(end.difference) },
  { words: "guarded", tip: "How often the link was guarded", show: (end) => `${count(end.guarded)} ×` },
];

interface Slider {
  element: HTMLElement;
  set(value: number): void;
  enable(yes: boolean): void;
}

function slider(
  words: string,
  tip: string,
  scale: { most: number; step: number; show: (value: number) => string },
  changed: (value: number) => void,
): Slider {
  const output = h("output", { class: "tabular" }, scale.show(0));
  const input = h("input", { type: "range", min: 0, max: scale.most, step: scale.step, value: 0, "aria-label": words });
  let touched = -Infinity;
  const send = paced(changed);
  const wear = (): void => {
    const value = Number(input.value);
    text(output, scale.show(value));
    attribute(input, "aria-valuetext", scale.show(value));
    input.style.setProperty("--share", `${(100 * value) / scale.most}%`);
  };
  input.addEventListener("input", () => {
    touched = performance.now();
    wear();
    send(Number(input.value));
  });
  return {
    element: h("label", { class: "slider", "data-tip": tip }, h("span", null, words), input, output),
    set(value) {
      // What comes back while one draws is older than the hand.
      if (performance.now() - touched < 1000 || Number(input.value) === value) return;
      input.value = String(value);
      wear();
    },
    enable(yes) {
      input.disabled = !yes;
    },
  };
}

/** The card of the chosen link. */
export function linkCard(context: Context): HTMLElement {
  const { store } = context;
  let pair: Pair = [0, 1];
  const title = h("h2", { id: "link-title", class: "tabular" });
  const sign = icon("good", 14);
  const state = h("strong", null);
  const means = h("span", { class: "means" });
  const margin = h("p", { class: "expected tabular" });
  const impair = (what: "delay" | "jitter" | "loss") => (value: number): void => void context.act({ what: "impair", a: pair[0], b: pair[1], [what]: value }, true);
  const sliders: Record<"delay" | "jitter" | "loss", Slider> = {
    delay: slider("delay", "Added to every sample, each way", { most: 0.5, step: 0.005, show: ms }, impair("delay")),
    jitter: slider("jitter", "Scale of the random part of the delay", { most: 0.1, step: 0.002, show: ms }, impair("jitter")),
    loss: slider("loss", "Share of samples dropped", { most: 0.5, step: 0.01, show: (value) => percent(value, 0) }, impair("loss")),
  };
  const cut = button("Cut", () => {
    const on = !(store.state && isCut(store.state, ...pair));
    void context.act({ what: "cut", a: pair[0], b: pair[1], on });
  }, { icon: "cut", class: "button", id: "cut" });
  const clear = button("Clear", () => void context.act({ what: "impair", a: pair[0], b: pair[1], delay: 0, jitter: 0, loss: 0 }), {
    class: "button", icon: "reset", tip: "No added delay, jitter or loss",
  });
  const heads = [h("th", { scope: "col" }), h("th", { scope: "col" })] as const;
  const cells = ROWS.map(() => [h("td"), h("td")] as const);
  const table = h(
    "table",
    { class: "numbers" },
    h("thead", null, h("tr", null, h("td"), ...heads)),
    h("tbody", null, ...ROWS.map((row, i) => h("tr", null, h("th", { scope: "row", "data-tip": row.tip, tabindex: 0 }, row.words), ...(cells[i] ?? [])))),
  );
  const close = button("", () => context.link.set(null), { icon: "close", class: "button bare", label: "Close the link’s card" });
  const element = h(
    "aside",
    { id: "link", class: "card", "aria-labelledby": "link-title", tabindex: -1, hidden: true },
    h("div", { class: "panel-head" }, title, h("div", { class: "grow" }), close),
    h("p", { class: "condition" }, sign, state, " ", means),
    margin,
    sliders.delay.element,
    sliders.jitter.element,
    sliders.loss.element,
    h("div", { class: "actions" }, cut, clear),
    table,
  );
  element.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    const back = document.querySelector<SVGElement>(`.link[data-link="${pair.join("-")}"]`);
    context.link.set(null);
    back?.focus();
    event.stopPropagation();
  });
  const update = (): void => {
    const chosen = context.link.get();
    shown(element, chosen !== null);
    if (!chosen) return;
    pair = chosen;
    const [a, b] = pair;
    const now = condition(store.state, a, b);
    text(title, `Link ${linkName(a, b)}`);
    attribute(element, "data-condition", now);
    redraw(sign, CONDITIONS[now].icon);
    text(state, CONDITIONS[now].words);
    text(means, meaning(store.state, a, b));
    const left = spare(store.state, a, b);
    text(margin, left === null || now === "cut" ? "" : left >= 0 ? `${percent(left, 0)} of the age budget to spare.` : `Ages are ${percent(-left, 0)} over budget.`);
    const done = store.state?.emulated[`${a}-${b}`];
    sliders.delay.set(done?.delay ?? 0);
    sliders.jitter.set(done?.jitter ?? 0);
    sliders.loss.set(done?.loss ?? 0);
    for (const one of Object.values(sliders)) one.enable(can(context, "impair"));
    clear.disabled = !can(context, "impair");
    const severed = !!store.state && isCut(store.state, a, b);
    text(cut.lastElementChild ?? cut, severed ? "Reconnect" : "Cut");
    const drawnSign = cut.querySelector("svg");
    if (drawnSign) redraw(drawnSign, severed ? "mend" : "cut");
    attribute(cut, "class", severed ? "button primary" : "button danger");
    cut.disabled = !can(context, "cut");
    [[a, b], [b, a]].forEach(([self, other], side) => {
      const head = heads[side];
      if (head) {
        text(head, `at ${(self ?? 0) + 1}`);
        attribute(head, "title", nameOf(store, self ?? 0));
        head.style.setProperty("--user", `var(--user-${self})`);
      }
      const end = store.state?.ends[`${self}-${other}`];
      ROWS.forEach((row, i) => {
        const cell = cells[i]?.[side];
        if (cell) text(cell, end ? row.show(end) : "–");
      });
    });
  };
  store.on("state", update);
  store.on("scene", update);
  store.on("connection", update);
  context.link.on((chosen) => {
    update();
    if (chosen) element.scrollTop = 0;
  });
  return element;
}
