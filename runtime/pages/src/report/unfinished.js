// "plastic 9 to 20 (missing), baseline 3 (unfinished, 10 of 200 generations)":
// runs that are not finished, those of an experiment in one state together.
import { range } from "./text.js";

// "plastic/9" -> ["plastic", 9]; others have no number.
function split(label) {
  const match = /^(.*)\/(\d+)$/.exec(label);
  return match ? [match[1], Number(match[2])] : [label, null];
}

// "1, 3 to 5"
export function numbersText(numbers) {
  const groups = [];
  for (const number of [...new Set(numbers)].sort((a, b) => a - b)) {
    const last = groups.at(-1);
    if (last && last[1] === number - 1) last[1] = number;
    else groups.push([number, number]);
  }
  return groups.map(([first, last]) => (first === last ? `${first}` : last === first + 1 ? `${first}, ${last}` : `${first} to ${last}`)).join(", ");
}

export function unfinishedText(runs) {
  const groups = new Map();
  for (const run of runs) {
    const [name, number] = split(run.label);
    const key = JSON.stringify([name, number === null, run.state, run.generations_planned]);
    const group = groups.get(key) ?? { name, numbers: [], generations: [], state: run.state, planned: run.generations_planned };
    if (number !== null) group.numbers.push(number);
    if (run.generations_planned) group.generations.push(run.generations);
    groups.set(key, group);
  }
  return [...groups.values()]
    .map(({ name, numbers, generations, state, planned }) => {
      const which = numbers.length ? `${name} ${numbersText(numbers)}` : name;
      return `${which} (${state}${planned ? `, ${range(generations)} of ${planned} generations` : ""})`;
    })
    .join("; ");
}
