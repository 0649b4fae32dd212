// Writes the module of runtime/web, packed, and its script as one C++ source.
// usage: node embed_module.mjs FOLDER OUTPUT.cc
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { view } from "./literal.mjs";

const [folder, output] = process.argv.slice(2);
const packed = gzipSync(readFileSync(join(folder, "plsc.wasm")), { level: 9 }).toString("base64");
const glue = readFileSync(join(folder, "plsc.js"), "utf8");
writeFileSync(
  output,
  `// Written by runtime/pages/embed_module.mjs.
#include "runtime/pages/web_module.h"

namespace plsc {

std::optional<WebModule> FindWebModule() {
  return WebModule{${view(packed)},\n  ${view(glue)}};
}

}  // namespace plsc
`,
);
