/** Round numbers for the ticks of axes. */

/** Space for the label of a tick [pixels]: horizontally, and vertically. */
export const BESIDE = 45;
export const ABOVE = 24;

/** Largest number of intervals between ticks. */
const ENOUGH = 5;

/** Multiples of 1, 2 or 5 times a power of ten between two numbers: about five, or fewer if there is less space. */
export function roundTicks(low, high, most) {
  const rough = (high - low) / Math.min(Math.max(most, 2), ENOUGH);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((one) => one >= rough);
  const ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high; i += 1) ticks.push(Number((i * step).toPrecision(12)));
  return ticks;
}

/** 1, 2 and 5 of each decade between two numbers > 0, or only 1 if these are too many. */
export function decadeTicks(low, high) {
  const all = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power += 1) {
    for (const factor of [1, 2, 5]) all.push(Number(`${factor}e${power}`));
  }
  const inside = all.filter((tick) => tick >= low && tick <= high);
  return inside.length <= 7 ? inside : inside.filter((tick) => String(tick.toExponential()).startsWith("1e"));
}
