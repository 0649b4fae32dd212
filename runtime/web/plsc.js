// Opens plsc.wasm, in a page, its workers and Node alike: a script without
// imports, so that it can stand in a worker made of a blob.
//
//   const plsc = await openPlsc(wasm);   // bytes, or a WebAssembly.Module of them
//   const answer = plsc.ask({ ask: "check", text: "..." });
//
// What the module asks of its host is a place for the words of a failed assertion
// and an end. After an exception it is broken: open another one.
async function openPlsc(wasm) {
  let words = "";
  let exports;
  const memory = () => new DataView(exports.memory.buffer);
  const utf8 = new TextDecoder();
  const host = {
    fd_write(fd, pieces, count, written) {
      let size = 0;
      for (let i = 0; i < count; ++i) {
        const at = memory().getUint32(pieces + 8 * i, true);
        const length = memory().getUint32(pieces + 8 * i + 4, true);
        words += utf8.decode(new Uint8Array(exports.memory.buffer, at, length));
        size += length;
      }
      memory().setUint32(written, size, true);
      return 0;
    },
    environ_sizes_get(count, size) {
      memory().setUint32(count, 0, true);
      memory().setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
    emscripten_notify_memory_growth() {},
    proc_exit(status) {
      throw new Error(words || `the module ended with status ${status}`);
    },
  };
  const module = wasm instanceof WebAssembly.Module ? wasm : await WebAssembly.compile(wasm);
  // Of the C library's other calls none is made; each would say its name.
  const imports = {};
  for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    if (kind === "function")
      imports[from][name] = host[name] ?? (() => { throw new Error(`the module calls ${name}`); });
  }
  exports = (await WebAssembly.instantiate(module, imports)).exports;
  exports._initialize();
  const session = exports.plsc_open();
  const encoder = new TextEncoder();

  // JSON text in, JSON text out.
  function answer(text) {
    const request = encoder.encode(text);
    const at = exports.plsc_request(session, request.length);
    new Uint8Array(exports.memory.buffer, at, request.length).set(request);
    words = "";
    let from;
    try {
      from = exports.plsc_answer(session);
    } catch (error) {
      throw words ? new Error(words.trim(), { cause: error }) : error;
    }
    const size = exports.plsc_answer_bytes(session);
    return utf8.decode(new Uint8Array(exports.memory.buffer, from, size));
  }

  return {
    answer,
    ask: (request) => JSON.parse(answer(JSON.stringify(request))),
    bytes: () => exports.memory.buffer.byteLength,
  };
}

if (typeof module === "object") module.exports = { openPlsc };
