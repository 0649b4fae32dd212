// The live page: what it shows, what it hands out, what may come in.
import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { assertFitsWidth, desktop, downloaded, phone, screenshot } from "./browser.mjs";
import { askedText, asks, count, cursorBehind, example, lineWith, modules, scenario, versions, withRobot } from "./live.mjs";

const linkOf = (value) => `r=${deflateRawSync(typeof value === "string" ? value : JSON.stringify(value)).toString("base64url")}`;

for (const [size, name] of [[desktop, "desktop"], [phone, "phone"]])
  test(`the robot is there, in words, drawings and 3-D, on a ${name}`, () =>
    withRobot(
      async (page) => {
        await assertFitsWidth(page);
        await modules(page, 12); // and a sensor
        assert.equal(await count(page, ".workings svg.body"), 2);
        assert.equal(await count(page, ".panel"), 2);
        for (const text of await page.locator(".now").allTextContents()) assert.match(text, /Speed −?[\d.]+ cm\/s.*Balance [\d.]+/);
        await page.locator(".of-keyword", { hasText: "genotype" }).waitFor();
        if (size === desktop) await page.locator(".hint", { hasText: "active" }).first().waitFor();
        // Something is drawn: the core's yellow.
        const picture = await page.locator(".stage").screenshot();
        assert.ok(picture.length > 10000);
        await screenshot(page, `live-${name}`);
        await screenshot(page, `live-${name}-whole`, { fullPage: true });
      },
      { robot: "climber", size },
    ));

test("pointing at a module lights up what made it, in the text too, and the other way round", () =>
  withRobot(
    async (page) => {
      await page.locator('.workings [data-key="mod:1:11"]').hover();
      assert.equal(await page.locator(".cm-line .lit").first().textContent(), "A1(0.7, 2.0, 2.0, 1.25)");
      assert.match(await page.locator(".told").textContent(), /module 12 \(A1\) in tilted/);
      await page.locator("h1").hover();
      assert.equal(await count(page, ".cm-line .lit"), 0);
      await lineWith(page, "T(0.5)").click();
      await page.locator('.workings .module.lit[aria-label="sensor 1, T"], .workings .module.lit').first().waitFor();
      assert.equal(await count(page, ".workings .module.lit"), 1);
    },
    { robot: "climber" },
  ));

test("a truth table stands where the pointer is on a clause", () =>
  withRobot(
    async (page) => {
      await lineWith(page, "rule C -> if inclined = False").scrollIntoViewIfNeeded();
      await page.locator(".cm-line", { hasText: "if inclined = False" }).locator("span", { hasText: "inclined" }).hover();
      await page.locator(".cm-tooltip-hover table").waitFor();
      assert.match(await page.locator(".cm-tooltip-hover").textContent(), /False\s*yes.*Active in 1 of 2 environments/s);
      await screenshot(page, "live-hover");
    },
    { robot: "climber" },
  ));

test("a robot travels as a link", async () => {
  let link = "";
  await withRobot(async (page) => {
    await cursorBehind(page, "A2(0.4, lift, beat, 1.5)");
    await page.keyboard.press("Control+Shift+k");
    await versions(page, 2);
    await page.getByRole("button", { name: "Link" }).click();
    await page.waitForFunction(() => location.hash.startsWith("#r="));
    link = await page.evaluate(() => location.hash.slice(1));
    assert.ok(link.length < 2000, `${link.length} characters`);
  });
  await withRobot(
    async (page, server) => {
      await page.getByRole("heading", { name: "gecko.pls" }).waitFor();
      await modules(page, 9);
      assert.notEqual(askedText(server), example("gecko"));
      assert.equal(asks(server, "explain").length, 1, "the page's own robot was not made before");
    },
    { robot: "climber", hash: link },
  );
});

const script = "<img src=x onerror=alert(1)><script>alert(2)</script>";
for (const [what, hash, words] of [
  ["cut off", linkOf({ text: example("climber") }).slice(0, 300), /damaged/],
  ["no base64", "r=%%%", /damaged/],
  ["no robot", linkOf([1, 2]), /holds no robot/],
  ["of another type", linkOf({ text: 7 }), /holds no robot/],
  ["immense when unpacked", linkOf({ text: "x".repeat(1 << 26) }), /too much for a robot/],
])
  test(`a link that is ${what} gets a word, and the page's robot is there`, () =>
    withRobot(
      async (page) => {
        await modules(page, 11);
        assert.match(await page.locator(".notice").textContent(), words);
      },
      { hash },
    ));

test("a link's names, texts and mistakes are text", () =>
  withRobot(
    async (page) => {
      await page.locator(".wrong", { hasText: /./ }).waitFor();
      assert.equal(await page.locator("h1").textContent(), script);
      assert.equal(await count(page, "img, h1 *, .wrong *"), 0);
    },
    { hash: linkOf({ name: script, text: `plsc 1\ngenotype ${script}\n`, scenario: script }), isLiving: false },
  ));

test("a genotype that grows beyond all bounds is ended with a word", () => {
  const text = "plsc 1\ngenotype big\nalphabet plasticoding 1\niterations 20\nrule C -> { C add_left B }\nrule B -> { B add_front B add_left B }\n";
  return withRobot(
    async (page) => {
      await page.locator(".wrong", { hasText: /3486784401 symbols/ }).waitFor();
      // And the page goes on.
      await page.locator(".cm-content").focus();
      await page.keyboard.press("Control+a");
      await page.keyboard.insertText("plsc 1\ngenotype small\nalphabet plasticoding 1\niterations 1\nrule C -> { C add_left B }\n");
      await modules(page, 2);
    },
    { hash: linkOf({ text }), isLiving: false },
  );
});

test("text, drawing and recording can be taken along", () =>
  withRobot(async (page) => {
    const take = async (name) => {
      await page.getByText("Download").click();
      return downloaded(page, page.getByRole("button", { name }));
    };
    assert.deepEqual(await take(/Genotype/), { name: "gecko.pls", text: example("gecko") });
    const drawing = await take(/Drawing of the bodies/);
    assert.equal(drawing.name, "gecko.svg");
    assert.match(drawing.text, /<svg/);
    const recording = await take(/Recording/);
    assert.equal(recording.name, "gecko.rec.json");
    assert.equal(JSON.parse(recording.text).seasons.length, 2);
  }));

test("a page that needs nobody hands itself out, with the robot as it is now", () =>
  withRobot(
    async (page) => {
      await cursorBehind(page, "genotype gecko");
      await page.keyboard.type("s # </script>");
      await page.getByText("Download").click();
      const { name, text } = await downloaded(page, page.getByRole("button", { name: "This page" }));
      assert.equal(name, "gecko.html");
      assert.match(text, /Content-Security-Policy/);
      assert.match(text, /genotype geckos # \\u003c\/script>/);
      assert.equal(text.match(/<\/script>/g).length, 2);
      assert.ok(text.includes('"packed":"QUJD"'));
    },
    { module: { packed: "QUJD", glue: "" } },
  ));

test("the scenario changes by its controls and as text, and a mistake in it is told", () =>
  withRobot(
    async (page, server) => {
      await page.locator("header summary", { hasText: "Scenario" }).click();
      await page.getByLabel("Slope of tilted, degrees").fill("12");
      await page.keyboard.press("Enter");
      await page.locator(".panel .who", { hasText: "12°" }).waitFor();
      assert.match(asks(server, "live").at(-1).scenario, /tilted: 12 deg/);
      await page.getByLabel("Duration of flat, seconds").fill("2");
      await page.keyboard.press("Enter");
      await page.waitForFunction(() => /flat −?[\d.]+/.test(document.querySelector(".version[aria-current]").title));
      await page.getByText("As YAML").click();
      const yaml = page.getByLabel("The scenario as YAML");
      await screenshot(page, "live-scenario");
      await yaml.fill("plsc_scenario: 1\nprofil: swift\n");
      await page.locator(".fault", { hasText: /profil/ }).waitFor();
      await yaml.fill(scenario.replace("5 deg", "8 deg"));
      await page.locator(".panel .who", { hasText: "8°" }).waitFor();
      assert.equal(await page.locator(".fault").textContent(), "");
    },
    { robot: "climber" },
  ));

test("what another program saves is in the page, what is edited here is saved, both are shown where both changed", () =>
  withRobot(
    async (page, server) => {
      server.change(example("climber"));
      await page.waitForFunction(() => document.querySelectorAll(".workings svg.body").length === 2);
      await cursorBehind(page, "genotype climber");
      await page.keyboard.type("s");
      await page.waitForFunction(() => document.querySelector(".status").textContent === "saved");
      assert.match(server.file.text, /genotype climbers/);
      // Both at once: neither is lost.
      server.file.text = example("gecko");
      ++server.file.version;
      await page.keyboard.type("x");
      await page.locator(".conflict").waitFor();
      const [theirs, ours] = await page.locator(".conflict pre").allTextContents();
      assert.equal(theirs, example("gecko"));
      assert.match(ours, /genotype climbersx/);
      assert.equal(server.file.text, example("gecko"), "not saved over");
      await screenshot(page, "live-conflict");
      await page.getByRole("button", { name: "Keep this one" }).click();
      await page.waitForFunction(() => document.querySelector(".status").textContent === "saved");
      assert.match(server.file.text, /genotype climbersx/);
    },
    { isJoined: true },
  ));

// Counts what is on the graphics card, before the page's own scripts run.
function countBuffers() {
  window.buffers = 0;
  const { createBuffer, deleteBuffer } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.createBuffer = function () {
    ++window.buffers;
    return createBuffer.call(this);
  };
  WebGL2RenderingContext.prototype.deleteBuffer = function (buffer) {
    --window.buffers;
    return deleteBuffer.call(this, buffer);
  };
}

test("robots that are gone leave nothing on the graphics card", () =>
  withRobot(
    async (page) => {
      const flip = async (many) => {
        for (let i = 0; i < many; ++i) {
          await page.locator(".version").nth(i % 2).click();
          await page.waitForFunction((k) => document.querySelectorAll(".version")[k].hasAttribute("aria-current"), i % 2);
          await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
        }
        return page.evaluate(() => window.buffers);
      };
      await cursorBehind(page, "A2(0.4, lift, beat, 1.5)");
      await page.keyboard.press("Control+Shift+k");
      await versions(page, 2);
      const before = await flip(4);
      assert.ok(before > 10);
      assert.equal(await flip(10), before);
    },
    { prepare: countBuffers },
  ));

test("all can be reached by keys, and each has a name", () =>
  withRobot(async (page) => {
    const seen = new Set();
    await page.locator("h1").click();
    for (let i = 0; i < 60; ++i) {
      await page.keyboard.press("Tab");
      const one = await page.evaluate(() => {
        const { activeElement: at } = document;
        const name = at.getAttribute("aria-label") ?? at.labels?.[0]?.textContent ?? at.textContent;
        return at === document.body ? null : { tag: at.tagName, name: name.trim().slice(0, 30) };
      });
      if (!one) break;
      assert.notEqual(one.name, "", `a ${one.tag} without a name`);
      seen.add(one.name);
    }
    for (const name of ["Scenario", "Format", "Genotype", "Pause", "Time, seconds", "module 1, C"]) assert.ok([...seen].includes(name), `${name} of ${[...seen]}`);
  }));
