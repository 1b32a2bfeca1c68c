/** Light or dark theme: the one that the reader chose on the site of the page, or else that of the system. */

/** Use the theme; `redraw` redraws the pictures whose colors the script sets, after a change of the system's theme. */
export function followTheme(redraw) {
  const chosen = chosenTheme();
  if (chosen) document.documentElement.dataset.theme = chosen;
  globalThis.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
}

/** The theme that the site (pydata-sphinx-theme) has stored, if there is one. */
function chosenTheme() {
  try {
    return ["light", "dark"].find((theme) => theme === localStorage.getItem("mode"));
  } catch {
    return undefined; // the browser does not let pages store anything
  }
}
