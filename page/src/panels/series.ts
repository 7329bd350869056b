/** Numbers for plots: fewer points without losing peaks, and axes that do not jump. */

/** Times and one row of values for each series. */
export interface Table {
  time: Float64Array;
  values: Float32Array[];
}

/** As few points as a plot has room for: of every stretch of time the least and the greatest, in the order they came.
 *
 * Stretches begin at multiples of their length, so that what scrolls does not flicker. NaN is nothing; a stretch of
 * nothing stays NaN.
 */
export function thinned(table: Table, span: number, room: number): Table {
  const { time, values } = table;
  const size = time.length;
  if (size <= 2 * room) return table;
  const length = span / room;
  const first = Math.floor((time[0] ?? 0) / length);
  const stretches = Math.floor((time[size - 1] ?? 0) / length) - first + 1;
  const result: Table = {
    time: new Float64Array(2 * stretches),
    values: values.map(() => new Float32Array(2 * stretches).fill(NaN)),
  };
  for (let i = 0; i < 2 * stretches; i++) result.time[i] = (first + i / 2) * length;
  values.forEach((row, n) => {
    const out = result.values[n];
    if (!out) return;
    let at = 0;
    for (let i = 0; i < stretches; i++) {
      let [low, high, lowAt, highAt] = [Infinity, -Infinity, -1, -1];
      for (; at < size && Math.floor((time[at] ?? 0) / length) - first <= i; at++) {
        const value = row[at] ?? NaN;
        if (value < low) [low, lowAt] = [value, at];
        if (value > high) [high, highAt] = [value, at];
      }
      if (lowAt < 0) continue;
      out[2 * i] = lowAt <= highAt ? low : high;
      out[2 * i + 1] = lowAt <= highAt ? high : low;
    }
  });
  return result;
}

/** Least and greatest of all rows; nothing in them: null. */
export function extent(values: readonly Float32Array[]): [number, number] | null {
  let [low, high] = [Infinity, -Infinity];
  for (const row of values) {
    for (let i = 0; i < row.length; i++) {
      const value = row[i] ?? NaN;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return low <= high ? [low, high] : null;
}

/** Ends of an axis: wide at once where values need it, narrow slowly where they do not. */
export class Axis {
  private low = 0;
  private high = 0;

  /** @param floor least width that is shown */
  constructor(private readonly floor: number) {}

  fit(found: [number, number] | null): [number, number] {
    const [low, high] = found ? [Math.min(found[0], 0), Math.max(found[1], 0)] : [0, 0];
    const pad = 0.08 * Math.max(high - low, this.floor);
    const [wantLow, wantHigh] = [low < 0 ? low - pad : 0, high > 0 || low === 0 ? Math.max(high, low === 0 ? this.floor : 0) + pad : 0];
    this.low = wantLow < this.low ? wantLow : this.low + (wantLow - this.low) * 0.04;
    this.high = wantHigh > this.high ? wantHigh : this.high + (wantHigh - this.high) * 0.04;
    return [this.low, Math.max(this.high, this.low + this.floor)];
  }
}

/** Rows of values with a comma between them, a line for each time. */
export function csv(heads: readonly string[], table: Table): string {
  const quoted = heads.map((head) => (/[",\n]/.test(head) ? `"${head.replaceAll('"', '""')}"` : head));
  const lines = [quoted.join(",")];
  for (let i = 0; i < table.time.length; i++) {
    const row = table.values.map((values) => (Number.isNaN(values[i]) ? "" : String(Number((values[i] ?? NaN).toPrecision(7)))));
    lines.push([(table.time[i] ?? NaN).toFixed(4), ...row].join(","));
  }
  return `${lines.join("\n")}\n`;
}
