// Programs of the graphics card, from shaders.glsl, and the few fixed shapes: ball, rod, cone, box.

// From rest to the most: porcelain to plum. Light falls with the value, so that it reads without colours too.
const RAMP = [[243, 238, 231], [247, 204, 170], [240, 150, 118], [222, 86, 93], [171, 35, 96], [98, 18, 84]];

/** Places, normals and corners of a body of revolution about z. @param {[number, number, number, number][]} profile radius, z, normal outwards, normal along z @param {number} sides */
function turned(profile, sides) {
  const places = [], normals = [], corners = [];
  for (const [r, z, out, up] of profile)
    for (let k = 0; k <= sides; k++) {
      const c = Math.cos((2 * Math.PI * k) / sides), s = Math.sin((2 * Math.PI * k) / sides);
      places.push(r * c, r * s, z);
      normals.push(out * c, out * s, up);
    }
  for (let j = 0; j + 1 < profile.length; j++)
    for (let k = 0; k < sides; k++) {
      const a = j * (sides + 1) + k, b = a + sides + 1;
      corners.push(a, a + 1, b + 1, a, b + 1, b);
    }
  return { places: new Float32Array(places), normals: new Float32Array(normals), corners: new Uint32Array(corners) };
}

const BALL = turned(Array.from({ length: 17 }, (_, j) => {
  const angle = (Math.PI * j) / 16 - Math.PI / 2, c = Math.cos(angle), s = Math.sin(angle);
  return /** @type {[number, number, number, number]} */ ([c, s, c, s]);
}), 32);
const ROD = turned([[0, 0, 0, -1], [1, 0, 0, -1], [1, 0, 1, 0], [1, 1, 1, 0]], 20);
const CONE = turned([[0, 0, 0, -1], [1, 0, 0, -1], [1, 0, 0.9, 0.4], [0, 1, 0.9, 0.4]], 24);

const BOX = (() => {
  const places = [], normals = [], corners = [];
  for (const axis of [0, 1, 2])
    for (const side of [-1, 1]) {
      const first = places.length / 3, [b, c] = side > 0 ? [(axis + 1) % 3, (axis + 2) % 3] : [(axis + 2) % 3, (axis + 1) % 3];
      for (const [u, v] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
        const place = [0, 0, 0], normal = [0, 0, 0];
        place[axis] = normal[axis] = side;
        place[b] = u;
        place[c] = v;
        places.push(...place);
        normals.push(...normal);
      }
      corners.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
  return { places: new Float32Array(places), normals: new Float32Array(normals), corners: new Uint32Array(corners) };
})();

/** A box of half sides 1 with a round hole through it along z. @param {number[]} half sides that it will have @param {number[]} hole its radius, and where it is along x and y @param {number} sides of it */
function bored(half, [radius, x, y], sides) {
  const outer = { places: [...BOX.places], normals: [...BOX.normals], corners: [...BOX.corners.subarray(0, 24)] }; // not the faces along z
  const { places, normals, corners } = outer, first = places.length / 3;
  const ring = Array.from({ length: sides + 1 }, (_, k) => {
    const c = Math.cos((2 * Math.PI * k) / sides), s = Math.sin((2 * Math.PI * k) / sides);
    const [u, v] = [(x + radius * c) / half[0], (y + radius * s) / half[1]];
    const most = Math.max(Math.abs(c), Math.abs(s)); // where the same direction leaves the box
    return { wall: [u, v], rim: [c / most, s / most], inwards: [-c, -s] };
  });
  for (const { wall, rim, inwards } of ring)
    for (const z of [-1, 1]) {
      places.push(...wall, z, ...wall, z, ...rim, z);
      normals.push(...inwards, 0, 0, 0, z, 0, 0, z);
    }
  for (let k = 0; k < sides; k++) {
    const a = first + 6 * k, b = a + 6; // wall, lid and rim below; the same above
    corners.push(a, a + 3, b + 3, a, b + 3, b);
    corners.push(a + 1, b + 1, b + 2, a + 1, b + 2, a + 2, a + 4, b + 5, b + 4, a + 4, a + 5, b + 5);
  }
  return { places: new Float32Array(places), normals: new Float32Array(normals), corners: new Uint32Array(corners) };
}

/** @param {WebGL2RenderingContext} gl @param {string} name */
function program(gl, name) {
  const text = document.getElementById("shaders")?.textContent ?? "";
  /** @type {Record<string, string>} */
  const parts = Object.fromEntries(text.split("#part ").map((part) => [part.slice(0, part.indexOf("\n")), part.slice(part.indexOf("\n") + 1)]));
  const made = /** @type {WebGLProgram} */ (gl.createProgram());
  for (const [kind, stage] of /** @type {[number, string][]} */ ([[gl.VERTEX_SHADER, "vertex"], [gl.FRAGMENT_SHADER, "fragment"]])) {
    const shader = /** @type {WebGLShader} */ (gl.createShader(kind));
    gl.shaderSource(shader, parts[`${name} ${stage}`].replace(/#use (\w+)\n/g, (_, piece) => parts[piece]));
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? name);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made) ?? name);
  /** @type {Record<string, WebGLUniformLocation | null>} */
  const at = {};
  for (let k = 0; k < gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS); k++) {
    const uniform = gl.getActiveUniform(made, k)?.name ?? "";
    at[uniform] = gl.getUniformLocation(made, uniform);
  }
  gl.useProgram(made);
  if (at["stops[0]"]) gl.uniform3fv(at["stops[0]"], RAMP.flat().map((v) => v / 255));
  return { made, at };
}
