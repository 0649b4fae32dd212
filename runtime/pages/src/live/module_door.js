// The door to plsc itself, compiled to WebAssembly: two workers, one for the
// language server and one for lives. One that takes too long, or dies, is ended
// and another one started.
import { unpack } from "./packed.js";

const longest = 20000; // ms that one answer may take

// Runs in the worker, after the module's own glue, which defines plsc(options).
function serve() {
  let answer = null;
  self.onmessage = async ({ data }) => {
    try {
      if (data.module) {
        const instantiateWasm = (imports, done) => {
          WebAssembly.instantiate(data.module, imports).then((instance) => done(instance, data.module));
          return {};
        };
        const made = await self.plsc({ instantiateWasm, print() {}, printErr() {} });
        made.ccall("plsc_open", null, [], []);
        answer = made.cwrap("plsc_answer", "string", ["string"]);
        self.postMessage({ isReady: true });
        return;
      }
      self.postMessage({ answer: answer(data.request) });
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
    const { code, module } = parts;
    const url = URL.createObjectURL(new Blob([code], { type: "text/javascript" }));
    this.worker = new Worker(url);
    URL.revokeObjectURL(url);
    this.isReady = false;
    this.worker.onmessage = ({ data }) => this.#heard(data);
    this.worker.onerror = (event) => this.end(`plsc stopped: ${event.message}`);
    this.worker.postMessage({ module });
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
  // {glue, wasm}: base64 of gzip of what `cmake --preset web` made.
  constructor({ glue, wasm }) {
    this.onRestart = () => {};
    this.parts = Promise.all([unpack(glue), unpack(wasm)]).then(async ([text, bytes]) => ({
      code: `${new TextDecoder().decode(text)}\n(${serve})();`,
      module: await WebAssembly.compile(bytes),
    }));
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
