/** Two minutes through everything: shows where, asks for one thing to do, and notices when it is done. */
import { type Context, type Tab, can, keyOf, pairOf } from "./panels/context";
import { attribute, button, h, icon, redraw, shown, text } from "./panels/dom";
import type { Doable } from "./messages";
import { type Box, common, placed } from "./placing";
import { condition, isCut } from "./panels/words";

const KEY = "cotouch.tour";
const AROUND = "#energy, #plots, #network";
const LOOK = 200; // ms between two looks at whether it is done

/** What a step may remember while it lasts. */
type Memory = Record<string, unknown>;

interface Step {
  title: string;
  words: string;
  /** What to do; and whether it was. */
  task: string;
  done: (context: Context, memory: Memory) => boolean;
  /** What is shown, the first of these that is seen; may depend on what was done. */
  where: string | ((memory: Memory) => string);
  /** What is to be seen besides; where nothing is said, all that moves with a hand. */
  sees?: string;
  tab?: Tab;
  /** What has to be so for it to be done at all; in words where it is not. */
  needs?: (context: Context, memory: Memory) => string | null;
}

const needs = (what: Doable, words: string) => (context: Context): string | null => (can(context, what) ? null : words);
const ownCopy = (context: Context) => context.store.frame?.copies.find((copy) => copy.slot === context.store.slot);
const grabbing = (context: Context): boolean => {
  const copy = ownCopy(context);
  return copy?.mode === "grab" || copy?.mode === "ball" || copy?.mode === "pose";
};
const force = (context: Context): number => Math.hypot(...(ownCopy(context)?.force ?? [0, 0, 0]));
const hands = needs("hand", "This page may only watch; continue with →.");
const links = (list: readonly (readonly [number, number])[]): string => list.map(([a, b]) => keyOf(pairOf(a, b))).sort().join(" ");

const cutLinks = ({ store: { state } }: Context): (readonly [number, number])[] => state?.links.filter(([a, b]) => isCut(state, a, b)) ?? [];

export const STEPS: readonly Step[] = [
  {
    title: "Take hold",
    words: "This is one object, held by several people. Each of them has a copy of it; yours is the solid one.",
    task: "Press on the object and drag.",
    where: "#stage",
    needs: hands,
    done: (context) => grabbing(context) && force(context) > 0.02,
  },
  {
    title: "Let go",
    words: "What you feel is a spring between your pointer and the point you hold. The others feel you through springs between the copies.",
    task: "Release, and watch the object swing back and come to rest.",
    where: "#stage",
    needs: hands,
    done: (context, memory) => {
      if (grabbing(context)) memory.held = true;
      return !!memory.held && !grabbing(context);
    },
  },
  {
    title: "See the delay",
    words: "Samples take tens of milliseconds to travel. The other copies do what yours did, but later.",
    task: "Choose Side by side (or Ghosts), then drag again and watch the others.",
    where: "#stage-frame",
    needs: hands,
    done: (context, memory) => {
      const { layout, ghosts } = context.store.settings;
      const first = (memory.first ??= `${layout} ${ghosts}`);
      if (layout === "side" || `${layout} ${ghosts}` !== first) memory.seen = true;
      return !!memory.seen && grabbing(context);
    },
  },
  {
    title: "Pull against somebody",
    words: "You can tell a scripted hand what to do. Two users who pull against each other feel each other’s force through the network.",
    task: "Expand another user, set the hand to Hold or Pull, and drag the other way.",
    where: (memory) => (memory.told ? "#stage" : "#users"),
    sees: "#stage, #users",
    tab: "users",
    needs: hands,
    done: (context, memory) => {
      const { state, slot } = context.store;
      const told = Object.entries(state?.members ?? {}).some(([key, one]) => Number(key) !== slot && (one.hand === "hold" || one.hand === "pull"));
      if (told) memory.told = true;
      return !!memory.told && grabbing(context) && force(context) > 0.02;
    },
  },
  {
    title: "Look at a link",
    words: "Lines link users. The number is the age of the samples that a copy works with. Damping is set so that this age does no harm.",
    task: "Select a link to see both ends.",
    where: "#network",
    sees: "#link",
    tab: "network",
    done: (context) => context.link.get() !== null,
  },
  {
    title: "Cut a link",
    words: "Networks fail. When samples stop arriving, both ends let go of their spring without a jolt, and everybody else carries on.",
    task: "Press Cut, and watch the line and the verdict at the top.",
    where: "#link, #network",
    sees: "#network, #verdict",
    tab: "network",
    needs: needs("cut", "Links cannot be cut from here; continue with →."),
    done: (context) => cutLinks(context).length > 0,
  },
  {
    title: "Reconnect it",
    words: "When samples arrive again, both ends first catch up and save energy; they couple only when both can pay for it.",
    task: "Press Reconnect, and wait until the link is coupled again.",
    where: "#link, #network",
    sees: "#network, #verdict",
    tab: "network",
    needs: (context, memory) =>
      !can(context, "cut") ? "Links cannot be reconnected from here; continue with →."
        : cutLinks(context).length || memory.cut ? null
        : "No link is cut. Go back with ← to cut one, or continue with →.",
    done: (context, memory) => {
      const { state } = context.store;
      const all = (memory.cut ??= []) as (readonly [number, number])[];
      for (const link of cutLinks(context)) if (!all.some(([a, b]) => a === link[0] && b === link[1])) all.push(link);
      return all.length > 0 && all.every(([a, b]) => condition(state, a, b) === "coupled");
    },
  },
  {
    title: "Choose bad links",
    words: "It matters which users are linked. With the same number of links, copies agree soonest with the best choice and latest with the worst.",
    task: "Choose Worst, drag and let go; then choose Best.",
    where: "#topology",
    sees: "#stage, #network",
    tab: "network",
    needs: needs("links", "Links cannot be chosen from here; continue with →."),
    done: ({ store }, memory) => {
      const { state } = store;
      if (!state) return false;
      const now = links(state.links);
      if (state.choices.worst && links(state.choices.worst) === now) memory.worst = true;
      return !!memory.worst && !!state.choices.best && links(state.choices.best) === now;
    },
  },
  {
    title: "Follow the energy",
    words: "Every joule is accounted for: put in by hands, added by delays, damped, or still in the copies. Both bars are always equally long.",
    task: "Drag the object, and see what you put in.",
    where: "#energy",
    sees: "#stage",
    tab: "energy",
    done: (context, memory) => {
      const supplied = Object.values(context.store.state?.members ?? {}).reduce((sum, one) => sum + Math.abs(one.supplied ?? 0), 0);
      const first = (memory.first ??= supplied) as number;
      return context.tab.get() === "energy" && (Math.abs(supplied - first) > 1e-6 || !can(context, "hand"));
    },
  },
  {
    title: "Remove the guarantee",
    words: "With less damping than the delays need, nothing keeps energy from growing. See for yourself: within seconds a copy runs away, is caught, and full damping is restored.",
    task: "Lower the damping and watch. Restore it, or wait until it is restored automatically.",
    where: (memory) => (memory.lowered ? "#stage-frame" : "#margin"),
    sees: "#stage-frame, #margin",
    tab: "margin",
    needs: needs("damping", "Damping cannot be changed from here; this was the last step."),
    done: ({ store }, memory) => {
      const share = store.state?.damping ?? 1;
      if (share < 1) memory.lowered = true;
      return !!memory.lowered && share === 1;
    },
  },
];

function saved(): { step: number; over: boolean } {
  try {
    const { step = 0, over = false } = JSON.parse(localStorage.getItem(KEY) ?? "{}") as { step?: number; over?: boolean };
    return { step: Math.min(Math.max(Math.floor(Number(step)) || 0, 0), STEPS.length - 1), over: over === true };
  } catch {
    return { step: 0, over: false };
  }
}

function save(step: number, over: boolean): void {
  try {
    localStorage.setItem(KEY, JSON.stringify({ step, over }));
  } catch {
    // Then the next visit begins anew.
  }
}

/** The tour; nothing of it is seen until it is opened. On a first visit a line invites to it. */
export function tour(context: Context, root: HTMLElement): { open: () => void; invite: () => void } {
  let at = 0;
  let memory: Memory = {};
  let running = false;
  let finished = new Set<number>();
  const hole = h("div", { class: "tour-hole", hidden: true, "aria-hidden": "true" });
  const number_ = h("p", { class: "tour-number tabular" });
  const title = h("h2", { id: "tour-title" });
  const words = h("p", { id: "tour-words" });
  const sign = icon("play", 16);
  const task = h("span", null);
  const asked = h("p", { class: "tour-task", role: "status" }, sign, task);
  const dots = h("div", { class: "tour-dots", "aria-hidden": "true" }, ...STEPS.map(() => h("i")));
  const back = button("Back", () => go(at - 1), { class: "button small", label: "Previous step (←)" });
  const next = button("Next", () => (at + 1 < STEPS.length ? go(at + 1) : end(true)), { class: "button small", label: "Next step (→)", id: "tour-next" });
  const leave = button("", () => end(false), { icon: "close", class: "button bare", label: "Leave the tour (Esc); you can resume it later" });
  const card = h(
    "div",
    { class: "tour-card", id: "tour", role: "dialog", "aria-modal": "false", "aria-labelledby": "tour-title", "aria-describedby": "tour-words", tabindex: -1, hidden: true },
    h("div", { class: "panel-head" }, number_, h("div", { class: "grow" }), leave),
    title,
    words,
    asked,
    h("div", { class: "tour-foot" }, dots, h("div", { class: "grow" }), back, next),
  );
  const begin = button("Start", () => open(), { class: "button small primary" });
  const later = button("Not now", () => {
    shown(offer, false);
    save(at, true);
  }, { class: "button small" });
  const offer = h(
    "div",
    { class: "tour-offer", id: "tour-offer", role: "region", "aria-label": "Tour", hidden: true },
    icon("tour", 18),
    h("span", null, "New here? Take a two-minute tour."),
    begin,
    later,
  );
  root.append(hole, card, offer);

  const seen = (selectors: string): DOMRect[] =>
    selectors ? selectors.split(", ").flatMap((one) => [...(document.querySelector(one)?.getClientRects() ?? [])]) : [];
  /** The ring around what is meant, and the card where it hides least of that and of what else is to be seen. */
  const place = (): void => {
    const step = STEPS[at];
    if (!running || !step) return;
    const box = seen(typeof step.where === "string" ? step.where : step.where(memory))[0];
    hole.hidden = !box;
    if (!box) return;
    const pad = 4;
    const [left, top] = [Math.max(box.left - pad, 2), Math.max(box.top - pad, 2)];
    Object.assign(hole.style, {
      left: `${left}px`, top: `${top}px`,
      width: `${Math.min(box.right + pad, innerWidth - 2) - left}px`, height: `${Math.min(box.bottom + pad, innerHeight - 2) - top}px`,
    });
    const room: Box = { left: 8, top: 8, width: innerWidth - 16, height: innerHeight - 16 };
    // The line on top says how things stand, and is low: it stays free.
    const keep = [box, ...seen(step.sees ?? AROUND), ...seen(".bar")];
    const fitted = (wide: boolean): Box => {
      card.toggleAttribute("data-wide", wide);
      const { width, height } = card.getBoundingClientRect();
      return { ...placed({ width, height }, keep, room), width, height };
    };
    // Below the picture of a small window there is no room for a high card, and how high it is depends on the font.
    let best = fitted(false);
    if (common(best, box) > 0) {
      const wide = fitted(true);
      if (common(wide, box) < common(best, box)) best = wide;
      else card.removeAttribute("data-wide");
    }
    card.style.left = `${best.left}px`;
    card.style.top = `${best.top}px`;
  };
  const look = (): void => {
    const step = STEPS[at];
    if (!running || !step) return;
    const missing = step.needs?.(context, memory) ?? null;
    if (!finished.has(at) && missing === null && step.done(context, memory)) {
      finished = new Set([...finished, at]);
      context.say(at + 1 < STEPS.length ? "Done. Continue when you like." : "That was the last step.", "good");
    }
    const done = finished.has(at);
    attribute(card, "data-done", done ? "" : null);
    redraw(sign, done ? "tick" : missing ? "wait" : "play");
    text(task, missing ?? step.task);
    attribute(next, "class", `button small${done ? " primary" : ""}`);
    text(next.lastElementChild ?? next, at + 1 === STEPS.length ? "Finish" : done ? "Next" : "Skip");
    place();
  };
  const go = (to: number): void => {
    at = Math.min(Math.max(to, 0), STEPS.length - 1);
    const step = STEPS[at];
    if (!step) return;
    memory = {};
    save(at, false);
    if (step.tab) context.tab.set(step.tab);
    text(number_, `Step ${at + 1} of ${STEPS.length}`);
    text(title, step.title);
    text(words, step.words);
    back.disabled = at === 0;
    [...dots.children].forEach((dot, i) => attribute(dot, "class", i === at ? "here" : finished.has(i) ? "done" : null));
    look();
  };
  const open = (): void => {
    running = true;
    shown(offer, false);
    card.hidden = false;
    go(saved().step);
    card.focus({ preventScroll: true });
  };
  const end = (over: boolean): void => {
    running = false;
    card.hidden = hole.hidden = true;
    save(over ? 0 : at, true);
    if (over) finished = new Set();
    else context.say(`You can resume the tour at step ${at + 1}.`);
    document.getElementById("tour-open")?.focus();
  };
  document.addEventListener(
    "keydown",
    (event) => {
      if (!running || document.querySelector("dialog[open]")) return;
      const inside = card.contains(document.activeElement) || document.activeElement === document.body;
      if (event.key === "Escape" && inside && !grabbing(context)) end(false);
      else if (event.key === "ArrowRight" && inside && !grabbing(context)) at + 1 < STEPS.length ? go(at + 1) : end(true);
      else if (event.key === "ArrowLeft" && inside && !grabbing(context)) go(at - 1);
      else return;
      event.preventDefault();
      event.stopPropagation();
    },
    true,
  );
  addEventListener("resize", place);
  setInterval(look, LOOK);
  return {
    open,
    invite: () => {
      let first = false;
      try {
        first = localStorage.getItem(KEY) === null;
      } catch {
        // Without storage nobody is asked again and again.
      }
      if (first && !running) shown(offer, true);
    },
  };
}
