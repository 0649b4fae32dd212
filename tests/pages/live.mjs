// The page that is edited in, as its tests open it: through a server around a
// door program (live_server.mjs).
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { desktop, source, withPage } from "./browser.mjs";
import { startServer } from "./live_server.mjs";

export const example = (name) => readFileSync(join(source, "examples", `${name}.pls`), "utf8");
const pageOf = (data) => execFileSync(process.env.PLSC_LIVE_PAGE, { input: JSON.stringify(data), encoding: "utf8", maxBuffer: 1 << 28 });

// Short lives: 4 s on the flat and 4 s uphill.
export const scenario = `plsc_scenario: 1
profile: swift
seasons:
  - {name: flat, terrain: flat, duration: 4 s}
  - {name: tilted, terrain: {tilted: 5 deg}, duration: 4 s}
`;

// use(page, server); the first robot lives already.
export async function withRobot(use, { robot = "gecko", size = desktop, hash, prepare, isLiving = true, ...rest } = {}) {
  const data = { robot: example(robot), name: `${robot}.pls`, scenario, ...rest };
  const server = await startServer([process.env.PLSC_DOOR], data, pageOf);
  try {
    await withPage(
      server.url,
      size,
      async (page) => {
        if (isLiving) await page.locator(".version").first().waitFor();
        await use(page, server);
      },
      { hash, prepare },
    );
  } finally {
    server.end();
  }
}

export const count = (page, selector) => page.locator(selector).count();

// The text that the page asked about last.
export const askedText = (server) => server.asked.findLast((one) => one.ask === "explain")?.text;
export const asks = (server, ask) => server.asked.filter((one) => one.ask === ask);

// The line of the editor that holds this text.
export const lineWith = (page, text) => page.locator(".cm-line", { hasText: text }).first();

// Until the strip has so many versions.
export const versions = (page, many) => page.waitForFunction((wanted) => document.querySelectorAll(".version").length === wanted, many);

// Until the first body has so many modules, and the page finds no fault.
export const modules = (page, many) =>
  page.waitForFunction(
    (wanted) =>
      document.querySelectorAll(".workings .environment:first-child svg.body .module").length === wanted &&
      document.querySelector(".right").ariaBusy === "false" &&
      document.querySelector(".wrong").hidden,
    many,
  );

// Puts the cursor behind this text of a line.
export async function cursorBehind(page, text) {
  await lineWith(page, text).click();
  await page.keyboard.press("End");
}
