// What came of each season, as a table a life, and what the life was made of.
import { element } from "../common/dom.js";
import { balanceText, bodyText, changeText, groundText, outcomeText, speedText } from "./words.js";

const columns = [
  ["Ground", (season) => groundText(season.terrain)],
  ["Robot", (season) => bodyText(season.body)],
  ["What changed", changeText],
  ["Outcome", outcomeText],
  ["Speed", speedText],
  ["Balance", balanceText],
];

export function seasonTable(life, clock) {
  const head = ["Season", ...columns.map(([name]) => name)];
  return element(
    "div",
    { class: "about" },
    element("h3", {}, life.name),
    element("p", { class: "quiet" }, life.remark ? `${life.source}: ${life.remark}` : life.source),
    element(
      "div",
      { class: "wide" },
      element(
        "table",
        {},
        element("thead", {}, element("tr", {}, head.map((name) => element("th", { scope: "col" }, name)))),
        element(
          "tbody",
          {},
          life.seasons.map((season) =>
            element(
              "tr",
              {},
              element("th", { scope: "row" }, element("button", { class: "go", onclick: () => clock.go(season.start) }, season.name)),
              columns.map(([name, text]) => element("td", { "data-column": name }, text(season))),
            ),
          ),
        ),
      ),
    ),
    element("details", {}, element("summary", {}, "Genotype"), element("pre", {}, life.genotype)),
    element("details", {}, element("summary", {}, "Scenario"), element("pre", {}, life.scenario)),
  );
}
