// What the page may say, and the server checks; made by messages.py from the server's models.

/** How a hand moves, by the number that stands for it in frames. */
export const HAND_MODES = ["script", "free", "hold", "pull", "wander", "grab", "ball", "blade", "cut", "pose"] as const;
export type HandMode = (typeof HAND_MODES)[number];

/** A hand of `Scene.own` does something. */
export interface MoveHand {
  what: "hand";
  slot: number; // the slot of a user, counted from 0
  mode: "script" | "free" | "hold" | "pull" | "wander" | "cut" | "pose"; // one of script, free, hold, pull, wander, cut, pose
  node?: number; // a node, counted from 0, or -1 for the one that is held
  to?: readonly [number, number, number] | null; // 3 numbers, each at most 10000 m
  at?: readonly [number, number, number] | null; // 3 numbers, each at most 10000 m
  edge?: readonly [number, number, number] | null; // 3 numbers, each at most 10000 m
  turn?: readonly [number, number, number] | null; // 3 numbers, each at most 4 rad
}

/** A path is made worse, or better again; what is missing stays as it is. */
export interface Impair {
  a: number; // the slot of a user, counted from 0
  b: number; // the slot of a user, counted from 0
  what: "impair";
  delay?: number | null; // from 0 to 5 s
  jitter?: number | null; // from 0 to 5 s
  loss?: number | null; // from 0 to 1
}

/** Nothing gets through on a path any more, or everything again. */
export interface Cut {
  a: number; // the slot of a user, counted from 0
  b: number; // the slot of a user, counted from 0
  what: "cut";
  on: boolean; // true or false
}

/** A user's process dies. */
export interface Kill {
  what: "kill";
  slot: number; // the slot of a user, counted from 0
}

/** A user's process is started again. */
export interface Revive {
  what: "revive";
  slot: number; // the slot of a user, counted from 0
}

/** Whoever has a slot goes, and it is free for whoever comes. */
export interface Expel {
  what: "expel";
  slot: number; // the slot of a user, counted from 0
}

/** Who is linked to whom. */
export interface ChooseLinks {
  what: "links";
  choice?: "best" | "worst" | "start" | null; // one of best, worst, start
  links?: readonly (readonly [number, number])[] | null; // a list of at most 496 pairs of slots, counted from 0
}

/** Copies are given a part of the damping that passivity needs. */
export interface SetDamping {
  what: "damping";
  fraction: number; // above 0 and at most 1
}

/** Everybody's part is recorded from now on, or no more. */
export interface SetRecording {
  what: "record";
  on: boolean; // true or false
}

/** What a session may be asked for. */
export type Command = MoveHand | Impair | Cut | Kill | Revive | Expel | ChooseLinks | SetDamping | SetRecording;
export type Doable = Command["what"];

/** This page is to lead its slot, whoever led it before; the server's own, no command of a session. */
export interface TakeControl {
  what: "control";
}

/** What a page says first. */
export interface Hello {
  type: "hello";
  version: number;
  token?: string | null;
  slot?: number | null;
  want?: "all" | "mine";
  rate?: number;
}
