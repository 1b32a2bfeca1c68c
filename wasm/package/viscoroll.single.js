/**
 * The library in one classic script, which may run in a page, in a worker and in node, from http: as from file:
 * addresses. It sets `viscoroll`, whose functions viscoroll.d.ts describes; viscoroll.js exports them.
 */
(() => {
  "use strict";

  /** The module of WebAssembly: zipped, as base64. */
  const MODULE = "";

  /** What a system says to calls that it does not know [errno of WASI]. */
  const NOT_SUPPORTED = 52;

  /** Where a process of WASI writes why it ends. */
  const STANDARD_ERROR = 2;

  async function unzipped(base64) {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
  }

  /** The little that the library wants of a system: the time, which it tells its observers, and to say why it ends. */
  function system(memory) {
    const view = () => new DataView(memory());
    return {
      clock_time_get(_clock, _precision, to) {
        view().setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
      fd_write(file, parts, count, written) {
        let [text, length] = ["", 0];
        for (let part = parts; part < parts + 8 * count; part += 8) {
          const bytes = new Uint8Array(memory(), view().getUint32(part, true), view().getUint32(part + 4, true));
          text += new TextDecoder().decode(bytes);
          length += bytes.length;
        }
        if (file === STANDARD_ERROR) console.error(text);
        view().setUint32(written, length, true);
        return 0;
      },
      proc_exit(code) {
        throw new Error(`viscoroll ended with ${code}`);
      },
    };
  }

  async function instance() {
    const module = await WebAssembly.compile(await unzipped(MODULE));
    let exports = null;
    const known = system(() => exports.memory.buffer);
    const imports = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      (imports[from] ??= {})[name] = known[name] ?? (() => NOT_SUPPORTED);
    }
    ({ exports } = await WebAssembly.instantiate(module, imports));
    exports._initialize();
    return exports;
  }

  let started = null;

  /** Call a function of texts. One that breaks off, which none should, leaves a memory that cannot be relied on. */
  async function call(name, text) {
    started ??= instance();
    const library = await started;
    try {
      const given = text === undefined ? [] : [written(library, text)];
      const answer = read(library, library[name](...given));
      given.forEach(library.free);
      return JSON.parse(answer);
    } catch (error) {
      started = null;
      throw error;
    }
  }

  function written(library, text) {
    const bytes = new TextEncoder().encode(`${text}\0`);
    const place = library.malloc(bytes.length) >>> 0;
    if (place === 0) throw new RangeError("no memory for the request");
    new Uint8Array(library.memory.buffer).set(bytes, place);
    return place;
  }

  function read(library, place) {
    const memory = new Uint8Array(library.memory.buffer);
    const start = place >>> 0;
    return new TextDecoder().decode(memory.subarray(start, memory.indexOf(0, start)));
  }

  /** JSON has no numbers for these: they go by their names in case files. */
  const NOT_FINITE = new Map([
    [Infinity, "inf"],
    [-Infinity, "-inf"],
    [NaN, "nan"],
  ]);

  async function solve(request) {
    return call("solve", JSON.stringify(request, (_key, value) => NOT_FINITE.get(value) ?? value));
  }

  async function scalars() {
    return call("scalars");
  }

  const functions = { solve, scalars };

  function serve(scope = globalThis) {
    scope.onmessage = async ({ data: { id, name, content } }) => {
      try {
        scope.postMessage({ id, answer: await functions[name](content) });
      } catch (error) {
        scope.postMessage({ id, failure: String(error) });
      }
    };
  }

  globalThis.viscoroll = { ...functions, serve };
})();
