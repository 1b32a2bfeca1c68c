/**
 * Reader of case files in TOML, for the site, where no Python reads them. It reads the parts of TOML that case files
 * use: tables, lists of tables, inline tables, lists, dotted keys, texts in one line, numbers and booleans.
 */

const BARE_KEY = /[\w-]+/y;
const NUMBER = /[+-]?(?:inf|nan|(?:\d(?:_?\d)*)(?:\.\d(?:_?\d)*)?(?:[eE][+-]?\d(?:_?\d)*)?)(?![\w.:-])/y;
const BASIC = /"((?:[^"\\\n]|\\.)*)"/y;
const LITERAL = /'([^'\n]*)'/y;
const SPACE = /[ \t]*/y;
const BLANK = /(?:[ \t\r\n]|#[^\n]*)*/y;
const END_OF_LINE = /[ \t]*(?:#[^\n]*)?\r?(?:\n|$)/y;

/**
 * The tables of a text in TOML.
 * @throws {Error} if the text is not TOML, or uses other parts of it
 */
export function parseToml(text) {
  return new Reader(text).document();
}

class Reader {
  #text;
  #position = 0;

  constructor(text) {
    this.#text = text.replace(/^\ufeff/, "");
  }

  document() {
    const root = {};
    let table = root;
    for (this.#skip(BLANK); this.#position < this.#text.length; this.#skip(BLANK)) {
      if (this.#takes("[[")) table = this.#newEntry(root);
      else if (this.#takes("[")) table = this.#newTable(root);
      else this.#pair(table);
      if (!this.#match(END_OF_LINE)) this.#fail("expected the end of the line");
    }
    return root;
  }

  #newEntry(root) {
    const path = this.#path();
    this.#expect("]]");
    const parent = this.#tableAt(root, path.slice(0, -1));
    const list = (parent[path.at(-1)] ??= []);
    if (!Array.isArray(list)) this.#fail(`${path.join(".")} is not a list of tables`);
    list.push({});
    return list.at(-1);
  }

  #newTable(root) {
    const path = this.#path();
    this.#expect("]");
    return this.#tableAt(root, path);
  }

  /** The table at a path, in the last entry of each list. */
  #tableAt(root, path) {
    return path.reduce((table, name) => {
      const next = own(table, name) ?? (table[name] = {});
      const found = Array.isArray(next) ? next.at(-1) : next;
      if (found === null || typeof found !== "object") this.#fail(`${name} is not a table`);
      return found;
    }, root);
  }

  #pair(table) {
    const path = this.#path();
    this.#expect("=");
    const target = this.#tableAt(table, path.slice(0, -1));
    if (own(target, path.at(-1)) !== undefined) this.#fail(`${path.join(".")} is given twice`);
    target[path.at(-1)] = this.#value();
  }

  /** The names of a key, such as ["ball", "layers"] for `ball.layers`. */
  #path() {
    const path = [];
    do {
      this.#skip(SPACE);
      const name = this.#string() ?? this.#match(BARE_KEY)?.[0];
      if (name === undefined) this.#fail("expected a key");
      if (name === "__proto__") this.#fail("this key is not allowed");
      path.push(name);
      this.#skip(SPACE);
    } while (this.#takes("."));
    return path;
  }

  #value() {
    this.#skip(SPACE);
    if (this.#takes("[")) return this.#list("]", () => this.#value());
    if (this.#takes("{")) {
      const table = {};
      this.#list("}", () => this.#pair(table));
      return table;
    }
    const text = this.#string();
    if (text !== undefined) return text;
    const number = this.#match(NUMBER)?.[0];
    if (number !== undefined) return Number(number.replaceAll("_", "").replace("inf", "Infinity"));
    const word = this.#match(BARE_KEY)?.[0];
    if (word === "true" || word === "false") return word === "true";
    return this.#fail("expected a number, a text in quotes, true, false, a list or a table");
  }

  #list(end, read) {
    const found = [];
    for (this.#skip(BLANK); !this.#takes(end); this.#skip(BLANK)) {
      found.push(read());
      this.#skip(BLANK);
      if (!this.#takes(",") && this.#text[this.#position] !== end) this.#fail(`expected "," or "${end}"`);
    }
    return found;
  }

  #string() {
    if (/^("""|''')/.test(this.#text.slice(this.#position, this.#position + 3))) {
      this.#fail("this page does not read texts of several lines");
    }
    const literal = this.#match(LITERAL);
    if (literal) return literal[1];
    const basic = this.#match(BASIC);
    if (!basic) return undefined;
    try {
      return JSON.parse(basic[0]);
    } catch {
      return this.#fail("this page does not read this text in quotes");
    }
  }

  #expect(token) {
    this.#skip(SPACE);
    if (!this.#takes(token)) this.#fail(`expected "${token}"`);
  }

  #takes(token) {
    const found = this.#text.startsWith(token, this.#position);
    if (found) this.#position += token.length;
    return found;
  }

  #skip(pattern) {
    this.#match(pattern);
  }

  #match(pattern) {
    pattern.lastIndex = this.#position;
    const found = pattern.exec(this.#text);
    if (found) this.#position = pattern.lastIndex;
    return found;
  }

  #fail(reason) {
    throw new Error(`line ${this.#text.slice(0, this.#position).split("\n").length}: ${reason}`);
  }
}

const own = (table, name) => (Object.hasOwn(table, name) ? table[name] : undefined);
