// How plastic populations are, and which clauses are held where.
import * as Plot from "@observablehq/plot";
import { element } from "../common/dom.js";
import { addLegend, chartFigure, legendHeight } from "./chart.js";
import { censusFigure } from "./census.js";
import { patternColours } from "./series.js";
import { fileName, plural } from "./text.js";

const parts = [
  { name: "body", title: "Robots whose body differs between seasons", yLabel: "% of robots", isShare: true },
  { name: "brain_only", title: "Robots whose brain alone differs between seasons", yLabel: "% of robots", isShare: true },
  { name: "regulated", title: "Rules that have a clause", yLabel: "% of rules", isShare: true },
  { name: "silent", title: "Rules that are active in no season", yLabel: "% of rules", isShare: true },
];

// "only flat", "flat and tilted", "never".
function patternName(seasons, held) {
  const names = seasons.filter((_, i) => held[i]);
  if (!names.length) return "never";
  if (names.length === seasons.length) return seasons.length === 2 ? "both" : "all seasons";
  return `only ${names.join(" and ")}`;
}

const barWidth = 560;
const longest = 46; // letters of a clause that there is room for
const letterWidth = 6;
const rowHeight = 22;

function clauseFigure(data, one, kind, title) {
  const seasons = data.experiments[one.experiment].seasons.map(({ name }) => name);
  const patterns = [...new Set(one[kind].flatMap(({ held }) => held.map(({ seasons: where }) => JSON.stringify(where))))]
    .sort((a, b) => (b.match(/true/g)?.length ?? 0) - (a.match(/true/g)?.length ?? 0) || b.localeCompare(a))
    .map((pattern, i) => ({ pattern, text: patternName(seasons, JSON.parse(pattern)), colour: patternColours[i % patternColours.length] }));
  const of = new Map(patterns.map((entry) => [entry.pattern, entry]));
  const shown = one[kind].slice(0, 12);
  const name = (item) => item.name || "(always)";
  const long = (text) => (text.length > longest ? `${text.slice(0, longest - 1)}…` : text);
  const bars = shown.flatMap((item) =>
    patterns.flatMap(({ pattern, text, colour }) => {
      const found = item.held.find(({ seasons: where }) => JSON.stringify(where) === pattern);
      return found ? [{ item: name(item), text, colour, share: (100 * found.rules) / item.rules, rules: found.rules }] : [];
    }),
  );
  const left = 24 + letterWidth * Math.min(longest, Math.max(...shown.map((item) => name(item).length)));
  const entries = patterns.map(({ text, colour }) => ({ text, colour, isArea: true }));
  const top = legendHeight(entries, barWidth) + 8;
  const svg = Plot.plot({
    width: barWidth,
    height: top + 40 + rowHeight * shown.length,
    marginTop: top,
    marginLeft: left,
    marginBottom: 36,
    marginRight: 60,
    x: { label: "% of rules", labelAnchor: "center", labelArrow: "none", domain: [0, 100] },
    y: { label: null, domain: shown.map(name), tickFormat: long, tickSize: 0, padding: 0.2 },
    style: { fontSize: "11px", fontFamily: "system-ui, 'DejaVu Sans', sans-serif", color: "#1b1b1b" },
    marks: [
      Plot.barX(bars, { y: "item", x: "share", fill: "colour", stroke: "#444", strokeWidth: 0.5, order: null }),
      Plot.text(shown, { y: name, x: 100, text: ({ rules }) => rules.toLocaleString("en-US"), textAnchor: "start", dx: 5 }),
    ],
  });
  addLegend(svg, entries, barWidth);
  const experiment = data.experiments[one.experiment].name;
  const rows = one[kind].flatMap((item) => item.held.map(({ seasons: where, rules }) => ({ experiment, [kind === "clauses" ? "clause" : "symbol"]: name(item), held: of.get(JSON.stringify(where)).text, rules })));
  const total = one[kind].reduce((sum, { rules }) => sum + rules, 0);
  const rest = one[kind].length - shown.length;
  return chartFigure({
    svg,
    title: `${title}, ${experiment}`,
    name: fileName(experiment, kind),
    rows,
    kind: "bars",
    caption: `${experiment}: ${title}, of ${plural(total, "rule")} of the last populations; at the right, how many${rest > 0 ? `; the CSV has ${rest} more` : ""}.`,
  });
}

export function plasticitySection(data, styles) {
  if (!data.plasticity.length && !data.regulation.length) return null;
  return element(
    "section",
    { id: "plasticity" },
    element("h2", {}, "Plasticity"),
    element("p", { class: "note" }, "A robot is plastic where another body, or another brain, develops of its one genotype in another season. A clause that is held in some seasons only is what makes it so."),
    element("div", { class: "charts" }, data.plasticity.length ? parts.map((part) => censusFigure(data, styles, { section: "plasticity", curves: data.plasticity, part, inRow: 2 })) : null),
    data.regulation.length ? element("h3", {}, "Where rules are active") : null,
    element(
      "div",
      { class: "charts" },
      data.regulation.flatMap((one) => [
        clauseFigure(data, one, "symbols", "seasons in which the rules of each symbol are active"),
        clauseFigure(data, one, "clauses", "seasons in which each clause holds"),
      ]),
    ),
  );
}
