// What plastic robots lose in a season with another season's body and brain:
// whether it pays that these differ.
import { element } from "../common/dom.js";
import { boxesFigure } from "./boxes.js";
import { csvButton, table } from "./chart.js";
import { fileName, number, pValue } from "./text.js";

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

function chartOf(data, styles, season, losses) {
  const values = losses.flatMap((one) => one.values.map(({ value }) => value));
  const low = Math.min(0, ...values);
  const high = Math.max(0, ...values);
  const air = (high - low) * 0.05 || 1;
  const boxes = losses.map((one) => {
    const experiment = data.experiments.findIndex(({ name }) => name === one.experiment);
    return { ...one, experiment, name: one.experiment, style: styles[experiment] };
  });
  const told = boxes.map(({ name, values: runs, p }) => `${name}: n = ${runs.length} runs, ${p === null ? "no loss at all" : `p = ${pValue(p)}`}`);
  return boxesFigure({
    title: `Speed lost with the other season's body and brain, ${season}`,
    name: fileName("swap", season, "boxes"),
    yLabel: `${season}: Speed lost, cm/s`,
    columns: { measure: "swap_loss", unit: "cm/s", season },
    domain: [low - air, high + air],
    boxes,
    references: [],
    tests: [],
    caption: `${season}, generation ${data.generation}: means over plastic robots, own less swapped. Signed-rank test against 0: ${told.join("; ")}.`,
  });
}

const columns = [
  { name: "experiment", title: "experiment" },
  { name: "season", title: "season" },
  { name: "runs", title: "runs", isNumber: true },
  { name: "own", title: "own, cm/s", isNumber: true },
  { name: "swapped", title: "swapped, cm/s", isNumber: true },
  { name: "loss", title: "loss, median of runs", isNumber: true },
  { name: "v", title: "V", isNumber: true },
  { name: "p", title: "p", isNumber: true },
];

const rowOf = (one) => ({
  experiment: one.experiment,
  season: one.season,
  runs: String(one.values.length),
  own: number(mean(one.values.map(({ own }) => own))),
  swapped: number(mean(one.values.map(({ swapped }) => swapped))),
  loss: number(one.median),
  v: one.v === null ? "–" : number(one.v),
  p: one.p === null ? "–" : `${pValue(one.p)} ${one.stars}`.trim(),
});

const csvRows = (swaps) =>
  swaps.flatMap(({ measure, season, experiment, values }) =>
    values.map(({ run, robots, own, swapped, value }) => ({ measure, season, experiment, run, robots, own_cm_s: own, swapped_cm_s: swapped, loss_cm_s: value })),
  );

export function swapsSection(data, styles) {
  if (!data.swaps.length) return null;
  const speeds = data.swaps.filter(({ measure }) => measure === "displacement_velocity_hill");
  const charts = data.single
    ? []
    : data.seasons.map((season) => [season, speeds.filter((one) => one.season === season)]).filter(([, losses]) => losses.length);
  return element(
    "section",
    { id: "swaps" },
    element("h2", {}, "Swap test"),
    element(
      "p",
      { class: "note" },
      "Survivors that differ between seasons live each season with another season's body and brain, from the same displaced starts. What they lose is what the difference is good for; around 0 it is of no use, below 0 it harms. Each run counts with the mean over its plastic robots; the test is Wilcoxon's signed-rank test, exact and two-sided.",
    ),
    element("div", { class: "charts" }, charts.map(([season, losses]) => chartOf(data, styles, season, losses))),
    table(columns, speeds.map(rowOf), { label: "swap test" }),
    csvButton("the swap test", "swaps", csvRows(data.swaps)),
  );
}
