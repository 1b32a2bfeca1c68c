/** Cases for a curve over one number of the state, in an order that shows its shape early. */

import { caseOf, outerRadius } from "./case.js";
import { tidy } from "./units.js";

/** Numbers that a curve can vary: label, range of factors, number of points, and the varied part of the state. */
export const ALONG = {
  speed: {
    label: "speed",
    span: [1 / 30, 30],
    count: 21,
    vary: (state, factor) => ({ speed: scaled(state.speed, factor) }),
  },
  load: {
    label: "load or penetration",
    span: [1 / 10, 4],
    count: 15,
    vary: (state, factor) => ({ [state.pressed]: scaled(state[state.pressed], factor) }),
  },
  thickness: {
    label: "thickness of the outer layer",
    span: [1 / 4, 4],
    count: 15,
    vary: (state, factor) => ({
      layers: state.layers.map((layer, i) =>
        i === state.layers.length - 1 ? { ...layer, thickness: scaled(layer.thickness, factor) } : layer,
      ),
    }),
  },
};

const scaled = ([value, unit], factor) => [tidy(value * factor), unit];

/** The number that a curve varies, with its unit, as the user typed it. */
export function typedAlong(state, along) {
  if (along === "load") return state[state.pressed];
  return along === "thickness" ? state.layers.at(-1)?.thickness : state[along];
}

/**
 * Points of a curve around a state.
 * @returns {{at: number, unit: string, tables: object, radius: number}[]} varied number with its unit, tables of the
 *   case, and outer radius [m], in the order of solving
 */
export function pointsOf(state, along) {
  if (!typedAlong(state, along)) return [];
  const { span, count, vary } = ALONG[along];
  const factors = Array.from({ length: count }, (_, i) => span[0] * (span[1] / span[0]) ** (i / (count - 1)));
  return spread(count).map((i) => {
    const varied = { ...state, ...vary(state, factors[i]) };
    const [at, unit] = typedAlong(varied, along);
    return { at, unit, tables: caseOf(varied), radius: outerRadius(varied) };
  });
}

/** The indices 0 to count - 1: both ends first, then repeatedly the middles of the gaps. */
export function spread(count) {
  const order = [0, count - 1];
  for (let step = 2 ** Math.floor(Math.log2(count - 1)); step >= 1; step /= 2) {
    for (let i = step; i < count - 1; i += step) if (!order.includes(i)) order.push(i);
  }
  return order;
}
