// Names over the picture, as text that stays sharp.
const HIGH = 24; // of a hand's name, with what is between two [pixels]
const LETTER = 7.1;

export class Labels {
  readonly element = document.createElement("div");
  private readonly taken: { x: number; y: number; wide: number }[] = [];
  private readonly made = new Map<string, HTMLElement>();
  private readonly used = new Set<string>();

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
  put(key: string, kind: string, seat: number, text: string, detail: string, x: number, y: number): void {
    let label = this.made.get(key);
    if (!label) {
      label = document.createElement("div");
      label.append(document.createElement("b"), document.createElement("span"));
      this.made.set(key, label);
      this.element.append(label);
    }
    this.used.add(key);
    const name = `ct-label ct-${kind}`;
    if (label.className !== name) label.className = name;
    label.style.setProperty("--user", `var(--user-${seat % 8})`);
    const [b, span] = label.children as unknown as [HTMLElement, HTMLElement];
    if (b.textContent !== text) b.textContent = text;
    if (span.textContent !== detail) span.textContent = detail;
    if (kind === "hand") y = this.clear(x, y, Labels.wide(text, detail));
    label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
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
      label.remove();
      this.made.delete(key);
    }
    this.used.clear();
  }
}
