// One user's copy in the picture: solid, or a ghost over one's own.
import { Group, LineSegments, Mesh, Points, ShaderMaterial, Vector3 } from "three";
import { channels, RAMP_STOPS } from "../colours";
import { type Relief, reliefOf } from "./relief";
import { defines, edges, ghost, nodes, solid } from "./shaders";
import { Moving, type Shape } from "./shape";

const STOPS = RAMP_STOPS.map((hex) => new Vector3(...channels(hex)).divideScalar(255));

/** Uniforms that all copies share: set once, seen by every program. */
export class Common {
  readonly scale = { value: 0 };
  readonly full = { value: 1 };
  /** 0: by displacement, 1: by stretch, 2: plain. */
  readonly by = { value: 0 };
  readonly stops = { value: STOPS };
  readonly apart: { value: number };
  readonly size: { value: number };
  readonly height = { value: 1 };
  /** The texture on the skin; null: it is smooth. */
  readonly relief: Relief | null;

  constructor(radius: number, shape: Shape) {
    this.apart = { value: 0.05 * radius };
    this.relief = shape.looks ? reliefOf(shape.scene.texture!) : null;
    // Balls of a third of what is between them.
    const lengths = shape.restLengths;
    const between = lengths.length ? lengths.reduce((sum, one) => sum + one, 0) / lengths.length : radius;
    this.size = { value: Math.min(0.17 * between, 0.08 * radius) };
  }
}

export class CopyShown {
  readonly moving: Moving;
  readonly group = new Group();
  private readonly body: Group = new Group();
  private readonly shell: Group = new Group();
  private readonly made: ShaderMaterial[] = [];
  private readonly plain = { value: new Vector3() };
  private readonly colour = { value: new Vector3() };
  /** How bright the colours of bodies are; 0: they have none. */
  private readonly tinted = { value: 0 };
  private readonly flash = { value: 0 };
  private readonly strength = { value: 1 };

  constructor(readonly slot: number, shape: Shape, common: Common) {
    this.moving = new Moving(shape);
    const { geometry, lines, film } = this.moving;
    const { relief, ...shared } = common;
    const uniforms = { ...shared, plain: this.plain, flash: this.flash };
    const make = (source: { vertex: string; fragment: string }, own: object, clear: boolean) => {
      const made = new ShaderMaterial({
        defines: { ...defines(), ...(source === solid && relief ? { RELIEF: "" } : {}) },
        vertexShader: source.vertex, fragmentShader: source.fragment, uniforms: { ...uniforms, ...own },
        transparent: clear, depthWrite: !clear, side: clear ? 0 : 2,
      });
      this.made.push(made);
      return made;
    };
    if (shape.triangles) {
      this.body.add(new Mesh(geometry, make(solid, { tinted: this.tinted, ...relief }, false)));
      this.shell.add(new Mesh(film!, make(ghost, { colour: this.colour, strength: this.strength }, true)));
    } else {
      const plainOnly = { plain: this.colour, by: { value: 2 } };
      this.body.add(new Points(geometry, make(nodes, { opacity: { value: 1 } }, false)));
      this.body.add(new LineSegments(lines!, make(edges, { opacity: { value: 1 } }, false)));
      this.shell.add(new Points(geometry, make(nodes, { opacity: { value: 0.35 }, ...plainOnly }, true)));
      this.shell.add(new LineSegments(lines!, make(edges, { opacity: { value: 0.35 }, ...plainOnly }, true)));
    }
    for (const part of [...this.body.children, ...this.shell.children]) part.frustumCulled = false;
    this.group.add(this.body, this.shell);
  }

  /** A ghost is seen where it differs from this copy. */
  against(own: Moving): void {
    this.moving.film?.setAttribute("own", own.shift);
  }

  paint(hex: string, dark: boolean): void {
    const [r, g, b] = channels(hex).map((value) => value / 255) as [number, number, number];
    this.colour.value.set(r, g, b);
    // Porcelain with a breath of the user's colour.
    this.plain.value.set(0.9, 0.895, 0.875).lerp(this.colour.value, 0.22).multiplyScalar(dark ? 0.9 : 1);
    this.tinted.value = this.moving.shape.tint ? (dark ? 0.9 : 1) : 0;
    this.strength.value = dark ? 1 : 0.95;
  }

  /** @param flash from 0 to 1 */
  show(as: "solid" | "ghost" | "hidden", flash: number): void {
    this.body.visible = as === "solid";
    this.shell.visible = as === "ghost";
    this.flash.value = flash;
  }

  /** Draws of a ghost only what can be seen of it. */
  thin(own: Moving, eye: Vector3, apart: number): void {
    if (this.shell.visible) this.shell.visible = this.moving.differs(own, eye, apart, this.flash.value > 0);
  }

  /** Whoever is farther from the eye is drawn first. */
  order(away: Vector3): void {
    const [x, y, z] = this.moving.mean;
    const depth = away.x * x + away.y * y + away.z * z;
    for (const part of this.shell.children) part.renderOrder = 10 - depth / (Math.abs(depth) + 1);
  }

  dispose(): void {
    this.moving.dispose();
    for (const made of this.made) made.dispose();
  }
}
