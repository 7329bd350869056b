/** What the picture shows, and what the pointer does in it. */
import type { Context } from "./context";
import { attribute, button, choice, h } from "./dom";

export function toolbar(context: Context, reset: () => void): HTMLElement {
  const { store } = context;
  const tool = choice("Tool", [
    { value: "grab", words: "Grab", icon: "grab", tip: "Take hold of a point and drag it (B switches tools)" },
    { value: "ball", words: "Ball", icon: "ball", tip: "Push with a ball; Shift + wheel changes its size" },
    { value: "blade", words: "Blade", icon: "blade", tip: "Cut away from you; Shift + wheel changes the depth" },
  ] as const, (value) => store.set({ tool: value }));
  const layout = choice("Copies", [
    { value: "overlay", words: "Overlaid", icon: "overlay", tip: "All copies in one place (S)" },
    { value: "side", words: "Side by side", icon: "side", tip: "Each copy on its own: see how late the others are (S)" },
  ] as const, (value) => store.set({ layout: value }));
  const own = h("option", { value: "plain" }, "Plain");
  const colour = h("select", { "aria-label": "Colour of the object", "data-tip": "What the colours show (C)" },
    h("option", { value: "displacement" }, "Displacement"),
    h("option", { value: "stress" }, "Stretch"),
    own,
  );
  colour.addEventListener("change", () => store.set({ colour: colour.value as "displacement" | "stress" | "plain" }));
  const ghosts = button("Ghosts", () => store.set({ ghosts: !store.settings.ghosts }), { icon: "ghosts", class: "button small toggle", tip: "Show the others’ copies over yours" });
  const home = button("", reset, { icon: "reset", class: "button small bare", label: "Reset the view", tip: "Reset the view (0)" });
  const element = h("div", { class: "toolbar", id: "toolbar", role: "toolbar", "aria-label": "Picture" },
    h("span", { class: "space-only" }, tool.element),
    h("span", { class: "space-only" }, layout.element),
    h("span", { class: "space-only select" }, colour),
    ghosts,
    home,
  );
  const update = (): void => {
    const { settings, scene } = store;
    tool.mark(store.tool);
    for (const choice of tool.element.querySelectorAll<HTMLElement>("[data-value]")) choice.hidden = !store.tools.some((one) => one === choice.dataset.value);
    layout.mark(settings.layout);
    own.textContent = scene?.parts.length ? "Bodies" : "Plain";
    colour.value = store.colour;
    attribute(ghosts, "aria-pressed", String(settings.ghosts));
    attribute(element, "data-dimension", scene ? String(scene.dimension) : null);
    ghosts.disabled = scene?.dimension !== 1 && settings.layout === "side";
  };
  store.on("settings", update);
  store.on("scene", update);
  update();
  return element;
}
