// Bundles every page (src/PAGE/main.js and the style that it imports) with
// esbuild and writes them as one C++ source.
// usage: node bundle.mjs NODE_MODULES OUTPUT.cc
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { view } from "./literal.mjs";

const [modules, output] = process.argv.slice(2);
const esbuild = createRequire(join(modules, "x.js"))("esbuild");
const here = dirname(fileURLToPath(import.meta.url));
const pages = ["report", "view", "explain", "live"]; // as PageKind in page_kind.h
const packed = new Set(["live"]); // pages that are large for their libraries

// The libraries' licences want to go where their code goes.
function notices(metafile) {
  const folders = new Set();
  for (const input of Object.keys(metafile.inputs)) {
    const match = input.match(/^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//);
    if (match) folders.add(match[1]);
  }
  const byText = new Map();
  for (const folder of [...folders].sort()) {
    const about = JSON.parse(readFileSync(join(here, folder, "package.json")));
    const file = readdirSync(join(here, folder)).find((name) => /^licen[sc]e/i.test(name));
    const text = file ? readFileSync(join(here, folder, file), "utf8").trim() : about.license;
    byText.set(text, [...(byText.get(text) ?? []), `${about.name} ${about.version}`]);
  }
  return [...byText]
    .map(([text, names]) => `Of ${names.join(", ")}:\n${text.replaceAll("*/", "* /")}`)
    .join("\n\n");
}

// The script as text that the browser unpacks: a third of its size.
function unpacking(script) {
  const text = gzipSync(script, { level: 9 }).toString("base64");
  const bytes = `Uint8Array.from(atob("${text}"),(c)=>c.charCodeAt(0))`;
  const stream = `new Blob([${bytes}]).stream().pipeThrough(new DecompressionStream("gzip"))`;
  return `new Response(${stream}).text().then((text)=>{const script=document.createElement("script");script.textContent=text;document.body.append(script)});`;
}

async function bundle(page) {
  const result = await esbuild.build({
    entryPoints: [join(here, "src", page, "main.js")],
    absWorkingDir: here,
    nodePaths: [modules],
    bundle: true,
    minify: true,
    write: false,
    outdir: "/bundle",
    format: "iife",
    target: ["es2022"],
    charset: "utf8",
    legalComments: "none", // notices() has them whole
    metafile: true,
    logLevel: "warning",
    loader: { ".svg": "text" },
  });
  const text = (ending) => result.outputFiles.find((file) => basename(file.path) === `main.${ending}`)?.text ?? "";
  const notice = notices(result.metafile);
  const code = packed.has(page) ? unpacking(text("js")) : text("js");
  const script = (notice ? `/*\n${notice}\n*/\n` : "") + code;
  // In HTML these end a script, or change what ends it.
  if (/<\/script|<!--/i.test(script) || /<\/style/i.test(text("css")))
    throw new Error(`the bundle of '${page}' cannot stand in HTML`);
  return { script, style: text("css") };
}

const built = await Promise.all(pages.map(bundle));
let source = `// Written by runtime/pages/bundle.mjs.
#include "runtime/pages/bundles.h"

namespace plsc {

bool HasPages() { return true; }

Bundle BundleOf(PageKind kind) {
  using namespace std::string_view_literals;
  switch (kind) {
`;
pages.forEach((page, i) => {
  const name = `k${page[0].toUpperCase()}${page.slice(1)}`;
  source += `    case PageKind::${name}:\n      return {${view(built[i].script)},\n  ${view(built[i].style)}};\n`;
});
source += "  }\n  return {};\n}\n\n}  // namespace plsc\n";
writeFileSync(output, source);
