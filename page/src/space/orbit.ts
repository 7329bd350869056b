// Where one looks from: around a target, z up.
import { PerspectiveCamera, Vector3 } from "three";

const LIMIT = 1.54;
const OUTSIDE = 1.15; // nearest to the centre of what is shown, in radii of the ball around it

interface Place {
  target: Vector3;
  yaw: number;
  pitch: number;
  /** In units of the distance from which all is seen. */
  zoom: number;
}

export class Orbit {
  readonly camera = new PerspectiveCamera(30, 1, 0.01, 100);
  private readonly home: Place;
  private goal: Place;
  private now: Place;
  private fit = 1;

  private readonly fits = new Map<string, number>();

  /**
   * @param size radius of a ball around the centre with all in it [m]
   * @param cloud places that are to be seen at first, behind each other [m]
   * @param flat whether to look straight down
   * @param room for what is pulled out of it, and for names: so much larger the picture is, in a high one and in a wide one
   */
  constructor(centre: Vector3, readonly size: number, private readonly cloud: Float32Array, flat: boolean, private readonly room: readonly [number, number] = [1.2, 1.42]) {
    this.camera.up.set(0, 0, 1);
    this.camera.near = size * 0.02;
    this.camera.far = size * 60;
    this.home = { target: centre.clone(), yaw: flat ? -Math.PI / 2 : -1.08, pitch: flat ? LIMIT : 0.36, zoom: 1 };
    this.goal = clone(this.home);
    this.now = clone(this.home);
  }

  /** For a picture of this size. */
  aspect(width: number, height: number): void {
    this.camera.aspect = width / Math.max(height, 1);
    this.fit = this.fitted(this.camera.aspect);
    this.camera.updateProjectionMatrix();
    this.apply();
  }

  /** From how far all of the cloud is seen at first. */
  private fitted(aspect: number): number {
    const key = aspect.toFixed(3);
    const known = this.fits.get(key);
    if (known) return known;
    const { target } = this.home;
    const back = backOf(this.home);
    const right = new Vector3(0, 0, 1).cross(back).normalize(), up = back.clone().cross(right), q = new Vector3();
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const stride = 3 * Math.max(1, Math.floor(this.cloud.length / 3 / 500));
    let fit = 0.5 * this.size;
    for (let i = 0; i < this.cloud.length; i += stride) {
      q.fromArray(this.cloud, i).sub(target);
      fit = Math.max(fit, q.dot(back) + this.room[aspect < 1 ? 0 : 1] * Math.max(Math.abs(q.dot(right)) / aspect, 1.12 * Math.abs(q.dot(up))) / half);
    }
    this.fits.set(key, fit);
    return fit;
  }

  turn(dx: number, dy: number): void {
    this.goal.yaw -= dx * 0.0065;
    this.goal.pitch = Math.min(Math.max(this.goal.pitch + dy * 0.0065, -LIMIT), LIMIT);
  }

  /** Comes nearer or goes away, and never into the object. */
  zoom(factor: number): void {
    const nearest = this.nearest(this.goal) / this.fit;
    this.goal.zoom = Math.min(Math.max(Math.max(this.goal.zoom, nearest) * factor, nearest, 0.12), Math.max(6, nearest));
  }

  /** Moves along the picture by so many of its pixels. */
  pan(dx: number, dy: number, height: number): void {
    const size = this.metres(height);
    const [right, up] = this.axes();
    this.goal.target.addScaledVector(right, -dx * size).addScaledVector(up, dy * size);
  }

  reset(): void {
    this.goal = clone(this.home);
  }

  /** Size of a pixel at the target [m]. */
  metres(height: number): number {
    return (2 * Math.tan((this.camera.fov * Math.PI) / 360) * Math.max(this.now.zoom * this.fit, this.nearest(this.now))) / Math.max(height, 1);
  }

  /** Right, up and away, of length 1. */
  axes(): [Vector3, Vector3, Vector3] {
    const right = new Vector3(), up = new Vector3(), back = new Vector3();
    this.camera.updateMatrixWorld();
    this.camera.matrixWorld.extractBasis(right, up, back);
    return [right, up, back.negate()];
  }

  /** Follows what was asked for; whether it is still moving. @param share of the way, 1 at once */
  step(share: number): boolean {
    const { now, goal } = this;
    const far = Math.abs(goal.yaw - now.yaw) + Math.abs(goal.pitch - now.pitch) + Math.abs(Math.log(goal.zoom / now.zoom)) + goal.target.distanceTo(now.target) / this.size;
    if (far === 0) return false;
    const part = far < 1e-3 ? 1 : share;
    if (part < 1) {
      now.yaw += (goal.yaw - now.yaw) * part;
      now.pitch += (goal.pitch - now.pitch) * part;
      now.zoom *= (goal.zoom / now.zoom) ** part;
      now.target.lerp(goal.target, part);
    } else this.now = clone(goal); // to the last digit
    this.apply();
    return true;
  }

  /** From where on, away from its target, the eye is outside of the ball around all that is shown [m]. */
  private nearest(place: Place): number {
    const off = place.target.clone().sub(this.home.target);
    const along = off.dot(backOf(place));
    const beside = (OUTSIDE * this.size) ** 2 - off.lengthSq() + along ** 2;
    return beside > 0 ? Math.sqrt(beside) - along : 0;
  }

  private apply(): void {
    const { target, zoom } = this.now;
    const distance = Math.max(zoom * this.fit, this.nearest(this.now));
    this.camera.position.copy(backOf(this.now)).multiplyScalar(distance).add(target);
    this.camera.lookAt(target);
    this.camera.updateMatrixWorld();
  }
}

/** From the target to the eye, of length 1. */
function backOf({ yaw, pitch }: Place): Vector3 {
  return new Vector3(Math.cos(yaw) * Math.cos(pitch), Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch));
}

function clone(place: Place): Place {
  return { ...place, target: place.target.clone() };
}
