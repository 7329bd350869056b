// Rigid tools that can be led: which there are, and how each is placed in a copy.
import { Matrix4, Quaternion, type Ray, Vector3 } from "three";
import type { Scene } from "../protocol";

export interface RigidTool {
  /** Whose it is. */
  slot: number;
  /** Its drawn points: the first, and one past the last. */
  first: number;
  last: number;
  /** Where it is held at rest [m]. */
  handle: Vector3;
  /** Corners of its skin that are far apart, by which its pose is read. */
  corners: [number, number, number];
  /** Corners of its triangles. */
  triangles: Uint32Array;
}

const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
const met = new Vector3();
const basis = new Matrix4();
const within = (value: number, first: number, last: number) => value >= first && value < last;

/**
 * @param corner of every drawn point
 * @param point of every corner
 * @param triangles their corners
 */
export function toolsOf({ parts, points }: Scene, corner: Uint32Array, point: Uint32Array, triangles: Uint32Array | null): RigidTool[] {
  const at = (point: number) => new Vector3().fromArray(points, 3 * point);
  const found: RigidTool[] = [];
  let first = 0;
  for (const { vertices, tool } of parts) {
    const last = first + vertices;
    if (tool) {
      const own = Array.from({ length: vertices }, (_, k) => first + k);
      const farthest = (how: (place: Vector3) => number) => own.reduce((best, point) => (how(at(point)) > how(at(best)) ? point : best));
      const one = first;
      const two = farthest((place) => place.distanceToSquared(at(one)));
      const line = at(two).sub(at(one));
      const three = farthest((place) => place.sub(at(one)).cross(line).lengthSq());
      const [begin, end] = [first, last];
      found.push({
        slot: tool.slot, first, last, handle: new Vector3(...tool.handle),
        corners: [corner[one]!, corner[two]!, corner[three]!],
        triangles: (triangles ?? new Uint32Array()).filter((_, k, all) => within(point[all[k - (k % 3)]!]!, begin, end)),
      });
    }
    first = last;
  }
  return found;
}

/** Where a tool's handle is, and how the tool is turned from its start. */
export function poseOf(tool: RigidTool, rest: Float32Array, places: Float32Array): { handle: Vector3; turned: Quaternion } {
  const turned = axesOf(tool, places).multiply(axesOf(tool, rest).invert());
  const from = new Vector3().fromArray(rest, 3 * tool.corners[0]);
  const handle = tool.handle.clone().sub(from).applyQuaternion(turned);
  return { handle: handle.add(a.fromArray(places, 3 * tool.corners[0])), turned };
}

/** Where a ray out of a tool leaves it last. @returns whether it meets it */
export function leaves(tool: RigidTool, ray: Ray, places: Float32Array, into: Vector3): boolean {
  let farthest = 0;
  for (let t = 0; t < tool.triangles.length; t += 3) {
    const [i, j, k] = [tool.triangles[t]!, tool.triangles[t + 1]!, tool.triangles[t + 2]!];
    if (!ray.intersectTriangle(a.fromArray(places, 3 * i), b.fromArray(places, 3 * j), c.fromArray(places, 3 * k), false, met)) continue;
    const far = met.distanceToSquared(ray.origin);
    if (far <= farthest) continue;
    farthest = far;
    into.copy(met);
  }
  return farthest > 0;
}

function axesOf({ corners: [one, two, three] }: RigidTool, places: Float32Array): Quaternion {
  a.fromArray(places, 3 * one);
  b.fromArray(places, 3 * two).sub(a).normalize();
  c.fromArray(places, 3 * three).sub(a);
  const up = new Vector3().crossVectors(b, c).normalize();
  return new Quaternion().setFromRotationMatrix(basis.makeBasis(b, c.crossVectors(up, b), up));
}
