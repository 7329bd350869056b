// What every copy did in the last seconds, at the rate of the frames, without garbage.
import type { Frame } from "./protocol";

const SECONDS = 20;
const CAPACITY = SECONDS * 62;
/** Of a mean over so many points the rest says nothing new. */
const ENOUGH = 1500;

const KEPT = ["x", "y", "z", "force", "energy", "supplied", "lost", "linked"] as const;
type Kept = (typeof KEPT)[number];
export type Quantity = "displacement" | Kept;

export class History {
  readonly seconds = SECONDS;
  /** Entries kept at most. */
  readonly capacity = CAPACITY;
  /** Entries so far, at most `capacity`. */
  count = 0;
  /** Rises with every entry. */
  version = 0;
  private next = 0;
  private readonly times = new Float64Array(CAPACITY);
  private tracks = new Map<number, Record<Kept, Float32Array>>();

  /** Slots of which there is something. */
  get slots(): number[] {
    return [...this.tracks.keys()].sort((a, b) => a - b);
  }

  clear(): void {
    this.count = this.next = 0;
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
      const track = this.track(copy.slot);
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
    }
    this.times[at] = frame.time;
    this.next = (at + 1) % CAPACITY;
    this.count = Math.min(this.count + 1, CAPACITY);
    this.version++;
  }

  /** Times of the entries on the server's clock, oldest first [s]. */
  time(): Float64Array {
    return this.ordered(this.times, new Float64Array(this.count));
  }

  /** One quantity of one slot, oldest first (NaN where it was not told); m, N or J. Displacements are means over all
   * points: x, y and z, and their length. */
  series(kind: Quantity, slot: number): Float32Array {
    const track = this.tracks.get(slot);
    const result = new Float32Array(this.count);
    if (!track) return result.fill(NaN);
    if (kind !== "displacement") return this.ordered(track[kind], result);
    const [x, y, z] = (["x", "y", "z"] as const).map((axis) => this.ordered(track[axis], new Float32Array(this.count)));
    return result.map((_, i) => Math.hypot(x![i]!, y![i]!, z![i]!));
  }

  /** Mean displacement of a slot along x so many seconds before the newest entry; NaN where unknown [m]. */
  before(slot: number, age: number): number {
    const track = this.tracks.get(slot);
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

  private track(slot: number): Record<Kept, Float32Array> {
    let track = this.tracks.get(slot);
    if (!track) {
      track = Object.fromEntries(KEPT.map((kind) => [kind, new Float32Array(CAPACITY).fill(NaN)])) as Record<Kept, Float32Array>;
      this.tracks.set(slot, track);
    }
    return track;
  }
}
