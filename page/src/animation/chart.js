import { num, prefixed, round } from "./data.js";
/** @typedef {import("./data.js").Run} Run */
/** @typedef {import("./data.js").Series} Series */

// A line for every user over time, and the playhead: what one drags to go to another moment.

export class Chart {
  /** @param {HTMLCanvasElement} canvas @param {Run} run @param {(at: number) => void} seek */
  constructor(canvas, run, seek) {
    this.canvas = canvas;
    this.run = run;
    this.lines = document.createElement("canvas");
    this.stale = true;
    let held = false;
    /** @param {PointerEvent} event */
    const go = (event) => {
      const { left, right } = this.area(), x = event.clientX - canvas.getBoundingClientRect().left;
      const share = Math.max(0, Math.min(1, (x - left) / (right - left)));
      seek(run.momentAt(run.time[0] + share * (run.time[run.frames - 1] - run.time[0])));
    };
    canvas.addEventListener("pointerdown", (event) => {
      held = true;
      canvas.setPointerCapture(event.pointerId);
      go(event);
    });
    canvas.addEventListener("pointermove", (event) => held && go(event));
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, () => (held = false));
  }

  area() {
    const { clientWidth, clientHeight } = this.canvas;
    return { left: 46, right: clientWidth - 12, top: 10, bottom: clientHeight - 20 };
  }

  /** @param {number} time */
  x(time) {
    const { left, right } = this.area(), { time: all, frames } = this.run;
    return left + ((right - left) * (time - all[0])) / (all[frames - 1] - all[0] || 1);
  }

  /** Lines and axes, drawn anew only if something changed. @param {Series | undefined} series @param {{users: string[], ink: string, muted: string, grid: string}} colors @param {number} chosen user drawn last and thickest */
  sketch(series, colors, chosen) {
    const { canvas, lines, run } = this, ratio = Math.min(devicePixelRatio, 2);
    for (const layer of [canvas, lines]) {
      layer.width = Math.round(canvas.clientWidth * ratio);
      layer.height = Math.round(canvas.clientHeight * ratio);
    }
    const pen = /** @type {CanvasRenderingContext2D} */ (lines.getContext("2d"));
    pen.scale(ratio, ratio);
    pen.font = `11px ${getComputedStyle(canvas).fontFamily}`;
    const { left, right, top, bottom } = this.area();
    const known = series ? Array.from(series.values).filter(Number.isFinite) : [];
    let low = Math.min(0, ...bounds(known)), high = Math.max(0, ...bounds(known));
    if (high === low) high = low + 1;
    const [factor, unit] = prefixed(Math.max(-low, high), series?.unit ?? ""), rise = round(((high - low) / factor) / 2);
    low = Math.floor(low / factor / rise + 1e-9) * rise * factor;
    high = Math.max(high, Math.ceil(high / factor / rise - 0.6) * rise * factor);
    /** @param {number} value */
    const y = (value) => bottom - ((bottom - top) * (value - low)) / (high - low);
    pen.lineWidth = 1;
    pen.textBaseline = "middle";
    pen.textAlign = "right";
    for (let value = low / factor; series && value <= (high / factor) * 1.0001; value += rise) {
      pen.strokeStyle = colors.grid;
      stroke(pen, [[left, y(value * factor)], [right, y(value * factor)]]);
      pen.fillStyle = colors.muted;
      pen.fillText(num(value) + (value + rise > (high / factor) * 1.0001 ? ` ${unit}` : ""), left - 7, y(value * factor));
    }
    const first = run.time[0], last = run.time[run.frames - 1], beat = round((last - first || 1) / Math.max(2, (right - left) / 110));
    pen.textBaseline = "alphabetic";
    for (let k = Math.ceil(first / beat - 1e-9); k * beat <= last + 1e-9; k++) {
      const x = this.x(k * beat), wide = pen.measureText(num(k * beat)).width;
      if (x + wide / 2 > right + 10) continue;
      pen.textAlign = "center";
      pen.fillStyle = colors.muted;
      pen.fillText(num(k * beat) + (k * beat + beat > last + 1e-9 ? " s" : ""), x, bottom + 15);
    }
    pen.lineJoin = "round";
    const order = colors.users.map((_, user) => user).filter((user) => user !== chosen).concat(chosen);
    for (const user of series ? order : []) {
      pen.strokeStyle = colors.users[user];
      pen.lineWidth = user === chosen ? 2 : 1.25;
      pen.globalAlpha = user === chosen ? 1 : 0.8;
      pen.setLineDash(DASHES[Math.floor(user / HUES) % DASHES.length]);
      /** @type {[number, number][]} */
      let points = [];
      for (let f = 0; f < run.frames; f++) {
        const value = series ? series.values[f * run.users + user] : NaN;
        if (Number.isFinite(value)) points.push([this.x(run.time[f]), y(value)]);
        else points = stroke(pen, points); // a gap
      }
      stroke(pen, points);
    }
    this.stale = false;
  }

  /** @param {number} time of the playhead @param {{ink: string, surface: string}} colors */
  show(time, colors) {
    const pen = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
    const ratio = Math.min(devicePixelRatio, 2), { top, bottom } = this.area(), x = this.x(time);
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.drawImage(this.lines, 0, 0);
    pen.scale(ratio, ratio);
    pen.strokeStyle = pen.fillStyle = colors.ink;
    pen.lineWidth = 1.5;
    stroke(pen, [[x, top - 4], [x, bottom]]);
    pen.beginPath();
    pen.arc(x, bottom, 5.5, 0, 7);
    pen.fill();
    pen.strokeStyle = colors.surface;
    pen.stroke();
  }
}

export const HUES = 6; // colours of users; further rounds are dashed
const DASHES = [[], [6, 2.5], [2, 2]];

/** @param {number[]} values */
export function bounds(values) {
  return values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [0, 0]);
}

/** @param {CanvasRenderingContext2D} pen @param {[number, number][]} points @returns {[number, number][]} none, to start anew */
function stroke(pen, points) {
  pen.beginPath();
  for (const [x, y] of points) pen.lineTo(x, y);
  pen.stroke();
  return [];
}
