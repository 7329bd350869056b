// How finely to draw: as finely as the screen allows, as coarsely as the machine needs to keep up.
const OFTEN = 0.06; // share of frames that came and were never drawn, above which the machine does not keep up
const LATE = 0.021; // s between two pictures from which on they are not what the screen asks for
const WINDOW = 24; // drawn frames over which that is judged
const FINER = 240; // frames without any left out until it gets finer; doubles with every mistake
const LEVELS = [2, 1, 0.75, 0.55, 0.4];

export class Quality {
  private level: number;
  private drawn = 0;
  private missed = 0;
  private kept = 0;
  private wait = FINER;

  constructor(private readonly finest: () => number) {
    this.level = finest() > 1 ? 0 : 1;
  }

  /** Pixels of the picture for one of the page. */
  get ratio(): number {
    return Math.min(this.finest(), LEVELS[this.level]!);
  }

  /** Drawn pictures between two shadows. */
  get shadows(): number {
    return this.level > 2 ? 3 : 1;
  }

  /**
   * A frame was drawn.
   * @param skipped frames that came since the one before, and were not
   * @param seconds since the one before; two clocks of 60 Hz leave out a frame now and then without any delay
   * @returns whether the ratio changed
   */
  took(skipped: number, seconds: number): boolean {
    const before = this.ratio;
    this.drawn++;
    const late = seconds > LATE ? Math.min(skipped, 6) : 0; // one long halt says little
    this.missed += late;
    this.kept = late ? 0 : this.kept + 1;
    if (this.drawn >= WINDOW) {
      if (this.missed > OFTEN * (this.drawn + this.missed) && this.level < LEVELS.length - 1) {
        this.level++;
        this.kept = 0;
        this.wait = Math.min(2 * this.wait, 64 * FINER);
      }
      this.drawn = this.missed = 0;
    }
    if (this.kept > this.wait && this.level > 0 && this.ratio < this.finest()) {
      this.level--;
      this.kept = this.drawn = this.missed = 0;
    }
    return this.ratio !== before;
  }
}

let software: boolean | null = null;

/** Whether pictures are worked out without a graphics card; then edges are not smoothed, which would cost most of all. */
export function inSoftware(): boolean {
  return (software ??= asked());
}

function asked(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const known = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl && known ? String(gl.getParameter(known.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}
