// The page of `plsc report`: from its data (docs/reports.md) to sections.
import "../common/base.css";
import "./main.css";
import { readData } from "../common/data.js";
import { element } from "../common/dom.js";
import { claimsSection } from "./claims.js";
import { differencesSection } from "./differences.js";
import { enginesSection } from "./engines.js";
import { gallerySection } from "./gallery.js";
import { measureSection } from "./measures.js";
import { numbered } from "./numbered.js";
import { diversitySection } from "./diversity.js";
import { plasticitySection } from "./plasticity.js";
import { provenanceSection } from "./provenance.js";
import { relivedNote } from "./relived.js";
import { stylesOf } from "./series.js";
import { swapsSection } from "./swaps.js";
import { testsSection } from "./tests.js";
import { plural } from "./text.js";
import { unfinishedText } from "./unfinished.js";

function statesText(runs) {
  const counts = new Map();
  for (const { state } of runs) counts.set(state, (counts.get(state) ?? 0) + 1);
  return [...counts].map(([state, count]) => `${count} ${state}`).join(", ");
}

// "flat (50 s)", "slope (tilted: 5 deg, 50 s)".
function seasonText({ name, terrain, duration }) {
  const ground = terrain.replace(/^\{(.*)\}$/, "$1");
  return `${name} (${ground === name ? "" : `${ground}, `}${duration} s)`;
}

const experimentText = (one) =>
  `${one.encoding}, population ${one.population} + ${one.offspring}, ${plural(one.generations, "generation")}, ` +
  one.seasons.map(seasonText).join(" then ") +
  (one.static ? "; a reference" : "");

function header(data) {
  const left = data.runs.filter(({ problem }) => problem);
  const waiting = data.runs.filter(({ state }) => state !== "done" && state !== "damaged");
  return element(
    "header",
    {},
    element("h1", {}, data.title),
    element("p", { class: "quiet" }, `${plural(data.runs.length, "run")} of ${plural(data.experiments.length, "experiment")}: ${statesText(data.runs)}. Made by ${data.made.by}, ${data.made.at}.`),
    waiting.length
      ? element("p", { class: "warning" }, `Not finished: ${unfinishedText(waiting)}. What is shown will change.`)
      : null,
    left.map(({ label, problem }) => element("p", { class: "warning" }, `Left out: ${label}. ${problem}.`)),
    element("dl", {}, data.experiments.map((one) => [element("dt", {}, one.name), element("dd", {}, experimentText(one))])),
  );
}

function contents(sections) {
  const link = (section) => element("li", {}, element("a", { href: `#${section.id}` }, section.querySelector("h2, h3").textContent));
  return element("nav", { "aria-label": "contents" }, element("ul", {}, sections.map(link)));
}

function measuresSection(data, measures) {
  if (!measures.length) return element("section", { id: "measures" }, element("h2", {}, "Measures"), element("p", {}, "No generation is completed yet."));
  const note = data.single
    ? "Lines are medians and bands quartiles of the population's robots, in each generation, and the thin line is its best robot, the one that dominates most others. Robots whose life was not completed have no behaviour and are left out."
    : "Each run counts with the mean of its population, and below with its best robot, the one that dominates most others. Lines are medians and bands quartiles of runs. Boxes are quartiles, whiskers end at the farthest run within 1.5 times the box, dots are runs, diamonds means. Robots whose life was not completed have no behaviour and are left out.";
  const without = data.measures.filter((_, i) => !data.curves.some(({ measure }) => measure === i)).map(({ title }) => title);
  return element(
    "section",
    { id: "measures" },
    element("h2", {}, "Measures"),
    element("p", { class: "note" }, note),
    relivedNote(data),
    without.length ? element("p", { class: "note", id: "without" }, `No run has a value of ${without.join(", ")}.`) : null,
    element("div", { class: data.single && data.seasons.length === 1 ? "pairs" : null }, measures),
  );
}

function show(data) {
  const styles = stylesOf(data.experiments);
  const measures = data.measures.map((_, index) => measureSection(data, styles, index)).filter(Boolean);
  const first = [claimsSection(data), differencesSection(data)].filter(Boolean);
  const rest = [testsSection(data), diversitySection(data, styles), plasticitySection(data, styles), swapsSection(data, styles), enginesSection(data, styles), gallerySection(data), provenanceSection(data)].filter(Boolean);
  const all = measuresSection(data, measures);
  document.body.append(element("main", {}, header(data), contents([...first, ...measures, ...rest]), first, all, rest));
}

show(numbered(readData()));
