// The picture: rails for a body in one dimension, else the object in space; made anew for every run of the server.
import "./stage.css";
import type { Connection } from "./connection";
import type { Stats } from "./stats";
import type { Store } from "./store";

/** What shows a scene in an element. */
export interface View {
  /** Looks from where it looked at first. */
  reset(): void;
  /** Makes a user's copy stand out for a moment. */
  pulse(seat: number): void;
  dispose(): void;
}

export interface Stage extends View {}

export function mountStage(element: HTMLElement, store: Store, connection: Connection, stats: Stats): Stage {
  let view: View | null = null;
  let shown = "";
  const show = () => {
    const scene = store.scene;
    if (!scene || scene.started === shown) return;
    shown = scene.started;
    view?.dispose();
    view = null;
    void connection, stats;
    element.textContent = `${scene.title}: ${scene.points.length / 3} points`;
  };
  const off = store.on("scene", show);
  show();
  return {
    reset: () => view?.reset(),
    pulse: (seat) => view?.pulse(seat),
    dispose: () => {
      off();
      view?.dispose();
    },
  };
}
