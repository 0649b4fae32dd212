// Box plots of the generation that is compared, with a dot a run, the tests
// between experiments as brackets, and static experiments as lines.
import * as Plot from "@observablehq/plot";
import { addLegend, axisTitle, chartFigure, legendHeight } from "./chart.js";

const height = 270;
const left = 46;
const halfBox = 0.28;
const mostBrackets = 3; // where not only the significant ones are drawn

// Dots of a box side by side, always in the same places.
const spread = (i) => (((i * 0.618034) % 1) - 0.5) * halfBox * 1.3;

// Brackets above all values, each on a level of its own.
function bracketsOf(chart, places, top, step) {
  const shown = chart.tests.length > mostBrackets ? chart.tests.filter(({ stars }) => stars) : chart.tests;
  return shown.map((test, level) => {
    const y = top + step * (level + 0.8);
    return { x1: places.get(test.first), x2: places.get(test.second), y, foot: y - step * 0.25, text: test.stars || "n.s." };
  });
}

function bracketMarks(brackets) {
  const lines = brackets.map(({ x1, x2, y, foot }) => [
    [x1, foot],
    [x1, y],
    [x2, y],
    [x2, foot],
  ]);
  return [
    lines.map((line) => Plot.line(line, { stroke: "#1b1b1b", strokeWidth: 1 })),
    Plot.text(brackets, { x: ({ x1, x2 }) => (x1 + x2) / 2, y: "y", text: "text", lineAnchor: "bottom", dy: -2, fontSize: 11, fill: "#1b1b1b" }),
  ];
}

function boxMarks(box, x, { colour }) {
  const one = [box];
  const whisker = { x: () => x, stroke: colour, strokeWidth: 1.25 };
  const dots = box.values.map(({ value }, i) => ({ x: x + spread(i), value }));
  return [
    Plot.ruleX(one, { ...whisker, y1: "low_whisker", y2: "low" }),
    Plot.ruleX(one, { ...whisker, y1: "high", y2: "high_whisker" }),
    Plot.rect(one, { x1: x - halfBox, x2: x + halfBox, y1: "low", y2: "high", fill: colour, fillOpacity: 0.16, stroke: colour, strokeWidth: 1.25 }),
    Plot.ruleY(one, { x1: x - halfBox, x2: x + halfBox, y: "median", stroke: colour, strokeWidth: 2.5 }),
    Plot.dot(dots, { x: "x", y: "value", r: 1.8, fill: colour, fillOpacity: 0.6 }),
    Plot.dot(one, { x: () => x, y: "mean", symbol: "diamond", r: 4, fill: "#fff", stroke: "#1b1b1b", strokeWidth: 1.25 }),
  ];
}

const rowsOf = (chart) =>
  [...chart.boxes, ...chart.references].flatMap((box) =>
    box.values.map(({ run, value }) => ({ ...chart.columns, experiment: box.name, run, value })),
  );

// `chart`: {title, yLabel, domain, boxes, references, tests, caption, name}.
export function boxesFigure(chart) {
  const count = chart.boxes.length;
  const width = Math.max(200, left + 20 + 70 * count);
  const places = new Map(chart.boxes.map((box, i) => [box.experiment, i]));
  const [low, high] = chart.domain;
  const step = (high - low || 1) * 0.11;
  const brackets = bracketsOf(chart, places, high, step);
  const entries = chart.references.map(({ name, style }) => ({ text: `${name}: mean`, ...style }));
  const top = legendHeight(entries, width) + 22;
  const label = (name) => (name.length > 11 ? `${name.slice(0, 10)}…` : name);
  const svg = Plot.plot({
    width,
    height: height + top,
    marginTop: top,
    marginLeft: left,
    marginBottom: 36,
    marginRight: 14,
    x: { type: "linear", domain: [-0.6, count - 0.4], ticks: chart.boxes.map((_, i) => i), tickFormat: (i) => label(chart.boxes[i].name), label: null, tickSize: 0, tickPadding: 8 },
    y: { label: null, domain: [low, high + step * (brackets.length + (brackets.length ? 0.6 : 0))], nice: true, ticks: 6, grid: true },
    style: { fontSize: "11px", fontFamily: "system-ui, 'DejaVu Sans', sans-serif", color: "#1b1b1b" },
    marks: [
      axisTitle(chart.yLabel, left),
      chart.references.map(({ mean, style }) => Plot.ruleY([mean], { stroke: style.colour, strokeWidth: 1.75, strokeDasharray: style.dash })),
      chart.boxes.map((box, i) => boxMarks(box, i, box.style)),
      bracketMarks(brackets),
    ],
  });
  addLegend(svg, entries, width);
  return chartFigure({ svg, title: chart.title, name: chart.name, rows: rowsOf(chart), caption: chart.caption, kind: "boxes" });
}
