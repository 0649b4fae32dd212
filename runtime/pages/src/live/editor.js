// The editor: CodeMirror with our own language server.
import { closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { bracketMatching } from "@codemirror/language";
import { lintGutter, lintKeymap } from "@codemirror/lint";
import { EditorState, Transaction } from "@codemirror/state";
import { EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from "@codemirror/view";
import { LanguageClient } from "./language/client.js";
import { completion, format, hover, showDiagnostics } from "./language/features.js";
import { colourEffect, hintEffect, litEffect, paintLayers } from "./language/paint.js";
import { wholeOf } from "./language/places.js";

const language = EditorState.languageData.of(() => [{ commentTokens: { line: "#" }, closeBrackets: { brackets: ["(", "{"] } }]);

export class Editor {
  // listeners: onChange(text), onCursor().
  constructor(door, text, listeners) {
    this.listeners = listeners;
    this.client = new LanguageClient(door, {
      onText: () => this.#paint(),
      onDiagnostics: (diagnostics) => showDiagnostics(this.view, this.client, diagnostics),
    });
    door.onRestart = () => this.client.reopen();
    this.view = new EditorView({ state: this.#state(text) });
    this.object = this.view.dom;
    this.client.change(text);
  }

  #state(text) {
    return EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        lintGutter(),
        highlightActiveLine(),
        highlightActiveLineGutter(),
        EditorView.lineWrapping,
        history(),
        bracketMatching(),
        closeBrackets(),
        language,
        paintLayers,
        completion(this.client),
        hover(this.client),
        keymap.of([
          { key: "Shift-Alt-f", run: () => (this.format(), true) },
          ...closeBracketsKeymap,
          ...completionKeymap,
          ...lintKeymap,
          ...historyKeymap,
          ...defaultKeymap,
        ]),
        EditorView.contentAttributes.of({ "aria-label": "Genotype", spellcheck: "false" }),
        EditorView.updateListener.of((update) => this.#updated(update)),
      ],
    });
  }

  get text() {
    return this.view.state.doc.toString();
  }

  #updated(update) {
    if (update.docChanged) {
      this.client.change(this.text);
      this.listeners.onChange(this.text);
    }
    if (update.docChanged || update.selectionSet) this.listeners.onCursor();
  }

  // Another text, which undo takes back.
  setText(text) {
    if (text === this.text) return;
    this.view.dispatch({ changes: { from: 0, to: this.view.state.doc.length, insert: text }, selection: { anchor: 0 }, scrollIntoView: true });
  }

  // Another robot: there is no way back from it by undo.
  open(text) {
    this.view.setState(this.#state(text));
    this.client.change(text);
    this.listeners.onChange(text);
    this.listeners.onCursor();
  }

  // A number that is being slid to; one undo takes the whole slide back.
  replace(from, to, insert) {
    this.view.dispatch({ changes: { from, to, insert }, annotations: Transaction.userEvent.of("input.slide") });
  }

  format() {
    return format(this.view, this.client);
  }

  light(ranges) {
    const { length } = this.view.state.doc;
    this.view.dispatch({ effects: litEffect(ranges.filter(({ to }) => to <= length)) });
  }

  scrollTo(offset) {
    this.view.dispatch({ effects: EditorView.scrollIntoView(offset, { y: "center" }) });
  }

  async #paint() {
    const { doc } = this.view.state;
    const [tokens, hints] = await Promise.all([
      this.client.ofDocument("textDocument/semanticTokens/full"),
      this.client.ofDocument("textDocument/inlayHint", { range: wholeOf(doc) }),
    ]);
    if (this.view.state.doc !== doc) return;
    const effects = [];
    if (tokens) effects.push(colourEffect(doc, tokens, this.client.legend));
    effects.push(hintEffect(doc, hints ?? []));
    this.view.dispatch({ effects });
  }
}
