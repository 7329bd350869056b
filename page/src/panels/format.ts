/** Numbers as people write them: units with a narrow space, a true minus, no more digits than count. */

const NARROW = "\u202f";
const MINUS = "\u2212";
export const NONE = "–";

function fixed(value: number, digits: number): string {
  const written = Math.abs(value).toFixed(digits);
  return value < 0 && Number(written) !== 0 ? MINUS + written : written;
}

/** With so many digits after the point; "–" if there is no number. */
export function number(value: number | null | undefined, digits = 0): string {
  return value === null || value === undefined || !Number.isFinite(value) ? NONE : fixed(value, digits);
}

const PREFIXES: readonly [number, string][] = [
  [1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"], [1e-12, "p"],
];

/** Three digits that count, with the prefix that fits: 0.0123 J is 12.3 mJ. Below `floor` it is 0. */
export function si(value: number | null | undefined, unit: string, floor = 0): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return NONE;
  const size = Math.abs(value);
  if (size <= floor || size < 1e-15) return `0${NARROW}${unit}`;
  const [scale, prefix] = PREFIXES.find(([s]) => size >= s * 0.9995) ?? [1e-12, "p"];
  const scaled = value / scale;
  const digits = Math.abs(scaled) >= 99.95 ? 0 : Math.abs(scaled) >= 9.995 ? 1 : 2;
  return `${fixed(scaled, digits)}${NARROW}${prefix}${unit}`;
}

/** A force; below a millinewton it is called 0. */
export function newtons(value: number | null | undefined): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return NONE;
  return Math.abs(value) < 10 ? `${fixed(value, 2)}${NARROW}N` : `${fixed(value, 1)}${NARROW}N`;
}

/** Seconds in milliseconds below one second. */
export function ms(seconds: number | null | undefined): string {
  if (seconds === null || seconds === undefined || !Number.isFinite(seconds)) return NONE;
  const size = Math.abs(seconds);
  if (size >= 0.9995) return `${fixed(seconds, 2)}${NARROW}s`;
  return `${fixed(seconds * 1e3, size < 0.00995 ? 1 : 0)}${NARROW}ms`;
}

/** A share in per cent. */
export function percent(share: number | null | undefined, digits?: number): string {
  if (share === null || share === undefined || !Number.isFinite(share)) return NONE;
  const value = share * 100;
  const size = Math.abs(value);
  return `${fixed(value, digits ?? (size === 0 || size >= 9.95 ? 0 : 1))}${NARROW}%`;
}

/** Metres in millimetres, or centimetres above 10 cm. */
export function lengthOf(metres: number | null | undefined): string {
  if (metres === null || metres === undefined || !Number.isFinite(metres)) return NONE;
  return Math.abs(metres) < 0.1 ? `${fixed(metres * 1e3, 1)}${NARROW}mm` : `${fixed(metres * 100, 1)}${NARROW}cm`;
}

/** Steps, samples per second. */
export function hertz(value: number | null | undefined): string {
  return value === null || value === undefined ? NONE : `${fixed(value, 0)}${NARROW}Hz`;
}

/** Minutes and seconds. */
export function clock(seconds: number): string {
  const whole = Math.max(0, Math.floor(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** A large count, in groups of three. */
export function count(value: number): string {
  return String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, NARROW);
}

/** "2–4": users are numbered from 1 on the page. */
export function linkName(a: number, b: number): string {
  return `${Math.min(a, b) + 1}–${Math.max(a, b) + 1}`;
}
