// Early development: the string after each rewriting.
import { element } from "../common/dom.js";
import { nameOf, textOf } from "./model.js";

function stepView(robot, environment, ids, number) {
  return element(
    "li",
    {},
    element("span", { class: "quiet" }, `${number}: `),
    element(
      "span",
      { class: "chips", "data-group": true, role: "group", "aria-label": `iteration ${number} in ${environment.name}` },
      ids.map((id) => {
        const one = environment.insertions[id - 1];
        const isNew = one.iteration === number && number > 0;
        return element(
          "button",
          { type: "button", class: isNew ? "chip fresh" : "chip", "data-key": `in:${environment.number}:${id}`, title: textOf(robot, one) },
          nameOf(robot, one),
        );
      }),
    ),
  );
}

export function stringsView(robot, environment) {
  return element(
    "section",
    {},
    element("h3", {}, "Rewritings"),
    element(
      "ol",
      { class: "steps", "data-scroll": true },
      environment.steps.map((ids, i) => stepView(robot, environment, ids, i)),
    ),
  );
}
