// The best robot of each run, with its body in every season side by side.
import { element } from "../common/dom.js";
import { csvButton, table } from "./chart.js";
import { relivedSpeed, relivedText } from "./relived.js";
import { number } from "./text.js";

const changes = { born: "", none: "same body and brain", brain: "another brain", body: "another body" };

// A picture is loaded as an image: nothing in it is run, whatever it holds.
const picture = (season, label) =>
  season.svg
    ? element("img", { src: `data:image/svg+xml,${encodeURIComponent(season.svg)}`, alt: `body of ${label} in ${season.season}` })
    : element("p", { class: "none" }, season.size ? "not drawn: this version develops another body" : "no robot");

// As a clause writes it: "inclined True, heat 30.5".
const words = { true: "True", false: "False" };
const sensedText = (sensed) =>
  Object.entries(sensed ?? {})
    .map(([state, value]) => `${state} ${words[value] ?? value}`)
    .join(", ");

const seasonFigure = (season, label, relived) =>
  element(
    "figure",
    {},
    picture(season, label),
    element(
      "figcaption",
      {},
      element("b", {}, season.season),
      season.speed === null ? ` ${season.outcome}` : ` ${number(season.speed)} cm/s`,
      relived ? [element("br"), element("span", { class: "relived" }, relived)] : null,
      element("br"),
      season.balance === null ? null : `balance ${number(season.balance)}, `,
      `size ${season.size}`,
      changes[season.change] ? [element("br"), changes[season.change]] : null,
      season.sensed ? [element("br"), element("span", { class: "quiet" }, `senses ${sensedText(season.sensed)}`)] : null,
    ),
  );

function rulesOf(best) {
  if (!best.rules.some(({ clause }) => clause !== null)) return null;
  const columns = [
    { name: "rule", title: "rule", isNumber: true },
    { name: "symbol", title: "of" },
    { name: "clause", title: "clause" },
    ...best.seasons.map(({ season }, i) => ({ name: `s${i}`, title: season })),
  ];
  const rows = best.rules.map(({ symbol, clause, held }, i) => ({
    rule: String(i + 1),
    symbol,
    clause: clause ?? "always",
    ...Object.fromEntries(held.map((isHeld, s) => [`s${s}`, isHeld ? "active" : "–"])),
  }));
  return element("details", {}, element("summary", {}, "rules"), table(columns, rows, { label: `rules of ${best.name}` }));
}

const card = (run) =>
  element(
    "article",
    { class: "robot" },
    element("h4", {}, run.label, run.state === "done" ? null : element("span", { class: "badge" }, run.state)),
    element("p", { class: "quiet" }, `robot ${run.best.id}, born in generation ${run.best.born}`),
    element("div", { class: "bodies" }, run.best.seasons.map((season) => seasonFigure(season, run.label, relivedText(run, season.season)))),
    rulesOf(run.best),
  );

const csvRows = (runs) =>
  runs.flatMap((run) =>
    run.best.seasons.map(({ season, outcome, speed, balance, size, change, sensed }) => ({ run: run.label, robot: run.best.id, born: run.best.born, season, speed_cm_s: speed, relived_low: relivedSpeed(run, season).low, relived_median: relivedSpeed(run, season).median, relived_high: relivedSpeed(run, season).high, balance, size, change, sensed: sensedText(sensed), outcome })),
  );

export function gallerySection(data) {
  const runs = data.runs.filter((run) => run.best);
  if (!runs.length) return null;
  const groups = data.experiments
    .map((experiment, index) => ({ experiment, runs: runs.filter((run) => run.experiment === index) }))
    .filter(({ runs: some }) => some.length);
  return element(
    "section",
    { id: "gallery" },
    element("h2", {}, "Best robots"),
    element("p", { class: "note" }, "Of the last generation of each run, the robot that dominates most others of its pool. Seen from above, the front up; what it developed in each season."),
    groups.map(({ experiment, runs: some }) => [element("h3", {}, experiment.name), element("div", { class: "robots" }, some.map(card))]),
    csvButton("the best robots", "best-robots", csvRows(runs)),
  );
}
