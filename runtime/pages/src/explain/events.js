// Late development: each symbol of the last string and what it did, or why it
// was not expressed.
import { element } from "../common/dom.js";
import { shortened, textOf } from "./model.js";

function eventView(robot, environment, event, index) {
  const one = environment.insertions[environment.string[index] - 1];
  const text = textOf(robot, one);
  return element(
    "li",
    { class: event.expressed ? "expressed" : "silent" },
    element(
      "button",
      { type: "button", class: "event", "data-key": `ev:${environment.number}:${index + 1}`, title: text },
      element("span", { class: "index" }, `${index + 1}`),
      element("span", { class: "what" }, element("code", {}, shortened(text)), " ", shortened(event.text)),
    ),
  );
}

export function eventsView(robot, environment) {
  const silent = environment.events.filter((event) => !event.expressed).length;
  const count = environment.events.length;
  return element(
    "section",
    {},
    element("h3", {}, "Late development"),
    element("p", { class: "quiet" }, `${count} symbol${count === 1 ? "" : "s"}, ${silent} not expressed`),
    element(
      "ol",
      { class: "events", "data-scroll": true, "data-group": true, "aria-label": `what each symbol did in ${environment.name}` },
      environment.events.map((event, i) => eventView(robot, environment, event, i)),
    ),
  );
}
