// The live page, edited in ten ways: each time the robot follows.
import assert from "node:assert/strict";
import { test } from "node:test";
import { screenshot } from "./browser.mjs";
import { askedText, asks, count, cursorBehind, example, lineWith, modules, versions, withRobot } from "./live.mjs";

const gecko = 11; // modules
const list = (page) => page.locator(".cm-tooltip-autocomplete");

test("typing grows a module, undo takes it back", () =>
  withRobot(async (page, server) => {
    await modules(page, gecko);
    // On the shoulder's front, where nothing is.
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("End");
    await page.keyboard.type("\nadd_front\nB ");
    await modules(page, gecko + 1);
    assert.match(askedText(server), /move_back\n {2}add_front\n {2}B/);
    for (let i = 0; i < 12 && askedText(server) !== example("gecko"); ++i) {
      await page.keyboard.press("Control+z");
      await page.waitForTimeout(200);
    }
    await modules(page, gecko);
    assert.equal(askedText(server), example("gecko"));
  }));

test("a line that is deleted takes its module away, pasting brings it back", () =>
  withRobot(async (page) => {
    await cursorBehind(page, "A2(0.4, lift, beat, 1.5)");
    await page.keyboard.press("Control+Shift+k");
    await modules(page, gecko - 2); // and the brick that was mounted on it
    await page.keyboard.insertText("  A2(0.4, lift, beat, 1.5)\n");
    await modules(page, gecko);
  }));

test("a comment switches a rule's symbol off", () =>
  withRobot(async (page) => {
    await cursorBehind(page, "A1(0.7, bend, beat, 1.75)");
    await page.keyboard.press("Control+/");
    await page.waitForFunction((before) => document.querySelectorAll(".workings svg.body .module").length !== before, await count(page, ".workings svg.body .module"));
    await page.keyboard.press("Control+/");
    await modules(page, gecko);
  }));

test("a mistake keeps the last robot in view, greyed, and its fix mends it", () =>
  withRobot(async (page) => {
    await cursorBehind(page, "A1(0.7, bend, beat, 1.75)");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("End");
    await page.keyboard.type("t");
    await page.locator(".stale").waitFor();
    assert.match(await page.locator(".wrong").textContent(), /unknown symbol 'move_frontt'/);
    assert.equal(await count(page, ".workings .environment:first-child svg.body .module"), gecko);
    await page.waitForFunction(() => Number(getComputedStyle(document.querySelector(".stage")).opacity) < 0.7);
    await page.locator(".cm-lintRange-error").hover();
    await screenshot(page, "live-mistake");
    await page.locator(".cm-diagnosticAction", { hasText: "Replace 'move_frontt' by 'move_front'" }).click();
    await modules(page, gecko);
    assert.equal(await count(page, ".stale"), 0);
  }));

test("completion offers symbols with their arguments and takes them in", () =>
  withRobot(async (page, server) => {
    await cursorBehind(page, "A1(0.7, bend, beat, 1.75)");
    await page.keyboard.press("Enter");
    await page.keyboard.type("move_f");
    await list(page).waitFor();
    await screenshot(page, "live-completion");
    await page.waitForTimeout(150); // CodeMirror takes no key sooner: it may be meant for the text
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => [...document.querySelectorAll(".cm-line")].filter((line) => line.textContent.trim() === "move_front").length === 3);
    await versions(page, 2);
    assert.match(askedText(server), /1\.75\)\n {2}move_front\n {2}move_front\n/);
  }));

test("format lays the text out, by button and by keys", () =>
  withRobot(async (page) => {
    // The first of the two lines, which a long indentation was given to.
    const indented = (wanted) =>
      page.waitForFunction((text) => [...document.querySelectorAll(".cm-line")].find((line) => /add_left/.test(line.textContent)).textContent === text, `${wanted}add_left`);
    const spoil = async () => {
      await lineWith(page, "add_left").click();
      await page.keyboard.press("Home");
      await page.keyboard.type("      ");
      await indented("        ");
    };
    await spoil();
    await page.getByRole("button", { name: "Format" }).click();
    await indented("  ");
    await spoil();
    await page.keyboard.press("Shift+Alt+F");
    await indented("  ");
    await modules(page, gecko);
  }));

test("the slider of the number under the cursor lives on while it is dragged", () =>
  withRobot(async (page, server) => {
    await lineWith(page, "let beat = 2.0").click();
    await page.keyboard.press("Home");
    for (let i = 0; i < 12; ++i) await page.keyboard.press("ArrowRight");
    const slider = page.locator("#slider");
    await slider.waitFor();
    assert.equal(await slider.inputValue(), "2");
    const speed = () => page.locator(".now .measure").first().textContent();
    const before = await speed();
    await slider.focus();
    for (let i = 0; i < 5; ++i) await page.keyboard.press("ArrowRight");
    await page.waitForFunction((old) => document.querySelector(".now .measure").textContent !== old, before);
    await versions(page, 2);
    const beat = Number(/let beat = ([\d.]+)/.exec(askedText(server))[1]);
    assert.ok(beat > 2, `${beat}`);
    assert.equal(await page.locator(".parameter output").textContent(), String(beat));
    // What that changed is told, in the text and in the robot.
    const changes = page.locator(".changes");
    await changes.locator("li", { hasText: "let beat" }).waitFor();
    assert.match(await changes.textContent(), /period of node/);
    await screenshot(page, "live-slider");
  }));

test("two hundred changes at once do not queue up, and the last one is shown", () =>
  withRobot(async (page, server) => {
    await lineWith(page, "let beat = 2.0").click();
    await page.keyboard.press("Home");
    for (let i = 0; i < 12; ++i) await page.keyboard.press("ArrowRight");
    await page.locator("#slider").waitFor();
    const before = asks(server, "live").length;
    await page.evaluate(async () => {
      const slider = document.querySelector("#slider");
      for (let i = 0; i < 200; ++i) {
        slider.value = 1 + ((i % 90) / 90) * 9;
        slider.dispatchEvent(new Event("input"));
        if (i % 20 === 19) await new Promise((resolve) => setTimeout(resolve));
      }
    });
    await versions(page, 2);
    assert.ok(asks(server, "live").length - before < 30, `${asks(server, "live").length - before} lives`);
    assert.ok(asks(server, "lsp").filter((one) => one.message.method === "textDocument/didChange").length < 60);
    const shown = await page.locator(".parameter output").textContent();
    assert.match(askedText(server), new RegExp(`let beat = ${shown.replace(".", "\\.")} `));
  }));

test("versions stand in a strip, and a press goes back to one", () =>
  withRobot(async (page, server) => {
    await cursorBehind(page, "A2(0.4, lift, beat, 1.5)");
    await page.keyboard.press("Control+Shift+k");
    await versions(page, 2);
    await modules(page, gecko - 2);
    assert.equal(await count(page, ".version[aria-current]"), 1);
    const labels = await page.locator(".version").evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")));
    assert.match(labels[1], /^Version 2: flat −?[\d.]+ cm\/s, tilted /);
    await page.locator(".version").first().click();
    await modules(page, gecko);
    assert.equal(askedText(server), example("gecko"));
    assert.equal(await page.locator(".version").first().getAttribute("aria-current"), "true");
    assert.equal(await count(page, ".version"), 2, "going back is no version of its own");
  }));

test("the gallery opens another robot", () =>
  withRobot(
    async (page) => {
      await page.getByText("Gallery").click();
      await page.getByRole("button", { name: /^climber/ }).click();
      await page.getByRole("heading", { name: "climber.pls" }).waitFor();
      await page.waitForFunction(() => document.querySelectorAll(".workings svg.body").length === 2);
      assert.equal(await page.locator(".environment h3").first().textContent(), "flat inclined=False");
      await page.locator(".hint", { hasText: "active" }).first().waitFor();
      await screenshot(page, "live-climber");
    },
    { gallery: [{ name: "climber.pls", text: example("climber"), note: "two bodies" }] },
  ));
