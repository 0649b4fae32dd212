// What both builds are asked: everything, of every genotype of the repository.
import { readdirSync, readFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
const read = (path) => readFileSync(join(root, path), "utf8");

function filesIn(folder, ending) {
  return readdirSync(join(root, folder), { withFileTypes: true })
    .flatMap((entry) => {
      const path = `${folder}/${entry.name}`;
      return entry.isDirectory() ? filesIn(path, ending) : path.endsWith(ending) ? [path] : [];
    })
    .sort();
}

// Where reading and printing numbers could differ: few digits and many, both
// ends of the range and beyond, between two doubles.
function numbers() {
  let state = 18n; // any; of Knuth's MMIX generator
  const next = () => (state = (state * 6364136223846793005n + 1442695040888963407n) % (1n << 64n));
  const texts = ["0", "-0", "1e999", "-1e999", "1e-999", "0e999", "0.0", "5e-324", "2e-324", "2.5e-324"];
  texts.push("1.7976931348623157e308", "1.7976931348623159e308", "9007199254740993", "1152921504606846976");
  texts.push("12345678901234567168", "100000", "1e5", "0.0001", "123456", "0.30000000000000004", "1e", "1.", ".5", "nan", "inf");
  for (let i = 0; i < 300; ++i) {
    const digits = next().toString().slice(0, 1 + Number(next() % 19n));
    texts.push(`${digits.slice(0, 1)}.${digits.slice(1) || "0"}e${Number(next() % 660n) - 330}`);
    texts.push(`${digits.slice(0, -1) || "0"}.${digits.slice(-1)}`);
  }
  const genotype = (number) => `plsc 1\nalphabet plasticoding 1\nrule C -> { C add_left A1(${number}, 2, 3, 1.25) }\n`;
  return texts.map((number) => ({ path: `number ${number}`, text: genotype(number) }));
}

const short = (seconds) => `profile: swift
seasons:
  - name: flat
    ground: plane
    duration: ${seconds} s
    senses: {hot: false}
  - name: hill
    ground: {tilt: 5 deg}
    duration: ${seconds} s
    senses: {hot: false}
`;

// [{what, request}], the request as JSON text.
export function allRequests(asks) {
  const requests = [];
  const ask = (what, request) => requests.push({ what: `${request.ask} of ${what}`, request: JSON.stringify(request) });
  const examples = filesIn("examples", ".pls");
  const programs = [...filesIn("tests", ".pls"), ...examples].map((path) => ({ path, text: read(path) }));
  const robots = [];
  for (const { path, text } of [...programs, ...numbers()]) {
    const of = { name: basename(path), text };
    ask(path, { ask: "check", lint: true, ...of });
    for (const kind of ["format", "develop", "explain", "picture", "parameters"]) if (asks.includes(kind)) ask(path, { ask: kind, ...of });
    if (path.startsWith("examples/") || path.endsWith("evolved.pls")) robots.push({ path, of });
  }
  for (const { path, of } of robots) {
    // As long as in the paper, and recorded.
    ask(path, { ask: "live", engine: "articulated", record: true, ...of });
    ask(path, { ask: "live", scenario: short(3), ...of });
    const genotypes = [...of.text.matchAll(/^genotype (\w+)/gm)].map((match) => match[1]);
    for (const genotype of genotypes.slice(1))
      for (const kind of ["develop", "live"]) ask(`${path}, ${genotype}`, { ask: kind, genotype, ...(kind === "live" ? { engine: "articulated" } : {}), ...of });
  }
  if (asks.includes("compare"))
    for (const [i, { path, of }] of robots.entries()) ask(path, { ask: "compare", before: robots.at(i - 1).of.text, ...of });
  for (const path of filesIn("examples", ".yaml")) {
    if (asks.includes("scenario")) ask(path, { ask: "scenario", scenario: read(path) });
    // In the engine that both have.
    const scenario = `profile: swift\n${read(path).replace(/^profile:.*\n/m, "")}`;
    for (const { of } of robots.slice(0, 2)) ask(`${path} of ${of.name}`, { ask: "develop", scenario, ...of });
  }
  if (asks.includes("lsp")) session(ask, programs);
  return requests;
}

// The language server, from its first word on.
function session(ask, programs) {
  const send = (what, message) => ask(what, { ask: "lsp", message: { jsonrpc: "2.0", ...message } });
  const idle = (what) => ask(what, { ask: "idle" });
  let id = 0;
  send("hello", { id: ++id, method: "initialize", params: { processId: null, rootUri: null, capabilities: {} } });
  send("hello", { method: "initialized", params: {} });
  for (const { path, text } of programs) {
    const uri = `file:///${path}`;
    const document = { textDocument: { uri } };
    send(path, { method: "textDocument/didOpen", params: { textDocument: { uri, languageId: "plsc", version: 1, text } } });
    for (let i = 0; i < 3; ++i) idle(path);
    for (const method of ["documentSymbol", "foldingRange", "semanticTokens/full"]) send(path, { id: ++id, method: `textDocument/${method}`, params: document });
    const lines = text.split("\n");
    for (let line = 0; line < lines.length; line += 5)
      for (const method of ["hover", "completion"])
        send(path, { id: ++id, method: `textDocument/${method}`, params: { ...document, position: { line, character: lines[line].length >> 1 } } });
    send(path, { method: "textDocument/didClose", params: document });
  }
}
