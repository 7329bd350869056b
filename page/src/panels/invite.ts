/** How somebody joins from another computer, or opens this page on a phone. */
import { type Context, can, nameOf } from "./context";
import { button, h, shown, text } from "./dom";
import { dialog } from "./dialog";
import { presence } from "./words";

async function copy(context: Context, words: string, what: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(words);
    context.say(`${what} copied.`, "good");
  } catch {
    context.say(`The browser does not allow this page to copy; select the text and copy it yourself.`, "warn");
  }
}

/** A name as a shell takes it for one word. */
export function quoted(name: string): string {
  return /^[\w.-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`;
}

export function inviteDialog(context: Context): { open: () => void } {
  const { store, connection } = context;
  const invitation = h("textarea", { readonly: true, rows: 3, "aria-label": "Invitation", spellcheck: "false" });
  const command = h("textarea", { readonly: true, rows: 1, "aria-label": "Command", spellcheck: "false" });
  const slots = h("select", { "aria-label": "User" });
  const note = h("p", { class: "hint", role: "status" });
  const code = h("img", { alt: "The address of this page as a QR code", width: 168, height: 168, class: "qr" });
  const scan = h("figcaption", null);
  const frame = h("figure", { class: "qr-frame" }, code, scan);
  const near = h("p", { class: "hint" }, "Only this computer can open this page. To open it on a phone with a QR code, start cotouch with --page-listen and this computer’s address.");
  const free = button("Free this slot", () => {
    const slot = Number(slots.value);
    void context.act({ what: "expel", slot });
  }, { class: "button small danger", icon: "stop" });
  const whole = h("p", { class: "hint" }, "Anyone with the invitation can take part, so give it only to people you trust. The other computer must be able to reach this one over the network.");
  const box = dialog("Invite", [
    h(
      "div",
      { class: "invite" },
      h(
        "div",
        { class: "invite-words" },
        h("label", { class: "field" }, h("span", null, "1. Choose the user to play"), h("span", { class: "row" }, slots, free)),
        note,
        h("div", { class: "field" }, h("span", null, "2. On the other computer, run"), command, h("span", { class: "row" }, button("Copy the command", () => void copy(context, command.value, "Command"), { class: "button small" }))),
        h("div", { class: "field" }, h("span", null, "3. Paste the invitation there"), invitation, h("span", { class: "row" }, button("Copy the invitation", () => void copy(context, invitation.value, "Invitation"), { class: "button small primary" }))),
      ),
      frame,
    ),
    whole,
    near,
  ], []);
  const update = (): void => {
    if (!box.element.open) return;
    const words = store.scene?.invitation ?? "";
    const slot = Number(slots.value);
    if (invitation.value !== words) invitation.value = words;
    const line = `cotouch join - --name ${quoted(nameOf(store, slot))}`;
    if (command.value !== line) command.value = line;
    const now = presence(store.state, slot);
    const taken = now === "here" || now === "starting";
    const elsewhere = store.state?.members[slot]?.alive === null;
    shown(frame, !!store.scene?.page);
    shown(near, !store.scene?.page);
    if (store.scene?.page) {
      const address = connection.link("qr.svg", { user: String(slot + 1) });
      if (code.getAttribute("src") !== address) code.src = address;
      text(scan, `opens this page on a phone, as ${nameOf(store, slot)}`);
    }
    text(note, elsewhere && taken
      ? `${nameOf(store, slot)} is played on another computer. If you free the slot, whoever plays there is removed for the rest of the session.`
      : taken
      ? `${nameOf(store, slot)} is played by a process on this computer. Free the slot first; whoever then joins with this name takes it over, and the object stays.`
      : `The slot of ${nameOf(store, slot)} is free.`);
    shown(free, taken);
    free.disabled = !can(context, "expel");
  };
  slots.addEventListener("change", update);
  store.on("state", update);
  store.on("scene", update);
  return {
    open: () => {
      if (!store.scene?.invitation) return;
      const users = store.scene.users;
      const before = slots.value;
      slots.replaceChildren(...users.map((user) => h("option", { value: user.slot }, `${user.slot + 1} · ${user.name}`)));
      const open = users.find((user) => !["here", "starting"].includes(presence(store.state, user.slot))) ?? users.at(-1);
      slots.value = before || String(open?.slot ?? 0);
      box.open();
      update();
    },
  };
}
