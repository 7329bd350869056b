// Mouse, pen, fingers, keys and gamepad, over the picture in space.
import { Vector3 } from "three";
import type { Store } from "../store";
import { Pads } from "../pads";
import type { Hold } from "./hold";
import type { Orbit } from "./orbit";
import { type Cell, type Hit, rayAt } from "./pick";

/** What the picture tells and is told. */
export interface Picture {
  readonly canvas: HTMLElement;
  readonly orbit: Orbit;
  readonly hold: Hold;
  /** The cell of one's own copy. */
  ownCell(): Cell;
  cellAt(x: number, y: number): Cell;
  pick(x: number, y: number, reach: number): Hit | null;
  /** Takes what a press met, the way that the pointer's tool does; a rigid tool is led. */
  take(hit: Hit, away: Vector3, time?: number): void;
  /** The point under the pointer that a press would take. */
  hover(hit: Hit | null): void;
  mayAct(): boolean;
  /** Force of one's own hand, 0 to 1 of what is drawn. */
  force(): number;
  draw(): void;
}

type Doing = "hold" | "turn" | "pan" | "two";
const FINGER = 30; // how near to a point counts [pixels]
const MOUSE = 14;
const TAP = 6; // pixels that are no drag yet
const DEADZONE = 0.15;
const RADIANS = 0.01; // that a rigid tool turns by for a pixel

export class Touch {
  private readonly pointers = new Map<number, { x: number; y: number }>();
  private doing: Doing | null = null;
  private holder = -1;
  private moved = 0;
  private over: { x: number; y: number } | null = null;
  private readonly ends: (() => void)[] = [];
  private readonly pads = new Pads();

  constructor(private readonly picture: Picture, private readonly store: Store) {
    const { canvas } = picture;
    const on = <K extends keyof HTMLElementEventMap>(target: HTMLElement | Window, kind: K, f: (event: HTMLElementEventMap[K]) => void, passive = true) => {
      target.addEventListener(kind, f as EventListener, { passive });
      this.ends.push(() => target.removeEventListener(kind, f as EventListener));
    };
    on(canvas, "pointerdown", (event) => this.down(event));
    on(canvas, "pointermove", (event) => this.move(event));
    // Where the browser has it, before the next picture is due: what is held moves a few ms sooner.
    on(canvas, "pointerrawupdate" as "pointermove", (event) => this.raw(event));
    on(canvas, "pointerup", (event) => this.up(event));
    on(canvas, "pointercancel", (event) => this.up(event));
    on(canvas, "pointerleave", () => this.leave());
    on(canvas, "wheel", (event) => this.wheel(event), false);
    on(canvas, "contextmenu", (event) => event.preventDefault(), false);
    on(canvas, "dblclick", (event) => this.double(event));
    on(window, "keydown", (event) => this.key(event), false);
    on(window, "blur", () => this.release());
  }

  dispose(): void {
    this.release();
    for (const end of this.ends) end();
  }

  release(): void {
    this.picture.hold.release();
    if (this.doing === "hold") this.doing = null;
    this.holder = -1;
    this.picture.draw();
  }

  /** Between two frames: what is held by a button or a stick moves. @returns whether something does */
  step(seconds: number): boolean {
    const { hold, orbit } = this.picture;
    let moving = this.doing === "hold" && this.moved < TAP && hold.push(seconds, orbit.axes()[2]);
    if (this.over) {
      this.picture.hover(!hold.holds && this.picture.mayAct() ? this.picture.pick(this.over.x, this.over.y, MOUSE) : null);
    }
    const pad = this.pads.read();
    if (!pad) return moving;
    if (pad.pressed && !hold.holds) this.grabCentre();
    if (pad.released && hold.holds) hold.release();
    if (hold.holds && Math.hypot(pad.x, pad.y, pad.depth) > DEADZONE) {
      const [right, up, away] = orbit.axes();
      const way = 1.2 * orbit.metres(this.picture.ownCell().height) * this.picture.ownCell().height * 0.5 * seconds;
      hold.shift(right.multiplyScalar(pad.x * way).addScaledVector(up, -pad.y * way).addScaledVector(away, pad.depth * way));
      moving = true;
    }
    this.pads.rumble(hold.holds ? this.picture.force() : 0);
    return moving || hold.holds;
  }

  private at(event: MouseEvent): { x: number; y: number } {
    const box = this.picture.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private down(event: PointerEvent): void {
    const { canvas, hold, orbit } = this.picture;
    const at = this.at(event);
    canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, at);
    this.moved = 0;
    if (event.pointerType === "touch" && this.pointers.size === 2) {
      if (this.doing === "hold") hold.release();
      this.doing = "two";
      return;
    }
    if (this.pointers.size > 1) return;
    if (event.button === 1 || (event.button === 0 && event.shiftKey)) this.doing = "pan";
    else if (event.button === 2 || event.ctrlKey) this.doing = "turn";
    else {
      const hit = this.picture.mayAct() ? this.picture.pick(at.x, at.y, event.pointerType === "touch" ? FINGER : MOUSE) : null;
      this.doing = hit ? "hold" : "turn";
      if (hit) {
        this.holder = event.pointerId;
        this.picture.take(hit, orbit.axes()[2], event.timeStamp);
        this.picture.hover(null);
      }
    }
    canvas.dataset.doing = this.doing;
    this.picture.draw();
  }

  private move(event: PointerEvent): void {
    const at = this.at(event);
    const { orbit } = this.picture;
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      if (event.pointerType !== "touch") this.over = at;
      this.picture.draw();
      return;
    }
    const [dx, dy] = [at.x - before.x, at.y - before.y];
    this.moved += Math.hypot(dx, dy);
    const height = this.picture.ownCell().height;
    if (this.doing === "two" && this.pointers.size === 2) {
      const other = [...this.pointers].find(([id]) => id !== event.pointerId)![1];
      const apart = (p: { x: number; y: number }) => Math.max(Math.hypot(p.x - other.x, p.y - other.y), 10);
      orbit.zoom(apart(before) / apart(at));
      orbit.turn(dx / 2, dy / 2);
    } else if (this.doing === "hold" && event.pointerId === this.holder) {
      this.lead(event, at, dx, dy);
    } else if (this.doing === "turn") orbit.turn(dx, dy);
    else if (this.doing === "pan") orbit.pan(dx, dy, height);
    this.pointers.set(event.pointerId, at);
    this.picture.draw();
  }

  private raw(event: PointerEvent): void {
    if (this.doing !== "hold" || event.pointerId !== this.holder || event.shiftKey) return;
    const at = this.at(event);
    this.picture.hold.follow(rayAt(this.picture.orbit.camera, this.picture.ownCell(), at.x, at.y), event.timeStamp);
  }

  /** What is held moves with the pointer; with Shift a rigid tool turns about what is upright and level in the picture. */
  private lead(event: PointerEvent, at: { x: number; y: number }, dx: number, dy: number): void {
    const { hold, orbit } = this.picture;
    const ray = rayAt(orbit.camera, this.picture.ownCell(), at.x, at.y);
    if (!event.shiftKey || hold.action !== "pose") return hold.follow(ray, event.timeStamp);
    const [right, up] = orbit.axes();
    hold.turn(up, RADIANS * dx, event.timeStamp);
    hold.turn(right, RADIANS * dy, event.timeStamp);
    hold.rebase(ray);
  }

  private up(event: PointerEvent): void {
    this.pointers.delete(event.pointerId);
    if (this.doing === "hold" && event.pointerId === this.holder) {
      this.picture.hold.release(event.timeStamp);
      this.holder = -1;
      this.doing = null;
    }
    if (this.doing === "two" && this.pointers.size === 1) this.doing = "turn";
    if (!this.pointers.size) this.doing = null;
    delete this.picture.canvas.dataset.doing;
    if (event.pointerType !== "touch") this.over = this.at(event);
    this.picture.draw();
  }

  private leave(): void {
    this.over = null;
    this.picture.hover(null);
    this.picture.draw();
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const { orbit, hold } = this.picture;
    const { height } = this.picture.ownCell();
    const turns = Math.max(-3, Math.min(3, (event.deltaY || event.deltaX) / (event.deltaMode ? 3 : 100)));
    if (event.shiftKey && this.store.tool === "ball") {
      hold.radius = Math.min(Math.max(hold.radius * 0.9 ** turns, 0.2 * 0.16 * orbit.size), 0.8 * orbit.size);
      if (hold.action === "ball") hold.send();
    } else if (event.shiftKey && this.store.tool === "blade") hold.deepen(0.9 ** turns);
    else if (event.shiftKey && hold.action === "pose") hold.turn(orbit.axes()[2], -0.15 * turns);
    else if (hold.holds) hold.depth(-turns * 0.06 * orbit.metres(height) * height * 0.5, orbit.axes()[2]);
    else orbit.zoom(1.12 ** turns);
    this.picture.draw();
  }

  /** A double click on another's picture: act for that user. */
  private double(event: MouseEvent): void {
    const at = this.at(event);
    const { slot } = this.picture.cellAt(at.x, at.y);
    if (slot !== this.store.slot && this.store.scene?.own.includes(slot)) this.store.take(slot);
    else if (!this.picture.pick(at.x, at.y, MOUSE)) this.picture.orbit.reset();
    this.picture.draw();
  }

  private grabCentre(): void {
    const cell = this.picture.ownCell();
    if (!this.picture.mayAct()) return;
    const hit = this.picture.pick(cell.x + cell.width / 2, cell.y + cell.height / 2, Math.max(cell.width, cell.height));
    if (!hit) return;
    const atPoint = this.store.tool === "grab" ? { ...hit, surface: hit.place } : hit;
    this.picture.take(atPoint, this.picture.orbit.axes()[2]);
  }

  private key(event: KeyboardEvent): void {
    const { hold, orbit, canvas } = this.picture;
    if (typing(event)) return;
    if (event.key === "Escape" && hold.holds) {
      this.release();
      event.preventDefault();
      return;
    }
    // Everything else belongs to the picture only while nothing else has the focus.
    if (document.activeElement !== canvas && document.activeElement !== document.body) return;
    if (event.key === "g" || event.key === "G") {
      if (hold.holds) this.release();
      else this.grabCentre();
    } else if (event.key in ARROWS) {
      const [x, y] = ARROWS[event.key as keyof typeof ARROWS];
      if (hold.holds) {
        const [right, up, away] = orbit.axes();
        const step = 0.05 * orbit.size;
        hold.shift(event.shiftKey ? away.multiplyScalar(y * step) : right.multiplyScalar(x * step).addScaledVector(up as Vector3, y * step));
      } else orbit.turn(-40 * x, 40 * y);
    } else if (event.key === "+" || event.key === "=") orbit.zoom(1 / 1.15);
    else if (event.key === "-") orbit.zoom(1.15);
    else if (event.key === "0" || event.key === "Home") orbit.reset();
    else return;
    event.preventDefault();
    this.picture.draw();
  }
}

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] } as const;

/** Whether a key is meant for something else: a field, a dialog, a shortcut of the browser. */
export function typing(event: KeyboardEvent): boolean {
  const element = event.target as HTMLElement | null;
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return true;
  return !!element?.closest?.("input, select, textarea, [contenteditable], dialog");
}
