// An animation's page: state, controls, and what is written around the picture.
import { RAMP_STOPS } from "../colours";
import { bounds, Chart, HUES } from "./chart.js";
import { num, prefixed, round, unpacked } from "./data.js";
import { follow } from "./pointing";
import { Shown } from "./shown";

/** @typedef {import("./data.js").Run} Run */
/** @typedef {import("./shown").Tile} Tile */

/** @typedef {"ghosts" | "side" | "alone"} View */

/** @template {HTMLElement} T @param {string} id @returns {T} */
function element(id) {
  return /** @type {T} */ (document.getElementById(id));
}

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2, 4];
const TOPS = [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];
const GAP = 1; // pixels between tiles
const SLOW = 0.07; // seconds between pictures from which on they become coarser
const [PLAY, PAUSE] = ["M6 3.5v13l11-6.5z", "M5 4h3.6v12H5zM11.4 4H15v12h-3.6z"].map((d) => `<svg viewBox="0 0 20 20"><path d="${d}"/></svg>`);

/** A new element in another. @param {Element} parent @param {string} kind @param {Record<string, string>} attributes @param {string} text */
function add(parent, kind, attributes = {}, text = "") {
  const svg = parent.namespaceURI?.endsWith("svg");
  const made = /** @type {HTMLElement} */ (svg ? document.createElementNS("http://www.w3.org/2000/svg", kind) : document.createElement(kind));
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.textContent = text;
  parent.append(made);
  return made;
}

class App {
  /** @param {Run} run */
  constructor(run) {
    this.run = run;
    this.scene = new Shown(/** @type {HTMLCanvasElement} */ (element("picture")), run);
    this.orbit = this.scene.orbit;
    this.at = 0; // the moment, in frames
    this.playing = false;
    this.speed = 1;
    this.user = 0;
    this.view = /** @type {View} */ (run.users > 1 ? "ghosts" : "alone");
    /** What colours may show. @type {("bodies" | "displacement" | "difference")[]} */
    this.fields = [];
    if (run.header.parts.length) this.fields.push("bodies");
    this.fields.push("displacement");
    if (run.header.peaks.difference > 0) this.fields.push("difference");
    this.field = this.fields[0];
    this.shown = 0; // which series
    this.moved = true; // the moment or the colouring is another
    this.stale = true; // the picture is
    this.last = 0;
    this.pace = 0; // mean time between pictures [s]
    this.quality = 1; // share of the pixels' density while playing: less where there is no graphics card
    this.help = /** @type {HTMLDialogElement} */ (element("help"));
    /** Largest size in every series, and what its numbers are divided by for their unit. */
    this.mosts = run.series.map(({ values }) => Math.max(...bounds(Array.from(values).filter(Number.isFinite)).map(Math.abs)));
    this.units = run.series.map(({ unit }, k) => prefixed(this.mosts[k], unit));
    this.chart = new Chart(element("chart"), run, (at) => this.seek(at));
    this.build();
    follow(element("picture"), this.orbit, () => this.tiles()[0].height, () => (this.stale = true));
    new ResizeObserver(() => this.resized()).observe(element("stage"));
    new ResizeObserver(() => this.resized()).observe(element("chart"));
    const dark = matchMedia("(prefers-color-scheme: dark)");
    dark.addEventListener("change", () => this.theme(dark.matches));
    this.theme(dark.matches);
    this.play(run.frames > 1 && !matchMedia("(prefers-reduced-motion: reduce)").matches);
    requestAnimationFrame((now) => this.tick(now));
  }

  build() {
    const { run } = this, { users, links } = run.header;
    /** @param {number} count @param {string} one @param {string} many */
    const counted = (count, one, many) => `${count} ${count === 1 ? one : many}`;
    const size = run.triangles.length ? counted(run.vertices, "vertex", "vertices") : counted(run.vertices, "node", "nodes");
    element("facts").textContent = `${counted(run.users, "user", "users")} · ${size} each · ${counted(run.frames, "frame", "frames")}`;
    /** @param {string} id @param {() => void} action */
    const press = (id, action) => element(id).addEventListener("click", action);
    addEventListener("click", (event) => {
      const target = /** @type {Element} */ (event.target);
      if (event.detail) /** @type {HTMLElement | null} */ (target.closest("button"))?.blur(); // keys belong to the page again
    });
    press("play", () => this.play(!this.playing));
    press("theme", () => this.theme(!this.dark));
    press("ask", () => this.help.showModal());
    press("field", () => this.recolour());
    element("views").hidden = run.users < 2;
    for (const button of element("views").querySelectorAll("button"))
      button.addEventListener("click", () => this.show(/** @type {View} */ (button.dataset.view)));
    const speed = /** @type {HTMLSelectElement} */ (element("speed"));
    for (const value of SPEEDS) add(speed, "option", { value: String(value) }, `${value} ×`);
    speed.addEventListener("change", () => {
      this.hurry(Number(speed.value));
      speed.blur();
    });
    run.series.forEach((series, k) => {
      if (run.series.length > 1)
        add(element("series"), "button", {}, series.name).addEventListener("click", () => this.plot(k));
    });
    element("series").hidden = run.series.length < 2;
    element("chart").classList.toggle("bare", !run.series.length);
    this.table(users);
    this.network(links, users);
    element("bar").style.background = `linear-gradient(90deg, ${RAMP_STOPS.join()})`;
    const field = /** @type {HTMLButtonElement} */ (element("field"));
    field.disabled = this.fields.length < 2;
    addEventListener("keydown", (event) => this.key(event));
  }

  /** @param {string[]} users */
  table(users) {
    const table = element("users"), head = add(add(table, "thead"), "tr"), body = add(table, "tbody");
    add(head, "th", { scope: "col" }, "");
    this.run.series.forEach(({ name }, k) => {
      const cell = add(head, "th", { scope: "col" }, name);
      cell.append(document.createElement("br"), this.units[k][1]);
    });
    this.rows = users.map((name, user) => {
      const row = add(body, "tr", { style: `--own: ${this.color(user)}` }), cell = add(row, "td"), button = add(cell, "button");
      add(button, "span", { class: "swatch" });
      button.append(name);
      row.addEventListener("click", () => this.choose(user));
      const cells = this.run.series.map(() => add(row, "td"));
      const meter = cells.length ? add(cell, "span", { class: "meter" }) : undefined;
      return { row, cells, meter };
    });
  }

  /** Who is joined to whom. @param {[number, number][]} links @param {string[]} users */
  network(links, users) {
    element("network").hidden = !links.length;
    const svg = /** @type {SVGElement} */ (element("network").querySelector("svg"));
    svg.setAttribute("aria-label", links.map(([a, b]) => `${users[a]} and ${users[b]}`).join(", "));
    const places = users.map((_, k) => {
      const angle = (2 * Math.PI * k) / users.length;
      return [34 * Math.sin(angle), -34 * Math.cos(angle)];
    });
    for (const [a, b] of links)
      add(svg, "line", { x1: String(places[a][0]), y1: String(places[a][1]), x2: String(places[b][0]), y2: String(places[b][1]) });
    places.forEach(([x, y], user) => {
      add(svg, "circle", { cx: String(x), cy: String(y), r: "4.5", fill: this.color(user) });
      add(svg, "text", { x: String(x + 0.24 * x), y: String(1.26 * y + 2.5), "text-anchor": Math.abs(x) < 9 ? "middle" : x > 0 ? "start" : "end" }, users[user]);
    });
  }

  /** @param {number} user */
  color(user) {
    return `var(--user-${(user % HUES) + 1})`;
  }

  /** @param {boolean} dark */
  theme(dark) {
    this.dark = dark;
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    const style = getComputedStyle(document.documentElement);
    /** @param {string} name */
    const read = (name) => style.getPropertyValue(`--${name}`).trim();
    this.colors = {
      ink: read("ink"), muted: read("muted"), grid: read("grid"), surface: read("surface"),
      users: this.run.header.users.map((_, user) => read(`user-${(user % HUES) + 1}`)),
    };
    this.scene.paint(this.colors.users, dark);
    this.resized();
  }

  resized() {
    this.chart.stale = this.stale = true;
  }

  /** @param {boolean} on */
  play(on) {
    if (on && this.at >= this.run.frames - 1) this.seek(0);
    this.playing = on;
    this.stale = true; // at rest a picture has all its pixels
    const button = element("play");
    button.innerHTML = on ? PAUSE : PLAY;
    button.setAttribute("aria-label", on ? "Pause" : "Play");
  }

  /** @param {number} at */
  seek(at) {
    this.at = Math.max(0, Math.min(this.run.frames - 1, at));
    this.moved = true;
  }

  /** @param {View} view */
  show(view) {
    if (this.run.users < 2) return;
    this.view = view;
    this.moved = true;
  }

  /** @param {number} user */
  choose(user) {
    this.user = user;
    if (this.view === "side") this.view = "alone";
    this.moved = true;
    this.resized();
  }

  /** @param {number} speed */
  hurry(speed) {
    this.speed = speed;
    this.stale = true;
  }

  /** @param {number} index of a series */
  plot(index) {
    this.shown = index;
    this.resized();
  }

  recolour() {
    if (/** @type {HTMLButtonElement} */ (element("field")).disabled) return;
    this.field = this.fields[(this.fields.indexOf(this.field) + 1) % this.fields.length];
    this.moved = true;
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const target = /** @type {HTMLElement} */ (event.target);
    if (event.ctrlKey || event.metaKey || event.altKey || this.help.open || target.tagName === "SELECT") return;
    if (target.tagName === "BUTTON" && [" ", "Enter"].includes(event.key)) return;
    const step = event.shiftKey ? 10 : 1, faster = SPEEDS.indexOf(this.speed);
    /** @type {Record<string, () => void>} */
    const keys = {
      " ": () => this.play(!this.playing),
      ArrowLeft: () => this.step(-step), ArrowRight: () => this.step(step),
      Home: () => this.step(-Infinity), End: () => this.step(Infinity),
      ArrowUp: () => this.hurry(SPEEDS[Math.min(faster + 1, SPEEDS.length - 1)]),
      ArrowDown: () => this.hurry(SPEEDS[Math.max(faster - 1, 0)]),
      g: () => this.show("ghosts"), s: () => this.show("side"), a: () => this.show("alone"),
      c: () => this.recolour(), t: () => this.theme(!this.dark), "?": () => this.help.showModal(),
      r: () => { this.orbit.reset(); this.orbit.step(1); this.stale = true; },
    };
    const action = keys[event.key.length > 1 ? event.key : event.key.toLowerCase()];
    if (action) action();
    else if (/^[1-9]$/.test(event.key) && Number(event.key) <= this.run.users) this.choose(Number(event.key) - 1);
    else return;
    event.preventDefault();
  }

  /** To a whole frame, and stay there. @param {number} frames */
  step(frames) {
    this.play(false);
    this.seek(frames > 0 ? Math.floor(this.at + 1e-6) + frames : Math.ceil(this.at - 1e-6) + frames);
  }

  /** @param {number} now [ms] */
  tick(now) {
    const passed = Math.min((now - this.last) / 1000, 0.25);
    this.last = now;
    if (this.playing) this.pace += 0.25 * (passed - this.pace);
    if (this.pace > SLOW && this.quality > 0.5) [this.quality, this.pace] = [0.7 * this.quality, 0];
    if (this.playing && passed > 0) {
      const end = this.run.time[this.run.frames - 1], time = this.run.timeAt(this.at) + passed * this.speed;
      this.seek(this.at >= this.run.frames - 1 ? 0 : time >= end ? this.run.frames - 1 : this.run.momentAt(time));
    }
    if (this.moved || this.stale) this.draw();
    requestAnimationFrame((next) => this.tick(next));
  }

  /** @returns {Tile[]} */
  tiles() {
    const { clientWidth: width, clientHeight: height } = element("stage");
    const all = Array.from({ length: this.run.users }, (_, user) => user);
    if (this.view !== "side")
      return [{
        x: 0, y: 0, width, height, solid: this.user,
        ghosts: this.view === "ghosts" ? all.filter((user) => user !== this.user) : [], users: this.view === "ghosts" ? all : [this.user],
      }];
    const columns = all.map((k) => k + 1).sort((a, b) => this.side(b, width, height) - this.side(a, width, height))[0];
    const rows = Math.ceil(all.length / columns), w = (width - (columns - 1) * GAP) / columns, h = (height - (rows - 1) * GAP) / rows;
    return all.map((user) => ({ x: (user % columns) * (w + GAP), y: Math.floor(user / columns) * (h + GAP), width: w, height: h, solid: user, ghosts: [], users: [user] }));
  }

  /** Shorter side of a tile in a table of so many columns. @param {number} columns @param {number} width @param {number} height */
  side(columns, width, height) {
    return Math.min(width / columns, height / Math.ceil(this.run.users / columns));
  }

  draw() {
    const { run, scene, colors } = this;
    if (!colors) return;
    const ratio = Math.min(devicePixelRatio, 2) * (this.playing ? this.quality : 1), stage = element("stage");
    const peak = this.field === "bodies" ? 0 : run.header.peaks[this.field], top = peak > 0 ? ceiling(peak) : 0, tiles = this.tiles();
    if (this.moved) scene.move(this.at, this.field, top, this.user);
    scene.draw(tiles, Math.max(1, stage.clientWidth), Math.max(1, stage.clientHeight), ratio);
    if (this.chart.stale) this.chart.sketch(run.series[this.shown], colors, this.user);
    this.chart.show(run.timeAt(this.at), colors);
    this.write(top);
    this.label(tiles);
    this.moved = this.stale = false;
  }

  /** All that is text and not in the picture. @param {number} top of the colours [m] */
  write(top) {
    const { run } = this, end = run.time[run.frames - 1], digits = Math.max(0, Math.min(6, 3 - Math.floor(Math.log10(end - run.time[0] || 1))));
    const time = run.timeAt(this.at).toFixed(digits);
    element("clock").innerHTML = `${time} <small>/ ${end.toFixed(digits)} s</small>`;
    const chart = element("chart");
    chart.setAttribute("aria-valuemax", String(run.frames - 1));
    chart.setAttribute("aria-valuenow", String(Math.round(this.at)));
    chart.setAttribute("aria-valuetext", `${time} s`);
    /** @type {HTMLSelectElement} */ (element("speed")).value = String(this.speed);
    for (const button of element("views").querySelectorAll("button")) button.setAttribute("aria-pressed", String(button.dataset.view === this.view));
    [...element("series").children].forEach((button, k) => button.setAttribute("aria-pressed", String(k === this.shown)));
    const frame = Math.min(Math.round(this.at), run.frames - 1);
    this.rows?.forEach(({ row, cells, meter }, user) => {
      row.setAttribute("aria-selected", String(this.view !== "side" && user === this.user));
      cells.forEach((cell, k) => (cell.textContent = this.reading(k, frame, user)));
      const series = run.series[this.shown];
      if (meter && series) meter.style.setProperty("--share", `${(100 * Math.abs(series.values[frame * run.users + user])) / (this.mosts[this.shown] || 1)}%`);
    });
    const [factor, unit] = prefixed(top, "m"), name = { bodies: "Bodies", displacement: "Displacement", difference: "Distance from the mean copy" }[this.field];
    const bare = this.field === "bodies";
    element("field").innerHTML = bare ? name : `${name} <small>/ ${unit}</small>`;
    element("bar").style.visibility = bare ? "hidden" : "visible";
    element("ticks").innerHTML = bare ? "" : top > 0 ? [0, 0.5, 1].map((share) => `<span>${num((share * top) / factor)}</span>`).join("") : "<span>0</span>";
  }

  /** A value of a series as text. @param {number} k @param {number} frame @param {number} user */
  reading(k, frame, user) {
    const value = this.run.series[k].values[frame * this.run.users + user] / this.units[k][0], most = this.mosts[k] / this.units[k][0];
    if (!Number.isFinite(value)) return "–";
    return most >= 1e4 || most < 1e-2 ? num(value) : value.toFixed(most >= 99.95 ? 0 : most >= 9.995 ? 1 : 2).replace("-", "−");
  }

  /** Names in the picture, and the scales, which follow the zoom. @param {Tile[]} tiles */
  label(tiles) {
    const { scene, orbit, run } = this, { peak, metresPerNewton, pitch, radius } = scene.sizes, labels = element("labels"), names = run.header.users;
    labels.textContent = "";
    const last = tiles[tiles.length - 1];
    element("legend").className = last.x + 1.5 * last.width < element("stage").clientWidth ? "beside" : "";
    const pixel = orbit.metres(tiles[0].height);
    const force = peak > 0 ? round(Math.min(peak, (90 * pixel) / metresPerNewton)) : 0;
    const length = (force * metresPerNewton) / pixel, [factor, unit] = prefixed(force, "N"), [metre, metres] = prefixed(pitch, "m");
    element("arrow").innerHTML = force && length < 140
      ? `<svg width="${length + 2}" viewBox="0 0 ${length + 2} 9" aria-hidden="true"><path d="M0 4.5H${Math.max(length - 8, 0)}" stroke="currentColor" stroke-width="2"/><path d="M${length - 9} .5 ${length} 4.5 ${length - 9} 8.5z" fill="currentColor"/></svg>${num(force / factor)} ${unit}` : "";
    element("pitch").textContent = pitch ? `grid ${num(pitch / metre)} ${metres}` : "";
    if (this.view === "side") {
      const frame = Math.min(Math.round(this.at), run.frames - 1), force = scene.sizes.peak > 0;
      for (const { x, y, width, height, solid } of tiles) {
        const tile = add(labels, "span", { class: "tile", style: `left:${x + 12}px;top:${y + 8}px;--own:${this.color(solid)}` });
        add(tile, "span", { class: "swatch", style: "position:static" });
        tile.append(names[solid]);
        if (force) add(tile, "b", {}, `${this.reading(0, frame, solid)} ${this.units[0][1]}`);
        if (x > 0) add(labels, "i", { style: `left:${x - GAP}px;top:${y}px;width:${GAP}px;height:${height}px` });
        if (y > 0) add(labels, "i", { style: `left:${x}px;top:${y - GAP}px;width:${width}px;height:${GAP}px` });
      }
      return;
    }
    const { width, height, users } = tiles[0];
    /** @type {[number, number, number, number][]} */
    const taken = [];
    for (const touch of scene.touches)
      touch.owner.forEach((user, k) => {
        if (!users.includes(user)) return;
        const place = [...touch.place.subarray(3 * k, 3 * k + 3)], [x, y] = scene.seen(place, width, height);
        const [tipX, tipY] = scene.seen(place.map((p, d) => p + metresPerNewton * touch.force[3 * k + d]), width, height);
        const away = (touch.radius[k] || 0.042 * radius) / pixel + 3;
        const name = add(labels, "span", { class: "name", style: `color:${this.color(user)}` }, names[user]);
        const w = name.offsetWidth, h = name.offsetHeight;
        // Beside an upright arrow, on the outer side of others; elsewhere, or left away, where another name stands.
        const sides = [[x + away, y - h / 2], [x - away - w, y - h / 2]], ends = [[x - w / 2, y + away], [x - w / 2, y - away - h]];
        if (y < height / 2) ends.reverse();
        const order = Math.abs(tipY - y) > Math.abs(tipX - x) ? [...sides, ...ends] : [...ends, ...sides];
        const free = order.find(([left, top]) => taken.every(([l, t, r, b]) => left > r || left + w < l || top > b || top + h < t));
        if (!free) return name.remove();
        name.style.left = `${free[0]}px`;
        name.style.top = `${free[1]}px`;
        taken.push([free[0], free[1], free[0] + w, free[1] + h]);
      });
  }
}

/** A number to end a scale with, not below another. @param {number} value */
function ceiling(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return (TOPS.find((top) => top * power >= value * 0.9999) ?? 10) * power;
}

/** @param {string} sentence */
function fail(sentence) {
  element("notice").hidden = false;
  element("notice").className = "failed";
  element("notice").textContent = sentence;
}

async function start() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return fail("This animation needs WebGL 2, which this browser lacks or has disabled. Any current browser with graphics acceleration can show it.");
  if (!("DecompressionStream" in window)) return fail("This browser is too old to unpack the animation; any browser from 2023 or later can.");
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  const app = new App(await unpacked());
  element("notice").hidden = true;
  element("picture").addEventListener("webglcontextlost", () => fail("The graphics context was lost; reload the page."));
  // For whoever drives the page from outside: a film, a test, a talk.
  Object.assign(window, {
    cotouch: {
      get state() {
        const { at, playing, speed, view, user, field, dark } = app;
        return { frame: at, time: app.run.timeAt(at), frames: app.run.frames, playing, speed, view, user, field, dark };
      },
      /** @param {number} frame */
      seek: (frame) => (app.play(false), app.seek(frame)),
      /** @param {View} view */
      show: (view) => app.show(view),
      /** @param {boolean} on */
      play: (on) => app.play(on),
      /** Where a place is seen, from the left and top of its picture [pixels]. @param {number[]} place [m] */
      seen: (place) => app.scene.seen(place, app.tiles()[0].width, app.tiles()[0].height),
      /** Places of a user's copy now, as drawn [m]. @param {number} user */
      copy: (user) => Array.from(app.scene.places[user]),
    },
  });
}

start().catch((error) => {
  fail(`The animation cannot be shown: ${error.message}`);
  throw error;
});
