// Buttons that open something below them; Escape or a press elsewhere closes it.
import { element } from "../common/dom.js";

export function panel(label, content) {
  const object = element("details", { class: "menu" }, element("summary", {}, label), element("div", { class: "opened" }, content));
  object.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !object.open) return;
    object.open = false;
    object.firstChild.focus();
  });
  document.addEventListener("pointerdown", (event) => {
    if (!object.contains(event.target)) object.open = false;
  });
  return object;
}

// `entries`: [what to do in words, act(), a note or nothing].
export function menu(label, entries) {
  const item = ([text, act, note]) => {
    const run = () => {
      object.open = false;
      act();
    };
    return element("li", {}, element("button", { type: "button", onclick: run }, text, note ? element("span", { class: "quiet" }, note) : null));
  };
  const object = panel(label, element("ul", {}, entries.map(item)));
  return object;
}
