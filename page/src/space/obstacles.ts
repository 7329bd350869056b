// What stands still around the object: boxes, plates with a hole, and planes that are no level floor.
import { Box3, BoxGeometry, BufferAttribute, BufferGeometry, EdgesGeometry, ExtrudeGeometry, Group, LineBasicMaterial, LineSegments, Mesh, Path, PlaneGeometry, Quaternion, Shape, Vector3 } from "three";
import type { Obstacle } from "../protocol";
import { material, paint } from "./props";

const UP = new Vector3(0, 0, 1);
const LEVEL = 1 - 1e-6;
// Boxes so many radii away are not in the first picture, which goes by so many points of the object.
const FAR = 6, SOME = 300;
const AROUND = 48, SHARP = 30;

function normalOf({ normal }: Extract<Obstacle, { kind: "plane" }>): Vector3 {
  return new Vector3(...normal).normalize();
}

/** Height of the highest floor: a plane that is level and solid below [m]; null: there is none. */
export function floorOf(obstacles: Obstacle[]): number | null {
  const heights = obstacles.flatMap((one) => (one.kind === "plane" && normalOf(one).z > LEVEL ? [one.point[2]] : []));
  return heights.length ? Math.max(...heights) : null;
}

/** What is to be seen at first: some of the object's points, and the corners of boxes that are not far away [m]. */
export function seenFirst(points: Float32Array, obstacles: Obstacle[], centre: Vector3, radius: number): Float32Array {
  const corners = obstacles.flatMap((one) => {
    if (one.kind === "plane") return [];
    if (one.kind === "solid") return cornersOf(one, centre, FAR * radius);
    if (centre.distanceTo(new Vector3(...one.centre)) > FAR * radius) return [];
    const turn = turnOf(one);
    return Array.from({ length: 8 }, (_, k) => {
      const half = new Vector3(...one.size.map((side, axis) => ((k >> axis) & 1 ? 0.5 : -0.5) * side));
      return half.applyQuaternion(turn).add(new Vector3(...one.centre)).toArray();
    }).flat();
  });
  const each = 3 * Math.max(1, Math.ceil(points.length / 3 / SOME));
  return corners.length ? Float32Array.from([...corners, ...points.filter((_, i) => i % each < 3)]) : points;
}

/** Corners of the box around a solid, if its middle is not far away. */
export function cornersOf({ vertices }: Extract<Obstacle, { kind: "solid" }>, centre: Vector3, far: number): number[] {
  const box = new Box3().setFromArray(vertices);
  if (box.getCenter(new Vector3()).distanceTo(centre) > far) return [];
  const ends = [box.min.toArray(), box.max.toArray()];
  return Array.from({ length: 8 }, (_, k) => [0, 1, 2].map((axis) => ends[(k >> axis) & 1]![axis]!)).flat();
}

/** Triangles, each by itself, so that edges stay sharp. */
function faceted({ vertices, triangles }: Extract<Obstacle, { kind: "solid" }>): BufferGeometry {
  const made = new BufferGeometry();
  made.setAttribute("position", new BufferAttribute(Float32Array.from(vertices), 3));
  made.setIndex(triangles);
  const faces = made.toNonIndexed();
  faces.computeVertexNormals();
  made.dispose();
  return faces;
}

function turnOf({ turn }: Extract<Obstacle, { kind: "box" | "plate" }>): Quaternion {
  const axis = new Vector3(...turn);
  return new Quaternion().setFromAxisAngle(axis.clone().normalize(), axis.length());
}

/** A box with a round hole through it along z, about its middle. */
function bored(size: [number, number, number], [radius, x, y]: [number, number, number, number]): BufferGeometry {
  const [a, b] = [0.5 * size[0], 0.5 * size[1]];
  const outline = new Shape().moveTo(-a, -b).lineTo(a, -b).lineTo(a, b).lineTo(-a, b).closePath();
  outline.holes.push(new Path().absarc(x, y, radius, 0, 2 * Math.PI, true));
  return new ExtrudeGeometry(outline, { depth: size[2], bevelEnabled: false, curveSegments: AROUND }).translate(0, 0, -0.5 * size[2]);
}

export class Obstacles {
  readonly group = new Group();
  private readonly solid = material("#ffffff");
  private readonly sheet = material("#ffffff", 0.3);
  private readonly line = new LineBasicMaterial({ transparent: true, opacity: 0.5 });
  private readonly made: BufferGeometry[] = [];

  /** @param radius of the object [m] */
  constructor(obstacles: Obstacle[], centre: Vector3, radius: number) {
    this.sheet.side = 2;
    for (const one of obstacles) {
      if (one.kind === "plane") {
        const normal = normalOf(one);
        if (normal.z > LEVEL) continue; // the ground is drawn there
        const shown = new Mesh(this.keep(new PlaneGeometry(5 * radius, 5 * radius)), this.sheet);
        // Where it is nearest to the object.
        shown.position.copy(centre).addScaledVector(normal, new Vector3(...one.point).sub(centre).dot(normal));
        shown.quaternion.setFromUnitVectors(UP, normal);
        shown.renderOrder = -1;
        this.group.add(shown);
        continue;
      }
      if (one.kind === "solid") {
        const faces = this.keep(faceted(one));
        this.group.add(new Mesh(faces, this.solid), new LineSegments(this.keep(new EdgesGeometry(faces, SHARP)), this.line));
        continue;
      }
      const box = this.keep(one.kind === "plate" ? bored(one.size, one.hole) : new BoxGeometry(...one.size));
      for (const part of [new Mesh(box, this.solid), new LineSegments(this.keep(new EdgesGeometry(box, SHARP)), this.line)]) {
        part.position.set(...one.centre);
        part.quaternion.copy(turnOf(one));
        this.group.add(part);
      }
    }
  }

  colours(dark: boolean): void {
    paint(this.solid, dark ? "#4A5464" : "#CBD2DC");
    paint(this.sheet, dark ? "#8C98AA" : "#7C8899");
    this.line.color.set(dark ? "#9AA6B8" : "#5C6878");
  }

  dispose(): void {
    for (const part of [this.solid, this.sheet, this.line, ...this.made]) part.dispose();
  }

  private keep<G extends BufferGeometry>(geometry: G): G {
    this.made.push(geometry);
    return geometry;
  }
}
