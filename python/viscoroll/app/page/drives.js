/** The drives of the form, by their keys in case files. */

/**
 * `offer`: text of the choice; `label`: label of the field; `total` and `line`: quantity, unit and slider range [SI] of
 * total values and of values per length.
 */
export const DRIVES = {
  force: {
    offer: "a force on the center",
    label: "force, forward",
    total: { quantity: "force", unit: "N", range: [-500, 500] },
    line: { quantity: "line_force", unit: "N/mm", range: [-1e4, 1e4] },
  },
  torque: {
    offer: "a driving torque (0: towed)",
    label: "driving torque",
    total: { quantity: "torque", unit: "N m", range: [-10, 10] },
    line: { quantity: "line_torque", unit: "N m/m", range: [-100, 100] },
  },
  power: {
    offer: "a driving power (negative: braked)",
    label: "driving power",
    total: { quantity: "power", unit: "W", range: [-100, 100] },
    line: { quantity: "line_power", unit: "W/m", range: [-1e4, 1e4] },
  },
  creepage: {
    offer: "a given creepage",
    label: "creepage",
    total: { quantity: "percent", unit: "%", range: [-0.1, 0.1] },
    line: { quantity: "percent", unit: "%", range: [-0.1, 0.1] },
  },
};

/** Quantity, unit and range of a drive; `line`: per length. */
export const scaleOf = (drive, line) => DRIVES[drive][line ? "line" : "total"];

/** The value 0 of every drive, as a part of a state. */
export const driveZeros = (line) =>
  Object.fromEntries(Object.keys(DRIVES).map((name) => [name, [0, scaleOf(name, line).unit]]));
