// The rules of the genotype: clause terms that hold or do not, by environment,
// and the production's symbols.
import { element } from "../common/dom.js";
import { clauseOf, shortened } from "./model.js";

// "flat: active", and which terms hold there.
function verdict(environment, rule, index) {
  const { active, terms } = environment.rules[index];
  const parts = rule.terms.map((term, i) =>
    element("span", { class: terms[i] ? "holds" : "fails" }, `${terms[i] ? "\u2713" : "\u2717"} ${term}`),
  );
  return element(
    "li",
    { class: active ? "active" : "idle" },
    element("b", {}, environment.name),
    active ? " active " : " not active ",
    parts.map((part) => [part, " "]),
  );
}

function ruleView(robot, index, swatch) {
  const rule = robot.rules[index];
  const number = index + 1;
  return element(
    "article",
    { class: "rule" },
    element(
      "button",
      { type: "button", class: "head", "data-key": `rule:${number}` },
      swatch(number),
      element("b", {}, `rule ${number}: ${rule.head}`),
      ` ${clauseOf(rule)} `,
      element("span", { class: "quiet" }, `line ${rule.line}`),
    ),
    element("ul", { class: "verdicts" }, robot.environments.map((one) => verdict(one, rule, index))),
    element(
      "div",
      { class: "chips" },
      rule.symbols.map((symbol, i) =>
        element("button", { type: "button", class: "chip", "data-key": `symbol:${number}:${i + 1}`, title: symbol.text }, shortened(symbol.text)),
      ),
    ),
  );
}

// `swatch` gives the element that shows a rule's colour, or null.
export function rulesView(robot, swatch) {
  return element(
    "section",
    { class: "rules", "data-scroll": true, "data-group": true, "aria-label": "the rules" },
    element("h2", {}, "Rules"),
    robot.rules.map((rule, i) => ruleView(robot, i, swatch)),
  );
}
