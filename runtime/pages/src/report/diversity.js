// How far the robots of a population are one and the same.
import { element } from "../common/dom.js";
import { censusFigure } from "./census.js";

const parts = [
  { name: "genotypes", title: "Different genotypes", yLabel: "genotypes" },
  { name: "phenotypes", title: "Different robots", yLabel: "robots, of all seasons together" },
  { name: "founders", title: "Robots of generation 0 with descendants", yLabel: "founders" },
];

export function diversitySection(data, styles) {
  if (!data.diversity.length) return null;
  return element(
    "section",
    { id: "diversity" },
    element("h2", {}, "Diversity"),
    element(
      "p",
      { class: "note" },
      "Of the survivors of each generation. Where few robots are different, a mean is of few lives. Descent is by first parents, and by second parents that gave a rule.",
    ),
    element("div", { class: "charts" }, parts.map((part) => censusFigure(data, styles, { section: "diversity", curves: data.diversity, part, inRow: parts.length }))),
  );
}
