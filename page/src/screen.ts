// When this screen shows its next picture, and how long before it a frame has to be made to be in it.
//
// A server that sends at a pace of its own leaves every frame lying until the screen's next picture, and every pointer
// until the server's next frame. So the page says, with each frame it takes, when the next one would come just in time.
const KEPT = 24; // pictures that the pace is judged by
const SLOWEST = 60; // ms between pictures that are still a pace and not a halt
const SPARE = 0.5; // ms that a frame should be there before its picture
const LATER = 0.6; // ms sooner after a frame that came too late
const SOONER = 0.04; // ms later after one that came in time: one of 16 is late
const EARLY = 3.5; // ms that a frame may be made before it was asked for, with others: what is earlier missed its picture

export class Screen {
  private readonly gaps: number[] = [];
  private last = 0;
  private every = 0;
  private lead = 4;

  /** Since when a frame's making until it was there lies before a picture [ms]; for tests. */
  get ahead(): number {
    return this.lead;
  }

  /** A picture is due. @param time that the browser gives for it, as performance.now() [ms] */
  picture(time: number): void {
    const gap = time - this.last;
    if (gap <= 0) return; // asked for twice
    this.last = time;
    if (gap > SLOWEST) return;
    this.gaps.push(gap);
    if (this.gaps.length > KEPT) this.gaps.shift();
    // Pictures are left out, never put in between: what is short counts.
    if (this.gaps.length === KEPT) this.every = [...this.gaps].sort((a, b) => a - b)[KEPT >> 2]!;
  }

  /**
   * A frame arrived.
   * @returns in how long the next one should be made, and how long there is between two pictures [ms]; zeros while unknown
   */
  came(now: number): [number, number] {
    if (!this.every || now - this.last > 4 * SLOWEST) return [0, 0];
    const left = this.until(now);
    if (left < SPARE || left > this.lead + Math.min(EARLY, 0.35 * this.every)) this.lead += LATER;
    else this.lead -= SOONER;
    // A whole picture sooner is the same as none.
    if (this.lead > this.every + SPARE) this.lead -= this.every;
    if (this.lead < SPARE) this.lead = SPARE;
    return [this.until(now + this.lead), this.every];
  }

  /** From a time to the next picture after it. */
  private until(time: number): number {
    const since = (time - this.last) % this.every;
    return since < 0 ? -since : this.every - since;
  }
}
