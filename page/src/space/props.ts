// A hand in the picture: proxy, force arrow, rope, and the ball that pushes.
import { ConeGeometry, CylinderGeometry, GreaterDepth, Group, Mesh, Quaternion, ShaderMaterial, SphereGeometry, TorusGeometry, Vector3 } from "three";
import { channels } from "../colours";
import { tension } from "../tension";
import { inSoftware } from "./quality";
import { defines, prop } from "./shaders";

// Fine enough for how large they are drawn.
const ball = new SphereGeometry(1, 28, 18);
const sphere = inSoftware() ? new SphereGeometry(1, 10, 7) : new SphereGeometry(1, 18, 12);
const rod = new CylinderGeometry(1, 1, 1, inSoftware() ? 6 : 12, 1, true).translate(0, 0.5, 0);
const cone = new ConeGeometry(1, 1, inSoftware() ? 10 : 18).translate(0, 0.5, 0);
const ring = inSoftware() ? new TorusGeometry(1, 0.13, 5, 20) : new TorusGeometry(1, 0.13, 8, 36);
// Thick where it is held, thin at the tip.
const knife = new CylinderGeometry(0.12, 1, 1, 12).translate(0, 0.5, 0);
const UP = new Vector3(0, 1, 0);
const along = new Vector3(), tail = new Vector3(), turn = new Quaternion();

export function material(hex: string, opacity = 1): ShaderMaterial {
  const made = new ShaderMaterial({
    defines: defines(),
    vertexShader: prop.vertex,
    fragmentShader: prop.fragment,
    uniforms: { colour: { value: new Vector3() }, opacity: { value: opacity } },
    transparent: opacity < 1,
    depthWrite: opacity >= 1,
  });
  paint(made, hex);
  return made;
}

export function paint(what: ShaderMaterial, hex: string): void {
  const [r, g, b] = channels(hex);
  what.uniforms.colour!.value.set(r / 255, g / 255, b / 255);
}

/** Puts a unit rod or cone between two places. */
function span(mesh: Mesh, from: Vector3, to: Vector3, radius: number): void {
  along.subVectors(to, from);
  const length = along.length();
  mesh.visible = length > 1e-9;
  if (!mesh.visible) return;
  mesh.position.copy(from);
  mesh.quaternion.copy(turn.setFromUnitVectors(UP, along.divideScalar(length)));
  mesh.scale.set(radius, length, radius);
}

export interface HandPose {
  /** Of the object: the held point, or the ball's proxy. */
  place: Vector3;
  /** Where the sphere is shown. */
  proxy: Vector3;
  /** Where the pointer is. */
  target: Vector3;
  /** On the object [N]. */
  force: Vector3;
  /** Of the ball; 0 where the hand holds. */
  radius: number;
  /** Of a blade, from its place to the other end, or of a stylus to its round tip; 0: it is neither [m]. */
  edge: Vector3;
  /** Where the force's arrow ends, outside of what is held from within; null: it begins at the place. */
  arrow: Vector3 | null;
  /** Whether to draw the small ring where the pointer is. */
  pointed: boolean;
}

export class HandProp {
  readonly group = new Group();
  /** Where its name belongs. */
  readonly spot = new Vector3();
  /** Of the last pose [N]. */
  force = 0;
  private readonly skin: ShaderMaterial;
  private readonly cord: ShaderMaterial;
  private readonly glass: ShaderMaterial;
  private readonly hidden = new Map<ShaderMaterial, ShaderMaterial>();
  private readonly proxy: Mesh;
  private readonly knot: Mesh;
  private readonly rope: Mesh;
  private readonly lead: Mesh;
  private readonly shaft: Mesh;
  private readonly head: Mesh;
  private readonly mark: Mesh;
  private readonly blade: Mesh;
  private readonly stem: Mesh;
  private readonly end: Mesh;
  private readonly tip = new Vector3();
  private readonly neck = new Vector3();

  /**
   * @param size radius of the object [m]
   * @param full force that draws the longest arrow [N]
   * @param arrow how long arrows of no force and of that one are, in radii of the object
   */
  constructor(private readonly size: number, private readonly full: number, hex: string, private readonly arrow = { least: 0.08, longest: 0.8 }) {
    this.skin = material(hex);
    this.cord = material(hex);
    this.glass = material(hex, 0.55);
    for (const by of [this.skin, this.cord, this.glass]) {
      const faint = material(hex, 0.2);
      faint.depthFunc = GreaterDepth;
      faint.uniforms.colour = by.uniforms.colour!;
      this.hidden.set(by, faint);
    }
    const mesh = (geometry: typeof sphere | typeof rod | typeof cone | typeof ring | typeof knife, by: ShaderMaterial) => {
      const made = new Mesh(geometry, by);
      made.frustumCulled = false;
      this.group.add(made);
      if (inSoftware()) return made;
      // Behind the object a hand still shows, faintly.
      const behind = new Mesh(geometry, this.hidden.get(by)!);
      behind.frustumCulled = false;
      behind.renderOrder = 20;
      made.add(behind);
      return made;
    };
    this.proxy = mesh(sphere, this.skin);
    this.knot = mesh(sphere, this.skin);
    this.rope = mesh(rod, this.cord);
    this.lead = mesh(rod, this.cord);
    this.shaft = mesh(rod, this.skin);
    this.head = mesh(cone, this.skin);
    this.mark = mesh(ring, this.skin);
    this.blade = mesh(knife, this.skin);
    this.stem = mesh(rod, this.glass);
    this.end = mesh(ball, this.glass);
    this.group.visible = false;
  }

  paint(hex: string): void {
    paint(this.skin, hex);
    paint(this.glass, hex);
  }

  /** @param face what turns a ring towards the eye */
  pose(hand: HandPose, face: Quaternion): void {
    const { size } = this;
    const force = (this.force = hand.force.length());
    this.spot.copy(hand.proxy);
    const share = Math.min(force / this.full, 1);
    const thick = size * (0.006 + 0.012 * share);
    paint(this.cord, tension(share, false));
    this.proxy.material = hand.radius > 0 ? this.glass : this.skin;
    this.proxy.geometry = hand.radius > 0 ? ball : sphere;
    this.proxy.position.copy(hand.proxy);
    this.proxy.scale.setScalar(hand.radius > 0 ? hand.radius : size * 0.042);
    const reaches = hand.edge.lengthSq() > 0, cuts = reaches && hand.radius === 0;
    this.knot.visible = hand.radius === 0 && !cuts;
    this.tip.addVectors(hand.place, hand.edge);
    span(this.blade, hand.place, this.tip, size * 0.024);
    span(this.stem, hand.place, this.tip, hand.radius);
    this.blade.visible = cuts;
    this.stem.visible = this.end.visible = reaches && !cuts;
    this.end.position.copy(this.tip);
    this.end.scale.setScalar(hand.radius);
    this.knot.position.copy(hand.place);
    this.knot.scale.setScalar(size * 0.026);
    span(this.rope, hand.place, hand.proxy, thick);
    span(this.lead, hand.proxy, hand.target, thick * 0.8);
    if (hand.radius > 0 || cuts) this.rope.visible = false;
    this.mark.visible = hand.pointed;
    this.mark.position.copy(hand.target);
    this.mark.quaternion.copy(face);
    this.mark.scale.setScalar(size * 0.045);
    this.shaft.visible = this.head.visible = share > 0.01 && !hand.pointed;
    if (!this.shaft.visible) return;
    along.copy(hand.force).divideScalar(force);
    // What begins at the place is half hidden; what ends there is seen as a whole.
    const length = (hand.arrow ? 0.6 : 1) * size * (this.arrow.least + (this.arrow.longest - this.arrow.least) * share);
    const head = Math.min(0.09 * size, 0.6 * length);
    const start = tail.copy(hand.arrow ?? (hand.radius > 0 ? hand.proxy : hand.place));
    if (hand.arrow) start.addScaledVector(along, -length);
    this.tip.copy(start).addScaledVector(along, length);
    this.neck.copy(start).addScaledVector(along, length - head);
    const [tip, neck] = [this.tip, this.neck];
    span(this.shaft, start, neck, 0.145 * head);
    span(this.head, neck, tip, 0.4 * head);
  }

  dispose(): void {
    for (const made of [this.skin, this.cord, this.glass, ...this.hidden.values()]) made.dispose();
  }
}
