// Stands in for the page's instruments until they are there: the picture fills the window.
import "./style.css";
import type { Connection } from "./connection";
import type { Store } from "./store";

export function mountShell(root: HTMLElement, _store: Store, _connection: Connection): { stageElement: HTMLElement } {
  const stageElement = document.createElement("div");
  stageElement.id = "stage";
  root.append(stageElement);
  return { stageElement };
}
