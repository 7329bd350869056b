// How quick the page is; read by tests and benchmarks as window.cotouch.stats.
const KEPT = 600;

export class Stats {
  /** Whether each picture is awaited until it is whole, so that times below tell it and not when it was handed over. */
  finishing = false;
  /** Frames drawn that had something new in them. */
  frames = 0;
  /** Of those, in the last second [1/s]. */
  fps = 0;
  /** From a pointer's event to the first drawn frame whose copy knows of it [ms]. */
  readonly dragToMesh: number[] = [];
  /** From a pointer's event to the arrival of that frame [ms]. */
  readonly echoMs: number[] = [];
  private readonly waiting: { number: number; time: number }[] = [];
  private since = 0;
  private counted = 0;

  pointed(number: number, time: number): void {
    this.waiting.push({ number, time });
    if (this.waiting.length > KEPT) this.waiting.shift();
  }

  /** A frame was drawn. @param now performance.now() after it was handed to the graphics card */
  drew(echo: number, received: number, now: number): void {
    this.frames++;
    this.counted++;
    if (now - this.since >= 1000) {
      this.fps = (this.counted * 1000) / (now - this.since);
      this.since = now;
      this.counted = 0;
    }
    while (this.waiting.length && this.waiting[0]!.number <= echo) {
      const { time } = this.waiting.shift()!;
      keep(this.dragToMesh, now - time);
      keep(this.echoMs, received - time);
    }
  }
}

function keep(list: number[], value: number): void {
  list.push(value);
  if (list.length > KEPT) list.shift();
}
