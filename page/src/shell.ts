/** Everything around the picture: puts the parts into the page and lets them know each other. */
import "./style.css";
import type { Connection } from "./connection";
import { banners } from "./panels/banners";
import { topBar } from "./panels/bar";
import { type Aiming, type Context, type Level, type Pair, TABS, type Tab, Value } from "./panels/context";
import { attribute, button, h, icon, redraw, text } from "./panels/dom";
import { energyPanel } from "./panels/energy";
import { eventsPanel } from "./panels/events";
import { inviteDialog } from "./panels/invite";
import { keyboard } from "./panels/keyboard";
import { linkCard } from "./panels/link";
import { marginPanel } from "./panels/margin";
import { networkPanel } from "./panels/network";
import { plotsPanel } from "./panels/plots";
import { tips } from "./panels/tips";
import { toolbar } from "./panels/toolbar";
import { usersPanel } from "./panels/users";
import type { Vec } from "./protocol";
import type { Store } from "./store";
import { tour } from "./tour";

/** What the shell asks of the picture. */
export interface Picture {
  reset(): void;
  pulse(slot: number): void;
  /** The drawn point that a place of the window is nearest to, and where in the session it is [m]; null: nowhere. */
  aim(x: number, y: number): { point: number; to: Vec } | null;
}

export interface Shell {
  stageElement: HTMLElement;
  /** Lets the shell reach the picture, once there is one. */
  attach(picture: Picture): void;
}

const TAB_WORDS: Record<Tab, string> = { users: "Users", network: "Network", plots: "Plots", energy: "Energy", margin: "Margin", events: "Events" };
const STAY = 4500; // ms that a toast is seen

function toasts(): { element: HTMLElement; say: Context["say"] } {
  const sign = icon("good", 16);
  const words = h("span", null);
  const bubble = h("div", { class: "toast", hidden: true, "aria-hidden": "true" }, sign, words);
  const spoken = h("div", { class: "unseen", role: "status", "aria-live": "polite", id: "spoken" });
  let timer = 0;
  return {
    element: h("div", { class: "toasts" }, bubble, spoken),
    say(said: string, level: Level = "info") {
      const sentence = said.slice(0, 1).toUpperCase() + said.slice(1);
      text(words, sentence);
      text(spoken, sentence);
      attribute(bubble, "data-level", level);
      redraw(sign, level === "info" ? "wait" : level);
      bubble.hidden = false;
      clearTimeout(timer);
      timer = window.setTimeout(() => (bubble.hidden = true), level === "bad" ? 2 * STAY : STAY);
    },
  };
}

function tabs(context: Context): HTMLElement {
  const buttons = TABS.map((tab) => {
    const one = h("button", { type: "button", role: "tab", id: `tab-${tab}`, "aria-controls": tab, "data-tab": tab }, TAB_WORDS[tab]);
    one.addEventListener("click", () => context.tab.set(tab));
    return one;
  });
  const element = h("div", { class: "tabs", role: "tablist", "aria-label": "Instruments" }, ...buttons);
  element.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const seen = buttons.filter((one) => one.getClientRects().length);
    const here = seen.indexOf(document.activeElement as HTMLButtonElement);
    const next = seen[(here + step + seen.length) % seen.length];
    next?.focus();
    if (next?.dataset.tab) context.tab.set(next.dataset.tab as Tab);
    event.preventDefault();
    event.stopPropagation();
  });
  const update = (): void => {
    const now = context.tab.get();
    document.documentElement.dataset.tab = now;
    // On a wide page users, network and plots are always there, and the tabs are of the rest.
    const wide = ["energy", "margin", "events"].includes(now);
    document.documentElement.dataset.side = wide ? now : (document.documentElement.dataset.side ?? "energy");
    const seen = matchMedia("(max-width: 899px)").matches ? now : document.documentElement.dataset.side;
    for (const one of buttons) {
      attribute(one, "aria-selected", String(one.dataset.tab === seen));
      one.tabIndex = one.dataset.tab === seen ? 0 : -1;
    }
  };
  context.tab.on(update);
  matchMedia("(max-width: 899px)").addEventListener("change", update);
  update();
  return element;
}

/** A click in the picture says where a scripted hand shall pull. */
function aim(context: Context, stage: HTMLElement, picture: () => Picture | null): void {
  const swallow = (event: PointerEvent): void => {
    const aiming = context.aiming.get();
    if (!aiming || !stage.contains(event.target as Node)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (event.type !== "pointerdown") return;
    const found = picture()?.aim(event.clientX, event.clientY) ?? null;
    if (!found) return context.say("The object is not there; click closer to it.", "warn");
    context.aiming.set(null);
    const held = context.store.frame?.copies.find((copy) => copy.slot === aiming.slot)?.node ?? -1;
    const node = held >= 0 ? held : (context.store.scene?.skin?.node[found.point] ?? found.point);
    void context.act({ what: "hand", slot: aiming.slot, mode: "pull", node, to: found.to });
  };
  for (const kind of ["pointerdown", "pointermove", "pointerup"] as const) addEventListener(kind, swallow, true);
  addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || event.defaultPrevented) return;
    if (context.aiming.get()) context.aiming.set(null);
    else if (!document.querySelector("dialog[open]")) context.link.set(null);
  });
  context.aiming.on((aiming) => stage.toggleAttribute("data-aiming", aiming !== null));
}

/** Says new events aloud, and levels of the verdict when they change. */
function speak(context: Context): void {
  let newest = -Infinity;
  let level = "";
  context.store.on("state", () => {
    const state = context.store.state;
    if (!state) return;
    const last = state.events.at(-1);
    if (last && last.time > newest) {
      if (newest > -Infinity) text(document.getElementById("spoken") ?? document.createElement("i"), last.text);
      newest = last.time;
    }
    // Who sees has it on top; a toast would say it twice.
    if (level && level !== state.verdict.level) text(document.getElementById("spoken") ?? document.createElement("i"), state.verdict.text);
    level = state.verdict.level;
  });
  context.store.on("scene", () => {
    if (!context.store.state) [newest, level] = [-Infinity, ""];
  });
}

export function mountShell(root: HTMLElement, store: Store, connection: Connection): Shell {
  const toast = toasts();
  const context: Context = {
    store,
    connection,
    link: new Value<Pair | null>(null),
    opened: new Value<number | null>(null),
    tab: new Value<Tab>("energy"),
    aiming: new Value<Aiming | null>(null),
    say: toast.say,
    async act(command, quiet = false) {
      const told = await connection.do(command);
      if (!told.ok || !quiet) toast.say(told.text || (told.ok ? "Done." : "The server refused."), told.ok ? "good" : "bad");
      return told.ok;
    },
  };
  let picture: Picture | null = null;
  const stageElement = h("div", { id: "stage" });
  const reset = (): void => picture?.reset();
  const invite = inviteDialog(context);
  const guide = tour(context, root);
  const plots = plotsPanel(context);
  const bar = topBar(context, { tour: guide.open, invite: invite.open, keys: () => keys.open() });
  const keys = keyboard(context, { tour: guide.open, invite: invite.open, record: bar.record, freeze: plots.freeze, reset });
  const main = h(
    "main",
    { class: "layout" },
    usersPanel(context),
    h("div", { id: "stage-frame" }, stageElement, toolbar(context, reset), linkCard(context), h("div", { class: "notices" }, toast.element, banners(context))),
    plots.element,
    networkPanel(context),
    tabs(context),
    energyPanel(context),
    marginPanel(context),
    eventsPanel(context),
  );
  const skip = button("To the object", () => stageElement.querySelector<HTMLElement>(".ct-canvas")?.focus(), { class: "skip" });
  root.classList.add("shell");
  root.prepend(skip, bar.element, main);
  if (matchMedia("(max-width: 899px)").matches) context.tab.set("users");
  context.opened.on((slot) => slot !== null && picture?.pulse(slot));
  aim(context, stageElement, () => picture);
  speak(context);
  tips(root);
  const offer = store.on("scene", () => {
    offer();
    guide.invite();
  });
  return { stageElement, attach: (made) => (picture = made) };
}
