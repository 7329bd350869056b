// One WebSocket that comes back by itself; whatever arrives goes into the store.
import type { Command, TakeControl } from "./messages";
import { type Action, readFrame, readScene, type State, type Vec, writeAck, writeHello, writePointer } from "./protocol";
import { Screen } from "./screen";
import type { Store } from "./store";

const SOONEST = 250; // ms until it dials again; doubles up to
const LATEST = 2000;
const PATIENCE = 10_000; // ms for an answer
const LOOK = 500; // ms between two looks whether the server says anything
const SILENT = 3000; // ms without a word after which it is said that there is none: states come every 200 ms
const GIVEN_UP = 8000; // ms after which another connection is tried
const SHAKE = 5000; // ms for a connection to come about
const PERIOD = 8; // ms between pointer messages, at least: 125 Hz
const RATE = 60;
const HALTED = 300; // ms after which no picture is waited for any more
const HIDDEN = 5; // frames per second of a page that nobody sees

export interface Told {
  ok: boolean;
  text: string;
}

export interface Pointing {
  action: Action;
  point: number;
  target: Vec;
  radius: number;
  stiffness: number;
  /** When the event was, as performance.now() [ms]; now if left out. */
  time?: number;
  /** Of the blade; 0: none [m]. */
  edge?: Vec;
}

const NONE: Vec = [0, 0, 0];

function same(a: Pointing, b: Pointing): boolean {
  return a.action === b.action && a.point === b.point && a.radius === b.radius && a.stiffness === b.stiffness && a.target.every((x, k) => x === b.target[k])
    && (a.edge ?? NONE).every((x, k) => x === (b.edge ?? NONE)[k]);
}

export class Connection {
  /** Number of the newest pointer message and when its event was, for measurements. */
  onPoint: ((number: number, time: number) => void) | null = null;
  readonly screen = new Screen();
  private socket: WebSocket | null = null;
  private wait = SOONEST;
  private timer = 0;
  private asked = 0;
  private readonly answers = new Map<number, (told: Told) => void>();
  private number = 0;
  private pending: Pointing | null = null;
  /** How things are, not shown yet. */
  private state: State | null = null;
  /** What was said last on this connection: a browser tells of a movement twice, at once and with its next picture. */
  private told: Pointing | null = null;
  private pointed = -Infinity;
  private pointTimer = 0;
  private closed = false;
  /** Whether the scene came on this connection. */
  private greeted = false;
  private said: number | null = null;
  /** When the server said anything last, or was dialled; as performance.now() [ms]. */
  private heard = 0;
  private looked = performance.now();
  private readonly looking: number;

  constructor(
    private readonly store: Store,
    private token: string | null,
    private readonly address: string,
  ) {
    store.on("slot", () => this.hello());
    document.addEventListener("visibilitychange", () => {
      this.heard = performance.now(); // who was not seen is not judged by what came meanwhile
      this.hello();
    });
    addEventListener("online", () => this.hurry());
    this.looking = window.setInterval(() => this.look(), LOOK);
    this.dial();
  }

  /** Whether this page has what it needs to change anything. */
  get mayAct(): boolean {
    const { live, state, scene, slot } = this.store;
    return live && this.hasToken && state?.control !== "other" && !!scene?.own.includes(slot);
  }

  /** Whether this page came with the token; it is taken to be right until the server says otherwise. */
  get hasToken(): boolean {
    return this.token !== null && this.store.scene?.acts !== false;
  }

  /** Whether it came with one that is not this server's. */
  get tokenWrong(): boolean {
    return this.token !== null && !this.hasToken;
  }

  /** Where something is downloaded from, with the token. */
  link(path: string, more: Record<string, string> = {}): string {
    return `${path}?${new URLSearchParams({ token: this.token ?? "", ...more })}`;
  }

  /** Asks for something; the answer is a sentence. Never rejects. */
  do(command: Command | TakeControl): Promise<Told> {
    const socket = this.socket;
    if (!socket || socket.readyState !== WebSocket.OPEN) return Promise.resolve({ ok: false, text: "There is no connection to the server." });
    const id = ++this.asked;
    return new Promise((resolve) => {
      const late = setTimeout(() => this.answer(id, { ok: false, text: "The server did not respond." }), PATIENCE);
      this.answers.set(id, (told) => {
        clearTimeout(late);
        resolve(told);
      });
      socket.send(JSON.stringify({ ...command, type: "do", id }));
    });
  }

  /** Moves this user's pointer: at most every 8 ms, the newest counts; letting go is never left out. */
  point(pointing: Pointing): void {
    if (this.told && same(this.told, pointing)) return;
    if (this.pending?.action === "free" && pointing.action !== "free") this.flush();
    this.told = pointing;
    this.pending = { ...pointing, time: pointing.time ?? performance.now() };
    const left = this.pointed + PERIOD - performance.now();
    if (left <= 0 || pointing.action === "free") this.flush();
    else if (!this.pointTimer) this.pointTimer = setTimeout(() => this.flush(), left);
  }

  close(): void {
    this.closed = true;
    clearInterval(this.looking);
    clearTimeout(this.timer);
    clearTimeout(this.pointTimer);
    this.socket?.close();
  }

  private flush(): void {
    clearTimeout(this.pointTimer);
    this.pointTimer = 0;
    const p = this.pending;
    this.pending = null;
    if (!p || !this.mayAct || this.socket?.readyState !== WebSocket.OPEN) return;
    this.pointed = performance.now();
    const number = ++this.number;
    const time = p.time!;
    this.socket.send(writePointer({ edge: [0, 0, 0], ...p, slot: this.store.slot, number, time }));
    this.onPoint?.(number, time);
  }

  private dial(): void {
    clearTimeout(this.timer);
    if (this.closed) return;
    const socket = new WebSocket(this.address);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    this.heard = performance.now();
    let refusal = "";
    socket.onopen = () => {
      this.told = null;
      this.hello();
    };
    socket.onmessage = ({ data }) => {
      if (this.socket !== socket) return; // given up
      this.heard = performance.now();
      if (this.store.connection === "silent" && this.greeted) this.store.connected("open");
      if (data instanceof ArrayBuffer) {
        const frame = readFrame(data, performance.now());
        socket.send(writeAck(frame.number, ...this.screen.came(frame.received)));
        requestAnimationFrame((time) => this.screen.picture(time));
        // The last moment of a session stands still.
        if (this.store.state?.ended && this.store.frame) return;
        if (this.store.scene && frame.points * 3 === this.store.scene.points.length) this.store.drawn(frame);
        return;
      }
      const message = JSON.parse(data);
      if (message.type === "scene") {
        this.wait = SOONEST;
        this.greeted = true;
        this.store.connected("open");
        this.state = null; // of an earlier run, perhaps
        this.store.show(readScene(message));
        if (this.said !== this.store.slot) this.hello(); // the first hello didn't know whom to act for
      } else if (message.type === "state") this.tell(message as State);
      else if (message.type === "answer") this.answer(message.id, message as Told);
      else if (message.type === "error") refusal = String(message.text);
    };
    socket.onclose = () => {
      if (this.socket === socket) this.ended(refusal);
    };
  }

  /** The connection is over; another is tried after a while. */
  private ended(refusal: string, silent = false): void {
    this.socket = null;
    this.greeted = false;
    for (const id of [...this.answers.keys()]) this.answer(id, { ok: false, text: "The connection was lost before the server responded." });
    if (refusal) this.store.connected("refused", refusal);
    else if (silent) this.store.connected("silent");
    else if (this.store.connection !== "refused") this.store.connected(this.store.scene ? "lost" : "connecting");
    if (this.closed) return;
    this.timer = window.setTimeout(() => this.dial(), refusal ? LATEST : this.wait);
    this.wait = Math.min(2 * this.wait, LATEST);
  }

  /** Whether the server says anything; a hung one keeps its connections, and takes new ones, without a word. */
  private look(): void {
    const now = performance.now();
    const late = now - this.looked > 3 * LOOK;
    this.looked = now;
    if (late) this.heard = Math.max(this.heard, now - LOOK); // this page stood still, and what came waits to be read
    const { socket } = this;
    if (!socket || document.hidden) return;
    const quiet = now - this.heard;
    if (quiet > (this.greeted ? GIVEN_UP : SHAKE)) {
      this.socket = null;
      socket.close();
      this.ended("", true);
    } else if (this.greeted && quiet > SILENT) this.store.connected("silent");
  }

  /** How things are can wait until the next picture is drawn, which could not wait for all that it changes. */
  private tell(state: State): void {
    const waits = this.state !== null;
    this.state = state;
    if (waits) return;
    const now = () => {
      clearTimeout(latest);
      const told = this.state;
      this.state = null;
      if (told) this.store.told(told);
    };
    const latest = setTimeout(now, HALTED); // no picture is drawn in a window that nobody sees
    if (this.store.state) requestAnimationFrame(() => setTimeout(now));
    else now();
  }

  private hello(): void {
    if (this.socket?.readyState !== WebSocket.OPEN) return;
    this.said = this.store.scene || this.store.wished !== null ? this.store.slot : null;
    this.socket.send(writeHello(this.token, this.said, document.hidden ? HIDDEN : RATE));
  }

  private hurry(): void {
    if (this.socket) return;
    this.wait = SOONEST;
    this.dial();
  }

  private answer(id: number, told: Told): void {
    this.answers.get(id)?.(told);
    this.answers.delete(id);
  }
}
