// What is pointed at, in words.
import { clauseOf, nameOf, parse, partOf, textOf } from "./model.js";

// "inserted in iteration 2 for B, in iteration 1 for C".
function ancestry(robot, environment, id) {
  const parts = [];
  for (let one = environment.insertions[id - 1]; one.parent; one = environment.insertions[one.parent - 1])
    parts.push(`in iteration ${one.iteration} for ${nameOf(robot, environment.insertions[one.parent - 1])}`);
  return parts.length === 0 ? "the axiom" : `inserted ${parts.join(", which was inserted ")}`;
}

function written(robot, one) {
  if (one.rule === 0) return "the axiom, written by no rule";
  const rule = robot.rules[one.rule - 1];
  return `symbol ${one.position} of rule ${one.rule} (${rule.head}, ${clauseOf(rule)}), line ${rule.line}`;
}

function symbolStory(robot, environment, index) {
  const id = environment.string[index - 1];
  const one = environment.insertions[id - 1];
  return [
    `symbol ${index} of ${environment.string.length}, ${textOf(robot, one)}: ${environment.events[index - 1].text}`,
    `${written(robot, one)}; ${ancestry(robot, environment, id)}`,
  ];
}

function ruleStory(robot, number, what) {
  const rule = robot.rules[number - 1];
  const lines = [what ?? `rule ${number}: ${rule.head}, ${clauseOf(rule)}`];
  for (const environment of robot.environments) {
    if (!environment.rules[number - 1].active) {
      lines.push(`${environment.name}: not active`);
      continue;
    }
    const made = environment.modules.filter((module) => {
      const one = environment.insertions[environment.string[module.origin - 1] - 1];
      return one.rule === number;
    });
    const modules = made.map((module) => module.id).join(", ");
    lines.push(`${environment.name}: active, ${made.length > 0 ? `made module${made.length > 1 ? "s" : ""} ${modules}` : "made no module"}`);
  }
  return lines;
}

function insertionStory(robot, environment, id) {
  const one = environment.insertions[id - 1];
  const lines = [`${textOf(robot, one)} in ${environment.name}: ${written(robot, one)}; ${ancestry(robot, environment, id)}`];
  if (one.last) lines.push(symbolStory(robot, environment, one.last)[0]);
  else lines.push(`replaced in iteration ${environment.insertions[one.children[0] - 1].iteration} by ${one.children.length} symbol${one.children.length === 1 ? "" : "s"}`);
  return lines;
}

// Nodes are called so already.
const kinds = { mod: "module ", node: "", edge: "edge " };

export function tell(robot, key) {
  const [kind, first, second] = parse(key);
  if (kind === "rule") return ruleStory(robot, first);
  if (kind === "symbol") {
    const symbol = robot.rules[first - 1].symbols[second - 1];
    const count = robot.environments.map((one) => {
      const all = one.insertions.filter((i) => i.rule === first && i.position === second);
      return `${one.name}: inserted ${all.length} time${all.length === 1 ? "" : "s"}, ${all.filter((i) => i.last).length} in the last string`;
    });
    return [`${symbol.text}: symbol ${second} of rule ${first}`, ...count];
  }
  const environment = robot.environments[first];
  if (kind === "in") return insertionStory(robot, environment, second);
  if (kind === "ev") return [`in ${environment.name}`, ...symbolStory(robot, environment, second)];
  const part = partOf(robot, key);
  const type = kind === "mod" ? ` (${part.type})` : "";
  const changes = part.changes.map((index) => `changed by ${symbolStory(robot, environment, index)[0]}`);
  const name = part.type === "T" ? "sensor " : kinds[kind];
  return [`${name}${part.id}${type} in ${environment.name}`, ...symbolStory(robot, environment, part.origin), ...changes];
}
