/** Light or dark theme: that of the system, or of the page that embeds this one. */

/** Follow changes of either theme; `redraw` redraws the pictures whose colors the script sets. */
export function followTheme(redraw) {
  globalThis.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  globalThis.addEventListener("message", ({ source, data }) => {
    if (source !== globalThis.parent || !["light", "dark"].includes(data?.theme)) return;
    document.documentElement.dataset.theme = data.theme;
    redraw();
  });
}
