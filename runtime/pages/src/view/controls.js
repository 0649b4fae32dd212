// Buttons and keys: the clock's below the picture, the cameras' beside them.
import { element } from "../common/dom.js";
import { views } from "./camera.js";
import { icon } from "./icons.js";
import { timeText } from "./words.js";

const speeds = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20];
const frame = 0.02; // s, as recordings are sampled

export function clockControls(clock, jumpSeason) {
  const play = element("button", { class: "play", onclick: () => clock.play(!clock.isPlaying) }, "Play");
  const speed = element(
    "select",
    { onchange: () => clock.setSpeed(Number(speed.value)) },
    speeds.map((one) => element("option", { value: one, selected: one === 1 }, `${one} ×`)),
  );
  const time = element("output", { class: "time" });
  const step = (by) => {
    clock.play(false);
    clock.go(clock.time + by);
  };
  const button = (picture, what, act) => element("button", { title: what, "aria-label": what, onclick: act }, icon(picture));
  clock.onChange(() => {
    const text = clock.isPlaying ? "Pause" : "Play";
    if (play.textContent !== text) play.textContent = text;
    const now = `${timeText(clock.time)} of ${timeText(clock.end)}`;
    if (time.textContent !== now) time.textContent = now;
  });
  addKeys(clock, step, jumpSeason);
  return element(
    "div",
    { class: "group", role: "group", "aria-label": "Time" },
    play,
    button("before", "Season before", () => jumpSeason(-1)),
    button("back", "A frame back", () => step(-frame)),
    button("on", "A frame on", () => step(frame)),
    button("next", "Next season", () => jumpSeason(1)),
    element("label", {}, "Speed ", speed),
    time,
  );
}

function addKeys(clock, step, jumpSeason) {
  const keys = {
    " ": () => clock.play(!clock.isPlaying),
    ArrowLeft: () => step(-1),
    ArrowRight: () => step(1),
    ",": () => step(-frame),
    ".": () => step(frame),
    PageUp: () => jumpSeason(-1),
    PageDown: () => jumpSeason(1),
  };
  document.addEventListener("keydown", (event) => {
    // What has the focus knows its keys itself.
    if (event.target.closest("button, input, select, summary, a, textarea, [contenteditable]")) return;
    if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key]) return;
    keys[event.key]();
    event.preventDefault();
  });
}

const toggle = (text, what, isOn, act) => {
  const button = element(
    "button",
    {
      title: what,
      "aria-pressed": String(isOn),
      onclick: () => {
        const now = button.getAttribute("aria-pressed") !== "true";
        button.setAttribute("aria-pressed", String(now));
        act(now);
      },
    },
    text,
  );
  return button;
};

const viewNames = { behind: "Behind", side: "Side", above: "Above" };

export function cameraControls(stage, save) {
  const all = (change) => () => stage.forEachCamera(change);
  const follow = toggle("Follow", "The camera moves along with the robot", true, (isOn) =>
    stage.forEachCamera((camera) => (camera.isFollowing = isOn)),
  );
  const link = toggle("Turn together", "All cameras turn with the one that is turned", true, (isOn) => (stage.isLinked = isOn));
  return element(
    "div",
    { class: "group", role: "group", "aria-label": "Camera" },
    follow,
    stage.cameras.length > 1 ? link : null,
    views.map((view) => element("button", { onclick: all((camera) => camera.look(view)) }, viewNames[view])),
    element("button", { "aria-label": "Nearer", title: "Nearer", onclick: all((camera) => camera.zoom(0.8)) }, "+"),
    element("button", { "aria-label": "Farther", title: "Farther", onclick: all((camera) => camera.zoom(1.25)) }, "−"),
    element("button", { onclick: save, title: "Saves what is shown as a PNG" }, "Save picture"),
  );
}
