// The texture on a skin as it is drawn: slopes and heights of one tile, and where on the skin it lies.
import { DataTexture, LinearFilter, LinearMipmapLinearFilter, RepeatWrapping, RGBAFormat, UnsignedByteType, Vector2, Vector3 } from "three";
import type { Scene, Texture } from "../protocol";

/** What programs read; see `solid` in shaders. */
export interface Relief {
  tile: { value: DataTexture };
  /** Tiles for each metre, along its two sides. */
  tiles: { value: Vector2 };
  /** Cosine and sine of the angle that it is turned by. */
  turn: { value: Vector2 };
  /** What a whole value of the tile's slopes stands for. */
  steep: { value: number };
  /** Share of each axis that it is laid on along; 0 of all: as the skin looks. */
  along: { value: Vector3 };
}

/** Slopes in red and green, 128 for none; heights in blue. */
export function reliefOf({ heights, rows, columns, size, top, angle, projection }: Texture): Relief {
  const slopes = new Float32Array(2 * rows * columns);
  const at = (row: number, column: number) => (heights[((row + rows) % rows) * columns + ((column + columns) % columns)]! / 65535) * top;
  let steep = 0;
  for (let i = 0; i < rows; i++)
    for (let j = 0; j < columns; j++) {
      const k = 2 * (i * columns + j);
      slopes[k] = ((at(i, j + 1) - at(i, j - 1)) * columns) / (2 * size[0]);
      slopes[k + 1] = ((at(i + 1, j) - at(i - 1, j)) * rows) / (2 * size[1]);
      steep = Math.max(steep, Math.abs(slopes[k]!), Math.abs(slopes[k + 1]!));
    }
  steep = steep || 1;
  const data = new Uint8Array(4 * rows * columns);
  for (let n = 0; n < rows * columns; n++) {
    data[4 * n] = 128 + Math.round((127 * slopes[2 * n]!) / steep);
    data[4 * n + 1] = 128 + Math.round((127 * slopes[2 * n + 1]!) / steep);
    data[4 * n + 2] = heights[n]! >> 8;
    data[4 * n + 3] = 255;
  }
  const tile = new DataTexture(data, columns, rows, RGBAFormat, UnsignedByteType);
  tile.wrapS = tile.wrapT = RepeatWrapping;
  tile.magFilter = LinearFilter;
  tile.minFilter = LinearMipmapLinearFilter;
  tile.generateMipmaps = true;
  tile.needsUpdate = true;
  const axis = ["x", "y", "z"].indexOf(projection);
  const along = new Vector3();
  if (axis >= 0) along.setComponent(axis, 1);
  return {
    tile: { value: tile }, tiles: { value: new Vector2(1 / size[0], 1 / size[1]) }, turn: { value: new Vector2(Math.cos(angle), Math.sin(angle)) },
    steep: { value: steep }, along: { value: along },
  };
}

/** Where the skin looks at every corner at rest, by the mean of the triangles around its point; 0 of bare parts. */
export function looksOf(scene: Scene, point: Uint32Array): Float32Array {
  const { points: p } = scene, triangles = scene.skin!.triangles;
  const looks = new Float32Array(p.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t]!, 3 * triangles[t + 1]!, 3 * triangles[t + 2]!];
    const ux = p[b]! - p[a]!, uy = p[b + 1]! - p[a + 1]!, uz = p[b + 2]! - p[a + 2]!;
    const vx = p[c]! - p[a]!, vy = p[c + 1]! - p[a + 1]!, vz = p[c + 2]! - p[a + 2]!;
    const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const corner of [a, b, c]) for (let k = 0; k < 3; k++) looks[corner + k]! += n[k]!;
  }
  let first = 0;
  for (const { vertices, bare } of scene.parts) {
    if (bare) looks.fill(0, 3 * first, 3 * (first + vertices));
    first += vertices;
  }
  const result = new Float32Array(3 * point.length);
  point.forEach((own, c) => {
    const [x, y, z] = [looks[3 * own]!, looks[3 * own + 1]!, looks[3 * own + 2]!];
    const size = Math.hypot(x, y, z) || 1;
    result.set([x / size, y / size, z / size], 3 * c);
  });
  return result;
}
