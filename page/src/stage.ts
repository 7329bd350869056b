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
  pulse(slot: number): void;
  /** The drawn point that a place of the window is nearest to, and where in the session it is [m]; null: nowhere. */
  aim(x: number, y: number): { point: number; to: Vec } | null;
  spot(point?: number): { x: number; y: number; point: number } | null;
  /** What tests measure; of no use to the page. */
  probe?(): object;
  dispose(): void;
}

const SORRY = "The picture needs WebGL 2, which this browser does not provide; everything else works.";

export interface Stage extends View {
  /** Where a drawn point of one's own copy is, or one that can be seen if none is named [pixels of the window]; null while unknown. */
  spot(point?: number): { x: number; y: number; point: number } | null;
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
    probe: () => view?.probe?.() ?? {},
    spot: (point) => {
      const found = view?.spot(point);
      const box = element.getBoundingClientRect();
      return found ? { ...found, x: found.x + box.left, y: found.y + box.top } : null;
    },
    pulse: (slot) => view?.pulse(slot),
    aim: (x, y) => view?.aim(x, y) ?? null,
    dispose: () => {
      off();
      view?.dispose();
    },
  };
}
