/** A case that the user keeps: its numbers appear on the cards of the current case, and its pictures beside. */

import { bodyOf, isLine, outerRadius } from "./case.js";
import { drawContact } from "./contact_picture.js";
import { el } from "./dom.js";
import { BODIES } from "./schema.js";
import { numberText, quantityText } from "./units.js";

export class Comparison {
  #elements;
  #kept = null;
  #ready = null; // state and result that can be kept
  #line = false; // whether the numbers on the cards are per length

  /**
   * @param {{keep, exchange, remove, said, numbers, pictures, root}} elements buttons, text about the kept case, cards of
   *   the current case, element for the kept pictures, and the element of all pictures
   * @param {object} tell functions to call: `changed()` after the kept case has changed, and `open(state)` with the state
   *   of the kept case if the user exchanges both cases
   */
  constructor(elements, tell) {
    this.#elements = elements;
    elements.keep.addEventListener("click", () => {
      this.#keep();
      tell.changed();
    });
    elements.exchange.addEventListener("click", () => {
      const { state } = this.#kept;
      this.#keep();
      tell.open(state);
    });
    elements.remove.addEventListener("click", () => {
      this.#kept = null;
      this.#show();
      tell.changed();
    });
    new ResizeObserver(() => this.draw()).observe(elements.pictures);
    this.#show();
  }

  /** State of the kept case, or null. */
  get state() {
    return this.#kept?.state ?? null;
  }

  /** Use a new result, which the cards show, and the tables of its case. It can be kept if its state is given. */
  use(result, tables, state = null) {
    this.#line = BODIES[bodyOf(tables)].line;
    this.#ready = state && { state, result };
    this.#show();
  }

  /** The shown result is no longer that of the form. */
  wait() {
    this.#ready = null;
    this.#showButtons();
  }

  /** Draw the pictures of the kept case in the available width and the colors of the page. */
  draw() {
    const { pictures } = this.#elements;
    if (this.#kept && pictures.clientWidth > 0) drawContact(pictures, this.#kept.result);
  }

  #keep() {
    for (const note of this.#elements.numbers.querySelectorAll(".kept")) note.remove();
    const cards = [...this.#elements.numbers.querySelectorAll("[data-scalar]")];
    const texts = Object.fromEntries(cards.map((card) => [card.dataset.scalar, card.textContent]));
    this.#kept = { ...this.#ready, texts };
    this.#show();
  }

  #show() {
    const { numbers, root, said } = this.#elements;
    root.dataset.kept = this.#kept !== null;
    said.textContent = this.#kept ? caseText(this.#kept.state) : "";
    for (const note of numbers.querySelectorAll(".kept")) note.remove();
    if (this.#kept) {
      for (const card of numbers.querySelectorAll("[data-scalar]")) {
        const text = this.#keptText(card.dataset.scalar, Number(card.dataset.value));
        if (text) card.after(el("dd", { class: "note kept" }, text));
      }
    }
    this.#showButtons();
    this.draw();
  }

  #showButtons() {
    const { keep, exchange, remove } = this.#elements;
    keep.disabled = exchange.disabled = this.#ready === null;
    exchange.hidden = remove.hidden = this.#kept === null;
  }

  /** Value of the kept case, and the change from it. */
  #keptText(name, value) {
    const { state, result, texts } = this.#kept;
    const before = result.scalars[name];
    if (!(name in texts) || !Number.isFinite(before)) return "";
    return `kept: ${texts[name]}${isLine(state) === this.#line ? changeText(before, value) : ""}`;
  }
}

/** Change of a number in percent, such as " (+12 %)". */
export function changeText(before, value) {
  if (before === 0 || !Number.isFinite(value)) return "";
  const percent = 100 * (value / before - 1);
  if (Math.abs(percent) < 0.05) return " (±0\u00a0%)";
  const text = numberText(Math.abs(percent) < 10 ? Number(percent.toFixed(1)) : Math.round(percent), 6);
  return ` (${percent > 0 ? "+" : ""}${text}\u00a0%)`;
}

/** Body, outer diameter, load and speed of a case. */
export function caseText(state) {
  const typed = ([number, unit]) => `${numberText(number)} ${unit}`;
  const diameter = quantityText(2 * outerRadius(state), "m");
  return `${BODIES[state.body].noun} ${diameter}, ${typed(state[state.pressed])}, ${typed(state.speed)}`;
}
