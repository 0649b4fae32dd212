// The page of `plsc live` and plsc.html: a genotype, and beside it the robot
// that it becomes and how that walks.
import "./main.css";
import { readData } from "../common/data.js";
import { element } from "../common/dom.js";
import { Changes } from "./changes.js";
import { openDoor } from "./door.js";
import { downloadMenu, menu } from "./downloads.js";
import { Editor } from "./editor.js";
import { Follow } from "./follow.js";
import { Lab } from "./lab.js";
import { LifeView } from "./lives.js";
import { Parameters } from "./parameters.js";
import { linkOf, robotOfLink } from "./share.js";
import { Versions } from "./versions.js";
import { Workings } from "./workings.js";

const typing = 80; // ms of rest after which a text is made into a robot

const data = readData();
const door = openDoor(data);
const robot = { name: data.name ?? "robot.pls", scenario: data.scenario ?? "" };
let last = null; // what lived last: {text, scenario, page, seasons, view}
let isSliding = false;

const status = element("p", { class: "status", role: "status" });
const wrong = element("p", { class: "wrong", role: "alert", hidden: true });
const title = element("h1", {}, robot.name);
function say(text, isWrong = false) {
  status.textContent = text;
  status.classList.toggle("bad", isWrong);
}
function complain(text) {
  wrong.hidden = !text;
  if (text && wrong.textContent !== text) wrong.textContent = text;
  right.classList.toggle("stale", Boolean(text));
}

const lives = new LifeView();
const changes = new Changes();
const workings = new Workings((ranges, hasMoved) => {
  editor?.light(ranges);
  const first = ranges.find((range) => range.name === "lit");
  if (first && hasMoved) editor.scrollTo(first.from);
});
const versions = new Versions((version) => {
  setScenario(version.scenario);
  editor.setText(version.text);
});

const lab = new Lab(door, {
  onBusy: (isBusy) => document.body.toggleAttribute("aria-busy", isBusy),
  onWrong: ({ error }) => complain(error),
  onRobot(page) {
    complain("");
    workings.show(page);
    pending = page;
  },
  onLife({ seasons, view }, { text, scenario }, milliseconds) {
    const now = { text, scenario, page: pending, seasons: speedsOf(view), view };
    last = now;
    const before = versions.before(now);
    lives.show(view.lives[0], before && new Map(before.seasons.map((season) => [season.name, season.speed])));
    versions.offer(now);
    compare(before, now);
    if (!follow) say(`lived in ${Math.round(milliseconds)} ms`);
  },
});
let pending = null;
const speedsOf = (view) => view.lives[0].recording.seasons.map(({ name, speed }) => ({ name, speed }));

async function compare(before, now) {
  if (!before || before.text === now.text) return changes.show(null);
  const answer = await door.ask({ ask: "compare", before: before.text, text: now.text, name: robot.name });
  if (last === now) changes.show(answer.ok ? answer.difference : null, before.number);
}

let timer;
function make(delay) {
  clearTimeout(timer);
  const run = () => lab.make({ text: editor.text, name: robot.name, scenario: robot.scenario });
  if (delay) timer = setTimeout(run, delay);
  else run();
}

let editor = null;
let parameters = null;
let follow = null;
editor = new Editor(door, data.robot, {
  onChange() {
    make(parameters?.isSliding ? 0 : typing);
    follow?.touch();
  },
  onCursor() {
    parameters?.look();
    workings.pointAt(editor.text, editor.view.state.selection.main.head);
  },
  onDiagnostics() {},
});
parameters = new Parameters(door, editor);

function setScenario(scenario) {
  robot.scenario = scenario;
}

function open({ name, text, scenario = "" }) {
  robot.name = name;
  title.textContent = name;
  document.title = name;
  setScenario(scenario);
  versions.forget();
  lives.clock.go(0);
  editor.open(text);
}

const gallery = menu("Gallery", (data.gallery ?? []).map((one) => [one.name.replace(/\.pls$/, ""), () => open(one), one.note]));

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
    return Boolean(linked);
  } catch (error) {
    say(error.message, true);
    return false;
  }
}
addEventListener("hashchange", openLink);

const left = element("div", { class: "left" }, element("div", { class: "editor" }, editor.object), parameters.object);
const right = element("div", { class: "right" }, wrong, lives.object, changes.object, workings.object);
document.body.append(
  element(
    "header",
    {},
    title,
    element(
      "div",
      { class: "actions" },
      gallery,
      element("button", { type: "button", onclick: () => editor.format(), title: "Shift-Alt-F" }, "Format"),
      element("button", { type: "button", onclick: share }, "Link"),
      downloadMenu(door, () => ({ ...robot, text: editor.text, view: last?.view }), say),
    ),
    status,
  ),
  element("main", {}, left, right),
  versions.object,
);
if (data.server?.file) {
  follow = new Follow(door, editor, data.server.file, { say, setText: (text) => editor.setText(text) });
  document.body.append(follow.object);
}
openLink().then((isLinked) => isLinked || make(0));
