// Where each copy is drawn: all in one picture, or one's own large and the others beside it.
import type { Cell } from "./pick";

const GAP = 6;

/** @param slots one's own first */
export function cells(slots: number[], width: number, height: number, side: boolean): Cell[] {
  if (!side || slots.length < 2) return [{ slot: slots[0] ?? 0, x: 0, y: 0, width, height }];
  const wide = width >= height;
  const count = slots.length - 1;
  // Half of the picture for one's own, unless the others would be slivers.
  const share = count === 1 ? 0.5 : 0.48;
  const own: Cell = wide
    ? { slot: slots[0]!, x: 0, y: 0, width: Math.round(width * share) - GAP / 2, height }
    : { slot: slots[0]!, x: 0, y: 0, width, height: Math.round(height * share) - GAP / 2 };
  const [left, top] = wide ? [own.width + GAP, 0] : [0, own.height + GAP];
  const [room, deep] = [width - left, height - top];
  let columns = 1, best = 0;
  for (let c = 1; c <= count; c++) {
    const size = Math.min(room / c, deep / Math.ceil(count / c));
    if (size > best) [best, columns] = [size, c];
  }
  const rows = Math.ceil(count / columns);
  const [w, h] = [(room - GAP * (columns - 1)) / columns, (deep - GAP * (rows - 1)) / rows];
  return [
    own,
    ...slots.slice(1).map((slot, i) => ({
      slot,
      x: Math.round(left + (i % columns) * (w + GAP)),
      y: Math.round(top + Math.floor(i / columns) * (h + GAP)),
      width: Math.round(w),
      height: Math.round(h),
    })),
  ];
}
