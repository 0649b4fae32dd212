// How the genotype became the robot: the body in every environment beside the
// others, the brain, the rules, and what each symbol did. What is pointed at
// lights up here and in the editor.
import { element } from "../common/dom.js";
import { tell } from "../explain/about.js";
import { bodyView, rowsOf } from "../explain/body.js";
import { brainView } from "../explain/brain.js";
import { eventsView } from "../explain/events.js";
import { enter, Highlight } from "../explain/highlight.js";
import { linksOf } from "../explain/links.js";
import { modelOf, parse } from "../explain/model.js";
import { legend, ruleColours } from "../explain/robot.js";
import { rulesView } from "../explain/rules.js";
import { stringsView } from "../explain/strings.js";
import { unitsOf } from "./language/places.js";

const perEnvironment = (robot, view) => robot.environments.map((one) => element("div", { class: "environment" }, element("h4", {}, one.name), view(one)));

// Sections that can be opened stay as they were, whatever the robot becomes.
const sections = [
  ["Brain", true, (robot) => perEnvironment(robot, brainView)],
  ["Rules", false, (robot) => [rulesView(robot, () => null)]],
  ["Late development", false, (robot) => perEnvironment(robot, (one) => eventsView(robot, one))],
  ["Rewritings", false, (robot) => perEnvironment(robot, (one) => stringsView(robot, one))],
];

export class Workings {
  // onLit(ranges, hasMoved): the places in the text of what is lit;
  // hasMoved is false where the text itself was pointed at.
  constructor(onLit) {
    this.onLit = onLit;
    this.isByRule = false;
    this.lines = element("div", { class: "lines", role: "status" });
    this.bodies = element("div", { class: "root" });
    this.legend = element("div");
    this.colours = element(
      "button",
      { type: "button", "aria-pressed": "false", title: "Colours modules by the rule that made them, not by their type", onclick: () => this.#toggle() },
      "Colour by rule",
    );
    this.opened = new Map(sections.map(([name, isOpen]) => [name, isOpen]));
    this.object = element(
      "section",
      { class: "workings", "aria-label": "Body and brain" },
      element("div", { class: "top" }, element("h2", {}, "Body and brain"), this.legend, this.colours),
      this.bodies,
      element("div", { class: "told" }, this.lines),
    );
  }

  #toggle() {
    this.isByRule = !this.isByRule;
    this.colours.setAttribute("aria-pressed", String(this.isByRule));
    if (this.shown) this.show(...this.shown);
  }

  // `page` as `plsc view --explain` shows it, and which of its robots.
  show(page, number = 0) {
    this.shown = [page, number];
    this.robot = modelOf(page.robots[number]);
    this.units = unitsOf(this.robot.text);
    const kept = this.highlight?.kept ?? null;
    const scrolled = [...this.bodies.querySelectorAll("[data-scroll]")].map((box) => box.scrollTop);
    const root = element(
      "div",
      { class: "root" },
      element("div", { class: "environments" }, this.#bodies(page.colours)),
      sections.map((section) => this.#section(section)),
    );
    enter(root);
    this.highlight = new Highlight(root, this.robot, (key) => this.#told(key));
    this.bodies.replaceWith(root);
    this.legend.replaceChildren(legend(this.robot));
    this.bodies = root;
    root.querySelectorAll("[data-scroll]").forEach((box, i) => (box.scrollTop = scrolled[i] ?? 0));
    this.highlight.show(null);
    this.#told(null);
    if (kept && this.highlight.elements.has(kept)) this.highlight.keep(kept, root);
  }

  #bodies(colours) {
    const { robot } = this;
    const byRule = ruleColours(robot, colours.numbers);
    const ruleOf = ({ insertions, string }, module) => insertions[string[module.origin - 1] - 1].rule;
    const colourOf = (environment, module) =>
      this.isByRule ? (byRule.get(ruleOf(environment, module)) ?? { fill: "#fff", ink: "#000" }) : { fill: colours.types[module.type], ink: "#000" };
    const rows = rowsOf(robot.environments);
    return robot.environments.map((one) =>
      element(
        "section",
        { class: "environment" },
        element("h3", {}, one.name, " ", element("span", { class: "quiet" }, one.senses)),
        bodyView(one, rows, colourOf),
      ),
    );
  }

  #section([name, , make]) {
    const parts = make(this.robot);
    return element(
      "details",
      { open: this.opened.get(name), ontoggle: (event) => this.opened.set(name, event.target.open) },
      element("summary", {}, name),
      element("div", { class: "environments" }, parts),
    );
  }

  #told(key) {
    const idle = "Point at a module, an oscillator or a symbol, or press it to keep it lit: the text shows what made it.";
    const told = key === null ? [idle] : tell(this.robot, key);
    this.lines.replaceChildren(...told.map((text) => element("p", {}, text)));
    this.onLit(key === null ? [] : this.#ranges(key), !this.isFromText);
  }

  #ranges(key) {
    const { lit, kin } = linksOf(this.robot, key);
    const of = (keys, name) =>
      [...keys].filter((one) => one.startsWith("symbol:")).map((one) => {
        const [, rule, position] = parse(one);
        const [from, to] = this.robot.rules[rule - 1].symbols[position - 1].span.map(this.units);
        return { from, to, name };
      });
    return [...of(kin, "kin"), ...of(lit, "lit")];
  }

  // The symbol of the text at this place lights up what it made, if the robot is
  // of this text.
  pointAt(text, offset) {
    if (!this.robot || this.highlight.kept) return;
    let found = null;
    const rules = text === this.robot.text ? this.robot.rules : [];
    rules.forEach((rule, r) =>
      rule.symbols.forEach((symbol, p) => {
        const [from, to] = symbol.span.map(this.units);
        if (from <= offset && offset <= to) found = `symbol:${r + 1}:${p + 1}`;
      }),
    );
    this.isFromText = true;
    this.highlight.show(found, this.bodies);
    this.isFromText = false;
  }
}
