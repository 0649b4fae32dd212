// Lives in plsc's module of a page beside lives in MuJoCo's own module of npm
// (@mujoco/mujoco), in one Node, in turns: the same random robots of 2 to 20
// modules, exported by `plsc export --to mjcf`, for 50 s on flat ground and 50 s
// on a slope, at 5 ms a step, driven 8 times a second by the same oscillators.
//
//   node tests/bench/page/steps_bench.mjs [--smoke]
//
// Ours is asked for as a page does: text in, speeds out, with parsing, growing,
// sensing and brain. MuJoCo's is its mj_step and its servos' speeds, which
// cost little: oscillators were computed before, sensors are switched off. Twice:
// as exported (implicit integrator), and as quick as its settings make it
// (implicitfast, one iteration of the solver). The limit of a servo's torque stands
// at the joint, not at the actuator as MuJoCo 2 needs it: there version 3 leaves out
// the damping of a servo at its limit, and links as light as ours fly away at 5 ms.
// Of each robot the quickest of `rounds` lives counts, as other programs disturb it
// least.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { isSmoke, machine, moduleFolder, packages, plsc, scratch } from "./common.mjs";
import { Random, randomGenotype } from "./robots.mjs";

const duration = isSmoke ? 0.5 : 50; // s
const robots = isSmoke ? 1 : 4; // of each size
const rounds = isSmoke ? 1 : 5;
const sizes = isSmoke ? [2, 8] : [2, 3, 5, 8, 11, 15, 20];
const step = 0.005; // s, of profile swift
const turn = 25; // steps between two targets of the servos, 8 Hz
const grounds = { flat: "flat", slope: "{tilted: 5 deg}" };

const { openPlsc } = createRequire(import.meta.url)(join(moduleFolder, "plsc.js"));
const ours = await openPlsc(readFileSync(join(moduleFolder, "plsc.wasm")));
const { default: loadMujoco } = await import(packages().resolve("@mujoco/mujoco"));
const mujoco = await loadMujoco();

const scenario = (seconds, ground) =>
  `profile: swift\ncontroller: open_loop\nseasons: [{name: season, terrain: ${grounds[ground]}, duration: ${seconds} s}]\n`;

function live(text, seconds, ground) {
  const answer = ours.ask({ ask: "live", text, scenario: scenario(seconds, ground) });
  return answer.ok && answer.seasons[0].outcome === "completed" ? answer.seasons[0] : null;
}

// ms of processor time, so that other programs disturb little; when both modules
// are warm all of it is this thread's.
function now() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

function timed(work) {
  const begun = now();
  work();
  return now() - begun;
}

function limitedAtJoint(mjcf) {
  const limit = / forcelimited="true" forcerange="(.*?)"/;
  const [, range] = limit.exec(mjcf);
  return mjcf.replace(limit, "").replace('<joint type="hinge"', `$& actuatorfrclimited="true" actuatorfrcrange="${range}"`);
}

// What drives the robot in MuJoCo: servos as ours, from oscillators.
function brainOf(text) {
  writeFileSync(join(scratch, "robot.pls"), text);
  writeFileSync(join(scratch, "scenario.yaml"), scenario(duration, "flat"));
  const words = ["export", "robot.pls", "--scenario", "scenario.yaml", "--to"];
  const { oscillators, servo } = JSON.parse(plsc(...words, "controller-json"));
  const steps = Math.round(duration / step);
  const targets = []; // by update, then by joint: rad
  for (let at = 0; at < steps; at += turn) {
    const of = ({ amplitude, period, phase_offset: offset }) => 0.5 + (amplitude / 2) * Math.sin(2 * Math.PI * ((at * step) / period - offset));
    const angle = (output) => servo.range * (2 * Math.min(Math.max(output, servo.min_output), servo.max_output) - 1);
    targets.push(oscillators.map((one) => angle(of(one))));
  }
  const mjcf = {};
  for (const ground of Object.keys(grounds)) {
    writeFileSync(join(scratch, "scenario.yaml"), scenario(duration, ground));
    mjcf[ground] = limitedAtJoint(plsc(...words, "mjcf"));
  }
  return { targets, servo, steps, mjcf };
}

const settings = {
  exported: () => {},
  quick: ({ opt }) => {
    opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST.value;
    opt.iterations = 1;
    opt.ls_iterations = 4;
  },
};

// {life, steps}: ms of a whole life and of its steps alone. `look`, if any, is
// called a turn.
function liveInMujoco({ targets, servo, steps, mjcf }, ground, set, look) {
  const begun = now();
  const model = mujoco.MjModel.from_xml_string(mjcf[ground]);
  model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_SENSOR.value;
  settings[set](model);
  const data = new mujoco.MjData(model);
  const joints = targets[0].length;
  const stepsBegun = now();
  for (let at = 0; at < steps; ++at) {
    if (at % turn === 0) {
      const { ctrl, qpos } = data; // 7 numbers of the core, then the joints
      const wanted = targets[at / turn];
      for (let j = 0; j < joints; ++j)
        ctrl[j] = Math.min(Math.max(servo.gain * (wanted[j] - qpos[7 + j]), -servo.max_speed), servo.max_speed);
      look?.(data, ctrl, qpos);
    }
    mujoco.mj_step(model, data);
  }
  const ended = now();
  const times = { life: ended - begun, steps: ended - stepsBegun };
  data.delete();
  model.delete();
  return times;
}

// Robots that live: random ones may have parts that overlap.
function robotsOf(size) {
  const random = new Random(20200217 + size);
  const found = [];
  while (found.length < robots) {
    const text = randomGenotype(random, size);
    const season = live(text, 0.5, "flat");
    if (season) found.push({ text, ...brainOf(text) });
  }
  return found;
}

const nothing = `<mujoco><option timestep="${step}"/></mujoco>`;
function callOfStep() {
  const model = mujoco.MjModel.from_xml_string(nothing);
  const data = new mujoco.MjData(model);
  const all = () => timed(() => { for (let i = 0; i < 10000; ++i) mujoco.mj_step(model, data); });
  return Math.min(...Array.from({ length: 10 }, all)) / 10;
}

function measure(robot, ground) {
  const { text, steps } = robot;
  const short = 5 * step; // what a life costs beside its steps
  const seen = { contacts: 0, bend: 0, looks: 0 };
  liveInMujoco(robot, ground, "exported", (data, ctrl, qpos) => {
    seen.contacts += data.ncon;
    for (let j = 0; j < ctrl.length; ++j) seen.bend += Math.abs(qpos[7 + j]) / ctrl.length;
    ++seen.looks;
  });
  const least = { ours: Infinity, beside: Infinity };
  for (let round = 0; round < rounds; ++round) {
    least.ours = Math.min(least.ours, timed(() => live(text, duration, ground)));
    least.beside = Math.min(least.beside, timed(() => live(text, short, ground)));
    for (const set of Object.keys(settings)) {
      const times = liveInMujoco(robot, ground, set);
      least[set] ??= times;
      for (const what of Object.keys(times)) least[set][what] = Math.min(least[set][what], times[what]);
    }
  }
  if (!(seen.bend / seen.looks < 1)) throw new Error(`in MuJoCo this robot flies away:\n${text}`);
  const us = (milliseconds, count = steps) => (1000 * milliseconds) / count;
  return {
    joints: robot.targets[0].length,
    life: least.ours,
    step: us(least.ours - least.beside, steps - 5),
    contacts: seen.contacts / seen.looks,
    bend: seen.bend / seen.looks,
    ...Object.fromEntries(Object.keys(settings).flatMap((set) => [[`${set}Life`, least[set].life], [`${set}Step`, us(least[set].steps)]])),
  };
}

console.log(`${machine()}; MuJoCo ${mujoco.mj_versionString()}, a call of its step with nothing to do ${callOfStep().toFixed(2)} us`);
console.log(`${robots} robots of each size, ${duration} s of ${step * 1000} ms, the quickest of ${rounds}`);
console.log("modules joints ground |  ours: life  a step | MuJoCo: life  a step contacts bend |  life  step times ours | quick: life  a step |  life  step times ours");
const ratios = [];
for (const size of sizes) {
  const all = robotsOf(size);
  for (const ground of Object.keys(grounds)) {
    const rows = all.map((robot) => measure(robot, ground));
    const mean = (key) => rows.reduce((sum, row) => sum + row[key], 0) / rows.length;
    const of = (over, under) => mean(over) / mean(under);
    const cell = (number, width, digits) => number.toFixed(digits).padStart(width);
    ratios.push(of("exportedStep", "step"));
    console.log(
      [
        `${String(size).padStart(7)} ${cell(mean("joints"), 6, 1)} ${ground.padStart(6)} `,
        `${cell(mean("life"), 9, 1)} ms ${cell(mean("step"), 5, 2)} us `,
        `${cell(mean("exportedLife"), 9, 1)} ms ${cell(mean("exportedStep"), 5, 1)} us ${cell(mean("contacts"), 6, 1)} ${cell(mean("bend"), 5, 2)} `,
        `${cell(of("exportedLife", "life"), 6, 1)} ${cell(of("exportedStep", "step"), 6, 1)}            `,
        `${cell(mean("quickLife"), 8, 1)} ms ${cell(mean("quickStep"), 5, 1)} us `,
        `${cell(of("quickLife", "life"), 6, 1)} ${cell(of("quickStep", "step"), 6, 1)}`,
      ].join("|"),
    );
  }
}
console.log(`a step of MuJoCo, as exported, takes ${Math.min(...ratios).toFixed(1)} to ${Math.max(...ratios).toFixed(1)} times as long as ours`);
