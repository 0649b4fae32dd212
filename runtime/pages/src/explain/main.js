// How genotypes become robots: the page of `plsc view --explain`.
import "../common/base.css";
import "./main.css";
import { readData } from "../common/data.js";
import { element } from "../common/dom.js";
import { robotView } from "./robot.js";

const data = readData();
const state = { robot: 0, isByRule: false };
const place = element("main");

// Buttons of which one is pressed.
function choice(label, names, chosen, choose) {
  const buttons = names.map((name, i) =>
    element(
      "button",
      {
        type: "button",
        "aria-pressed": i === chosen ? "true" : "false",
        onclick: () => {
          buttons.forEach((one, k) => one.setAttribute("aria-pressed", k === i ? "true" : "false"));
          choose(i);
        },
      },
      name,
    ),
  );
  return element("div", { class: "choice", role: "group", "aria-label": label }, element("span", { class: "quiet" }, label), buttons);
}

function show() {
  place.replaceChildren(robotView(data.robots[state.robot], { colours: data.colours, isByRule: state.isByRule }));
}

const titles = data.robots.map((robot) => robot.title);
const hide = element("input", { type: "checkbox", id: "hide", onchange: () => place.classList.toggle("only-expressed", hide.checked) });
document.body.append(
  element(
    "header",
    {},
    element("h1", {}, titles.length === 1 ? titles[0] : "Robots"),
    element("p", { class: "quiet" }, "how the genotype became the robot, in each environment"),
    element(
      "div",
      { class: "tools" },
      titles.length > 1 ? choice("Robot", titles, 0, (i) => ((state.robot = i), show())) : null,
      choice("Colour", ["type", "rule"], 0, (i) => ((state.isByRule = i === 1), show())),
      element("label", { for: "hide" }, hide, " hide symbols that are not expressed"),
    ),
  ),
  place,
);
show();
