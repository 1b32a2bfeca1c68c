/**
 * Makes the npm package: `node make_package.mjs MODULE VERSION SOURCES PACKAGE`, with the module of WebAssembly, the
 * version of the project, its sources and the folder that is to hold the package.
 */

import fs from "node:fs";
import path from "node:path";
import zlib from "node:zlib";

const [moduleFile, version, sources, folder] = process.argv.slice(2);

/** Of what is inside, and what is not: transforms by FFTW, the module of Python. */
const LICENSES = {
  LICENSE: "viscoroll.txt",
  "licenses/Eigen.txt": "Eigen.txt",
  "licenses/PocketFFT.txt": "PocketFFT.txt",
  "licenses/musl.txt": "musl.txt",
  "licenses/nlohmann-json.txt": "nlohmann-json.txt",
};

/** Fill in what a line of a source leaves empty: `"version": ""`, `const MODULE = "";`. */
function fill(name, entries) {
  const file = path.join(folder, name);
  let text = fs.readFileSync(file, "utf8");
  for (const [before, value] of Object.entries(entries)) {
    if (!text.includes(`${before}""`)) throw new Error(`${name} has no line ${before}""`);
    text = text.replace(`${before}""`, () => `${before}${JSON.stringify(value)}`);
  }
  fs.writeFileSync(file, text);
}

fs.rmSync(folder, { recursive: true, force: true });
fs.cpSync(path.join(import.meta.dirname, "package"), folder, { recursive: true });
fs.mkdirSync(path.join(folder, "licenses"));
for (const [from, to] of Object.entries(LICENSES)) {
  fs.copyFileSync(path.join(sources, from), path.join(folder, "licenses", to));
}

const described = /DESCRIPTION "(.*)"/.exec(fs.readFileSync(path.join(sources, "CMakeLists.txt"), "utf8"))[1];
fill("package.json", { '"version": ': version, '"description": ': described });
const module = fs.readFileSync(moduleFile);
const zipped = zlib.gzipSync(module, { level: zlib.constants.Z_BEST_COMPRESSION });
fill("viscoroll.single.js", { "const MODULE = ": zipped.toString("base64") });

const kilobytes = (bytes) => `${Math.round(bytes / 1e3)} kB`;
const single = fs.readFileSync(path.join(folder, "viscoroll.single.js"));
console.log(
  `viscoroll ${version}: ${kilobytes(module.length)} of WebAssembly, ${kilobytes(single.length)} as a script, ` +
    `${kilobytes(zlib.gzipSync(single).length)} of it to download`,
);
