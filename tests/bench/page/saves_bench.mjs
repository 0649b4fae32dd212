// From the rename of a file to the changed pixels: `plsc live` serves gecko (11
// modules, the paper's two seasons of 50 s), a file is renamed over it as editors
// do, and the page in Chromium, with WebGL in software, shows it.
//
//   node tests/bench/page/saves_bench.mjs [--smoke]
import { spawn } from "node:child_process";
import { renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { launch, watch } from "./browser.mjs";
import { example, isSmoke, machine, program, scratch, summary } from "./common.mjs";

const saves = isSmoke ? 2 : 50;
const path = join(scratch, "robot.pls");

// Each has another body than the one before, and numbers that were never there.
function text(i) {
  const gecko = example("gecko").replace("let lift = 1.0", `let lift = ${(1 + i / 1000).toFixed(3)}`);
  return i % 2 === 0 ? gecko : gecko.replace(/  add_front\n  B\n  move_back\n}/, "  move_back\n}");
}

writeFileSync(path, text(0));
const live = spawn(program, ["live", path], { stdio: ["ignore", "pipe", "inherit"] });
const address = await new Promise((resolve) => createInterface({ input: live.stdout }).once("line", resolve));
const browser = await launch();
const page = await (await browser.newContext({ viewport: { width: 1280, height: 800 } })).newPage();
await page.addInitScript(watch);
await page.goto(address);
await page.waitForFunction(() => window.watching.first.life);

// What the page's clock is ahead of ours, ms: of the quickest answer.
async function clockOffset() {
  let best = { took: Infinity };
  for (let i = 0; i < 50; ++i) {
    const begun = performance.now();
    const there = await page.evaluate(() => performance.now());
    const took = performance.now() - begun;
    if (took < best.took) best = { took, offset: there - begun - took / 2 };
  }
  return best.offset;
}

// Runs in the page: when, by its clock, the text of this many modules' robot, its
// bodies and its life are seen.
function seenOf([line, modules]) {
  const times = {};
  return new Promise((resolve) => {
    const done = async (name, needsPicture) => {
      times[name] = 0;
      times[name] = await window.watching.seen(needsPicture);
      if (times.text && times.body && times.life) resolve(times);
    };
    const look = () => {
      const isThere = (selector, count) => document.querySelectorAll(selector).length === count;
      if (times.text === undefined && document.querySelector(".cm-content").textContent.includes(line)) done("text", false);
      if (times.body === undefined && isThere(".workings .environment:first-child svg.body .module", modules)) done("body", false);
    };
    const looking = new MutationObserver(look);
    looking.observe(document.body, { subtree: true, childList: true, characterData: true });
    // The page is at rest again when the life is known.
    const right = document.querySelector(".right");
    const resting = new MutationObserver(() => {
      if (times.body === undefined || right.ariaBusy !== "false") return;
      resting.disconnect();
      looking.disconnect();
      done("life", true);
    });
    resting.observe(right, { attributeFilter: ["aria-busy"] });
  });
}

const all = [];
for (let i = 1; i <= saves + 3; ++i) {
  const offset = await clockOffset();
  const changed = text(i);
  const seen = page.evaluate(seenOf, [/let lift = .*/.exec(changed)[0].trim().split("  ")[0], i % 2 === 0 ? 11 : 10]);
  await page.waitForTimeout(100 + ((i * 37) % 97)); // at no certain time of the server's looks
  writeFileSync(`${path}.new`, changed);
  const renamed = performance.now();
  renameSync(`${path}.new`, path);
  const times = await seen;
  if (i > 3) all.push(Object.fromEntries(Object.entries(times).map(([name, at]) => [name, at - offset - renamed])));
  await page.waitForTimeout(300);
}
console.log(`${machine()}, Chromium ${browser.version()}`);
for (const [name, words] of [["text", "the text"], ["body", "the bodies"], ["life", "the robot in 3-D"]])
  console.log(`from the rename until ${words} of ${all.length} saves is seen, ms: ${summary(all.map((times) => times[name]))}`);
await browser.close();
live.kill("SIGINT");
