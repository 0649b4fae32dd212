// The page of `plsc live` and plsc.html: a genotype, and beside it the robot
// that it becomes and how that walks.
import "./main.css";
import { readData } from "../common/data.js";
import { element } from "../common/dom.js";
import { Changes } from "./changes.js";
import { Choices } from "./choices.js";
import { PageCopy } from "./copy.js";
import { openDoor } from "./door.js";
import { downloadMenu } from "./downloads.js";
import { Editor } from "./editor.js";
import { Follow } from "./follow.js";
import { Lab } from "./lab.js";
import { LifeView } from "./lives.js";
import { menu, panel } from "./menu.js";
import { Parameters } from "./parameters.js";
import { ScenarioPanel, usual } from "./scenario.js";
import { RunPanel } from "./run.js";
import { linkOf, robotOfLink } from "./share.js";
import { Versions } from "./versions.js";
import { Workings } from "./workings.js";

const typing = 80; // ms of rest after which a text is made into a robot

const data = readData();
const copy = new PageCopy(data);
const door = openDoor(data);
const robot = { name: data.name ?? "robot.pls", scenario: data.scenario || usual, genotype: "" };
let last = null; // what lived last: {input, text, scenario, page, seasons, view}
let editor = null;
let parameters = null;
let follow = null;

const title = element("h1", {}, robot.name);
const status = element("p", { class: "status", role: "status" });
const wrong = element("p", { class: "wrong", role: "alert", hidden: true });

// What must not be overlooked, until it is put away.
const notice = element("p", { class: "notice", role: "alert", hidden: true });
function warn(text) {
  notice.hidden = false;
  notice.replaceChildren(text, " ", element("button", { type: "button", onclick: () => (notice.hidden = true) }, "All right"));
}

function say(text, isWrong = false) {
  status.textContent = text;
  status.classList.toggle("bad", isWrong);
}

// The last good robot stays in view, greyed, while there is a fault.
function complain(text) {
  wrong.hidden = !text;
  if (wrong.textContent !== text) wrong.textContent = text;
  right.classList.toggle("stale", text !== "");
}

// Where the first error is, and what.
function wordsOf({ error, diagnostics = [] }) {
  const first = diagnostics.find((one) => one.severity === "error");
  if (!first) return error;
  const place = first.file === robot.name ? "Line" : "Scenario, line";
  return `${place} ${first.line}: ${first.message}`;
}

const lives = new LifeView();
const changes = new Changes();
const workings = new Workings((ranges, hasMoved) => {
  if (!editor) return;
  editor.light(editor.text === workings.robot.text ? ranges : []);
  const first = ranges.find((range) => range.name === "lit");
  if (first && hasMoved) editor.scrollTo(first.from);
});
const versions = new Versions((version) => {
  setScenario(version.scenario);
  editor.setText(version.text);
  make(0);
});
const scenario = new ScenarioPanel(door, (yaml) => {
  robot.scenario = yaml;
  make(0);
});
const choices = new Choices({
  onGenotype(genotype) {
    robot.genotype = genotype;
    make(0);
  },
  onEnvironment: (environment) => editor.client.choose(environment),
});

const lab = new Lab(door, {
  onBusy: (isBusy) => right.setAttribute("aria-busy", String(isBusy)),
  onWrong: (answer) => complain(wordsOf(answer)),
  onRobot: (page) => workings.show(page),
  onLife(life, page, input, milliseconds) {
    complain("");
    const { recording } = life.view.lives[0];
    const seasons = recording.seasons.map(({ name, speed }) => ({ name, speed }));
    last = { ...input, page, seasons, view: life.view };
    const before = versions.before(last);
    lives.show(life.view.lives[0], before && new Map(before.seasons.map((season) => [season.name, season.speed])));
    versions.offer(last);
    compare(before, last);
    if (!follow) say(`lived ${Math.round(lives.clock.end)} s a season in ${Math.round(milliseconds)} ms`);
    choices.look(door, input).then((states) => states && scenario.setStates(states));
  },
});

async function compare(before, now) {
  if (!before || before.text === now.text) return changes.show(null);
  const answer = await door.ask({ ask: "compare", before: before.text, text: now.text, name: robot.name });
  if (last === now) changes.show(answer.ok ? answer.difference : null, before.number);
}

let timer;
function make(delay) {
  clearTimeout(timer);
  const run = () => lab.make({ text: editor.text, ...robot });
  if (delay) timer = setTimeout(run, delay);
  else run();
}

function setScenario(yaml) {
  robot.scenario = yaml;
  scenario.set(yaml);
}

function open({ name, text, scenario: yaml }) {
  Object.assign(robot, { name, genotype: "" });
  title.textContent = name;
  document.title = name;
  if (yaml) setScenario(yaml);
  versions.forget();
  lives.clock.go(0);
  editor.open(text);
}

async function share() {
  const link = await linkOf({ ...robot, text: editor.text });
  history.replaceState(null, "", link);
  try {
    await navigator.clipboard.writeText(location.href);
    say("The link is in the clipboard.");
  } catch {
    say("The link is in the address bar.");
  }
}

async function openLink() {
  try {
    const linked = await robotOfLink(location.hash);
    if (linked) open(linked);
    notice.hidden = true;
    return linked !== null;
  } catch (error) {
    warn(`${error.message} This page shows a robot of its own instead.`);
    return false;
  }
}

editor = new Editor(door, data.robot, {
  onChange() {
    make(parameters?.isSliding ? 0 : typing);
    follow?.touch();
  },
  onCursor() {
    parameters?.look();
    workings.pointAt(editor.text, editor.view.state.selection.main.head);
  },
});
parameters = new Parameters(door, editor);
const right = element("div", { class: "right" }, element("div", { class: "over" }, wrong), lives.object, changes.object, workings.object);
document.body.append(
  element(
    "header",
    {},
    title,
    choices.object,
    element(
      "div",
      { class: "actions" },
      data.gallery?.length > 0 ? menu("Gallery", data.gallery.map((one) => [one.name.replace(/\.pls$/, ""), () => open(one), one.note])) : null,
      panel("Scenario", scenario.object),
      element("button", { type: "button", onclick: () => editor.format(), title: "Shift-Alt-F" }, "Format"),
      element("button", { type: "button", onclick: share, title: "A link that holds this robot" }, "Link"),
      downloadMenu(door, data.module ? copy : null, () => ({ ...robot, text: editor.text, view: last?.view }), warn),
    ),
    status,
    notice,
  ),
  element("main", {}, element("div", { class: "left" }, element("div", { class: "editor" }, editor.object), parameters.object), right),
  versions.object,
);
if (data.server?.file !== undefined) {
  const setText = (text) => {
    editor.setText(text);
    make(0); // who saved is done typing
  };
  follow = new Follow(door, editor, data.server.file, { say, setText });
  document.body.append(follow.object);
}
// A robot of a run takes the place of the one before, which is what it is
// compared with.
function change({ name, text, scenario: yaml }) {
  Object.assign(robot, { name, genotype: "" });
  title.textContent = name;
  document.title = name;
  if (yaml !== robot.scenario) setScenario(yaml);
  editor.setText(text);
}
const isOfRuns = data.follow === "run" || data.follow === "study";
if (isOfRuns) right.prepend(new RunPanel(data.follow, { show: change, say }).object);
addEventListener("hashchange", openLink);
scenario.set(robot.scenario);
openLink().then((isLinked) => isLinked || isOfRuns || make(0));
