/** Which law the links have, its energy on the way, and the drag that hands feel of it, beside what people notice. */
import type { LawState } from "../protocol";
import { attribute, h, shown, text } from "./dom";
import { NONE, number, si } from "./format";

const UNIT = "\u202fN·s/m";
const LAWS: Record<string, string> = {
  spring: "Each link is a spring to the newest sample; damping pays for the samples’ ages, and is felt as drag.",
  paid: "Copies exchange what hands do and predict it; each push is paid from an energy account. Needs no damping.",
  wave: "Each link is a wave line: it adds some mass, and no drag beyond what damps its reflections.",
  tank: "Springs and dampers, paid from an energy tank that a damper fills.",
};

/** How a drag stands beside what people notice. */
export function beside(drag: number, noticed: number): string {
  const times = drag / noticed;
  if (times < -1) return "links are returning stored energy";
  if (times < 1) return "less than people notice";
  return `${number(times, times < 9.95 ? 1 : 0)} times what people notice`;
}

export function lawLine(): { element: HTMLElement; show: (law: LawState | null, nodes: boolean) => void } {
  const name = h("dd", { tabindex: 0 });
  const way = h("dd");
  const drag = h("dd");
  const words = h("dd", { class: "means" });
  const term = (said: string, tip: string): HTMLElement => h("dt", { "data-tip": tip, tabindex: 0 }, said);
  const wayTerm = term("energy on its way", "Energy sent by link ends and not yet received");
  const dragTerm = term("felt drag", "Drag of the link law, as a hand feels it");
  const element = h("dl", { class: "law tabular", hidden: true }, h("dt", null, "link law"), name, wayTerm, way, dragTerm, drag, words);
  return {
    element,
    show(law, nodes) {
      shown(element, law !== null);
      if (!law) return;
      text(name, law.law);
      attribute(name, "data-tip", LAWS[law.law] ?? null);
      shown(wayTerm, law.on_the_way !== null);
      shown(way, law.on_the_way !== null);
      text(way, si(law.on_the_way, "J", 1e-9));
      const [value, how] = law.measured !== null ? [law.measured, "measured"] : [law.predicted, "predicted"];
      const other = law.measured !== null && law.predicted !== null ? `, predicted ${number(law.predicted, 2)}` : "";
      text(drag, value === null ? NONE : `${number(value, 2)}${UNIT} ${how}${other}${nodes ? ", at each node" : ""}`);
      attribute(drag, "data-how", value === null ? null : how);
      const from = `from ${number(law.noticed, 1)}${UNIT}`;
      const felt = value === null ? "" : nodes ? `A hand feels the sum over all nodes that move with it; people notice drag ${from}.` : `${beside(value, law.noticed)} (${from})`;
      text(words, value === null ? "Known once the object moves." : felt);
    },
  };
}
