/** Light and dark: as the system has it, or as the page says around which this one stands. */

/** Follow both; `redraw` draws what has its colors from the script. */
export function followTheme(redraw) {
  globalThis.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  globalThis.addEventListener("message", ({ source, data }) => {
    if (source !== globalThis.parent || !["light", "dark"].includes(data?.theme)) return;
    document.documentElement.dataset.theme = data.theme;
    redraw();
  });
}
