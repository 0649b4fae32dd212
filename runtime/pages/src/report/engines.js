// The best robots by the engine that their run did not have: Speed then against
// Speed now, a chart a season, and how far ranks agree.
import * as Plot from "@observablehq/plot";
import { element } from "../common/dom.js";
import { addLegend, axisTitle, chartFigure, csvButton, legendHeight, table } from "./chart.js";
import { fileName, number, plural } from "./text.js";

const size = 300;
const left = 46;
const centimetres = 100; // a metre

// Every robot that completed the season by both engines.
const dotsOf = (runs, name) =>
  runs.flatMap((run) =>
    run.engine_check.seasons
      .filter(({ season }) => season === name)
      .flatMap(({ lives, stored_engine: before }) =>
        lives
          .filter(({ stored, now }) => stored !== null && now !== null)
          .map(({ id, stored, now }) => ({ run, id, before, stored: stored * centimetres, now: now * centimetres })),
      ),
  );

function seasonFigure(data, styles, runs, name) {
  const dots = dotsOf(runs, name);
  if (!dots.length) return null;
  const shown = [...new Set(dots.map(({ run }) => run.experiment))];
  const entries = shown.map((index) => ({ text: data.experiments[index].name, ...styles[index], isArea: true }));
  const top = legendHeight(entries, size) + 22;
  const all = dots.flatMap(({ stored, now }) => [stored, now]);
  const domain = [Math.min(...all), Math.max(...all)];
  const title = `Speed by both engines in ${name}`;
  const svg = Plot.plot({
    width: size,
    height: size + top,
    marginTop: top,
    marginLeft: left,
    marginBottom: 36,
    marginRight: 14,
    x: { label: "in the run (cm/s)", labelAnchor: "center", labelArrow: "none", domain, nice: true, ticks: 5, grid: true },
    y: { label: null, domain, nice: true, ticks: 5, grid: true },
    style: { fontSize: "11px", fontFamily: "system-ui, 'DejaVu Sans', sans-serif", color: "#1b1b1b" },
    marks: [
      axisTitle("by the other engine (cm/s)", left),
      Plot.line([domain, domain].map(([low, high], i) => (i ? [high, high] : [low, low])), { stroke: "#999", strokeDasharray: "3 3" }),
      Plot.dot(dots, { x: "stored", y: "now", r: 3, fill: ({ run }) => styles[run.experiment].colour, fillOpacity: 0.6 }),
      Plot.tip(dots, Plot.pointer({ x: "stored", y: "now", title: ({ run, id, stored, now }) => `${run.label}, robot ${id}\n${number(stored)} and ${number(now)} cm/s`, fontSize: 11 })),
    ],
  });
  addLegend(svg, entries, size);
  return chartFigure({
    svg,
    title,
    name: fileName("engines", name),
    rows: dots.map(({ run, id, before, stored, now }) => ({ season: name, run: run.label, robot: id, stored_engine: before, engine: run.engine_check.engine, stored_cm_s: stored, now_cm_s: now })),
    caption: `${name}: ${plural(dots.length, "robot")}`,
    kind: "engines",
  });
}

const rowsOf = (runs) =>
  runs.flatMap((run) =>
    run.engine_check.seasons.map((one) => ({
      run: run.label,
      season: one.season,
      stored_engine: one.stored_engine,
      engine: run.engine_check.engine,
      both: one.both,
      only_stored: one.only_stored,
      only_now: one.only_now,
      rank_correlation: one.rank_correlation,
      median_cm_s: one.median_difference === null ? null : one.median_difference * centimetres,
      largest_cm_s: one.largest_difference === null ? null : one.largest_difference * centimetres,
    })),
  );

const columns = [
  { name: "run", title: "run" },
  { name: "season", title: "season" },
  { name: "stored_engine", title: "in the run" },
  { name: "engine", title: "checked by" },
  { name: "both", title: "lived in both", isNumber: true },
  { name: "only_stored", title: "only in the run", isNumber: true },
  { name: "only_now", title: "only now", isNumber: true },
  { name: "rank_correlation", title: "rank correlation", isNumber: true },
  { name: "median_cm_s", title: "median difference (cm/s)", isNumber: true },
  { name: "largest_cm_s", title: "largest (cm/s)", isNumber: true },
];

export function enginesSection(data, styles) {
  const runs = data.runs.filter((run) => run.engine_check);
  if (!runs.length) return null;
  const seasons = [...new Set(runs.flatMap((run) => run.engine_check.seasons.map(({ season }) => season)))];
  const rows = rowsOf(runs);
  const text = (row) => Object.fromEntries(Object.entries(row).map(([key, value]) => [key, typeof value === "string" ? value : number(value)]));
  return element(
    "section",
    { id: "engines" },
    element("h2", {}, "The other engine"),
    element("p", { class: "note" }, "The best robots of each run's last generation, lived again by the engine that the run did not have. On the dashed line both give the same Speed. The rank correlation is Spearman's, of the robots that completed the season by both."),
    element("div", { class: "charts" }, seasons.map((name) => seasonFigure(data, styles, runs, name))),
    table(columns, rows.map(text), { label: "robots by both engines" }),
    csvButton("the engines", "engines", rows),
  );
}
