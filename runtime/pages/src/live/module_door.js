// The door to plsc itself, compiled to WebAssembly: two workers, one for the
// language server and one for lives. One that takes too long, or dies, is ended
// and another one started.
import { toBytes } from "./packed.js";

const longest = 20000; // ms that one answer may take

function workerOf(code) {
  const url = URL.createObjectURL(new Blob([code], { type: "text/javascript" }));
  const worker = new Worker(url);
  URL.revokeObjectURL(url);
  return worker;
}

// Compiled once, on the browser's own threads, for all workers; `packed` is
// base64 of gzip.
function compile(packed) {
  const stream = new Blob([toBytes(packed)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(stream, { headers: { "Content-Type": "application/wasm" } }));
}

// Runs in a worker behind the glue, which defines openPlsc.
function serve() {
  let plsc = null;
  self.onmessage = async ({ data }) => {
    try {
      if (data.wasm) {
        plsc = await openPlsc(data.wasm);
        self.postMessage({ isReady: true });
      } else {
        self.postMessage({ answer: plsc.answer(data.request) });
      }
    } catch (error) {
      self.postMessage({ fault: String(error?.message ?? error) });
    }
  };
}

class Lane {
  constructor(parts, onRestart) {
    this.parts = parts;
    this.onRestart = onRestart;
    this.waiting = []; // {request, resolve}, the first of which is being done
    this.#start();
  }

  async #start() {
    const started = (this.started = {});
    let parts;
    try {
      parts = await this.parts;
    } catch (error) {
      this.fault = `plsc cannot run in this browser: ${error.message}`;
      for (const { resolve } of this.waiting.splice(0)) resolve({ ok: false, error: this.fault });
      return;
    }
    if (this.started !== started) return;
    const { code, wasm } = parts;
    this.worker = workerOf(code);
    this.isReady = false;
    this.worker.onmessage = ({ data }) => this.#heard(data);
    this.worker.onerror = (event) => this.end(`plsc stopped: ${event.message}`);
    this.worker.postMessage({ wasm });
  }

  #heard({ isReady, answer, fault }) {
    if (fault !== undefined) return this.end(`plsc stopped: ${fault}`);
    if (isReady) this.isReady = true;
    else this.#finish(JSON.parse(answer));
    this.#next();
  }

  #finish(answer) {
    clearTimeout(this.timer);
    this.waiting.shift()?.resolve(answer);
  }

  #next() {
    if (!this.isReady || this.waiting.length === 0) return;
    this.worker.postMessage({ request: JSON.stringify(this.waiting[0].request) });
    this.timer = setTimeout(() => this.end(`this took longer than ${longest / 1000} s and was ended`), longest);
  }

  ask(request) {
    if (this.fault) return Promise.resolve({ ok: false, error: this.fault });
    return new Promise((resolve) => {
      this.waiting.push({ request, resolve });
      if (this.waiting.length === 1) this.#next();
    });
  }

  // The one being done is answered with the reason, the others are asked again.
  end(reason) {
    this.worker?.terminate();
    this.worker = null;
    this.isReady = false;
    this.#finish({ ok: false, error: reason });
    this.#start();
    this.onRestart();
  }
}

export class ModuleDoor {
  // `packed`: base64 of the module's bytes in gzip; `glue`: the script that
  // opens them (runtime/web/plsc.js).
  constructor({ packed, glue }) {
    this.onRestart = () => {};
    const code = `${glue}\n(${serve})();`;
    this.parts = compile(packed).then((wasm) => ({ code, wasm }));
    this.lives = new Lane(this.parts, () => {});
    this.language = new Lane(this.parts, () => this.onRestart());
    this.ids = 0;
  }

  ask(request) {
    const lane = request.ask === "lsp" || request.ask === "idle" ? this.language : this.lives;
    return lane.ask({ id: ++this.ids, ...request });
  }

  restart() {
    if (this.lives.waiting.length > 0) this.lives.end("ended, because something newer is to be done");
  }
}
