/** How somebody joins from another computer. */
import { type Context, can, nameOf } from "./context";
import { button, h, shown, text } from "./dom";
import { dialog } from "./dialog";
import { presence } from "./words";

async function copy(context: Context, words: string, what: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(words);
    context.say(`${what} copied.`, "good");
  } catch {
    context.say(`The browser does not let this page copy; mark the text and copy it yourself.`, "warn");
  }
}

/** A name as a shell takes it for one word. */
export function quoted(name: string): string {
  return /^[\w.-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`;
}

export function inviteDialog(context: Context): { open: () => void } {
  const { store, connection } = context;
  const invitation = h("textarea", { readonly: true, rows: 3, "aria-label": "Invitation", spellcheck: "false" });
  const command = h("textarea", { readonly: true, rows: 3, "aria-label": "Command", spellcheck: "false" });
  const seats = h("select", { "aria-label": "Whose place" });
  const note = h("p", { class: "hint", role: "status" });
  const code = h("img", { alt: "The invitation as a QR code", width: 168, height: 168, class: "qr" });
  const free = button("Free this place", () => {
    const seat = Number(seats.value);
    void context.act("kill", { seat });
  }, { class: "button small danger", icon: "stop" });
  const whole = h("p", { class: "hint" }, "Whoever has the invitation can take part: give it only to those you trust. The other computer must reach this one over the network.");
  const box = dialog("Invite", [
    h(
      "div",
      { class: "invite" },
      h(
        "div",
        { class: "invite-words" },
        h("label", { class: "field" }, h("span", null, "1. Whose place shall be taken?"), h("span", { class: "row" }, seats, free)),
        note,
        h("div", { class: "field" }, h("span", null, "2. On the other computer, type"), command, h("span", { class: "row" }, button("Copy the command", () => void copy(context, command.value, "Command"), { class: "button small primary" }))),
        h("div", { class: "field" }, h("span", null, "or hand over the invitation alone"), invitation, h("span", { class: "row" }, button("Copy the invitation", () => void copy(context, invitation.value, "Invitation"), { class: "button small" }))),
      ),
      h("figure", { class: "qr-frame" }, code, h("figcaption", null, "or scan it")),
    ),
    whole,
  ], []);
  const update = (): void => {
    if (!box.element.open) return;
    const words = store.scene?.invitation ?? "";
    const seat = Number(seats.value);
    if (invitation.value !== words) invitation.value = words;
    const line = `cotouch join ${words} --name ${quoted(nameOf(store, seat))}`;
    if (command.value !== line) command.value = line;
    const now = presence(store.state, seat);
    const taken = now === "here" || now === "starting";
    text(note, taken
      ? `${nameOf(store, seat)} is played by a process here. Free the place first; the object stays, and whoever joins with this name takes it.`
      : `The place of ${nameOf(store, seat)} is free.`);
    shown(free, taken);
    free.disabled = !can(context, "kill") || !store.scene?.own.includes(seat);
  };
  seats.addEventListener("change", update);
  store.on("state", update);
  store.on("scene", update);
  return {
    open: () => {
      if (!store.scene?.invitation) return;
      const users = store.scene.users;
      const before = seats.value;
      seats.replaceChildren(...users.map((user) => h("option", { value: user.seat }, `${user.seat + 1} · ${user.name}`)));
      const open = users.find((user) => !["here", "starting"].includes(presence(store.state, user.seat))) ?? users.at(-1);
      seats.value = before || String(open?.seat ?? 0);
      code.src = connection.link("qr.svg");
      box.open();
      update();
    },
  };
}
