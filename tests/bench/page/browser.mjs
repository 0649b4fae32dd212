// Chromium for benchmarks, and what is watched in a page from before its first
// script on.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { packages } from "./common.mjs";

const chromiumPath = () => process.env.PLSC_CHROMIUM ?? execFileSync("sh", ["-c", "command -v chromium || command -v google-chrome"], { encoding: "utf8" }).trim();

export function launch() {
  const { chromium } = packages()("playwright-core");
  const args = ["--no-sandbox", "--disable-background-networking", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
  return chromium.launch({ executablePath: chromiumPath(), args });
}

// Runs in the page. `watch.next(...)` tells when what was asked for is on the
// screen: the frame is drawn, and a pixel of the 3-D picture was read back, which
// waits for the software or the card that draws it.
export function watch() {
  const watching = (window.watching = { first: {}, counts: { buffers: 0, textures: 0, programs: 0 }, draws: 0 });
  const { counts } = watching;
  const gl = WebGL2RenderingContext.prototype;
  for (const [kind, what] of [["Buffer", "buffers"], ["Texture", "textures"], ["Program", "programs"]]) {
    const make = gl[`create${kind}`];
    const end = gl[`delete${kind}`];
    gl[`create${kind}`] = function () {
      ++counts[what];
      return make.call(this);
    };
    gl[`delete${kind}`] = function (one) {
      if (one) --counts[what];
      return end.call(this, one);
    };
  }
  for (const name of ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced"]) {
    const draw = gl[name];
    gl[name] = function (...words) {
      watching.context = this;
      ++watching.draws;
      return draw.apply(this, words);
    };
  }
  // ms since the page was navigated to, when what has been done so far is seen.
  watching.seen = (needsPicture) =>
    new Promise((resolve) => {
      const { draws } = watching;
      const frame = () => {
        if (needsPicture && watching.draws === draws) return requestAnimationFrame(frame);
        if (needsPicture) watching.context.readPixels(0, 0, 1, 1, 6408, 5121, new Uint8Array(4)); // RGBA, bytes
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () => resolve(performance.now());
        port2.postMessage(null);
      };
      requestAnimationFrame(frame);
    });
  // Once the page has this, it is noted when that was seen.
  const wanted = { editor: ".cm-content", body: ".workings svg.body .module", life: ".stage:not(.empty)" };
  const looking = new MutationObserver(() => {
    for (const [name, selector] of Object.entries(wanted)) {
      if (!document.querySelector(selector)) continue;
      delete wanted[name];
      watching.seen(name === "life").then((at) => (watching.first[name] = at));
    }
    if (Object.keys(wanted).length === 0) looking.disconnect();
  });
  looking.observe(document, { subtree: true, childList: true, attributes: true, attributeFilter: ["class"] });
  // The module's memory, for who asks in the worker.
  const OldBlob = window.Blob;
  window.Blob = class extends OldBlob {
    constructor(parts = [], options = {}) {
      const isWorker = options.type === "text/javascript";
      const telling = `{ const make = WebAssembly.instantiate;
        WebAssembly.instantiate = async (...words) => { const made = await make(...words); self.moduleMemory = (made.instance ?? made).exports.memory; return made; }; }\n`;
      super(isWorker ? [telling, ...parts] : parts, options);
    }
  };
}

// bytes of all workers' modules
export async function moduleBytes(page) {
  const bytes = await Promise.all(page.workers().map((worker) => worker.evaluate(() => self.moduleMemory?.buffer.byteLength ?? 0)));
  return bytes.reduce((sum, one) => sum + one, 0);
}

// {renderer, gpu}: bytes that the processes have in memory
export async function processBytes(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  await session.detach();
  const bytes = {};
  for (const { type, id } of processInfo) {
    const pages = Number(readFileSync(`/proc/${id}/statm`, "utf8").split(" ")[1]);
    bytes[type] = (bytes[type] ?? 0) + pages * 4096;
  }
  return bytes;
}
