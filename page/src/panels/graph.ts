/** Where users and labels stand in the drawing of a network; no document, so it can be tested alone. */
import type { Pair } from "./context";

export interface Point {
  x: number;
  y: number;
}

export const WIDTH = 360;
export const HEIGHT = 248;
export const RADIUS = 16;
const CENTRE: Point = { x: WIDTH / 2, y: HEIGHT / 2 + 2 };
const SHARES = [0.5, 0.42, 0.58, 0.34, 0.66, 0.28, 0.72];

/** Places of so many users on an ellipse, the first on top, clockwise. */
export function places(users: number): Point[] {
  const [rx, ry] = users === 2 ? [104, 0] : [104, 92];
  return Array.from({ length: users }, (_, i) => {
    const angle = (2 * Math.PI * i) / users + (users === 2 ? Math.PI : -Math.PI / 2);
    return { x: CENTRE.x + rx * Math.cos(angle), y: CENTRE.y + ry * Math.sin(angle) };
  });
}

/** A place on the way from one to the other. */
export function along(a: Point, b: Point, share: number): Point {
  return { x: a.x + (b.x - a.x) * share, y: a.y + (b.y - a.y) * share };
}

/** Where on each link its label stands, as a share of the way, so that labels and users keep apart. */
export function labelShares(links: readonly Pair[], at: readonly Point[]): number[] {
  const taken: Point[] = [];
  return links.map(([a, b]) => {
    const [from, to] = [at[a], at[b]];
    if (!from || !to) return 0.5;
    let best = 0.5;
    let most = -Infinity;
    for (const share of SHARES) {
      const here = along(from, to, share);
      // Labels are wider than high.
      const room = Math.min(
        40 - 40 * Math.abs(share - 0.5),
        ...taken.map((other) => Math.hypot((here.x - other.x) * 0.62, (here.y - other.y) * 1.5)),
        ...at.map((user) => Math.hypot(here.x - user.x, here.y - user.y) - 6),
      );
      if (room > most + 0.5) [most, best] = [room, share];
    }
    taken.push(along(from, to, best));
    return best;
  });
}

/** The users that cannot be reached from the first of them over these links. */
export function unreached(slots: readonly number[], links: readonly Pair[]): number[] {
  const found = new Set(slots.slice(0, 1));
  for (let grown = true; grown; ) {
    grown = false;
    for (const [a, b] of links) {
      if (found.has(a) !== found.has(b)) {
        found.add(a).add(b);
        grown = true;
      }
    }
  }
  return slots.filter((slot) => !found.has(slot));
}

/** All pairs, the lower slot first. */
export function allPairs(slots: readonly number[]): Pair[] {
  return slots.flatMap((a, i) => slots.slice(i + 1).map((b): Pair => (a < b ? [a, b] : [b, a])));
}
