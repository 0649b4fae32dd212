// The page of `plsc report`, of a tiny real study whose names are hostile.
import assert from "node:assert/strict";
import { copyFileSync, cpSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";
import { assertFitsWidth, desktop, downloaded, handedOut, keepFiles, phone, plsc, scratch, screenshot, source, withPage } from "./browser.mjs";

const hostile = `</script><img src=x onerror="alert('study')"><!-- ` + "`${alert(1)}`";
const study = `plsc_study: 1
name: ${JSON.stringify(hostile)}
seed: 7
repetitions: 3
base:
  population: 6
  offspring: 6
  generations: 4
  scenario:
    seasons:
      - {name: flat, terrain: flat, duration: 1 s}
      - {name: tilted, terrain: {tilted: 5 deg}, duration: 1 s}
experiments:
  plastic: {encoding: plasticoding}
  baseline: {encoding: baseline}
  static:
    encoding: baseline
    scenario: {seasons: [{name: plain, terrain: flat, duration: 1 s}]}
`;
const claims = `claims:
  ${JSON.stringify(hostile)}: {measure: speed, season: flat, greater: [plastic, baseline], source: ${JSON.stringify(hostile)}}
  as many limbs: {measure: limbs, season: tilted, equal: [plastic, baseline]}
  the slope is slow: {measure: speed, experiment: plastic, less: [tilted, flat]}
  as published: {measure: speed, experiment: static, season: plain, value: 3.63 cm/s}
  shrinks: {measure: size, experiment: baseline, season: flat, minimum_before: 2}
`;
const folder = join(scratch, "study");
const claimedFolder = join(scratch, "claimed");
const file = join(scratch, "report.html");
const single = join(scratch, "single.html");
const still = join(scratch, "still.html");
const waiting = join(scratch, "waiting.html");
const partly = join(scratch, "partly.html");
const checked = join(scratch, "checked.html");
const claimed = join(scratch, "claimed.html");
const changed = join(scratch, "changed.html");
const relived = join(scratch, "relived.html");
const iterative = join(scratch, "iterative.html");
const older = join(scratch, "older.html");
const solvers = `name: solvers
population: 4
offspring: 2
generations: 2
scenario:
  seasons:
    - {name: direct, terrain: flat, duration: 1 s}
    - {name: few, terrain: flat, duration: 1 s, physics: {solver: iterative, solver_iterations: 5}}
    - {name: own, terrain: flat, duration: 1 s, physics: {engine: articulated}}
`;

before(() => {
  writeFileSync(join(scratch, "claimed.yaml"), study + claims);
  plsc("study", "run", "claimed.yaml", "-o", claimedFolder, "--quiet");
  plsc("report", claimedFolder, "-o", claimed);
  const changedFolder = join(scratch, "changed");
  cpSync(claimedFolder, changedFolder, { recursive: true });
  writeFileSync(join(scratch, "changed.yaml"), study + claims.split("\n").slice(0, 2).join("\n").replace("greater", "less") + "\n");
  plsc("study", "run", "changed.yaml", "-o", changedFolder, "--quiet");
  plsc("report", changedFolder, "-o", changed);

  // The others are of a study that claims nothing.
  cpSync(claimedFolder, folder, { recursive: true });
  rmSync(join(folder, "claims.yaml"));
  plsc("report", folder, "-o", file);
  plsc("report", join(folder, "plastic/1.sqlite"), "-o", single, "--measures", "speed,hinge_count");
  plsc("report", join(folder, "static/1.sqlite"), "-o", still, "--measures", "speed,balance,size,hinge_count");

  plsc("report", folder, "-o", checked, "--measures", "size", "--check-engine", "2");

  writeFileSync(join(scratch, "solvers.yaml"), solvers);
  plsc("evolve", "solvers.yaml", "-o", "solvers.sqlite", "--quiet");
  plsc("report", "solvers.sqlite", "-o", iterative, "--measures", "servo_error_median,core_turns");

  copyFileSync(join(source, "tests/data/run_schema_2.sqlite"), join(scratch, "older.sqlite"));
  plsc("report", "older.sqlite", "-o", older, "--measures", "size,core_turns");

  // Most runs missing.
  const begun = join(scratch, "begun");
  cpSync(folder, begun, { recursive: true });
  for (const run of ["plastic/2", "plastic/3", "baseline/1", "baseline/2", "baseline/3", "static/2"]) rmSync(join(begun, `${run}.sqlite`));
  plsc("report", begun, "-o", waiting, "--measures", "size");

  // Robots of a copy have lived again, but for one run.
  const again = join(scratch, "again");
  cpSync(folder, again, { recursive: true });
  plsc("relive", again, "--lives", "2", "--swap", "1", "--quiet");
  rmSync(join(again, "baseline/3.relived.sqlite"));
  plsc("report", again, "-o", relived, "--measures", "speed,size");

  // One run missing, one damaged, one whose name is a script.
  const runs = join(scratch, "runs");
  mkdirSync(runs);
  copyFileSync(join(folder, "plastic/1.sqlite"), join(runs, "<img src=x onerror=alert(2)>.sqlite"));
  copyFileSync(join(folder, "baseline/1.sqlite"), join(runs, "=1+1.sqlite"));
  writeFileSync(join(runs, "broken.sqlite"), readFileSync(join(folder, "plastic/2.sqlite")).subarray(0, 9000));
  assert.throws(() => plsc("report", runs, "-o", partly), /broken\.sqlite/); // told, and the others shown
});

const diversity = ["Different genotypes", "Different robots", "Robots of generation 0 with descendants"];
const plasticity = ["Robots whose body differs between seasons", "Robots whose brain alone differs between seasons", "Rules that have a clause", "Rules that are active in no season"];

// Marks of each chart, by its title.
const chartsOf = (page) =>
  page.$$eval("figure.chart", (figures) =>
    figures.map((figure) => ({
      title: figure.querySelector("svg").getAttribute("aria-label"),
      kind: figure.classList[1],
      lines: figure.querySelectorAll('g[aria-label="line"] path').length,
      bands: figure.querySelectorAll('g[aria-label="area"] path').length,
      bars: figure.querySelectorAll('g[aria-label="bar"] rect').length,
      boxes: figure.querySelectorAll('g[aria-label="rect"] rect').length,
      dots: figure.querySelectorAll('g[aria-label="dot"] circle').length,
      means: figure.querySelectorAll('g[aria-label="dot"] path').length,
      references: figure.querySelectorAll('g[aria-label="rule"][stroke-dasharray] line').length,
      legend: [...figure.querySelectorAll(".legend text")].map((text) => text.textContent),
      isFinite: !/NaN|Infinity|undefined/.test(figure.querySelector("svg").outerHTML),
    })),
  );

for (const [name, size] of [
  ["desktop", desktop],
  ["phone", phone],
])
  test(`every chart has its marks (${name})`, () =>
    withPage(file, size, async (page) => {
      await assertFitsWidth(page);
      const charts = await chartsOf(page);
      const kinds = (kind) => charts.filter((chart) => chart.kind === kind);
      // Six measures in two seasons, of means and of the best robots; three of
      // diversity and four of plasticity.
      assert.equal(kinds("curves").length, 2 * 6 * 2 + 3 + 4);
      assert.equal(kinds("boxes").length, 2 * 6 * 2);
      assert.equal(kinds("bars").length, 2);
      for (const chart of charts) assert.ok(chart.isFinite, `${chart.title} has what is no number`);
      for (const { title, lines, bands, legend } of kinds("curves")) {
        const hasStatic = title.includes("flat") || diversity.includes(title);
        assert.equal(bands, 2, title);
        assert.equal(lines, hasStatic ? 3 : 2, title); // the static one has no band
        assert.deepEqual(legend, hasStatic ? ["plastic", "baseline", "static"] : ["plastic", "baseline"]);
      }
      for (const { title, boxes, dots, means, references, lines } of kinds("boxes")) {
        assert.equal(boxes, 2, title);
        assert.equal(dots, 6, title); // a run each
        assert.equal(means, 2, title);
        assert.equal(references, title.includes("flat") ? 1 : 0, title);
        const isTested = !title.includes("best robots");
        assert.equal(lines, isTested ? 1 : 0, `${title}: a bracket`);
      }
      for (const { title, bars } of kinds("bars")) assert.ok(bars >= 5, title);
      await screenshot(page, `report-${name}`);
      if (size === desktop) await screenshot(page, "report-whole", { fullPage: true });
    }));

test("claims come first, with the numbers of the JSON", () =>
  withPage(claimed, desktop, async (page) => {
    const data = JSON.parse(plsc("report", claimedFolder, "--format", "json"));
    assert.equal(await page.locator("main > section").first().getAttribute("id"), "claims");
    const rows = await page.$$eval("#claims tbody tr", (lines) => lines.map((line) => [...line.cells].map((cell) => cell.textContent)));
    assert.equal(data.claims.length, 5);
    assert.equal(rows.length, 5); // none of these lived again
    const verdicts = rows.map(([verdict]) => verdict.slice(2));
    assert.deepEqual(verdicts, data.claims.map(({ verdict }) => verdict));
    assert.ok(rows[0][1].startsWith(hostile), rows[0][1]);
    assert.match(rows[0][8], / of 2$/); // corrected together
    assert.ok(rows.flat().every((cell) => !/NaN|undefined|null/.test(cell)));
    assert.match(await page.textContent("#claims"), /5 claims, stated 20\S+Z before the first run; hash [0-9a-f]{32}/);
    const { text } = await downloaded(page, page.getByRole("button", { name: "CSV of the claims" }));
    assert.equal(text.trim().split("\r\n").length, 1 + 5);
    // Their measures are shown, too.
    assert.ok(data.measures.some(({ id }) => id === "limbs"));
  }));

test("claims that were changed, and a record that was, are told", () =>
  withPage(changed, desktop, async (page) => {
    const text = await page.textContent("#claims");
    assert.match(text, /Changed to 1 claim, at 20\S+Z after \d+ of 9 runs had begun/);
    assert.match(text, /withdrawn 20/);
    await screenshot(page, "report-claims");
  }));

test("claims fit a phone", () =>
  withPage(claimed, phone, async (page) => {
    await assertFitsWidth(page);
    await screenshot(page, "report-claims-phone");
  }));

test("a study that claims nothing has no such section", () =>
  withPage(file, desktop, async (page) => assert.equal(await page.locator("#claims").count(), 0)));

test("names are shown as what they are", () =>
  withPage(file, desktop, async (page) => {
    assert.equal(await page.textContent("h1"), hostile);
    assert.equal(await page.title(), hostile);
    assert.equal(await page.locator("img[onerror]").count(), 0);
  }));

test("names of experiments are text in charts and in their files, too", () =>
  withPage(partly, desktop, async (page) => {
    // Loose runs are called after their study.
    assert.equal(await page.textContent("header dt"), `${hostile} plastic`.replaceAll(/\s+/g, " "));
    assert.equal(await page.locator("img[onerror]").count(), 0);
    const legend = await page.locator(".legend text").first().textContent();
    assert.ok(legend.startsWith("</script><img"), legend);
    const { text } = await downloaded(page, page.locator("figure.chart button").first());
    const images = await page.evaluate((svg) => {
      const document = new DOMParser().parseFromString(svg, "image/svg+xml");
      return document.querySelector("parsererror, img, script") === null;
    }, text);
    assert.ok(images);
  }));

test("the gallery shows each run's best robot in every season", () =>
  withPage(file, desktop, async (page) => {
    assert.equal(await page.locator("article.robot").count(), 9);
    const sizes = await page.$$eval(".bodies img", (images) => images.map((image) => [image.complete, image.naturalWidth]));
    assert.equal(sizes.length, 3 * 2 + 3 * 2 + 3);
    for (const [isComplete, width] of sizes) assert.ok(isComplete && width > 0);
    const first = page.locator("article.robot").first();
    await first.locator("summary").click();
    assert.ok((await first.locator("tbody tr").count()) >= 5);
    assert.match(await first.locator("tbody").textContent(), /inclined = /);
  }));

test("each button gives its file", () =>
  withPage(file, desktop, async (page) => {
    const buttons = page.locator("figure.chart button");
    const count = await buttons.count();
    assert.equal(count, 2 * (2 * 6 * 2 + 3 + 4 + 2 * 6 * 2 + 2));
    const names = new Set();
    for (let i = 0; i < count; ++i) {
      const button = buttons.nth(i);
      const { name, text } = await handedOut(page, button);
      assert.ok(!names.has(name), `${name} twice`);
      names.add(name);
      if ((await button.textContent()) === "SVG") {
        assert.match(name, /^[a-z0-9-]+\.svg$/);
        const marks = await page.evaluate((svg) => {
          const document = new DOMParser().parseFromString(svg, "image/svg+xml");
          if (document.querySelector("parsererror")) return -1;
          return document.querySelectorAll("path, rect, line, circle").length;
        }, text);
        assert.ok(marks > 5, `${name} has ${marks} marks`);
      } else {
        assert.match(name, /^[a-z0-9-]+\.csv$/);
        const lines = text.split("\r\n");
        assert.match(lines[0], /^[a-z0-9_]+(,[a-z0-9_]+)+$/);
        assert.ok(lines.length > 3, name);
        assert.equal(lines.at(-1), "");
      }
    }
  }, { prepare: keepFiles }));

test("tables can be had as CSV, their numbers those of the JSON", () =>
  withPage(file, desktop, async (page) => {
    const data = JSON.parse(plsc("report", folder, "--format", "json"));
    const csvOf = async (what) => (await downloaded(page, page.getByRole("button", { name: `CSV of ${what}` }))).text.trim().split("\r\n");
    const tests = await csvOf("the tests");
    assert.equal(tests.length, 1 + data.tests.length);
    assert.equal(data.tests.length, 6 * 2);
    assert.equal((await csvOf("the runs")).length, 1 + 9);
    assert.equal((await csvOf("the best robots")).length, 1 + 15);
    const speeds = await csvOf("Speed of generation 3, flat");
    const values = data.finals.filter(({ measure, season, of }) => measure === data.measures[0].id && season === "flat" && of === "mean").flatMap(({ values }) => values);
    assert.deepEqual(speeds.slice(1).map((line) => Number(line.split(",").at(-1))), values.map(({ value }) => value));
    // With three runs each there is no p below a tenth, and the page says so.
    assert.ok(data.tests.every(({ p }) => p === null || p >= 0.1));
    assert.match(await page.textContent("#tests"), /cannot be below 0\.1/);
    assert.match(await page.textContent("#tests"), /12 tests, not corrected/);
  }));

test("it says in what the experiments differ", () =>
  withPage(file, desktop, async (page) => {
    const rows = await page.$$eval("#differences tbody tr", (lines) => lines.map((line) => [...line.cells].map((cell) => cell.textContent)));
    const of = (key) => rows.find(([name]) => name === key)?.slice(1);
    assert.deepEqual(of("encoding"), ["plasticoding", "plasticoding", "baseline", "baseline"]);
    assert.deepEqual(of("population"), ["100", "6", "6", "6"]);
    assert.deepEqual(of("scenario.seasons.tilted.duration"), ["50 s", "1 s", "1 s", "–"]);
    assert.equal(of("mutation"), undefined);
    assert.equal(rows[0][0], "encoding"); // what differs between them comes first
  }));

test("diversity and plasticity are those of the JSON", () =>
  withPage(file, desktop, async (page) => {
    const data = JSON.parse(plsc("report", folder, "--format", "json"));
    const medians = async (title, name) => {
      const { text } = await downloaded(page, page.getByRole("button", { name: `CSV of ${title}` }));
      const rows = text.trim().split("\r\n").map((line) => line.split(","));
      const column = rows[0].indexOf("median");
      return rows.slice(1).filter((row) => row.includes(name)).map((row) => Number(row[column]));
    };
    for (const [titles, list, keys] of [
      [diversity, data.diversity, ["genotypes", "phenotypes", "founders"]],
      [plasticity, data.plasticity, ["body", "brain_only", "regulated", "silent"]],
    ])
      for (const [i, title] of titles.entries()) {
        const of = list.find(({ experiment }) => experiment === "plastic");
        assert.deepEqual(await medians(title, "plastic"), of[keys[i]].median, title);
      }
    assert.equal(data.diversity.length, 3);
    assert.equal(data.plasticity.length, 2);
  }));

test("it says how well the solvers did", () =>
  withPage(iterative, desktop, async (page) => {
    await assertFitsWidth(page);
    const rows = await page.$$eval('[aria-label="errors of servos"] tbody tr', (lines) => lines.map((line) => [...line.cells].map((cell) => cell.textContent)));
    assert.deepEqual(rows.map((row) => row.slice(0, 3)), [
      ["solvers", "direct", "ODE, direct"],
      ["solvers", "few", "ODE, iterative, 5 iterations"],
      ["solvers", "own", "the articulated engine"],
    ]);
    const [direct, few, own] = rows.map((row) => Number(row[3].replace("−", "-")));
    assert.ok(direct < 1e-3 && own === 0 && few > 10 * direct && few > 1e-3, `${direct} ${few} ${own}`);
    const lines = await page.$$eval("#iterative li", (items) => items.map((item) => item.textContent));
    assert.equal(lines.length, 1);
    assert.match(lines[0], /^solvers, few: lived by ODE's iterative solver, which leaves half of the joints' speeds \S+ rad\/s or more/);
  }));

test("what an older store lacks is told", () =>
  withPage(older, desktop, async (page) => {
    assert.match(await page.textContent("#without"), /No run has a value of Core turns\./);
    assert.match(await page.textContent("#lacks"), /These runs were made by a plsc that did not measure servo_error_median, servo_error_worst, core_turns/);
    assert.equal(await page.locator("#diversity figure").count(), 3);
    assert.match(await page.textContent('[aria-label="errors of servos"]'), /not measured/);
  }));

test("where all solvers are direct there is no warning of them", () =>
  withPage(file, desktop, async (page) => {
    assert.equal(await page.locator("#iterative").count(), 0);
    assert.equal(await page.locator('[aria-label="errors of servos"] tbody tr').count(), 5);
  }));

test("robots that lived by both engines are compared, a chart a season", () =>
  withPage(checked, desktop, async (page) => {
    await assertFitsWidth(page);
    const charts = (await chartsOf(page)).filter(({ kind }) => kind === "engines");
    assert.deepEqual(charts.map(({ title }) => title), ["flat", "tilted", "plain"].map((season) => `Speed by both engines in ${season}`));
    for (const { title, dots, lines, legend, isFinite } of charts) {
      assert.ok(dots > 0 && dots <= 12, `${title}: ${dots} robots`);
      assert.equal(lines, 1, `${title}: where both are equal`);
      assert.ok(legend.length >= 1 && isFinite, title);
    }
    await page.locator("#engines figure").first().scrollIntoViewIfNeeded();
    await screenshot(page, "report-engines");
    // Three runs of two seasons, twice, and three of one.
    assert.equal(await page.locator("#engines tbody tr").count(), 15);
    const { name, text } = await downloaded(page, page.locator('button[aria-label="CSV of the engines"]'));
    assert.equal(name, "engines.csv");
    assert.equal(text.trim().split("\r\n").length, 16);
    assert.match(text, /,ode,articulated,/);
  }));

test("a report that was not asked for it has no other engine", () =>
  withPage(file, desktop, async (page) => assert.equal(await page.locator("#engines").count(), 0)));

test("relived values come before recorded ones", () =>
  withPage(relived, desktop, async (page) => {
    await assertFitsWidth(page);
    const charts = (await chartsOf(page)).filter(({ kind }) => kind === "boxes");
    const titles = charts.map(({ title }) => title);
    // Size does not differ between lives of one robot.
    const isRelived = (title) => title.startsWith("Relived ");
    assert.deepEqual(titles.filter(isRelived), ["", " of the best robots"].flatMap((of) => ["flat", "tilted"].map((season) => `Relived Speed${of} of generation 3, ${season}`)));
    assert.ok(titles.findIndex(isRelived) < titles.findIndex((title) => title.startsWith("Speed")));
    for (const { title, boxes, dots, isFinite } of charts.filter(({ title }) => isRelived(title))) {
      assert.equal(boxes, 2, title);
      assert.equal(dots, 5, title); // a run each, of those that have them
      assert.ok(isFinite, title);
    }
    assert.match(await page.textContent("#relived"), /8 runs, 2 lives of each survivor\. Of 1 run they are missing/);
    assert.match(await page.textContent("#tests"), /relived.*recorded/s);
    assert.match(await page.textContent("#gallery"), /relived -?[0-9.]+ \(/);
    await page.locator("#relived").scrollIntoViewIfNeeded();
    await screenshot(page, "report-relived");
  }));

test("what plastic robots lose with another season's body is shown", () =>
  withPage(relived, desktop, async (page) => {
    const charts = (await chartsOf(page)).filter(({ title }) => title.startsWith("Speed lost"));
    assert.ok(charts.length >= 1 && charts.length <= 2);
    for (const { title, isFinite, dots } of charts) assert.ok(isFinite && dots >= 1 && dots <= 3, title);
    assert.match(await page.textContent("#swaps"), /plastic/);
    const { name, text } = await downloaded(page, page.locator('button[aria-label="CSV of the swap test"]'));
    assert.equal(name, "swaps.csv");
    assert.match(text, /^measure,season,experiment,run,robots,own_cm_s,swapped_cm_s,loss_cm_s\r\n/);
    await page.locator("#swaps").scrollIntoViewIfNeeded();
    await screenshot(page, "report-swaps");
  }));

test("a report without relived lives says how to make them", () =>
  withPage(file, desktop, async (page) => {
    assert.match(await page.textContent("#relived"), /have lived again: plsc relive .*study/);
    assert.equal(await page.locator("#swaps").count(), 0);
  }));

test("what is not finished is told in groups", () =>
  withPage(waiting, desktop, async (page) => {
    const warning = await page.textContent("header .warning");
    assert.match(warning, /Not finished: plastic 2, 3 \(missing\); baseline 1 to 3 \(missing\); static 2 \(missing\)\./);
  }));

test("it can be printed", () =>
  withPage(file, desktop, async (page) => {
    const pdf = await page.pdf({ format: "A4" });
    assert.equal(pdf.subarray(0, 5).toString(), "%PDF-");
    assert.ok(pdf.length > 50000);
    await page.emulateMedia({ media: "print" });
    assert.equal(await page.locator("figure.chart button").first().isVisible(), false);
  }));

test("keys reach the links and the buttons", () =>
  withPage(file, desktop, async (page) => {
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.getAttribute("href")), "#differences");
    for (const link of await page.$$eval("nav a", (links) => links.map((link) => link.getAttribute("href")))) assert.equal(await page.locator(link).count(), 1);
  }));

test("one run alone shows its population", () =>
  withPage(single, phone, async (page) => {
    await assertFitsWidth(page);
    const charts = await chartsOf(page);
    assert.equal(charts.filter(({ kind }) => kind === "curves").length, 2 * 2 + 3 + 4);
    assert.equal(charts.filter(({ kind }) => kind === "boxes").length, 0);
    assert.equal(await page.locator("#tests").count(), 0);
    assert.match(await page.textContent("#measures"), /quartiles of the population's robots/);
    for (const { kind, lines, legend, title } of charts)
      if (kind === "curves" && ![...diversity, ...plasticity].includes(title)) {
        assert.equal(lines, 2, title);
        assert.deepEqual(legend, ["plastic", "plastic, best robot"]);
      }
    await screenshot(page, "report-single-phone");
  }));

test("one run alone fills the page, with two seasons and with one", async () => {
  for (const [shown, name] of [
    [single, "report-single"],
    [still, "report-single-season"],
  ])
    await withPage(shown, desktop, async (page) => {
      await assertFitsWidth(page);
      const { charts, room } = await page.evaluate(() => ({
        charts: [...document.querySelectorAll("figure.curves")].map((figure) => figure.querySelector("svg").getBoundingClientRect().toJSON()),
        room: document.querySelector("#measures").getBoundingClientRect().toJSON(),
      }));
      const tops = new Set(charts.map(({ top }) => Math.round(top)));
      for (const row of [...tops].map((top) => charts.filter((chart) => Math.round(chart.top) === top))) {
        const right = Math.max(...row.map((chart) => chart.right));
        assert.ok(right > room.left + 0.9 * room.width, `a row of ${row.length} ends at ${right} of ${room.right}`);
      }
      await screenshot(page, name, { fullPage: true });
    });
});

test("what is damaged is told, and what is named as a script is text", () =>
  withPage(partly, desktop, async (page) => {
    const header = await page.textContent("header");
    assert.match(header, /3 runs of 2 experiments: /);
    assert.match(header, /Left out: broken\.sqlite\./);
    assert.match(await page.textContent("#provenance"), /<img src=x onerror=alert\(2\)>\.sqlite/);
    assert.equal(await page.locator("#tests").count(), 0); // a run each
    const runs = await downloaded(page, page.getByRole("button", { name: "CSV of the runs" }));
    assert.match(runs.text, /^'=1\+1\.sqlite,/m); // no formula for spreadsheets
  }));

test("pages are small", () => assert.ok(statSync(file).size < 1.5e6));
