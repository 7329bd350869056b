// Puts the page's sources, and the animation's, into the Python package: src/cotouch/web/static and
// src/cotouch/simulation/_viewer. `npm run build`, or with --watch.
import { createHash } from "node:crypto";
import { cp, mkdir, readdir, readFile, writeFile } from "node:fs/promises";
import { gzipSync } from "node:zlib";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import * as esbuild from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const packages = join(here, "..", "src", "cotouch");
const out = join(packages, "web", "static");
const watch = process.argv.includes("--watch");
const LIBRARIES = ["three", "uplot"]; // what the bundle contains

/** The files that decide what the bundle is, by path; tests/web/test_bundle.py reads the same. */
async function sources() {
  const found = (await readdir(join(here, "src"), { recursive: true, withFileTypes: true }))
    .filter((entry) => entry.isFile())
    .map((entry) => relative(here, join(entry.parentPath, entry.name)).replaceAll("\\", "/"));
  return [...found, "build.mjs", "index.html", "package-lock.json", "tsconfig.json"].sort();
}

async function hash() {
  const digest = createHash("sha256");
  for (const path of await sources()) {
    digest.update(`${path}\0`).update(await readFile(join(here, path))).update("\0");
  }
  return digest.digest("hex");
}

async function licences() {
  const parts = ["Licences of the libraries in app.js and app.css.\n"];
  for (const name of LIBRARIES) {
    const folder = join(here, "node_modules", name);
    const { version, license } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
    parts.push(`\n== ${name} ${version} (${license}) ==\n\n${(await readFile(join(folder, "LICENSE"), "utf8")).trim()}\n`);
  }
  return parts.join("");
}

/** What is not worked out by esbuild: the page itself, its icon, and what the bundle contains. */
async function rest() {
  await cp(join(here, "index.html"), join(out, "index.html"));
  await cp(join(here, "src", "favicon.svg"), join(out, "favicon.svg"));
  await writeFile(join(out, "licences.txt"), await licences());
  await writeFile(join(out, "sources.txt"), `${await hash()}\n`);
  const sizes = await Promise.all(
    ["index.html", "app.js", "app.css"].map(async (name) => gzipSync(await readFile(join(out, name)), { level: 9 }).length),
  );
  console.log(`${sizes.map((size) => (size / 1000).toFixed(1)).join(" + ")} kB compressed`);
}

const banner = `/*! cotouch page; sources ${await hash()}; licences of what it contains: licences.txt */`;
const options = {
  absWorkingDir: here,
  entryPoints: { app: "src/main.ts" },
  outdir: out,
  bundle: true,
  minify: true,
  format: "esm",
  target: ["es2022"],
  charset: "utf8",
  legalComments: "none",
  banner: { js: banner, css: banner },
  logLevel: "warning",
  plugins: [{ name: "rest", setup: (build) => build.onEnd((result) => (result.errors.length ? undefined : rest())) }],
};

// An animation is one file with this inside, which nothing can be served beside: it holds the licence itself.
const three = (await readFile(join(here, "node_modules", "three", "LICENSE"), "utf8")).trim();
const animation = {
  ...options,
  entryPoints: { animation: "src/animation/app.js" },
  outdir: join(packages, "simulation", "_viewer"),
  banner: { js: `/*! cotouch animation; sources ${await hash()}; with three.js:\n${three}\n*/` },
  plugins: [],
};

await mkdir(out, { recursive: true });
for (const one of [animation, options]) {
  if (watch) await (await esbuild.context(one)).watch();
  else await esbuild.build(one);
}
