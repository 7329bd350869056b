// What every copy did in the last seconds, at the rate of the frames, without garbage.
import type { Frame } from "./protocol";

const SECONDS = 20;
const CAPACITY = SECONDS * 62;
/** Of a mean over so many points the rest says nothing new. */
const ENOUGH = 1500;

export type Quantity = "position" | "force" | "energy" | "supplied" | "lost" | "linked";
const KEPT = ["x", "y", "z", "force", "energy", "supplied", "lost", "linked"] as const;
type Kept = (typeof KEPT)[number];

export class History {
  readonly seconds = SECONDS;
  /** Entries kept at most. */
  readonly capacity = CAPACITY;
  /** Entries so far, at most `capacity`. */
  count = 0;
  /** Rises with every entry. */
  version = 0;
  /** Axis of the largest mean displacement so far; what "position" is along. */
  axis: 0 | 1 | 2 = 0;
  private next = 0;
  private readonly times = new Float64Array(CAPACITY);
  private tracks = new Map<number, Record<Kept, Float32Array>>();
  private readonly reach: [number, number, number] = [0, 0, 0];

  /** Seats of which there is something. */
  get seats(): number[] {
    return [...this.tracks.keys()].sort((a, b) => a - b);
  }

  clear(): void {
    this.count = this.next = 0;
    this.axis = 0;
    this.reach.fill(0);
    this.tracks = new Map();
    this.version++;
  }

  add(frame: Frame): void {
    const at = this.next;
    // A server's clock that goes back is another server's.
    if (this.count && frame.time < this.times[(at + CAPACITY - 1) % CAPACITY]!) return;
    for (const track of this.tracks.values()) for (const kind of KEPT) track[kind][at] = NaN;
    const stride = Math.max(1, Math.floor(frame.points / ENOUGH));
    for (const copy of frame.copies) {
      const track = this.track(copy.seat);
      const d = copy.displacement;
      let x = 0, y = 0, z = 0, n = 0;
      for (let i = 0; i < frame.points; i += stride, n++) {
        x += d[3 * i]!;
        y += d[3 * i + 1]!;
        z += d[3 * i + 2]!;
      }
      const scale = frame.scale / Math.max(n, 1);
      track.x[at] = x * scale;
      track.y[at] = y * scale;
      track.z[at] = z * scale;
      track.force[at] = Math.hypot(...copy.force);
      track.energy[at] = copy.energy;
      track.supplied[at] = copy.supplied;
      track.lost[at] = copy.lost;
      track.linked[at] = copy.linked;
      this.reach[0] = Math.max(this.reach[0], Math.abs(x * scale));
      this.reach[1] = Math.max(this.reach[1], Math.abs(y * scale));
      this.reach[2] = Math.max(this.reach[2], Math.abs(z * scale));
    }
    for (const axis of [0, 1, 2] as const) if (this.reach[axis] > 1.5 * this.reach[this.axis]) this.axis = axis;
    this.times[at] = frame.time;
    this.next = (at + 1) % CAPACITY;
    this.count = Math.min(this.count + 1, CAPACITY);
    this.version++;
  }

  /** Times of the entries on the server's clock, oldest first [s]. */
  time(): Float64Array {
    return this.ordered(this.times, new Float64Array(this.count));
  }

  /** One quantity of one seat, oldest first (NaN where it was not told); m, N or J. */
  series(kind: Quantity, seat: number): Float32Array {
    const track = this.tracks.get(seat);
    const result = new Float32Array(this.count);
    if (!track) return result.fill(NaN);
    return this.ordered(track[kind === "position" ? (["x", "y", "z"] as const)[this.axis]! : kind], result);
  }

  /** Mean displacement of a seat along x so many seconds before the newest entry; NaN where unknown [m]. */
  before(seat: number, age: number): number {
    const track = this.tracks.get(seat);
    if (!track || !this.count) return NaN;
    const index = (back: number) => (this.next - 1 - back + 2 * CAPACITY) % CAPACITY;
    const wanted = this.times[index(0)]! - age;
    let low = 0, high = this.count - 1; // steps back; times fall
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[index(middle)]! > wanted) low = middle + 1;
      else high = middle;
    }
    return track.x[index(low)]!;
  }

  private ordered<T extends Float32Array | Float64Array>(ring: T, result: T): T {
    const start = (this.next - this.count + CAPACITY) % CAPACITY;
    const first = Math.min(this.count, CAPACITY - start);
    result.set(ring.subarray(start, start + first) as any);
    result.set(ring.subarray(0, this.count - first) as any, first);
    return result;
  }

  private track(seat: number): Record<Kept, Float32Array> {
    let track = this.tracks.get(seat);
    if (!track) {
      track = Object.fromEntries(KEPT.map((kind) => [kind, new Float32Array(CAPACITY).fill(NaN)])) as Record<Kept, Float32Array>;
      this.tracks.set(seat, track);
    }
    return track;
  }
}
