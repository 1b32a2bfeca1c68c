/** Buttons that copy the case as Python code, as a case file and as a link. */

import { fileOf } from "./case.js";
import { caseFileOf, pythonOf } from "./code.js";
import { fragmentOf } from "./link.js";

/**
 * Connect the buttons.
 * @param {() => object} state returns the current state
 * @param {boolean} hasLink whether others can open the address of the page
 */
export function connectCopies(state, hasLink) {
  const texts = {
    "copy-python": ["Python", () => pythonOf(fileOf(state()))],
    "copy-case": ["Case file", () => caseFileOf(fileOf(state()))],
    "copy-link": ["Link", () => location.href.split("#")[0] + fragmentOf(state())],
  };
  for (const [id, [name, text]] of Object.entries(texts)) {
    document.getElementById(id).addEventListener("click", () => copy(name, text()));
  }
  document.getElementById("copy-link").hidden = !hasLink;
  document.getElementById("code-close").addEventListener("click", () => {
    document.getElementById("code").hidden = true;
  });
}

/** Copy a text, and show it for browsers that do not let pages copy. */
async function copy(name, text) {
  const shown = document.getElementById("code");
  const said = document.getElementById("code-said");
  shown.hidden = false;
  shown.querySelector("pre").textContent = text;
  try {
    await navigator.clipboard.writeText(text);
    said.textContent = `${name} copied.`;
  } catch {
    said.textContent = `${name}: the browser does not allow the page to copy; select the text and copy it.`;
  }
}
