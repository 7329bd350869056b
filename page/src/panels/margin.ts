/** What is guaranteed, with how much to spare, and a way to see what happens without it. */
import { agesChart } from "./ages";
import { type Context, can, keyOf, nameOf, pairOf, samePair } from "./context";
import { attribute, button, h, icon, panel, shown, text } from "./dom";
import { lawLine } from "./law";
import { NONE, linkName, ms, number, percent } from "./format";
import { dialog } from "./dialog";
import { CONDITIONS, condition, spare, worse } from "./words";

const EXPLANATION =
  "Safe (passive) means that whatever the users do, the session as a whole never returns more energy than hands put in, so nothing can " +
  "start to oscillate by itself. This holds as long as each copy’s damping is at least what the ages on its links require. Damping is " +
  "set for an age budget on each link; what the ages do not use is to spare. A link that exceeds its budget is guarded: it then " +
  "spends only energy that it has saved. Laws other than springs need neither this damping nor a budget: they pay for their energy.";

// In per cent, by powers of ten, because what matters lies near the lower end.
const [LEAST, MOST] = [0.1, 100];
// With this much, copies shake within some three seconds and do not fly apart at once: a skinned body's own damping holds
// it still above some 2 %, a point and bare nodes shake at 5 % already.
const USUAL = { skin: 1, bare: 5 };

/** What a place of the slider stands for, to two figures [%]; its places are tenths of a power of ten, from LEAST. */
function shareAt(place: number): number {
  return Math.min(Number((LEAST * 10 ** (place / 10)).toPrecision(2)), 95);
}

const placeOf = (share: number): number => Math.round(10 * Math.log10(share / LEAST));
const PLACES = placeOf(MOST);

/** The dialog that lowers the damping below what is needed. */
export function dampingDialog(context: Context): { open: () => void } {
  const output = h("output", { class: "tabular" });
  const input = h("input", { type: "range", min: 0, max: PLACES, step: 1, value: placeOf(USUAL.bare), "aria-label": "Damping, as a share of what is needed" });
  const wear = (): void => {
    const words = `${shareAt(Number(input.value))} % of what is needed`;
    text(output, words);
    attribute(input, "aria-valuetext", words);
    input.style.setProperty("--share", `${(Number(input.value) / PLACES) * 100}%`);
  };
  input.addEventListener("input", wear);
  wear();
  const box = dialog("Lower the damping", [
    h(
      "p",
      { class: "warning" },
      icon("warn", 20),
      h("span", null, "With less damping than the delays need, nothing keeps energy from growing: copies start to shake by themselves, ever harder, until they are stopped. You will see this in the numbers and in the picture."),
    ),
    h("p", null, "Do this only with simulated hands. Let go of any real device first."),
    h("label", { class: "slider" }, h("span", null, "damping"), input, output),
    h("p", { class: "hint" }, "Meanwhile, scripted hands let go. Damping stays lowered only while this page is open and responding. It is restored automatically when a copy runs away, and by one click on the banner."),
  ], [
    { words: "Lower it", class: "button danger", act: () => void context.act({ what: "damping", fraction: Number((shareAt(Number(input.value)) / 100).toPrecision(3)) }) },
    { words: "Keep it as it is", class: "button primary", act: () => undefined, focus: true },
  ]);
  let whose: string | undefined;
  return {
    open: () => {
      const { scene } = context.store;
      if (scene && scene.started !== whose) {
        whose = scene.started;
        input.value = String(placeOf(scene.skin ? USUAL.skin : USUAL.bare));
        wear();
      }
      box.open();
    },
  };
}

export function marginPanel(context: Context): HTMLElement {
  const { store } = context;
  const lowering = dampingDialog(context);
  const lower = button("Lower damping …", () => lowering.open(), { icon: "warn", class: "button small danger", id: "lower", tip: "Shows what the damping is for" });
  const restore = button("Restore damping", () => void context.act({ what: "damping", fraction: 1 }), { class: "button small primary" });
  const { element, body } = panel("margin", "Margin", EXPLANATION, lower, restore);
  const links = h("tbody");
  const users = h("tbody");
  const law = lawLine();
  body.append(
    law.element,
    h(
      "table",
      { class: "numbers" },
      h("thead", null, h("tr", null, ...["link", "age sum", "budget", "to spare", ""].map((words) => h("th", { scope: "col" }, words)))),
      links,
    ),
    agesChart(context),
    h(
      "table",
      { class: "numbers" },
      h(
        "thead",
        null,
        h(
          "tr",
          null,
          h("th", { scope: "col" }, "user"),
          h("th", { scope: "col", "data-tip": "Largest damping coefficient of the copy", tabindex: 0 }, "damping"),
          h("th", { scope: "col", "data-tip": "Damping beyond what the current budgets need", tabindex: 0 }, "damping margin"),
        ),
      ),
      users,
    ),
  );
  const update = (): void => {
    const state = store.state;
    const lowered = !!state && state.damping < 1;
    shown(lower, !lowered && !!store.scene?.may.includes("damping"));
    shown(restore, lowered);
    lower.disabled = restore.disabled = !can(context, "damping");
    if (!state || body.offsetParent === null) return;
    law.show(state.law, (store.scene?.nodes.count ?? 1) > 1);
    const pairs = state.links.map(([a, b]) => pairOf(a, b));
    const key = JSON.stringify([pairs, store.scene?.started]);
    if (links.dataset.key !== key) {
      links.dataset.key = key;
      links.replaceChildren(
        ...pairs.map((pair) =>
          h(
            "tr",
            { "data-link": keyOf(pair) },
            h("th", { scope: "row" }, button(linkName(...pair), () => context.link.set(pair), { class: "plain", label: `Open link ${linkName(...pair)}` })),
            h("td"),
            h("td"),
            h("td", { class: "gauge" }, h("i"), h("span")),
            h("td", { class: "word" }),
          ),
        ),
      );
    }
    pairs.forEach((pair, i) => {
      const cells = links.children[i]?.children;
      if (!cells) return;
      const now = condition(state, ...pair);
      const left = spare(state, ...pair);
      attribute(links.children[i] as Element, "data-condition", now);
      attribute(links.children[i] as Element, "data-chosen", samePair(pair, context.link.get()) ? "" : null);
      text(cells[1] as Element, ms(worse(state, ...pair, "age_sum")));
      text(cells[2] as Element, ms(worse(state, ...pair, "budget")));
      const gauge = cells[3] as HTMLElement;
      gauge.style.setProperty("--share", `${Math.round(100 * Math.min(Math.max(1 - (left ?? 1), 0), 1))}%`);
      attribute(gauge, "data-level", left === null ? null : left < 0 ? "bad" : left < 0.1 ? "warn" : "good");
      text(gauge.lastElementChild as Element, left === null ? NONE : left < 0 ? `${percent(-left, 0)} over` : percent(left, 0));
      text(cells[4] as Element, CONDITIONS[now].words);
    });
    const slots = Object.keys(state.members).map(Number).sort((a, b) => a - b);
    const whom = JSON.stringify([slots, store.scene?.started]);
    if (users.dataset.key !== whom) {
      users.dataset.key = whom;
      users.replaceChildren(
        ...slots.map((slot) =>
          h(
            "tr",
            null,
            h("th", { scope: "row" }, h("span", { class: "badge tiny", style: `--user:var(--user-${slot});--on-user:var(--on-user-${slot})` }, String(slot + 1)), " ", nameOf(store, slot)),
            h("td"),
            h("td"),
          ),
        ),
      );
    }
    slots.forEach((slot, i) => {
      const cells = users.children[i]?.children;
      const member = state.members[slot];
      if (!cells || !member) return;
      text(cells[1] as Element, member.steps ? `${number(member.damping, 2)}\u202fN·s/m` : NONE);
      const above = member.damping_margin;
      text(cells[2] as Element, typeof above === "number" ? percent(above) : NONE);
      attribute(cells[2] as Element, "data-level", typeof above === "number" ? (above < 0 ? "bad" : "good") : null);
    });
  };
  store.on("state", update);
  store.on("connection", update);
  context.tab.on(update);
  context.link.on(update);
  update();
  return element;
}
