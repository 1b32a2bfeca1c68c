/** The functions of viscoroll.single.js as those of a module. */

import "./viscoroll.single.js";

export const { solve, scalars, serve } = globalThis.viscoroll;
