// What one can take along.
import { download } from "../common/dom.js";
import { menu } from "./menu.js";

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
