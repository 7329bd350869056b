// Where one looks from: orbit, zoom and pan by mouse, pen and fingers. Matrices are in columns, as WebGL takes them.

/** @typedef {[number, number, number]} Vec */

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b @returns {Vec} */
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

const FIELD = (28 * Math.PI) / 180; // of view, over the shorter side

class Camera {
  /** @param {Vec} centre @param {number[]} cloud places that are to be seen, behind each other [m] @param {number} pitch to start with */
  constructor(centre, cloud, pitch) {
    this.target = centre;
    this.distance = 0;
    this.yaw = pitch > 1.5 ? -Math.PI / 2 : -1.05;
    this.pitch = pitch;
    this.cloud = cloud;
    this.radius = 0; // of a ball around the target with all of the cloud in it
    const [x, y] = this.axes(), sides = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i < cloud.length; i += 3) {
      const q = centre.map((c, d) => cloud[i + d] - c);
      [x, y].forEach((axis, k) => {
        sides[2 * k] = Math.min(sides[2 * k], dot(axis, q));
        sides[2 * k + 1] = Math.max(sides[2 * k + 1], dot(axis, q));
      });
      this.radius = Math.max(this.radius, Math.hypot(...q));
    }
    this.target = /** @type {Vec} */ (centre.map((c, d) => c + (x[d] * (sides[0] + sides[1]) + y[d] * (sides[2] + sides[3])) / 2));
    this.home = { target: this.target, distance: 0, yaw: this.yaw, pitch };
  }

  /** Stands where the whole cloud is seen at first in a picture of this size; the zoom stays. @param {number} width @param {number} height */
  frame(width, height) {
    const here = { yaw: this.yaw, pitch: this.pitch }, half = Math.tan(FIELD / 2) / Math.min(width, height);
    Object.assign(this, { yaw: this.home.yaw, pitch: this.home.pitch });
    const [x, y, z] = this.axes();
    let distance = 0.7 * this.radius;
    for (let i = 0; i < this.cloud.length; i += 3) {
      const q = this.home.target.map((c, d) => this.cloud[i + d] - c);
      distance = Math.max(distance, 1.08 * Math.max(Math.abs(dot(x, q)) / (half * width), Math.abs(dot(y, q)) / (half * height)) + dot(z, q));
    }
    this.distance = (distance * (this.distance || 1)) / (this.home.distance || 1);
    if (!this.home.distance) this.distance = distance;
    this.home.distance = distance;
    Object.assign(this, here);
  }

  reset() {
    Object.assign(this, this.home);
  }

  /** Right, up and back, as rows. @returns {[Vec, Vec, Vec]} */
  axes() {
    const [cy, sy, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
    return [[-sy, cy, 0], [-sp * cy, -sp * sy, cp], [cp * cy, cp * sy, sp]];
  }

  view() {
    const [x, y, z] = this.axes();
    const eye = this.target.map((t, d) => t + this.distance * z[d]);
    return new Float32Array([x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1]);
  }

  /** @param {number} width @param {number} height */
  projection(width, height) {
    const focal = 1 / Math.tan(FIELD / 2), shorter = Math.min(width, height);
    const near = Math.max(this.distance - 12 * this.radius, this.distance / 100), far = this.distance + 12 * this.radius;
    return new Float32Array([
      (focal * shorter) / width, 0, 0, 0, 0, (focal * shorter) / height, 0, 0,
      0, 0, (far + near) / (near - far), -1, 0, 0, (2 * far * near) / (near - far), 0,
    ]);
  }

  /** Metres of a pixel at the target. @param {number} width @param {number} height */
  pixel(width, height) {
    return (2 * this.distance * Math.tan(FIELD / 2)) / Math.min(width, height);
  }

  /** Where a point is seen, in pixels from the left and top. @param {ArrayLike<number>} p @param {number} width @param {number} height @returns {[number, number]} */
  seen(p, width, height) {
    const [x, y, z] = this.axes(), q = [0, 1, 2].map((d) => p[d] - this.target[d]);
    const scale = this.distance / (this.pixel(width, height) * Math.max(this.distance - dot(z, q), 1e-9));
    return [width / 2 + scale * dot(x, q), height / 2 - scale * dot(y, q)];
  }

  /** @param {number} dx pixels @param {number} dy */
  orbit(dx, dy) {
    this.yaw -= 0.008 * dx;
    this.pitch = Math.max(-1.5707, Math.min(1.5707, this.pitch + 0.008 * dy));
  }

  /** @param {number} dx pixels @param {number} dy @param {number} pixel metres of one */
  pan(dx, dy, pixel) {
    const [x, y] = this.axes();
    this.target = /** @type {Vec} */ (this.target.map((t, d) => t + pixel * (dy * y[d] - dx * x[d])));
  }

  /** @param {number} factor above 1 goes away */
  zoom(factor) {
    this.distance = Math.max(0.1, Math.min(8, (this.distance * factor) / this.home.distance)) * this.home.distance;
  }

  /** @param {HTMLElement} element @param {() => number} pixel metres of a pixel @param {() => void} moved */
  follow(element, pixel, moved) {
    /** @type {Map<number, {x: number, y: number}>} */
    const down = new Map();
    element.addEventListener("pointerdown", (event) => {
      element.setPointerCapture(event.pointerId);
      down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    element.addEventListener("pointermove", (event) => {
      const last = down.get(event.pointerId);
      if (!last) return;
      const dx = event.clientX - last.x, dy = event.clientY - last.y;
      const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
      if (other) {
        const before = Math.hypot(last.x - other.x, last.y - other.y);
        this.zoom(before / Math.max(Math.hypot(event.clientX - other.x, event.clientY - other.y), 1));
        this.pan(dx / 2, dy / 2, pixel());
      } else if (event.shiftKey || event.buttons & 6) this.pan(dx, dy, pixel());
      else this.orbit(dx, dy);
      down.set(event.pointerId, { x: event.clientX, y: event.clientY });
      moved();
    });
    for (const name of ["pointerup", "pointercancel"])
      element.addEventListener(name, (event) => down.delete(/** @type {PointerEvent} */ (event).pointerId));
    element.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * (event.deltaMode ? 0.04 : 0.0012)));
      moved();
    }, { passive: false });
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("dblclick", () => {
      this.reset();
      moved();
    });
  }
}
