// Names over the picture, as text that stays sharp.
const HIGH = 24; // of a hand's name, with what is between two [pixels]
const LETTER = 7.1;
const READ = 125; // ms between two changes of a number: quicker ones nobody reads, and each has to be laid out anew

/** A label, and what it shows now: a page that nothing was written into needs no layout. */
interface Made {
  readonly element: HTMLElement;
  readonly text: HTMLElement;
  readonly detail: HTMLElement;
  slot: number;
  place: string;
}

export class Labels {
  readonly element = document.createElement("div");
  private readonly taken: { x: number; y: number; wide: number }[] = [];
  private readonly made = new Map<string, Made>();
  private readonly used = new Set<string>();
  private since = 0;
  private count = true; // whether numbers change in this picture: all in the same, for one layout

  constructor(parent: HTMLElement) {
    this.element.className = "ct-labels";
    this.element.setAttribute("aria-hidden", "true");
    parent.append(this.element);
  }

  /** About how wide a hand's name is drawn [pixels]. */
  static wide(text: string, detail: string): number {
    return LETTER * (text.length + detail.length) + 52;
  }

  /** Puts a label; what was not put since `sweep` began disappears with it. */
  put(key: string, kind: string, slot: number, text: string, detail: string, x: number, y: number): void {
    const label = this.made.get(key) ?? this.make(key);
    this.used.add(key);
    const name = `ct-label ct-${kind}`;
    if (label.element.className !== name) label.element.className = name;
    if (label.slot !== slot) label.element.style.setProperty("--user", `var(--user-${(label.slot = slot) % 8})`);
    if (label.text.textContent !== text) label.text.textContent = text;
    const shown = label.detail.textContent!;
    if (shown !== detail && (this.count || !shown || !detail)) label.detail.textContent = detail;
    if (kind === "hand") y = this.clear(x, y, Labels.wide(text, detail));
    const place = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    if (label.place !== place) label.element.style.transform = label.place = place;
  }

  private make(key: string): Made {
    const element = document.createElement("div");
    const [text, detail] = [document.createElement("b"), document.createElement("span")];
    element.append(text, detail);
    this.element.append(element);
    const made = { element, text, detail, slot: -1, place: "" };
    this.made.set(key, made);
    return made;
  }

  /** Names stay readable: one that would lie on another goes above it. */
  private clear(x: number, y: number, wide: number): number {
    for (let tries = 0; tries < 6; tries++) {
      const under = this.taken.find((other) => x < other.x + other.wide && other.x < x + wide && Math.abs(y - other.y) < HIGH);
      if (!under) break;
      y = under.y - HIGH;
    }
    this.taken.push({ x, y, wide });
    return y;
  }

  sweep(): void {
    this.taken.length = 0;
    for (const [key, label] of this.made) {
      if (this.used.has(key)) continue;
      label.element.remove();
      this.made.delete(key);
    }
    this.used.clear();
    const now = performance.now();
    this.count = now - this.since >= READ;
    if (this.count) this.since = now;
  }
}
