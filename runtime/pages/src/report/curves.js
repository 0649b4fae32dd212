// Curves over generations: medians as lines, quartiles as bands.
import * as Plot from "@observablehq/plot";
import { addLegend, axisTitle, chartFigure, legendHeight } from "./chart.js";
import { number } from "./text.js";

const height = 270;
const left = 46;
const gap = 16; // px, of main.css
const widest = 1240; // px, of main.css

// px. Where box plots stand beside them.
export const usualWidth = 380;

// Of `count` charts that have a row to themselves, as far as the window has
// one; at most half of it each, so that one alone leaves room for another.
export function widthInRow(count) {
  const room = Math.min(widest, document.documentElement.clientWidth - 40);
  const inRow = Math.max(2, count);
  return Math.max(usualWidth, Math.floor((room - gap * (inRow - 1)) / inRow));
}

// A line is {name, style, low, median, high, counts, hasBand}.
const pointsOf = (line) =>
  line.median.map((median, generation) => ({ generation, median, low: line.low[generation], high: line.high[generation], runs: line.counts[generation] }));

// `isThinned`: between generations that were kept there is nothing to show, and
// lines go on.
function marksOf(line, isThinned) {
  const points = pointsOf(line).filter(({ median }) => !isThinned || median !== null);
  const { colour, dash, width: strokeWidth } = line.style;
  const band = Plot.areaY(points, { x: "generation", y1: "low", y2: "high", fill: colour, fillOpacity: 0.16, curve: "linear" });
  const curve = Plot.line(points, { x: "generation", y: "median", stroke: colour, strokeWidth, strokeDasharray: dash ?? undefined });
  // A single generation is no line.
  const dot = points.length === 1 ? [Plot.dot(points, { x: "generation", y: "median", fill: colour, r: 3 })] : [];
  return [line.hasBand ? [band] : [], curve, dot].flat();
}

// `chart`: {title, yLabel, domain, lines, caption, name, isShare, isThinned, width}.
export function curvesFigure(chart) {
  const { width = usualWidth } = chart;
  const entries = chart.lines.map((line) => ({ text: line.name, ...line.style }));
  const top = legendHeight(entries, width) + 22;
  const tips = chart.lines.flatMap((line) =>
    pointsOf(line)
      .filter(({ median }) => median !== null)
      .map((point) => ({ ...point, text: `${line.name}\ngeneration ${point.generation}: ${number(point.median)}\n${line.isOne ? "one robot" : `quartiles ${number(point.low)} to ${number(point.high)}\n${chart.isSingle ? "of the population" : `runs: ${point.runs}`}`}` })),
  );
  const svg = Plot.plot({
    width,
    height: height + top,
    marginTop: top,
    marginLeft: left,
    marginBottom: 36,
    marginRight: 14,
    x: { label: "generation", labelAnchor: "center", labelArrow: "none", tickFormat: "d", ticks: Math.min(5, chart.generations[1]), domain: chart.generations },
    y: { label: null, domain: chart.domain, nice: true, ticks: 6, grid: true, percent: chart.isShare },
    style: { fontSize: "11px", fontFamily: "system-ui, 'DejaVu Sans', sans-serif", color: "#1b1b1b" },
    marks: [
      axisTitle(chart.yLabel, left),
      chart.lines.map((line) => marksOf(line, chart.isThinned)),
      Plot.tip(tips, Plot.pointer({ x: "generation", y: "median", title: "text", fontSize: 11 })),
    ],
  });
  addLegend(svg, entries, width);
  const rows = chart.lines.flatMap((line) =>
    pointsOf(line).map(({ generation, runs, low, median, high }) => ({ ...chart.columns, experiment: line.name, generation, runs, quartile_1: low, median, quartile_3: high })),
  );
  return chartFigure({ svg, title: chart.title, name: chart.name, rows, caption: chart.caption, kind: "curves" });
}
