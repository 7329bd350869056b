// Which point of a copy is under the pointer.
import { Matrix4, type PerspectiveCamera, Ray, Vector3 } from "three";
import type { Moving } from "./shape";

export interface Hit {
  /** Drawn point. */
  point: number;
  /** Where it is [m]. */
  place: Vector3;
  /** Where the surface was met; the point itself where there is none [m]. */
  surface: Vector3;
}

/** A rectangle of the picture, in its pixels. */
export interface Cell {
  slot: number;
  x: number;
  y: number;
  width: number;
  height: number;
}

const a = new Vector3(), b = new Vector3(), c = new Vector3(), met = new Vector3();
const matrix = new Matrix4();

export function rayAt(camera: PerspectiveCamera, cell: Cell, x: number, y: number): Ray {
  const direction = new Vector3((2 * (x - cell.x)) / cell.width - 1, 1 - (2 * (y - cell.y)) / cell.height, 0.5).unproject(camera);
  return new Ray(camera.position.clone(), direction.sub(camera.position).normalize());
}

/** @param reach of a point from the pointer where the surface was missed [pixels] */
export function pick(moving: Moving, camera: PerspectiveCamera, cell: Cell, x: number, y: number, reach: number): Hit | null {
  const { shape, places } = moving;
  const at = (corner: number, into: Vector3) => into.fromArray(places, 3 * corner);
  const ray = rayAt(camera, cell, x, y);
  let nearest = Infinity;
  let corner = -1;
  const surface = new Vector3();
  const { triangles } = moving;
  if (triangles) {
    for (let t = 0; t < triangles.length; t += 3) {
      const [i, j, k] = [triangles[t]!, triangles[t + 1]!, triangles[t + 2]!];
      if (!ray.intersectTriangle(at(i, a), at(j, b), at(k, c), false, met)) continue;
      const far = met.distanceToSquared(ray.origin);
      if (far >= nearest) continue;
      nearest = far;
      surface.copy(met);
      const [p, q, r] = [a.distanceToSquared(met), b.distanceToSquared(met), c.distanceToSquared(met)];
      corner = p <= q && p <= r ? i : q <= r ? j : k;
    }
    if (corner >= 0) return { point: shape.point[corner]!, place: at(corner, new Vector3()), surface };
  }
  // Beside the surface, or no surface: the point that is nearest in the picture, the front one of several.
  matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  let best = reach * reach;
  for (let i = 0; i < shape.corners; i++) {
    at(i, a).applyMatrix4(matrix);
    const dx = cell.x + ((a.x + 1) / 2) * cell.width - x, dy = cell.y + ((1 - a.y) / 2) * cell.height - y;
    const far = dx * dx + dy * dy + 40 * a.z; // z breaks ties towards the eye
    if (a.z < 1 && dx * dx + dy * dy < reach * reach && far - 40 < best) {
      best = far - 40;
      corner = i;
    }
  }
  if (corner < 0) return null;
  const place = at(corner, new Vector3());
  return { point: shape.point[corner]!, place, surface: place.clone() };
}

/** Where something is in the picture [pixels]; null behind the eye. */
export function project(camera: PerspectiveCamera, cell: Cell, place: Vector3): { x: number; y: number } | null {
  a.copy(place).project(camera);
  if (a.z > 1) return null;
  return { x: cell.x + ((a.x + 1) / 2) * cell.width, y: cell.y + ((1 - a.y) / 2) * cell.height };
}
