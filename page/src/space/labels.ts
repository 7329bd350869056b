// Names over the picture, as text that stays sharp.
export class Labels {
  readonly element = document.createElement("div");
  private readonly made = new Map<string, HTMLElement>();
  private readonly used = new Set<string>();

  constructor(parent: HTMLElement) {
    this.element.className = "ct-labels";
    this.element.setAttribute("aria-hidden", "true");
    parent.append(this.element);
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
    label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  }

  sweep(): void {
    for (const [key, label] of this.made) {
      if (this.used.has(key)) continue;
      label.remove();
      this.made.delete(key);
    }
    this.used.clear();
  }
}
