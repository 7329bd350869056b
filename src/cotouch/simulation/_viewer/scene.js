// Draws copies, tools and forces with WebGL2. A tile is a part of the canvas with one solid copy and any ghosts.

/** @typedef {{x: number, y: number, width: number, height: number, solid: number, ghosts: number[], users: number[]}} Tile in pixels of the page; `users`: whose tools and ports are shown */
/** @typedef {{owner: number[], radius: number[], axis?: number[][], place: Float32Array, force: Float32Array}} Touch; `axis`: of blades, from one end of the edge to the other */
/** @typedef {{places: Float32Array, normals: Float32Array, values: Float32Array, texels: Float32Array, place: WebGLBuffer, normal: WebGLBuffer, value: WebGLBuffer, array: WebGLVertexArrayObject, texture: WebGLTexture, corners: Uint32Array, order: WebGLBuffer | null}} Copy; `corners`: of the triangles that are there */

const WIDE = 1024; // texels in a row, as in shaders.glsl
const APART = 0.015; // of the extent: a ghost so far from the solid copy is seen fully

class Scene {
  /** @param {WebGL2RenderingContext} gl @param {Run} run */
  constructor(gl, run) {
    this.gl = gl;
    this.run = run;
    this.programs = { surface: program(gl, "surface"), points: program(gl, "points"), edges: program(gl, "edges"), solid: program(gl, "solid"), floor: program(gl, "floor") };
    this.solids = { ball: this.shape(BALL), rod: this.shape(ROD), cone: this.shape(CONE), box: this.shape(BOX) };
    this.around = run.header.boxes.map(({ half, hole }) => (hole.length ? this.shape(bored(half, hole, 64)) : this.solids.box));
    this.empty = /** @type {WebGLVertexArrayObject} */ (gl.createVertexArray());
    this.corners = this.filled(gl.ELEMENT_ARRAY_BUFFER, run.triangles);
    this.ends = this.filled(gl.ARRAY_BUFFER, run.edges);
    this.copies = Array.from({ length: run.users }, () => this.copy());
    this.lines = this.edgeArray();
    /** @type {Touch[]} */
    this.touches = []; // as they are at the moment
    this.sizes = measured(run);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  /** @param {number} kind @param {Float32Array | Uint32Array} data @returns {WebGLBuffer} */
  filled(kind, data) {
    const { gl } = this, made = /** @type {WebGLBuffer} */ (gl.createBuffer());
    gl.bindVertexArray(null);
    gl.bindBuffer(kind, made);
    gl.bufferData(kind, data, gl.STATIC_DRAW);
    return made;
  }

  /** @param {number} index @param {WebGLBuffer} buffer @param {number} width */
  attribute(index, buffer, width) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(index);
    gl.vertexAttribPointer(index, width, gl.FLOAT, false, 0, 0);
  }

  /** @param {{places: Float32Array, normals: Float32Array, corners: Uint32Array}} data */
  shape({ places, normals, corners }) {
    const { gl } = this, array = /** @type {WebGLVertexArrayObject} */ (gl.createVertexArray());
    const [place, normal] = [places, normals].map((data) => this.filled(gl.ARRAY_BUFFER, data));
    const order = this.filled(gl.ELEMENT_ARRAY_BUFFER, corners);
    gl.bindVertexArray(array);
    this.attribute(0, place, 3);
    this.attribute(1, normal, 3);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, order);
    gl.bindVertexArray(null);
    return { array, count: corners.length };
  }

  /** @returns {Copy} */
  copy() {
    const { gl, run } = this, count = run.vertices;
    const [place, normal, value] = [0, 1, 2].map(() => /** @type {WebGLBuffer} */ (gl.createBuffer()));
    const array = /** @type {WebGLVertexArrayObject} */ (gl.createVertexArray());
    const order = run.spans.length ? /** @type {WebGLBuffer} */ (gl.createBuffer()) : null; // of its own where it is cut
    gl.bindVertexArray(array);
    this.attribute(0, place, 3);
    this.attribute(1, normal, 3);
    this.attribute(2, value, 1);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, order ?? this.corners);
    gl.bindVertexArray(null);
    const texture = /** @type {WebGLTexture} */ (gl.createTexture());
    gl.bindTexture(gl.TEXTURE_2D, texture);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    return {
      places: new Float32Array(3 * count), normals: new Float32Array(3 * count), values: new Float32Array(count),
      texels: new Float32Array(run.triangles.length ? 0 : 4 * WIDE * Math.ceil(count / WIDE)), place, normal, value, array, texture,
      corners: run.triangles, order,
    };
  }

  edgeArray() {
    const { gl } = this, array = /** @type {WebGLVertexArrayObject} */ (gl.createVertexArray());
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.ends);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribIPointer(0, 2, gl.UNSIGNED_INT, 0, 0);
    gl.vertexAttribDivisor(0, 1);
    gl.bindVertexArray(null);
    return array;
  }

  /** Brings all copies to a moment. @param {number} at @param {"displacement" | "difference"} field @param {number} most [m] @param {number} solid the copy from which the ghosts are away; -1 for no ghosts */
  move(at, field, most, solid) {
    const { run, copies } = this;
    copies.forEach((copy, user) => {
      run.copy(user, at, copy.places);
      if (copy.order) {
        const room = new Uint32Array(run.triangles.length);
        copy.corners = room.subarray(0, run.shown(user, at, room));
      }
    });
    const origin = field === "displacement" ? run.rest : mean(copies.map((copy) => copy.places));
    copies.forEach((copy, user) => {
      const ghost = solid >= 0 && user !== solid, from = ghost ? copies[solid].places : origin, scale = ghost ? APART * this.sizes.extent : most || 1;
      for (let v = 0, i = 0; v < copy.values.length; v++, i += 3)
        {
        const x = copy.places[i] - from[i], y = copy.places[i + 1] - from[i + 1], z = copy.places[i + 2] - from[i + 2];
        copy.values[v] = Math.sqrt(x * x + y * y + z * z) / scale; // much faster than hypot
      }
      this.upload(copy);
    });
    this.touches = [run.tools, run.ports].map((touch) => ({
      ...touch, place: run.row(touch.place, 3 * touch.owner.length, at), force: run.row(touch.force, 3 * touch.owner.length, at),
    }));
  }

  /** @param {Copy} copy */
  upload(copy) {
    const { gl, run } = this;
    if (run.triangles.length) {
      smooth(copy.places, copy.corners, copy.normals);
      if (copy.order) {
        gl.bindVertexArray(null);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, copy.order);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, copy.corners, gl.DYNAMIC_DRAW);
      }
      for (const [buffer, data] of /** @type {[WebGLBuffer, Float32Array][]} */ ([[copy.place, copy.places], [copy.normal, copy.normals], [copy.value, copy.values]])) {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
      }
      return;
    }
    for (let v = 0; v < copy.values.length; v++) {
      copy.texels.set(copy.places.subarray(3 * v, 3 * v + 3), 4 * v);
      copy.texels[4 * v + 3] = copy.values[v];
    }
    gl.bindTexture(gl.TEXTURE_2D, copy.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, WIDE, copy.texels.length / (4 * WIDE), 0, gl.RGBA, gl.FLOAT, copy.texels);
  }

  /** @param {Tile[]} tiles @param {Camera} camera @param {number[][]} colors of users, then of the floor's lines, 0 to 1 @param {number} ratio device pixels of a page's pixel */
  draw(tiles, camera, colors, ratio) {
    const { gl } = this, view = camera.view();
    gl.disable(gl.SCISSOR_TEST);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.SCISSOR_TEST);
    for (const tile of tiles) {
      const area = [tile.x, gl.canvas.height / ratio - tile.y - tile.height, tile.width, tile.height].map((v) => Math.round(v * ratio));
      gl.viewport(area[0], area[1], area[2], area[3]);
      gl.scissor(area[0], area[1], area[2], area[3]);
      const projection = camera.projection(tile.width, tile.height);
      for (const { made, at } of Object.values(this.programs)) {
        gl.useProgram(made);
        gl.uniformMatrix4fv(at.view, false, view);
        gl.uniformMatrix4fv(at.projection, false, projection);
      }
      gl.clear(gl.DEPTH_BUFFER_BIT);
      this.ground(colors[colors.length - 1]);
      this.boxes(colors[colors.length - 1]);
      this.body(this.copies[tile.solid], [0, 0, 0], 0, area, ratio);
      for (const ghost of tile.ghosts) this.ghost(this.copies[ghost], colors[ghost], area, ratio);
      if (tile.ghosts.length) {
        gl.clear(gl.DEPTH_BUFFER_BIT);
        gl.colorMask(false, false, false, false);
        this.body(this.copies[tile.solid], [0, 0, 0], 0, area, ratio);
        gl.colorMask(true, true, true, true);
      }
      this.hands(tile.users, colors);
    }
  }

  /** A surface shines through all other copies, but not through itself; nodes and edges stand beside the solid ones. @param {Copy} copy @param {number[]} color @param {number[]} area @param {number} ratio */
  ghost(copy, color, area, ratio) {
    const { gl } = this;
    if (!this.run.triangles.length) return this.body(copy, color, 0.45, area, ratio);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.colorMask(false, false, false, false);
    this.body(copy, color, 1, area, ratio);
    gl.colorMask(true, true, true, true);
    this.body(copy, color, 0.85, area, ratio);
  }

  /** @param {number[]} color */
  ground(color) {
    const { gl } = this, { extent, middle, size, floor, pitch } = this.sizes, { made, at } = this.programs.floor;
    gl.useProgram(made);
    gl.depthMask(false);
    gl.uniform3f(at.centre, middle[0], middle[1], floor);
    gl.uniform3fv(at.color, color);
    gl.uniform2f(at.shade, 0.45 * size[0] + 0.06 * extent, 0.45 * size[1] + 0.06 * extent);
    gl.uniform1f(at.reach, 1.1 * extent);
    gl.uniform1f(at.pitch, pitch);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    gl.depthMask(true);
  }

  /** What stands around. @param {number[]} color */
  boxes(color) {
    const { gl } = this, { made, at } = this.programs.solid;
    gl.useProgram(made);
    for (const [k, { centre, half, turn }] of this.run.header.boxes.entries()) {
      const { array, count } = this.around[k];
      gl.bindVertexArray(array);
      gl.uniform4fv(at.color, [...color, 1]);
      gl.uniform3fv(at.scale, half);
      gl.uniform3fv(at.offset, centre);
      gl.uniformMatrix3fv(at.turn, false, turn);
      gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    }
  }

  /** A copy: a surface, or edges and nodes. @param {Copy} copy @param {number[]} color @param {number} ghost its strength; 0 for a solid one @param {number[]} area @param {number} ratio */
  body(copy, color, ghost, area, ratio) {
    const { gl, run } = this, { surface, edges, points } = this.programs;
    const parts = run.triangles.length ? [surface] : [edges, points];
    for (const { made, at } of parts) {
      gl.useProgram(made);
      gl.uniform3fv(at.color, color);
      gl.uniform1f(at.ghost, ghost);
    }
    gl.depthFunc(gl.LEQUAL);
    if (run.triangles.length) {
      gl.useProgram(surface.made);
      gl.bindVertexArray(copy.array);
      gl.drawElements(gl.TRIANGLES, copy.corners.length, gl.UNSIGNED_INT, 0);
      return;
    }
    gl.bindTexture(gl.TEXTURE_2D, copy.texture);
    gl.useProgram(edges.made);
    gl.uniform2f(edges.at.size, area[2], area[3]);
    gl.uniform1f(edges.at.thick, 1.5 * ratio);
    gl.bindVertexArray(this.lines);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, run.edges.length / 2);
    gl.useProgram(points.made);
    gl.uniform1f(points.at.radius, this.sizes.dot);
    gl.uniform1f(points.at.height, area[3]);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.POINTS, 0, run.vertices);
  }

  /** Tools, ports and their forces; what the object hides shines through it. @param {number[]} users @param {number[][]} colors */
  hands(users, colors) {
    const { gl } = this, { extent, metresPerNewton } = this.sizes;
    gl.useProgram(this.programs.solid.made);
    for (const hidden of [true, false]) {
      gl.depthFunc(hidden ? gl.GREATER : gl.LEQUAL);
      gl.depthMask(!hidden);
      for (const touch of this.touches)
        touch.owner.forEach((user, k) => {
          if (!users.includes(user)) return;
          const color = [...colors[user], hidden ? 0.22 : 1];
          const place = [...touch.place.subarray(3 * k, 3 * k + 3)], force = [...touch.force.subarray(3 * k, 3 * k + 3)];
          const radius = touch.radius[k] || 0.011 * extent;
          const edge = touch.axis?.[k] ?? [0, 0, 0], reach = Math.hypot(...edge);
          if (reach > 0) {
            const wide = Math.max(radius, 0.006 * extent); // a blade is seen however thin it is
            this.solid("rod", color, [wide, wide, reach], place, edge.map((e) => e / reach));
            return;
          }
          this.solid("ball", color, [radius, radius, radius], place, [0, 0, 1]);
          const size = Math.hypot(...force), length = size * metresPerNewton;
          if (length < 0.004 * extent) return;
          const way = force.map((f) => f / size), head = Math.min(0.06 * extent, 0.5 * length), thick = 0.13 * head;
          const from = touch.radius[k] ? radius : 0; // arrows leave a ball at its surface
          const foot = place.map((p, d) => p + from * way[d]), neck = foot.map((p, d) => p + (length - head) * way[d]);
          this.solid("rod", color, [thick, thick, length - head], foot, way);
          this.solid("cone", color, [2.7 * thick, 2.7 * thick, head], neck, way);
        });
    }
    gl.depthMask(true);
    gl.depthFunc(gl.LEQUAL);
  }

  /** @param {"ball" | "rod" | "cone"} kind @param {number[]} color @param {number[]} scale @param {number[]} offset @param {number[]} way where its z axis points */
  solid(kind, color, scale, offset, way) {
    const { gl } = this, { at } = this.programs.solid, { array, count } = this.solids[kind];
    const x = cross(Math.abs(way[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0], way), size = Math.hypot(...x);
    const side = x.map((v) => v / size);
    gl.uniform4fv(at.color, color);
    gl.uniform3fv(at.scale, scale);
    gl.uniform3fv(at.offset, offset);
    gl.uniformMatrix3fv(at.turn, false, [...side, ...cross(way, side), ...way]);
    gl.bindVertexArray(array);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
  }
}

/** Sizes: the object's box, what is to be seen, arrows, dots, floor. @param {Run} run */
function measured(run) {
  const { low, step } = run.header, touches = [run.tools, run.ports];
  const size = step.map((s) => 65535 * s), middle = low.map((l, d) => l + size[d] / 2);
  const reach = run.tools.radius.reduce((a, b) => Math.max(a, b), 0);
  const extent = Math.hypot(...size) || 8 * reach || 1; // a single point has no size
  const peak = touches.reduce((most, touch) => touch.force.reduce((m, _, i, f) =>
    i % 3 ? m : Math.max(m, Math.hypot(f[i], f[i + 1], f[i + 2])), most), 0);
  const metresPerNewton = peak > 0 ? (0.3 * extent) / peak : 0;
  const cloud = Array.from({ length: 24 }, (_, i) => low[i % 3] + ((Math.floor(i / 3) >> i % 3) & 1) * size[i % 3]);
  let bottom = low[2];
  for (const touch of touches)
    for (let i = 0; i < touch.place.length; i += 3) {
      const r = touch.radius[(i / 3) % touch.owner.length], p = touch.place.subarray(i, i + 3);
      const f = Math.hypot(...touch.force.subarray(i, i + 3)) || 1;
      for (const d of [0, 1, 2]) cloud.push(p[0] + (d === 0 ? r : 0), p[1] + (d === 1 ? r : 0), p[2] + (d === 2 ? r : -r));
      cloud.push(...[0, 1, 2].map((d) => p[d] + (metresPerNewton + r / f) * touch.force[i + d]));
      bottom = Math.min(bottom, p[2] - r);
    }
  const { floor, boxes } = run.header;
  for (const { centre, half, turn } of boxes)
    for (let k = 0; k < 8; k++) cloud.push(...[0, 1, 2].map((d) => centre[d] + [0, 1, 2].reduce((s, a) => s + (k >> a & 1 ? 1 : -1) * half[a] * turn[3 * a + d], 0)));
  const { edges, rest } = run;
  let dot = 0.02 * extent, length = 0;
  for (let k = 0; k < edges.length; k += 2)
    length += Math.hypot(...[0, 1, 2].map((d) => rest[3 * edges[k] + d] - rest[3 * edges[k + 1] + d]));
  if (length > 0) dot = Math.min(dot, (0.2 * length) / edges.length); // a tenth of an edge
  return { size, middle, extent, peak, metresPerNewton, cloud, dot, floor: floor ?? bottom - 0.02 * extent, pitch: round(extent / 5), flat: size[2] < 1e-6 * extent };
}

/** @param {Float32Array[]} arrays */
function mean(arrays) {
  const result = new Float32Array(arrays[0].length);
  for (const array of arrays) for (let i = 0; i < array.length; i++) result[i] += array[i] / arrays.length;
  return result;
}

/** Normals of vertices from those of their triangles, the less the longer its sides there [Max 1999], so that slivers leave no dents. @param {Float32Array} p @param {Uint32Array} corners @param {Float32Array} n */
function smooth(p, corners, n) {
  n.fill(0);
  for (let k = 0; k < corners.length; k += 3) {
    const a = 3 * corners[k], b = 3 * corners[k + 1], c = 3 * corners[k + 2];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    const wx = vx - ux, wy = vy - uy, wz = vz - uz;
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    const u = ux * ux + uy * uy + uz * uz, v = vx * vx + vy * vy + vz * vz, w = wx * wx + wy * wy + wz * wz;
    if (!(u * v * w > 0)) continue; // two corners in one place
    n[a] += x / (u * v); n[a + 1] += y / (u * v); n[a + 2] += z / (u * v);
    n[b] += x / (u * w); n[b + 1] += y / (u * w); n[b + 2] += z / (u * w);
    n[c] += x / (v * w); n[c + 1] += y / (v * w); n[c + 2] += z / (v * w);
  }
  for (let i = 0; i < n.length; i += 3) {
    const size = Math.sqrt(n[i] * n[i] + n[i + 1] * n[i + 1] + n[i + 2] * n[i + 2]) || 1;
    n[i] /= size;
    n[i + 1] /= size;
    n[i + 2] /= size;
  }
}
