// The page with plsc in it, opened from disk: nothing answers but its own module
// (-DPLSC_MODULE=FOLDER; without one there is no such page, and nothing to try).
import assert from "node:assert/strict";
import { statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { desktop, phone, plsc, scratch, screenshot, withPage, assertFitsWidth } from "./browser.mjs";
import { cursorBehind, example, scenario, versions } from "./live.mjs";

writeFileSync(join(scratch, "robot.pls"), example("climber"));
writeFileSync(join(scratch, "short.yaml"), scenario);
let why = false;
try {
  plsc("view", "--editable", "robot.pls", "--scenario", "short.yaml", "-o", "robot.html");
} catch (error) {
  why = /docs\/web\.md/.test(error.stderr) ? "this plsc has no module for pages" : false;
  if (!why) throw error;
}

for (const size of [desktop, phone])
  test(`${size.width} px: a robot is edited and lives without plsc or a network`, { skip: why }, () =>
    withPage(join(scratch, "robot.html"), size, async (page) => {
      await versions(page, 1);
      if (size === desktop) {
        await cursorBehind(page, "A2(0.4, 1.0, 2.0, 1.5)");
        await page.keyboard.press("Control+Shift+k");
        await versions(page, 2);
      }
      await page.locator(".cm-line").first().click();
      await page.keyboard.press("End");
      await page.keyboard.type("\nnonsense");
      await page.locator(".wrong", { hasText: /./ }).waitFor();
      await assertFitsWidth(page);
      await screenshot(page, `live-disk-${size.width}`);
    }),
  );

test("the page can be sent by mail", { skip: why }, () => {
  assert.ok(statSync(join(scratch, "robot.html")).size < 1600000);
});
