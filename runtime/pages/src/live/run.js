// Joined with a run, or a study's runs, by `plsc live`: how it goes, and its
// robots: a generation's best is put into the page, where it walks, with what
// changed since the one that was there before.
import { element } from "../common/dom.js";
import { curves } from "./run_curves.js";

async function got(target) {
  try {
    const response = await fetch(target);
    const text = await response.text();
    return response.ok ? JSON.parse(text) : { error: JSON.parse(text).error ?? text };
  } catch {
    return { error: "plsc live does not answer: was it ended?" };
  }
}
const query = (words) => new URLSearchParams(words).toString();

export class RunPanel {
  // show({name, text, scenario}) puts a robot into the page; say(text, isWrong).
  constructor(kind, { show, say }) {
    this.show = show;
    this.say = say;
    this.name = ""; // of the run in the study
    this.id = 0; // of the robot that is shown
    this.curves = element("div", { class: "curves" });
    this.told = element("p", { class: "quiet", role: "status" });
    this.bar = element("input", { type: "range", min: 0, max: 0, step: 1, value: 0, "aria-label": "Generation", oninput: () => this.#move() });
    this.of = element("select", { "aria-label": "Whose best", onchange: () => this.#move() });
    this.lineage = element("ol", { class: "lineage", "aria-label": "First parents, nearest first" });
    this.runs = element("select", { "aria-label": "Run", onchange: () => this.#choose(this.runs.value) });
    this.object = element(
      "section",
      { class: "run", "aria-label": "The run" },
      element("div", { class: "top" }, kind === "study" ? this.runs : null, this.told, element("label", {}, "best of ", this.of)),
      this.curves,
      this.bar,
      this.lineage,
    );
    this.events = new EventSource("events");
    this.events.addEventListener("error", () => say("plsc live does not answer", true));
    if (kind === "study") this.#list();
    else this.#choose("");
  }

  async #list() {
    const study = await got("study");
    if (study.error) return this.say(study.error, true);
    const speeds = (run) => run.best.map(({ season, speed }) => `${season} ${speed === null ? "none" : (100 * speed).toFixed(2)}`).join(", ");
    this.runs.replaceChildren(
      ...study.runs.map((run) =>
        element("option", { value: run.run, disabled: run.generations === 0 }, `${run.run}: ${run.state}, ${run.generations} generations${run.best.length ? `, ${speeds(run)} cm/s` : ""}`),
      ),
    );
    const first = study.runs.find((run) => run.generations > 0);
    if (!first) return this.say("no run of the study has a generation yet");
    this.runs.value = first.run;
    this.#choose(first.run);
  }

  async #choose(name) {
    if (this.listener) this.events.removeEventListener(this.event, this.listener);
    this.name = name;
    this.run = null;
    await this.#read();
    this.event = name ? `run:${name}` : "run";
    this.listener = () => this.#read();
    this.events.addEventListener(this.event, this.listener);
  }

  async #read() {
    const run = await got(`run?${query({ run: this.name })}`);
    if (run.error) return this.say(run.error, true);
    // Who looks at the newest generation goes on with the run.
    const isAtEnd = !this.run || Number(this.bar.value) >= Number(this.bar.max);
    if (!this.run) this.of.replaceChildren(element("option", { value: -1 }, "all seasons"), ...run.seasons.map((season, i) => element("option", { value: i }, season)));
    this.run = run;
    const last = run.generations.length - 1;
    this.told.textContent = `${run.name || "run"}, seed ${run.seed}: ${run.state}, ${last + 1} of ${run.total_generations} generations`;
    this.bar.max = Math.max(last, 0);
    if (isAtEnd) this.bar.value = Math.max(last, 0);
    if (last >= 0) this.#move();
  }

  async #move() {
    const row = this.run.generations[Number(this.bar.value)];
    const season = Number(this.of.value);
    const id = season < 0 ? row.best : row.best_of[season];
    this.curves.replaceChildren(curves(this.run, row.generation));
    const { census } = row;
    this.bar.title = `generation ${row.generation}`;
    this.curves.append(
      element(
        "p",
        { class: "quiet" },
        `Generation ${row.generation}: robot ${id || "none"}` + (census ? `; ${census.genotypes} genotypes, ${census.phenotypes} robots, of ${census.founders} founders` : ""),
      ),
    );
    if (id && id !== this.id) await this.#robot(id);
  }

  async #robot(id) {
    this.id = id;
    const robot = await got(`robot?${query({ run: this.name, id })}`);
    if (this.id !== id) return; // another one is wanted by now
    if (robot.error) return this.say(robot.error, true);
    this.show({ name: `robot_${id}.pls`, text: robot.genotype, scenario: this.run.scenario });
    const words = (one) => `${one.id} of generation ${one.generation}${one.mutation ? `, by ${one.mutation}` : ""}`;
    const press = (one) => () => {
      this.id = one.id;
      this.show({ name: `robot_${one.id}.pls`, text: one.genotype, scenario: this.run.scenario });
    };
    this.lineage.replaceChildren(
      ...[robot, ...robot.lineage].map((one) => element("li", {}, element("button", { type: "button", onclick: press(one) }, words(one)))),
    );
  }
}
