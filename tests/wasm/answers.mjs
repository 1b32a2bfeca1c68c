// Answers requests, a JSON array on the standard input, with the package in a folder: `node answers.mjs PACKAGE [WAY]`.
// WAY selects the default "module"; "script", which uses viscoroll.single.js like a page opened as a file; or "worker",
// which uses viscoroll-worker.js in a worker that Node sets up like those of browsers.

import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import vm from "node:vm";
import { isMainThread, parentPort, Worker, workerData } from "node:worker_threads";

async function byModule(folder) {
  return import(pathToFileURL(path.join(folder, "viscoroll.js")));
}

function byScript(folder) {
  vm.runInThisContext(fs.readFileSync(path.join(folder, "viscoroll.single.js"), "utf8"));
  return globalThis.viscoroll;
}

function byWorker(folder) {
  const worker = new Worker(new URL(import.meta.url), { workerData: folder });
  const ask = (name, content, each) =>
    new Promise((resolve, reject) => {
      const receive = ({ part, answer, failure }) => {
        if (part) {
          each(part);
          return;
        }
        worker.off("message", receive);
        if (failure === undefined) resolve(answer);
        else reject(new Error(failure));
      };
      worker.on("message", receive);
      worker.once("error", reject);
      worker.postMessage({ id: 1, name, content });
    });
  return {
    solve: (request) => ask("solve", request),
    roll: (request, each) => ask("roll", request, each),
    scalars: () => ask("scalars"),
    historyScalars: () => ask("historyScalars"),
    end: () => worker.terminate(),
  };
}

/** Worker: set up the scope of browsers, then load the file of the package. */
async function beWorker(folder) {
  globalThis.postMessage = (answer) => parentPort.postMessage(answer);
  await import(pathToFileURL(path.join(folder, "viscoroll-worker.js")));
  parentPort.on("message", (data) => globalThis.onmessage({ data }));
}

/** The answer to a request; a request for a history, `{history}`, also gets the parts of its time series. */
async function answered(viscoroll, request) {
  if (!request?.history) return viscoroll.solve(request);
  const parts = [];
  const answer = await viscoroll.roll(request.history, (part) => parts.push(part));
  return { ...answer, parts };
}

async function answerAll(folder, entry = "module") {
  const viscoroll = await { module: byModule, script: byScript, worker: byWorker }[entry](folder);
  const answers = [];
  for (const request of JSON.parse(fs.readFileSync(0, "utf8"))) answers.push(await answered(viscoroll, request));
  const [scalars, historyScalars] = [await viscoroll.scalars(), await viscoroll.historyScalars()];
  console.log(JSON.stringify({ answers, scalars, historyScalars }));
  await viscoroll.end?.();
}

if (isMainThread) await answerAll(...process.argv.slice(2));
else await beWorker(workerData);
