// The slider of the number under the cursor.
import { element } from "../common/dom.js";
import { Newest } from "./newest.js";
import { unitsOf } from "./language/places.js";

// As few digits as the step asks for.
function written(value, step) {
  const digits = Math.max(0, Math.min(6, Math.ceil(-Math.log10(step))));
  return String(Number(value.toFixed(digits)));
}

export class Parameters {
  constructor(door, editor) {
    this.editor = editor;
    this.label = element("label", { for: "slider" });
    this.slider = element("input", { type: "range", step: "any", id: "slider", oninput: () => this.#slide() });
    this.value = element("output", { for: "slider" });
    this.ends = [element("span", { class: "quiet" }), element("span", { class: "quiet" })];
    this.row = element("div", { class: "row", hidden: true }, this.ends[0], this.slider, this.ends[1], this.value);
    this.object = element("section", { class: "parameter", "aria-label": "The number under the cursor" }, this.label, this.row);
    this.asking = new Newest(({ text, at }) => this.#ask(door, text, at));
    this.#hide();
  }

  // Called when the cursor or the text moved.
  look() {
    if (this.isSliding) return;
    const { state } = this.editor.view;
    const { head } = state.selection.main;
    const line = state.doc.lineAt(head);
    const column = [...line.text.slice(0, head - line.from)].length + 1; // characters, not units
    this.asking.add({ text: state.doc.toString(), at: { line: line.number, column } });
  }

  #hide() {
    this.shown = null;
    this.row.hidden = true;
    this.label.textContent = "Put the cursor on a number to slide it.";
    this.label.className = "quiet";
  }

  async #ask(door, text, at) {
    const answer = await door.ask({ ask: "parameters", text, at });
    if (text !== this.editor.text || this.isSliding) return;
    const found = answer.ok ? answer.parameters?.[0] : null;
    if (!found) return this.#hide();
    const units = unitsOf(text);
    this.#show(found, units(found.byte_begin), units(found.byte_end));
  }

  #show({ name, about, value, from: lowest, to: highest, step }, from, to) {
    this.shown = { from, to, step };
    this.label.replaceChildren(name, " ", element("span", { class: "quiet" }, /```/.test(about) ? "" : about.split("\n")[0].replaceAll("`", "")));
    this.label.className = "";
    this.row.hidden = false;
    this.slider.min = lowest;
    this.slider.max = highest;
    this.slider.value = value;
    this.value.textContent = this.editor.text.slice(from, to);
    this.ends[0].textContent = lowest;
    this.ends[1].textContent = highest;
  }

  #slide() {
    const { from, to, step } = this.shown;
    const text = written(Number(this.slider.value), step);
    this.isSliding = true;
    this.editor.replace(from, to, text);
    this.isSliding = false;
    this.shown.to = from + text.length;
    this.value.textContent = text;
  }
}
