/** Module that exports the functions of viscoroll.single.js. */

import "./viscoroll.single.js";

export const { solve, roll, scalars, historyScalars, serve } = globalThis.viscoroll;
