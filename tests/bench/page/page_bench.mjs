// The page that runs plsc, from disk, in Chromium with WebGL in software: how
// long until the first robot is seen, how long from a number that is changed to
// the changed robot, and memory over thousands of changes. `gecko`, 11 modules,
// in the paper's two seasons of 50 s.
//
//   node tests/bench/page/page_bench.mjs [--smoke | --memory CHANGES]
//
// The program must have been built with -DPLSC_MODULE (docs/web.md). Times end
// when the frame is drawn, pixels of the 3-D picture read back.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { launch, moduleBytes, processBytes, watch } from "./browser.mjs";
import { example, isSmoke, machine, plsc, scratch, summary } from "./common.mjs";

const openings = isSmoke ? 1 : 20;
const changes = isSmoke ? 3 : 50;
const memoryAt = process.argv.indexOf("--memory");
const most = memoryAt > 0 ? Number(process.argv[memoryAt + 1]) : 0;

writeFileSync(join(scratch, "gecko.pls"), example("gecko"));
plsc("view", "--editable", "gecko.pls", "-o", "gecko.html");
const address = pathToFileURL(join(scratch, "gecko.html")).href;
const browser = await launch();

async function withPage(use) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  await context.addInitScript(watch);
  await context.addInitScript({ content: `window.slide = ${slide};` });
  const page = await context.newPage();
  page.on("pageerror", (error) => {
    throw error;
  });
  await page.goto(address, { waitUntil: "commit" });
  await page.waitForFunction(() => window.watching.first.life);
  try {
    return await use(page);
  } finally {
    await context.close();
  }
}

async function open() {
  const all = [];
  for (let i = 0; i < openings; ++i) all.push(await withPage((page) => page.evaluate(() => window.watching.first)));
  for (const [name, words] of [["editor", "the editor"], ["body", "the body"], ["life", "the robot in 3-D"]])
    console.log(`opening until ${words} is seen, ms: ${summary(all.map((first) => first[name]))}`);
}

// Puts the cursor on a number, so that it has a slider.
async function aim(page) {
  await page.locator(".cm-line", { hasText: "let lift" }).first().click();
  await page.keyboard.press("Home");
  for (let i = 0; i < 12; ++i) await page.keyboard.press("ArrowRight");
  await page.locator("#slider").waitFor();
}

// Runs in the page: slides to a value and gives ms until the body is seen, the
// life known, the life seen: {body, asked, life}; without `isSeen` nobody waits for
// pictures.
function slide(value, isSeen = true) {
  return new Promise((resolve) => {
    const slider = document.querySelector("#slider");
    const begun = performance.now();
    const times = {};
    const bodies = new MutationObserver(() => {
      bodies.disconnect();
      window.watching.seen(false).then((at) => (times.body = at - begun));
    });
    bodies.observe(document.querySelector(".workings"), { childList: true, subtree: true });
    const said = new MutationObserver(() => {
      if (!/^lived/.test(document.querySelector(".status").textContent)) return;
      said.disconnect();
      times.asked = performance.now() - begun;
      if (!isSeen) return resolve(times);
      window.watching.seen(true).then((at) => resolve({ ...times, life: at - begun }));
    });
    said.observe(document.querySelector(".status"), { childList: true });
    slider.value = value;
    slider.dispatchEvent(new Event("input"));
  });
}
// Never the same text twice within 9 * 97 changes, as slider values of 0.01 to 9.
const valueOf = (i) => (1 + ((i * 37) % 801) / 100).toFixed(2);

async function change() {
  const all = await withPage(async (page) => {
    await aim(page);
    const times = [];
    for (let i = 0; i < changes + 5; ++i) {
      const time = await page.evaluate(slide, valueOf(i));
      if (i >= 5) times.push(time);
      await page.waitForTimeout(i % 3 === 0 ? 1100 : 50); // some become versions
    }
    return times;
  });
  for (const [name, words] of [["body", "the body"], ["asked", "the life is known"], ["life", "the robot in 3-D"]])
    console.log(`a number slid until ${words}${name === "asked" ? "" : " is seen"}, ms: ${summary(all.map((time) => time[name]))}`);
}

async function memory() {
  await withPage(async (page) => {
    await aim(page);
    const session = await page.context().newCDPSession(page);
    await session.send("Performance.enable");
    const mega = (bytes) => (bytes / 1e6).toFixed(1).padStart(8);
    console.log(" changes  JS heap  modules renderer      gpu, MB | nodes listeners buffers textures programs");
    const report = async (count) => {
      await page.waitForTimeout(2000);
      for (let i = 0; i < 3; ++i) await session.send("HeapProfiler.collectGarbage");
      const { metrics } = await session.send("Performance.getMetrics");
      const of = (name) => metrics.find((one) => one.name === name).value;
      const counts = await page.evaluate(() => window.watching.counts);
      const processes = await processBytes(browser);
      const { usedSize } = await session.send("Runtime.getHeapUsage");
      const row = [usedSize, await moduleBytes(page), processes.renderer, processes.GPU].map(mega).join(" ");
      console.log(`${String(count).padStart(8)} ${row}     | ${of("Nodes")} ${of("JSEventListeners")} ${counts.buffers} ${counts.textures} ${counts.programs}`);
    };
    // First the strip of versions is filled, which keeps 60 and their pictures.
    const slideAll = (from, count, rest) =>
      page.evaluate(
        async ([values, rest]) => {
          for (const value of values) {
            await window.slide(value, false);
            await new Promise((resolve) => setTimeout(resolve, rest));
          }
        },
        [Array.from({ length: count }, (_, i) => valueOf(from + i)), rest],
      );
    let done = 0;
    for (const until of [10, 70, 100, 200, 500, 1000, 2000, 5000, 10000].filter((one) => one <= most)) {
      while (done < until) {
        const batch = Math.min(50, until - done);
        await slideAll(done, batch, done < 70 ? 1000 : 0);
        done += batch;
      }
      await report(done);
    }
  });
}

console.log(`${machine()}, Chromium ${browser.version()}`);
if (most > 0) {
  await memory();
} else {
  await open();
  await change();
}
await browser.close();
