// Which genotype of the text is shown, and for which environment the editor's
// hints are, where there is something to choose.
import { element } from "../common/dom.js";

function fill(select, values) {
  const chosen = values.some(([value]) => value === select.value) ? select.value : (values[0]?.[0] ?? "");
  select.replaceChildren(...values.map(([value, text]) => element("option", { value }, text)));
  select.value = chosen;
}

export class Choices {
  constructor({ onGenotype, onEnvironment }) {
    this.genotype = element("select", { onchange: () => onGenotype(this.genotype.value) });
    this.environment = element("select", { onchange: () => onEnvironment(this.environment.value) });
    this.labels = [
      element("label", { hidden: true }, "Genotype ", this.genotype),
      element("label", { hidden: true }, "Hints for ", this.environment),
    ];
    this.object = element("div", { class: "choices" }, this.labels);
  }

  // Gives the states that the genotype asks about, or null.
  async look(door, { text, name, genotype }) {
    const answer = await door.ask({ ask: "check", text, name });
    if (!answer.ok || answer.genotypes.length === 0) return null;
    const shown = answer.genotypes.find((one) => one.name === genotype) ?? answer.genotypes[0];
    fill(this.genotype, answer.genotypes.map((one) => [one.name, one.name]));
    fill(this.environment, shown.environments.map((one) => [one.name, one.name]));
    this.labels[0].hidden = answer.genotypes.length < 2;
    this.labels[1].hidden = shown.environments.length < 2;
    return shown.states;
  }
}
