// What the page carries: unpacked once, read per frame. The counterpart of _pack.py.

/** @typedef {{kind: "f4"|"f8"|"u4"|"q2", shape: number[], offset: number}} Entry */
/**
 * @typedef {object} Header
 * @property {string} title
 * @property {string[]} users
 * @property {number[]} low corner of the box around all vertices [m]
 * @property {number[]} step between levels [m]
 * @property {Record<string, Entry>} arrays
 * @property {{owner: number[], radius: number[], axis: number[][], tip: number[][]}} tools of blades `axis` is from one end of the edge to the other, of styluses `tip` from one round end to the other
 * @property {{owner: number[]}} ports
 * @property {[number, number][]} links
 * @property {{name: string, unit: string}[]} series
 * @property {{displacement: number, difference: number}} peaks [m]
 * @property {import("../protocol").Obstacle[]} obstacles what stands still around
 * @property {unknown} texture on the skin, as `readTexture` reads it
 * @property {import("../protocol").Part[]} parts several bodies, in the order of their vertices; empty: there is one
 */
/** @typedef {{name: string, unit: string, values: ArrayLike<number>}} Series values by frame and user */
/** @typedef {{owner: number[], radius: number[], place: Float32Array, force: Float32Array}} Touch */

export class Run {
  /** @param {Header} header @param {ArrayBuffer} data */
  constructor(header, data) {
    /** @param {string} name */
    const single = (name) => new Float32Array(data, header.arrays[name].offset, count(header.arrays[name]));
    /** @param {string} name */
    const whole = (name) => new Uint32Array(data, header.arrays[name].offset, count(header.arrays[name]));
    const levels = header.arrays.vertices;
    this.header = header;
    this.time = new Float64Array(data, header.arrays.time.offset, count(header.arrays.time));
    this.users = levels.shape[0];
    this.frames = levels.shape[1];
    this.vertices = levels.shape[2];
    this.levels = accumulated(new Uint8Array(data, levels.offset, 2 * count(levels)), levels.shape);
    this.rest = single("rest");
    this.triangles = whole("triangles");
    /** When a user's triangle is there, from and until [s]; empty: always. */
    this.spans = single("spans");
    this.edges = whole("edges");
    this.tools = { ...header.tools, place: single("tool_centre"), force: single("tool_force") };
    const ports = header.ports.owner.length;
    this.ports = { ...header.ports, radius: new Array(ports).fill(0), place: single("grip_place"), force: single("grip_force") };
    /** @type {Series[]} */
    this.series = header.series.map((entry, k) => ({ ...entry, values: single(`series_${k}`) }));
  }

  /** Vertices of a user's copy at a moment between two frames. @param {number} user @param {number} at @param {Float32Array} out */
  copy(user, at, out) {
    const size = 3 * this.vertices, frame = Math.min(Math.floor(at), this.frames - 1), share = at - frame;
    const here = (user * this.frames + frame) * size, next = share > 0 ? here + size : here;
    const { low, step } = this.header;
    for (let d = 0; d < 3; d++)
      for (let i = d; i < size; i += 3) {
        const a = this.levels[here + i];
        out[i] = low[d] + step[d] * (a + share * (this.levels[next + i] - a));
      }
  }

  /** A row of a track, straight between frames. @param {ArrayLike<number>} track @param {number} width @param {number} at */
  row(track, width, at) {
    const frame = Math.min(Math.floor(at), this.frames - 1), share = at - frame, next = share > 0 ? width : 0;
    return Float32Array.from({ length: width }, (_, i) => {
      const a = track[frame * width + i];
      return a + share * (track[frame * width + next + i] - a);
    });
  }

  /** Time of a moment between two frames [s]. @param {number} at */
  timeAt(at) {
    return this.row(this.time, 1, at)[0];
  }

  /** The moment between two frames at a time; outside, the first or last. @param {number} time */
  momentAt(time) {
    let low = 0, high = this.frames - 1;
    if (time <= this.time[0]) return 0;
    if (time >= this.time[high]) return high;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.time[middle] <= time) low = middle;
      else high = middle;
    }
    return low + (time - this.time[low]) / (this.time[high] - this.time[low]);
  }
}

/** @param {Entry} entry */
function count(entry) {
  return entry.shape.reduce((a, b) => a * b, 1);
}

/** Levels from what a straight line through the last two frames missed. @param {Uint8Array} halves @param {number[]} shape */
function accumulated(halves, [users, frames, vertices]) {
  const size = 3 * vertices, total = users * frames * size;
  const levels = new Uint16Array(total);
  for (let row = 0; row < users * frames; row++) {
    const once = row % frames > 0 ? size : 0, twice = row % frames > 1 ? size : 0;
    for (let at = row * size; at < (row + 1) * size; at++) {
      const coded = halves[at] | (halves[total + at] << 8);
      let level = (coded >> 1) ^ -(coded & 1);
      if (once) level += levels[at - size];
      if (twice) level += levels[at - size] - levels[at - 2 * size];
      levels[at] = level; // modulo 2^16
    }
  }
  return levels;
}

/** @returns {Promise<Run>} */
export async function unpacked() {
  const header = /** @type {HTMLElement} */ (document.getElementById("header"));
  const data = /** @type {HTMLElement} */ (document.getElementById("data"));
  const letters = atob(/** @type {string} */ (data.textContent).trim());
  const packed = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) packed[i] = letters.charCodeAt(i);
  data.remove();
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Run(JSON.parse(/** @type {string} */ (header.textContent)), await new Response(stream).arrayBuffer());
}

const PREFIXES = /** @type {[number, string][]} */ ([[1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"], [1e-12, "p"]]);

/** What to divide by so that numbers up to `largest` read well, and the unit. @param {number} largest @param {string} unit @returns {[number, string]} */
export function prefixed(largest, unit) {
  if (!(largest > 0) || !unit) return [1, unit];
  const [factor, letter] = PREFIXES.find(([size]) => largest >= 0.999 * size) ?? PREFIXES[PREFIXES.length - 1];
  return [factor, letter + unit];
}

/** The largest of 1, 2 and 5 times a power of ten that is not above a positive number. @param {number} value */
export function round(value) {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  return (value >= 4.999 * power ? 5 : value >= 1.999 * power ? 2 : 1) * power;
}

/** A number in the text of the page. @param {number} value @param {number} digits */
export function num(value, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}
