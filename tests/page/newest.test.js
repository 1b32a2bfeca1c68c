/** Only the newest case is solved: coarsely, then to its accuracy, then along its curve. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { Newest } from "../../python/viscoroll/app/page/newest.js";

const tables = (load) => ({ ball: {}, rolling: { load }, numerics: { accuracy: 0.01, compliance: "radial" } });

/** A slow solver that records its requests. */
function slowSolver(milliseconds) {
  const log = [];
  const solve = ({ case: { rolling, numerics } }, signal) =>
    new Promise((resolve, reject) => {
      log.push(`${rolling.load} ${"accuracy" in numerics ? "fine" : `coarse ${numerics.nodes_per_revolution}`}`);
      signal?.addEventListener("abort", () => reject(new DOMException("", "AbortError")));
      setTimeout(() => resolve({ result: { scalars: { semi_axis_x: 0.004 } } }), milliseconds);
    });
  return { log, solve };
}

function noted(solver) {
  const told = [];
  let done;
  const end = new Promise((resolve) => (done = resolve));
  const newest = new Newest(solver, {
    solving: () => {},
    solved: (_, { stage }) => told.push(stage),
    temperature: (answer) => told.push(answer),
    point: (place) => {
      told.push(place);
      if (place === 1) done();
    },
    failed: (error) => told.push(error.message),
  });
  return { newest, told, end };
}

const curve = [7, 8].map((load) => ({ tables: tables(load), radius: 0.02 }));

test("only the first and the last of thirty quick changes are solved", async () => {
  const solver = slowSolver(30);
  const { newest, told, end } = noted(solver);
  for (let load = 1; load <= 30; load += 1) newest.ask(tables(load), 0.02, curve);
  await end;
  assert.deepEqual(told, ["coarse", "coarse", "fine", 0, 1]);
  // 16 nodes across the contact of the first result: 16 π 0.02/0.004 = 251, but at least 300.
  assert.deepEqual(solver.log, ["1 coarse 400", "30 coarse 300", "30 fine", "7 coarse 300", "8 coarse 300"]);
});

test("a change aborts the refinement", async () => {
  const solver = slowSolver(100);
  const { newest, told, end } = noted(solver);
  newest.ask(tables(1), 0.02, curve);
  await new Promise((resolve) => setTimeout(resolve, 400));
  assert.deepEqual(solver.log.at(-1), "1 fine");
  newest.ask(tables(2), 0.02, curve);
  await end;
  assert.deepEqual(told, ["coarse", "coarse", "fine", 0, 1]);
});

test("a temperature follows the refined result", async () => {
  const solver = slowSolver(1);
  solver.temperature = async ({ case: { rolling }, thermal }) => `${rolling.load} ${thermal.convection}`;
  const { newest, told, end } = noted(solver);
  newest.ask(tables(1), 0.02, curve, { convection: 10 });
  await end;
  assert.deepEqual(told, ["coarse", "fine", "1 10", 0, 1]);
});

test("a failure is reported, and the next case is solved", async () => {
  const good = slowSolver(1);
  let first = true;
  const solver = {
    solve: (...of) => (first ? ((first = false), Promise.reject(new Error("gone"))) : good.solve(...of)),
  };
  const { newest, told, end } = noted(solver);
  newest.ask(tables(1), 0.02, curve);
  await new Promise((resolve) => setTimeout(resolve, 10));
  newest.ask(tables(2), 0.02, curve);
  await end;
  assert.deepEqual(told, ["gone", "coarse", "fine", 0, 1]);
});
