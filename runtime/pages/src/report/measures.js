// A section a measure: curves and box plots of every season side by side, on
// the same scales, as the paper's figures have them.
import { element } from "../common/dom.js";
import { boxesFigure } from "./boxes.js";
import { curvesFigure, usualWidth, widthInRow } from "./curves.js";
import { fileName, number, pValue, range, withUnit } from "./text.js";

// The least and the greatest of numbers, nulls left out, with a little air.
function domainOf(values) {
  const numbers = values.flat().filter((value) => value !== null);
  if (!numbers.length) return [0, 1];
  const low = Math.min(...numbers);
  const high = Math.max(...numbers);
  const air = (high - low) * 0.04 || Math.abs(high) * 0.1 || 1;
  // Measures that cannot be negative do not look as if they could.
  return [low >= 0 ? Math.max(0, low - air) : low - air, high + air];
}

// What of a run counts.
const kinds = {
  mean: { of: "population means", title: "" },
  best: { of: "best robots", title: " of the best robots" },
};

function curveCaption(data, season, lines, of) {
  const counts = lines.flatMap(({ counts }) => counts);
  const references = lines.filter(({ hasBand }) => !hasBand);
  const what = data.single
    ? "median and quartiles of the population of the one run, and its best robot"
    : `median and quartiles of the runs' ${kinds[of].of}, n = ${range(counts)} runs an experiment`;
  const dotted = references.length ? `; grey: median of ${references.map(({ name }) => name).join(", ")}, where the season is always the same` : "";
  return `${season}: ${what}${dotted}.`;
}

function boxCaption(data, season, boxes, tests, of, told) {
  const n = boxes.map(({ values }) => values.length);
  const values = tests.map(({ p }) => (p === null ? "no test: all values are equal" : `p = ${pValue(p)}`));
  const test = values.length === 1 ? ` Rank-sum test: ${values[0].replaceAll(" ", "\u00a0")}.` : "";
  return `${season}, generation ${data.generation}: ${told === "relived" ? `${kinds[of].of}, of medians of relived lives` : kinds[of].of}, n = ${n.join(", ")} runs.${test}`;
}

// A row of charts: curves and boxes of one kind, in every season.
function chartsOf(data, styles, index, of, told = "recorded") {
  const measure = data.measures[index];
  const mine = (list) => list.filter((one) => one.measure === index && (one.of ?? "mean") === of && (one.told ?? "recorded") === told);
  const curves = told === "recorded" ? mine(data.curves) : [];
  const finals = mine(data.finals);
  const tests = of === "mean" ? mine(data.tests) : [];
  if (!curves.length && !finals.length) return null;
  const isStatic = ({ experiment }) => data.experiments[experiment].static;
  const title = `${told === "relived" ? "Relived " : ""}${measure.title}${kinds[of].title}`;
  const bests = data.single ? data.curves.filter((one) => one.measure === index && one.of === "best") : [];
  const curveDomain = domainOf([...curves.flatMap((one) => (isStatic(one) ? [one.median] : [one.low, one.high])), ...bests.map(({ median }) => median)]);
  const boxDomain = domainOf(finals.flatMap((one) => (isStatic(one) ? [one.mean] : one.values.map(({ value }) => value))));
  const generations = [0, Math.max(1, ...curves.map(({ median }) => median.length - 1))];
  const width = data.single ? widthInRow(data.seasons.length) : usualWidth;
  const figures = { curves: [], boxes: [] };
  data.seasons.forEach((season, seasonIndex) => {
    const here = (one) => one.season === seasonIndex;
    const common = { yLabel: `${season}: ${withUnit(measure)}`, columns: { measure: measure.id, unit: measure.unit ?? "", season, of, told } };
    const lines = curves.filter(here).map((one) => ({
      name: data.experiments[one.experiment].name,
      style: styles[one.experiment],
      hasBand: !isStatic(one) || data.single,
      counts: one.runs,
      low: one.low,
      median: one.median,
      high: one.high,
    }));
    // Beside the population of the one run, its best robot.
    const robots = bests.filter(here).map((one) => ({
      name: `${data.experiments[one.experiment].name}, best robot`,
      style: { ...styles[one.experiment], width: 1, dash: "3 2" },
      hasBand: false,
      isOne: true,
      counts: one.runs,
      low: one.low,
      median: one.median,
      high: one.high,
    }));
    if (lines.length)
      figures.curves.push(
        curvesFigure({ ...common, title: `${title} over generations, ${season}`, name: fileName(title, season, "curves"), domain: curveDomain, generations, lines: [...lines, ...robots], width, isSingle: data.single, isThinned: data.thinned, caption: curveCaption(data, season, lines, of) }),
      );
    const named = finals.filter(here).map((one) => ({
      ...one,
      name: data.experiments[one.experiment].name,
      style: styles[one.experiment],
    }));
    const boxes = named.filter((one) => !isStatic(one));
    const references = named.filter(isStatic);
    // Of one run there is no distribution of runs.
    if (boxes.length && !data.single)
      figures.boxes.push(
        boxesFigure({ ...common, title: `${title} of generation ${data.generation}, ${season}`, name: fileName(title, season, "boxes"), domain: boxDomain, boxes, references, tests: tests.filter(here), caption: boxCaption(data, season, boxes, tests.filter(here), of, told) }),
      );
  });
  return element("div", { class: "charts" }, figures.curves, figures.boxes);
}

export function measureSection(data, styles, index) {
  const means = chartsOf(data, styles, index, "mean");
  if (!means) return null;
  const best = data.single ? null : chartsOf(data, styles, index, "best");
  const relived = data.single ? [] : ["mean", "best"].map((of) => chartsOf(data, styles, index, of, "relived")).filter(Boolean);
  return element(
    "section",
    { class: "measure", id: `measure-${index}` },
    element("h3", {}, withUnit(data.measures[index])),
    relived.length ? [element("h4", {}, "Relived: population means, best robots"), relived, element("h4", {}, "Recorded")] : null,
    means,
    best ? [element("h4", {}, "Best robot of each run"), best] : null,
  );
}

// What the means of two experiments differ by.
export function difference(first, second) {
  if (!second) return "–";
  const change = (100 * (first - second)) / Math.abs(second);
  return `${change > 0 ? "+" : ""}${number(Number(change.toPrecision(2)))} %`;
}
