// What the page and the server say to each other: JSON as text, frames and pointers as little-endian binary.

import { type Doable, HAND_MODES, type HandMode, type Hello } from "./messages";

export type Vec = [number, number, number];

export interface User {
  slot: number;
  name: string;
}

/** What stands still around the object; lengths in m. */
export type Obstacle =
  | { kind: "plane"; point: Vec; normal: Vec }
  /** `turn`: along the axis of turning, as long as the angle [rad]. */
  | { kind: "box"; size: Vec; centre: Vec; turn: Vec }
  /** A box with a round hole along its third side: its radius, where its axis is along the others, and what its rims lack. */
  | { kind: "plate"; size: Vec; hole: [number, number, number, number]; centre: Vec; turn: Vec }
  /** What a closed surface encloses: places and corners, three numbers each. */
  | { kind: "solid"; vertices: number[]; triangles: number[] };

/** One of several bodies: how many of the skin's vertices are its own, and its colour as #rrggbb. */
export interface Part {
  name: string;
  vertices: number;
  colour: string | null;
  /** Whether the session's texture is not on it: it is a tool. */
  bare?: boolean;
  /** Of a tool that can be led: whose it is, which of that user's, and where its handle is at rest [m]. */
  tool?: { slot: number; number: number; handle: Vec };
}

/** Heights on the skin at rest: one tile of a map that repeats, laid on it as contact lays it. */
export interface Texture {
  /** Of the middles of its parts, rows along the second side, from 0 to 65535 for `top`. */
  heights: Uint16Array;
  rows: number;
  columns: number;
  /** Lengths of its two sides [m]. */
  size: [number, number];
  /** [m] */
  top: number;
  /** By which it is turned in its plane [rad]. */
  angle: number;
  /** Axis that it is laid on along, or "triplanar": that which the skin looks to. */
  projection: "x" | "y" | "z" | "triplanar";
}

/** What a server run shows; does not change while it runs. Lengths in m. */
export interface Scene {
  title: string;
  version: string;
  dimension: 1 | 2 | 3;
  users: User[];
  /** Slots whose hands this server can move. */
  own: number[];
  /** What `Connection.do` may ask for here. */
  may: Doable[];
  /** Whether this page's token is right. */
  acts: boolean;
  invitation: string | null;
  /** Where other devices find this page, without the token; null: only this computer can. */
  page: string | null;
  nodes: { count: number; rest: Float32Array };
  skin: { vertices: number; rest: Float32Array; triangles: Uint32Array; node: Uint32Array } | null;
  /** Elements that can be cut, and what hangs on them: a triangle is there while all elements that carry it
   * (`element` from `pointer[t]` to `pointer[t + 1]`) are whole, and the one beyond it, if any, is cut; null: none can. */
  cutting: { elements: number; pointer: Uint32Array; element: Uint32Array; beyond: Int32Array } | null;
  /** Pairs of nodes, for bodies without a skin. */
  edges: Uint32Array | null;
  obstacles: Obstacle[];
  /** Several bodies, in the order of their vertices; empty: there is one. */
  parts: Part[];
  /** What lies on the skin of all that are not bare; null: nothing that can be seen. */
  texture: Texture | null;
  radius: number;
  centre: Vec;
  /** Usual stiffness of a hand [N/m]. */
  stiffness: number;
  /** Which run of the server this is. */
  started: string;
  /** Places at rest of what is drawn, (V*3): the skin's vertices, or the nodes. */
  points: Float32Array;
}

export interface LinkStatus {
  slot: number;
  state: string;
  path_state: string;
  age: number | null;
  age_sum: number | null;
  budget: number | null;
  round_trip: number | null;
  loss: number;
  rate: number;
  datagram_rate: number;
  byte_rate: number;
  saved: number;
  force: number;
  work: number;
  difference: number | null;
  guarded: number;
}

export interface MemberStatus {
  slot: number;
  epoch: number;
  time: number;
  steps: number;
  rate: number;
  nominal_period: number;
  longest_period: number;
  missed: number;
  stood: number;
  busy: number;
  force: number;
  position: number[];
  supplied: number;
  lost: number;
  linked: number;
  rescaled: number;
  energy: number;
  initial: number;
  residual: number;
  damping: number;
  damping_margin: number | null;
  links: LinkStatus[];
  /** The copy is farther away than samples can tell, so none are sent. */
  unsent: boolean;
  /** Slot of another, linked or not, and the quickest way there and back [s]. */
  round_trips: [number, number][];
  alarms: number;
  /** Of bodies that turn or bend far: the most that balancing a step changed a velocity by, as a share. */
  closure_factor: number;
  /** Of its whole part, into a file of its own. */
  recording: "off" | "on" | "failed";
  recording_failure: string;
  here: boolean;
  alive: boolean | null;
  /** null: led on another computer. */
  hand: HandMode | null;
  /** Lost with the elements that were cut, part of `lost` [J]. */
  cut_energy: number;
  /** How many elements are cut. */
  cuts: number;
  /** Tells one set of them from another. */
  cut_set: string;
  /** Which, a bit for each; null: not known here. */
  cut: string | null;
  /** How many of them each user decided, by number from 1. */
  cut_by: number[];
}

export interface Emulated {
  delay: number;
  jitter: number;
  loss: number;
  cut: boolean;
}

/** Which law the links have, and what is felt of it. */
export interface LawState {
  law: string;
  /** Given by ends, and not taken by the others yet; null: the law exchanges none [J]. */
  on_the_way: number | null;
  /** Drag of the last seconds; null: the copies hardly moved [N·s/m]. */
  measured: number | null;
  /** Drag of copies that move evenly together; null: nobody can say [N·s/m]. */
  predicted: number | null;
  /** Least drag that people notice [N·s/m]. */
  noticed: number;
}

/** A recording that was asked for by a page. */
export interface Taping {
  state: "off" | "on" | "ending" | "done" | "failed";
  /** Of the order, from 1. */
  number: number;
  seconds: number;
  /** What came of it. */
  text: string;
  /** Name and bytes. */
  files: [string, number][];
  /** What is wrong with it, at once. */
  troubles: string[];
}

/** How things are; five times a second. Members may be told only in part before they said anything. */
export interface State {
  time: number;
  /** Since the session's process looked [s]. */
  age: number;
  members: Record<string, Partial<MemberStatus> & { here: boolean; alive: boolean | null; hand: HandMode | null }>;
  links: [number, number][];
  /** "a-b": what a knows of its link to b. */
  ends: Record<string, LinkStatus>;
  /** "a-b": what is done to samples that a receives from b. */
  emulated: Record<string, Emulated>;
  choices: Record<string, [number, number][]>;
  damping: number;
  recording: Taping;
  events: { time: number; text: string }[];
  /** What is felt of the links' law; null before anybody moves. */
  law: LawState | null;
  verdict: { level: "good" | "warn" | "bad"; text: string };
  control: "mine" | "other" | "none";
  pages: number;
  ended: boolean;
}

/** One copy in a frame. */
export interface Copy {
  slot: number;
  mode: HandMode;
  /** Told by its own process; else what a neighbour knows of it. */
  direct: boolean;
  hasHand: boolean;
  hands: number;
  /** Of the copy at the frame's time [s]. */
  age: number;
  target: Vec;
  place: Vec;
  /** Of the hand on the object [N]. */
  force: Vec;
  /** Of the ball; 0: none [m]. */
  radius: number;
  /** [J] */
  energy: number;
  supplied: number;
  lost: number;
  linked: number;
  /** Held; -1: none. */
  node: number;
  /** Of a blade, from its place to the other end; 0: there is none [m]. */
  edge: Vec;
  /** Displacement of every point, times `Frame.scale` in m; a view into the message. */
  displacement: Int16Array;
}

export interface Frame {
  number: number;
  /** On the server's clock [s]. */
  time: number;
  points: number;
  scale: number;
  /** Newest pointer message that the controlled copy has used. */
  echo: number;
  /** Between that pointer's arrival at the server and this frame [s]. */
  served: number;
  copies: Copy[];
  /** When it arrived, as performance.now() [ms]. */
  received: number;
}

export type Action = "ball" | "grab" | "free" | "blade" | "pose";
const ACTIONS: Action[] = ["ball", "grab", "free", "blade", "pose"];

export interface PointerMessage {
  slot: number;
  action: Action;
  number: number;
  point: number;
  target: Vec;
  radius: number;
  stiffness: number;
  /** performance.now() of the event [ms]. */
  time: number;
  /** Of the blade, from the target to the other end [m]; of a rigid tool how it is turned from its start [rad]. */
  edge: Vec;
}

const VERSION = 3;
const HEADER = 32;
const BLOCK = 80;

/** Which elements are cut, by number. */
export function readCut(text: string, elements: number): Uint8Array {
  const packed = new Uint8Array(bytes(text));
  return Uint8Array.from({ length: elements }, (_, n) => (packed[n >> 3]! >> (7 - (n & 7))) & 1);
}

function bytes(text: string): ArrayBuffer {
  const raw = atob(text);
  const result = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) result[i] = raw.charCodeAt(i);
  return result.buffer;
}

const FINEST = 1e-4, COARSEST = 1e4; // sides of a texture's tile, in radii of the object
const MOST = 256; // heights along a side

/** A texture as it comes; null where there is none, or none that could be drawn. @param radius of the object [m] */
export function readTexture(told: any, radius: number): Texture | null {
  if (!told) return null;
  const heights = new Uint16Array(bytes(String(told.heights)));
  const { rows, columns, size, top, angle, projection } = told;
  const counted = [rows, columns].every((count) => Number.isInteger(count) && count >= 1 && count <= MOST) && heights.length === rows * columns;
  const measured = Array.isArray(size) && size.length === 2 && size.every((side) => side >= FINEST * radius && side <= COARSEST * radius);
  const known = Number.isFinite(angle) && top > 0 && top <= radius && ["x", "y", "z", "triplanar"].includes(projection);
  return counted && measured && known ? { heights, rows, columns, size: [size[0], size[1]], top, angle, projection } : null;
}

/** A scene as it comes, with its numbers decoded. */
export function readScene(message: any): Scene {
  const rest = new Float32Array(bytes(message.nodes.rest));
  const skin = message.skin && {
    vertices: message.skin.vertices as number,
    rest: new Float32Array(bytes(message.skin.rest)),
    triangles: new Uint32Array(bytes(message.skin.triangles)),
    node: new Uint32Array(bytes(message.skin.node)),
  };
  const cutting = message.cutting && {
    elements: message.cutting.elements as number,
    pointer: new Uint32Array(bytes(message.cutting.pointer)),
    element: new Uint32Array(bytes(message.cutting.element)),
    beyond: new Int32Array(bytes(message.cutting.beyond)),
  };
  return {
    ...message,
    nodes: { count: message.nodes.count, rest },
    skin,
    cutting: cutting ?? null,
    parts: message.parts ?? [],
    texture: readTexture(message.texture, message.radius),
    edges: message.edges ? new Uint32Array(bytes(message.edges)) : null,
    started: String(message.started),
    points: skin ? skin.rest : rest,
  };
}

function vec(view: DataView, at: number): Vec {
  return [view.getFloat32(at, true), view.getFloat32(at + 4, true), view.getFloat32(at + 8, true)];
}

/** A frame; its displacements stay where they arrived. Throws where the message is none. */
export function readFrame(buffer: ArrayBuffer, received: number): Frame {
  const view = new DataView(buffer);
  if (buffer.byteLength < HEADER || view.getUint8(0) !== 1 || view.getUint8(1) !== VERSION) {
    throw new RangeError(`not a frame of version ${VERSION}`);
  }
  const count = view.getUint16(2, true);
  const points = view.getUint32(16, true);
  const size = BLOCK + 4 * Math.ceil((points * 6) / 4);
  if (buffer.byteLength !== HEADER + count * size) throw new RangeError("a frame of the wrong length");
  const copies: Copy[] = [];
  for (let i = 0; i < count; i++) {
    const at = HEADER + i * size;
    const flags = view.getUint8(at + 2);
    copies.push({
      slot: view.getUint8(at),
      mode: HAND_MODES[view.getUint8(at + 1)] ?? "free",
      direct: (flags & 1) > 0,
      hasHand: (flags & 2) > 0,
      hands: view.getUint8(at + 3),
      age: view.getFloat32(at + 4, true),
      target: vec(view, at + 8),
      place: vec(view, at + 20),
      force: vec(view, at + 32),
      radius: view.getFloat32(at + 44, true),
      energy: view.getFloat32(at + 48, true),
      supplied: view.getFloat32(at + 52, true),
      lost: view.getFloat32(at + 56, true),
      linked: view.getFloat32(at + 60, true),
      node: view.getInt32(at + 64, true),
      edge: vec(view, at + 68),
      displacement: new Int16Array(buffer, at + BLOCK, points * 3),
    });
  }
  return {
    number: view.getUint32(4, true),
    time: view.getFloat64(8, true),
    points,
    scale: view.getFloat32(20, true),
    echo: view.getUint32(24, true),
    served: view.getUint32(28, true) / 1e6,
    copies,
    received,
  };
}

export function writePointer(message: PointerMessage): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(52));
  view.setUint8(0, 2);
  view.setUint8(1, message.slot);
  view.setUint8(2, ACTIONS.indexOf(message.action));
  view.setUint32(4, message.number, true);
  view.setUint32(8, message.point, true);
  message.target.forEach((value, axis) => view.setFloat32(12 + 4 * axis, value, true));
  view.setFloat32(24, message.radius, true);
  view.setFloat32(28, message.stiffness, true);
  view.setFloat64(32, message.time, true);
  message.edge.forEach((value, axis) => view.setFloat32(40 + 4 * axis, value, true));
  return view.buffer as ArrayBuffer;
}

/**
 * @param wait until the next frame should be made [ms]
 * @param every between two pictures of this screen [ms]; 0: not known
 */
export function writeAck(number: number, wait: number, every: number): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(16));
  view.setUint8(0, 3);
  view.setUint32(4, number, true);
  view.setFloat32(8, wait, true);
  view.setFloat32(12, every, true);
  return view.buffer as ArrayBuffer;
}

export function writeHello(token: string | null, slot: number | null, rate: number): string {
  const hello: Hello = { type: "hello", version: VERSION, token, slot, want: "all", rate };
  return JSON.stringify(hello);
}
