// The page's space without a session: copies, hands, ground and obstacles of an animation at any of its moments.
import { Box3, CylinderGeometry, Mesh, Quaternion, Ray, type ShaderMaterial, Scene as World, Vector3, WebGLRenderer } from "three";
import { readTexture, type Obstacle, type Scene } from "../protocol";
import { Common, CopyShown } from "../space/copy";
import { Ground } from "../space/ground";
import { Obstacles, cornersOf, floorOf } from "../space/obstacles";
import { Orbit } from "../space/orbit";
import { type Cell, project } from "../space/pick";
import { HandProp, material, paint } from "../space/props";
import { inSoftware } from "../space/quality";
import { Shape } from "../space/shape";
import { type RigidTool, leaves, poseOf } from "../space/tool";
import type { Run, Touch } from "./data.js";

export interface Tile extends Omit<Cell, "slot"> {
  solid: number;
  ghosts: number[];
  /** Whose tools and hands are shown. */
  users: number[];
}

export interface Sizes {
  /** Of a ball around all frames [m]. */
  radius: number;
  /** Largest force [N]. */
  peak: number;
  metresPerNewton: number;
  /** Between two lines of the ground; 0: there is none [m]. */
  pitch: number;
}

const LEVELS = 32767;
const LONGEST = 0.6; // of the radius: the arrow of the largest force

export class Shown {
  readonly sizes: Sizes;
  readonly orbit: Orbit;
  /** Places of every copy's vertices now [m]. */
  readonly places: Float32Array[];
  /** Tools and hands now. */
  touches: Touch[] = [];
  private readonly renderer: WebGLRenderer;
  private readonly world = new World();
  private readonly common: Common;
  private readonly shape: Shape;
  private readonly copies: CopyShown[];
  private readonly hands: HandProp[][];
  /** Of tools, by number: those that cut. */
  private readonly blades = new Map<number, Mesh<CylinderGeometry, ShaderMaterial>>();
  private readonly ground: Ground;
  private readonly obstacles: Obstacles;
  private readonly shift: Int16Array;
  private readonly values: Float32Array;
  private readonly face = new Quaternion();

  constructor(canvas: HTMLCanvasElement, private readonly run: Run) {
    const { low, step, obstacles } = run.header;
    const size = step.map((one) => 65535 * one);
    const centre = new Vector3(...low.map((one, axis) => one + size[axis]! / 2));
    const widest = Math.max(0, ...run.tools.radius);
    const radius = Math.hypot(...size) / 2 || 4 * widest || 1; // a single point has no size
    const flat = size[2]! < 1e-6 * radius;
    const touches = [run.tools, run.ports];
    let peak = 0;
    for (const { force } of touches) for (let i = 0; i < force.length; i += 3) peak = Math.max(peak, Math.hypot(force[i]!, force[i + 1]!, force[i + 2]!));
    const metresPerNewton = peak > 0 ? (LONGEST * radius) / peak : 0;
    const scene = sceneOf(run, centre, radius, flat);
    const shape = new Shape(scene);
    shape.loose = run.spans.length > 0;
    this.common = new Common(radius, shape);
    this.shape = shape;
    this.common.scale.value = run.header.peaks.displacement / LEVELS;
    this.renderer = new WebGLRenderer({ canvas, antialias: !inSoftware(), alpha: true, powerPreference: "high-performance" });
    this.renderer.setClearAlpha(0);
    this.renderer.autoClear = false;
    this.shift = new Int16Array(3 * run.vertices);
    this.values = new Float32Array(run.vertices);
    this.places = Array.from({ length: run.users }, () => new Float32Array(3 * run.vertices));
    this.copies = this.places.map((_, user) => new CopyShown(user, shape, this.common));
    this.hands = touches.map(({ owner }) => owner.map(() => new HandProp(radius, peak || 1, "#ffffff", { least: 0, longest: LONGEST })));
    run.tools.axis.forEach((axis, k) => {
      const edge = new Vector3(...axis), reach = edge.length();
      if (!(reach > 0)) return;
      const blade = new Mesh(new CylinderGeometry(1, 1, 1, 12).translate(0, 0.5, 0), material("#ffffff"));
      const wide = Math.max(run.tools.radius[k]!, 0.012 * radius); // a blade is seen however thin it is
      blade.scale.set(wide, reach, wide);
      blade.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), edge.divideScalar(reach));
      this.blades.set(k, blade);
    });
    let bottom = low[2]!;
    for (const { place, radius: sizes } of touches) place.forEach((value, i) => i % 3 === 2 && (bottom = Math.min(bottom, value - (sizes[Math.floor(i / 3) % sizes.length] ?? 0))));
    this.ground = new Ground(centre, bottom, radius, scene.skin ? this.copies[0]!.moving : null, floorOf(obstacles));
    this.ground.mesh.visible = !flat || size[1] === 0;
    this.obstacles = new Obstacles(obstacles, centre, radius);
    this.world.add(this.ground.mesh, this.obstacles.group, ...this.copies.map((copy) => copy.group), ...this.hands.flat().map((hand) => hand.group), ...this.blades.values());
    const cloud = cloudOf(run, centre, radius, metresPerNewton);
    this.orbit = new Orbit(new Box3().setFromArray(cloud).getCenter(new Vector3()), radius, cloud, flat && size[1]! > 0, [1.1, 1.1]);
    this.sizes = { radius, peak, metresPerNewton, pitch: this.ground.mesh.visible ? (this.ground.mesh.material.uniforms.pitch!.value as number) / 5 : 0 };
  }

  /** Dresses everything: colours of users as #rrggbb. */
  paint(colours: string[], dark: boolean): void {
    this.copies.forEach((copy, user) => copy.paint(colours[user]!, dark));
    [this.run.tools, this.run.ports].forEach(({ owner }, kind) => owner.forEach((user, k) => this.hands[kind]![k]!.paint(colours[user]!)));
    for (const [k, blade] of this.blades) paint(blade.material, colours[this.run.tools.owner[k]!]!);
    this.ground.colours(dark);
    this.obstacles.colours(dark);
  }

  /**
   * Brings everything to a moment.
   * @param full what the strongest colour stands for [m]
   * @param solid the copy that ghosts are compared with
   */
  move(at: number, field: "bodies" | "displacement" | "difference", full: number, solid: number): void {
    const { run, common, copies, places, shift } = this;
    common.full.value = full || 1;
    common.by.value = { displacement: 0, difference: 1, bodies: 2 }[field];
    places.forEach((into, user) => run.copy(user, at, into));
    const mean = field === "difference" ? meanOf(places) : null;
    const scale = common.scale.value || 1;
    const time = run.timeAt(at), count = run.triangles.length / 3;
    copies.forEach((copy, user) => {
      const here = places[user]!;
      if (run.spans.length) copy.moving.keep((t) => run.spans[2 * (user * count + t)]! <= time && time < run.spans[2 * (user * count + t) + 1]!);
      for (let i = 0; i < shift.length; i++) shift[i] = Math.round((here[i]! - run.rest[i]!) / scale);
      copy.moving.update(shift, common.scale.value, false);
      if (mean) copy.moving.colour(apart(here, mean, this.values));
      copy.against(copies[solid]!.moving);
    });
    this.touches = [run.tools, run.ports].map((touch) => ({
      ...touch,
      place: run.row(touch.place, 3 * touch.owner.length, at),
      force: run.row(touch.force, 3 * touch.owner.length, at),
    }));
    this.touches.forEach((touch, kind) => touch.owner.forEach((_, k) => this.pose(this.hands[kind]![k]!, touch, k)));
  }

  /** @param ratio pixels of the screen for one of the page */
  draw(tiles: Tile[], width: number, height: number, ratio: number): void {
    const { renderer, orbit, copies } = this;
    renderer.setPixelRatio(ratio);
    renderer.setSize(width, height, false);
    const [, , away] = orbit.axes();
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
    renderer.clear();
    for (const tile of tiles) {
      orbit.aspect(tile.width, tile.height);
      copies.forEach((copy, user) => {
        copy.show(user === tile.solid ? "solid" : tile.ghosts.includes(user) ? "ghost" : "hidden", 0);
        copy.thin(copies[tile.solid]!.moving, orbit.camera.position, this.common.apart.value);
        copy.order(away);
      });
      this.touches.forEach((touch, kind) => touch.owner.forEach((user, k) => {
        const shown = tile.users.includes(user), blade = kind === 0 ? this.blades.get(k) : undefined;
        this.hands[kind]![k]!.group.visible = shown && !blade;
        if (blade) blade.visible = shown;
      }));
      this.ground.shadow(renderer, copies[tile.solid]!.moving, this.common.scale.value);
      this.common.height.value = tile.height * ratio;
      const bottom = height - tile.y - tile.height;
      renderer.setScissorTest(true);
      renderer.setScissor(tile.x, bottom, tile.width, tile.height);
      renderer.setViewport(tile.x, bottom, tile.width, tile.height);
      renderer.render(this.world, orbit.camera);
      renderer.setScissorTest(false);
    }
    orbit.aspect(tiles[0]!.width, tiles[0]!.height);
  }

  /** Where a place is seen in a picture of some size [pixels]. */
  seen(place: number[], width: number, height: number): [number, number] {
    const found = project(this.orbit.camera, { slot: 0, x: 0, y: 0, width, height }, new Vector3(...place));
    return found ? [found.x, found.y] : [-1e6, -1e6];
  }

  private pose(hand: HandProp, touch: Touch, k: number): void {
    const place = new Vector3().fromArray(touch.place, 3 * k);
    const force = new Vector3().fromArray(touch.force, 3 * k);
    if (touch === this.touches[0]) this.blades.get(k)?.position.copy(place);
    const arrow = touch === this.touches[1] ? this.behind(touch.owner[k]!, place, force) : null;
    hand.pose({ place, proxy: place, target: place, force, radius: touch.radius[k] ?? 0, edge: new Vector3(...(touch === this.touches[0] ? this.run.tools.tip[k]! : [])), arrow, pointed: false }, this.face);
  }

  /** Where the force comes in of a hand whose place is the handle of a rigid tool, within it; null: it is none, or nothing pushes. */
  private behind(user: number, place: Vector3, force: Vector3): Vector3 | null {
    const { rest, tools } = this.shape, { places } = this.copies[user]!.moving;
    const near = (tool: RigidTool) => poseOf(tool, rest, places).handle.distanceTo(place) < 0.01 * this.sizes.radius;
    const tool = tools.find((one) => one.slot === user && near(one)), out = new Vector3();
    const met = tool && force.lengthSq() && leaves(tool, new Ray(place, force.clone().negate().normalize()), places, out);
    return met ? out : null;
  }
}

/** What the page's space takes a body for. */
function sceneOf(run: Run, centre: Vector3, radius: number, flat: boolean): Scene {
  const { header, rest, triangles, edges } = run;
  const node = new Uint32Array(run.vertices);
  return {
    title: header.title, version: "", dimension: flat ? 2 : 3, users: header.users.map((name, slot) => ({ name, slot })), own: [], may: [],
    acts: false, invitation: null, page: null, started: "", stiffness: 0, radius, centre: [centre.x, centre.y, centre.z],
    nodes: { count: run.vertices, rest }, points: rest, edges, obstacles: header.obstacles, parts: header.parts, cutting: null,
    texture: readTexture(header.texture, radius),
    skin: triangles.length ? { vertices: run.vertices, rest, triangles, node } : null,
  };
}

/** Corners of boxes around all that is to be seen at first: copies, tools, arrows and obstacles that are near [m]. */
function cloudOf(run: Run, centre: Vector3, radius: number, metresPerNewton: number): Float32Array {
  const { low, step, obstacles } = run.header;
  const corners: number[] = [];
  const box = (least: number[], most: number[]) => {
    for (let k = 0; k < 8; k++) for (let axis = 0; axis < 3; axis++) corners.push((k >> axis) & 1 ? most[axis]! : least[axis]!);
  };
  box(low, low.map((one, axis) => one + 65535 * step[axis]!));
  for (const touch of [run.tools, run.ports])
    touch.owner.forEach((_, k) => {
      const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
      for (let i = 3 * k; i < touch.place.length; i += 3 * touch.owner.length)
        for (let axis = 0; axis < 3; axis++) {
          const edge = touch === run.tools ? run.tools.axis[k]![axis]! + run.tools.tip[k]![axis]! : 0;
          const at = touch.place[i + axis]!, tip = at + edge + metresPerNewton * touch.force[i + axis]!, r = touch.radius[k] ?? 0;
          least[axis] = Math.min(least[axis]!, at - r, tip);
          most[axis] = Math.max(most[axis]!, at + r, tip);
        }
      box(least, most);
    });
  for (const one of obstacles as Obstacle[]) {
    if (one.kind === "plane") continue;
    if (one.kind === "solid") {
      corners.push(...cornersOf(one, centre, 6 * radius));
      continue;
    }
    if (centre.distanceTo(new Vector3(...one.centre)) > 6 * radius) continue;
    const half = Math.hypot(...one.size) / 2;
    box(one.centre.map((x) => x - half), one.centre.map((x) => x + half));
  }
  return Float32Array.from(corners);
}

function meanOf(arrays: Float32Array[]): Float32Array {
  const result = new Float32Array(arrays[0]!.length);
  for (const array of arrays) for (let i = 0; i < array.length; i++) result[i]! += array[i]! / arrays.length;
  return result;
}

/** How far every vertex is from another place for it. */
function apart(here: Float32Array, there: Float32Array, into: Float32Array): Float32Array {
  for (let v = 0, i = 0; v < into.length; v++, i += 3) {
    const x = here[i]! - there[i]!, y = here[i + 1]! - there[i + 1]!, z = here[i + 2]! - there[i + 2]!;
    into[v] = Math.sqrt(x * x + y * y + z * z);
  }
  return into;
}
