// The judge is judged: what must fail a page's test does.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { assertFitsWidth, desktop, downloaded, phone, scratch, withPage } from "./browser.mjs";

function pageWith(body) {
  const file = join(scratch, "page.html");
  writeFileSync(file, `<!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,">${body}`);
  return file;
}
// What happened while it was loaded has been told before this is answered.
const idle = (page) => page.evaluate(() => new Promise(requestAnimationFrame));

test("a page without faults passes", () => withPage(pageWith("<p>fine</p>"), desktop, idle));

for (const [what, body] of [
  ["an error on the console", "<script>console.error('no')</script>"],
  ["a warning on the console", "<script>console.warn('no')</script>"],
  ["an exception", "<script>null.f()</script>"],
  ["a request to the network", "<img src='http://127.0.0.1:9/x.png'>"],
  ["a file beside it", "<script src='other.js'></script>"],
  ["a dialog", "<script>alert(1)</script>"],
])
  test(`${what} fails it`, async () => {
    await assert.rejects(withPage(pageWith(body), desktop, idle), assert.AssertionError);
  });

test("what is too wide for a phone is seen", () =>
  withPage(pageWith("<div style='width:600px'>wide</div>"), phone, async (page) => {
    await assert.rejects(assertFitsWidth(page));
  }));

test("downloads come with name and text", () =>
  withPage(pageWith("<a href='data:text/csv,a%0A1' download='x.csv'>get</a>"), desktop, async (page) => {
    assert.deepEqual(await downloaded(page, page.getByText("get")), { name: "x.csv", text: "a\n1" });
  }));
