// What the benchmarks of pages share: where things are, npm's packages, numbers.
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { cpus, loadavg, tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
export const source = resolve(here, "../../..");
// Where builds are made unless the environment says otherwise.
export const program = resolve(process.env.PLSC ?? join(source, "build/release/runtime/cli/plsc"));
export const moduleFolder = resolve(process.env.PLSC_MODULE ?? join(source, "build/web/runtime/web"));

// --smoke only tries that it runs; its figures mean nothing.
export const isSmoke = process.argv.includes("--smoke");

export const scratch = mkdtempSync(join(tmpdir(), "plsc-bench-"));
process.on("exit", () => rmSync(scratch, { recursive: true, force: true }));

export const plsc = (...words) => execFileSync(program, words, { cwd: scratch, encoding: "utf8" });
export const example = (name) => readFileSync(join(source, "examples", `${name}.pls`), "utf8");

// A function that requires what package-lock.json pins, fetched once into the
// build's folder.
export function packages() {
  const folder = join(source, "build/bench_npm");
  const lock = join(here, "package-lock.json");
  const copy = join(folder, "package-lock.json");
  const isFetched = existsSync(join(folder, "node_modules")) && readFileSync(copy, "utf8") === readFileSync(lock, "utf8");
  if (!isFetched) {
    mkdirSync(folder, { recursive: true });
    copyFileSync(join(here, "package.json"), join(folder, "package.json"));
    rmSync(join(folder, "node_modules"), { recursive: true, force: true });
    copyFileSync(lock, copy);
    execFileSync("npm", ["ci", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"], { cwd: folder });
  }
  return createRequire(join(folder, "x.js"));
}

// The share `at` (0 to 1) of the numbers is not larger; 0.5 is the median.
export function quantile(numbers, at) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(at * sorted.length))];
}
export const summary = (numbers, digits = 0) =>
  `least ${Math.min(...numbers).toFixed(digits)}, median ${quantile(numbers, 0.5).toFixed(digits)}, ` +
  `95 % below ${quantile(numbers, 0.95).toFixed(digits)}, most ${Math.max(...numbers).toFixed(digits)}`;

export const machine = () => `${cpus().length} x ${cpus()[0].model}, Node ${process.version}, load ${loadavg()[0].toFixed(1)}`;
