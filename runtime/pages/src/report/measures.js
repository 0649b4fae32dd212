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

function curveCaption(data, season, lines) {
  const counts = lines.flatMap(({ counts }) => counts);
  const references = lines.filter(({ hasBand }) => !hasBand);
  const what = data.single
    ? "median and quartiles of the population of the one run"
    : `median and quartiles of the runs' population means, n = ${range(counts)} runs an experiment`;
  const dotted = references.length ? `; grey: median of ${references.map(({ name }) => name).join(", ")}, where the season is always the same` : "";
  return `${season}: ${what}${dotted}.`;
}

function boxCaption(data, season, boxes, tests) {
  const n = boxes.map(({ values }) => values.length);
  const told = tests.map(({ p }) => (p === null ? "no test: all values are equal" : `p = ${pValue(p)}`));
  const test = told.length === 1 ? ` Rank-sum test: ${told[0].replaceAll(" ", "\u00a0")}.` : "";
  return `${season}, generation ${data.generation}: population means, n = ${n.join(", ")} runs.${test}`;
}

export function measureSection(data, styles, index) {
  const measure = data.measures[index];
  const mine = (list) => list.filter((one) => one.measure === index);
  const curves = mine(data.curves);
  const finals = mine(data.finals);
  const tests = mine(data.tests);
  if (!curves.length) return null;
  const curveDomain = domainOf(curves.flatMap(({ experiment, low, median, high }) => (data.experiments[experiment].static ? [median] : [low, high])));
  const boxDomain = domainOf(finals.flatMap(({ experiment, values, mean }) => (data.experiments[experiment].static ? [mean] : values.map(({ value }) => value))));
  const generations = [0, Math.max(1, ...curves.map(({ median }) => median.length - 1))];
  const width = data.single ? widthInRow(data.seasons.length) : usualWidth;
  const figures = { curves: [], boxes: [] };
  data.seasons.forEach((season, seasonIndex) => {
    const here = (one) => one.season === seasonIndex;
    const common = { yLabel: `${season}: ${withUnit(measure)}`, columns: { measure: measure.id, unit: measure.unit ?? "", season } };
    const lines = curves.filter(here).map(({ experiment, low, median, high, runs }) => ({
      name: data.experiments[experiment].name,
      style: styles[experiment],
      hasBand: !data.experiments[experiment].static,
      counts: runs,
      low,
      median,
      high,
    }));
    if (lines.length)
      figures.curves.push(
        curvesFigure({ ...common, title: `${measure.title} over generations, ${season}`, name: fileName(measure.title, season, "curves"), domain: curveDomain, generations, lines, width, isSingle: data.single, caption: curveCaption(data, season, lines) }),
      );
    const named = finals.filter(here).map((one) => ({
      ...one,
      name: data.experiments[one.experiment].name,
      style: styles[one.experiment],
      values: one.values.map(({ run, value }) => ({ run: data.runs[run].label, value })),
    }));
    const boxes = named.filter(({ experiment }) => !data.experiments[experiment].static);
    const references = named.filter(({ experiment }) => data.experiments[experiment].static);
    // Of one run there is no distribution of runs.
    if (boxes.length && !data.single)
      figures.boxes.push(
        boxesFigure({ ...common, title: `${measure.title} of generation ${data.generation}, ${season}`, name: fileName(measure.title, season, "boxes"), domain: boxDomain, boxes, references, tests: tests.filter(here), caption: boxCaption(data, season, boxes, tests.filter(here)) }),
      );
  });
  return element("section", { class: "measure", id: `measure-${index}` }, element("h3", {}, withUnit(measure)), element("div", { class: "charts" }, figures.curves, figures.boxes));
}

// What the means of two experiments differ by.
export function difference(first, second) {
  if (!second) return "–";
  const change = (100 * (first - second)) / Math.abs(second);
  return `${change > 0 ? "+" : ""}${number(Number(change.toPrecision(2)))} %`;
}
