/** What the parts of the page share: the store, the connection, what is chosen, and how something is said. */
import type { Connection } from "../connection";
import type { Command, Doable, TakeControl } from "../messages";
import type { Vec } from "../protocol";
import type { Store } from "../store";

/** A value that tells who listens when it changes. */
export class Value<T> {
  private readonly listeners = new Set<(value: T) => void>();
  constructor(private current: T) {}

  get(): T {
    return this.current;
  }

  set(value: T): void {
    if (Object.is(value, this.current)) return;
    this.current = value;
    for (const listener of [...this.listeners]) listener(value);
  }

  /** Calls back after every change; returns what ends that. */
  on(listener: (value: T) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

export const TABS = ["users", "network", "plots", "energy", "margin", "events"] as const;
export type Tab = (typeof TABS)[number];
export type Pair = readonly [number, number];
export type Level = "info" | "good" | "warn" | "bad";

/** Waits for a click in the picture that says a place. */
export interface Aiming {
  readonly slot: number;
}

export interface Context {
  readonly store: Store;
  readonly connection: Connection;
  /** The link whose panel is open, the lower slot first. */
  readonly link: Value<Pair | null>;
  /** Whose card is open. */
  readonly opened: Value<number | null>;
  readonly tab: Value<Tab>;
  readonly aiming: Value<Aiming | null>;
  /** Asks the server for something and says its answer; whether it was done. */
  act(command: Command | TakeControl, quiet?: boolean): Promise<boolean>;
  /** Says something for a moment, to those who see and to those who listen. */
  say(words: string, level?: Level): void;
}

/** A user's name, or what he is called before there is one. */
export function nameOf(store: Store, slot: number): string {
  return store.scene?.users.find((user) => user.slot === slot)?.name ?? `user ${slot + 1}`;
}

/** The lower slot first; as an address of a link. */
export function pairOf(a: number, b: number): Pair {
  return a < b ? [a, b] : [b, a];
}

export function keyOf(pair: Pair): string {
  return `${pair[0]}-${pair[1]}`;
}

export function samePair(a: Pair | null, b: Pair | null): boolean {
  return a === b || (a !== null && b !== null && a[0] === b[0] && a[1] === b[1]);
}

/** Whether this server does such a thing, and this page may ask for it. */
export function can(context: Context, what: Doable): boolean {
  const { store, connection } = context;
  return store.live && connection.hasToken && !!store.scene?.may.includes(what);
}

/** What a pull draws at, and where to, for a direction of length 1: the point farthest that way, drawn out by a third of
 * the body's size. */
export function pullTo(context: Context, slot: number, direction: Vec): { node: number; to: Vec } | null {
  const { scene, frame } = context.store;
  if (!scene) return null;
  const copy = frame?.copies.find((one) => one.slot === slot);
  const rest = scene.nodes.rest;
  let node = copy && copy.node >= 0 && copy.node < scene.nodes.count ? copy.node : -1;
  if (node < 0) {
    let most = -Infinity;
    for (let i = 0; i < scene.nodes.count; i++) {
      const along = rest[3 * i]! * direction[0] + rest[3 * i + 1]! * direction[1] + rest[3 * i + 2]! * direction[2];
      if (along > most + 1e-9) [most, node] = [along, i];
    }
  }
  if (node < 0) return null;
  const reach = scene.dimension === 1 ? Math.max(scene.radius, 0.1) : 0.35 * scene.radius;
  return { node, to: [0, 1, 2].map((axis) => rest[3 * node + axis]! + reach * direction[axis]!) as Vec };
}
