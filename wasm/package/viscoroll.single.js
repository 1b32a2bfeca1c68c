/**
 * The whole library as one classic script. It runs in pages, workers and Node.js, and can be loaded from http: and
 * file: URLs. It defines the global variable `viscoroll`; viscoroll.d.ts documents its functions, and viscoroll.js
 * exports them as a module.
 */
(() => {
  "use strict";

  /** WebAssembly module, compressed by gzip and encoded in base64. The build inserts it. */
  const MODULE = "";

  /** WASI error code (errno) returned by system functions that are not implemented. */
  const NOT_SUPPORTED = 52;

  /** WASI file descriptor of the standard error stream. */
  const STANDARD_ERROR = 2;

  async function decompress(base64) {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
  }

  /** Function that receives the time series of a history while the module computes it. */
  let receive = () => {};

  /**
   * WASI functions that the library imports: the clock, for its progress reports, and error output and exit, for fatal
   * errors. Pointers and lengths are in bytes of the module's memory, which `memory` returns.
   */
  function systemFunctions(memory) {
    const view = () => new DataView(memory());
    return {
      clock_time_get(_clock, _precision, time) {
        view().setBigUint64(time, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
      /** Each of the `count` buffers is described by its address and its length, in 8 bytes. */
      fd_write(file, buffers, count, written) {
        let [text, length] = ["", 0];
        for (let buffer = buffers; buffer < buffers + 8 * count; buffer += 8) {
          const bytes = new Uint8Array(memory(), view().getUint32(buffer, true), view().getUint32(buffer + 4, true));
          text += new TextDecoder().decode(bytes);
          length += bytes.length;
        }
        if (file === STANDARD_ERROR) console.error(text);
        view().setUint32(written, length, true);
        return 0;
      },
      /** Function of viscoroll: the text at an address has time series. */
      receive(address) {
        receive(JSON.parse(readText(memory(), address)));
      },
      proc_exit(code) {
        throw new Error(`viscoroll exited with code ${code}`);
      },
    };
  }

  async function instantiate() {
    const module = await WebAssembly.compile(await decompress(MODULE));
    let exports = null;
    const provided = systemFunctions(() => exports.memory.buffer);
    const imports = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      (imports[from] ??= {})[name] = provided[name] ?? (() => NOT_SUPPORTED);
    }
    ({ exports } = await WebAssembly.instantiate(module, imports));
    exports._initialize();
    return exports;
  }

  /** Promise of the module's exports; null before the first call. */
  let instance = null;

  /**
   * Call a function of the module with a text, if there is one, and parse the JSON text that it returns. `each` receives
   * time series meanwhile. After an exception, the memory of the module may be corrupt, so the next call makes a new
   * instance.
   */
  async function call(name, text, each = () => {}) {
    instance ??= instantiate();
    const library = await instance;
    try {
      const addresses = text === undefined ? [] : [writeText(library, text)];
      receive = each;
      const returned = library[name](...addresses);
      const answer = readText(library.memory.buffer, returned);
      addresses.forEach(library.free);
      return JSON.parse(answer);
    } catch (error) {
      instance = null;
      throw error;
    }
  }

  /** Copy a text to newly allocated memory of the module, with a final zero; return its address. */
  function writeText(library, text) {
    const bytes = new TextEncoder().encode(`${text}\0`);
    const address = library.malloc(bytes.length) >>> 0;
    if (address === 0) throw new RangeError(`not enough memory for a request of ${bytes.length} bytes`);
    new Uint8Array(library.memory.buffer).set(bytes, address);
    return address;
  }

  /** Return the text at an address of a memory, which ends with a zero. */
  function readText(buffer, address) {
    const memory = new Uint8Array(buffer);
    const start = address >>> 0;
    return new TextDecoder().decode(memory.subarray(start, memory.indexOf(0, start)));
  }

  /** Numbers that JSON cannot represent, and their names in the requests. */
  const NON_FINITE_NAMES = new Map([
    [Infinity, "inf"],
    [-Infinity, "-inf"],
    [NaN, "nan"],
  ]);

  const requestText = (request) => JSON.stringify(request, (_key, value) => NON_FINITE_NAMES.get(value) ?? value);

  async function solve(request) {
    return call("solve", requestText(request));
  }

  async function roll(request, each) {
    return call("roll", requestText(request), each);
  }

  async function scalars() {
    return call("scalars");
  }

  async function historyScalars() {
    return call("history_scalars");
  }

  const functions = { solve, roll, scalars, historyScalars };

  function serve(scope = globalThis) {
    scope.onmessage = async ({ data: { id, name, content } }) => {
      try {
        const each = (part) => scope.postMessage({ id, part });
        scope.postMessage({ id, answer: await functions[name](content, each) });
      } catch (error) {
        scope.postMessage({ id, failure: String(error) });
      }
    };
  }

  globalThis.viscoroll = { ...functions, serve };
})();
