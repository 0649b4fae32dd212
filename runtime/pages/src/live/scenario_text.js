// A scenario's text as plsc prints it, every constant on a line of its own, read
// and changed line by line: what controls do not know stays as it is.

const seasonStart = /^  - name: (.*)$/;
const grounds = {
  flat: "flat",
  tilted: "{tilted: 5 deg}",
  rough: "{rough: {amplitude: 2 cm, wavelength: 30 cm}}",
  steps: "{steps: {height: 1 cm, depth: 40 cm}}",
  obstacles: "{obstacles: {height: 2 cm}}",
};
export const groundNames = Object.keys(grounds);

// "{hot: False, wet: 3}" as [["hot", "False"], ["wet", "3"]].
function pairsOf(text) {
  const inner = /^\{(.*)\}$/.exec(text ?? "")?.[1] ?? "";
  return inner.split(", ").filter(Boolean).map((pair) => pair.split(": "));
}

export class ScenarioText {
  constructor(yaml) {
    this.lines = yaml.split("\n");
  }

  get text() {
    return this.lines.join("\n");
  }

  // [first, last) lines of each season.
  #blocks() {
    const starts = this.lines.flatMap((line, i) => (seasonStart.test(line) ? [i] : []));
    return starts.map((start) => {
      let end = start + 1;
      while (/^    /.test(this.lines[end] ?? "")) ++end;
      return [start, end];
    });
  }

  // {name, ground, slope (deg, if tilted), duration (s), senses: Map}
  get seasons() {
    return this.#blocks().map(([start, end]) => {
      const value = (key) => {
        const prefix = `    ${key}: `;
        return this.lines.slice(start, end).find((line) => line.startsWith(prefix))?.slice(prefix.length);
      };
      const terrain = value("terrain") ?? "flat";
      const slope = /^\{tilted: ([-\d.e]+) (deg|rad)\}$/.exec(terrain);
      return {
        name: seasonStart.exec(this.lines[start])[1],
        ground: /^\{?(\w+)/.exec(terrain)[1],
        slope: slope ? Number(slope[1]) * (slope[2] === "rad" ? 180 / Math.PI : 1) : null,
        duration: parseFloat(value("duration")),
        senses: new Map(pairsOf(value("senses"))),
      };
    });
  }

  // Of a line of the season, which is added if it has none.
  #setLine(i, key, value) {
    const [start, end] = this.#blocks()[i];
    const at = this.lines.findIndex((line, k) => k > start && k < end && line.startsWith(`    ${key}: `));
    if (at >= 0) this.lines[at] = `    ${key}: ${value}`;
    else this.lines.splice(end, 0, `    ${key}: ${value}`);
  }

  setDuration(i, seconds) {
    this.#setLine(i, "duration", `${seconds} s`);
  }
  setGround(i, name) {
    this.#setLine(i, "terrain", grounds[name]);
  }
  setSlope(i, degrees) {
    this.#setLine(i, "terrain", `{tilted: ${degrees} deg}`);
  }
  // "" leaves the state to what the robot feels.
  setSense(i, state, value) {
    const { senses } = this.seasons[i];
    if (value === "") senses.delete(state);
    else senses.set(state, value);
    this.#setLine(i, "senses", `{${[...senses].map(([name, one]) => `${name}: ${one}`).join(", ")}}`);
  }
  remove(i) {
    const [start, end] = this.#blocks()[i];
    this.lines.splice(start, end - start);
  }
  // Like the last one, under another name.
  add() {
    const [start, end] = this.#blocks().at(-1);
    const names = new Set(this.seasons.map((season) => season.name));
    let number = names.size + 1;
    while (names.has(`season${number}`)) ++number;
    this.lines.splice(end, 0, `  - name: season${number}`, ...this.lines.slice(start + 1, end));
  }

  // Keys of the physics that all seasons share.
  physics(key) {
    const line = this.lines.find((one) => one.startsWith(`  ${key}: `));
    return line?.slice(key.length + 4) ?? null;
  }
  setPhysics(key, value) {
    const at = this.lines.findIndex((one) => one.startsWith(`  ${key}: `));
    if (at >= 0) this.lines[at] = `  ${key}: ${value}`;
    else this.lines.splice(this.lines.indexOf("physics:") + 1, 0, `  ${key}: ${value}`);
  }
}
