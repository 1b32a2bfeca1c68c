/** Example cases. */

import { initialState } from "./case.js";
import { PRESETS } from "./materials.js";

const layer = (preset, thickness) => ({ thickness: [thickness, "mm"], preset, ...PRESETS[preset].layer });

/** Differences of each example from the initial state. */
const CHANGES = {
  paper: { label: "ball of the paper, 1 mm of rubber", state: {} },
  skate: {
    label: "skate wheel, 80 mm, 20 km/h",
    state: {
      body: "wheel",
      given: "outer_diameter",
      size: [80, "mm"],
      width: [24, "mm"],
      crown_radius: [12, "mm"],
      layers: [layer("skate", 18)],
      load: [20, "kgf"],
      speed: [20, "km/h"],
    },
  },
  caster: {
    label: "caster, 100 mm, 80 kg, walking",
    state: {
      body: "wheel",
      given: "outer_diameter",
      size: [100, "mm"],
      width: [32, "mm"],
      layers: [layer("caster", 10)],
      load: [80, "kgf"],
      speed: [4, "km/h"],
    },
  },
  towed: {
    label: "towed ball with stick and slip",
    state: { friction: 0.3, drive: "torque", speed: [0.2, "rad/s"] },
  },
  roller: {
    label: "rubber-covered roller",
    state: {
      body: "cylinder",
      size: [50, "mm"],
      layers: [layer("soft_rubber", 10)],
      load: [5, "N/mm"],
      force: [0, "N/mm"],
      torque: [0, "N m/m"],
      speed: [1, "m/s"],
    },
  },
  mat: {
    label: "steel ball on a rubber mat",
    state: {
      size: [10, "mm"],
      layers: [],
      on: "plane",
      ground: [layer("soft_rubber", 5)],
      load: [5, "N"],
      speed: [0.5, "m/s"],
    },
  },
};

/** Labels of the examples by name. */
export const EXAMPLES = Object.fromEntries(Object.entries(CHANGES).map(([name, { label }]) => [name, label]));

export function exampleState(name) {
  return { ...initialState(), ...CHANGES[name].state };
}
