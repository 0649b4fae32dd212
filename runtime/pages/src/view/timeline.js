// The time line: a bar to scrub, and above it the seasons of each life.
import { element } from "../common/dom.js";
import { changeText, groundText, outcomeText } from "./words.js";

function marksOf(life, end, clock, hasNames) {
  return element(
    "div",
    { class: "seasons", role: "group", "aria-label": `Seasons of ${life.name}` },
    hasNames ? element("span", { class: "whose" }, life.name) : null,
    life.seasons.map((season) => {
      const begin = (100 * season.start) / end;
      const width = (100 * season.duration) / end;
      const about = `${season.name} (${groundText(season.terrain)})\n${changeText(season)}\n${outcomeText(season)}`;
      return element(
        "button",
        {
          class: `season ${season.terrain.type} changed-${season.change}`,
          style: `left:${begin}%;width:${width}%`,
          title: about,
          onclick: () => clock.go(season.start),
        },
        element("span", { class: "mark" }),
        element("span", { class: "name" }, season.name),
        season.lived < season.duration - 1e-6
          ? element("span", { class: "unlived", style: `left:${(100 * season.lived) / season.duration}%` })
          : null,
      );
    }),
  );
}

// Lives of the same seasons share their marks.
const plan = (life) => JSON.stringify(life.seasons.map(({ name, duration, change, lived }) => [name, duration, change, lived]));

export function makeTimeline(lives, clock) {
  const isShared = new Set(lives.map(plan)).size === 1;
  const bar = element("input", {
    type: "range",
    min: 0,
    max: clock.end,
    step: 0.02,
    value: 0,
    "aria-label": "Time, seconds",
    oninput: () => clock.go(Number(bar.value)),
  });
  const cursor = element("div", { class: "cursor" });
  clock.onChange(() => {
    cursor.style.transform = `translateX(${(100 * clock.time) / clock.end}%)`;
    // Moved when it can be seen to, for that has the browser paint it anew.
    if (clock.isPlaying && Math.abs(bar.value - clock.time) < clock.end / 500) return;
    bar.value = clock.time;
  });
  return element(
    "div",
    { class: "timeline" },
    element(
      "div",
      { class: "marks" },
      (isShared ? lives.slice(0, 1) : lives).map((life) => marksOf(life, clock.end, clock, !isShared)),
      cursor,
    ),
    bar,
  );
}
