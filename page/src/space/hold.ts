// What this page's hand does in space: one pointer, finger, stick or key at a time. Knows no picture.
import { Plane, Quaternion, type Ray, Vector3 } from "three";
import type { Connection } from "../connection";
import type { Action, Vec } from "../protocol";

const spin = new Quaternion();

export class Hold {
  /** What the hand does now. */
  action: Action = "free";
  /** Drawn point that is held; -1: none. */
  point = -1;
  /** Where the pointer is in space [m]. */
  readonly target = new Vector3();
  /** Of the ball [m]. */
  radius: number;
  /** How deep the blade goes [m]. */
  deep: number;
  /** Of the blade, from the target to its tip [m]. */
  readonly edge = new Vector3();
  /** How a rigid tool is to be turned from its start. */
  readonly turned = new Quaternion();
  /** Where it is held, from its handle as it was at the start [m]. */
  readonly local = new Vector3();
  private readonly plane = new Plane();
  private readonly offset = new Vector3();
  /** How far the ball has been pushed in by pressing [m]. */
  private pressed = 0;

  constructor(private readonly connection: Connection, private readonly size: number, private readonly stiffness: number, private readonly flat: boolean) {
    this.radius = 0.16 * size;
    this.deep = 0.5 * size;
  }

  /** Where what is held is to be: its node, a rigid tool's point, the ball, the blade. */
  goal(into: Vector3): Vector3 {
    if (this.action !== "pose") return into.copy(this.target);
    return into.copy(this.local).applyQuaternion(this.turned).add(this.target);
  }

  get holds(): boolean {
    return this.action !== "free";
  }

  /** Takes a point; the pointer met the object at `met` and moves in the plane through it that faces the eye. */
  grab(point: number, place: Vector3, met: Vector3, away: Vector3, time?: number, action: "grab" | "pose" = "grab"): void {
    this.action = action;
    this.point = point;
    this.plane.setFromNormalAndCoplanarPoint(away, met);
    this.offset.subVectors(place, met);
    this.target.copy(place);
    this.send(time);
  }

  /** Takes a rigid tool, whose handle is at `handle` and which is turned so, at a point of its skin. */
  lead(point: number, handle: Vector3, turned: Quaternion, met: Vector3, away: Vector3, time?: number): void {
    this.turned.copy(turned);
    this.local.subVectors(met, handle).applyQuaternion(spin.copy(turned).invert());
    this.grab(point, handle, met, away, time, "pose");
  }

  /** Turns a rigid tool about an axis. */
  turn(axis: Vector3, angle: number, time?: number): void {
    if (this.action !== "pose") return;
    this.turned.premultiply(spin.setFromAxisAngle(axis, angle)).normalize();
    this.send(time);
  }

  /** The pointer is on this ray now, and moves nothing: it did something else meanwhile. */
  rebase(ray: Ray): void {
    const met = ray.intersectPlane(this.plane, new Vector3());
    if (met) this.offset.subVectors(this.target, met);
  }

  /** Puts the ball where it touches the object. */
  press(met: Vector3, away: Vector3, time?: number): void {
    this.action = "ball";
    this.point = -1;
    this.pressed = 0;
    this.offset.copy(away).multiplyScalar(-this.radius);
    this.target.copy(met).add(this.offset);
    this.plane.setFromNormalAndCoplanarPoint(away, met);
    this.send(time);
  }

  /** Puts the blade in where the pointer meets the object, away from the eye; its other end stays a little outside. */
  cut(met: Vector3, away: Vector3, time?: number): void {
    this.action = "blade";
    this.point = -1;
    const outside = 0.08 * this.size;
    this.offset.copy(away).multiplyScalar(-outside);
    this.target.copy(met).add(this.offset);
    this.edge.copy(away).multiplyScalar(this.deep + outside);
    this.plane.setFromNormalAndCoplanarPoint(away, met);
    this.send(time);
  }

  /** Makes the blade so many times as long. */
  deepen(factor: number): void {
    const before = this.deep;
    this.deep = Math.min(Math.max(before * factor, 0.05 * this.size), 2.5 * this.size);
    if (this.action !== "blade") return;
    const outside = 0.08 * this.size;
    this.edge.setLength(this.deep + outside);
    this.send();
  }

  /** A held button pushes the ball in, up to half of it. @returns whether it still moves */
  push(seconds: number, away: Vector3): boolean {
    if (this.action !== "ball" || this.pressed >= 1) return false;
    const more = Math.min(seconds / 0.35, 1 - this.pressed);
    this.pressed += more;
    this.shift(away.clone().multiplyScalar(more * this.radius));
    return true;
  }

  /** The pointer is on this ray now. */
  follow(ray: Ray, time?: number): void {
    const met = ray.intersectPlane(this.plane, new Vector3());
    if (!met || !this.holds) return;
    this.target.copy(met).add(this.offset);
    this.limit();
    this.send(time);
  }

  /** Moves towards or away from the eye. */
  depth(metres: number, away: Vector3): void {
    if (this.holds && !this.flat) this.shift(away.clone().multiplyScalar(metres));
  }

  /** Moves by keys or a stick. */
  shift(by: Vector3): void {
    if (!this.holds) return;
    this.offset.add(by);
    this.target.add(by);
    this.limit();
    this.send();
  }

  release(time?: number): void {
    if (!this.holds) return;
    this.action = "free";
    this.point = -1;
    this.send(time);
  }

  /** Says again what it does; for a connection that came back. */
  send(time?: number): void {
    this.connection.point({
      action: this.action, point: Math.max(this.point, 0), target: this.target.toArray() as Vec,
      radius: this.action === "ball" ? this.radius : 0, stiffness: this.stiffness, time,
      edge: this.action === "blade" ? this.edge.toArray() as Vec : this.action === "pose" ? vectorOf(this.turned) : [0, 0, 0],
    });
  }

  private limit(): void {
    if (this.flat) this.target.z = 0;
    // Nobody means to pull from the next room; a wheel can get there.
    const far = this.target.length();
    if (far > 50 * this.size) this.target.multiplyScalar((50 * this.size) / far);
  }
}

/** Along the axis of turning, as long as the angle, which is at most half a turn [rad]. */
function vectorOf({ x, y, z, w }: Quaternion): Vec {
  const sine = Math.hypot(x, y, z);
  const scale = (sine < 1e-12 ? 2 : (2 * Math.atan2(sine, Math.abs(w))) / sine) * (w < 0 ? -1 : 1);
  return [scale * x, scale * y, scale * z];
}
