/** Users in a circle and the links between them: how each link is, and a hold on it. */
import { type Context, type Pair, can, keyOf, nameOf, pairOf, samePair } from "./context";
import { attribute, h, icon, panel, s, shown, text } from "./dom";
import { NONE, linkName, ms, percent } from "./format";
import { HEIGHT, type Point, RADIUS, WIDTH, allPairs, along, labelShares, places } from "./graph";
import { topologyChoices } from "./topology";
import { CONDITIONS, condition, presence, worse } from "./words";

const EXPLANATION =
  "Who is linked to whom. The number on a link is the age of its later end’s newest sample, and the share of samples " +
  "lost. Select a link to see both ends and to delay, disturb or cut it; drag it sideways to change its delay " +
  "(1 ms per pixel; on the keyboard, + and −).";
const NUDGE = 0.005; // s, of a key
const MOST = 0.5; // s
const QUIET = 100; // ms between two orders while something is drawn

interface Drawn {
  group: SVGGElement;
  update(): void;
}

/** Sends the newest of what changes often, at most so many times a second, and always the last. */
export function paced(send: (value: number) => void): (value: number) => void {
  let next: number | null = null;
  let timer = 0;
  const flush = (): void => {
    timer = 0;
    if (next === null) return;
    const value = next;
    next = null;
    timer = window.setTimeout(flush, QUIET);
    send(value);
  };
  return (value) => {
    next = value;
    if (!timer) flush();
  };
}

function linkDrawing(context: Context, pair: Pair, at: readonly Point[], share: number, drafting: () => boolean): Drawn {
  const { store } = context;
  const [a, b] = pair;
  const [from, to] = [at[a] ?? { x: 0, y: 0 }, at[b] ?? { x: 0, y: 0 }];
  const ends = { x1: from.x, y1: from.y, x2: to.x, y2: to.y };
  const spot = along(from, to, share);
  const line = s("line", { ...ends, class: "link-line" });
  const words = s("text", { x: spot.x, y: spot.y + 3.5, class: "link-words" });
  const plate = s("rect", { class: "link-plate", rx: 4, y: spot.y - 9, height: 18 });
  const group = s(
    "g",
    { class: "link", tabindex: 0, role: "button", "data-link": keyOf(pair) },
    s("line", { ...ends, class: "link-halo" }),
    line,
    s("line", { ...ends, class: "link-hit" }),
    plate,
    words,
  );
  const delayOf = (): number => store.state?.emulated[`${a}-${b}`]?.delay ?? 0;
  const send = paced((delay) => void context.act({ what: "impair", a, b, delay }, true));
  let drawnDelay: number | null = null;
  let start: { x: number; delay: number } | null = null;
  group.addEventListener("pointerdown", (event) => {
    if (drafting() || event.button !== 0) return;
    start = { x: event.clientX, delay: delayOf() };
    group.setPointerCapture(event.pointerId);
  });
  group.addEventListener("pointermove", (event) => {
    if (!start) return;
    const moved = event.clientX - start.x;
    if (drawnDelay === null && (Math.abs(moved) < 4 || !can(context, "impair"))) return;
    drawnDelay = Math.min(Math.max(start.delay + moved * 1e-3, 0), MOST);
    send(drawnDelay);
    update();
  });
  const end = (event: PointerEvent): void => {
    const drawn = drawnDelay !== null;
    const held = start !== null;
    start = drawnDelay = null;
    if (!drawn && held && event.type === "pointerup") context.link.set(samePair(context.link.get(), pair) ? null : pair);
    update();
  };
  group.addEventListener("pointerup", end);
  group.addEventListener("pointercancel", end);
  let wished = 0;
  group.addEventListener("keydown", (event) => {
    if (drafting()) return;
    if (event.key === "Enter" || event.key === " ") {
      context.link.set(samePair(context.link.get(), pair) ? null : pair);
      document.getElementById("link")?.focus();
    } else if ("+-=−".includes(event.key) && can(context, "impair")) {
      wished = Math.min(Math.max(delayOf() + (event.key === "+" || event.key === "=" ? NUDGE : -NUDGE), 0), MOST);
      send(wished);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });
  const update = (): void => {
    const now = condition(store.state, a, b);
    const age = worse(store.state, a, b, "age");
    const loss = worse(store.state, a, b, "loss");
    attribute(group, "data-condition", now);
    attribute(group, "data-chosen", samePair(context.link.get(), pair) ? "" : null);
    attribute(group, "data-drawn", drawnDelay === null ? null : "");
    const said =
      drawnDelay !== null
        ? `+${ms(drawnDelay)} each way`
        : now === "coupled" || now === "catching" || now === "guarded"
          ? [age === null ? "" : ms(Math.max(age, 0)), loss !== null && loss >= 0.0005 ? percent(loss) : ""].filter(Boolean).join(" · ") || NONE
          : now === "waiting" ? "" : CONDITIONS[now].words; // many wait at once, and a word each would not fit
    const mark = { guarded: "! ", cut: "✕ ", waiting: "… ", catching: "… " }[now as string] ?? "";
    const label = drawnDelay === null ? (mark + said).trim() : said;
    text(words, label);
    const width = 12 + label.length * 6.1;
    attribute(plate, "x", (spot.x - width / 2).toFixed(1));
    attribute(plate, "width", width.toFixed(1));
    attribute(
      group,
      "aria-label",
      `Link ${linkName(a, b)}, ${CONDITIONS[now].words}, age ${ms(age)}, loss ${percent(loss)}`,
    );
    attribute(group, "aria-pressed", String(samePair(context.link.get(), pair)));
  };
  return { group, update };
}

function userDrawing(context: Context, slot: number, at: Point): Drawn {
  const { store } = context;
  const name = nameOf(store, slot);
  // At the sides a name stands beside its user, else above or below, where links do not go.
  const aside = Math.abs(at.x - WIDTH / 2) > 80;
  const right = at.x > WIDTH / 2;
  const most = aside ? 10 : 16;
  const short = name.length > most ? `${name.slice(0, most - 1)}…` : name;
  const label = aside
    ? { x: at.x + (right ? 1 : -1) * (RADIUS + 8), y: at.y + 4, anchor: right ? "start" : "end" }
    : { x: at.x, y: at.y + (at.y < HEIGHT / 2 ? -RADIUS - 7 : RADIUS + 16), anchor: "middle" };
  const group = s(
    "g",
    { class: "node", style: `--user:var(--user-${slot});--on-user:var(--on-user-${slot})`, "data-slot": slot },
    s("title", null, name),
    s("circle", { cx: at.x, cy: at.y, r: RADIUS + 4, class: "node-mine" }),
    s("circle", { cx: at.x, cy: at.y, r: RADIUS, class: "node-disc" }),
    s("text", { x: at.x, y: at.y + 4.5, class: "node-number" }, String(slot + 1)),
    s("text", { x: label.x, y: label.y, "text-anchor": label.anchor, class: "node-name" }, short),
  );
  group.addEventListener("click", () => {
    context.opened.set(slot);
    context.tab.set("users");
  });
  return {
    group,
    update: () => {
      attribute(group, "data-presence", presence(store.state, slot));
      attribute(group, "data-mine", store.me === slot ? "" : null);
    },
  };
}

function pairDrawing(draft: Set<string>, pair: Pair, at: readonly Point[], changed: () => void): Drawn {
  const [from, to] = [at[pair[0]] ?? { x: 0, y: 0 }, at[pair[1]] ?? { x: 0, y: 0 }];
  const ends = { x1: from.x, y1: from.y, x2: to.x, y2: to.y };
  const key = keyOf(pair);
  const group = s(
    "g",
    { class: "pair", tabindex: 0, role: "checkbox", "aria-label": `Link ${linkName(...pair)}`, "data-link": key },
    s("line", { ...ends, class: "pair-line" }),
    s("line", { ...ends, class: "link-hit" }),
  );
  const turn = (): void => {
    if (!draft.delete(key)) draft.add(key);
    changed();
  };
  group.addEventListener("click", turn);
  group.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    turn();
  });
  return { group, update: () => attribute(group, "aria-checked", String(draft.has(key))) };
}

/** The panel with the drawing and the choices of links. */
export function networkPanel(context: Context): HTMLElement {
  const { store } = context;
  const { element, body } = panel("network", "Network", EXPLANATION);
  const drawing = s("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "graph", role: "group", "aria-label": "Users and links" });
  const legend = h(
    "ul",
    { class: "legend" },
    ...(["coupled", "guarded", "cut"] as const).map((one) =>
      h("li", { "data-condition": one, "data-tip": CONDITIONS[one].means, tabindex: 0 }, icon(CONDITIONS[one].icon, 12), CONDITIONS[one].words),
    ),
  );
  const draft = new Set<string>();
  let drafting = false;
  let drawn: Drawn[] = [];
  let built = "";
  const update = (): void => {
    const slots = (store.scene?.users ?? []).map((user) => user.slot);
    const linked = (store.state?.links ?? []).map(([a, b]) => pairOf(a, b));
    const key = JSON.stringify([drafting, store.scene?.started, store.scene?.users, linked]);
    if (key !== built) {
      built = key;
      const focused = document.activeElement?.closest<SVGElement>("[data-link]")?.dataset.link;
      const at: Point[] = [];
      places(slots.length).forEach((place, i) => {
        at[slots[i] ?? i] = place;
      });
      const shares = labelShares(linked, at);
      const links = drafting
        ? allPairs(slots).map((pair) => pairDrawing(draft, pair, at, () => choices.changed()))
        : linked.map((pair, i) => linkDrawing(context, pair, at, shares[i] ?? 0.5, () => drafting));
      drawn = [...links, ...slots.map((slot) => userDrawing(context, slot, at[slot] ?? { x: 0, y: 0 }))];
      drawing.replaceChildren(...drawn.map((one) => one.group));
      attribute(drawing, "data-drafting", drafting ? "" : null);
      if (focused) drawing.querySelector<SVGElement>(`[data-link="${focused}"]`)?.focus();
      const open = context.link.get();
      if (open && !linked.some((pair) => samePair(pair, open))) context.link.set(null);
    }
    for (const one of drawn) one.update();
    choices.update();
    shown(legend, !drafting);
  };
  const choices = topologyChoices(context, draft, (now) => {
    drafting = now;
    if (now) context.link.set(null);
    update();
  }, () => update());
  body.append(drawing, legend, choices.element);
  for (const kind of ["scene", "state", "slot", "connection"] as const) store.on(kind, update);
  context.link.on(update);
  update();
  return element;
}
