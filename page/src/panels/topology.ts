/** Which users are linked: best, worst, as at the start, or as one draws it; and what to expect of it. */
import type { State } from "../protocol";
import { type Context, type Pair, can, keyOf, nameOf, pairOf } from "./context";
import { attribute, button, choice, h, shown, text } from "./dom";
import { ms, number } from "./format";
import { unreached } from "./graph";

type Name = "start" | "best" | "worst" | "yours";

const MEANS: Record<Name, string> = {
  start: "The links that the session started with.",
  best: "With these links, differences between copies fade fastest.",
  worst: "The same number of links, but differences fade slowest: watch the copies agree late.",
  yours: "Click the lines between users to link or unlink them, then apply.",
};

/** Quickest way there and back between two users, as they measured it, linked or not [s]. */
export function wayBetween(state: State, a: number, b: number): number | null {
  for (const [from, to] of [[a, b], [b, a]] as const) {
    const measured = state.members[from]?.round_trips?.find(([slot]) => slot === to)?.[1];
    const way = state.ends[`${from}-${to}`]?.round_trip ?? measured;
    if (typeof way === "number") return Math.max(way, 0);
  }
  return null;
}

/** Mean way over links, and the sum of ways at the user where it is greatest; null if one is not known. */
export function load(state: State, links: readonly Pair[]): { mean: number; most: number } | null {
  const sums = new Map<number, number>();
  let all = 0;
  for (const [a, b] of links) {
    const way = wayBetween(state, a, b);
    if (way === null) return null;
    all += way;
    for (const slot of [a, b]) sums.set(slot, (sums.get(slot) ?? 0) + way);
  }
  return links.length ? { mean: all / links.length, most: Math.max(...sums.values()) } : null;
}

const title = (name: Name): string => (name[0] ?? "").toUpperCase() + name.slice(1);

function same(a: readonly Pair[], b: readonly Pair[]): boolean {
  const keys = new Set(a.map(keyOf));
  return a.length === b.length && b.every((pair) => keys.has(keyOf(pair)));
}

const pairs = (links: readonly (readonly [number, number])[]): Pair[] => links.map(([a, b]) => pairOf(a, b));

export function topologyChoices(
  context: Context,
  draft: Set<string>,
  drafted: (on: boolean) => void,
  redrawn: () => void,
): { element: HTMLElement; update(): void; changed(): void } {
  const { store } = context;
  let drafting = false;
  let asked: Name | null = null;
  const means = h("p", { class: "means" });
  const expected = h("p", { class: "expected tabular" });
  const warning = h("p", { class: "problem", role: "status", hidden: true });
  const links = (name: Name): Pair[] =>
    name === "yours"
      ? [...draft].map((key) => key.split("-").map(Number) as [number, number])
      : pairs(store.state?.choices[name] ?? []);
  const draw = (on: boolean): void => {
    drafting = on;
    draft.clear();
    if (on) for (const pair of pairs(store.state?.links ?? [])) draft.add(keyOf(pair));
    drafted(on);
  };
  const choose = (name: Name): void => {
    asked = name;
    if (name === "yours") {
      if (!drafting) draw(true);
    } else {
      if (drafting) draw(false);
      void context.act({ what: "links", choice: name });
    }
    redrawn();
  };
  const known = (name: Name): boolean => !!store.state && name in store.state.choices;
  const options = choice<Name>(
    "Links",
    (["start", "best", "worst", "yours"] as const).map((value) => ({ value, words: title(value), tip: MEANS[value] })),
    choose,
  );
  const apply = button("Apply", () => {
    const wanted = links("yours");
    void context.act({ what: "links", links: wanted }).then((done) => {
      if (done) draw(false);
    });
  }, { class: "button small primary" });
  const leave = button("Cancel", () => {
    asked = null;
    draw(false);
  }, { class: "button small" });
  const drafts = h("div", { class: "actions", hidden: true }, apply, leave);
  const update = (): void => {
    const state = store.state;
    const now = pairs(state?.links ?? []);
    for (const name of ["start", "best", "worst"] as const) {
      const awaited = !known(name) && can(context, "links");
      options.allow(name, can(context, "links") && links(name).length > 0);
      options.say(name, awaited ? `${title(name)} …` : title(name), awaited ? "Being computed; this takes a few seconds." : known(name) && !links(name).length ? "None found." : MEANS[name]);
    }
    options.allow("yours", can(context, "links"));
    const current: Name | null = drafting
      ? "yours"
      : asked && asked !== "yours" && same(links(asked), now) ? asked
      : ((["start", "best", "worst"] as const).find((name) => links(name).length && same(links(name), now)) ?? (now.length ? "yours" : null));
    options.mark(current);
    const subject: Pair[] = drafting ? links("yours") : now;
    const waits = can(context, "links") && !(known("best") && known("worst"));
    const chosen = Object.keys(state?.choices ?? {}).length > 0; // by somebody's page of the whole session
    shown(options.element, chosen || can(context, "links"));
    const meant = current && (chosen || drafting) ? (current === "yours" && !drafting ? "Your own links." : MEANS[current]) : "";
    text(means, waits && !drafting ? `${meant} Best and worst are being computed.`.trim() : meant);
    const [before, after] = state ? [load(state, pairs(state.choices.start ?? state.links)), load(state, subject)] : [null, null];
    let words = subject.length ? `${subject.length} ${subject.length === 1 ? "link" : "links"}` : "";
    if (after) words += `, mean round trip ${ms(after.mean)}`;
    if (before && after && before.most > 0 && !same(subject, pairs(state?.choices.start ?? []))) {
      words += `. The user with the highest load needs about ${number(after.most / before.most, 1)} × the initial damping, if all springs are equal`;
    }
    text(expected, words && `${words}.`);
    shown(drafts, drafting);
    const alone = drafting ? unreached((store.scene?.users ?? []).map((user) => user.slot), subject) : [];
    text(warning, alone.length ? `No path leads to ${alone.map((slot) => nameOf(store, slot)).join(", ")}.` : "");
    shown(warning, alone.length > 0);
    apply.disabled = alone.length > 0 || same(subject, now) || !can(context, "links");
    attribute(options.element, "data-drafting", drafting ? "" : null);
  };
  return {
    element: h("div", { class: "topology", id: "topology" }, options.element, means, expected, warning, drafts),
    update,
    changed: redrawn,
  };
}
