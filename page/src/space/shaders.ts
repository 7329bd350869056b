// Programs of the graphics card. Colours are worked out in sRGB and lit in linear light.
// With LEAN, where the processor draws: light at vertices instead of pixels, and no powers that are no whole numbers.
import { inSoftware } from "./quality";

/** What every program is made with. */
export function defines(): Record<string, string> {
  return inSoftware() ? { LEAN: "" } : {};
}

const light = /* glsl */ `
#ifdef LEAN
vec3 toLinear(vec3 c) { return c * c; }
vec3 toScreen(vec3 c) { return sqrt(c); }
float gleam(float x) { x *= x; x *= x; x *= x; x *= x; return x * x; }
float edge(float x) { return x * x * x; }
#else
vec3 toLinear(vec3 c) { return pow(c, vec3(2.2)); }
vec3 toScreen(vec3 c) { return pow(c, vec3(1.0 / 2.2)); }
float gleam(float x) { return pow(x, 42.0); }
float edge(float x) { return pow(x, 3.5); }
#endif
vec3 lit(vec3 colour, vec3 n, vec3 eye, float gloss) {
  vec3 key = normalize(vec3(-0.45, 0.8, 0.55)), fill = normalize(vec3(0.9, 0.05, 0.35));
  float up = 0.5 + 0.5 * n.y;
  float wrap = max(dot(n, key) * 0.85 + 0.15, 0.0);
  vec3 light = mix(vec3(0.30, 0.29, 0.33), vec3(0.60, 0.62, 0.66), up) + 0.78 * wrap * vec3(1.0, 0.98, 0.94)
    + 0.16 * max(dot(n, fill), 0.0) * vec3(0.8, 0.9, 1.0);
  vec3 halfway = normalize(key + eye);
  float shine = gleam(max(dot(n, halfway), 0.0)) * gloss;
  float rim = edge(1.0 - max(dot(n, eye), 0.0));
  return toScreen(toLinear(colour) * light + shine + rim * 0.10 * vec3(0.8, 0.9, 1.0));
}
`;

const ramp = /* glsl */ `
uniform vec3 stops[9];
vec3 ramp(float value) {
  float at = clamp(value, 0.0, 1.0) * 8.0;
  int low = min(int(at), 7);
  return mix(stops[low], stops[low + 1], at - float(low));
}
`;

/** Slopes of a texture on a skin, as contact has it, and the light that they catch. */
const relief = /* glsl */ `
#ifdef RELIEF
uniform sampler2D tile;
uniform vec2 tiles, turn;
uniform float steep;
uniform vec3 along;
/** Slopes along two axes, and height, seen along the third. */
vec3 laid(vec2 at) {
  vec3 found = texture2D(tile, vec2(dot(at, turn), turn.x * at.y - turn.y * at.x) * tiles).rgb;
  vec2 slope = (found.rg * 255.0 - 128.0) / 127.0 * steep;
  return vec3(turn.x * slope.x - turn.y * slope.y, turn.y * slope.x + turn.x * slope.y, found.b);
}
/** The normal of the skin with its texture; colour gets what hollows lack of light. q: place, at: at rest, m: normal. */
vec3 rough(vec3 q, vec3 at, vec3 looks, vec3 m, inout vec3 colour) {
  vec3 share = looks * looks;
  share *= share;
  float all = share.x + share.y + share.z;
  share = all > 1e-6 ? (along == vec3(0.0) ? share / all : along) : vec3(0.0);
  vec3 x = vec3(0.0), y = vec3(0.0), z = vec3(0.0);
  if (along.y + along.z == 0.0) x = laid(at.yz);
  if (along.x + along.z == 0.0) y = laid(at.xz);
  if (along.x + along.y == 0.0) z = laid(at.xy);
  vec3 slope = share.x * vec3(0.0, x.xy) + share.y * vec3(y.x, 0.0, y.y) + share.z * vec3(z.xy, 0.0);
  slope *= min(1.0, 3.0 / max(length(slope), 1e-6));
  float height = dot(share, vec3(x.z, y.z, z.z));
  if (all > 1e-6) colour *= 0.86 + 0.14 * height;
  // What rises from pixel to pixel tilts the normal, however the skin is stretched [Mikkelsen 2010].
  vec3 right = dFdx(q), over = dFdy(q), first = cross(over, m), second = cross(m, right);
  float size = dot(right, first);
  vec3 rises = sign(size) * (dot(slope, dFdx(at)) * first + dot(slope, dFdy(at)) * second);
  vec3 tilted = abs(size) * m - rises;
  return dot(tilted, tilted) > 0.0 ? normalize(tilted) : m;
}
#endif
`;

/** A copy, solid; with RELIEF its texture needs light at pixels everywhere. */
export const solid = {
  vertex: /* glsl */ `
    ${light}${ramp}
    attribute vec3 shift, tint;
    attribute float value;
    uniform float scale, full, flash, tinted;
    uniform vec3 plain;
    uniform int by;
    #if defined(LEAN) && !defined(RELIEF)
    varying vec3 shown;
    #else
    varying vec3 n, p, own;
    varying float v;
    #endif
    #ifdef RELIEF
    attribute vec3 looks;
    varying vec3 stands, faces;
    #endif
    void main() {
      vec4 q = modelViewMatrix * vec4(position + shift * scale, 1.0);
      float far = (by == 0 ? length(shift) * scale : value) / full;
      gl_Position = projectionMatrix * q;
      #ifdef RELIEF
      stands = position;
      faces = looks;
      #endif
      #if defined(LEAN) && !defined(RELIEF)
      vec3 eye = normalize(-q.xyz), m = normalize(mat3(modelViewMatrix) * normal + 1e-20);
      if (dot(m, eye) < -0.2) m = -m;
      shown = mix(lit(by == 2 ? (tinted > 0.0 ? tinted * tint : plain) : ramp(far), m, eye, 0.20), vec3(1.0), flash * 0.5);
      #else
      n = mat3(modelViewMatrix) * normal;
      p = q.xyz;
      own = tinted > 0.0 ? tinted * tint : plain;
      v = far;
      #endif
    }`,
  fragment: /* glsl */ `
    #if defined(LEAN) && !defined(RELIEF)
    varying vec3 shown;
    void main() { gl_FragColor = vec4(shown, 1.0); }
    #else
    ${light}${ramp}${relief}
    uniform int by;
    uniform float flash;
    varying vec3 n, p, own;
    varying float v;
    #ifdef RELIEF
    varying vec3 stands, faces;
    #endif
    void main() {
      vec3 eye = normalize(-p), m = normalize(n);
      if (!gl_FrontFacing) m = -m;
      vec3 colour = by == 2 ? own : ramp(v);
      #ifdef RELIEF
      m = rough(p, stands, faces, m, colour);
      #endif
      gl_FragColor = vec4(mix(lit(colour, m, eye, 0.20), vec3(1.0), flash * 0.5), 1.0);
    }
    #endif`,
};

/** Another's copy over one's own: seen where the two differ, and at its rim. */
export const ghost = {
  vertex: /* glsl */ `
    attribute vec3 shift, own;
    uniform float scale, apart, flash, strength;
    #ifndef LEAN
    varying vec3 n, p;
    #endif
    varying float v;
    void main() {
      vec4 q = modelViewMatrix * vec4(position + shift * scale, 1.0);
      // Where both surfaces cross they differ along neither's normal: no seam is seen.
      vec3 differs = (shift - own) * scale / apart;
      v = max(smoothstep(0.1, 1.0, dot(differs, normalize(normal + 1e-20))), 0.5 * smoothstep(3.0, 8.0, length(differs)));
      gl_Position = projectionMatrix * q;
      #ifdef LEAN
      float rim = 1.0 - abs(dot(normalize(mat3(modelViewMatrix) * normal + 1e-20), normalize(-q.xyz)));
      v = min(v * strength * (0.05 + 0.95 * rim * sqrt(rim)) + flash * 0.35, 1.0);
      #else
      n = mat3(modelViewMatrix) * normal;
      p = q.xyz;
      #endif
    }`,
  fragment: /* glsl */ `
    uniform vec3 colour;
    uniform float flash, strength;
    varying float v;
    #ifdef LEAN
    void main() { gl_FragColor = vec4(mix(colour, vec3(1.0), flash * 0.3), v); }
    #else
    varying vec3 n, p;
    void main() {
      float rim = 1.0 - abs(dot(normalize(n), normalize(-p)));
      float cover = v * strength * (0.05 + 0.95 * pow(rim, 1.5)) + flash * 0.35;
      gl_FragColor = vec4(mix(colour, vec3(1.0), flash * 0.3), min(cover, 1.0));
    }
    #endif`,
};

/** Nodes as balls that face the eye, for bodies without a skin. */
export const nodes = {
  vertex: /* glsl */ `
    attribute vec3 shift;
    attribute float value;
    uniform float scale, full, size, height;
    uniform int by;
    varying float v;
    void main() {
      vec4 q = modelViewMatrix * vec4(position + shift * scale, 1.0);
      v = (by == 0 ? length(shift) * scale : value) / full;
      gl_Position = projectionMatrix * q;
      gl_PointSize = max(size * projectionMatrix[1][1] * height / gl_Position.w, 3.0);
    }`,
  fragment: /* glsl */ `
    ${light}${ramp}
    uniform vec3 plain;
    uniform int by;
    uniform float opacity, flash;
    varying float v;
    void main() {
      vec2 c = vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
      float r = dot(c, c);
      if (r > 1.0) discard;
      vec3 colour = by == 2 ? plain : ramp(v);
      gl_FragColor = vec4(mix(lit(colour, vec3(c, sqrt(1.0 - r)), vec3(0, 0, 1), 0.25), vec3(1.0), flash * 0.5), opacity);
    }`,
};

/** Edges between nodes. */
export const edges = {
  vertex: nodes.vertex.replace(/gl_PointSize.*\n/, "\n"),
  fragment: /* glsl */ `
    ${ramp}
    uniform vec3 plain;
    uniform int by;
    uniform float opacity;
    varying float v;
    void main() { gl_FragColor = vec4((by == 2 ? plain : ramp(v)) * 0.85, opacity); }`,
};

/** Proxies, arrows and ropes. */
export const prop = {
  vertex: /* glsl */ `
    ${light}
    uniform vec3 colour;
    #ifdef LEAN
    varying vec3 shown;
    #else
    varying vec3 n, p;
    #endif
    void main() {
      vec4 q = modelViewMatrix * vec4(position, 1.0);
      #ifdef LEAN
      shown = lit(colour, normalize(normalMatrix * normal), normalize(-q.xyz), 0.35);
      #else
      n = normalMatrix * normal;
      p = q.xyz;
      #endif
      gl_Position = projectionMatrix * q;
    }`,
  fragment: /* glsl */ `
    uniform float opacity;
    #ifdef LEAN
    varying vec3 shown;
    void main() { gl_FragColor = vec4(shown, opacity); }
    #else
    ${light}
    uniform vec3 colour;
    varying vec3 n, p;
    void main() { gl_FragColor = vec4(lit(colour, normalize(n), normalize(-p), 0.35), opacity); }
    #endif`,
};

/** What lies over the ground, seen from below: near is dark. */
export const shade = {
  vertex: /* glsl */ `
    attribute vec3 shift;
    uniform float scale, ground, reach;
    varying float height;
    void main() {
      vec4 q = modelMatrix * vec4(position + shift * scale, 1.0);
      height = (q.z - ground) / reach;
      gl_Position = projectionMatrix * viewMatrix * q;
    }`,
  fragment: /* glsl */ `
    varying float height;
    void main() { gl_FragColor = vec4(1.0, clamp(height, 0.0, 1.0), 0.0, 1.0); }`,
};

/** Fading lines, on a plate where there is a floor, with the object's soft shadow between them. */
export const ground = {
  vertex: /* glsl */ `
    varying vec2 at;
    void main() {
      vec4 q = modelMatrix * vec4(position, 1.0);
      at = q.xy;
      gl_Position = projectionMatrix * viewMatrix * q;
    }`,
  fragment: /* glsl */ `
    uniform sampler2D shadow;
    uniform vec2 centre;
    uniform vec3 line, dark;
    uniform float reach, pitch, strength, opacity, plate;
    varying vec2 at;
    float lines(vec2 q) {
      vec2 width = max(fwidth(q), 1e-6);
      vec2 l = clamp(1.15 - abs(fract(q - 0.5) - 0.5) / width, 0.0, 1.0) * clamp(0.5 / width - 1.0, 0.0, 1.0);
      return max(l.x, l.y);
    }
    void main() {
      vec2 d = (at - centre) / reach;
      float away = length(d), cover = 0.0, fade = smoothstep(2.1, 0.3, away);
      vec2 q = (at - centre) / pitch;
      if (away > 2.1) discard;
      #ifdef LEAN
      if (away < 1.1) {
        vec4 seen = textureLod(shadow, vec2(0.5 + 0.5 * d.x, 0.5 - 0.5 * d.y), 2.5);
        if (seen.r > 0.003) cover = strength * seen.r * (1.0 - 0.75 * min(seen.g / seen.r, 1.0));
      }
      #else
      if (away < 1.3) {
        vec2 uv = vec2(0.5 + 0.5 * d.x, 0.5 - 0.5 * d.y);
        vec4 far = textureLod(shadow, uv, 4.6);
        if (far.r > 0.003) {
          float h = far.g / far.r;
          float soft = mix(mix(textureLod(shadow, uv, 2.5).r, textureLod(shadow, uv, 3.5).r, smoothstep(0.0, 0.2, h)), far.r, smoothstep(0.15, 0.6, h));
          cover = strength * soft * (1.0 - 0.75 * smoothstep(0.0, 1.0, h));
        }
      }
      #endif
      float grid = max(opacity * max(lines(q), 0.55 * lines(q * 5.0)), plate) * fade;
      float all = cover + grid * (1.0 - cover);
      gl_FragColor = vec4(mix(line, dark, cover / max(all, 1e-4)), all);
    }`,
};
