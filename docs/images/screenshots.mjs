// Pictures of the pages in a folder: node screenshots.mjs PAGES IMAGES
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [pages, images] = process.argv.slice(2);
const { chromium } = createRequire(resolve(process.env.PLSC_NODE_MODULES, "x.js"))("playwright-core");
const browser = await chromium.launch({
  executablePath: "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});

// name: what to do on the page before it is taken, and of which size
const shots = {
  live: {
    size: { width: 1280, height: 800 },
    url: () => readFileSync(join(pages, "live.address"), "utf8").trim(),
    prepare: async (page) => {
      await page.locator(".version").first().waitFor();
      await page.waitForTimeout(6000); // they have walked a little
    },
  },
  report: { size: { width: 1280, height: 860 } },
  replay: {
    size: { width: 1100, height: 760 },
    at: "#t=27", // the second season began at 20 s
    prepare: (page) => page.waitForTimeout(1500), // finely painted when it stands still
  },
  explain: {
    size: { width: 1280, height: 860 },
    prepare: (page) => page.locator('[data-key="mod:1:11"]').click(), // module 12, tilted
  },
};

for (const [name, { size, at, url, prepare }] of Object.entries(shots)) {
  const page = await browser.newPage({ viewport: size });
  await page.goto(url ? url() : pathToFileURL(join(resolve(pages), `${name}.html`)).href + (at ?? ""));
  await page.waitForTimeout(500);
  await prepare?.(page);
  await page.screenshot({ path: join(images, `${name}.png`) });
  console.log(join(images, `${name}.png`));
}
await browser.close();
