// The object in space: every user's copy, hands, ground and names, and what one's own hand does to it.
import { Mesh, Quaternion, Ray, Scene as World, SphereGeometry, Vector3, WebGLRenderer } from "three";
import { isDark, onSystemTheme, userColour } from "../colours";
import type { Connection } from "../connection";
import { delaysFrom, inWords, length, newtons, nice } from "../delays";
import { Furniture } from "../furniture";
import type { Frame, Scene, Vec } from "../protocol";
import type { View } from "../stage";
import type { Stats } from "../stats";
import type { Store } from "../store";
import { Common, CopyShown } from "./copy";
import { Ground } from "./ground";
import { Hold } from "./hold";
import { Labels } from "./labels";
import { cells } from "./layout";
import { Orbit } from "./orbit";
import { type Cell, type Hit, pick, project, rayAt } from "./pick";
import { floorOf, Obstacles, seenFirst } from "./obstacles";
import { type HandPose, HandProp, material, paint } from "./props";
import { inSoftware, Quality } from "./quality";
import { Shape } from "./shape";
import { type RigidTool, leaves, poseOf } from "./tool";
import { Touch } from "./touch";

const PULSE = 900; // ms
const ABOVE = 46; // of the buttons over the picture [pixels]
const calm = matchMedia("(prefers-reduced-motion: reduce)");

export function mountSpace(element: HTMLElement, scene: Scene, store: Store, connection: Connection, stats: Stats): View {
  return new Space(element, scene, store, connection, stats);
}

/** Waits until what was handed over is drawn; for measurements. */
function finish(gl: WebGLRenderingContext | WebGL2RenderingContext): void {
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
}

class Space implements View {
  readonly canvas: HTMLCanvasElement;
  readonly orbit: Orbit;
  readonly hold: Hold;
  private readonly renderer: WebGLRenderer;
  private readonly world = new World();
  private readonly shape: Shape;
  private readonly common: Common;
  private readonly copies = new Map<number, CopyShown>();
  private readonly hands = new Map<number, HandProp>();
  private readonly ground: Ground;
  private readonly obstacles: Obstacles;
  private readonly dot: Mesh;
  private readonly dotPaint = material("#ffffff");
  private readonly labels: Labels;
  private readonly furniture: Furniture;
  private readonly touch: Touch;
  private readonly ends: (() => void)[] = [];
  private readonly full: number;
  private readonly face = new Quaternion();
  private readonly proxy = new Vector3();
  private readonly place = new Vector3();
  private readonly goal = new Vector3();
  private readonly aimed = new Vector3();
  private readonly posed: HandPose = { place: new Vector3(), proxy: new Vector3(), target: new Vector3(), force: new Vector3(), radius: 0, edge: new Vector3(), arrow: null, pointed: false };
  private readonly back = new Ray();
  private readonly out = new Vector3();
  private fresh = true;
  private hovered: Hit | null = null;
  private area: Cell[] = [];
  private width = 0;
  private height = 0;
  private shown: Frame | null = null;
  private dirty = true;
  private came = 0;
  private shadowed = { by: -1, left: 0 };
  private last = 0;
  private handle = 0;
  private peak = 0;
  private pulsed = { slot: -1, since: -Infinity };
  private readonly quality = new Quality(() => Math.min(devicePixelRatio || 1, 2));

  constructor(element: HTMLElement, private readonly scene: Scene, private readonly store: Store, private readonly connection: Connection, private readonly stats: Stats) {
    const radius = scene.radius || 1;
    const flat = scene.dimension < 3;
    this.renderer = new WebGLRenderer({ antialias: !inSoftware(), alpha: true, powerPreference: "high-performance" });
    this.renderer.setClearAlpha(0);
    this.renderer.autoClear = false;
    this.canvas = this.renderer.domElement;
    this.canvas.className = "ct-canvas";
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-label", "The shared object. Drag it to pull; G grabs, arrows move, Escape lets go.");
    element.append(this.canvas);
    this.shape = new Shape(scene);
    this.common = new Common(radius, this.shape);
    const centre = new Vector3(...scene.centre);
    this.orbit = new Orbit(centre, radius, seenFirst(scene.points, scene.obstacles, centre, radius), flat);
    this.full = 0.6 * scene.stiffness * radius;
    this.hold = new Hold(connection, radius, scene.stiffness, flat);
    for (const { slot } of scene.users) {
      const copy = new CopyShown(slot, this.shape, this.common);
      const hand = new HandProp(radius, this.full, userColour(slot, false));
      this.copies.set(slot, copy);
      this.hands.set(slot, hand);
      this.world.add(copy.group, hand.group);
    }
    let low = Infinity;
    for (let i = 2; i < scene.points.length; i += 3) low = Math.min(low, scene.points[i]!);
    this.ground = new Ground(centre, low, radius, scene.skin ? this.mine.moving : null, floorOf(scene.obstacles));
    this.obstacles = new Obstacles(scene.obstacles, centre, radius);
    this.ground.mesh.visible = !flat;
    this.dot = new Mesh(new SphereGeometry(0.022 * radius, 20, 14), this.dotPaint);
    this.dot.visible = false;
    this.world.add(this.ground.mesh, this.obstacles.group, this.dot);
    this.labels = new Labels(element);
    const leads = scene.parts.some(({ tool }) => tool && scene.own.includes(tool.slot));
    const act = leads ? "Drag your tool to move it; hold Shift to turn it. Drag beside it to look around." : "Grab the object and pull. Drag beside it to look around.";
    this.furniture = new Furniture(element, store, { act, look: "Drag to look around, and scroll to zoom." });
    this.touch = new Touch(this, store);
    const sized = new ResizeObserver(() => this.resize());
    sized.observe(element);
    const dressed = () => this.dress();
    this.ends.push(
      () => sized.disconnect(),
      onSystemTheme(dressed),
      store.on("settings", dressed),
      store.on("slot", () => {
        this.touch.release();
        this.dress();
      }),
      store.on("frame", () => this.draw()),
      store.on("state", () => {
        for (const [slot, copy] of this.copies) copy.moving.cut(this.store.state?.members[slot]?.cut ?? null);
        this.draw();
      }),
      store.on("connection", () => {
        if (store.connection === "open" && this.hold.holds) this.hold.send();
      }),
    );
    this.resize();
    this.dress();
  }

  reset(): void {
    this.orbit.reset();
    this.draw();
  }

  pulse(slot: number): void {
    this.pulsed = { slot, since: performance.now() };
    this.draw();
  }

  spot(point?: number): { x: number; y: number; point: number } | null {
    const cell = this.area[0]!;
    // Of those in front, the one that is nearest to the middle.
    const seen = point ?? this.pick(cell.x + cell.width / 2, cell.y + cell.height / 2, cell.width)?.point;
    if (seen === undefined) return null;
    const at = project(this.orbit.camera, cell, new Vector3().fromArray(this.mine.moving.places, 3 * this.shape.corner[seen]!));
    return at && { ...at, point: seen };
  }

  probe(): object {
    const box = this.canvas.getBoundingClientRect();
    const at = project(this.orbit.camera, this.area[0]!, this.hold.target);
    return { space: this, hold: this.hold, orbit: this.orbit, target: at && [at.x + box.left, at.y + box.top] };
  }

  dispose(): void {
    cancelAnimationFrame(this.handle);
    this.handle = -1;
    this.touch.dispose();
    for (const end of this.ends) end();
    for (const part of [...this.copies.values(), ...this.hands.values(), this.ground, this.obstacles, this.dotPaint, this.dot.geometry, this.furniture]) part.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
    this.labels.element.remove();
  }

  // What touch asks.

  ownCell(): Cell {
    return this.area[0]!;
  }

  cellAt(x: number, y: number): Cell {
    return this.area.find((cell) => x >= cell.x && x < cell.x + cell.width && y >= cell.y && y < cell.y + cell.height) ?? this.area[0]!;
  }

  pick(x: number, y: number, reach: number): Hit | null {
    if (this.cellAt(x, y) !== this.area[0]) return null;
    const hit = pick(this.mine.moving, this.orbit.camera, this.area[0]!, x, y, reach);
    const tool = hit && this.toolAt(hit.point);
    return tool && tool.slot !== this.store.slot ? null : hit; // another's is not in this copy
  }

  take(hit: Hit, away: Vector3, time?: number): void {
    const tool = this.toolAt(hit.point);
    if (tool) {
      const { handle, turned } = poseOf(tool, this.shape.rest, this.mine.moving.places);
      this.hold.lead(hit.point, handle, turned, hit.surface, away, time);
    } else if (this.store.tool === "ball") this.hold.press(hit.surface, away, time);
    else if (this.store.tool === "blade") this.hold.cut(hit.surface, away, time);
    else this.hold.grab(hit.point, hit.place, hit.surface, away, time);
  }

  private toolAt(point: number): RigidTool | undefined {
    return this.shape.tools.find(({ first, last }) => point >= first && point < last);
  }

  aim(x: number, y: number): { point: number; to: Vec } | null {
    const box = this.canvas.getBoundingClientRect();
    const cell = this.cellAt(x - box.left, y - box.top);
    const moving = (this.copies.get(cell.slot) ?? this.mine).moving;
    const ray = rayAt(this.orbit.camera, cell, x - box.left, y - box.top);
    const over = pick(moving, this.orbit.camera, cell, x - box.left, y - box.top, 0);
    const near = over ?? pick(moving, this.orbit.camera, cell, x - box.left, y - box.top, Infinity);
    if (!near) return null;
    // Beside the object: as far away as the point that is nearest in the picture.
    const away = this.orbit.camera.getWorldDirection(new Vector3());
    const to = over?.surface ?? ray.at(near.place.clone().sub(ray.origin).dot(away) / ray.direction.dot(away), new Vector3());
    return { point: near.point, to: [to.x, to.y, to.z] };
  }

  hover(hit: Hit | null): void {
    if (hit?.point !== this.hovered?.point) this.draw();
    this.hovered = hit;
    const over = hit ? this.store.tool : "";
    if (this.canvas.dataset.over !== over) this.canvas.dataset.over = over;
  }

  mayAct(): boolean {
    return this.connection.mayAct;
  }

  force(): number {
    return Math.min(this.pull() / this.full, 1);
  }

  draw(): void {
    this.dirty = true;
    if (!this.handle) this.handle = requestAnimationFrame((now) => this.tick(now));
  }

  private get mine(): CopyShown {
    return this.copies.get(this.store.slot) ?? this.copies.values().next().value!;
  }

  private get side(): boolean {
    return this.store.settings.layout === "side";
  }

  /** Force of one's own hand as far as it is known here: before an answer comes, that of its spring [N]. */
  private pull(): number {
    if (!this.hold.holds || this.fresh) return 0; // just taken: where it is held is not looked at yet
    const told = this.shown?.copies.find((copy) => copy.slot === this.store.slot);
    if (this.hold.action !== "grab") return told?.mode === this.hold.action ? Math.hypot(...told.force) : 0;
    return this.scene.stiffness * this.place.distanceTo(this.hold.target);
  }

  private resize(): void {
    const box = this.canvas.parentElement?.getBoundingClientRect();
    if (!box || box.width < 1 || box.height < 1) return;
    this.width = Math.round(box.width);
    this.height = Math.round(box.height);
    this.renderer.setPixelRatio(this.quality.ratio);
    this.renderer.setSize(this.width, this.height);
    this.arrange();
    // A new size empties the picture, and the screen may show it before the next one.
    if (this.shown) this.render(performance.now());
    this.draw();
  }

  private arrange(): void {
    const others = this.scene.users.map((user) => user.slot).filter((slot) => slot !== this.store.slot);
    // Side by side each has its name on top, below the buttons.
    const above = this.side && this.height > 3 * ABOVE ? ABOVE : 0;
    this.area = cells([this.store.slot, ...others], this.width, this.height - above, this.side);
    for (const cell of this.area) cell.y += above;
    this.furniture.rules(this.area.length > 1 ? this.area : []);
  }

  private dress(): void {
    const { settings } = this.store;
    const dark = isDark(settings.theme);
    const mode = { displacement: 0, stress: 1, plain: 2 }[this.store.colour];
    if (mode !== this.common.by.value) this.peak = 0;
    this.common.by.value = mode;
    for (const [slot, copy] of this.copies) {
      copy.paint(userColour(slot, dark), dark);
      copy.against(this.mine.moving);
      this.hands.get(slot)!.paint(userColour(slot, dark));
    }
    paint(this.dotPaint, dark ? "#FFFFFF" : "#111827");
    this.ground.colours(dark);
    this.obstacles.colours(dark);
    this.arrange();
    this.shown = null; // what is coloured by may need other numbers
    this.draw();
  }

  private tick(now: number): void {
    this.handle = 0;
    const seconds = Math.min((now - this.last) / 1000, 0.1);
    this.last = now;
    const fresh = this.store.frame !== null && this.store.frame !== this.shown;
    const skipped = this.store.came - this.came - 1;
    if (fresh) {
      this.came = this.store.came;
      this.show(this.store.frame!);
    }
    let moving = this.orbit.step(calm.matches ? 1 : 1 - Math.exp(-seconds * 18));
    moving = this.touch.step(seconds) || moving;
    moving = this.haptic(seconds) || moving;
    moving = this.range(seconds) || moving;
    moving = now - this.pulsed.since < PULSE || moving;
    if (this.dirty || moving) {
      this.dirty = false;
      this.render(now);
      if (fresh) {
        if (this.stats.finishing) finish(this.renderer.getContext());
        this.stats.drew(this.shown!.echo, this.shown!.received, performance.now());
        if (this.quality.took(skipped, seconds)) this.resize();
      }
    }
    if (moving) this.draw();
  }

  private show(frame: Frame): void {
    this.shown = frame;
    this.common.scale.value = frame.scale;
    const ghosts = this.side || this.store.settings.ghosts;
    const stretch = this.common.by.value === 1;
    let peak = 0;
    for (const { slot, displacement } of frame.copies) {
      const copy = this.copies.get(slot);
      if (!copy || !(ghosts || copy === this.mine)) continue;
      copy.moving.update(displacement, frame.scale, stretch && (this.side || copy === this.mine));
      if (this.side || copy === this.mine) peak = Math.max(peak, copy.moving.peak);
    }
    this.peak = Math.max(peak, this.peak * 0.998);
  }

  /** What one's own hand looks like: the proxy lags the more, the harder it pulls. @returns whether it moves */
  private haptic(seconds: number): boolean {
    if (!this.hold.holds) return !(this.fresh = true);
    const { moving } = this.mine;
    const held = this.hold.action === "pose" ? this.toolAt(this.hold.point) : undefined;
    if (this.hold.action === "grab") this.place.fromArray(moving.places, 3 * this.shape.corner[this.hold.point]!);
    else if (held) {
      const { handle, turned } = poseOf(held, this.shape.rest, moving.places);
      this.place.copy(this.hold.local).applyQuaternion(turned).add(handle);
    } else {
      const told = this.shown?.copies.find((copy) => copy.slot === this.store.slot);
      if (told?.mode === this.hold.action) this.place.fromArray(told.place);
      else this.place.copy(this.hold.target);
    }
    const aim = this.hold.goal(this.aimed);
    const share = this.force();
    const draws = this.hold.action === "grab" || this.hold.action === "pose";
    const lag = draws ? (0.6 * share) / (share + 0.45) : 1;
    const goal = this.goal.lerpVectors(aim, this.place, lag);
    if (this.fresh || calm.matches) this.proxy.copy(goal);
    else this.proxy.lerp(goal, 1 - Math.exp(-seconds * 55));
    this.fresh = false;
    return this.proxy.distanceTo(goal) > 1e-4 * this.scene.radius;
  }

  private range(seconds: number): boolean {
    const stretch = this.common.by.value === 1;
    const top = nice(Math.max(this.peak, stretch ? 0.02 : 0.04 * this.scene.radius));
    this.furniture.legend(this.store.colour, stretch ? `${Math.round(top * 100)} %` : length(top));
    const { full } = this.common;
    full.value += (top - full.value) * (calm.matches ? 1 : 1 - Math.exp(-seconds * 6));
    return Math.abs(full.value - top) > 0.01 * top;
  }

  private render(now: number): void {
    const { renderer, common } = this;
    const [, , away] = this.orbit.axes();
    this.orbit.camera.getWorldQuaternion(this.face);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, this.width, this.height);
    renderer.clear();
    for (const cell of this.area) {
      this.orbit.aspect(cell.width, cell.height);
      const shown = this.copies.get(cell.slot) ?? this.mine;
      const told = this.shown?.copies;
      for (const [slot, copy] of this.copies) {
        const known = !told || told.some((other) => other.slot === slot);
        const ghost = !this.side && this.store.settings.ghosts && known && told;
        copy.show(copy === shown ? "solid" : ghost ? "ghost" : "hidden", this.flash(slot, now));
        copy.thin(this.mine.moving, this.orbit.camera.position, common.apart.value);
        copy.order(away);
      }
      for (const [slot, hand] of this.hands) hand.group.visible = (!this.side || slot === cell.slot) && this.pose(slot, hand);
      this.dot.visible = !!this.hovered && cell === this.area[0];
      if (this.hovered) this.dot.position.fromArray(this.mine.moving.places, 3 * this.shape.corner[this.hovered.point]!);
      if (this.side || shown.slot !== this.shadowed.by || --this.shadowed.left <= 0) {
        this.ground.shadow(renderer, shown.moving, common.scale.value);
        this.shadowed = { by: shown.slot, left: this.quality.shadows };
      }
      common.height.value = cell.height * this.quality.ratio;
      const bottom = this.height - cell.y - cell.height;
      renderer.setScissorTest(true);
      renderer.setScissor(cell.x, bottom, cell.width, cell.height);
      renderer.setViewport(cell.x, bottom, cell.width, cell.height);
      renderer.render(this.world, this.orbit.camera);
      renderer.setScissorTest(false);
      this.name(cell);
    }
    this.orbit.aspect(this.area[0]!.width, this.area[0]!.height);
    this.labels.sweep();
  }

  private flash(slot: number, now: number): number {
    const share = (now - this.pulsed.since) / PULSE;
    if (slot !== this.pulsed.slot || share >= 1 || share < 0) return 0;
    return calm.matches ? 0.6 : Math.sin(share * Math.PI * 3) ** 2 * (1 - share);
  }

  /** @returns whether this user has a hand to show */
  private pose(slot: number, prop: HandProp): boolean {
    const pose = this.posed;
    if (slot === this.store.slot && this.hold.holds) {
      const force = this.pull();
      pose.place.copy(this.place);
      pose.proxy.copy(this.proxy);
      this.hold.goal(pose.target);
      pose.force.subVectors(pose.target, pose.place).setLength(force);
      pose.radius = this.hold.action === "ball" ? this.hold.radius : 0;
      if (this.hold.action === "blade") pose.edge.copy(this.hold.edge);
      else pose.edge.set(0, 0, 0);
      pose.arrow = null;
      pose.pointed = true;
      prop.pose(pose, this.face);
      return true;
    }
    const copy = this.shown?.copies.find((other) => other.slot === slot);
    if (!copy?.hasHand || copy.mode === "free") return false;
    // Of a rigid tool a hand holds no node, and is told by its force.
    if (copy.node < 0 && copy.radius === 0 && copy.mode !== "pose" && !copy.edge.some(Boolean) && !copy.force.some(Boolean)) return false;
    pose.place.fromArray(copy.place);
    pose.target.fromArray(copy.target);
    pose.force.fromArray(copy.force);
    pose.edge.fromArray(copy.edge);
    pose.proxy.copy(copy.radius > 0 || copy.edge.some(Boolean) ? pose.place : pose.target);
    pose.radius = copy.radius;
    pose.arrow = copy.radius === 0 && copy.node < 0 && !copy.edge.some(Boolean) ? this.behind(slot, pose) : null;
    pose.pointed = false;
    prop.pose(pose, this.face);
    return true;
  }

  /** Where the force on a rigid tool comes in: its handle is within. null: no tool is there, or nothing pushes. */
  private behind(slot: number, { place, force }: HandPose): Vector3 | null {
    if (!force.lengthSq()) return null;
    this.back.set(place, this.back.direction.copy(force).negate().normalize());
    const places = this.copies.get(slot)?.moving.places;
    for (const tool of this.shape.tools) {
      if (places && tool.slot === slot && leaves(tool, this.back, places, this.out)) return this.out;
    }
    return null;
  }

  private name(cell: Cell): void {
    const { slot: mine, me, state } = this.store;
    const named = (slot: number) => this.scene.users.find((user) => user.slot === slot)?.name ?? `User ${slot + 1}`;
    if (this.side) {
      const delay = state ? delaysFrom(state, mine).get(cell.slot) : 0;
      const copy = this.shown?.copies.find((other) => other.slot === cell.slot);
      const gone = state?.members[cell.slot]?.here === false || !copy;
      const old = copy && !copy.direct ? `, shown ${inWords(copy.age)} old` : "";
      const text = cell.slot === me ? "you" : cell.slot === mine ? "" : gone ? "not here" : delay === undefined ? `out of reach${old}` : cell.width < 240 ? `+${inWords(delay)}` : me === null ? `${inWords(delay)} after ${named(mine)}${old}` : `feels you ${inWords(delay)} later${old}`;
      this.labels.put(`cell${cell.slot}`, "title", cell.slot, named(cell.slot), text, cell.x + 14, cell.y + 12);
    }
    for (const [slot, hand] of this.hands) {
      if (!hand.group.visible) continue;
      const at = project(this.orbit.camera, cell, hand.spot);
      if (!at || at.x < cell.x || at.x > cell.x + cell.width || at.y < cell.y || at.y > cell.y + cell.height) continue;
      const force = hand.force > 0.005 * this.full ? newtons(hand.force) : "";
      if (this.side && !force) continue;
      const who = this.side ? "" : slot === me && this.hold.holds ? "You" : named(slot);
      const wide = Labels.wide(who, force);
      at.x = Math.max(Math.min(at.x, cell.x + cell.width - wide), cell.x);
      const covered = this.side ? 0 : this.furniture.covered(at.x, at.x + wide, cell.width);
      at.y = Math.max(Math.min(at.y, cell.y + cell.height + 9 - covered), cell.y + 34);
      this.labels.put(`hand${slot}`, "hand", slot, who, force, at.x, at.y);
    }
  }
}
