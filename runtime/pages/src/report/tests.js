// The table of all rank-sum tests.
import { element } from "../common/dom.js";
import { csvButton, table } from "./chart.js";
import { difference } from "./measures.js";
import { number, plural, pValue } from "./text.js";

function choose(n, k) {
  let ways = 1;
  for (let i = 1; i <= k; ++i) ways = (ways * (n - k + i)) / i;
  return ways;
}

// The least p that samples of these sizes can have.
const leastP = (m, n) => Math.min(1, 2 / choose(m + n, Math.min(m, n)));

const finalOf = (data, test, experiment) =>
  data.finals.find((one) => one.of === "mean" && one.told === test.told && one.measure === test.measure && one.season === test.season && one.experiment === experiment);

function rowOf(data, test) {
  const first = finalOf(data, test, test.first);
  const second = finalOf(data, test, test.second);
  return {
    measure: data.measures[test.measure].title,
    season: data.seasons[test.season],
    told: test.told,
    pair: `${data.experiments[test.first].name} – ${data.experiments[test.second].name}`,
    n: `${test.first_runs}, ${test.second_runs}`,
    medians: `${number(first.median)} – ${number(second.median)}`,
    means: `${number(first.mean)} – ${number(second.mean)} (${difference(first.mean, second.mean)})`,
    w: number(test.w),
    p: `${pValue(test.p)} ${test.stars}`.trim(),
    method: test.exact === null ? "–" : test.exact ? "exact" : "normal",
  };
}

const csvRow = (data, test) => ({
  measure: data.measures[test.measure].id,
  season: data.seasons[test.season],
  told: test.told,
  first: data.experiments[test.first].name,
  second: data.experiments[test.second].name,
  first_runs: test.first_runs,
  second_runs: test.second_runs,
  first_median: finalOf(data, test, test.first).median,
  second_median: finalOf(data, test, test.second).median,
  first_mean: finalOf(data, test, test.first).mean,
  second_mean: finalOf(data, test, test.second).mean,
  w: test.w,
  p: test.p,
  method: test.exact === null ? "" : test.exact ? "exact" : "normal",
});

const columns = [
  { name: "measure", title: "measure" },
  { name: "season", title: "season" },
  { name: "told", title: "values" },
  { name: "pair", title: "experiments" },
  { name: "n", title: "runs", isNumber: true },
  { name: "medians", title: "medians", isNumber: true },
  { name: "means", title: "means (difference)", isNumber: true },
  { name: "w", title: "W", isNumber: true },
  { name: "p", title: "p", isNumber: true },
  { name: "method", title: "distribution" },
];

function notesOf(data) {
  const bound = Math.max(...data.tests.map((test) => leastP(test.first_runs, test.second_runs)));
  // The same claims told twice are one family.
  const count = data.tests.filter(({ told }) => told === data.tests[0].told).length;
  return [
    `Two-sided Wilcoxon rank-sum tests of the runs' population means in generation ${data.generation}, as R's wilcox.test has them: exact below 50 runs without equal values, else from the normal distribution with corrections for ties and continuity. * p < 0.05, ** p < 0.01, *** p < 0.001.`,
    `${plural(count, "test")}, not corrected for their number, as the paper's are not` + (count > 1 ? `; with Bonferroni's correction the bound for * would be ${pValue(0.05 / count)}.` : "."),
    bound > 0.05 ? `With so few runs p cannot be below ${pValue(bound)}, whatever the difference.` : null,
  ].filter(Boolean);
}

export function testsSection(data) {
  if (!data.tests.length) return null;
  return element(
    "section",
    { id: "tests" },
    element("h2", {}, "Tests"),
    notesOf(data).map((note) => element("p", { class: "note" }, note)),
    table(columns, data.tests.map((test) => rowOf(data, test)), { label: "rank-sum tests" }),
    csvButton("the tests", "tests", data.tests.map((test) => csvRow(data, test))),
  );
}
