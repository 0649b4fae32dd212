// The lives in 3-D: every season beside the others on one clock, or, where
// there are many, one after the other.
import { element } from "../common/dom.js";
import { Clock } from "../view/clock.js";
import { cameraControls, clockControls } from "../view/controls.js";
import { readLife } from "../view/life.js";
import { Stage, contextOf } from "../view/stage.js";
import { panel } from "./menu.js";
import { Pane } from "./pane.js";

const mostBeside = 3; // seasons

// A life a pane.
function lifesOf({ recording, grounds, ...rest }) {
  const { seasons } = recording;
  if (seasons.length > mostBeside) return [readLife({ recording, grounds, ...rest })];
  return seasons.map((season, i) => readLife({ ...rest, recording: { ...recording, seasons: [season] }, grounds: [grounds[i]] }));
}

export class LifeView {
  constructor() {
    this.clock = new Clock(0);
    this.clock.isLooping = true;
    this.lives = [];
    this.panes = [];
    this.canvas = element("canvas", { class: "picture", "aria-label": "The robot in 3-D", role: "img" });
    this.box = element("div", { class: "stage empty" }, this.canvas);
    this.bar = element("input", { type: "range", min: 0, step: 0.02, value: 0, "aria-label": "Time, seconds", oninput: () => this.clock.go(Number(this.bar.value)) });
    this.tools = element("div", { class: "tools" }, clockControls(this.clock, (direction) => this.#jump(direction)));
    this.object = element("section", { class: "lives", "aria-label": "Lives" }, this.box, this.bar, this.tools);
    this.context = contextOf(this.canvas);
    if (!this.context) {
      this.box.classList.add("blind");
      this.box.append(element("p", { class: "missing", role: "alert" }, "This browser has no WebGL 2, so that the robot cannot be shown in 3-D."));
    }
    this.clock.onChange(() => this.#pose());
    const frame = (now) => {
      this.#tick(now);
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  // `life` of what the page of `plsc view` shows; `before`: seasons' speeds of
  // the version that it is compared with, by name of the season.
  show(life, before) {
    const isFirst = this.lives.length === 0;
    this.lives = lifesOf(life);
    while (this.panes.length > this.lives.length) this.panes.pop().object.remove();
    while (this.panes.length < this.lives.length) {
      this.panes.push(new Pane());
      this.box.append(this.panes.at(-1).object);
    }
    this.box.classList.remove("empty");
    this.box.style.setProperty("--lives", this.lives.length);
    this.panes.forEach((pane, i) => pane.setLife(this.lives[i], before));
    if (this.context) this.#stage(life.recording.name);
    const end = Math.max(...this.lives.map((one) => one.end));
    this.bar.max = end;
    this.clock.setEnd(end);
    if (isFirst) this.clock.play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
  }

  #stage(name) {
    this.name = name;
    const surfaces = this.panes.map((pane) => pane.surface);
    if (this.stage) return this.stage.setLives(this.lives, surfaces);
    this.stage = new Stage(this.canvas, this.context, this.lives, surfaces);
    this.tools.append(panel("Camera", cameraControls(this.stage, () => this.#savePicture())));
  }

  #pose() {
    this.panes.forEach((pane, i) => {
      const { season, age } = pane.show(this.clock.time);
      this.stage?.pose(i, season, age);
    });
    // Moved when it can be seen to, for that has the browser paint it anew.
    if (!this.clock.isPlaying || Math.abs(this.bar.value - this.clock.time) > this.clock.end / 500) this.bar.value = this.clock.time;
  }

  #tick(now) {
    this.lastFrame ??= now;
    this.clock.pass((now - this.lastFrame) / 1000);
    if (this.stage?.draw(now) && this.clock.isPlaying) this.stage.judge(now - this.lastFrame);
    this.lastFrame = now;
  }

  #jump(direction) {
    const starts = [...new Set(this.lives.flatMap((life) => life.seasons.map((season) => season.start)))];
    const { time, end } = this.clock;
    const before = starts.filter((start) => start < time - 1);
    const after = starts.filter((start) => start > time + 1e-6);
    this.clock.go(direction < 0 ? (before.at(-1) ?? 0) : (after[0] ?? end));
  }

  async #savePicture() {
    const url = URL.createObjectURL(await this.stage.picture());
    element("a", { href: url, download: `${this.name}.png` }).click();
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  }
}
