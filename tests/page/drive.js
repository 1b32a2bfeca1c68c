/**
 * Uses the page in a headless browser as a user would, and writes what it displayed as JSON.
 *
 *     node tests/page/drive.js ADDRESS FOLDER     environment variable BROWSER: path of the browser
 */

import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

// NODE_PATH applies to require, but not to imports.
const puppeteer = createRequire(import.meta.url)("puppeteer-core");

const [address, folder] = process.argv.slice(2);
const browser = await puppeteer.launch({ executablePath: process.env.BROWSER, args: ["--no-sandbox"] });
const requests = [];
const complaints = [];

async function open(where, width = 1280) {
  const page = await browser.newPage();
  page.on("request", (request) => requests.push(request.url()));
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.message));
  await page.setViewport({ width, height: 900 });
  await page.goto(where);
  return page;
}

/** Numbers of the page by name, after refinement. */
async function refined(page) {
  await page.waitForSelector('body[data-stage="fine-solved"]', { timeout: 60_000 });
  return page.$$eval("#table [data-scalar]", (cells) =>
    Object.fromEntries(
      cells.map((cell) => [cell.dataset.scalar, cell.dataset.value === undefined ? null : Number(cell.dataset.value)]),
    ),
  );
}

/** Wait for the answer for a load [N]. */
const answered = (page, load) =>
  page.waitForFunction(
    (newton) => JSON.parse(document.getElementById("answer").dataset.of ?? "{}").rolling?.load === newton,
    {},
    load,
  );

/** Slider next to the field of a label. */
const slider = (page, label) => page.$(`input[aria-label="${label}, slider"]`);

async function text(page, button) {
  await page.click(button);
  return page.$eval("#code pre", (pre) => pre.textContent);
}

const seen = {};

// The case of the README, from opening the page to its numbers.
const begun = performance.now();
const page = await open(address);
await page.waitForSelector("#numbers .card", { timeout: 60_000 });
seen.first = (performance.now() - begun) / 1e3;
seen.readme = await refined(page);
seen.start = (performance.now() - begun) / 1e3;
await page.waitForSelector('#curve[data-filling="done"]', { timeout: 60_000 });
seen.points = await page.$$eval("#curve circle.dot", (dots) => dots.length);
await page.screenshot({ path: join(folder, "try-1280.png") });
seen.inView = await page.evaluate(() =>
  ["load", "speed"].every((label) => {
    const slider = document.querySelector(`input[aria-label="${label}, slider"]`);
    return slider.getBoundingClientRect().bottom < innerHeight;
  }),
);

// Thirty moves of a slider; the last value is solved.
const load = await slider(page, "load");
for (let i = 1; i <= 30; i += 1) {
  await load.evaluate(
    (input, value) => {
      input.value = value;
      input.dispatchEvent(new Event("input", { bubbles: true }));
    },
    100 + 2 * i,
  );
}
const moved = performance.now();
seen.load = await page.$eval(
  "#form",
  () => JSON.parse(atob(location.hash.slice(1).replaceAll("-", "+").replaceAll("_", "/"))).load,
);
await answered(page, seen.load[0]);
seen.answered = (performance.now() - moved) / 1e3;
seen.moved = await refined(page);

// The copied text is this case, and a link restores it.
seen.python = await text(page, "#copy-python");
seen.caseFile = await text(page, "#copy-case");
seen.hasLink = await page.$eval("#copy-link", (button) => !button.hidden);
seen.link = seen.hasLink ? await text(page, "#copy-link") : page.url();
seen.restored = await refined(await open(seen.link));

// So does the copied case file, if it is opened or dropped on the page.
const file = join(folder, "case.toml");
writeFileSync(file, seen.caseFile);
const other = await open(address);
await (await other.$("#case-file")).uploadFile(file);
await answered(other, seen.load[0]);
seen.opened = await refined(other);
await other.evaluate((content) => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([content], "dropped.toml"));
  document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
}, "wheel = 5");
await other.waitForSelector('#file-said[data-kind="error"]');
seen.dropped = await other.$eval("#file-said", (said) => said.textContent);

// The numbers of a kept case appear beside those of the next one.
await other.waitForSelector("#keep:not([disabled])");
await other.click("#keep");
await other.select("#examples", "paper");
await answered(other, 100);
await refined(other);
seen.kept = await other.$eval('#numbers [data-scalar="strain"] + .kept', (note) => note.textContent);

// The server of `viscoroll app` also computes temperatures.
const heated = await open(`${address}#${Buffer.from(JSON.stringify({ temperature: "on" })).toString("base64url")}`);
const legends = await heated.$$eval("#form legend", (all) => all.map(({ textContent }) => textContent));
seen.hasTemperature = legends.includes("Temperature");
if (seen.hasTemperature) await heated.waitForSelector("#temperature .card", { timeout: 60_000 });
seen.hottest = await heated.$$eval("#temperature .card dd", (cards) => cards[0]?.textContent);
seen.charts = await heated.$$eval("#temperature svg", (charts) => charts.length);

// A body rolls over a bump; the history can be stopped, and starts again with another input.
const rolled = await open(`${address}#${Buffer.from(JSON.stringify({ obstacle: "half_sine" })).toString("base64url")}`);
const run = (state) => rolled.waitForSelector(`#over-ground[data-run="${state}"]`, { timeout: 60_000 });
await run("rolling");
await rolled.waitForSelector("#over-ground[data-frames]", { timeout: 60_000 });
const played = performance.now();
await run("done");
seen.ground = await rolled.$eval("#over-ground", (view) => ({
  tables: JSON.parse(view.dataset.of),
  frames: Number(view.dataset.frames),
  said: view.querySelector(".said").textContent,
  last: Object.fromEntries(
    [...view.querySelectorAll("[data-series]")].map((one) => [one.dataset.series, Number(one.dataset.value)]),
  ),
}));
seen.ground.seconds = (performance.now() - played) / 1e3;
await rolled.click("#over-ground button");
await run("rolling");
await rolled.click("#over-ground button");
await run("stopped");
await rolled.evaluate(() => {
  const label = [...document.querySelectorAll("#form label")].find(({ textContent }) => textContent === "obstacle");
  const select = document.getElementById(label.htmlFor);
  select.value = "step";
  select.dispatchEvent(new Event("change"));
});
await run("done");
seen.ground.next = await rolled.$eval("#over-ground", (view) => JSON.parse(view.dataset.of).ground.type);

// The field of a wrong number displays the error; a new number removes it.
await page.bringToFront();
const field = await page.evaluateHandle(() =>
  [...document.querySelectorAll("#form .field")].find((one) => one.querySelector("label").textContent === "thickness"),
);
const typed = await field.$("input[type=text]");
await typed.click({ clickCount: 3 });
await typed.type("0");
await page.waitForSelector('body[data-wrong="true"]');
seen.problem = await field.$eval(".problem", (problem) => problem.textContent);
await typed.click({ clickCount: 3 });
await typed.type("0.1 cm");
await page.waitForSelector('body[data-wrong="false"]');
await page.keyboard.press("Tab");
seen.typed = await field.$eval(".typed", (part) => [...part.children].map(({ value }) => value));

// All examples have results, and each fits the width of a phone's screen.
seen.examples = {};
const narrow = await open(address, 400);
await narrow.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
await refined(narrow);
const [first, ...others] = await narrow.$$eval("#examples option", (options) =>
  options.map(({ value }) => value).filter(Boolean),
);
for (const name of [...others, first]) {
  await narrow.evaluate(() => delete document.body.dataset.stage);
  await narrow.select("#examples", name);
  const { rolling_resistance_coefficient: coefficient } = await refined(narrow);
  const width = await narrow.evaluate(() => document.documentElement.scrollWidth);
  seen.examples[name] = {
    coefficient,
    width,
    python: await text(narrow, "#copy-python"),
    caseFile: await text(narrow, "#copy-case"),
  };
  await narrow.click("#code-close");
}
await narrow.$eval("#answer", (answer) => answer.scrollIntoView());
await narrow.screenshot({ path: join(folder, "try-400.png") });

await browser.close();
writeFileSync(join(folder, "seen.json"), JSON.stringify({ ...seen, requests: [...new Set(requests)], complaints }));
