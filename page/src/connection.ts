// One WebSocket that comes back by itself; whatever arrives goes into the store.
import { type Action, readFrame, readScene, type State, type Vec, writeAck, writeHello, writePointer } from "./protocol";
import { Screen } from "./screen";
import type { Store } from "./store";

const SOONEST = 250; // ms until it dials again; doubles up to
const LATEST = 2000;
const PATIENCE = 10_000; // ms for an answer
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
}

function same(a: Pointing, b: Pointing): boolean {
  return a.action === b.action && a.point === b.point && a.radius === b.radius && a.stiffness === b.stiffness && a.target.every((x, k) => x === b.target[k]);
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
  private said: number | null = null;

  constructor(
    private readonly store: Store,
    private token: string | null,
    private readonly address: string,
  ) {
    store.on("seat", () => this.hello());
    document.addEventListener("visibilitychange", () => this.hello());
    addEventListener("online", () => this.hurry());
    this.dial();
  }

  /** Whether this page has what it needs to change anything. */
  get mayAct(): boolean {
    const { connection, state, scene, seat } = this.store;
    return connection === "open" && this.hasToken && state?.control !== "other" && !!scene?.own.includes(seat);
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
  link(path: string): string {
    return `${path}?token=${encodeURIComponent(this.token ?? "")}`;
  }

  /** Asks for something; the answer is a sentence. Never rejects. */
  do(what: string, args: object = {}): Promise<Told> {
    const socket = this.socket;
    if (!socket || socket.readyState !== WebSocket.OPEN) return Promise.resolve({ ok: false, text: "There is no connection to the server." });
    const id = ++this.asked;
    return new Promise((resolve) => {
      const late = setTimeout(() => this.answer(id, { ok: false, text: "The server did not answer." }), PATIENCE);
      this.answers.set(id, (told) => {
        clearTimeout(late);
        resolve(told);
      });
      socket.send(JSON.stringify({ ...args, type: "do", id, what }));
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
    this.socket.send(writePointer({ ...p, seat: this.store.seat, number, time }));
    this.onPoint?.(number, time);
  }

  private dial(): void {
    clearTimeout(this.timer);
    if (this.closed) return;
    const socket = new WebSocket(this.address);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    let refusal = "";
    socket.onopen = () => {
      this.told = null;
      this.hello();
    };
    socket.onmessage = ({ data }) => {
      if (data instanceof ArrayBuffer) {
        const frame = readFrame(data, performance.now());
        socket.send(writeAck(frame.number, ...this.screen.came(frame.received)));
        requestAnimationFrame((time) => this.screen.picture(time));
        if (this.store.scene && frame.points * 3 === this.store.scene.points.length) this.store.drawn(frame);
        return;
      }
      const message = JSON.parse(data);
      if (message.type === "scene") {
        this.wait = SOONEST;
        this.store.connected("open");
        this.state = null; // of an earlier run, perhaps
        this.store.show(readScene(message));
        if (this.said !== this.store.seat) this.hello(); // the first hello didn't know whom to act for
      } else if (message.type === "state") this.tell(message as State);
      else if (message.type === "told") this.answer(message.id, message as Told);
      else if (message.type === "error") refusal = String(message.text);
    };
    socket.onclose = () => {
      if (this.socket !== socket) return;
      this.socket = null;
      for (const id of [...this.answers.keys()]) this.answer(id, { ok: false, text: "The connection was lost before an answer came." });
      if (refusal) this.store.connected("refused", refusal);
      else if (this.store.connection !== "refused") this.store.connected(this.store.scene ? "lost" : "connecting");
      if (this.closed) return;
      this.timer = setTimeout(() => this.dial(), refusal ? LATEST : this.wait);
      this.wait = Math.min(2 * this.wait, LATEST);
    };
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
    this.said = this.store.scene || this.store.wished !== null ? this.store.seat : null;
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
