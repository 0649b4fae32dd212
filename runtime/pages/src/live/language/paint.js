// What is drawn into the text: colours by meaning, hints behind lines, and the
// symbols that belong to what is pointed at elsewhere on the page.
import { StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView, WidgetType } from "@codemirror/view";
import { element } from "../../common/dom.js";
import { offsetOf } from "./places.js";

// A layer of decorations that moves along with the text until it is set anew.
function layer() {
  const set = StateEffect.define();
  const field = StateField.define({
    create: () => Decoration.none,
    update(decorations, transaction) {
      for (const effect of transaction.effects) if (effect.is(set)) return effect.value;
      return decorations.map(transaction.changes);
    },
    provide: (self) => EditorView.decorations.from(self),
  });
  return { field, set };
}

const colours = layer();
const hints = layer();
const lit = layer();
export const paintLayers = [colours.field, hints.field, lit.field];

// The server's five numbers a token: line and character since the one before,
// length, type, modifiers.
export function colourEffect(doc, { data }, legend) {
  const marks = [];
  let [line, character] = [0, 0];
  for (let i = 0; i + 4 < data.length; i += 5) {
    if (data[i] > 0) character = 0;
    line += data[i];
    character += data[i + 1];
    const from = offsetOf(doc, { line, character });
    const to = offsetOf(doc, { line, character: character + data[i + 2] });
    if (to > from) marks.push(Decoration.mark({ class: `of-${legend[data[i + 3]]}` }).range(from, to));
  }
  return colours.set.of(Decoration.set(marks, true));
}

class Hint extends WidgetType {
  constructor(label, tooltip) {
    super();
    this.label = label;
    this.tooltip = tooltip;
  }
  eq(other) {
    return other.label === this.label && other.tooltip === this.tooltip;
  }
  toDOM() {
    const isIdle = /^inactive/.test(this.label);
    return element("span", { class: isIdle ? "hint idle" : "hint", title: this.tooltip }, this.label);
  }
}

export function hintEffect(doc, found) {
  const widgets = found.map(({ label, tooltip, position }) =>
    Decoration.widget({ widget: new Hint(String(label), String(tooltip ?? "")), side: 1 }).range(offsetOf(doc, position)),
  );
  return hints.set.of(Decoration.set(widgets, true));
}

// `ranges`: [{from, to, name}], in units of the text.
export function litEffect(ranges) {
  const marks = ranges.filter(({ from, to }) => to > from).map(({ from, to, name }) => Decoration.mark({ class: name }).range(from, to));
  return lit.set.of(Decoration.set(marks, true));
}
