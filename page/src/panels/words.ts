/** What states are called, in words that need no paper. */
import type { LinkStatus, State } from "../protocol";
import type { IconName } from "./dom";

export type Presence = "here" | "starting" | "gone" | "stopped" | "awaited" | "over";

export const PRESENCE: Record<Presence, { words: string; icon: IconName }> = {
  here: { words: "here", icon: "good" },
  starting: { words: "starting", icon: "wait" },
  gone: { words: "gone", icon: "bad" },
  stopped: { words: "stopped", icon: "bad" },
  awaited: { words: "not here yet", icon: "wait" },
  over: { words: "finished", icon: "tick" },
};

/** Whether a user takes part. */
export function presence(state: State | null, slot: number): Presence {
  const member = state?.members[slot];
  if (!member) return "awaited";
  if (state?.ended && member.here && member.steps) return "over";
  if (member.alive === false) return "stopped";
  if (!member.here) return member.alive ? "starting" : member.steps ? "gone" : "awaited";
  return member.steps ? "here" : "starting";
}

/** What a link is, from what both its ends say and what is done to it. */
export type Condition = "coupled" | "catching" | "guarded" | "waiting" | "cut" | "off";

export const CONDITIONS: Record<Condition, { words: string; means: string; icon: IconName }> = {
  coupled: { words: "coupled", means: "Both ends feel each other through the spring.", icon: "good" },
  catching: {
    words: "catching up",
    means: "This end has caught up and is proving reliable; the link couples when both ends have.",
    icon: "wait",
  },
  guarded: {
    words: "guarded",
    means: "Samples are, or were, older than the budget allows. This end moves its spring only as far as its saved energy pays for.",
    icon: "warn",
  },
  waiting: { words: "waiting", means: "No samples arrive.", icon: "wait" },
  cut: { words: "cut", means: "Nothing gets through. Each end lets go of its spring without a jolt.", icon: "bad" },
  off: { words: "not linked", means: "These two are not linked directly.", icon: "minus" },
};

const ENDS: Record<string, Condition> = { coupled: "coupled", ready: "catching", guarded: "guarded", waiting: "waiting", keys: "waiting" };

/** How one end calls its state; `end` is null where it said nothing. */
export function endCondition(end: LinkStatus | null | undefined): Condition {
  return end ? (ENDS[end.state] ?? "waiting") : "waiting";
}

const WORST: Condition[] = ["cut", "guarded", "waiting", "catching", "coupled"];

/** How a link is: as the worse of its ends; cut where it was cut both ways or one. */
export function condition(state: State | null, a: number, b: number): Condition {
  if (!state) return "waiting";
  if (isCut(state, a, b)) return "cut";
  if (!state.links.some(([x, y]) => (x === a && y === b) || (x === b && y === a))) return "off";
  const ends = [endCondition(state.ends[`${a}-${b}`]), endCondition(state.ends[`${b}-${a}`])];
  return WORST.find((one) => ends.includes(one)) ?? "waiting";
}

/** What a condition means, and why where an end says so. */
export function meaning(state: State | null, a: number, b: number): string {
  const now = condition(state, a, b);
  const away = now !== "cut" && now !== "off" && [a, b].some((slot) => state?.members[slot]?.unsent);
  return away ? "A copy is farther away than samples can tell, so it sends none." : CONDITIONS[now].means;
}

/** Whether samples are kept from getting through, in either direction. */
export function isCut(state: State, a: number, b: number): boolean {
  return !!(state.emulated[`${a}-${b}`]?.cut || state.emulated[`${b}-${a}`]?.cut);
}

/** The greater of what both ends say; null where neither does. */
export function worse(state: State | null, a: number, b: number, kind: "age" | "age_sum" | "round_trip" | "loss" | "budget"): number | null {
  const all = [state?.ends[`${a}-${b}`]?.[kind], state?.ends[`${b}-${a}`]?.[kind]].filter((x): x is number => typeof x === "number");
  return all.length ? Math.max(...all) : null;
}

/** Share of a link's budget that its age sum leaves; null where one is unknown. */
export function spare(state: State | null, a: number, b: number): number | null {
  const [sum, budget] = [worse(state, a, b, "age_sum"), worse(state, a, b, "budget")];
  return sum === null || budget === null || budget <= 0 ? null : 1 - sum / budget;
}

export const MODES: Record<string, string> = {
  script: "follows the script",
  free: "hand free",
  hold: "holds still",
  pull: "pulls",
  wander: "wanders",
  grab: "pointer grabs",
  ball: "pointer pushes",
  blade: "pointer cuts",
  cut: "cuts",
  pose: "moves a tool",
  elsewhere: "on another computer",
};
