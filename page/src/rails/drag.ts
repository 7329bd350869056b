// What this page's hand does on its rail: mouse, finger, keys and stick.
import type { Connection } from "../connection";
import { Pads } from "../pads";
import { typing } from "../space/touch";

/** What the rails tell. */
export interface Rails {
  readonly canvas: HTMLElement;
  /** The point of one's own copy that is meant by a place on the picture; null where that is not on one's rail. */
  reach(x: number, y: number, loose: boolean): { point: number; place: number; near: boolean } | null;
  /** Metres at a place of the picture. */
  metres(x: number): number;
  /** Metres that one's rail is long. */
  span(): number;
  /** 0 to 1. */
  force(): number;
  mayAct(): boolean;
  /** Whose rail a place is on; null: nobody's. */
  whose(y: number): number | null;
  take(slot: number): void;
  stiffness: number;
  draw(): void;
}

export class Drag {
  holds = false;
  point = 0;
  /** Where the hand is [m]. */
  target = 0;
  private offset = 0;
  private finger = -1;
  private readonly pads = new Pads();
  private readonly ends: (() => void)[] = [];

  constructor(private readonly rails: Rails, private readonly connection: Connection) {
    const { canvas } = rails;
    const on = <K extends keyof HTMLElementEventMap>(target: HTMLElement | Window, kind: K, f: (event: HTMLElementEventMap[K]) => void) => {
      target.addEventListener(kind, f as EventListener);
      this.ends.push(() => target.removeEventListener(kind, f as EventListener));
    };
    on(canvas, "pointerdown", (event) => this.down(event));
    on(canvas, "pointermove", (event) => this.move(event));
    on(canvas, "pointerrawupdate" as "pointermove", (event) => {
      if (this.holds && event.pointerId === this.finger) this.follow(this.at(event).x, event.timeStamp);
    });
    on(canvas, "pointerup", (event) => this.up(event));
    on(canvas, "pointercancel", (event) => this.up(event));
    on(canvas, "dblclick", (event) => {
      const slot = rails.whose(this.at(event).y);
      if (slot !== null) rails.take(slot);
    });
    on(window, "keydown", (event) => this.key(event));
    on(window, "blur", () => this.release());
  }

  dispose(): void {
    this.release();
    for (const end of this.ends) end();
  }

  release(time?: number): void {
    if (!this.holds) return;
    this.holds = false;
    this.finger = -1;
    this.send(time);
    this.rails.draw();
  }

  /** Says again what it does. */
  send(time?: number): void {
    this.connection.point({
      action: this.holds ? "grab" : "free", point: this.point, target: [this.target, 0, 0], radius: 0,
      stiffness: this.rails.stiffness, time,
    });
  }

  /** @returns whether a stick or motor is at work */
  step(seconds: number): boolean {
    const pad = this.pads.read();
    if (!pad) return false;
    if (pad.pressed) this.grabMiddle();
    if (pad.released) this.release();
    if (this.holds && Math.abs(pad.x) > 0.15) this.shift(pad.x * this.rails.span() * 0.5 * seconds);
    this.pads.rumble(this.holds ? this.rails.force() : 0);
    return this.holds;
  }

  private at(event: MouseEvent): { x: number; y: number } {
    const box = this.rails.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private down(event: PointerEvent): void {
    const { x, y } = this.at(event);
    const found = this.rails.mayAct() && event.button === 0 && this.finger < 0 ? this.rails.reach(x, y, event.pointerType === "touch") : null;
    if (!found) return;
    this.rails.canvas.setPointerCapture(event.pointerId);
    this.finger = event.pointerId;
    this.holds = true;
    this.point = found.point;
    this.offset = found.near ? found.place - this.rails.metres(x) : 0;
    this.follow(x, event.timeStamp);
  }

  private move(event: PointerEvent): void {
    const { x, y } = this.at(event);
    if (this.holds && event.pointerId === this.finger) this.follow(x, event.timeStamp);
    else if (!this.holds) this.rails.canvas.dataset.over = this.rails.mayAct() && this.rails.reach(x, y, false) ? "grab" : "rails";
  }

  private up(event: PointerEvent): void {
    if (event.pointerId === this.finger) this.release(event.timeStamp);
  }

  private follow(x: number, time: number): void {
    this.target = this.rails.metres(x) + this.offset;
    this.send(time);
    this.rails.draw();
  }

  private shift(metres: number): void {
    const most = this.rails.span();
    this.target = Math.min(Math.max(this.target + metres, this.rails.metres(0) - most), this.rails.metres(0) + 2 * most);
    this.send();
    this.rails.draw();
  }

  private grabMiddle(): void {
    const found = this.rails.mayAct() && !this.holds ? this.rails.reach(NaN, NaN, true) : null;
    if (!found) return;
    this.holds = true;
    this.point = found.point;
    this.target = found.place;
    this.send();
    this.rails.draw();
  }

  private key(event: KeyboardEvent): void {
    if (typing(event)) return;
    if (event.key === "Escape" && this.holds) this.release();
    else if (document.activeElement !== this.rails.canvas && document.activeElement !== document.body) return;
    else if (event.key === "g" || event.key === "G") {
      if (this.holds) this.release();
      else this.grabMiddle();
    } else if (this.holds && (event.key === "ArrowLeft" || event.key === "ArrowRight")) {
      this.shift((event.key === "ArrowLeft" ? -0.02 : 0.02) * this.rails.span());
    } else return;
    event.preventDefault();
  }
}
