// How finely to draw: as finely as the screen allows, as coarsely as the machine needs to keep up.
const SLOW = 0.026; // s between two drawn frames
const QUICK = 0.0185;
const PATIENCE = 24; // slow frames until it gets coarser
const LEVELS = [2, 1, 0.75, 0.55];

export class Quality {
  private level: number;
  private slow = 0;
  private quick = 0;
  private wait = 240; // quick frames until it gets finer; doubles with every mistake

  constructor(private readonly finest: () => number) {
    this.level = finest() > 1 ? 0 : 1;
  }

  /** Pixels of the picture for one of the page. */
  get ratio(): number {
    return Math.min(this.finest(), LEVELS[this.level]!);
  }

  /** A frame was drawn so long after the one before. @returns whether the ratio changed */
  took(seconds: number): boolean {
    const before = this.ratio;
    this.slow = seconds > SLOW ? this.slow + 1 : Math.max(0, this.slow - 0.5);
    this.quick = seconds < QUICK ? this.quick + 1 : 0;
    if (this.slow > PATIENCE && this.level < LEVELS.length - 1) {
      this.level++;
      this.slow = this.quick = 0;
      this.wait *= 2;
    } else if (this.quick > this.wait && this.level > 0) {
      this.level--;
      this.slow = this.quick = 0;
    }
    return this.ratio !== before;
  }
}

/** Whether pictures are worked out without a graphics card; then edges are not smoothed, which would cost most of all. */
export function inSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const known = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl && known ? String(gl.getParameter(known.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}
