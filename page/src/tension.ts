// The colour of what is pulled at: from slack grey over amber to red.
const LIGHT = [[148, 158, 172], [232, 160, 30], [208, 48, 42]] as const;
const DARK = [[122, 133, 150], [245, 185, 66], [255, 107, 91]] as const;

/** @param share of the most that is shown, 0 to 1 @returns #rrggbb */
export function tension(share: number, dark: boolean): string {
  const stops = dark ? DARK : LIGHT;
  const at = Math.min(Math.max(share, 0), 1) / 0.4;
  const low = at < 1 ? 0 : 1;
  const mix = stops[low]!.map((value, i) => Math.round(value + (stops[low + 1]![i]! - value) * (low ? (at - 1) / 1.5 : at)));
  return `#${mix.map((value) => value.toString(16).padStart(2, "0")).join("")}`;
}
