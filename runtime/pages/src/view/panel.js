// What is written over the picture of one life: who it is, which season, what
// changed, and how it ended.
import { element } from "../common/dom.js";
import { seasonAt } from "./life.js";
import { balanceText, bodyText, changeText, groundBehind, outcomeText, speedText } from "./words.js";

function set(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

export class Panel {
  constructor(life) {
    this.life = life;
    this.season = null;
    this.seasonName = element("strong");
    this.ground = element("span");
    this.speed = element("div", { class: "measure" });
    this.balance = element("div", { class: "measure" });
    this.change = element("div", { class: "change" });
    this.end = element("div", { class: "end", role: "status" });
    this.surface = element("div", { class: "surface" });
    this.object = element(
      "section",
      { class: "panel", "aria-label": life.name },
      this.surface,
      element(
        "div",
        { class: "who" },
        element("h2", {}, life.name),
        element("div", { class: "source" }, life.source),
        life.remark ? element("div", { class: "remark" }, life.remark) : null,
      ),
      element("div", { class: "now" }, element("div", {}, this.seasonName, " ", this.ground), this.speed, this.balance),
      this.change,
      this.end,
    );
  }

  // Gives the season and the s since it began.
  show(time) {
    const season = seasonAt(this.life, time);
    const age = Math.min(Math.max(time - season.start, 0), season.duration);
    if (season !== this.season) {
      this.season = season;
      set(this.seasonName, season.name);
      set(this.ground, groundBehind(season));
      set(this.speed, `Speed ${speedText(season)}`);
      set(this.balance, `Balance ${balanceText(season)}`);
    }
    const isGone = time > this.life.end;
    const hasEnded = isGone || (season.outcome !== "completed" && age >= season.lived);
    set(this.end, hasEnded ? (isGone ? "the end of its recording" : outcomeText(season)) : "");
    // Long enough to be read, counted in life so that it can be scrubbed to.
    set(this.change, age < 6 && season.motion.samples > 0 ? `${changeText(season)} (${bodyText(season.body)})` : "");
    return { season, age };
  }
}
