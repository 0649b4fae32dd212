// Pages in a real browser: Chromium of Debian, driven by Playwright. A page
// fails its test if it logs an error or a warning, throws, or asks for
// anything beyond its own file.
//
// Environment, set by CMake: PLSC (the program), PLSC_NODE_MODULES,
// PLSC_CHROMIUM, PLSC_SOURCE (the repository), PLSC_SCREENSHOTS (a folder to
// keep pictures in; optional).
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import { pathToFileURL } from "node:url";

const { chromium } = createRequire(join(process.env.PLSC_NODE_MODULES, "x.js"))("playwright-core");

export const source = process.env.PLSC_SOURCE;
export const desktop = { width: 1280, height: 800 };
export const phone = { width: 390, height: 844 };

// A folder that goes when the tests of this file have ended.
export const scratch = mkdtempSync(join(tmpdir(), "plsc-pages-"));

let browser = null;
after(async () => {
  await browser?.close();
  rmSync(scratch, { recursive: true, force: true });
});

// Runs plsc and gives what it printed; throws with its message if it failed.
export function plsc(...args) {
  return execFileSync(process.env.PLSC, args, { encoding: "utf8", cwd: scratch, maxBuffer: 1 << 28 });
}

async function launch() {
  browser ??= await chromium.launch({
    executablePath: process.env.PLSC_CHROMIUM,
    args: [
      "--no-sandbox", // tests may run as root
      "--disable-background-networking",
      "--disable-dev-shm-usage", // small in containers
      "--use-angle=swiftshader", // WebGL without a GPU
      "--enable-unsafe-swiftshader",
    ],
  });
  return browser;
}

// What a GPU that is none has to say is not the page's doing.
const notOurs = /swiftshader|GPU stall|GL Driver Message|Automatic fallback to software WebGL/i;

// Opens the file, or what a server of this test has (http://), and calls
// use(page); size is desktop or phone. `prepare` runs in the page before any
// script of its own; `hash` is where it is opened at.
export async function withPage(file, size, use, { prepare, hash = "" } = {}) {
  const context = await (await launch()).newContext({ viewport: size, acceptDownloads: true });
  if (prepare) await context.addInitScript(prepare);
  const page = await context.newPage();
  const isServed = file.startsWith("http://127.0.0.1:");
  const url = isServed ? file : pathToFileURL(file).href;
  const isOurs = (asked) => asked.split("#")[0] === url || /^(data|blob):/.test(asked) || (isServed && asked.startsWith(url));
  const wrongs = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !notOurs.test(message.text()))
      wrongs.push(`console ${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => wrongs.push(`exception: ${error.stack}`));
  page.on("request", (request) => {
    if (!isOurs(request.url())) wrongs.push(`request: ${request.url()}`);
  });
  page.on("dialog", (dialog) => {
    wrongs.push(`dialog: ${dialog.message()}`); // a script of somebody's name ran
    dialog.dismiss();
  });
  try {
    await page.goto(hash ? `${url}#${hash}` : url);
    await use(page);
    assert.deepEqual(wrongs, []);
  } finally {
    await context.close();
  }
}

// No part of the page is out of sight to the right.
export async function assertFitsWidth(page) {
  const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(content <= window, `the page is ${content} px wide on ${window} px`);
}

// Presses the button (a locator) and gives the file that it hands out. Chromium
// drops all but ten downloads of a page a second, without a word.
export async function downloaded(page, button) {
  const [file] = await Promise.all([page.waitForEvent("download"), button.click()]);
  const stream = await file.createReadStream();
  let text = "";
  for await (const piece of stream) text += piece;
  return { name: file.suggestedFilename(), text };
}

// For pages with more buttons than that: to be prepared with `keepFiles`, which
// keeps what would be downloaded in the page.
export function keepFiles() {
  window.keptFiles = [];
  const blobs = new Map();
  const nameBlob = URL.createObjectURL;
  URL.createObjectURL = (blob) => {
    const url = nameBlob(blob);
    blobs.set(url, blob);
    return url;
  };
  const click = HTMLElement.prototype.click;
  HTMLAnchorElement.prototype.click = function () {
    if (this.download) window.keptFiles.push({ name: this.download, blob: blobs.get(this.href) });
    else click.call(this);
  };
}
export async function handedOut(page, button) {
  await button.click();
  return page.evaluate(async () => {
    const [{ name, blob }, ...more] = window.keptFiles.splice(0);
    if (more.length > 0) throw new Error(`also ${more.map((one) => one.name)}`);
    return { name, text: await blob.text() };
  });
}

// Kept for people to look at, if PLSC_SCREENSHOTS names a folder.
export async function screenshot(page, name, options = {}) {
  const folder = process.env.PLSC_SCREENSHOTS;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`), ...options });
}
