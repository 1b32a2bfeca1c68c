/** Case files: download of the case, and opening by a button or by drag and drop. */

import { fileOf } from "./case.js";
import { caseFileOf } from "./code.js";

/** Name of the downloaded file. */
export const NAME = "case.toml";

/**
 * Connect the buttons and the drop area, which is the whole page.
 * @param {object} of
 * @param {() => object} of.state returns the current state
 * @param {(file: File) => void} of.open called with a file that the user chose or dropped
 * @param {() => void} of.downloaded called after a download
 */
export function connectFiles({ state, open, downloaded }) {
  const input = document.getElementById("case-file");
  document.getElementById("open-case").addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    if (input.files.length) open(input.files[0]);
    input.value = ""; // so that the same file can be chosen again
  });
  document.getElementById("download-case").addEventListener("click", () => {
    download(caseFileOf(fileOf(state())));
    downloaded();
  });
  connectDrop(open);
}

function download(text) {
  const address = URL.createObjectURL(new Blob([text], { type: "application/toml" }));
  const link = document.createElement("a");
  Object.assign(link, { href: address, download: NAME });
  link.click();
  URL.revokeObjectURL(address);
}

function connectDrop(open) {
  const { dataset } = document.body;
  const isFile = (event) => event.dataTransfer?.types.includes("Files");
  document.addEventListener("dragover", (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    dataset.drop = true;
  });
  document.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) delete dataset.drop; // the pointer leaves the page
  });
  document.addEventListener("drop", (event) => {
    delete dataset.drop;
    if (!isFile(event)) return;
    event.preventDefault();
    open(event.dataTransfer.files[0]);
  });
}
