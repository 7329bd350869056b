// How rails, sliders, springs and marks look; knows nothing of what they mean.
import { alpha, channels } from "../colours";

export interface Ink {
  text: string;
  soft: string;
  rail: string;
  line: string;
  paper: string;
  dark: boolean;
}

export const INK: Record<"light" | "dark", Ink> = {
  light: { text: "#1b2330", soft: "#55606f", rail: "#d3dae4", line: "rgb(27 35 48 / 0.09)", paper: "#ffffff", dark: false },
  dark: { text: "#eef1f5", soft: "#a7b0bd", rail: "#3a424f", line: "rgb(255 255 255 / 0.08)", paper: "#171b22", dark: true },
};

type Pen = CanvasRenderingContext2D;

export function text(pen: Pen, words: string, x: number, y: number, style: { size: number; weight?: number; colour: string; align?: CanvasTextAlign }): void {
  pen.font = `${style.weight ?? 400} ${style.size}px system-ui, sans-serif`;
  pen.fillStyle = style.colour;
  pen.textAlign = style.align ?? "left";
  pen.textBaseline = "middle";
  pen.fillText(words, x, y);
}

export function rail(pen: Pen, left: number, right: number, y: number, width: number, colour: string): void {
  pen.lineCap = "round";
  pen.lineWidth = width;
  pen.strokeStyle = colour;
  pen.beginPath();
  pen.moveTo(left, y);
  pen.lineTo(right, y);
  pen.stroke();
}

/** A slider's knob: a disc with a light rim, a soft shadow and three grooves. */
export function knob(pen: Pen, x: number, y: number, radius: number, colour: string, ink: Ink, strong: boolean): void {
  pen.save();
  pen.shadowColor = ink.dark ? "rgb(0 0 0 / 0.55)" : "rgb(20 30 50 / 0.28)";
  pen.shadowBlur = strong ? 14 : 8;
  pen.shadowOffsetY = strong ? 4 : 2;
  pen.fillStyle = ink.dark ? "#f3f5f8" : "#ffffff";
  disc(pen, x, y, radius);
  pen.restore();
  const [r, g, b] = channels(colour);
  const shine = pen.createLinearGradient(x, y - radius, x, y + radius);
  shine.addColorStop(0, `rgb(${[r, g, b].map((c) => Math.round(c + (255 - c) * 0.22)).join(" ")})`);
  shine.addColorStop(1, colour);
  pen.fillStyle = shine;
  disc(pen, x, y, radius - 2.5);
  pen.strokeStyle = "rgb(255 255 255 / 0.75)";
  pen.lineWidth = 1.5;
  pen.lineCap = "round";
  pen.beginPath();
  for (const dx of [-0.22, 0, 0.22]) {
    pen.moveTo(x + dx * radius, y - 0.3 * radius);
    pen.lineTo(x + dx * radius, y + 0.3 * radius);
  }
  pen.stroke();
}

export function disc(pen: Pen, x: number, y: number, radius: number): void {
  pen.beginPath();
  pen.arc(x, y, Math.max(radius, 0), 0, 2 * Math.PI);
  pen.fill();
}

export function ring(pen: Pen, x: number, y: number, radius: number, colour: string, width = 2): void {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.stroke();
}

/** Where somebody is believed to be: a small diamond with a dot's worth of paper around it. */
export function belief(pen: Pen, x: number, y: number, size: number, colour: string, ink: Ink): void {
  pen.beginPath();
  pen.moveTo(x, y - size);
  pen.lineTo(x + size, y);
  pen.lineTo(x, y + size);
  pen.lineTo(x - size, y);
  pen.closePath();
  pen.fillStyle = ink.paper;
  pen.fill();
  pen.fillStyle = alpha(colour, 0.35);
  pen.fill();
  pen.strokeStyle = colour;
  pen.lineWidth = 1.75;
  pen.lineJoin = "round";
  pen.stroke();
}

export function arrow(pen: Pen, x: number, y: number, length: number, colour: string): void {
  if (Math.abs(length) < 5) return;
  const way = Math.sign(length);
  pen.strokeStyle = pen.fillStyle = colour;
  pen.lineWidth = 3;
  pen.lineCap = "butt";
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(x + length - 7 * way, y);
  pen.stroke();
  pen.beginPath();
  pen.moveTo(x + length, y);
  pen.lineTo(x + length - 9 * way, y - 5);
  pen.lineTo(x + length - 9 * way, y + 5);
  pen.fill();
}

export function rope(pen: Pen, from: number, to: number, y: number, width: number, colour: string): void {
  rail(pen, from, to, y, width, colour);
}

/** A spring between two knobs; long ways bend aside, so that none lies on another. @param stretch from 0 to 1 */
export function spring(pen: Pen, ax: number, ay: number, bx: number, by: number, bend: number, stretch: number, colour: string, broken: boolean, still: boolean): void {
  const mx = (ax + bx) / 2 + 2 * bend, my = (ay + by) / 2;
  const length = Math.hypot(bx - ax, by - ay) + Math.abs(bend);
  pen.strokeStyle = colour;
  pen.lineJoin = "round";
  pen.lineCap = "round";
  pen.lineWidth = 1.8 + 1.6 * stretch;
  pen.setLineDash(broken ? [2, 7] : []);
  pen.beginPath();
  const turns = Math.max(4, Math.round(length / 15));
  const steps = broken ? 24 : turns * 10;
  const swing = broken || still ? 0 : 6.5 * (1 - 0.45 * stretch);
  for (let i = 0; i <= steps; i++) {
    const t = i / steps, s = 1 - t;
    let x = s * s * ax + 2 * s * t * mx + t * t * bx, y = s * s * ay + 2 * s * t * my + t * t * by;
    const dx = 2 * s * (mx - ax) + 2 * t * (bx - mx), dy = 2 * s * (my - ay) + 2 * t * (by - my);
    const size = Math.hypot(dx, dy) || 1;
    // The ends run out straight, as of a real spring.
    const end = Math.min(1, Math.max(0, (Math.min(t, s) * length - 16) / 14));
    const wave = swing * end * Math.sin(t * turns * 2 * Math.PI);
    x += (-dy / size) * wave;
    y += (dx / size) * wave;
    if (i) pen.lineTo(x, y);
    else pen.moveTo(x, y);
  }
  pen.stroke();
  pen.setLineDash([]);
}
