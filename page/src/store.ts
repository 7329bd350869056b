// What the page knows, in one place; whoever shows something listens here.
import type { Theme } from "./colours";
import { History } from "./history";
import type { Frame, Scene, State } from "./protocol";

/** silent: it is there, and says nothing. */
export type ConnectionState = "connecting" | "open" | "silent" | "lost" | "refused";
export type Kind = "scene" | "state" | "frame" | "connection" | "settings" | "slot";

export type Tool = "grab" | "ball" | "blade";

export interface Settings {
  /** All copies in one place, or next to each other. */
  layout: "overlay" | "side";
  /** "auto": bodies by their own colours where there are several, else by displacement. */
  colour: "auto" | "displacement" | "stress" | "plain";
  theme: Theme;
  tool: Tool;
  /** Whether the others' copies are shown over one's own. */
  ghosts: boolean;
}

const DEFAULTS: Settings = { layout: "overlay", colour: "auto", theme: "auto", tool: "grab", ghosts: true };
const KEY = "cotouch.settings";
const STALE = 3; // s after which the session's process is taken to hang

function saved(): Settings {
  try {
    return { ...DEFAULTS, ...JSON.parse(localStorage.getItem(KEY) ?? "{}") };
  } catch {
    return { ...DEFAULTS };
  }
}

export class Store {
  scene: Scene | null = null;
  state: State | null = null;
  frame: Frame | null = null;
  /** Frames so far. */
  came = 0;
  connection: ConnectionState = "connecting";
  /** Why the connection was refused, in the server's words. */
  refusal = "";
  /** The user that this page acts for, from 0. */
  slot = 0;
  readonly history = new History();
  settings: Settings = saved();
  private readonly listeners = new Map<Kind, Set<() => void>>();
  /** The slot that the address or the user asked for; null: whichever there is. */
  wished: number | null;

  /** @param wished the slot that the address asks for, if any */
  constructor(wished: number | null = null) {
    this.wished = wished;
    if (wished !== null) this.slot = wished;
  }

  /** What colours show. */
  get colour(): "displacement" | "stress" | "plain" {
    const { colour } = this.settings;
    return colour !== "auto" ? colour : this.scene?.parts.length ? "plain" : "displacement";
  }

  /** Whether the server answers, and the session's process behind it does not. */
  get stalled(): boolean {
    return this.connection === "open" && !this.state?.ended && (this.state?.age ?? 0) > STALE;
  }

  /** What the pointer can do: a blade only where something can be cut. */
  get tools(): Tool[] {
    return this.scene?.cutting ? ["grab", "ball", "blade"] : ["grab", "ball"];
  }

  /** What it does. */
  get tool(): Tool {
    return this.tools.includes(this.settings.tool) ? this.settings.tool : "grab";
  }

  /** The user whom whoever looks at this page is; null: who only watches is nobody. */
  get me(): number | null {
    return this.scene?.acts && this.scene.own.includes(this.slot) ? this.slot : null;
  }

  /** Whether what is shown is how things are, and can be changed. */
  get live(): boolean {
    return this.connection === "open" && !this.state?.ended && !this.stalled;
  }

  /** Calls back after every change of a kind; returns what ends that. */
  on(kind: Kind, f: () => void): () => void {
    const all = this.listeners.get(kind) ?? new Set();
    this.listeners.set(kind, all.add(f));
    return () => all.delete(f);
  }

  emit(kind: Kind): void {
    for (const f of [...(this.listeners.get(kind) ?? [])]) f();
  }

  set(changes: Partial<Settings>): void {
    this.settings = { ...this.settings, ...changes };
    try {
      localStorage.setItem(KEY, JSON.stringify(this.settings));
    } catch {
      // A page without storage forgets; that is all.
    }
    this.emit("settings");
  }

  /** Acts for another user from now on. */
  take(slot: number): void {
    if (slot === this.slot) return;
    this.slot = this.wished = slot;
    this.emit("slot");
  }

  /** A scene arrived: of another run of the server everything begins anew. */
  show(scene: Scene): void {
    if (this.scene?.started !== scene.started) {
      this.state = this.frame = null;
      this.history.clear();
    }
    this.scene = scene;
    const known = scene.users.map((user) => user.slot);
    const wanted = this.wished !== null && known.includes(this.wished) ? this.wished : (scene.own[0] ?? known[0] ?? 0);
    const moved = wanted !== this.slot;
    this.slot = wanted;
    this.emit("scene");
    if (moved) this.emit("slot");
  }

  told(state: State): void {
    this.state = state;
    this.emit("state");
  }

  drawn(frame: Frame): void {
    this.frame = frame;
    this.came++;
    this.history.add(frame);
    this.emit("frame");
  }

  connected(state: ConnectionState, refusal = ""): void {
    if (state === this.connection && refusal === this.refusal) return;
    this.connection = state;
    this.refusal = refusal;
    this.emit("connection");
  }
}
