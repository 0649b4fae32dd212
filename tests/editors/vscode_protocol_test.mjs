// All features over a real pipe, answers held to the protocol's own types.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { lsp, source, start, stop } from "./client.mjs";

const uri = "file:///robots/g%C3%A9cko.pls";
const broken = [
  "plsc 1",
  "alphabet plasticoding 1",
  "sense inclined: bool # 🦎🦎",
  "let half = 0.5",
  "rule C -> if inclind = True then { C add_front T(half) }",
  "rule B -> { A1(half, 1, 2, 3) }",
  "environment flat { inclined = False }",
  "environment tilted { inclined = True }",
  "",
].join("\r\n");
const mended = broken.replace("inclind", "inclined");

const lineOf = (text, what) => {
  const before = text.slice(0, text.indexOf(what)).split("\r\n");
  assert.notEqual(text.indexOf(what), -1);
  return { line: before.length - 1, character: before.at(-1).length };
};

function assertRange(text, range) {
  assert.ok(lsp.Range.is(range));
  const lines = text.split("\r\n");
  for (const place of [range.start, range.end]) {
    assert.ok(place.line < lines.length);
    assert.ok(place.character <= lines[place.line].length);
  }
  const { start, end } = range;
  assert.ok(start.line < end.line || (start.line === end.line && start.character <= end.character));
}

// As an editor applies them.
function applied(text, edits) {
  const document = text.split("\r\n");
  const offset = (place) => document.slice(0, place.line).reduce((sum, line) => sum + line.length + 2, 0) + place.character;
  return [...edits]
    .sort((a, b) => offset(b.range.start) - offset(a.range.start))
    .reduce((all, edit) => {
      assert.ok(lsp.TextEdit.is(edit));
      return all.slice(0, offset(edit.range.start)) + edit.newText + all.slice(offset(edit.range.end));
    }, text);
}

async function opened(text, options) {
  const session = await start(options);
  session.connection.sendNotification(lsp.DidOpenTextDocumentNotification.type, {
    textDocument: { uri, languageId: "pls", version: 1, text },
  });
  return session;
}

const at = (text, what) => ({ textDocument: { uri }, position: lineOf(text, what) });
const whole = (text) => ({
  textDocument: { uri },
  range: { start: { line: 0, character: 0 }, end: { line: text.split("\r\n").length, character: 0 } },
});

test("initialize says what the server can", async () => {
  const session = await start();
  const can = session.initialized.capabilities;
  assert.equal(can.textDocumentSync.change, lsp.TextDocumentSyncKind.Incremental);
  assert.equal(can.positionEncoding, "utf-16");
  for (const type of can.semanticTokensProvider.legend.tokenTypes)
    assert.ok(Object.values(lsp.SemanticTokenTypes).includes(type), type);
  for (const modifier of can.semanticTokensProvider.legend.tokenModifiers)
    assert.ok(Object.values(lsp.SemanticTokenModifiers).includes(modifier), modifier);
  assert.equal(await stop(session), 0);
});

test("diagnostics, a fix as a code action, and the text it makes", async () => {
  const session = await opened(broken);
  const [wrong] = await session.diagnostics(uri, 1);
  assert.ok(lsp.Diagnostic.is(wrong));
  assert.equal(wrong.code, "P2005");
  assert.equal(wrong.severity, lsp.DiagnosticSeverity.Error);
  assert.deepEqual(wrong.range.start, lineOf(broken, "inclind"));
  assert.ok(wrong.relatedInformation.every(lsp.DiagnosticRelatedInformation.is));
  const actions = await session.connection.sendRequest(lsp.CodeActionRequest.type, {
    textDocument: { uri },
    range: wrong.range,
    context: { diagnostics: [wrong] },
  });
  assert.ok(actions.every(lsp.CodeAction.is));
  const fix = actions.find((action) => action.title === "Replace 'inclind' by 'inclined'");
  assert.equal(applied(broken, fix.edit.changes[uri]), mended);
  // As the editor says what the action did.
  session.connection.sendNotification(lsp.DidChangeTextDocumentNotification.type, {
    textDocument: { uri, version: 2 },
    contentChanges: fix.edit.changes[uri].map((edit) => ({ range: edit.range, text: edit.newText })),
  });
  assert.ok(
    (await session.diagnostics(uri, 2)).every((one) => one.severity !== lsp.DiagnosticSeverity.Error),
  );
  assert.equal(await stop(session), 0);
});

test("every feature answers in the protocol's types", async () => {
  const session = await opened(mended);
  const { connection } = session;
  const hover = await connection.sendRequest(lsp.HoverRequest.type, at(mended, "inclined = True"));
  assert.ok(lsp.Hover.is(hover));
  assert.match(hover.contents.value, /Active in 1 of 2 environments/);
  assertRange(mended, hover.range);

  const definition = await connection.sendRequest(lsp.DefinitionRequest.type, at(mended, "half)"));
  assert.ok(definition.every(lsp.Location.is));
  assert.deepEqual(definition[0].range.start, lineOf(mended, "half"));

  const references = await connection.sendRequest(lsp.ReferencesRequest.type, {
    ...at(mended, "half)"),
    context: { includeDeclaration: true },
  });
  assert.equal(references.length, 3);
  references.forEach((one) => assertRange(mended, one.range));

  const highlights = await connection.sendRequest(lsp.DocumentHighlightRequest.type, at(mended, "half)"));
  assert.deepEqual(highlights.map((one) => one.kind), [3, 2, 2]);
  highlights.forEach((one) => assertRange(mended, one.range));

  const items = await connection.sendRequest(lsp.CompletionRequest.type, at(mended, "T(half"));
  for (const item of items) {
    assert.equal(typeof item.label, "string");
    assert.ok(Object.values(lsp.CompletionItemKind).includes(item.kind));
    assert.ok(item.documentation === undefined || lsp.MarkupContent.is(item.documentation));
    assert.ok(lsp.TextEdit.is(item.textEdit));
  }
  const joint = items.find((item) => item.label === "A1");
  assert.equal(joint.insertTextFormat, lsp.InsertTextFormat.Snippet);
  assertRange(mended, joint.textEdit.range);

  const symbols = await connection.sendRequest(lsp.DocumentSymbolRequest.type, { textDocument: { uri } });
  for (const symbol of symbols) {
    assertRange(mended, symbol.range);
    assertRange(mended, symbol.selectionRange);
    assert.ok(Object.values(lsp.SymbolKind).includes(symbol.kind));
  }

  const prepared = await connection.sendRequest(lsp.PrepareRenameRequest.type, at(mended, "half)"));
  assert.equal(prepared.placeholder, "half");
  const rename = await connection.sendRequest(lsp.RenameRequest.type, { ...at(mended, "half)"), newName: "weight" });
  assert.ok(lsp.WorkspaceEdit.is(rename));
  assert.equal(applied(mended, rename.changes[uri]), mended.replaceAll("half", "weight"));

  const edits = await connection.sendRequest(lsp.DocumentFormattingRequest.type, {
    textDocument: { uri },
    options: { tabSize: 2, insertSpaces: true },
  });
  assert.match(applied(mended, edits), /then \{\r?\n  C\r?\n/);
  assert.equal(await stop(session), 0);
});

test("a rename that clashes is refused in words", async () => {
  const session = await opened(mended);
  await assert.rejects(
    session.connection.sendRequest(lsp.RenameRequest.type, { ...at(mended, "half)"), newName: "rule" }),
    (error) => error.code === lsp.LSPErrorCodes.RequestFailed && error.message === "'rule' is a reserved word",
  );
  assert.equal(await stop(session), 0);
});

test("semantic tokens are sorted, in the text, and apart", async () => {
  const session = await opened(mended);
  const legend = session.initialized.capabilities.semanticTokensProvider.legend;
  const tokens = await session.connection.sendRequest(lsp.SemanticTokensRequest.type, { textDocument: { uri } });
  assert.ok(lsp.SemanticTokens.is(tokens));
  const lines = mended.split("\r\n");
  let [line, character, end] = [0, 0, 0];
  const types = {};
  for (let i = 0; i < tokens.data.length; i += 5) {
    const [lines_on, characters_on, length, type] = tokens.data.slice(i, i + 4);
    if (lines_on > 0) [line, character, end] = [line + lines_on, 0, 0];
    character += characters_on;
    assert.ok(character >= end && length > 0);
    end = character + length;
    assert.ok(end <= lines[line].length, `${line}:${character}`);
    types[lines[line].slice(character, end)] = legend.tokenTypes[type];
  }
  assert.equal(types.rule, "keyword");
  assert.equal(types.inclined, "variable");
  assert.equal(types["# 🦎🦎"], "comment");
  assert.equal(types.A1, "type");
  assert.equal(types.add_front, "function");
  const part = await session.connection.sendRequest(lsp.SemanticTokensRangeRequest.type, {
    textDocument: { uri },
    range: { start: { line: 3, character: 0 }, end: { line: 3, character: 99 } },
  });
  assert.equal(part.data.length, 4 * 5);
  assert.equal(await stop(session), 0);
});

test("hints follow the chosen environment", async () => {
  const session = await opened(mended, { environment: "flat" });
  const hints = async () => {
    const found = await session.connection.sendRequest(lsp.InlayHintRequest.type, whole(mended));
    assert.ok(found.every(lsp.InlayHint.is));
    return found.map((hint) => hint.label);
  };
  assert.deepEqual(await hints(), ["inactive"]);
  const command = (name, ...args) =>
    session.connection.sendRequest(lsp.ExecuteCommandRequest.type, { command: name, arguments: args });
  assert.deepEqual(await command("plsc.listEnvironments", uri), ["flat", "tilted"]);
  await command("plsc.chooseEnvironment", "tilted");
  assert.deepEqual(await hints(), ["active"]);
  assert.equal(session.refreshes.length, 1);
  session.connection.sendNotification(lsp.DidChangeConfigurationNotification.type, {
    settings: { plsc: { environment: "inclined=False" } },
  });
  assert.deepEqual(await hints(), ["inactive"]);
  assert.equal(await stop(session), 0);
});

test("a thousand keystrokes at once end in the diagnostics of the last", async () => {
  const session = await opened(mended);
  for (let version = 2; version <= 1001; ++version)
    session.connection.sendNotification(lsp.DidChangeTextDocumentNotification.type, {
      textDocument: { uri, version },
      contentChanges: [
        { range: { start: { line: 0, character: 6 }, end: { line: 0, character: 6 } }, text: "1" },
      ],
    });
  const [wrong] = await session.diagnostics(uri, 1001);
  assert.equal(wrong.range.start.line, 0);
  assert.equal(await stop(session), 0);
});

test("every example is without errors", async () => {
  const session = await start();
  for (const name of ["climber", "desert", "didactic", "gecko", "snake", "spider"]) {
    const text = readFileSync(join(source, "examples", `${name}.pls`), "utf8");
    const file = `file:///${name}.pls`;
    session.connection.sendNotification(lsp.DidOpenTextDocumentNotification.type, {
      textDocument: { uri: file, languageId: "pls", version: 1, text },
    });
    assert.deepEqual(await session.diagnostics(file, 1), [], name);
  }
  assert.equal(await stop(session), 0);
});

// What a process does with `bytes` for its input: its status and output.
function answerTo(bytes) {
  const server = spawn(process.env.PLSC, ["lsp"], { stdio: ["pipe", "pipe", "pipe"] });
  let [out, err] = ["", ""];
  server.stdout.on("data", (data) => (out += data));
  server.stderr.on("data", (data) => (err += data));
  server.stdin.on("error", () => {}); // it may end before all is written
  server.stdin.end(bytes);
  return new Promise((resolve) => server.on("exit", (status, signal) => resolve({ status, signal, out, err })));
}
const framed = (body) => `Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`;

test("hostile bytes get an error or a clean end", async () => {
  const rows = [
    ["nothing", "", ""],
    ["no header", '{"jsonrpc":"2.0"}\n', "-32700"],
    ["a negative length", "Content-Length: -5\r\n\r\n{}", "-32700"],
    ["a huge length", "Content-Length: 99999999999\r\n\r\n{}", "-32700"],
    ["a body cut off", "Content-Length: 50\r\n\r\n{}", ""],
    ["a header cut off", "Content-Len", ""],
    ["no JSON", framed("hello"), "-32700"],
    ["bytes of no UTF-8", Buffer.concat([Buffer.from("Content-Length: 2\r\n\r\n"), Buffer.from([0xff, 0xfe])]), "-32700"],
    ["ten million brackets", framed("[".repeat(10_000_000)), "-32700"],
    ["too early", framed('{"jsonrpc":"2.0","id":1,"method":"textDocument/hover"}'), "-32002"],
    ["random bytes", Buffer.from(Array.from({ length: 20000 }, (_, i) => (i * 7919) % 256)), "-32700"],
  ];
  for (const [why, bytes, code] of rows) {
    const { status, signal, out, err } = await answerTo(bytes);
    assert.equal(signal, null, why);
    assert.equal(status, 1, why);
    assert.equal(err, "", why);
    assert.ok(out.includes(code), `${why}: ${out}`);
    if (code === "") assert.equal(out, "", why);
  }
});

test("exit after shutdown is 0, without it 1", async () => {
  const initialize = framed('{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}');
  const shutdown = framed('{"jsonrpc":"2.0","id":2,"method":"shutdown"}');
  const exit = framed('{"jsonrpc":"2.0","method":"exit"}');
  assert.equal((await answerTo(initialize + shutdown + exit)).status, 0);
  assert.equal((await answerTo(initialize + exit)).status, 1);
  assert.equal((await answerTo(initialize + shutdown)).status, 1);
});
