import type { Connection } from "../connection";
import type { Scene } from "../protocol";
import type { View } from "../stage";
import type { Stats } from "../stats";
import type { Store } from "../store";
export function mountRails(_e: HTMLElement, _s: Scene, _st: Store, _c: Connection, _t: Stats): View { return { reset() {}, pulse() {}, dispose() {} }; }
