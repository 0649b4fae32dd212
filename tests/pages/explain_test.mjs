// The page of `plsc view --explain`: what is pointed at lights up with all that
// belongs to it.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { assertFitsWidth, desktop, phone, plsc, scratch, screenshot, source, withPage } from "./browser.mjs";

function explain(name, ...args) {
  const file = join(scratch, `${name}.html`);
  plsc("view", "--explain", ...args, "-o", file);
  return file;
}
const climber = explain("climber", join(source, "examples/climber.pls"));

const keysOf = (page, name) =>
  page.$$eval(`.${name}[data-key]`, (all) => [...new Set(all.map((one) => one.dataset.key))].sort());
const count = (page, selector) => page.locator(selector).count();
const told = (page) => page.locator(".lines p").allTextContents();

// What plsc itself says of a robot.
function developed(environment) {
  const args = ["develop", join(source, "examples/climber.pls"), "--env", environment];
  return JSON.parse(plsc(...args, "--trace", "--format", "json"));
}

for (const [size, name] of [[desktop, "desktop"], [phone, "phone"]])
  test(`the page shows all that develop --trace tells, on a ${name}`, () =>
    withPage(climber, size, async (page) => {
      await assertFitsWidth(page);
      assert.equal(await count(page, ".environment"), 2);
      for (const [e, environment] of ["flat", "tilted"].entries()) {
        const robot = developed(environment);
        assert.equal(await count(page, `[data-key^="ev:${e}:"]`), robot.trace.events.length);
        const shown = robot.trace.derivation.steps.flat().length;
        assert.equal(await count(page, `.steps [data-key^="in:${e}:"]`), shown);
        const modules = robot.body_descriptors.absolute_size + robot.body_descriptors.touch_sensor_count;
        assert.equal(await count(page, `.module[data-key^="mod:${e}:"]`), modules);
        assert.equal(await count(page, `[data-key^="node:${e}:"]`), robot.brain.nodes.length);
        assert.equal(await count(page, `[data-key^="edge:${e}:"]`), robot.brain.connections.length);
        const active = await page.$$eval(
          ".rule",
          (rules, at) => rules.flatMap((rule, i) => (rule.querySelectorAll(".verdicts li")[at].className === "active" ? [i + 1] : [])),
          e,
        );
        assert.deepEqual(active, robot.active_rules);
      }
      await screenshot(page, `explain-${name}`, { fullPage: true });
    }));

test("pointing at a module lights up its rule and the symbols that made it", () =>
  withPage(climber, desktop, async (page) => {
    const robot = developed("tilted");
    const index = robot.trace.events.findIndex((event) => event.effect === "mounted" && event.module === "12");
    const event = robot.trace.events[index];
    const symbol = robot.trace.derivation.symbols[event.id - 1];
    await page.locator('[data-key="mod:1:11"]').hover();
    const lit = await keysOf(page, "lit");
    for (const key of [
      "mod:1:11",
      `ev:1:${index + 1}`,
      `in:1:${event.id}`,
      `rule:${symbol.rule}`,
      `symbol:${symbol.rule}:${symbol.position}`,
      `node:1:${Number(event.node.slice(4)) - 1}`,
    ])
      assert.ok(lit.includes(key), `${key} is lit`);
    assert.ok(!lit.includes("mod:1:10"), "no other module is");
    assert.deepEqual(lit.filter((key) => key.startsWith("rule:")), [`rule:${symbol.rule}`]);
    assert.ok((await keysOf(page, "kin")).includes(`ev:1:${event.partner}`), "the mounting command helped");
    const lines = await told(page);
    assert.match(lines[0], /module 12 \(A1\) in tilted/);
    assert.ok(lines.some((line) => line.includes(event.text)));
    await screenshot(page, "explain-module");
    // Away from it, nothing is lit.
    await page.locator("h1").hover();
    assert.deepEqual(await keysOf(page, "lit"), []);
    assert.match((await told(page))[0], /Point at/);
  }));

test("pointing at a rule lights up the modules that it made, everywhere", () =>
  withPage(climber, desktop, async (page) => {
    await page.locator('.rule [data-key="rule:3"]').hover();
    const lit = await keysOf(page, "lit");
    assert.deepEqual(lit.filter((key) => key.startsWith("mod:")), ["mod:1:11", "mod:1:12", "mod:1:13", "mod:1:14"]);
    assert.deepEqual(lit.filter((key) => key.startsWith("rule:")), ["rule:3"]);
    const lines = await told(page);
    assert.ok(lines.includes("flat: not active"));
    assert.ok(lines.includes("tilted: active, made modules 12, 13, 14, 15"));
    await screenshot(page, "explain-rule");
  }));

test("pointing at symbols lights up what they did, in lists, strings and text", () =>
  withPage(climber, desktop, async (page) => {
    const robot = developed("flat");
    const index = robot.trace.events.findIndex((event) => event.module === "2" && event.effect === "mounted");
    for (const selector of [`[data-key="ev:0:${index + 1}"]`, `.steps [data-key="in:0:${robot.trace.events[index].id}"]`]) {
      await page.locator(selector).last().hover();
      assert.ok((await keysOf(page, "lit")).includes("mod:0:1"), selector);
    }
    const symbol = robot.trace.derivation.symbols[robot.trace.events[index].id - 1];
    await page.locator(`pre [data-key="symbol:${symbol.rule}:${symbol.position}"]`).hover();
    const lit = await keysOf(page, "lit");
    assert.ok(lit.includes("mod:0:1") && lit.includes("mod:1:1"), "in both environments");
    // The axiom is what all came of.
    await page.locator('.steps [data-key="in:0:1"]').first().hover();
    assert.equal((await keysOf(page, "lit")).filter((key) => key.startsWith("mod:0:")).length, robot.body_descriptors.absolute_size + 1);
  }));

test("a press keeps it, Escape and the button let go", () =>
  withPage(climber, desktop, async (page) => {
    const release = page.getByRole("button", { name: "Let go" });
    await page.locator('[data-key="mod:0:1"]').click();
    await page.locator("h1").hover();
    assert.ok((await keysOf(page, "lit")).includes("mod:0:1"));
    await release.click();
    assert.deepEqual(await keysOf(page, "lit"), []);
    assert.equal(await release.isVisible(), false);
    await page.locator('[data-key="mod:0:2"]').click();
    await page.keyboard.press("Escape");
    assert.deepEqual(await keysOf(page, "lit"), []);
  }));

test("a tap on a phone keeps it and tells about it in sight", () =>
  withPage(climber, phone, async (page) => {
    await page.locator('[data-key="mod:0:6"]').click();
    assert.ok((await keysOf(page, "lit")).includes("mod:0:6"));
    const about = await page.locator(".about").boundingBox();
    assert.ok(about.y + about.height <= phone.height + 1);
    assert.match((await told(page))[0], /module 7 \(B\)/);
    await screenshot(page, "explain-phone-module");
  }));

test("keys walk through modules and symbols", () =>
  withPage(climber, desktop, async (page) => {
    await page.locator('[data-key="mod:0:0"]').focus();
    assert.match((await told(page))[0], /module 1 \(C\)/);
    await page.keyboard.press("ArrowRight");
    assert.match((await told(page))[0], /module 2 \(A2\)/);
    await page.keyboard.press("Enter");
    assert.ok(await page.getByRole("button", { name: "Let go" }).isVisible());
    await page.keyboard.press("Enter");
    await page.locator('[data-key="ev:0:1"]').focus();
    await page.keyboard.press("ArrowDown");
    assert.match((await told(page))[1], /^symbol 2 of /);
  }));

test("colours by rule", () =>
  withPage(climber, desktop, async (page) => {
    const fill = (key) => page.locator(`[data-key="${key}"] .face`).getAttribute("fill");
    assert.notEqual(await fill("mod:1:1"), await fill("mod:1:2"));
    await page.getByRole("button", { name: "rule", exact: true }).click();
    assert.equal(await fill("mod:1:1"), await fill("mod:1:2"));
    assert.notEqual(await fill("mod:1:1"), await fill("mod:1:11"));
    assert.equal(await count(page, ".swatch"), 3);
    await page.getByRole("button", { name: "type", exact: true }).click();
    assert.equal(await count(page, ".swatch"), 0);
  }));

test("symbols that are not expressed say why, and can be hidden", () => {
  const file = join(scratch, "full.pls");
  writeFileSync(file, "plsc 1\ngenotype full\nalphabet plasticoding 1\niterations 1\nrule C -> { C B add_left B add_left B loop(0.5) }\n");
  return withPage(explain("full", file), desktop, async (page) => {
    const visible = () => page.locator(".silent:visible").count();
    const before = await visible();
    assert.equal(before, 4);
    await page.locator('[data-key="ev:0:6"]').hover();
    assert.match((await told(page))[1], /not expressed \(IV\): .*taken by module 2/);
    assert.ok((await keysOf(page, "lit")).includes("rule:1"));
    await page.getByLabel("hide symbols that are not expressed").check();
    assert.equal(await visible(), 0);
    await page.getByLabel("hide symbols that are not expressed").uncheck();
    assert.equal(await visible(), before);
  });
});

test("every symbol and part can be pointed at without a fault", () =>
  withPage(explain("desert", join(source, "examples/desert.pls"), join(source, "examples/spider.pls")), desktop, async (page) => {
    for (const robot of ["desert", "spider"]) {
      await page.getByRole("button", { name: robot, exact: true }).click();
      const pointed = await page.evaluate(() => {
        const all = [...document.querySelectorAll("[data-key]")];
        const nothing = all.filter((one) => {
          one.dispatchEvent(new PointerEvent("pointerover", { bubbles: true, pointerType: "mouse" }));
          return !one.classList.contains("lit") || document.querySelectorAll(".lines p").length === 0;
        });
        return [all.length, nothing.map((one) => one.dataset.key)];
      });
      assert.ok(pointed[0] > 100);
      assert.deepEqual(pointed[1], []);
    }
    await screenshot(page, "explain-spider");
  }));

test("names, comments and files with HTML in them are text", () => {
  const script = "<script>alert(1)</script><img src=x onerror=alert(2)>&amp;\u00e9\u{1f916}";
  const file = join(scratch, "<b>evil.pls");
  writeFileSync(
    file,
    `# ${script}\nplsc 1\ngenotype shy # ${script}\nalphabet plasticoding 1\nsense hot: bool\n` +
      `iterations 1\nrule C -> if hot = True then { C # ${script}\n add_left B }\n` +
      "environment hot { hot = True }\nenvironment cold { hot = False }\n",
  );
  return withPage(explain("evil", file), desktop, async (page) => {
    assert.equal(await count(page, "main script, main img, main b b"), 0);
    const text = await page.locator("pre").textContent();
    assert.ok(text.includes(`# ${script}\nplsc 1`));
    assert.match(await page.locator("summary").textContent(), /<b>evil\.pls/);
    // Bytes and characters differ before the symbols, which are still found.
    assert.equal(await page.locator('pre [data-key="symbol:1:3"]').textContent(), "B");
  });
});

test("a robot of a run is explained in its seasons", () => {
  const season = (name, terrain) => `    - {name: ${name}, terrain: ${terrain}, duration: 1 s}\n`;
  writeFileSync(
    join(scratch, "tiny.yaml"),
    "plsc_experiment: 1\npopulation: 4\noffspring: 4\ngenerations: 2\nscenario:\n  seasons:\n" +
      season("flat", "flat") + season("hill", "{tilted: 5 deg}"),
  );
  plsc("evolve", "tiny.yaml", "-o", "tiny.sqlite", "--quiet");
  return withPage(explain("run", join(scratch, "tiny.sqlite"), "2", "best"), phone, async (page) => {
    await assertFitsWidth(page);
    assert.deepEqual(await page.locator(".environment h2").evaluateAll((all) => all.map((one) => one.firstChild.data)), ["flat", "hill"]);
    await page.getByRole("button", { name: /^robot_/ }).last().click();
    assert.equal(await count(page, ".environment"), 2);
    await screenshot(page, "explain-run", { fullPage: true });
  });
});
