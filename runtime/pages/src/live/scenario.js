// What the robot lives through, as controls and as text.
import { element } from "../common/dom.js";
import { Newest } from "./newest.js";
import { groundNames, ScenarioText } from "./scenario_text.js";

// The paper's two seasons, by the engine that answers while one drags.
export const usual = `plsc_scenario: 1
profile: swift
seasons:
  - {name: flat, terrain: flat, duration: 50 s}
  - {name: tilted, terrain: {tilted: 5 deg}, duration: 50 s}
`;

const number = (label, value, rest, act) => {
  const input = element("input", { type: "number", value, "aria-label": label, ...rest, onchange: () => input.checkValidity() && act(input.value) });
  return input;
};
const select = (label, values, chosen, act) => {
  const made = element(
    "select",
    { "aria-label": label, onchange: () => act(made.value) },
    values.map(([value, text]) => element("option", { value, selected: value === chosen }, text)),
  );
  return made;
};

export class ScenarioPanel {
  // onChange(yaml): another scenario that is right.
  constructor(door, onChange) {
    this.door = door;
    this.onChange = onChange;
    this.states = [];
    this.engines = [];
    door.ask({ ask: "about" }).then((answer) => {
      this.engines = answer.engines ?? [];
      if (this.printed) this.#show();
    });
    this.seasons = element("div", { class: "seasons-table" });
    this.shared = element("div", { class: "shared" });
    this.text = element("textarea", { "aria-label": "The scenario as YAML", spellcheck: "false", rows: 10, oninput: () => this.checking.add(this.text.value) });
    this.wrong = element("p", { class: "fault", role: "alert" });
    this.checking = new Newest((yaml) => this.#check(yaml, true));
    this.object = element(
      "div",
      { class: "scenario" },
      this.seasons,
      this.shared,
      element("details", {}, element("summary", {}, "As YAML"), this.text),
      this.wrong,
    );
  }

  // Another robot's, or an earlier version's.
  set(yaml) {
    this.yaml = yaml;
    this.text.value = yaml;
    return this.#check(yaml, false);
  }

  // What the robot asks about, as `check` has it: [{name, type, ...}].
  setStates(states) {
    const isSame = JSON.stringify(states) === JSON.stringify(this.states);
    this.states = states;
    if (!isSame && this.printed) this.#show();
  }

  async #check(yaml, isNew) {
    const answer = await this.door.ask({ ask: "scenario", scenario: yaml });
    this.wrong.textContent = answer.ok ? "" : answer.error;
    if (!answer.ok) return;
    this.printed = answer.yaml;
    if (!this.seasons.contains(document.activeElement)) this.#show();
    if (isNew && yaml !== this.yaml) {
      this.yaml = yaml;
      this.onChange(yaml);
    }
  }

  // A control: changes the text that has every constant.
  #change(change) {
    const text = new ScenarioText(this.printed);
    change(text);
    this.printed = text.text;
    this.text.value = text.text;
    this.checking.add(text.text);
    this.#show();
  }

  #row(season, i, isOnly) {
    const change = (act) => (value) => this.#change((text) => act(text, value));
    const slope =
      season.slope === null
        ? null
        : element("label", {}, number(`Slope of ${season.name}, degrees`, Number(season.slope.toFixed(3)), { min: -45, max: 45, step: "any" }, change((text, value) => text.setSlope(i, value))), "°");
    return element(
      "tr",
      {},
      element("th", { scope: "row" }, season.name),
      element("td", {}, select(`Ground of ${season.name}`, groundNames.map((one) => [one, one]), season.ground, change((text, value) => text.setGround(i, value))), " ", slope),
      element("td", {}, number(`Duration of ${season.name}, seconds`, season.duration, { min: 1, max: 1000, step: "any" }, change((text, value) => text.setDuration(i, value))), " s"),
      this.states.map((state) => element("td", {}, this.#sense(season, i, state))),
      element("td", {}, isOnly ? null : element("button", { type: "button", "aria-label": `Leave out ${season.name}`, onclick: () => this.#change((text) => text.remove(i)) }, "×")),
    );
  }

  #sense(season, i, { name, type, values = ["False", "True"], low, high }) {
    const given = season.senses.get(name) ?? "";
    const change = (value) => this.#change((text) => text.setSense(i, name, value));
    const label = `${name} in ${season.name}`;
    if (type === "real") return number(label, given, { step: "any", min: low, max: high }, change);
    return select(label, [["", name === "inclined" ? "as felt" : "–"], ...values.map((one) => [one, one])], given, change);
  }

  #show() {
    const text = new ScenarioText(this.printed);
    const { seasons } = text;
    const head = ["Season", "Ground", "Duration", ...this.states.map((state) => state.name), ""];
    this.seasons.replaceChildren(
      element(
        "table",
        {},
        element("thead", {}, element("tr", {}, head.map((name) => element("th", { scope: "col" }, name)))),
        element("tbody", {}, seasons.map((season, i) => this.#row(season, i, seasons.length === 1))),
      ),
      element("button", { type: "button", onclick: () => this.#change((one) => one.add()) }, "Add a season"),
    );
    const friction = element("input", {
      type: "range",
      min: 0,
      max: 2,
      step: 0.05,
      value: Number(text.physics("friction")),
      "aria-label": "Friction",
      oninput: () => {
        output.textContent = friction.value;
        this.#slide("friction", friction.value);
      },
    });
    const output = element("output", {}, text.physics("friction"));
    this.shared.replaceChildren(element("label", {}, "Friction ", friction, " ", output), ...this.#engine(text.physics("engine")));
  }

  // Where there is one to choose: a page's own plsc has no ODE.
  #engine(chosen) {
    const names = [...new Set([...this.engines, ...(chosen ? [chosen] : [])])];
    if (!chosen || names.length < 2) return [];
    return [element("label", {}, "Engine ", select("Engine", names.map((one) => [one, one]), chosen, (name) => this.#change((text) => text.setPhysics("engine", name))))];
  }

  // As #change, without making the slider anew under the pointer.
  #slide(key, value) {
    const text = new ScenarioText(this.printed);
    text.setPhysics(key, value);
    this.printed = text.text;
    this.text.value = text.text;
    this.checking.add(text.text);
  }
}
