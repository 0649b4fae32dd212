// The page of `plsc view`: replays that move, and all that one can press.
import assert from "node:assert/strict";
import { readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { assertFitsWidth, desktop, downloaded, phone, plsc, scratch, screenshot, source, withPage } from "./browser.mjs";

const example = (name) => join(source, "examples", name);

// A page of these inputs and options; gives its path.
function made(name, ...args) {
  const file = join(scratch, name);
  plsc("view", ...args, "-o", file);
  return file;
}

const gecko = made("gecko.html", example("gecko.pls"));
const three = made(
  "three.html",
  ...["climber.pls", "gecko.pls", "spider.pls"].map(example),
  ...["--scenario", example("life.yaml")],
);

const timeOf = async (page) => parseFloat(await page.locator(".time").textContent());
const seasonOf = (page, i = 0) => page.locator(".now strong").nth(i).textContent();

// As withPage, opened at a time of the life, which then stands; see
// docs/replays.md.
const withPageAt = (time, file, size, use) =>
  withPage(
    file,
    size,
    async (page) => {
      await page.locator(".time").waitFor();
      await use(page);
    },
    { hash: `t=${time}` },
  );

// The picture when it has come to rest: what is asked for was drawn, and drawn
// finely, with two points of the canvas a point of the page, which on a machine
// without a graphics card is last.
async function still(page) {
  await page.evaluate(async () => {
    const canvas = document.querySelector(".stage canvas");
    const frame = () => new Promise(requestAnimationFrame);
    for (let frames = 0; frames < 1000; ++frames) {
      await frame();
      if (frames > 2 && canvas.width > 1.5 * canvas.clientWidth) return;
    }
    throw new Error("the picture does not come to rest");
  });
  return page.locator(".stage").screenshot();
}

// Pixels of the picture whose colour is near (r, g, b).
function pixels(page, picture, [r, g, b]) {
  return page.evaluate(
    async ([text, wanted]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${text}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [image.width, image.height];
      const pen = canvas.getContext("2d");
      pen.drawImage(image, 0, 0);
      const { data } = pen.getImageData(0, 0, image.width, image.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4)
        if (wanted.every((part, k) => Math.abs(data[i + k] - part) < 24)) ++count;
      return count;
    },
    [picture.toString("base64"), [r, g, b]],
  );
}
const coreYellow = [255, 238, 56]; // its upper side in the light

for (const [name, size] of [
  ["desktop", desktop],
  ["phone", phone],
])
  test(`a replay is seen, plays and stands (${name})`, () =>
    withPage(gecko, size, async (page) => {
      // It plays when it is opened.
      await page.waitForFunction(() => parseFloat(document.querySelector(".time").textContent) > 0.5);
      await assertFitsWidth(page);
      await page.getByRole("button", { name: "Pause" }).click();
      const time = await timeOf(page);
      const before = await still(page);
      assert.ok((await pixels(page, before, coreYellow)) > 300, "no core to be seen");
      assert.equal(await timeOf(page), time);
      await screenshot(page, `view-${name}`, { fullPage: true });
      await page.getByRole("button", { name: "Play" }).click();
      await page.waitForFunction((least) => parseFloat(document.querySelector(".time").textContent) > least, time + 1);
      await page.getByRole("button", { name: "Pause" }).click();
      const after = await still(page);
      assert.ok(!before.equals(after), "the picture does not move");
      assert.ok((await pixels(page, after, coreYellow)) > 300, "the camera lost the robot");
    }));

// On a slow machine the first frames are stamped with times before the script
// had run; others may be stamped out of order.
test("time never goes back, however frames are stamped", () =>
  withPage(
    gecko,
    desktop,
    async (page) => {
      await page.waitForFunction(() => window.timesSeen.length > 30);
      const times = await page.evaluate(() => window.timesSeen);
      assert.equal(times[0], 0);
      times.forEach((time, i) => assert.ok(time >= (times[i - 1] ?? 0), `${times[i - 1]} s, then ${time} s`));
      assert.ok(times.at(-1) > 0);
    },
    {
      prepare: () => {
        window.timesSeen = [];
        const frame = window.requestAnimationFrame.bind(window);
        let calls = 0;
        window.requestAnimationFrame = (draw) =>
          frame((now) => {
            const late = [-3000, -2000, 0, -500][calls++] ?? 0;
            draw(now + late);
            const shown = document.querySelector(".time")?.textContent;
            if (shown) window.timesSeen.push(parseFloat(shown));
          });
      },
    },
  ));

test("every button can be pressed, on a desktop and on a phone", async () => {
  for (const [file, size, least] of [
    [three, desktop, 40],
    [gecko, phone, 15],
  ])
    await withPage(file, size, async (page) => {
      const buttons = page.getByRole("button");
      const count = await buttons.count();
      assert.ok(count >= least, `${count} buttons`);
      for (let i = 0; i < count; ++i) await buttons.nth(i).click();
      for (const summary of await page.locator("summary").all()) await summary.click();
      assert.match(await page.locator("details pre").first().textContent(), /^plsc 1|genotype /);
      await assertFitsWidth(page);
    });
});

test("time can be scrubbed, stepped, jumped and sped up", () =>
  withPageAt(10, gecko, desktop, async (page) => {
    assert.equal(await page.locator(".play").textContent(), "Play");
    assert.equal(await seasonOf(page), "flat");
    const early = await still(page);
    await page.locator(".timeline input").fill("75");
    assert.equal(await timeOf(page), 75);
    assert.equal(await seasonOf(page), "tilted");
    assert.ok(!early.equals(await still(page)));
    await page.getByRole("button", { name: "Season before" }).click();
    assert.equal(await timeOf(page), 50);
    await page.getByRole("button", { name: "Season before" }).click();
    assert.equal(await timeOf(page), 0);
    await page.getByRole("button", { name: "Next season" }).click();
    assert.equal(await timeOf(page), 50);
    for (let i = 0; i < 5; ++i) await page.getByRole("button", { name: "A frame on" }).click();
    assert.equal(await timeOf(page), 50.1);
    for (let i = 0; i < 10; ++i) await page.getByRole("button", { name: "A frame back" }).click();
    assert.equal(await timeOf(page), 49.9);
    // Faster than the clock on the wall, which one at 1 x never is.
    await page.getByLabel("Speed").selectOption("20");
    const began = Date.now();
    await page.getByRole("button", { name: "Play" }).click();
    await page.waitForFunction(() => document.querySelector(".play").textContent === "Play");
    assert.equal(await timeOf(page), 100); // the end
    assert.ok(Date.now() - began < 50000);
    await page.getByRole("button", { name: "Play" }).click(); // begins anew
    assert.ok((await timeOf(page)) < 90);
  }));

test("keys play and move the time", () =>
  withPageAt(10, gecko, desktop, async (page) => {
    await page.keyboard.press("ArrowRight");
    assert.equal(await timeOf(page), 11);
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("ArrowLeft");
    assert.equal(await timeOf(page), 9);
    await page.keyboard.press("PageDown");
    assert.equal(await timeOf(page), 50);
    await page.keyboard.press(" ");
    assert.equal(await page.locator(".play").textContent(), "Pause");
  }));

test("the camera follows, or stays, and turns by mouse", () =>
  withPageAt(45, gecko, desktop, async (page) => {
    await page.getByRole("button", { name: "Follow" }).click();
    await page.locator(".timeline input").fill("5");
    const left = await still(page);
    assert.equal(await page.getByRole("button", { name: "Follow" }).getAttribute("aria-pressed"), "false");
    await page.getByRole("button", { name: "Follow" }).click();
    await page.locator(".timeline input").fill("5.02");
    const followed = await still(page);
    assert.ok((await pixels(page, followed, coreYellow)) > (await pixels(page, left, coreYellow)));
    const box = await page.locator(".surface").boundingBox();
    await page.mouse.move(box.x + 300, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 500, box.y + 220, { steps: 4 });
    await page.mouse.up();
    const turned = await still(page);
    assert.ok(!turned.equals(followed), "dragging does not turn it");
    await page.getByRole("button", { name: "Nearer" }).click();
    assert.ok((await pixels(page, await still(page), coreYellow)) > (await pixels(page, turned, coreYellow)));
    for (const view of ["Above", "Side", "Behind"]) {
      const before = await still(page);
      await page.getByRole("button", { name: view, exact: true }).click();
      assert.ok(!before.equals(await still(page)), view);
    }
  }));

test("seasons are marked, and say what came of them", () =>
  withPage(gecko, desktop, async (page) => {
    const marks = page.locator(".season");
    assert.deepEqual(await marks.allTextContents(), ["flat", "tilted"]);
    await marks.nth(1).click();
    assert.ok((await timeOf(page)) >= 50);
    assert.match(await page.locator(".now").textContent(), /tilted by 5°.*Speed \d.*cm\/s.*Balance 0\.9/s);
    assert.equal(await page.locator("tbody tr").count(), 2);
    assert.match(await page.locator("tbody tr").first().textContent(), /completed.*cm\/s/);
  }));

test("robots stand side by side, each with its own life", () =>
  withPageAt(21, three, desktop, async (page) => {
    assert.equal(await page.locator(".panel").count(), 3);
    const xs = await page.locator(".panel").evaluateAll((all) => all.map((one) => one.getBoundingClientRect().left));
    assert.ok(xs[0] < xs[1] && xs[1] < xs[2]);
    // Only the climber changes where it is tilted; how is said.
    const changes = await page.locator(".change").allTextContents();
    assert.match(changes[0], /^another body: inclined False → True .*15 modules, 8 joints/);
    assert.match(changes[1], /^the same robot/);
    const picture = await still(page);
    assert.ok((await pixels(page, picture, coreYellow)) > 900);
    await screenshot(page, "view-three");
    // What is new glows at first.
    const glowing = [255, 150, 120];
    await page.locator(".timeline input").fill("20");
    const first = await pixels(page, await still(page), glowing);
    await page.locator(".timeline input").fill("25");
    const later = await pixels(page, await still(page), glowing);
    assert.ok(first > later, `${first} glowing, then ${later}`);
    // Every ground can be shown.
    for (const [time, ground] of [[41, "rough"], [61, "steps"], [81, "obstacles"]]) {
      await page.locator(".timeline input").fill(String(time));
      assert.equal(await seasonOf(page), ground);
      assert.ok((await pixels(page, await still(page), coreYellow)) > 600);
      await screenshot(page, `view-${ground}`);
    }
  }));

test("plots have a row a joint, and a cursor that moves", () =>
  withPageAt(12, gecko, desktop, async (page) => {
    const cursor = page.locator(".plot-cursor");
    const before = await cursor.boundingBox();
    await page.locator(".timeline input").fill("14");
    const after = await cursor.boundingBox();
    assert.ok(after.x > before.x + 50);
    const canvas = page.locator(".plot canvas");
    assert.match(await canvas.getAttribute("aria-label"), /5 joints/);
    const blue = await pixels(page, await canvas.screenshot(), [0, 114, 178]);
    assert.ok(blue > 5 * 400, `${blue} pixels of curves`);
    await page.getByLabel("Plots show").selectOption("Infinity");
    assert.ok((await cursor.boundingBox()).x < after.x);
    assert.ok((await pixels(page, await canvas.screenshot(), [0, 114, 178])) > blue);
  }));

test("touch is seen in the plots", () => {
  const file = made("touch.html", example("climber.pls"), "--scenario", example("life.yaml"));
  return withPageAt(5, file, phone, async (page) => {
    await page.getByLabel("Plots show").selectOption("Infinity");
    assert.match(await page.locator(".plots .quiet").textContent(), /touch sensors/);
    await assertFitsWidth(page);
  });
});

test("pictures can be saved", () =>
  withPage(gecko, desktop, async (page) => {
    const { name, text } = await downloaded(page, page.getByRole("button", { name: "Save picture" }));
    assert.equal(name, "gecko.png");
    assert.match(text, /PNG/);
  }));

test("without WebGL the page says so, and plots", () =>
  withPage(gecko, desktop, async (page) => {
    await page.addInitScript(() => {
      const real = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        return kind.startsWith("webgl") ? null : real.call(this, kind, ...rest);
      };
    });
    await page.reload();
    assert.match(await page.getByRole("alert").textContent(), /no WebGL/);
    await page.waitForFunction(() => parseFloat(document.querySelector(".time").textContent) > 0.3);
    assert.equal(await page.getByRole("button", { name: "Follow" }).count(), 0);
    assert.ok((await pixels(page, await page.locator(".plot canvas").screenshot(), [0, 114, 178])) > 1000);
    await screenshot(page, "view-blind");
  }));

const hostile = `</script><script>alert(1)</script><img src=x onerror=alert(2)>&lt;b&gt;"'`;

function recordingWith(change) {
  const scenario = join(scratch, "short.yaml");
  writeFileSync(scenario, "plsc_scenario: 1\nseasons: [{name: a, terrain: flat, duration: 1 s}]\n");
  const file = join(scratch, "short.rec.json");
  plsc("simulate", example("gecko.pls"), "--scenario", scenario, "--record", file);
  const recording = JSON.parse(readFileSync(file, "utf8"));
  change(recording);
  const changed = join(scratch, "changed.rec.json");
  writeFileSync(changed, JSON.stringify(recording));
  return changed;
}

test("names with HTML and script in them are text", () => {
  const recording = recordingWith((one) => {
    one.name = hostile;
    one.genotype = hostile;
    one.scenario = hostile;
    Object.assign(one.seasons[0], { name: hostile, change_reason: hostile, reason: hostile });
    one.seasons[0].body.modules.forEach((module) => (module.id = hostile));
  });
  return withPageAt(0.5, made("hostile.html", recording), phone, async (page) => {
    assert.equal(await page.locator(".who h2").textContent(), hostile);
    assert.equal(await seasonOf(page), hostile);
    assert.equal(await page.locator("details pre").first().textContent(), hostile);
    assert.equal(await page.title(), hostile);
    assert.ok((await page.locator(".change").textContent()).includes(hostile));
    assert.equal(await page.locator("img").count(), 0);
    await assertFitsWidth(page);
    await screenshot(page, "view-hostile");
  });
});

test("a season that nobody lived is told", () => {
  const recording = recordingWith((one) => {
    const season = one.seasons[0];
    Object.assign(season, { outcome: "overlapping", reason: "modules 2 and 3", speed: null, balance: null, fitness: null });
    season.motion.samples = 0;
    for (const track of ["steps", "position", "turn", "joint_angle", "touch"])
      Object.assign(season.motion[track], { rows: 0, data: "" });
  });
  return withPageAt(0.5, made("unlived.html", recording), desktop, async (page) => {
    assert.match(await page.locator(".end").textContent(), /overlapping: modules 2 and 3/);
    assert.match(await page.locator(".now").textContent(), /Speed –/);
    await still(page);
    await screenshot(page, "view-unlived");
  });
});

test("100 s of 15 modules are less than 2 MB", () => {
  // Every module but the core is a joint that swings, so a link of its own.
  const worm = join(scratch, "worm.pls");
  writeFileSync(
    worm,
    "plsc 1\ngenotype worm\nalphabet plasticoding 1\niterations 14\nmax_modules 15\n" +
      "rule C -> { C add_front A1(0.5, 1.5, 3.0, 2.0) move_front }\n" +
      "rule A1 -> { A1(0.5, 1.5, 3.0, 2.0) mutate_off(-0.1) }\n",
  );
  const file = made("long.html", worm);
  assert.match(readFileSync(file, "utf8"), /"id":"15"/);
  const { size } = statSync(file);
  assert.ok(size < 2e6, `${size} bytes`);
});
