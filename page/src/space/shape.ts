// What all copies share, and the moving part of each: filled in place from the messages, frame after frame.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, StaticDrawUsage } from "three";
import { bodyColour, channels } from "../colours";
import { readCut, type Scene } from "../protocol";
import { looksOf } from "./relief";
import { type RigidTool, toolsOf } from "./tool";

/** Faces that meet at more than this are an edge, not a curve. */
const CREASE = Math.cos((50 * Math.PI) / 180);

/** The drawn points and how they hang together; skins are cut at their creases, so that corners stay sharp. */
export class Shape {
  /** Corner of a drawn vertex to the point it shows. */
  readonly point: Uint32Array;
  /** (corners * 3) */
  readonly rest: Float32Array;
  /** Corners of triangles; null where there are only nodes. */
  readonly triangles: Uint32Array | null;
  /** Pairs of corners: the sides of triangles, or the edges between nodes. */
  readonly sides: Uint32Array;
  /** A corner of every point. */
  readonly corner: Uint32Array;
  readonly restLengths: Float32Array;
  /** Sides at every corner's point, at least 1. */
  readonly degree: Float32Array;
  readonly corners: number;

  /** Of every corner the colour of its body, from 0 to 1; null where there is one body. */
  readonly tint: Float32Array | null;

  /** Where the skin looks at every corner at rest, for a texture; null: it is smooth. */
  readonly looks: Float32Array | null;

  /** Rigid tools that can be led. */
  readonly tools: RigidTool[];

  /** Whether triangles of a copy may be gone. */
  loose: boolean;

  constructor(readonly scene: Scene) {
    this.loose = scene.cutting != null;
    const points = scene.points.length / 3;
    if (scene.skin) {
      const cut = creased(scene.points, scene.skin.triangles);
      this.point = cut.point;
      this.triangles = cut.triangles;
    } else {
      this.point = Uint32Array.from({ length: points }, (_, i) => i);
      this.triangles = null;
    }
    this.corners = this.point.length;
    this.rest = new Float32Array(this.corners * 3);
    this.corner = new Uint32Array(points);
    this.point.forEach((point, c) => {
      this.corner[point] = c;
      for (let k = 0; k < 3; k++) this.rest[3 * c + k] = scene.points[3 * point + k]!;
    });
    this.tools = toolsOf(scene, this.corner, this.point, this.triangles);
    this.looks = scene.skin && scene.texture ? looksOf(scene, this.point) : null;
    this.tint = scene.parts.length ? tints(scene.parts, this.point) : null;
    this.sides = scene.skin ? sidesOf(scene.skin.triangles, this.corner, points) : (scene.edges ?? new Uint32Array());
    const count = this.sides.length / 2;
    this.restLengths = new Float32Array(count);
    this.degree = new Float32Array(this.corners);
    for (let s = 0; s < count; s++) {
      const a = this.sides[2 * s]!, b = this.sides[2 * s + 1]!;
      this.restLengths[s] = distance(this.rest, a, b);
      this.degree[a]!++;
      this.degree[b]!++;
    }
    for (let c = 0; c < this.corners; c++) this.degree[c] = Math.max(this.degree[c]!, 1);
  }
}

/** The colour of every corner's body. */
function tints(parts: Scene["parts"], point: Uint32Array): Float32Array {
  const of = parts.flatMap(({ vertices, colour }, number) => {
    const own = channels(bodyColour(number, colour)).map((value) => value / 255);
    return Array.from({ length: vertices }, () => own);
  });
  return Float32Array.from(Array.from(point).flatMap((p) => of[p] ?? [1, 1, 1]));
}

/** One copy's places, normals and stretch. */
export class Moving {
  readonly geometry = new BufferGeometry();
  readonly lines: BufferGeometry | null = null;
  /** The same surface, of which only what `differs` found is drawn; null without one. */
  readonly film: BufferGeometry | null = null;
  readonly shift: BufferAttribute;
  readonly places: Float32Array;
  /** Mean displacement [m]. */
  readonly mean: [number, number, number] = [0, 0, 0];
  /** Largest displacement, or share of stretch, of the last update. */
  peak = 0;
  private readonly normal: BufferAttribute;
  private readonly value: BufferAttribute;
  private readonly faces: BufferAttribute | null = null;
  private readonly seen: Uint8Array;
  /** Corners of the triangles that are there; null where there are only nodes. */
  triangles: Uint32Array | null;
  /** Corners of none of these: what was cut away. */
  private gone: Uint8Array | null = null;
  private told: string | null = null;

  constructor(readonly shape: Shape) {
    this.triangles = shape.triangles;
    const n = shape.corners;
    const attribute = (array: Int16Array | Float32Array, size: number) => new BufferAttribute(array, size).setUsage(DynamicDrawUsage);
    this.places = shape.rest.slice();
    this.seen = new Uint8Array(n);
    this.shift = attribute(new Int16Array(3 * n), 3);
    this.normal = attribute(new Float32Array(3 * n), 3);
    this.value = attribute(new Float32Array(n), 1);
    const rest = new BufferAttribute(shape.rest, 3);
    for (const geometry of [this.geometry, ...(shape.triangles ? [] : [(this.lines = new BufferGeometry())])]) {
      geometry.setAttribute("position", rest);
      geometry.setAttribute("shift", this.shift);
      geometry.setAttribute("value", this.value);
    }
    if (shape.triangles) {
      this.geometry.setAttribute("normal", this.normal);
      if (shape.looks) this.geometry.setAttribute("looks", new BufferAttribute(shape.looks, 3));
      if (shape.tint) this.geometry.setAttribute("tint", new BufferAttribute(shape.tint, 3));
      const index = shape.loose ? shape.triangles.slice() : shape.triangles; // what is cut has one of its own
      this.geometry.setIndex(new BufferAttribute(index, 1).setUsage(shape.loose ? DynamicDrawUsage : StaticDrawUsage));
      this.film = new BufferGeometry();
      for (const name of ["position", "shift", "normal"] as const) this.film.setAttribute(name, this.geometry.getAttribute(name));
      this.film.setIndex((this.faces = new BufferAttribute(new Uint32Array(shape.triangles.length), 1).setUsage(DynamicDrawUsage)));
    }
    this.lines?.setIndex(new BufferAttribute(shape.sides, 1));
    if (shape.scene.cutting) this.cut(btoa("\0".repeat(Math.ceil(shape.scene.cutting.elements / 8))));
    this.update(new Int16Array(shape.scene.points.length), 0, false);
  }

  /** Draws what is left when these elements are gone. @param told a bit for each, as in `MemberStatus.cut`; null: as it was */
  cut(told: string | null): void {
    const { cutting } = this.shape.scene;
    if (!cutting || told === null || told === this.told) return;
    this.told = told;
    const cut = readCut(told, cutting.elements);
    const { pointer, element, beyond } = cutting;
    this.keep((t) => {
      let there = beyond[t]! < 0 || cut[beyond[t]!] === 1;
      for (let n = pointer[t]!; there && n < pointer[t + 1]!; n++) there = cut[element[n]!] === 0;
      return there;
    });
  }

  /** Draws only some of the triangles; of a loose shape. */
  keep(there: (triangle: number) => boolean): void {
    const all = this.shape.triangles;
    if (!all) return;
    const index = this.geometry.index!.array as Uint32Array;
    this.gone = new Uint8Array(this.shape.corners).fill(1);
    let size = 0;
    for (let t = 0; 3 * t < all.length; t++) {
      if (!there(t)) continue;
      for (let k = 0; k < 3; k++) {
        index[size++] = all[3 * t + k]!;
        this.gone[all[3 * t + k]!] = 0;
      }
    }
    this.triangles = index.subarray(0, size);
    this.geometry.setDrawRange(0, size);
    this.geometry.index!.needsUpdate = true;
  }

  update(displacement: Int16Array, scale: number, stretch: boolean): void {
    const { point, rest, corners } = this.shape;
    const shift = this.shift.array as Int16Array;
    const { places, gone } = this;
    let most = 0, x = 0, y = 0, z = 0;
    for (let c = 0; c < corners; c++) {
      const i = 3 * c, j = 3 * point[c]!;
      const a = displacement[j]!, b = displacement[j + 1]!, d = displacement[j + 2]!;
      shift[i] = a;
      shift[i + 1] = b;
      shift[i + 2] = d;
      places[i] = rest[i]! + a * scale;
      places[i + 1] = rest[i + 1]! + b * scale;
      places[i + 2] = rest[i + 2]! + d * scale;
      x += a;
      y += b;
      z += d;
      if (gone?.[c]) continue;
      most = Math.max(most, a * a + b * b + d * d);
    }
    this.mean[0] = (x * scale) / corners;
    this.mean[1] = (y * scale) / corners;
    this.mean[2] = (z * scale) / corners;
    this.shift.needsUpdate = true;
    this.peak = stretch ? this.stretch() : Math.sqrt(most) * scale;
    if (this.triangles) this.normals(this.triangles);
  }

  /** Gives every drawn point a value to be coloured by, in place of stretch. */
  colour(values: Float32Array): void {
    const value = this.value.array as Float32Array;
    this.shape.point.forEach((point, c) => (value[c] = values[point]!));
    this.value.needsUpdate = true;
  }

  /**
   * Leaves of the film only triangles that the ghost's program would not draw clear, and that face the eye: mostly a few.
   * @param own copy that it is compared with
   * @param apart see `Common` [m]
   * @param all whether to leave out no more than what faces away
   * @returns whether anything is left
   */
  differs(own: Moving, eye: { x: number; y: number; z: number }, apart: number, all: boolean): boolean {
    const { corners } = this.shape, { triangles } = this;
    if (!triangles || !this.film || !this.faces) return true;
    const { places: p, seen } = this, q = own.places, n = this.normal.array as Float32Array;
    const [near, far] = [(0.1 * apart) ** 2, (3 * apart) ** 2];
    for (let c = 0; c < corners; c++) {
      const i = 3 * c, x = n[i]!, y = n[i + 1]!, z = n[i + 2]!;
      let cover = all;
      if (!cover) {
        const dx = p[i]! - q[i]!, dy = p[i + 1]! - q[i + 1]!, dz = p[i + 2]! - q[i + 2]!;
        const out = dx * x + dy * y + dz * z;
        cover = (out > 0 && out * out > near * (x * x + y * y + z * z)) || dx * dx + dy * dy + dz * dz > far;
      }
      const faces = x * (p[i]! - eye.x) + y * (p[i + 1]! - eye.y) + z * (p[i + 2]! - eye.z) < 0;
      seen[c] = (cover ? 1 : 0) | (faces ? 2 : 0);
    }
    const index = this.faces.array as Uint32Array;
    let count = 0;
    for (let t = 0; t < triangles.length; t += 3) {
      const a = triangles[t]!, b = triangles[t + 1]!, c = triangles[t + 2]!;
      if ((seen[a]! | seen[b]! | seen[c]!) !== 3) continue;
      index[count++] = a;
      index[count++] = b;
      index[count++] = c;
    }
    this.film.setDrawRange(0, count);
    this.faces.clearUpdateRanges();
    this.faces.addUpdateRange(0, count);
    if (count) this.faces.needsUpdate = true;
    return count > 0;
  }

  dispose(): void {
    this.film?.dispose();
    this.geometry.dispose();
    this.lines?.dispose();
  }

  private normals(triangles: Uint32Array): void {
    const p = this.places;
    const n = this.normal.array as Float32Array;
    n.fill(0);
    for (let t = 0; t < triangles.length; t += 3) {
      const a = 3 * triangles[t]!, b = 3 * triangles[t + 1]!, c = 3 * triangles[t + 2]!;
      const ux = p[b]! - p[a]!, uy = p[b + 1]! - p[a + 1]!, uz = p[b + 2]! - p[a + 2]!;
      const vx = p[c]! - p[a]!, vy = p[c + 1]! - p[a + 1]!, vz = p[c + 2]! - p[a + 2]!;
      const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
      n[a]! += x; n[a + 1]! += y; n[a + 2]! += z;
      n[b]! += x; n[b + 1]! += y; n[b + 2]! += z;
      n[c]! += x; n[c + 1]! += y; n[c + 2]! += z;
    }
    this.normal.needsUpdate = true;
  }

  /** How much the sides at each point are longer or shorter than at rest, in the mean. */
  private stretch(): number {
    const { sides, restLengths, degree, corner, point, corners } = this.shape;
    const value = this.value.array as Float32Array;
    value.fill(0);
    for (let s = 0; s < restLengths.length; s++) {
      const a = sides[2 * s]!, b = sides[2 * s + 1]!;
      if (this.gone && (this.gone[a] || this.gone[b])) continue;
      const strain = Math.abs(distance(this.places, a, b) / Math.max(restLengths[s]!, 1e-12) - 1);
      value[a]! += strain / degree[a]!;
      value[b]! += strain / degree[b]!;
    }
    let most = 0;
    for (let c = 0; c < corners; c++) {
      value[c] = value[corner[point[c]!]!]!;
      most = Math.max(most, value[c]!);
    }
    this.value.needsUpdate = true;
    return most;
  }
}

function distance(places: Float32Array, a: number, b: number): number {
  const x = places[3 * a]! - places[3 * b]!, y = places[3 * a + 1]! - places[3 * b + 1]!, z = places[3 * a + 2]! - places[3 * b + 2]!;
  return Math.sqrt(x * x + y * y + z * z);
}

function sidesOf(triangles: Uint32Array, corner: Uint32Array, points: number): Uint32Array {
  const seen = new Set<number>();
  const sides: number[] = [];
  for (let t = 0; t < triangles.length; t++) {
    const a = triangles[t]!, b = triangles[t % 3 === 2 ? t - 2 : t + 1]!;
    const key = Math.min(a, b) * points + Math.max(a, b);
    if (seen.has(key)) continue;
    seen.add(key);
    sides.push(corner[a]!, corner[b]!);
  }
  return Uint32Array.from(sides);
}

/** Splits points where faces meet at an edge: faces around a point that are joined by smooth sides share a corner. */
function creased(places: Float32Array, triangles: Uint32Array): { point: Uint32Array; triangles: Uint32Array } {
  const faces = triangles.length / 3;
  const normals = new Float32Array(3 * faces);
  const around: number[][] = Array.from({ length: places.length / 3 }, () => []);
  for (let f = 0; f < faces; f++) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * triangles[3 * f + k]!) as [number, number, number];
    const u = [0, 1, 2].map((k) => places[b + k]! - places[a + k]!), v = [0, 1, 2].map((k) => places[c + k]! - places[a + k]!);
    const n = [u[1]! * v[2]! - u[2]! * v[1]!, u[2]! * v[0]! - u[0]! * v[2]!, u[0]! * v[1]! - u[1]! * v[0]!];
    const size = Math.hypot(...n) || 1;
    for (let k = 0; k < 3; k++) {
      normals[3 * f + k] = n[k]! / size;
      around[triangles[3 * f + k]!]!.push(f);
    }
  }
  const smooth = (f: number, g: number) =>
    normals[3 * f]! * normals[3 * g]! + normals[3 * f + 1]! * normals[3 * g + 1]! + normals[3 * f + 2]! * normals[3 * g + 2]! > CREASE;
  const touches = (f: number, g: number, point: number) => {
    for (let i = 0; i < 3; i++) for (let j = 0; j < 3; j++)
      if (triangles[3 * f + i] === triangles[3 * g + j] && triangles[3 * f + i] !== point) return true;
    return false;
  };
  const point: number[] = [];
  const result = new Uint32Array(triangles.length);
  around.forEach((all, p) => {
    const left = new Set(all);
    for (const first of all) {
      if (!left.delete(first)) continue;
      const group = [first];
      for (let i = 0; i < group.length; i++)
        for (const other of left) if (smooth(group[i]!, other) && touches(group[i]!, other, p)) { left.delete(other); group.push(other); }
      for (const f of group) for (let k = 0; k < 3; k++) if (triangles[3 * f + k] === p) result[3 * f + k] = point.length;
      point.push(p);
    }
    if (!all.length) point.push(p);
  });
  return { point: Uint32Array.from(point), triangles: result };
}
