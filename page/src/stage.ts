// The picture: rails for a body in one dimension, else the object in space; made anew for every run of the server.
import "./stage.css";
import { mountRails } from "./rails/rails";
import { mountSpace } from "./space/space";
import type { Connection } from "./connection";
import type { Vec } from "./protocol";
import type { Stats } from "./stats";
import type { Store } from "./store";

/** What shows a scene in an element. */
export interface View {
  /** Looks from where it looked at first. */
  reset(): void;
  /** Makes a user's copy stand out for a moment. */
  pulse(seat: number): void;
  knob?(): { x: number; y: number } | null;
  /** The drawn point that a place of the window is nearest to, and where in the session it is [m]; null: nowhere. */
  aim(x: number, y: number): { point: number; to: Vec } | null;
  dispose(): void;
}

const SORRY = "The picture needs WebGL 2, which this browser does not give; everything beside it works.";

export interface Stage extends View {
  /** Where a user's slider is in the picture of rails [pixels]; null in space. */
  knob(): { x: number; y: number } | null;
}

export function mountStage(element: HTMLElement, store: Store, connection: Connection, stats: Stats): Stage {
  let view: View | null = null;
  let shown = "";
  const show = () => {
    const scene = store.scene;
    if (!scene || scene.started === shown) return;
    shown = scene.started;
    view?.dispose();
    view = null;
    element.classList.add("ct-stage");
    try {
      view = (scene.dimension === 1 ? mountRails : mountSpace)(element, scene, store, connection, stats);
    } catch (error) {
      element.replaceChildren(Object.assign(document.createElement("p"), { className: "ct-sorry", textContent: SORRY }));
      console.warn(error);
    }
  };
  const off = store.on("scene", show);
  show();
  return {
    reset: () => view?.reset(),
    knob: () => view?.knob?.() ?? null,
    pulse: (seat) => view?.pulse(seat),
    aim: (x, y) => view?.aim(x, y) ?? null,
    dispose: () => {
      off();
      view?.dispose();
    },
  };
}
