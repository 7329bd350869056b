/** Ages of all links over the last seconds; kept here, because they come with the states and not with the frames. */
import { Chart } from "./chart";
import { type Context, type Pair, keyOf, pairOf, samePair } from "./context";
import { h } from "./dom";
import { linkName } from "./format";
import type { Table } from "./series";
import { worse } from "./words";

const SECONDS = 20;
const KEPT = 128; // states; they come five times a second

/** A chart of the sum of ages at both ends of every link, the chosen link and its budget standing out. */
export function agesChart(context: Context): HTMLElement {
  const { store } = context;
  const holder = h("div", { class: "charts charts-one" });
  let time = new Float64Array(KEPT);
  let rows = new Map<string, Float32Array>();
  let budget = new Float32Array(KEPT).fill(NaN);
  let size = 0;
  let chart: Chart | null = null;
  let links: Pair[] = [];
  let built = "";

  const style = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const chosen = (pair: Pair): boolean => samePair(context.link.get(), pair);
  const push = (): void => {
    const state = store.state;
    if (!state || (size && state.time <= (time[size - 1] ?? 0))) return;
    if (size === KEPT) {
      time.copyWithin(0, 1);
      for (const row of [...rows.values(), budget]) row.copyWithin(0, 1);
      size--;
    }
    time[size] = state.time;
    for (const row of rows.values()) row[size] = NaN;
    for (const pair of links) {
      const row = rows.get(keyOf(pair)) ?? new Float32Array(KEPT).fill(NaN);
      rows.set(keyOf(pair), row);
      row[size] = worse(state, ...pair, "age_sum") ?? NaN;
    }
    const pair = context.link.get();
    budget[size] = (pair && worse(state, ...pair, "budget")) ?? NaN;
    size++;
    for (const [key, row] of rows) if (row.subarray(0, size).every(Number.isNaN)) rows.delete(key);
  };
  const update = (): void => {
    const now = (store.state?.links ?? []).map(([a, b]) => pairOf(a, b));
    const key = JSON.stringify([store.scene?.started, now]);
    if (key !== built) {
      if (!built.startsWith(JSON.stringify([store.scene?.started]).slice(0, -1))) {
        [time, rows, budget, size] = [new Float64Array(KEPT), new Map(), new Float32Array(KEPT).fill(NaN), 0];
      }
      built = key;
      links = now;
      chart?.dispose();
      chart = null;
      if (links.length) {
        chart = new Chart(
          "Age sum",
          "s",
          0.01,
          [
            ...links.map((pair) => ({
              name: linkName(...pair),
              colour: () => style(chosen(pair) ? "--accent" : "--faint"),
              width: () => (chosen(pair) ? 2.25 : 1),
            })),
            { name: "budget", colour: () => style("--warn"), width: () => 1.25, dash: [5, 4] },
          ],
          SECONDS,
          "ages",
          "Sum of the ages at both ends of every link. Select a link to highlight it and its budget",
        );
        holder.replaceChildren(chart.element);
      }
    }
    push();
    draw();
  };
  const draw = (): void => {
    if (!chart || !size || holder.offsetParent === null) return;
    const table: Table = {
      time: time.subarray(0, size),
      values: [...links.map((pair) => rows.get(keyOf(pair))?.subarray(0, size) ?? new Float32Array(size).fill(NaN)), budget.subarray(0, size)],
    };
    chart.draw(table, time[size - 1] ?? 0);
  };
  store.on("state", update);
  store.on("settings", () => chart?.redraw());
  context.link.on(() => {
    budget.fill(NaN);
    draw();
  });
  context.tab.on(draw);
  return holder;
}
