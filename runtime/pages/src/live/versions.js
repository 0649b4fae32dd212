// The strip of earlier versions: how the robot looked and how fast it was. A
// version is a text that lived and then stood still for a while.
import { element } from "../common/dom.js";
import { thumbnail } from "./thumbnail.js";

const settling = 900; // ms
const most = 60; // the first one stays, too: what one came from

const speed = (season) => (season.speed === null || season.speed === undefined ? "–" : (season.speed * 100).toFixed(2).replace("-", "−"));

export class Versions {
  // goTo(version) puts its text back.
  constructor(goTo) {
    this.goTo = goTo;
    this.all = []; // {text, scenario, seasons, number, item}
    this.count = 0;
    this.current = null;
    this.list = element("ol", { class: "versions", "aria-label": "Versions" });
    this.object = element("section", { class: "strip", "aria-label": "Earlier versions" }, element("h2", {}, "Versions"), this.list);
  }

  // A version that lived, {text, scenario, page, seasons}; the strip has it when
  // nothing newer comes soon. Of its recording and development nothing is kept.
  offer(version) {
    clearTimeout(this.timer);
    const known = this.find(version);
    if (known) this.#mark(known);
    else this.timer = setTimeout(() => this.#add(version), this.all.length === 0 ? 0 : settling);
  }

  find({ text, scenario }) {
    return this.all.find((one) => one.text === text && one.scenario === scenario);
  }

  // What the present text is compared with: the last version that is another.
  before({ text, scenario }) {
    const known = this.find({ text, scenario });
    const others = known ? this.all.slice(0, this.all.indexOf(known)) : this.all;
    return others.at(-1) ?? null;
  }

  forget() {
    clearTimeout(this.timer);
    this.all = [];
    this.count = 0;
    this.current = null;
    this.list.replaceChildren();
  }

  #add({ text, scenario, page, seasons }) {
    const version = { text, scenario, seasons, number: ++this.count };
    version.item = this.#item(version, page);
    this.all.push(version);
    this.list.append(version.item);
    if (this.all.length > most) this.all.splice(1, 1)[0].item.remove();
    this.#mark(version);
    this.list.scrollLeft = this.list.scrollWidth;
  }

  #mark(version) {
    this.current?.item.firstChild.removeAttribute("aria-current");
    this.current = version;
    version.item.firstChild.setAttribute("aria-current", "true");
  }

  #item(version, page) {
    const { seasons, number } = version;
    const speeds = seasons.map((season) => `${season.name} ${speed(season)} cm/s`);
    return element(
      "li",
      {},
      element(
        "button",
        { type: "button", class: "version", title: speeds.join("\n"), "aria-label": `Version ${number}: ${speeds.join(", ")}`, onclick: () => this.goTo(version) },
        element("span", { class: "bodies" }, page.robots[0].environments.slice(0, 2).map((one) => thumbnail(one, page.colours.types))),
        element("span", { class: "speeds" }, seasons.slice(0, 2).map(speed).join(" · ")),
      ),
    );
  }
}
