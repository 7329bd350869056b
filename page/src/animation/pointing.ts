// Turns, moves and zooms by mouse, pen and fingers, for whoever only watches.
import type { Orbit } from "../space/orbit";

/** @param height of the picture that is turned [pixels] @param moved is called after every change */
export function follow(element: HTMLElement, orbit: Orbit, height: () => number, moved: () => void): void {
  const down = new Map<number, { x: number; y: number }>();
  const changed = () => {
    orbit.step(1);
    moved();
  };
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
      orbit.zoom(before / Math.max(Math.hypot(event.clientX - other.x, event.clientY - other.y), 1));
      orbit.pan(dx / 2, dy / 2, height());
    } else if (event.shiftKey || event.buttons & 6) orbit.pan(dx, dy, height());
    else orbit.turn(dx, dy);
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    changed();
  });
  for (const name of ["pointerup", "pointercancel"] as const) element.addEventListener(name, (event) => down.delete(event.pointerId));
  element.addEventListener("wheel", (event) => {
    event.preventDefault();
    orbit.zoom(Math.exp(event.deltaY * (event.deltaMode ? 0.04 : 0.0012)));
    changed();
  }, { passive: false });
  element.addEventListener("contextmenu", (event) => event.preventDefault());
  element.addEventListener("dblclick", () => {
    orbit.reset();
    changed();
  });
}
