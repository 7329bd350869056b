/** Where every joule went: what was put in, and where it is now. */
import type { MemberStatus } from "../protocol";
import { type Context, nameOf } from "./context";
import { attribute, button, h, panel, shown, text } from "./dom";
import { number, percent, si } from "./format";

const EXPLANATION =
  "Every step accounts for its energy, to rounding, so both bars are equally long: what came in is either still there or " +
  "was damped. Hands put energy in and take some back. Links are springs between copies: they return what they store, and " +
  "delay makes them return more than they took, because late samples push at the wrong moment. The damping is chosen to take " +
  "at least that much; this keeps the session stable. As members join and leave, each copy’s share of the object changes, and with it " +
  "its energy. The residual is rounding.";

export interface Row {
  slot: number;
  initial: number;
  hands: number;
  links: number;
  shared: number;
  damped: number;
  stored: number;
  residual: number;
}

/** One user's account; energies in J. Initial + hands + links + shared − damped − stored is rounding. */
export function account(slot: number, status: Partial<MemberStatus>, before: Partial<MemberStatus> | null): Row {
  const since = (kind: "supplied" | "linked" | "rescaled" | "lost"): number => (status[kind] ?? 0) - (before?.[kind] ?? 0);
  const initial = before ? (before.energy ?? 0) : (status.initial ?? 0);
  const row = {
    slot, initial, hands: since("supplied"), links: since("linked"), shared: since("rescaled"), damped: since("lost"), stored: status.energy ?? 0,
  };
  return { ...row, residual: row.initial + row.hands + row.links + row.shared - row.damped - row.stored };
}

interface Part {
  label: string;
  value: number;
  class: string;
  slot?: number;
}

/** What came in and where it went, as parts above 0; both sum to the same, up to the residual. */
export function sides(rows: readonly Row[]): { came: Part[]; went: Part[] } {
  const came: Part[] = [];
  const went: Part[] = [];
  const put = (value: number, source: Omit<Part, "value">, sink: Omit<Part, "value">): void => {
    if (value > 0) came.push({ ...source, value });
    else if (value < 0) went.push({ ...sink, value: -value });
  };
  for (const row of rows) {
    put(row.hands, { label: "hand", class: "hand", slot: row.slot }, { label: "taken back by hand", class: "hand", slot: row.slot });
  }
  put(rows.reduce((sum, row) => sum + row.initial, 0), { label: "at the start", class: "initial" }, { label: "at the start", class: "initial" });
  put(
    rows.reduce((sum, row) => sum + row.links, 0),
    { label: "added by links", class: "links" },
    { label: "stored or taken by links", class: "links" },
  );
  put(
    rows.reduce((sum, row) => sum + row.shared, 0),
    { label: "members leaving", class: "shared" },
    { label: "members joining", class: "shared" },
  );
  put(-rows.reduce((sum, row) => sum + row.damped, 0), { label: "dampers", class: "damped" }, { label: "damped", class: "damped" });
  put(-rows.reduce((sum, row) => sum + row.stored, 0), { label: "copies", class: "stored" }, { label: "in the copies", class: "stored" });
  return { came, went };
}

const COLUMNS: { key: keyof Row; words: string; sign: string; tip: string }[] = [
  { key: "hands", words: "hands", sign: "", tip: "Put in by this user’s hand, less what it took back" },
  { key: "links", words: "links", sign: "+", tip: "Work of the links on this copy: what delays added, less what springs store" },
  { key: "initial", words: "start", sign: "+", tip: "In the copy when counting began" },
  { key: "shared", words: "shares", sign: "+", tip: "Gained or lost as members joined and left, which changes each copy’s share of the object" },
  { key: "damped", words: "damped", sign: "−", tip: "Lost in this copy’s dampers" },
  { key: "stored", words: "in copy", sign: "−", tip: "In this copy now, in motion and in springs" },
  { key: "residual", words: "rest", sign: "=", tip: "The residual: rounding" },
];

const UNITS: readonly [number, string][] = [[1e3, "kJ"], [1, "J"], [1e-3, "mJ"], [1e-6, "µJ"], [1e-9, "nJ"]];

/** An energy in the table’s unit; what rounding leaves is 0. */
function plain(value: number, scale: number): string {
  const size = Math.abs(value) / scale;
  return Math.abs(value) < 1e-12 ? "0" : number(value / scale, size >= 99.95 ? 0 : size >= 9.995 ? 1 : 2);
}

const LETTER = 7; // pixels

function bar(element: HTMLElement, parts: readonly Part[], total: number, name: (slot: number) => string): void {
  while (element.children.length > parts.length) element.lastElementChild?.remove();
  while (element.children.length < parts.length) element.append(h("div", null, h("span")));
  parts.forEach((part, i) => {
    const one = element.children[i] as HTMLElement;
    const share = total > 0 ? part.value / total : 0;
    const label = part.slot === undefined ? part.label : `${part.label} of ${name(part.slot)}`;
    attribute(one, "class", `part part-${part.class}`);
    one.style.width = `${(100 * share).toFixed(2)}%`;
    if (part.slot !== undefined) {
      one.style.setProperty("--user", `var(--user-${part.slot})`);
      one.style.setProperty("--on-user", `var(--on-user-${part.slot})`);
    }
    attribute(one, "data-tip", `${label}: ${si(part.value, "J", 1e-12)}`);
    const words = part.slot === undefined ? part.label : String(part.slot + 1);
    // What does not fit is not written.
    if (one.firstElementChild) text(one.firstElementChild, share * element.clientWidth > 8 + LETTER * words.length ? words : "");
  });
}

export function energyPanel(context: Context): HTMLElement {
  const { store } = context;
  const base = new Map<number, Partial<MemberStatus>>();
  const zero = button("Count from now", () => {
    if (base.size) base.clear();
    else for (const [slot, member] of Object.entries(store.state?.members ?? {})) base.set(Number(slot), { ...member });
    update();
  }, { class: "button small", tip: "Ignore everything before now" });
  const { element, body } = panel("energy", "Energy", EXPLANATION, zero);
  const [came, went] = [h("div", { class: "stack" }), h("div", { class: "stack" })];
  const [cameSum, wentSum] = [h("span", { class: "sum tabular" }), h("span", { class: "sum tabular" })];
  const unit = h("th", { scope: "col" });
  const head = h("tr", null, unit, ...COLUMNS.map((one) => h("th", { scope: "col", "data-tip": one.tip, tabindex: 0 }, `${one.sign}\u00a0${one.words}`.trim())));
  const rows = h("tbody");
  const sums = COLUMNS.map(() => h("td"));
  const closing = h("p", { class: "expected tabular" });
  const empty = h("p", { class: "hint" }, "No energy has been counted yet.");
  const table = h("table", { class: "numbers ledger" }, h("thead", null, head), rows, h("tfoot", null, h("tr", null, h("th", { scope: "row" }, "all"), ...sums)));
  const full = h(
    "div",
    { hidden: true },
    h("div", { class: "bar-row" }, h("span", { class: "bar-name" }, "came in"), came, cameSum),
    h("div", { class: "bar-row" }, h("span", { class: "bar-name" }, "went to"), went, wentSum),
    closing,
    h("div", { class: "scroll" }, table),
  );
  body.append(empty, full);
  const cells = new Map<number, { element: HTMLElement; cells: HTMLElement[] }>();
  const update = (): void => {
    if (body.offsetParent === null && cells.size) return;
    const all = Object.entries(store.state?.members ?? {})
      .filter(([, member]) => member.steps)
      .map(([key, member]) => {
        const slot = Number(key);
        const before = base.get(slot) ?? null;
        // A process that began anew counts from its own start.
        if (before && (member.steps ?? 0) < (before.steps ?? 0)) base.delete(slot);
        return account(slot, member, base.get(slot) ?? null);
      });
    shown(full, all.length > 0);
    shown(empty, all.length === 0);
    text(zero.firstElementChild ?? zero, base.size ? "Count from the start" : "Count from now");
    const both = sides(all);
    const sum = (parts: readonly Part[]): number => parts.reduce((total, part) => total + part.value, 0);
    const [in_, out] = [sum(both.came), sum(both.went)];
    const total = Math.max(in_, out);
    const name = (slot: number): string => nameOf(store, slot);
    bar(came, both.came, total, name);
    bar(went, both.went, total, name);
    text(cameSum, si(in_, "J", 1e-12));
    text(wentSum, si(out, "J", 1e-12));
    const left = in_ - out;
    const members = Object.values(store.state?.members ?? {});
    const worst = Math.max(0, ...members.map((member) => member.residual ?? 0));
    const closure = Math.max(0, ...members.map((member) => member.closure_factor ?? 0));
    const told = closure > 0 ? ` Balancing the steps changed velocities by at most ${percent(closure)}.` : "";
    const cuts = cutWords(members, name);
    attribute(closing, "data-left", total > 0 ? String(Math.abs(left) / total) : null);
    text(closing, total > 0 ? `Residual: ${exponent(left / total)} of what came in. Worst single step: off by ${exponent(worst)} of the energy in play.${told}${cuts}` : "");
    // One unit for all: that of the greatest.
    const largest = Math.max(1e-9, ...all.flatMap((row) => COLUMNS.map((column) => Math.abs(row[column.key]))));
    const [scale, words] = UNITS.find(([one]) => largest >= one) ?? UNITS[UNITS.length - 1]!;
    text(unit, words);
    for (const [slot, row] of cells) if (!all.some((one) => one.slot === slot)) (row.element.remove(), cells.delete(slot));
    for (const one of all) {
      let row = cells.get(one.slot);
      if (!row) {
        const own = COLUMNS.map(() => h("td"));
        const line = h("tr", null, h("th", { scope: "row", title: name(one.slot) }, h("span", { class: "badge tiny", style: `--user:var(--user-${one.slot});--on-user:var(--on-user-${one.slot})` }, String(one.slot + 1))), ...own);
        row = { element: line, cells: own };
        cells.set(one.slot, row);
        rows.append(line);
        // By slot, whoever came first.
        for (const slot of [...cells.keys()].sort((a, b) => a - b)) rows.append(cells.get(slot)?.element ?? line);
      }
      COLUMNS.forEach((column, i) => {
        const cell = row.cells[i];
        if (cell) text(cell, plain(one[column.key], scale));
      });
    }
    attribute(table, "data-initial", all.some((row) => row.initial) ? "" : null);
    COLUMNS.forEach((column, i) => {
      const cell = sums[i];
      if (cell) text(cell, plain(all.reduce((total_, row) => total_ + row[column.key], 0), scale));
    });
  };
  store.on("state", update);
  let run = store.scene?.started;
  store.on("scene", () => {
    if (store.scene?.started !== run) base.clear();
    run = store.scene?.started;
    update();
  });
  context.tab.on(update);
  update();
  return element;
}

const RAISED: Record<string, string> = { "-": "⁻", "0": "⁰", "1": "¹", "2": "²", "3": "³", "4": "⁴", "5": "⁵", "6": "⁶", "7": "⁷", "8": "⁸", "9": "⁹" };

/** A share as 3 · 10⁻¹²; from a hundredth on in per cent. */
export function exponent(share: number): string {
  if (!Number.isFinite(share)) return "–";
  const size = Math.abs(share);
  if (size === 0) return "0";
  if (size >= 0.01) return percent(size);
  const power = Math.floor(Math.log10(size));
  return `${Math.round(size / 10 ** power)}\u00a0·\u00a010${[...String(power)].map((digit) => RAISED[digit] ?? "").join("")}`;
}

/** What was cut, by whom, and whether all copies know of it. */
function cutWords(members: readonly Partial<MemberStatus>[], name: (slot: number) => string): string {
  const most = members.reduce((best, member) => ((member.cuts ?? 0) > (best.cuts ?? 0) ? member : best), members[0] ?? {});
  if (!most.cuts) return "";
  const held = members.reduce((sum, member) => sum + (member.cut_energy ?? 0), 0);
  const by = (most.cut_by ?? []).flatMap((count, user) => (user > 0 && count > 0 ? [`${name(user - 1)} ${count}`] : []));
  const same = new Set(members.flatMap((member) => (member.cut_set ? [member.cut_set] : []))).size < 2;
  return ` Cut: ${most.cuts} elements${by.length ? ` (${by.join(", ")})` : ""}, which stored ${si(held, "J", 1e-12)}${same ? "" : "; not all copies know about them yet"}.`;
}
