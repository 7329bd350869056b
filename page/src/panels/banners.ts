/** Lines under the top that say what is out of the ordinary, and what can be done about it. */
import { type Context, can, nameOf } from "./context";
import { button, h, icon, shown, text } from "./dom";
import { percent } from "./format";

interface Banner {
  element: HTMLElement;
  update(): void;
}

function banner(level: "info" | "warn" | "bad", id: string, when: () => string | null, ...more: HTMLElement[]): Banner {
  const words = h("span", null);
  const element = h(
    "div",
    { class: `banner banner-${level}`, id, role: level === "bad" ? "alert" : "status", hidden: true },
    icon(level === "info" ? "wait" : level, 16),
    words,
    ...more,
  );
  return {
    element,
    update: () => {
      const said = when();
      shown(element, said !== null);
      if (said !== null) text(words, said);
    },
  };
}

export function banners(context: Context): HTMLElement {
  const { store, connection } = context;
  const restore = button("Restore now", () => void context.act("damping", { share: 1 }), { class: "button small primary" });
  const take = button("Take over", () => void context.act("control"), { class: "button small primary" });
  const stop = button("Cancel", () => context.aiming.set(null), { class: "button small" });
  const all = [
    banner("bad", "banner-lost", () =>
      store.connection === "lost" ? "The connection is lost; what you see is the last that was known. Connecting again …" : null),
    banner("bad", "banner-refused", () =>
      store.connection === "refused" ? `The server refused this page: ${store.refusal || "no reason was given."}` : null),
    banner("info", "banner-ended", () =>
      store.connection !== "refused" && store.state?.ended ? "The session has ended. What you see is its last moment." : null),
    banner("bad", "banner-damping", () => {
      const share = store.state?.damping ?? 1;
      restore.disabled = !can(context, "damping");
      return store.connection === "open" && share < 1 ? `Damping is lowered to ${percent(share, share < 0.01 ? 1 : 0)} of what is needed: the session is not passive.` : null;
    }, restore),
    banner("info", "banner-view", () =>
      store.connection === "open" && store.scene && !connection.hasToken
        ? connection.tokenWrong
          ? "You are watching: the token in this address is not that of the session that runs now. Open the address that cotouch printed last."
          : "You are watching. To take part, open the address with the token that cotouch printed."
        : null),
    banner("warn", "banner-control", () =>
      store.connection === "open" && connection.hasToken && !store.state?.ended && store.state?.control === "other"
        ? `Another page holds the control of ${nameOf(store, store.seat)}.`
        : null, take),
    banner("info", "banner-aim", () => {
      const aiming = context.aiming.get();
      return aiming ? `Click in the picture where ${nameOf(store, aiming.seat)} shall pull.` : null;
    }, stop),
  ];
  const update = (): void => {
    for (const one of all) one.update();
    document.documentElement.toggleAttribute("data-lost", store.connection === "lost" || store.connection === "refused");
  };
  for (const kind of ["scene", "state", "connection", "seat"] as const) store.on(kind, update);
  context.aiming.on(update);
  update();
  return h("div", { class: "banners" }, ...all.map((one) => one.element));
}
