// What the language server knows, as CodeMirror asks for it.
import { autocompletion, snippet } from "@codemirror/autocomplete";
import { setDiagnostics } from "@codemirror/lint";
import { hoverTooltip } from "@codemirror/view";
import { element } from "../../common/dom.js";
import { markdown } from "./markdown.js";
import { changesOf, offsetOf, positionOf, rangeOf, wholeOf } from "./places.js";

// By CompletionItemKind; CodeMirror has an icon for each.
const kinds = { 3: "function", 6: "variable", 7: "class", 12: "constant", 14: "keyword", 15: "text", 20: "enum", 21: "constant" };

function optionOf(doc, item) {
  const text = item.textEdit?.newText ?? item.insertText ?? item.label;
  const isSnippet = item.insertTextFormat === 2;
  return {
    label: item.filterText ?? item.label,
    displayLabel: item.label,
    detail: item.detail && item.detail !== item.label ? item.detail : undefined,
    type: kinds[item.kind],
    apply: isSnippet ? snippet(text.replace(/\$\{(\d+):([^}]*)\}/g, "#{$2}").replace(/\$\d/g, "#{}")) : text,
    info: item.documentation ? () => markdown(item.documentation.value ?? item.documentation) : undefined,
  };
}

export function completion(client) {
  const source = async (context) => {
    const word = context.matchBefore(/[\w.]+/);
    if (!word && !context.explicit && !/[ ={(]$/.test(context.state.doc.sliceString(context.pos - 1, context.pos))) return null;
    const { doc } = context.state;
    const answer = await client.ofDocument("textDocument/completion", { position: positionOf(doc, context.pos) });
    const items = Array.isArray(answer) ? answer : (answer?.items ?? []);
    if (context.aborted || items.length === 0) return null;
    const range = items[0].textEdit?.range;
    return { from: range ? offsetOf(doc, range.start) : (word?.from ?? context.pos), options: items.map((item) => optionOf(doc, item)), validFor: /^[\w.]*$/ };
  };
  return autocompletion({ override: [source], icons: false });
}

export function hover(client) {
  return hoverTooltip(async (view, at) => {
    const { doc } = view.state;
    const answer = await client.ofDocument("textDocument/hover", { position: positionOf(doc, at) });
    if (!answer || view.state.doc !== doc) return null;
    const range = answer.range ? rangeOf(doc, answer.range) : { from: at, to: at };
    return { pos: range.from, end: range.to, above: true, create: () => ({ dom: markdown(answer.contents.value ?? String(answer.contents)) }) };
  });
}

const severities = { 1: "error", 2: "warning", 3: "info", 4: "hint" };

function actionOf(action) {
  const edits = Object.values(action.edit?.changes ?? {}).flat();
  return {
    name: action.title,
    apply(view) {
      view.dispatch({ changes: changesOf(view.state.doc, edits), userEvent: "input.fix" });
      view.focus();
    },
  };
}

const key = ({ code, range }) => `${code} ${JSON.stringify([range.start.line, range.start.character, range.end.line, range.end.character])}`;

// Shows the diagnostics, each with the fixes that the server has for it.
export async function showDiagnostics(view, client, diagnostics) {
  const { doc } = view.state;
  const actions = new Map();
  if (diagnostics.length > 0) {
    const answer = await client.ofDocument("textDocument/codeAction", { range: wholeOf(doc), context: { diagnostics } });
    if (view.state.doc !== doc) return;
    for (const action of answer ?? [])
      for (const of of action.diagnostics ?? []) actions.set(key(of), [...(actions.get(key(of)) ?? []), actionOf(action)]);
  }
  const shown = diagnostics.map((one) => ({
    ...rangeOf(doc, one.range),
    severity: severities[one.severity] ?? "error",
    source: one.code ? `${one.code}` : undefined,
    message: one.message,
    actions: actions.get(key(one)) ?? [],
  }));
  view.dispatch(setDiagnostics(view.state, shown));
}

export async function format(view, client) {
  const { doc } = view.state;
  const edits = await client.ofDocument("textDocument/formatting", { options: { tabSize: 2, insertSpaces: true } });
  if (!edits || edits.length === 0 || view.state.doc !== doc) return false;
  view.dispatch({ changes: changesOf(doc, edits), userEvent: "input.format" });
  return true;
}
