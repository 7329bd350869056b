// How old what one user knows of another is, as far as the server says.
import type { State } from "./protocol";

/** Age of a's newest sample of b [s]: what is emulated, else half of both directions' ages; null while unknown or cut. */
export function linkDelay(state: State, a: number, b: number): number | null {
  const emulated = state.emulated[`${a}-${b}`];
  if (emulated?.cut) return null;
  if (emulated && emulated.delay + emulated.jitter > 0) return emulated.delay + emulated.jitter;
  const end = state.ends[`${a}-${b}`];
  if (end?.age_sum != null) return end.age_sum / 2;
  if (end?.round_trip != null) return end.round_trip / 2;
  return emulated ? emulated.delay : null;
}

/** Time in which what a user does reaches every other over the links [s]; users it does not reach are missing. */
export function delaysFrom(state: State, slot: number): Map<number, number> {
  const reached = new Map([[slot, 0]]);
  const done = new Set<number>();
  for (;;) {
    let next = -1;
    for (const [other, time] of reached) if (!done.has(other) && (next < 0 || time < reached.get(next)!)) next = other;
    if (next < 0) return reached;
    done.add(next);
    for (const [a, b] of state.links) {
      if (a !== next && b !== next) continue;
      const other = a === next ? b : a;
      const delay = linkDelay(state, other, next);
      if (delay === null) continue;
      const time = reached.get(next)! + delay;
      if (time < (reached.get(other) ?? Infinity)) reached.set(other, time);
    }
  }
}

/** "48 ms", "1.2 s". */
export function inWords(seconds: number): string {
  return seconds < 0.9995 ? `${Math.round(seconds * 1000)} ms` : `${seconds.toFixed(1)} s`;
}

/** A length with a unit that fits it, or the most that is beside it: "12 mm". */
export function length(metres: number, most = metres): string {
  const size = Math.abs(most);
  const [factor, unit] = size < 0.00095 ? [1e6, "µm"] : size < 0.095 ? [1e3, "mm"] : size < 0.95 ? [1e2, "cm"] : [1, "m"];
  const value = metres * factor;
  return `${value.toFixed(Math.abs(value) < 9.95 && value !== Math.round(value) ? 1 : 0).replace("-", "−")} ${unit}`;
}

/** "0.42 N", "12 N". */
export function newtons(force: number): string {
  return `${force.toFixed(force < 0.995 ? 2 : force < 9.95 ? 1 : 0)} N`;
}

/** 1, 2 or 5 times a power of ten, at least as much as what is given. */
export function nice(value: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1e-12)));
  for (const step of [1, 2, 5, 10]) if (step * power >= value * 0.9999) return step * power;
  return 10 * power;
}
