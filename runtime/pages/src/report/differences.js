// In which keys the experiments differ from each other and from the paper.
import { element } from "../common/dom.js";
import { csvButton, table } from "./chart.js";

export function differencesSection(data) {
  const { differences, experiments } = data;
  const several = experiments.length > 1;
  const text = (value) => value ?? "–";
  const cell = (value, { paper }) => (value === paper ? text(value) : element("b", {}, text(value)));
  const columns = [
    { name: "key", title: "key" },
    { name: "paper", title: "paper" },
    ...experiments.map(({ name }, i) => ({ name: `e${i}`, title: name })),
  ];
  const rowOf = (one) => ({
    key: one.between || !several ? one.key : element("span", { class: "quiet" }, one.key),
    paper: text(one.paper),
    ...Object.fromEntries(experiments.map(({ name }, i) => [`e${i}`, cell(one.values[name], one)])),
  });
  const note = several
    ? "Keys of the experiments in which one differs from another or from the paper's; bold is what differs from the paper, grey keys are those in which all are alike. All other keys have the paper's values."
    : "Keys in which the experiment differs from the paper's. All other keys have the paper's values.";
  return element(
    "section",
    { id: "differences" },
    element("h2", {}, "What differs"),
    differences.length
      ? [
          element("p", { class: "note" }, note),
          table(columns, [...differences.filter(({ between }) => between), ...differences.filter(({ between }) => !between)].map(rowOf), { label: "differences between experiments" }),
          csvButton(
            "the differences",
            "differences",
            differences.flatMap((one) => experiments.map(({ name }) => ({ key: one.key, experiment: name, value: text(one.values[name]), paper: text(one.paper), between: one.between }))),
          ),
        ]
      : element("p", { class: "note" }, "Every key has the paper's value."),
  );
}
