// `plsc live` itself in the browser: joined with a file, a run, a study.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { test } from "node:test";
import { assertFitsWidth, desktop, phone, plsc, scratch, screenshot, withPage } from "./browser.mjs";
import { cursorBehind, example, lineWith, scenario } from "./live.mjs";

// use(page) with the page of `plsc live WORDS`.
async function withLive(words, use, size = desktop) {
  const child = spawn(process.env.PLSC, ["live", ...words], { cwd: scratch, stdio: ["ignore", "pipe", "inherit"] });
  try {
    const address = await new Promise((resolve) => createInterface({ input: child.stdout }).once("line", resolve));
    await withPage(address, size, use);
  } finally {
    child.kill("SIGINT");
    await new Promise((resolve) => child.once("exit", resolve));
  }
}
const status = (page, text) => page.waitForFunction((wanted) => document.querySelector(".status").textContent === wanted, text);

// The editor has the line, and the page finds no fault with the text.
async function holds(page, line) {
  await lineWith(page, line).waitFor();
  await page.waitForFunction(() => document.querySelector(".right").ariaBusy === "false" && document.querySelector(".wrong").hidden);
}

writeFileSync(join(scratch, "s.yaml"), scenario);

test("a file is joined with the page: both ways, and both are shown where both changed", async () => {
  const path = join(scratch, "a.pls");
  writeFileSync(path, example("climber"));
  await withLive(["a.pls", "--scenario", "s.yaml"], async (page) => {
    await page.locator(".version").first().waitFor();
    await screenshot(page, "live-command");
    await holds(page, "genotype climber");
    writeFileSync(`${path}.new`, example("gecko"));
    renameSync(`${path}.new`, path);
    await holds(page, "genotype gecko");
    await cursorBehind(page, "genotype gecko");
    await page.keyboard.type("s");
    await status(page, "saved");
    assert.match(readFileSync(path, "utf8"), /genotype geckos/);
    await page.keyboard.type("x");
    writeFileSync(path, example("climber"));
    await page.locator(".conflict").waitFor();
    assert.equal(readFileSync(path, "utf8"), example("climber"));
    await page.getByRole("button", { name: "Take this one" }).click();
    await holds(page, "genotype climber");
    rmSync(path);
    await page.waitForFunction(() => /gone/.test(document.querySelector(".status").textContent));
    writeFileSync(path, example("gecko"));
    await holds(page, "genotype gecko");
  });
});

const experiment = `name: tiny
population: 6
offspring: 6
generations: 4
seed: 7
profile: swift
scenario:
  profile: swift
  seasons:
    - {name: flat, terrain: flat, duration: 3 s}
    - {name: tilted, terrain: {tilted: 5 deg}, duration: 3 s}
`;

test("a run's generations are gone over, its best robots walk, and whom they come from", async () => {
  writeFileSync(join(scratch, "e.yaml"), experiment);
  plsc("evolve", "e.yaml", "-o", "r.sqlite", "--quiet");
  const best = JSON.parse(plsc("show", "r.sqlite", "best", "--format", "json")).id;
  for (const size of [desktop, phone])
    await withLive(
      ["r.sqlite"],
      async (page) => {
        await page.getByRole("heading", { name: `robot_${best}.pls` }).waitFor();
        await page.locator(".version").first().waitFor();
        assert.match(await page.locator(".run .top").textContent(), /finished, 4 of 4 generations/);
        await screenshot(page, `live-run-${size === phone ? "phone" : "desktop"}`);
        await assertFitsWidth(page);
        await page.getByLabel("Generation", { exact: true }).fill("0");
        await page.waitForFunction(() => /^Generation 0:/.test(document.querySelector(".run .curves p").textContent));
        const id = /robot (\d+)/.exec(await page.locator(".run .curves p").textContent())[1];
        await page.getByRole("heading", { name: `robot_${id}.pls` }).waitFor();
        const shown = JSON.parse(plsc("show", "r.sqlite", id, "--format", "json"));
        assert.equal(shown.generation, 0);
        await page.locator(".cm-line", { hasText: shown.genotype.split("\n")[1] }).first().waitFor();
        assert.equal(await page.locator(".lineage button").count(), 1);
      },
      size,
    );
});

test("a study's runs are chosen from", async () => {
  const keys = experiment.replace(/^name:.*\n|^seed:.*\n/gm, "").replaceAll(/^/gm, "  ");
  writeFileSync(join(scratch, "st.yaml"), `plsc_study: 1\nname: two\nseed: 1\nrepetitions: 1\nbase:\n${keys}\nexperiments:\n  plastic: {}\n  baseline: {encoding: baseline}\n`);
  plsc("study", "run", "st.yaml", "-o", "st", "--quiet");
  await withLive(["st"], async (page) => {
    await page.locator(".version").first().waitFor();
    const title = await page.locator("h1").textContent();
    await page.getByLabel("Run", { exact: true }).selectOption("baseline/1");
    await page.waitForFunction(() => document.querySelectorAll(".version").length >= 2);
    assert.match(title, /^robot_\d+\.pls$/);
    await screenshot(page, "live-study");
  });
});
