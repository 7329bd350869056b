// Colours of users and of values: told apart by the colour-blind, in light and in dark.

// Okabe and Ito's palette, with brown and grey for the seventh and eighth.
const LIGHT = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8B6F47", "#6B7280"];
const DARK = ["#3D9FE0", "#F08438", "#2BC495", "#DE97BF", "#F2B73C", "#86CCF5", "#B3946A", "#9CA3AF"];
export const USER_COLOURS = { light: LIGHT, dark: DARK };

// Of bodies: paler than users, so that a hand or a copy is never taken for one.
const BODIES = ["#D8BE98", "#9DB4CE", "#B3C99C", "#D0A9C3", "#E3AF90", "#98CBC4", "#DDD394", "#BBB5AE"];

/** A body's colour as #rrggbb. @param number of the body, from 0 @param given what the file says, if anything */
export function bodyColour(number: number, given: string | null): string {
  return given ?? BODIES[number % BODIES.length]!;
}

// Perceptually uniform (viridis without its darkest end, so that form stays visible), as sRGB from none to most.
const RAMP = ["#414487", "#355F8D", "#2A788E", "#21908D", "#22A884", "#43BF71", "#7AD151", "#BBDF27", "#FDE725"];
export const RAMP_STOPS = RAMP;

export type Theme = "auto" | "light" | "dark";
const dim = typeof matchMedia === "function" ? matchMedia("(prefers-color-scheme: dark)") : null;

/** Whether a theme is a dark one here and now. */
export function isDark(theme: Theme): boolean {
  return theme === "dark" || (theme === "auto" && dim !== null && dim.matches);
}

/** Calls back when the system turns dark or light; returns what ends that. */
export function onSystemTheme(f: () => void): () => void {
  dim?.addEventListener("change", f);
  return () => dim?.removeEventListener("change", f);
}

/** A user's colour as #rrggbb. */
export function userColour(slot: number, dark: boolean): string {
  return (dark ? DARK : LIGHT)[slot % LIGHT.length]!;
}

/** Sets --user-0 … --user-7 and data-theme, from which the style sheet works. */
export function applyTheme(theme: Theme, root: HTMLElement = document.documentElement): void {
  const dark = isDark(theme);
  root.dataset.theme = dark ? "dark" : "light";
  root.style.colorScheme = dark ? "dark" : "light";
  for (let slot = 0; slot < LIGHT.length; slot++) root.style.setProperty(`--user-${slot}`, userColour(slot, dark));
}

/** The ramp at a share, as [r, g, b] of 0 to 255. */
export function ramp(share: number): [number, number, number] {
  const at = Math.min(Math.max(share, 0), 1) * (RAMP.length - 1);
  const low = Math.min(Math.floor(at), RAMP.length - 2);
  const [a, b] = [channels(RAMP[low]!), channels(RAMP[low + 1]!)];
  return [0, 1, 2].map((i) => a[i]! + (b[i]! - a[i]!) * (at - low)) as [number, number, number];
}

/** #rrggbb as numbers of 0 to 255. */
export function channels(hex: string): [number, number, number] {
  const value = parseInt(hex.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/** #rrggbb with an opacity, for canvases. */
export function alpha(hex: string, opacity: number): string {
  return `rgb(${channels(hex).join(" ")} / ${opacity})`;
}
