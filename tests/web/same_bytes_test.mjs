// The module answers as this machine's own build does, in every byte.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { before, test } from "node:test";
import { allRequests } from "./requests.mjs";

const folder = resolve(process.env.PLSC_MODULE);
const { openPlsc } = createRequire(import.meta.url)(join(folder, "plsc.js"));
const open = () => openPlsc(readFileSync(join(folder, "plsc.wasm")));
let plsc;
before(async () => void (plsc = await open()));

function answersOfDoor(requests) {
  const door = spawnSync(resolve(process.env.PLSC_DOOR), { input: requests.join("\n") + "\n", maxBuffer: 2 ** 30 });
  assert.equal(door.status, 0, String(door.stderr));
  return door.stdout.toString().split("\n").slice(0, -1);
}

function assertSame(found, wanted, what) {
  if (found === wanted) return;
  let at = 0;
  while (found[at] === wanted[at]) ++at;
  const around = (text) => text.slice(Math.max(0, at - 60), at + 60);
  assert.fail(`${what}: at ${at} the module answers\n${around(found)}\nand plsc\n${around(wanted)}`);
}

test("both answer alike", () => {
  const { asks } = plsc.ask({ ask: "about" });
  const requests = allRequests(asks);
  const wanted = answersOfDoor(requests.map(({ request }) => request));
  assert.equal(wanted.length, requests.length);
  const fine = {};
  for (const [i, { what, request }] of requests.entries()) {
    assertSame(plsc.answer(request), wanted[i], what);
    const ask = JSON.parse(request).ask;
    fine[ask] ??= 0;
    if (JSON.parse(wanted[i]).ok) ++fine[ask];
  }
  // That they agree in refusing everything would say little.
  for (const ask of asks) if (ask !== "about") assert.ok(fine[ask] > 3, `only ${fine[ask]} answers to '${ask}'`);
  console.log(Object.entries(fine).map(([ask, count]) => `${count} ${ask}`).join(", "));
});

test("what a page cannot do is said", () => {
  assert.deepEqual(plsc.ask({ ask: "about" }).engines, ["articulated"]);
  const text = readFileSync(new URL("../../examples/gecko.pls", import.meta.url), "utf8");
  assert.match(plsc.ask({ ask: "live", engine: "ode", text }).error, /live in ODE, which a page has not/);
});

test("requests that are no JSON are answered", () => {
  const requests = ["", "{", "[1]", '"\\ud800"', '{"ask": 3}', '{"ask": "check", "text": "\\u0000"}', '{"ask":"x"}'];
  const wanted = answersOfDoor(requests);
  for (const [i, request] of requests.entries()) assertSame(plsc.answer(request), wanted[i], request);
});

test("memory stays where it is", () => {
  const text = readFileSync(new URL("../../examples/gecko.pls", import.meta.url), "utf8");
  const change = (i) => {
    const changed = text.replace("A2(0.4", `A2(0.${i % 9}${i % 7}1`);
    assert.notEqual(changed, text);
    assert.ok(plsc.ask({ ask: "check", text: changed }).ok);
    assert.ok(plsc.ask({ ask: "develop", text: changed }).ok);
  };
  for (let i = 0; i < 100; ++i) change(i);
  const bytes = plsc.bytes();
  for (let i = 0; i < 1000; ++i) change(i);
  assert.equal(plsc.bytes(), bytes);
});
