// Where something that floats hides least of what it speaks of.

export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

const GAP = 12;

/** How much two boxes have in common [pixels²]. */
export function common(a: Box, b: Box): number {
  const width = Math.min(a.left + a.width, b.left + b.width) - Math.max(a.left, b.left);
  const height = Math.min(a.top + a.height, b.top + b.height) - Math.max(a.top, b.top);
  return Math.max(width, 0) * Math.max(height, 0);
}

/**
 * A place in a room for something of a size.
 *
 * @param keep what is not to be hidden, what matters most first; of places as good, the nearest to that is taken
 */
export function placed(size: { width: number; height: number }, keep: readonly Box[], room: Box): { left: number; top: number } {
  const [right, bottom] = [room.left + room.width - size.width, room.top + room.height - size.height];
  const beside = (from: "left" | "top", extent: "width" | "height"): number[] =>
    keep.flatMap((box) => [box[from] - size[extent] - GAP, box[from], box[from] + box[extent] - size[extent], box[from] + box[extent] + GAP]);
  const inside = (all: number[], low: number, high: number): number[] => [...new Set([low, high, ...all.filter((one) => one > low && one < high)])];
  const first = keep[0] ?? room;
  let best = { left: room.left, top: Math.max(bottom, room.top) };
  let least = Infinity;
  for (const left of inside(beside("left", "width"), room.left, Math.max(right, room.left))) {
    for (const top of inside(beside("top", "height"), room.top, Math.max(bottom, room.top))) {
      const here = { left, top, ...size };
      const hidden = keep.reduce((sum, box, i) => sum + (i ? 1 : 4) * common(here, box), 0);
      const away = Math.hypot(left + size.width / 2 - first.left - first.width / 2, top + size.height / 2 - first.top - first.height / 2);
      const cost = 1e3 * hidden + away;
      if (cost < least) [best, least] = [{ left, top }, cost];
    }
  }
  return best;
}
