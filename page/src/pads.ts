// A gamepad, where the browser knows one: a stick that moves the hand, and motors that tell its force.
const EVERY = 90; // ms between rumbles

export interface Pad {
  x: number;
  y: number;
  /** Away from the eye. */
  depth: number;
  pressed: boolean;
  released: boolean;
}

export class Pads {
  private held = false;
  private told = 0;

  /** What the first gamepad says; null without one. */
  read(): Pad | null {
    const pad = this.first();
    if (!pad) return null;
    const held = !!pad.buttons[0]?.pressed;
    const result = {
      x: pad.axes[0] ?? 0, y: pad.axes[1] ?? 0, depth: -(pad.axes[3] ?? 0),
      pressed: held && !this.held, released: !held && this.held,
    };
    this.held = held;
    return result;
  }

  /** @param force 0 to 1 */
  rumble(force: number): void {
    const now = performance.now();
    const motor = this.first()?.vibrationActuator;
    if (!motor || now - this.told < EVERY || force < 0.03) return;
    this.told = now;
    const strength = Math.min(force, 1);
    void motor
      .playEffect("dual-rumble", { duration: EVERY * 1.5, strongMagnitude: strength ** 2, weakMagnitude: strength })
      .catch(() => undefined);
  }

  private first(): Gamepad | null {
    try {
      return navigator.getGamepads?.().find((pad) => pad?.connected) ?? null;
    } catch {
      return null; // a page without permission for gamepads has none
    }
  }
}
