// Programs of the graphics card. "#part" begins a piece, "#use" puts one in.

#part head
#version 300 es
precision highp float;
precision highp int;

#part light
uniform vec3 stops[6]; // colours from rest to the most
vec3 linear(vec3 c) { return pow(c, vec3(2.2)); }
vec3 lit(vec3 color, vec3 n, vec3 eye, float gloss) {
  vec3 key = normalize(vec3(-0.35, 0.75, 0.6)), fill = normalize(vec3(0.8, -0.1, 0.5));
  float sky = 0.5 + 0.5 * n.y;
  vec3 light = mix(vec3(0.26, 0.25, 0.29), vec3(0.5, 0.52, 0.55), sky) + 0.62 * max(dot(n, key), 0.0) * vec3(1.0, 0.98, 0.94)
    + 0.13 * max(dot(n, fill), 0.0);
  float shine = pow(max(dot(n, normalize(key + eye)), 0.0), 48.0) * gloss;
  float rim = pow(1.0 - max(dot(n, eye), 0.0), 3.0);
  return pow(linear(color) * light * (1.0 - 0.28 * rim) + shine, vec3(1.0 / 2.2));
}
vec3 ramp(float value) {
  float at = clamp(value, 0.0, 1.0) * float(stops.length() - 1);
  int low = min(int(at), stops.length() - 2);
  return mix(stops[low], stops[low + 1], at - float(low));
}

// Nodes and edges read places (and the value, fourth) from a texture of 1024 texels in a row.
#part fetch
uniform sampler2D places;
vec4 node(int i) { return texelFetch(places, ivec2(i & 1023, i >> 10), 0); }

// A copy's surface: coloured by a value, or a ghost that shows its rim in a user's colour.
#part surface vertex
#use head
layout(location=0) in vec3 place; layout(location=1) in vec3 normal; layout(location=2) in float value;
uniform mat4 view, projection;
out vec3 n, p; out float v;
void main() { vec4 q = view * vec4(place, 1.0); n = mat3(view) * normal; p = q.xyz; v = value; gl_Position = projection * q; }

#part surface fragment
#use head
#use light
in vec3 n, p; in float v;
uniform vec3 color; uniform float ghost;
out vec4 result;
void main() {
  vec3 eye = normalize(-p), m = normalize(n);
  if (!gl_FrontFacing) m = -m;
  float rim = 1.0 - clamp(dot(m, eye), 0.0, 1.0);
  // Seen only where it is away from the solid copy: what agrees needs no ghost.
  if (ghost > 0.0) result = vec4(color, ghost * smoothstep(0.05, 1.0, v) * (0.1 + 0.9 * pow(rim, 1.6)));
  else result = vec4(lit(ramp(v), m, eye, 0.16), 1.0);
}

// Nodes, as balls that face the eye.
#part points vertex
#use head
#use fetch
uniform mat4 view, projection; uniform float radius, height, ghost;
out float v;
void main() {
  vec4 q = node(gl_VertexID);
  v = q.w; gl_Position = projection * view * vec4(q.xyz, 1.0);
  gl_PointSize = max(radius * (ghost > 0.0 ? 0.8 : 1.0) * projection[1][1] * height / gl_Position.w, 2.0);
}

#part points fragment
#use head
#use light
in float v;
uniform vec3 color; uniform float ghost;
out vec4 result;
void main() {
  vec2 c = vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
  float r = dot(c, c);
  if (r > 1.0) discard;
  vec3 base = ghost > 0.0 ? color : ramp(v);
  result = vec4(lit(base, vec3(c, sqrt(1.0 - r)), vec3(0, 0, 1), 0.25), ghost > 0.0 ? ghost : 1.0);
}

// Edges, as wide as a pen.
#part edges vertex
#use head
#use fetch
layout(location=0) in uvec2 ends;
uniform mat4 view, projection; uniform vec2 size; uniform float thick;
out float v;
void main() {
  vec4 a = node(int(ends.x)), b = node(int(ends.y));
  vec4 p = projection * view * vec4(a.xyz, 1.0), q = projection * view * vec4(b.xyz, 1.0);
  vec2 way = (q.xy / q.w - p.xy / p.w) * size, side = normalize(vec2(-way.y, way.x) + vec2(1e-6, 0.0));
  bool far = gl_VertexID > 1;
  vec4 at = far ? q : p;
  v = far ? b.w : a.w;
  gl_Position = at + vec4(side * thick * (float(gl_VertexID & 1) - 0.5) * 2.0 / size * at.w, 0.0, 0.0);
}

#part edges fragment
#use head
#use light
in float v;
uniform vec3 color; uniform float ghost;
out vec4 result;
void main() { result = ghost > 0.0 ? vec4(color, ghost) : vec4(ramp(v) * 0.88, 1.0); }

// Balls, rods and cones: a unit shape, scaled, turned and moved.
#part solid vertex
#use head
layout(location=0) in vec3 place; layout(location=1) in vec3 normal;
uniform mat4 view, projection; uniform mat3 turn; uniform vec3 scale, offset;
out vec3 n, p;
void main() {
  vec4 q = view * vec4(turn * (scale * place) + offset, 1.0);
  n = mat3(view) * (turn * (normal / scale)); p = q.xyz; gl_Position = projection * q;
}

#part solid fragment
#use head
#use light
in vec3 n, p;
uniform vec4 color;
out vec4 result;
void main() { result = vec4(lit(color.rgb, normalize(n), normalize(-p), 0.5), color.a); }

// A floor of fading lines, with a soft shade below the object.
#part floor vertex
#use head
uniform mat4 view, projection; uniform vec3 centre; uniform float reach;
out vec2 p;
void main() {
  p = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  gl_Position = projection * view * vec4(centre + vec3(p * reach, 0.0), 1.0);
}

#part floor fragment
#use head
in vec2 p;
uniform vec3 centre, color; uniform vec2 shade; uniform float reach, pitch;
out vec4 result;
void main() {
  vec2 at = (centre.xy + p * reach) / pitch, width = max(fwidth(at), 1e-6);
  vec2 line = clamp(1.1 - abs(fract(at - 0.5) - 0.5) / width, 0.0, 1.0);
  vec2 s = p * reach / shade;
  float fade = smoothstep(1.0, 0.25, length(p)), dark = 0.2 * exp(-1.6 * dot(s, s));
  float grid = 0.55 * max(line.x, line.y) * fade;
  result = vec4(mix(vec3(0.0), color, grid / max(grid + dark, 1e-4)), grid + dark * (1.0 - grid));
}
