// What is written over the picture of one life: the season, how it went, and
// how much better or worse than before.
import { element } from "../common/dom.js";
import { seasonAt } from "../view/life.js";
import { balanceText, changeText, groundBehind, outcomeText, speedText } from "../view/words.js";

function set(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

// "+0.31", of cm/s.
function gain(season, before) {
  const old = before?.get(season.name);
  if (old === undefined || old === null || season.speed === null) return 0;
  return Math.round((season.speed - old) * 10000) / 100;
}

export class Pane {
  constructor() {
    this.seasonName = element("strong");
    this.ground = element("span", { class: "quiet" });
    this.speed = element("span", { class: "measure" });
    this.gain = element("span");
    this.balance = element("div", { class: "measure" });
    this.change = element("div", { class: "change" });
    this.end = element("div", { class: "end", role: "status" });
    this.surface = element("div", { class: "surface" });
    this.object = element(
      "section",
      { class: "panel" },
      this.surface,
      element("div", { class: "who" }, element("div", {}, this.seasonName, " ", this.ground)),
      element("div", { class: "now" }, element("div", {}, this.speed, " ", this.gain), this.balance),
      this.change,
      this.end,
    );
  }

  setLife(life, before) {
    this.life = life;
    this.before = before;
    this.season = null;
  }

  #enter(season) {
    this.season = season;
    this.object.setAttribute("aria-label", `Season ${season.name}`);
    set(this.seasonName, season.name);
    set(this.ground, groundBehind(season));
    set(this.speed, `Speed ${speedText(season)}`);
    set(this.balance, `Balance ${balanceText(season)}`);
    const by = gain(season, this.before);
    set(this.gain, by === 0 ? "" : `${by > 0 ? "▲ +" : "▼ −"}${Math.abs(by).toFixed(2)}`);
    this.gain.className = by > 0 ? "better" : "worse";
    this.gain.title = "against the version before, cm/s";
  }

  // Gives the season and the s since it began.
  show(time) {
    const season = seasonAt(this.life, time);
    const age = Math.min(Math.max(time - season.start, 0), season.duration);
    if (season !== this.season) this.#enter(season);
    const hasEnded = season.outcome !== "completed" && age >= season.lived;
    set(this.end, hasEnded ? outcomeText(season) : "");
    const isTold = this.life.seasons.length > 1 && age < 6 && season.motion.samples > 0;
    set(this.change, isTold ? changeText(season) : "");
    return { season, age };
  }
}
