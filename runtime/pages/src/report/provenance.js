// Where the results come from: runs, versions, constants.
import { element } from "../common/dom.js";
import { csvButton, table } from "./chart.js";
import { servos } from "./servos.js";
import { duration, percent, plural, whole } from "./text.js";

const isRead = (run) => run.seed !== undefined;

function shareLookedUp({ simulated, looked_up }) {
  const all = simulated + looked_up;
  return all ? looked_up / all : null;
}

const columns = [
  { name: "run", title: "run" },
  { name: "state", title: "state" },
  { name: "seed", title: "seed", isNumber: true },
  { name: "generations", title: "generations", isNumber: true },
  { name: "evaluations", title: "evaluations", isNumber: true },
  { name: "seconds", title: "wall time", isNumber: true },
  { name: "cpu", title: "CPU time", isNumber: true },
  { name: "simulated", title: "seasons simulated", isNumber: true },
  { name: "share", title: "looked up", isNumber: true },
  { name: "sessions", title: "sessions", isNumber: true },
  { name: "last", title: "ended" },
];

function rowOf(run) {
  const state = run.state === "done" ? "done" : element("span", { class: "badge" }, run.state);
  if (!isRead(run)) return { run: run.label, state };
  const { work } = run;
  return {
    run: run.label,
    state,
    seed: run.seed,
    generations: `${run.generations}/${run.generations_planned}`,
    evaluations: `${whole(run.evaluations)}/${whole(run.evaluations_planned)}`,
    seconds: duration(work.seconds),
    cpu: duration(work.cpu_seconds),
    simulated: whole(work.simulated),
    share: percent(shareLookedUp(work)),
    sessions: work.open_sessions ? `${work.sessions} (${work.open_sessions} not ended)` : String(work.sessions),
    last: work.last,
  };
}

const csvRow = (run) => ({
  run: run.label,
  path: run.path,
  state: run.state,
  problem: run.problem,
  seed: run.seed,
  generations: run.generations,
  generations_planned: run.generations_planned,
  evaluations: run.evaluations,
  evaluations_planned: run.evaluations_planned,
  wall_seconds: run.work?.seconds,
  cpu_seconds: run.work?.cpu_seconds,
  seasons_simulated: run.work?.simulated,
  seasons_looked_up: run.work?.looked_up,
  sessions: run.work?.sessions,
  first_session: run.work?.first,
  last_session: run.work?.last,
  hosts: run.work?.hosts.join(" "),
  plsc: run.plsc,
  ode: run.ode,
  compiler: run.compiler,
  machine: run.machine,
});

function totals(runs) {
  const sum = (take) => runs.reduce((total, run) => total + take(run), 0);
  const work = { simulated: sum((run) => run.work.simulated), looked_up: sum((run) => run.work.looked_up) };
  const open = sum((run) => run.work.open_sessions);
  return (
    `${plural(sum((run) => run.evaluations), "evaluation")}; ${whole(work.simulated)} seasons simulated, ${percent(shareLookedUp(work))} of all looked up instead; ` +
    `${duration(sum((run) => run.work.seconds))} by the wall and ${duration(sum((run) => run.work.cpu_seconds))} of CPU` +
    (open ? `, without ${plural(open, "session")} that did not end` : "") +
    "."
  );
}

const verifiedText = ({ verified }) =>
  verified
    ? "All results were compared with their checksums, and are what was written. (Hosts and times of sessions have no checksums.)"
    : "Not all results were compared with their checksums: only the best robots, the rules of the last populations and what the runs are. To compare all, add --verify to plsc report.";

function versions(runs) {
  const texts = new Map();
  for (const run of runs) {
    const text =
      run.machine === "any"
        ? `plsc ${run.plsc}, results ${run.results}, by the articulated engine, which comes to the same bits on any machine`
        : `plsc ${run.plsc}, results ${run.results}, ODE ${run.ode}, compiler ${run.compiler}, machine ${run.machine}`;
    texts.set(text, [...(texts.get(text) ?? []), run.label]);
  }
  if (texts.size === 1) return [element("p", {}, `All runs: ${[...texts.keys()][0]}.`)];
  return [...texts].map(([text, labels]) => element("p", {}, element("b", {}, text), `: ${labels.join(", ")}`));
}

// What runs of older stores cannot tell.
function lacks(runs) {
  const older = runs.filter((run) => run.lacks.length);
  if (!older.length) return null;
  const names = [...new Set(older.flatMap((run) => run.lacks))].join(", ");
  const whose = older.length === runs.length ? "These runs were" : `${older.map(({ label }) => label).join(", ")} were`;
  return element("p", { id: "lacks" }, `${whose} made by a plsc that did not measure ${names}, and are left out there.`);
}

// How experiments have robots live, where it is not once and undisturbed.
function lives({ experiments }) {
  const told = experiments.filter((one) => one.lives);
  if (!told.length) return null;
  return element(
    "p",
    { id: "lives" },
    `${told.map((one) => `${one.name}: ${one.lives}`).join("; ")}. Fitness, and who is best, are over all trials; all else that is recorded is of each robot's first trial.`,
  );
}

// What experiments go by, where it is not the paper's fitness.
function fitness({ experiments }) {
  const own = experiments.filter((one) => one.fitness);
  if (!own.length) return null;
  return element("p", { id: "fitness" }, `Fitness is ${own.map((one) => `${one.name}: ${one.fitness}`).join("; ")}${own.length < experiments.length ? "; of the others the paper's" : ""}.`);
}

// A row a constant; a column an experiment's season, equal ones put together.
function constants(data) {
  const sets = data.constants.flatMap(({ experiment, same, values }) =>
    [...new Set(values.map(({ season }) => season))].map((season) => ({
      title: `${data.experiments[experiment].name}: ${season}${same ? "" : " (differs between runs)"}`,
      values: new Map(values.filter((value) => value.season === season).map(({ name, value, unit }) => [name, unit ? `${value} ${unit}` : value])),
    })),
  );
  const merged = new Map();
  for (const { title, values } of sets) {
    const key = JSON.stringify([...values]);
    if (merged.has(key)) merged.get(key).titles.push(title);
    else merged.set(key, { titles: [title], values });
  }
  const shown = [...merged.values()];
  const names = [...new Set(shown.flatMap(({ values }) => [...values.keys()]))];
  const rows = names.map((name) => ({ name, ...Object.fromEntries(shown.map(({ values }, i) => [`c${i}`, values.get(name)])) }));
  return element(
    "details",
    {},
    element("summary", {}, `Constants of the simulations (${names.length})`),
    table([{ name: "name", title: "constant" }, ...shown.map(({ titles }, i) => ({ name: `c${i}`, title: titles.join(", ") }))], rows, { label: "constants" }),
    csvButton("the constants", "constants", data.constants.flatMap(({ experiment, values }) => values.map((value) => ({ experiment: data.experiments[experiment].name, ...value })))),
  );
}

export function provenanceSection(data) {
  const read = data.runs.filter(isRead);
  return element(
    "section",
    { id: "provenance" },
    element("h2", {}, "Provenance"),
    element("p", {}, totals(read)),
    versions(read),
    lacks(read),
    lives(data),
    fitness(data),
    element("p", { id: "verified" }, verifiedText(data)),
    table(columns, data.runs.map(rowOf), { label: "runs" }),
    csvButton("the runs", "runs", data.runs.map(csvRow)),
    servos(data),
    data.constants.length ? constants(data) : null,
  );
}
