/** Position, force and energy of all users over the last seconds. */
import { isDark, userColour } from "../colours";
import type { Quantity } from "../history";
import { Chart } from "./chart";
import { type Context, nameOf } from "./context";
import { button, h, panel, redraw, text } from "./dom";
import { type Table, csv, thinned } from "./series";

const EXPLANATION =
  "The last 20 seconds of every copy, in the users’ colours; the user this page acts for has a thicker line. Displacement is the " +
  "mean over all points (along x if the object moves along a line, else the distance), force is what the hand exerts on the copy, and energy is what the copy stores in motion and " +
  "springs. Move over a plot to read values; otherwise the newest are shown. Saved data has every value.";
const WAIT = 45; // ms between two drawings, at least
interface Kind {
  kind: Quantity;
  what: string;
  unit: string;
  floor: number;
  tip: string;
}
const LINE: Kind = { kind: "x", what: "Displacement x", unit: "m", floor: 2e-3, tip: "Mean displacement of each copy from rest, along x" };
const KINDS: Kind[] = [
  { kind: "displacement", what: "Displacement", unit: "m", floor: 2e-3, tip: "Mean displacement of each copy from rest, as a distance" },
  { kind: "force", what: "Force", unit: "N", floor: 0.05, tip: "Force of each user’s hand on the copy" },
  { kind: "energy", what: "Energy", unit: "J", floor: 1e-5, tip: "Energy in each copy: in motion and in springs" },
];

/** Gives a file to who reads the page. */
export function download(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  h("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

/** The panel of plots, and a way to freeze it by a key. */
export function plotsPanel(context: Context): { element: HTMLElement; freeze: () => void } {
  const { store } = context;
  let frozen: Map<Quantity, Table> | null = null;
  let frozenAt = 0;
  let charts: Chart[] = [];
  let slots: number[] = [];
  const kinds = (): Kind[] => (store.scene?.dimension === 1 ? [LINE, ...KINDS.slice(1)] : KINDS);
  /** What is saved: every axis by its name, so that it means the same whoever saved it. */
  const saved = (): { kind: Quantity; head: string }[] => [
    ...(["x", "y", "z"] as const).slice(0, store.scene?.dimension ?? 3).map((kind) => ({ kind, head: `displacement_${kind}_m` })),
    { kind: "force", head: "force_N" },
    { kind: "energy", head: "energy_J" },
  ];
  let drawnAt = 0;
  let drawnVersion = -1;

  const table = (kind: Quantity): Table =>
    frozen?.get(kind) ?? { time: store.history.time(), values: slots.map((slot) => store.history.series(kind, slot)) };
  const now = (): number => {
    if (frozen) return frozenAt;
    const frame = store.frame;
    if (!frame) return 0;
    return frame.time + Math.min((performance.now() - frame.received) / 1000, store.connection === "open" ? 0.25 : 0);
  };
  const freeze = (): void => {
    if (frozen) frozen = null;
    else {
      frozenAt = now();
      frozen = new Map([...kinds(), ...saved()].map(({ kind }) => [kind, table(kind)]));
    }
    const sign = stop.querySelector("svg");
    if (sign) redraw(sign, frozen ? "play" : "pause");
    text(stop.lastElementChild ?? stop, frozen ? "Resume" : "Freeze");
    stop.setAttribute("aria-pressed", String(!!frozen));
    element.toggleAttribute("data-frozen", !!frozen);
    drawnVersion = -1;
  };
  const stop = button("Freeze", freeze, { icon: "pause", class: "button small", id: "freeze" });
  const saveCsv = button("CSV", () => {
    const all = saved().map(({ kind, head }) => ({ head, table: table(kind) }));
    const heads = ["time_s", ...all.flatMap(({ head }) => slots.map((slot) => `${head} ${slot + 1} ${nameOf(store, slot)}`))];
    const numbers = csv(heads, { time: all[0]!.table.time, values: all.flatMap((one) => one.table.values) });
    download("cotouch.csv", new Blob([numbers], { type: "text/csv" }));
  }, { icon: "save", class: "button small", label: "Save the data as CSV" });
  const savePng = button("PNG", () => {
    picture(context, charts, slots)?.toBlob((blob) => blob && download("cotouch.png", blob));
  }, { icon: "save", class: "button small", label: "Save the plots as an image" });
  const { element, body } = panel("plots", "Plots", EXPLANATION, stop, saveCsv, savePng);
  body.classList.add("charts");

  let built = "";
  const build = (): void => {
    const scene = store.scene;
    const key = scene ? JSON.stringify([scene.started, scene.users, scene.dimension]) : "";
    if (key === built) return;
    built = key;
    if (frozen) freeze();
    for (const chart of charts) chart.dispose();
    slots = (scene?.users ?? []).map((user) => user.slot);
    charts = kinds().map(
      ({ what, unit, floor, tip }) =>
        new Chart(
          what,
          unit,
          floor,
          slots.map((slot) => ({
            name: nameOf(store, slot),
            colour: () => userColour(slot, isDark(store.settings.theme)),
            width: () => (slot === store.slot ? 2.25 : 1.25),
          })),
          store.history.seconds,
          "users",
          tip,
        ),
    );
    body.replaceChildren(...charts.map((chart) => chart.element));
    drawnVersion = -1;
  };
  const draw = (at: number): void => {
    requestAnimationFrame(draw);
    // Nothing is worked out for what is not seen; the browser itself pauses this in a hidden page.
    if (at - drawnAt < WAIT || !charts.length || body.offsetParent === null) return;
    if (drawnVersion === store.history.version && (frozen || store.connection !== "open")) return;
    if (frozen && drawnVersion >= 0) return;
    drawnAt = at;
    drawnVersion = store.history.version;
    const moment = now();
    kinds().forEach(({ kind }, i) => {
      const chart = charts[i];
      chart?.draw(thinned(table(kind), store.history.seconds, chart.room), moment);
    });
  };
  store.on("scene", build);
  store.on("settings", () => {
    for (const chart of charts) chart.redraw();
  });
  build();
  requestAnimationFrame(draw);
  return { element, freeze };
}

function picture(context: Context, charts: readonly Chart[], slots: readonly number[]): HTMLCanvasElement | null {
  const first = charts[0]?.canvas;
  if (!first) return null;
  const look = getComputedStyle(document.documentElement);
  const scale = devicePixelRatio || 1;
  const line = 22 * scale;
  const canvas = h("canvas", {
    width: Math.max(...charts.map((chart) => chart.canvas.width)) + 2 * line,
    height: charts.reduce((sum, chart) => sum + chart.canvas.height + line, 3 * line),
  });
  const pen = canvas.getContext("2d");
  if (!pen) return null;
  pen.fillStyle = look.getPropertyValue("--panel");
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.textBaseline = "middle";
  const write = (words: string, x: number, y: number, weight: number, colour: string): number => {
    pen.font = `${weight} ${12 * scale}px system-ui, sans-serif`;
    pen.fillStyle = colour;
    pen.fillText(words, x, y);
    return pen.measureText(words).width;
  };
  const ink = look.getPropertyValue("--ink");
  let x = line;
  for (const slot of slots) {
    pen.fillStyle = userColour(slot, isDark(context.store.settings.theme));
    pen.fillRect(x, line - 5 * scale, 10 * scale, 10 * scale);
    x += 15 * scale;
    x += write(nameOf(context.store, slot), x, line, 400, ink) + 16 * scale;
  }
  let y = 2 * line;
  for (const chart of charts) {
    write(chart.caption, line, y, 600, ink);
    pen.drawImage(chart.canvas, line, y + line / 2);
    y += chart.canvas.height + line;
  }
  return canvas;
}
