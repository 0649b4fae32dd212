// The TextMate grammar of docs/editors over all examples: every keyword,
// number and comment has its colour, and no rule is left open.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { required, source } from "./client.mjs";

const { INITIAL, Registry, parseRawGrammar } = required("vscode-textmate");
const oniguruma = required("vscode-oniguruma");

const read = (...path) => readFileSync(join(source, ...path), "utf8");
const wasm = readFileSync(required.resolve("vscode-oniguruma").replace(/main\.js$/, "onig.wasm"));
await oniguruma.loadWASM(wasm);
const registry = new Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async () =>
    parseRawGrammar(read("docs", "editors", "plsc.tmLanguage.json"), "plsc.tmLanguage.json"),
});
const grammar = await registry.loadGrammar("source.pls");

// The language's own list.
const keywords = new Set(
  [...read("grammar", "keywords.cc").matchAll(/k(?:Item|Other)Keywords = \{([^}]*)\}/g)].flatMap((list) =>
    [...list[1].matchAll(/"(\w+)"/g)].map((word) => word[1]),
  ),
);

// [{text, scope}] of all lines; the scope is the innermost.
function painted(text) {
  let stack = INITIAL;
  const tokens = text.split(/\r?\n/).flatMap((line) => {
    const result = grammar.tokenizeLine(line, stack);
    stack = result.ruleStack;
    return result.tokens.map((token) => ({
      text: line.slice(token.startIndex, token.endIndex),
      scope: token.scopes.at(-1),
    }));
  });
  assert.equal(stack.depth, 1, "a rule is left open");
  return tokens;
}

const texts = readdirSync(join(source, "examples"))
  .filter((name) => name.endsWith(".pls"))
  .map((name) => [name, read("examples", name)]);
for (const [i, block] of [...read("docs", "language.md").matchAll(/```pls[^\n]*\n(.*?)```/gs)].entries())
  texts.push([`docs/language.md, block ${i + 1}`, block[1]]);

test("the keywords of the language were found", () => {
  assert.equal(keywords.size, 28);
  assert.ok(keywords.has("rule") && keywords.has("terminal"));
});

for (const [name, text] of texts) {
  test(`colours of ${name}`, () => {
    for (const token of painted(text)) {
      const word = token.text.trim();
      if (word === "") continue;
      assert.notEqual(token.scope, "source.pls", `'${token.text}' has no colour`);
      if (token.scope.startsWith("comment") || token.scope.startsWith("punctuation.definition.comment")) continue;
      if (keywords.has(word)) assert.match(token.scope, /^(keyword|storage|constant\.language)/, word);
      if (/^-?[0-9]/.test(word)) assert.match(token.scope, /^constant\.numeric/, word);
    }
  });
}

test("names and words are told apart", () => {
  const scope = (text, what) => painted(text).find((token) => token.text === what)?.scope;
  assert.equal(scope("rule C -> { add_left }", "C"), "entity.name.function.pls");
  assert.equal(scope("rule C -> { add_left }", "add_left"), "support.function.command.pls");
  assert.equal(scope("rule C -> { B }", "B"), "support.type.module.pls");
  assert.equal(scope("rules", "rules"), "variable.other.pls");
  assert.equal(scope("a >= -1.5e3 # c", "-1.5e3"), "constant.numeric.pls");
  assert.equal(scope("real in -40..60", "-40"), "constant.numeric.pls");
  assert.equal(scope("real in -40..60", "60"), "constant.numeric.pls");
  assert.equal(scope("a # rule", "# rule") ?? scope("a # rule", " rule"), "comment.line.number-sign.pls");
  assert.equal(scope("# plsc: allow W3003", "allow"), "keyword.other.annotation.pls");
  assert.equal(scope("test t in flat after 2 -> { C }", "in"), "keyword.other.pls");
  assert.equal(scope("test t -> body C { front B }", " body") ?? scope("test t -> body C", "body"), "keyword.other.pls");
});
