// What lies over a picture: the legend of its colours, a hint, and lines between its parts.
import { RAMP_STOPS } from "./colours";
import type { Store } from "./store";

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

const NAMES = { displacement: "displacement", stress: "stretch", plain: "" } as const;

// About how wide the hint and the legend are [pixels].
const [HINT, LEGEND] = [440, 220];

export class Furniture {
  private readonly root = document.createElement("div");
  private readonly key = document.createElement("figure");
  private readonly what = document.createElement("figcaption");
  private readonly most = document.createElement("span");
  private readonly hint = document.createElement("p");
  private readonly lines = document.createElement("div");
  private readonly off: () => void;

  /** @param hint how to act, for those who may; else how to look */
  constructor(element: HTMLElement, store: Store, hint: { act: string; look: string }) {
    this.root.className = "ct-furniture";
    this.key.className = "ct-legend";
    const bar = document.createElement("i");
    bar.style.background = `linear-gradient(to right, ${RAMP_STOPS.join(", ")})`;
    const none = document.createElement("span");
    none.textContent = "0";
    this.key.append(this.what, none, bar, this.most);
    this.hint.className = "ct-hint";
    this.hint.textContent = store.scene?.acts ? hint.act : hint.look;
    this.hint.hidden = !this.hint.textContent;
    this.lines.className = "ct-lines";
    this.root.append(this.lines, this.key, this.hint);
    element.append(this.root);
    // Whoever has pulled once knows how.
    this.off = store.on("frame", () => {
      const mode = store.frame?.copies.find((copy) => copy.slot === store.slot)?.mode;
      if (mode === "grab" || mode === "ball" || mode === "pose") this.told();
    });
  }

  told(): void {
    this.hint.hidden = true;
    this.off();
  }

  legend(colour: keyof typeof NAMES, top: string): void {
    this.key.hidden = !NAMES[colour];
    if (this.what.textContent !== NAMES[colour]) this.what.textContent = NAMES[colour];
    if (this.most.textContent !== top) this.most.textContent = top;
  }

  /** How far up from the bottom something lies over a picture of some width, between two places on it [pixels]. */
  covered(from: number, to: number, width: number): number {
    const half = Math.min(HINT / 2, 0.44 * width);
    if (!this.hint.hidden && from < width / 2 + half && to > width / 2 - half) return 94;
    return !this.key.hidden && to > width - LEGEND ? 44 : 0;
  }

  /** Frames around the parts of a picture. */
  rules(boxes: Box[]): void {
    this.lines.replaceChildren(
      ...boxes.map(({ x, y, width, height }) => {
        const box = document.createElement("i");
        Object.assign(box.style, { left: `${x}px`, top: `${y}px`, width: `${width}px`, height: `${height}px` });
        return box;
      }),
    );
  }

  dispose(): void {
    this.off();
    this.root.remove();
  }
}
