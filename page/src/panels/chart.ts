/** One plot over the last seconds. */
import uPlot from "uplot";
import { h, text } from "./dom";
import { NONE, number } from "./format";
import { Axis, type Table, extent } from "./series";

export interface Line {
  name: string;
  colour: () => string;
  width: () => number;
  dash?: number[];
}

// From which share of the plain unit on it is used without a prefix.
const unitFrom: Record<string, number> = { N: 0.05, J: 0.2 };
const PREFIXES: readonly [number, string][] = [[1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"]];

// Steps of an axis; 2.5 would need a digit more.
const STEPS = Array.from({ length: 22 }, (_, i) => [1, 2, 5].map((step) => Number(`${step}e${i - 14}`))).flat();

const LEAST_GAP = 0.4; // s

function style(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function gaps(plot: uPlot, series: number, from: number, to: number): [number, number][] {
  const row = plot.data[series];
  const found: [number, number][] = [];
  const place = (i: number): number => plot.valToPos(plot.data[0][Math.min(Math.max(i, 0), plot.data[0].length - 1)] ?? 0, "x", true);
  for (let i = from; row && i <= to; i++) {
    if (!Number.isNaN(row[i])) continue;
    let end = i;
    while (end < to && Number.isNaN(row[end + 1])) end++;
    // A frame or two without a user are no gap.
    if ((plot.data[0][end + 1] ?? Infinity) - (plot.data[0][i - 1] ?? -Infinity) > LEAST_GAP) found.push([place(i - 1), place(end + 1)]);
    i = end;
  }
  return found;
}

/** A title with its unit, the values under the cursor (else the newest), and lines. */
export class Chart {
  readonly element: HTMLElement;
  private readonly unitWords = h("span", { class: "unit" });
  private readonly readout: HTMLElement[];
  private readonly plot: uPlot;
  private readonly axis: Axis;
  private scale = 1;
  private limits: [number, number] = [0, 1];
  private readonly observer: ResizeObserver;

  /**
   * @param what is plotted, in words
   * @param unit of the numbers, without a prefix
   * @param floor least range of the axis
   * @param lines to be drawn
   * @param seconds that are shown
   * @param sync charts with the same key share a cursor
   */
  constructor(
    readonly what: string,
    readonly unit: string,
    floor: number,
    readonly lines: readonly Line[],
    seconds: number,
    sync: string,
    tip: string,
  ) {
    this.axis = new Axis(floor);
    this.readout = lines.map((line) => h("span", { class: "reading", title: line.name }));
    const area = h("div", { class: "chart-area", role: "img", "aria-label": `${what} of the last ${seconds} s` });
    this.element = h(
      "figure",
      { class: "chart" },
      h("figcaption", { "data-tip": tip, tabindex: 0 }, h("strong", null, what), this.unitWords, h("span", { class: "readings tabular" }, ...this.readout)),
      area,
    );
    const ink = (): string => style("--muted");
    const rule = (): string => style("--rule");
    const font = `11px ${style("--sans") || "system-ui"}`;
    this.plot = new uPlot(
      {
        width: 200,
        height: 90,
        padding: [6, 16, 0, 0],
        legend: { show: false },
        cursor: { y: false, drag: { x: false, y: false }, points: { size: 5 }, sync: { key: sync } },
        scales: { x: { time: false, range: [-seconds, 0] }, y: { range: () => this.limits } },
        axes: [
          {
            stroke: ink, font, size: 20, gap: 2, space: 38, incrs: [1, 2, 5, 10, 20],
            grid: { stroke: rule, width: 1 }, ticks: { show: false },
            values: (_plot, splits) => splits.map((at) => (at === 0 ? "now" : at === -seconds ? "" : `${number(at)}\u202fs`)),
          },
          {
            stroke: ink, font, size: 38, gap: 4, space: 20, incrs: STEPS,
            grid: { stroke: rule, width: 1 }, ticks: { show: false },
            values: (_plot, splits, _axis, _space, step) => {
              const digits = Math.max(0, -Math.floor(Math.log10(step / this.scale + 1e-12)));
              return splits.map((at) => number(at / this.scale, Math.min(digits, 3)));
            },
          },
        ],
        series: [
          {},
          ...lines.map((line): uPlot.Series => ({
            label: line.name,
            stroke: line.colour,
            width: 1.5,
            points: { show: false },
            spanGaps: false,
            gaps: (plot, series, from, to) => gaps(plot, series, from, to),
            ...(line.dash ? { dash: line.dash } : {}),
          })),
        ],
        hooks: { setCursor: [() => this.read()] },
      },
      [[], ...lines.map(() => [])],
      area,
    );
    this.observer = new ResizeObserver(([entry]) => {
      const { width = 0, height = 0 } = entry?.contentRect ?? {};
      if (width > 20 && height > 20) this.plot.setSize({ width: Math.floor(width), height: Math.floor(height) });
    });
    this.observer.observe(area);
  }

  /** Plots what was so many seconds before `now`. */
  draw(table: Table, now: number): void {
    const time = new Float64Array(table.time.length);
    for (let i = 0; i < time.length; i++) time[i] = (table.time[i] ?? 0) - now;
    this.limits = this.axis.fit(extent(table.values));
    const most = Math.max(Math.abs(this.limits[0]), Math.abs(this.limits[1]));
    const [scale, prefix] = PREFIXES.find(([size]) => most >= size * (unitFrom[this.unit] ?? 1)) ?? [1e-9, "n"];
    this.scale = scale;
    text(this.unitWords, prefix + this.unit);
    this.lines.forEach((line, i) => {
      const series = this.plot.series[i + 1];
      if (series) series.width = line.width();
    });
    this.plot.setData([time, ...table.values] as unknown as uPlot.AlignedData, true);
    this.read();
  }

  /** Draws again with other colours. */
  redraw(): void {
    this.plot.redraw(false, true);
  }

  /** What is drawn, for a picture of all. */
  get canvas(): HTMLCanvasElement {
    return this.plot.ctx.canvas;
  }

  get caption(): string {
    return `${this.what} [${this.unitWords.textContent ?? ""}]`;
  }

  get room(): number {
    return Math.max(this.plot.width - 46, 100);
  }

  dispose(): void {
    this.observer.disconnect();
    this.plot.destroy();
    this.element.remove();
  }

  private read(): void {
    const under = this.plot.cursor.idx;
    const last = this.plot.data[0].length - 1;
    this.lines.forEach((line, i) => {
      const reading = this.readout[i];
      const row = this.plot.data[i + 1];
      if (!reading || !row) return;
      const value = row[under ?? last];
      const size = Math.abs((value ?? 0) / this.scale);
      const most = this.plot.width / this.lines.length < 36 ? 1 : 2; // so that none is cut
      const digits = Math.max(0, size < 9.995 ? most : size < 99.95 ? most - 1 : 0);
      text(reading, value === undefined || value === null || Number.isNaN(value) ? NONE : number(value / this.scale, digits));
      reading.style.setProperty("--user", line.colour());
    });
  }
}
