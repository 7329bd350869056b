/** Lines over the picture, so that nothing moves when they come and go, that say what is out of the ordinary, and what can be done about it. */
import { type Context, can, nameOf } from "./context";
import { button, h, icon, shown, text } from "./dom";
import { percent } from "./format";

const RETURNED = 8000; // ms for which it is said that damping is back

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
  const restore = button("Restore now", () => void context.act({ what: "damping", fraction: 1 }), { class: "button small primary" });
  const take = button("Take over", () => void context.act({ what: "control" }), { class: "button small primary" });
  const stop = button("Cancel", () => context.aiming.set(null), { class: "button small" });
  // Damping comes back by itself where a copy ran away: that is said where the button was that would have done it.
  let lowered = false;
  let returned = 0;
  const seen = button("Dismiss", () => {
    clearTimeout(returned);
    returned = 0;
    update();
  }, { class: "button small" });
  const watchDamping = (): void => {
    const low = (store.state?.damping ?? 1) < 1;
    if (lowered && !low && store.live) returned = window.setTimeout(() => seen.click(), RETURNED);
    if (low) returned = 0;
    lowered = low;
  };
  const ended = (): boolean => !!store.state?.ended;
  let heard = "";
  const hear = button("Dismiss", () => {
    heard = notRecorded();
    update();
  }, { class: "button small" });
  const notRecorded = (): string => {
    const { state } = store;
    const own = Object.entries(state?.members ?? {}).filter(([, member]) => member.recording === "failed");
    return [
      ...own.map(([slot, member]) => `The recording of ${nameOf(store, Number(slot))} stopped${member.recording_failure ? `: ${member.recording_failure}` : ""}.`),
      ...(state?.recording.troubles.length ? [`${state.recording.state === "failed" ? "Nothing was recorded" : "The recording is incomplete"}: ${state.recording.troubles.join("; ")}.`] : []),
    ].join(" ");
  };
  const all = [
    banner("bad", "banner-lost", () =>
      store.connection === "lost" && !ended() ? "The connection is lost; you see the last known state. Reconnecting …" : null),
    banner("bad", "banner-silent", () =>
      ended() ? null
        : store.connection === "silent" ? "The server does not respond. You see the last known state; nothing can be changed until it responds."
        : store.stalled ? "The session’s process does not respond. Users, links and energies show their last known state; nothing can be changed until it responds."
        : null),
    banner("bad", "banner-refused", () =>
      store.connection === "refused" ? `The server refused this page: ${store.refusal || "it gave no reason."}` : null),
    banner("info", "banner-ended", () =>
      store.connection !== "refused" && ended() ? "The session has ended. You see its final state." : null),
    banner("bad", "banner-recording", () => {
      const said = notRecorded();
      return said && said !== heard ? said : null;
    }, hear),
    banner("bad", "banner-damping", () => {
      const share = store.state?.damping ?? 1;
      restore.disabled = !can(context, "damping");
      return store.live && share < 1 ? `Damping is lowered to ${percent(share, share < 0.01 ? 1 : 0)} of what is needed: energy can grow by itself.` : null;
    }, restore),
    banner("info", "banner-restored", () => (returned && store.live ? "Full damping is restored: the copies are coming to rest." : null), seen),
    banner("info", "banner-view", () =>
      store.connection === "open" && store.scene && !connection.hasToken
        ? connection.tokenWrong
          ? "You are only watching: the token in this address does not belong to the running session. Open the latest address that cotouch printed."
          : "You are only watching. To take part, open the address with the token that cotouch printed."
        : null),
    banner("warn", "banner-control", () =>
      store.live && connection.hasToken && store.state?.control === "other"
        ? `Another page controls ${nameOf(store, store.slot)}.`
        : null, take),
    banner("info", "banner-aim", () => {
      const aiming = context.aiming.get();
      return aiming ? `Click in the picture where ${nameOf(store, aiming.slot)} should pull.` : null;
    }, stop),
  ];
  const update = (): void => {
    watchDamping();
    for (const one of all) one.update();
    const away = ["silent", "lost", "refused"].includes(store.connection) || store.stalled;
    document.documentElement.toggleAttribute("data-lost", away && !ended());
    document.documentElement.toggleAttribute("data-ended", ended());
  };
  for (const kind of ["scene", "state", "connection", "slot"] as const) store.on(kind, update);
  context.aiming.on(update);
  update();
  return h("div", { class: "banners" }, ...all.map((one) => one.element));
}
