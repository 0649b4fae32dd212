// Curves of what a census counts of each generation's survivors.
import { curvesFigure, usualWidth, widthInRow } from "./curves.js";
import { fileName, number, percent, range } from "./text.js";

// `curves`: of the report, an item an experiment. `part`: {name, title, yLabel,
// isShare}; `inRow`: how many charts stand side by side.
export function censusFigure(data, styles, { section, curves, part, inRow }) {
  const lines = curves.map((one) => ({
    name: data.experiments[one.experiment].name,
    style: styles[one.experiment],
    hasBand: data.single || !data.experiments[one.experiment].static,
    counts: one.runs,
    ...one[part.name],
  }));
  const told = part.isShare ? percent : number;
  const last = lines.map(({ name, median }) => `${name} ${told(median.at(-1))}`).join(", ");
  const most = Math.max(...curves.map(({ experiment }) => data.experiments[experiment].population));
  const of = data.single ? "of the population" : `median and quartiles of n = ${range(lines.flatMap(({ counts }) => counts))} runs an experiment`;
  return curvesFigure({
    title: part.title,
    yLabel: part.yLabel,
    columns: { part: part.name },
    isThinned: data.thinned,
    domain: part.isShare ? [0, 100] : [0, most],
    isShare: part.isShare,
    generations: [0, Math.max(1, ...lines.map(({ median }) => median.length - 1))],
    lines,
    width: data.single ? widthInRow(inRow) : usualWidth,
    isSingle: data.single,
    name: fileName(section, part.name),
    caption: `${part.title}, ${of}. At the end: ${last}.`,
  });
}
