// What one can take along.
import { download, element } from "../common/dom.js";

const stem = (name) => name.replace(/\.pls$/, "");

// state(): {text, name, scenario, genotype, view}; `view` is the last life's, if any.
export function downloadMenu(door, state, say) {
  const picture = async () => {
    const { text, name } = state();
    const answer = await door.ask({ ask: "picture", text, name });
    if (!answer.ok) return say(answer.error);
    download(`${stem(name)}.svg`, "image/svg+xml", answer.body);
  };
  const recording = () => {
    const { name, view } = state();
    if (!view) return say("There is no life to take along yet.");
    download(`${stem(name)}.rec.json`, "application/json", JSON.stringify(view.lives[0].recording));
  };
  const entries = [
    ["Genotype (.pls)", () => download(state().name, "text/plain", state().text)],
    ["Drawing of the bodies (.svg)", picture],
    ["Recording of the life (.rec.json)", recording],
  ];
  return menu("Download", entries);
}

// A button that opens a list of things to do.
export function menu(label, entries) {
  const close = () => (object.open = false);
  const object = element(
    "details",
    { class: "menu" },
    element("summary", {}, label),
    element(
      "ul",
      {},
      entries.map(([text, act, note]) =>
        element("li", {}, element("button", { type: "button", onclick: () => (close(), act()) }, text, note ? element("span", { class: "quiet" }, note) : null)),
      ),
    ),
  );
  object.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !object.open) return;
    close();
    object.firstChild.focus();
  });
  document.addEventListener("pointerdown", (event) => object.contains(event.target) || close());
  return object;
}
