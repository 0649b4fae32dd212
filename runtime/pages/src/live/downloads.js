// What one can take along.
import { download } from "../common/dom.js";
import { menu } from "./menu.js";

const stem = (name) => name.replace(/\.pls$/, "");

// state(): {text, name, scenario, genotype, view}; `view` is the last life's, if any.
// `copy`: a PageCopy where the page needs nobody else; else null.
export function downloadMenu(door, copy, state, warn) {
  const picture = async (what, suffix) => {
    const { text, name, scenario, ...rest } = state();
    const answer = await door.ask({ ask: "picture", text, name, scenario, ...(rest.genotype ? { genotype: rest.genotype } : {}) });
    if (!answer.ok) return warn(answer.error);
    download(`${stem(name)}${suffix}.svg`, "image/svg+xml", answer[what]);
  };
  const recording = () => {
    const { name, view } = state();
    if (!view) return warn("There is no life to take along yet.");
    download(`${stem(name)}.rec.json`, "application/json", JSON.stringify(view.lives[0].recording));
  };
  const entries = [
    ["Genotype (.pls)", () => download(state().name, "text/plain", state().text)],
    ["Drawing of the bodies (.svg)", () => picture("body", "")],
    ["Drawing of the brains (.svg)", () => picture("brain", "-brain")],
    ["Recording of the life (.rec.json)", recording],
  ];
  const page = () => {
    const { text, name, scenario } = state();
    download(`${stem(name)}.html`, "text/html", copy.with({ robot: text, name, scenario }));
  };
  if (copy) entries.push(["This page with this robot (.html)", page]);
  return menu("Download", entries);
}
