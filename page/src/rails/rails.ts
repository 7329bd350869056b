// A body in one dimension: every user's copy is a slider on a rail of its own, and links are springs between them.
import { alpha, isDark, onSystemTheme, userColour } from "../colours";
import type { Connection } from "../connection";
import { delaysFrom, inWords, length, linkDelay, newtons, nice } from "../delays";
import { Furniture } from "../furniture";
import type { Copy, Frame, Scene, Vec } from "../protocol";
import { tension } from "../tension";
import type { View } from "../stage";
import type { Stats } from "../stats";
import type { Store } from "../store";
import { Drag, type Rails as Told } from "./drag";
import { arrow, belief, disc, type Ink, INK, knob, rail, ring, rope, spring, text } from "./draw";

const PULSE = 900;
const calm = matchMedia("(prefers-reduced-motion: reduce)");

export function mountRails(element: HTMLElement, scene: Scene, store: Store, connection: Connection, stats: Stats): View {
  return new Rails(element, scene, store, connection, stats);
}

class Rails implements View, Told {
  readonly canvas = document.createElement("canvas");
  readonly stiffness: number;
  private readonly pen = this.canvas.getContext("2d")!;
  private readonly drag: Drag;
  private readonly furniture: Furniture;
  private readonly ends: (() => void)[] = [];
  private width = 0;
  private height = 0;
  private shown: Frame | null = null;
  private handle = 0;
  private last = 0;
  /** Half of what a rail shows [m]. */
  private half = 0.1;
  private wanted = 0.1;
  private proxy = 0;
  private pulsed = { slot: -1, since: -Infinity };

  constructor(element: HTMLElement, private readonly scene: Scene, private readonly store: Store, private readonly connection: Connection, private readonly stats: Stats) {
    this.stiffness = scene.stiffness;
    this.canvas.className = "ct-canvas";
    this.canvas.dataset.over = "rails";
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-label", "One slider for every user. Drag yours; G grabs, arrows move, Escape lets go.");
    element.append(this.canvas);
    this.furniture = new Furniture(element, store, { act: "Drag your slider to feel the others.", look: "" });
    this.furniture.legend("plain", "");
    this.drag = new Drag(this, connection);
    const sized = new ResizeObserver(() => this.resize());
    sized.observe(element);
    const draw = () => this.draw();
    this.ends.push(
      () => sized.disconnect(),
      onSystemTheme(draw),
      store.on("settings", draw),
      store.on("frame", draw),
      store.on("state", draw),
      store.on("slot", () => {
        this.drag.release();
        this.draw();
      }),
      store.on("connection", () => {
        if (store.connection === "open" && this.drag.holds) this.drag.send();
      }),
    );
    this.resize();
  }

  reset(): void {
    this.wanted = 0.1;
    this.draw();
  }

  pulse(slot: number): void {
    this.pulsed = { slot, since: performance.now() };
    this.draw();
  }

  spot(point = 0): { x: number; y: number; point: number } | null {
    const copy = this.copy(this.store.slot);
    return copy ? { x: this.x(this.place(copy, point)), y: this.y(this.store.slot), point } : null;
  }

  aim(x: number): { point: number; to: Vec } | null {
    const along = x - this.canvas.getBoundingClientRect().left;
    const found = this.reach(along, this.y(this.store.slot), true);
    return found && { point: found.point, to: [this.metres(along), 0, 0] };
  }

  dispose(): void {
    cancelAnimationFrame(this.handle);
    this.handle = -1;
    this.drag.dispose();
    this.furniture.dispose();
    for (const end of this.ends) end();
    this.canvas.remove();
  }

  // What dragging asks.

  reach(x: number, y: number, loose: boolean): { point: number; place: number; near: boolean } | null {
    const copy = this.copy(this.store.slot);
    if (!copy) return null;
    const anywhere = Number.isNaN(x);
    if (!anywhere && Math.abs(y - this.y(this.store.slot)) > Math.max(this.gap * 0.45, loose ? 34 : 24)) return null;
    let point = 0, best = Infinity;
    for (let i = 0; i < this.shown!.points; i++) {
      const far = Math.abs(this.x(this.place(copy, i)) - (anywhere ? this.x(this.scene.centre[0]) : x));
      if (far < best) [best, point] = [far, i];
    }
    return { point, place: this.place(copy, point), near: best < 44 };
  }

  metres(x: number): number {
    return this.scene.centre[0] + ((x - this.middle) / (this.right - this.left)) * 2 * this.half;
  }

  span(): number {
    return 2 * this.half;
  }

  force(): number {
    return Math.min(this.pull() / this.most, 1);
  }

  mayAct(): boolean {
    return this.connection.mayAct;
  }

  whose(y: number): number | null {
    return this.scene.users.find(({ slot }) => Math.abs(this.y(slot) - y) < this.gap / 2)?.slot ?? null;
  }

  take(slot: number): void {
    if (this.scene.own.includes(slot)) this.store.take(slot);
  }

  draw(): void {
    if (!this.handle) this.handle = requestAnimationFrame((now) => this.tick(now));
  }

  private get narrow(): boolean {
    return this.width < 620;
  }

  private get left(): number {
    return this.narrow ? 30 : 168;
  }

  private get right(): number {
    return this.width - (this.narrow ? 30 : 104);
  }

  private get middle(): number {
    return (this.left + this.right) / 2;
  }

  private get gap(): number {
    return (this.height - this.foot - 30) / this.scene.users.length;
  }

  /** Room below the rails, for the scale, a hint and what marks mean [pixels]. */
  private get foot(): number {
    return 108;
  }

  /** Force that draws the longest arrow [N]. */
  private get most(): number {
    return this.scene.stiffness * this.half;
  }

  private y(slot: number): number {
    return 26 + this.gap * (this.scene.users.findIndex((user) => user.slot === slot) + 0.5) + (this.narrow ? 8 : 0);
  }

  private x(metres: number): number {
    return this.middle + ((metres - this.scene.centre[0]) / (2 * this.half)) * (this.right - this.left);
  }

  private copy(slot: number): Copy | undefined {
    return this.shown?.copies.find((copy) => copy.slot === slot);
  }

  private place(copy: Copy, point: number): number {
    return this.scene.points[3 * point]! + copy.displacement[3 * point]! * this.shown!.scale;
  }

  private mean(copy: Copy): number {
    let sum = 0;
    for (let i = 0; i < this.shown!.points; i++) sum += this.place(copy, i);
    return sum / Math.max(this.shown!.points, 1);
  }

  private pull(): number {
    const copy = this.copy(this.store.slot);
    return this.drag.holds && copy ? this.stiffness * Math.abs(this.drag.target - this.place(copy, this.drag.point)) : 0;
  }

  private resize(): void {
    const box = this.canvas.parentElement?.getBoundingClientRect();
    if (!box || box.width < 1 || box.height < 1) return;
    [this.width, this.height] = [Math.round(box.width), Math.round(box.height)];
    const ratio = devicePixelRatio || 1;
    this.canvas.width = Math.round(this.width * ratio);
    this.canvas.height = Math.round(this.height * ratio);
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.draw();
  }

  private tick(now: number): void {
    this.handle = 0;
    const seconds = Math.min((now - this.last) / 1000, 0.1);
    this.last = now;
    const fresh = this.store.frame !== null && this.store.frame !== this.shown;
    this.shown = this.store.frame;
    let moving = this.drag.step(seconds);
    moving = this.range(seconds) || moving;
    moving = this.lag(seconds) || moving;
    moving = now - this.pulsed.since < PULSE || moving;
    this.paint(now);
    if (fresh) this.stats.drew(this.shown!.echo, this.shown!.received, performance.now());
    if (moving) this.draw();
  }

  /** Rails are as long as what moves on them; never while somebody drags, whose pointer would lose its place. */
  private range(seconds: number): boolean {
    if (!this.shown || this.drag.holds) return false;
    let reach = 0;
    for (const copy of this.shown.copies) {
      for (let i = 0; i < this.shown.points; i++) reach = Math.max(reach, Math.abs(this.place(copy, i) - this.scene.centre[0]));
      if (copy.hasHand && copy.mode !== "free") reach = Math.max(reach, Math.abs(copy.target[0] - this.scene.centre[0]));
    }
    if (reach > 0.92 * this.wanted || reach < 0.3 * this.wanted) this.wanted = Math.max(nice(reach * 1.15), 0.1);
    this.half += (this.wanted - this.half) * (calm.matches ? 1 : 1 - Math.exp(-seconds * 5));
    if (Math.abs(this.half - this.wanted) > 1e-3 * this.wanted) return true;
    this.half = this.wanted;
    return false;
  }

  private lag(seconds: number): boolean {
    const copy = this.copy(this.store.slot);
    if (!this.drag.holds || !copy) {
      this.proxy = NaN; // the next hold begins where the pointer is
      return false;
    }
    if (Number.isNaN(this.proxy)) this.proxy = this.drag.target;
    const share = this.force();
    const place = this.place(copy, this.drag.point);
    const goal = this.drag.target + ((place - this.drag.target) * 0.6 * share) / (share + 0.45);
    this.proxy += (goal - this.proxy) * (calm.matches ? 1 : 1 - Math.exp(-seconds * 55));
    return Math.abs(goal - this.proxy) > 1e-4 * this.half;
  }

  private paint(now: number): void {
    const { pen, store } = this;
    const dark = isDark(store.settings.theme);
    const ink = INK[dark ? "dark" : "light"];
    pen.clearRect(0, 0, this.width, this.height);
    this.scale(ink);
    const slots = this.scene.users.map((user) => user.slot);
    for (const slot of slots) this.rail(slot, ink, now);
    this.springs(ink);
    for (const slot of slots) this.beliefs(slot, ink);
    for (const slot of slots) this.slider(slot, ink);
    this.key(ink);
  }

  private scale(ink: Ink): void {
    const { pen } = this;
    const bottom = this.height - this.foot + 4;
    for (let i = -4; i <= 4; i++) {
      const x = Math.round(this.middle + (i / 8) * (this.right - this.left)) + 0.5;
      pen.strokeStyle = i === 0 ? alpha(ink.dark ? "#ffffff" : "#1b2330", 0.22) : ink.line;
      pen.lineWidth = 1;
      pen.beginPath();
      pen.moveTo(x, 22);
      pen.lineTo(x, bottom);
      pen.stroke();
      if (i % 2 === 0 && !(this.narrow && Math.abs(i) > 2)) {
        const label = i === 0 ? "rest" : `${i > 0 ? "+" : ""}${length((i / 4) * this.half, this.half / 2)}`;
        text(pen, label, x, bottom + 13, { size: 11.5, colour: ink.soft, align: "center" });
      }
    }
  }

  /** What the marks mean. */
  private key(ink: Ink): void {
    const y = this.height - 25;
    const x = this.narrow ? 22 : 32;
    belief(this.pen, x, y, 5.5, ink.soft, ink);
    text(this.pen, "where a user sees a neighbour", x + 13, y, { size: 12, colour: ink.soft });
  }

  private rail(slot: number, ink: Ink, now: number): void {
    const { pen, store } = this;
    const colour = userColour(slot, ink.dark);
    const y = this.y(slot);
    const mine = slot === store.slot;
    const copy = this.copy(slot);
    const gone = !copy || store.state?.members[slot]?.here === false;
    if (mine) {
      pen.fillStyle = alpha(colour, ink.dark ? 0.13 : 0.07);
      pen.beginPath();
      pen.roundRect(8, y - this.gap * 0.46, this.width - 16, this.gap * 0.92, 14);
      pen.fill();
    }
    const share = (now - this.pulsed.since) / PULSE;
    if (slot === this.pulsed.slot && share < 1) {
      pen.strokeStyle = alpha(colour, calm.matches ? 0.8 : Math.sin(share * Math.PI * 3) ** 2);
      pen.lineWidth = 3;
      pen.beginPath();
      pen.roundRect(8, y - this.gap * 0.46, this.width - 16, this.gap * 0.92, 14);
      pen.stroke();
    }
    rail(pen, this.left, this.right, y, mine ? 7 : 5, ink.rail);
    const name = this.scene.users.find((user) => user.slot === slot)!.name;
    const delay = store.state ? delaysFrom(store.state, store.slot).get(slot) : undefined;
    const old = copy && !copy.direct ? `, ${inWords(copy.age)} old` : "";
    const note = gone ? "not here" : slot === store.me ? "you" : mine ? "" : !store.state ? "" : delay === undefined ? "out of reach" : this.narrow ? `+${inWords(delay)}` : store.me === null ? `${inWords(delay)} after ${this.scene.users.find((user) => user.slot === store.slot)?.name}${old}` : `feels you ${inWords(delay)} later${old}`;
    const [nx, ny] = this.narrow ? [this.left - 8, y - this.gap * 0.33] : [26, y - 9];
    text(pen, name, nx, ny, { size: 15, weight: 650, colour: gone ? ink.soft : colour });
    const beside = this.narrow ? [nx + pen.measureText(name).width + 8, ny] : [nx, y + 10];
    text(pen, note, beside[0]!, beside[1]!, { size: 12, colour: ink.soft });
    if (gone) return;
    const force = mine && this.drag.holds ? this.pull() : Math.abs(copy.force[0]);
    if (force > 0.005) {
      const [fx, fy] = this.narrow ? [this.right + 8, ny] : [this.width - 26, y];
      text(pen, newtons(force), fx, fy, { size: 13, weight: 600, colour: ink.text, align: "right" });
    }
  }

  private springs(ink: Ink): void {
    const { state } = this.store;
    if (!state || !this.shown) return;
    const order = (slot: number) => this.scene.users.findIndex((user) => user.slot === slot);
    for (const [a, b] of state.links) {
      const [p, q] = [this.copy(a), this.copy(b)];
      if (!p || !q) continue;
      const [x, y] = [this.mean(p), this.mean(q)];
      const cut = !!state.emulated[`${a}-${b}`]?.cut || !!state.emulated[`${b}-${a}`]?.cut;
      const end = state.ends[`${a}-${b}`];
      const loose = cut || (end && end.state !== "coupled" && end.state !== "ready" && end.state !== "guarded");
      const stretch = Math.min(Math.abs(x - y) / (0.6 * this.half), 1);
      const apart = Math.abs(order(a) - order(b));
      const bend = apart < 2 ? 0 : (apart - 1) * Math.min(this.gap * 0.42, 38) * ((order(a) + order(b)) % 2 ? 1 : -1);
      const colour = loose ? alpha(ink.dark ? "#a7b0bd" : "#55606f", 0.55) : tension(stretch, ink.dark);
      spring(this.pen, this.x(x), this.y(a), this.x(y), this.y(b), bend, stretch, colour, !!loose, false);
    }
  }

  /** Where this user takes its neighbours to be: their sliders, as old as the link. */
  private beliefs(slot: number, ink: Ink): void {
    const { state, history } = this.store;
    if (!state || !this.copy(slot)) return;
    for (const [a, b] of state.links) {
      if (a !== slot && b !== slot) continue;
      const other = a === slot ? b : a;
      const delay = linkDelay(state, slot, other);
      if (delay === null || !this.copy(other)) continue;
      const past = history.before(other, delay);
      if (Number.isNaN(past)) continue;
      let rest = 0;
      for (let i = 0; i < this.shown!.points; i++) rest += this.scene.points[3 * i]! / this.shown!.points;
      belief(this.pen, this.x(rest + past), this.y(slot), 6, userColour(other, ink.dark), ink);
    }
  }

  private slider(slot: number, ink: Ink): void {
    const copy = this.copy(slot);
    if (!copy) return;
    const { pen } = this;
    const colour = userColour(slot, ink.dark);
    const y = this.y(slot);
    const mine = slot === this.store.slot;
    const held = mine && this.drag.holds;
    const size = Math.min(mine ? 19 : 15, this.gap * 0.3);
    const point = held ? this.drag.point : Math.max(copy.node, 0);
    const holds = held || (copy.hasHand && copy.mode !== "free" && copy.node >= 0);
    const place = this.x(this.place(copy, Math.min(point, this.shown!.points - 1)));
    const force = held ? Math.sign(this.drag.target - this.place(copy, point)) * this.pull() : copy.force[0];
    if (holds) {
      const share = Math.min(Math.abs(force) / this.most, 1);
      const target = this.x(held ? this.drag.target : copy.target[0]);
      rope(pen, place, target, y, 3 + 4 * share, tension(share, ink.dark));
      if (held) {
        pen.fillStyle = colour;
        disc(pen, this.x(this.proxy), y, 7);
        ring(pen, target, y, 12, colour, 2.5);
      } else {
        pen.fillStyle = colour;
        disc(pen, target, y, 5);
      }
    }
    if (this.shown!.points > 1) for (let i = 0; i < this.shown!.points; i++) {
      pen.fillStyle = alpha(colour, 0.85);
      disc(pen, this.x(this.place(copy, i)), y, Math.min(size * 0.5, 8));
    }
    const at = this.shown!.points > 1 && holds ? place : this.x(this.mean(copy));
    knob(pen, at, y, size, colour, ink, mine);
    if (holds) arrow(pen, at, y - size - 8, (force / this.most) * (this.right - this.left) * 0.3, colour);
  }
}
