// One robot: its rules and text beside its environments.
import { element } from "../common/dom.js";
import { tell } from "./about.js";
import { bodyView, rowsOf } from "./body.js";
import { brainView } from "./brain.js";
import { eventsView } from "./events.js";
import { enter, Highlight } from "./highlight.js";
import { modelOf } from "./model.js";
import { rulesView } from "./rules.js";
import { sourceView } from "./source.js";
import { stringsView } from "./strings.js";

const idle = "Point at a module, a rule or a symbol, or press it to keep it lit.";

// Which colour a rule has: its place among those that made a module.
export function ruleColours(robot, numbers) {
  const rules = new Set();
  for (const { modules, insertions, string } of robot.environments)
    for (const module of modules) rules.add(insertions[string[module.origin - 1] - 1].rule);
  const sorted = [...rules].filter((rule) => rule > 0).sort((a, b) => a - b);
  return new Map(sorted.map((rule, i) => [rule, numbers[i % numbers.length]]));
}

function environmentView(robot, environment, rows, colourOf) {
  return element(
    "section",
    { class: "environment" },
    element("h2", {}, environment.name, " ", element("span", { class: "quiet" }, environment.senses)),
    bodyView(environment, rows, colourOf),
    stringsView(robot, environment),
    eventsView(robot, environment),
    brainView(environment),
  );
}

export function legend(robot) {
  const first = robot.environments[0].name;
  const marks = new Set(robot.environments.flatMap((one) => one.modules.map((module) => module.mark)));
  const entries = [];
  if (marks.has("new")) entries.push(element("li", {}, element("span", { class: "key new" }), `not there in ${first}`));
  if (marks.has("other")) entries.push(element("li", {}, element("span", { class: "key other" }), `another module than in ${first}`));
  if (robot.environments.some((one) => one.missing.length > 0))
    entries.push(element("li", {}, element("span", { class: "key missing" }), `there in ${first} only`));
  return element("ul", { class: "legend" }, entries);
}

// `options`: colours of the page, whether modules are coloured by rule.
export function robotView(data, options) {
  const robot = modelOf(data);
  const byRule = ruleColours(robot, options.colours.numbers);
  const ruleOf = ({ insertions, string }, module) => insertions[string[module.origin - 1] - 1].rule;
  const colourOf = (environment, module) =>
    options.isByRule
      ? (byRule.get(ruleOf(environment, module)) ?? { fill: "#fff", ink: "#000" })
      : { fill: options.colours.types[module.type], ink: "#000" };
  const swatch = (rule) => {
    const colour = options.isByRule && byRule.get(rule);
    if (!colour) return null;
    const made = element("span", { class: "swatch" });
    made.style.background = colour.fill;
    return made;
  };
  // Cores lie on a line where bodies are side by side (main.css).
  const isStacked = window.matchMedia("(max-width: 860px)").matches;
  const rows = (environment) => rowsOf(isStacked ? [environment] : robot.environments);
  const lines = element("div", { class: "lines", role: "status" }, element("p", {}, idle));
  const release = element("button", { type: "button", hidden: true }, "Let go");
  const root = element(
    "div",
    { class: "robot" },
    element("div", { class: "genotype" }, rulesView(robot, swatch), sourceView(robot)),
    element(
      "div",
      { class: "right" },
      legend(robot),
      element("div", { class: "environments" }, robot.environments.map((one) => environmentView(robot, one, rows(one), colourOf))),
    ),
    element("div", { class: "about" }, lines, release),
  );
  enter(root);
  const highlight = new Highlight(root, robot, (key, isKept) => {
    release.hidden = !isKept;
    const told = key === null ? [idle] : tell(robot, key);
    lines.replaceChildren(...told.map((text) => element("p", {}, text)));
  });
  release.addEventListener("click", () => highlight.letGo());
  return root;
}
