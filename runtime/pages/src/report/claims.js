// What the study claims and whether it holds: the first table of a report.
import { element } from "../common/dom.js";
import { csvButton, table } from "./chart.js";
import { number, plural, pValue, range } from "./text.js";

const marks = { holds: "✓", opposite: "✗", "not shown": "?", "too few runs": "…" };

const interval = (limits) => (limits ? ` (${number(limits[0])} to ${number(limits[1])})` : "");

const badge = (verdict) => element("span", { class: `verdict ${verdict.replaceAll(" ", "-")}` }, `${marks[verdict]} ${verdict}`);

// By whom, what the verdict rests on first.
const findingsOf = (claim) => {
  const told = claim.told === "relived" ? ["relived", "recorded"] : ["recorded", "relived"];
  return told.filter((one) => claim[one]).map((one) => [one, claim[one]]);
};

const statedText = ({ at, when }) => `${at} ${when}`;

const withUnit = (text, unit) => (unit ? `${text} ${unit}` : text);

// What is claimed, of which measure, since when, and where it is from.
function words(data, claim, measure) {
  const of = claim.of === "best" ? " of the best" : "";
  const published = claim.kind === "value" ? ` ${measure.unit ?? ""}` : "";
  const quiet = (text) => element("div", { class: "quiet" }, text);
  return element(
    "div",
    { class: "claim" },
    element("b", {}, claim.claim),
    element("div", {}, `${measure.title}${of}: ${claim.says}${published}`),
    claim.source ? quiet(`source: ${claim.source}`) : null,
    claim.stated.runs_begun > 0 ? element("div", { class: "late" }, `stated ${statedText(claim.stated)}`) : null,
    claim.withdrawn ? element("div", { class: "late" }, `withdrawn ${statedText(claim.withdrawn)}`) : null,
  );
}

// Why runs that are there have no value.
function whyNone(claim, told) {
  if (told === "relived") return "not lived again";
  return claim.kind === "minimum_before" ? "without a whole curve" : "not measured";
}

function runsText(claim, told, { runs, paired }) {
  const joined = (counts) => (paired ? String(counts[0]) : counts.join(" + "));
  if (joined(runs) === joined(claim.runs_planned)) return joined(runs);
  const without = claim.runs_completed.map((completed, i) => Math.max(0, completed - runs[i]));
  const why = without.some((count) => count > 0) ? `, ${joined(without)} ${whyNone(claim, told)}` : "";
  return `${joined(runs)} of ${joined(claim.runs_planned)}${why}`;
}

function effectText(claim, finding) {
  if (claim.kind === "minimum_before") return `so in ${finding.runs_so} of ${plural(finding.runs[0], "run")}${interval(finding.interval)}`;
  if (claim.kind === "value") return interval(finding.interval).trim() || "–";
  return finding.a === null ? "–" : `${number(finding.a)}${interval(finding.interval)}`;
}

function mediansText(claim, finding, unit) {
  if (claim.kind === "minimum_before") return finding.minimum === null ? "–" : `lowest in generation ${finding.minimum}`;
  if (claim.kind === "value") return `${claim.over_runs} ${withUnit(number(finding.ours), unit)}`;
  return withUnit(finding.medians.map(number).join(" – "), unit);
}

const holmText = (claim, { holm }) => (holm === null || holm === undefined ? "–" : `${pValue(holm)} of ${claim.corrected_among}`);

function rowsOf(data, claim) {
  const measure = data.measures.find(({ id }) => id === claim.measure);
  return findingsOf(claim).map(([told, finding], i) => ({
    verdict: badge(finding.verdict),
    claim: i === 0 ? words(data, claim, measure) : "",
    told,
    runs: runsText(claim, told, finding),
    medians: mediansText(claim, finding, measure.unit),
    ratio: finding.ratio === undefined ? "–" : number(finding.ratio),
    effect: effectText(claim, finding),
    p: pValue(finding.p ?? null),
    holm: holmText(claim, finding),
  }));
}

const csvRows = (claim) =>
  findingsOf(claim).map(([told, finding]) => ({
    claim: claim.claim,
    says: claim.says,
    measure: claim.measure,
    of: claim.of,
    kind: claim.kind,
    values: told,
    verdict: finding.verdict,
    first_runs: finding.runs[0],
    second_runs: finding.runs[1] ?? null,
    first_median: finding.medians[0],
    second_median: finding.medians[1] ?? null,
    ratio: finding.ratio ?? null,
    a: finding.a ?? null,
    published: claim.value,
    ours: finding.ours ?? null,
    minimum: finding.minimum ?? null,
    low: finding.interval?.[0] ?? null,
    high: finding.interval?.[1] ?? null,
    p: finding.p ?? null,
    holm: finding.holm ?? null,
    corrected_among: claim.corrected_among,
    source: claim.source,
    stated: claim.stated.at,
    hash: claim.stated.hash,
    runs_begun: claim.stated.runs_begun,
  }));

const columns = [
  { name: "verdict", title: "verdict" },
  { name: "claim", title: "claim" },
  { name: "told", title: "values" },
  { name: "runs", title: "runs", isNumber: true },
  { name: "medians", title: "medians", isNumber: true },
  { name: "ratio", title: "ratio", isNumber: true },
  { name: "effect", title: "A, or interval (95 %)", isNumber: true },
  { name: "p", title: "p", isNumber: true },
  { name: "holm", title: "by Holm", isNumber: true },
];

// "17 claims stated 2026-... before the first run (hash ...)", a line a version.
function statements(data) {
  return data.claims_stated.flatMap(({ study, problem, versions }) => [
    problem ? element("p", { class: "warning" }, `The record of what ${study} claims cannot be trusted: ${problem}.`) : null,
    ...versions.map((one, i) =>
      element(
        "p",
        { class: one.runs_begun > 0 ? "warning" : "note" },
        `${i > 0 ? "Changed to " : ""}${plural(one.claims, "claim")}, ${i > 0 ? "at" : "stated"} ${statedText(one)}; hash ${one.hash}.`,
      ),
    ),
  ]);
}

function notesOf(data) {
  const { claims } = data;
  const kinds = new Set(claims.map(({ kind }) => kind));
  const isTwo = ["greater", "less", "equal"].some((kind) => kinds.has(kind));
  const counts = claims.filter(({ kind }) => kind === "greater" || kind === "less").map(({ corrected_among }) => corrected_among);
  const isRelived = claims.some(({ relived }) => relived);
  return [
    isRelived ? "The verdict rests on relived values where all runs with a record have them, otherwise on recorded ones; it stands first, and the other values below it with theirs." : null,
    isTwo ? "A is Vargha and Delaney's, the probability that a run of the first is above one of the second (of seasons, in the same run), with a 95 % bootstrap interval; p is Wilcoxon's, two-sided." : null,
    counts.length ? `Greater and less hold if p, by Holm's correction of ${range(counts)} claims, is below 0.05.` : null,
    kinds.has("equal") ? "Equal holds if the interval of A lies within 0.36 to 0.64, no more than a small effect, and its opposite is shown if it lies outside; a p above 0.05 shows nothing." : null,
    kinds.has("value") ? "A published value holds if it lies in the interval of ours." : null,
    kinds.has("minimum_before") ? "A course holds if the median curve, and most of the runs, fall first and rise before that generation." : null,
  ].filter(Boolean);
}

export function claimsSection(data) {
  const stated = statements(data);
  if (!stated.length) return null;
  return element(
    "section",
    { id: "claims" },
    element("h2", {}, "Claims"),
    stated,
    data.claims.length
      ? [
          data.claims.some(({ early }) => early) ? element("p", { class: "note" }, `A look ahead, in generation ${data.generation ?? "–"}: not all runs are done.`) : null,
          table(columns, data.claims.flatMap((claim) => rowsOf(data, claim)), { label: "claims" }),
          csvButton("the claims", "claims", data.claims.flatMap(csvRows)),
          notesOf(data).map((note) => element("p", { class: "note" }, note)),
        ]
      : null,
  );
}
