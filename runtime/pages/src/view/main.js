// The page of `plsc view`: recorded lives side by side on one clock.
import "./main.css";
import { readData } from "../common/data.js";
import { element } from "../common/dom.js";
import { Clock } from "./clock.js";
import { moduleColours, moduleNames, touchColour } from "./colours.js";
import { cameraControls, clockControls } from "./controls.js";
import { readLife } from "./life.js";
import { Panel } from "./panel.js";
import { Plots } from "./plots.js";
import { Stage, contextOf } from "./stage.js";
import { seasonTable } from "./table.js";
import { makeTimeline } from "./timeline.js";

// s shown by plots at first: some ten swings of a joint.
const firstSpan = 10;

const lives = readData().lives.map(readLife);
const clock = new Clock(Math.max(...lives.map((life) => life.end)));
const panels = lives.map((life) => new Panel(life));
const plots = lives.map((life) => new Plots(life, firstSpan));

// To where any life has its next season, or had the one before.
function jumpSeason(direction) {
  const starts = [...new Set(lives.flatMap((life) => life.seasons.map((season) => season.start)))].sort((a, b) => a - b);
  // A season's first second counts as its start, so that one can go on back.
  const before = starts.filter((start) => start < clock.time - (clock.isPlaying ? 1 : 1e-6));
  const after = starts.filter((start) => start > clock.time + 1e-6);
  clock.go(direction < 0 ? before.at(-1) ?? 0 : after[0] ?? clock.end);
}

function legend() {
  const item = (colour, text) => element("li", {}, element("span", { class: "swatch", style: `background:${colour}` }), text);
  return element(
    "ul",
    { class: "legend", "aria-label": "Colours" },
    Object.entries(moduleNames).map(([type, name]) => item(moduleColours[type], name)),
    item(touchColour, "sensor that touches"),
    element("li", { class: "quiet" }, "squares of 10 cm; the arrow on the core points ahead, arrows on the ground uphill"),
  );
}

function spanControl() {
  const spans = [2, 5, 10, 20];
  const select = element(
    "select",
    { onchange: () => plots.forEach((one) => one.setSpan(Number(select.value))) },
    spans.map((span) => element("option", { value: span, selected: span === firstSpan }, `${span} s`)),
    element("option", { value: "Infinity" }, "the season"),
  );
  return element("label", {}, "Plots show ", select);
}

const canvas = element("canvas", { class: "picture", "aria-label": "The robots in 3-D", role: "img" });
const stageBox = element("div", { class: "stage", style: `--lives:${lives.length}` }, canvas, panels.map((panel) => panel.object));
const tools = element("div", { class: "tools" }, clockControls(clock, jumpSeason));
document.body.append(
  element(
    "main",
    {},
    element("h1", {}, document.title),
    stageBox,
    makeTimeline(lives, clock),
    tools,
    legend(),
    element("section", { class: "plotting" }, element("h2", {}, "Joints and touch"), spanControl(), element("div", { class: "columns", style: `--lives:${lives.length}` }, plots.map((one) => one.object))),
    element("section", {}, element("h2", {}, "Seasons"), lives.map((life) => seasonTable(life, clock))),
  ),
);

const context = contextOf(canvas);
const stage = context ? new Stage(canvas, context, lives, panels.map((panel) => panel.surface)) : null;
if (stage) {
  tools.append(cameraControls(stage, savePicture));
} else {
  stageBox.classList.add("blind");
  stageBox.append(
    element("p", { class: "missing", role: "alert" }, "This browser has no WebGL 2, so that the robots cannot be shown. The plots and tables below do not need it."),
  );
}

async function savePicture() {
  const url = URL.createObjectURL(await stage.picture());
  element("a", { href: url, download: `${lives[0].name}.png` }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

clock.onChange(() => {
  panels.forEach((panel, i) => {
    const { season, age } = panel.show(clock.time);
    stage?.pose(i, season, age);
    plots[i].show(season, age);
  });
});

// "#t=52" opens the page at that time, standing; "#t=52&play" playing.
const wanted = new URLSearchParams(location.hash.slice(1));
clock.go(Number(wanted.get("t")) || 0);
const isCalm = matchMedia("(prefers-reduced-motion: reduce)").matches;
clock.play(wanted.has("t") ? wanted.has("play") : !isCalm);

// Frames are stamped with their beginning, which may be before this script
// ran: the first one only says when the next one's time begins.
let last = null;
function tick(now) {
  last ??= now;
  clock.pass((now - last) / 1000);
  if (stage?.draw(now) && clock.isPlaying) stage.judge(now - last);
  last = now;
  requestAnimationFrame(tick);
}
requestAnimationFrame(tick);
