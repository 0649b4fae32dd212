// The data of one robot, indexed for questions. Numbers count from 1, as in
// the rest of plsc; environments are counted from 0.
//
// Whatever can be pointed at has a key:
//   rule:R   symbol:R:P            of the genotype
//   in:E:I   ev:E:S                an inserted symbol; a symbol of the last string
//   mod:E:K  node:E:K  edge:E:K    a part of the robot, counted from 0

function environmentModel(robot, data, number) {
  const insertions = data.insertions.map(([rule, position, iteration, parent]) => ({
    rule,
    position,
    iteration,
    parent,
    children: [],
    last: 0, // its number in the last string; 0: it was replaced
  }));
  insertions.forEach((one, i) => one.parent && insertions[one.parent - 1].children.push(i + 1));
  const string = data.steps.at(-1);
  string.forEach((id, i) => (insertions[id - 1].last = i + 1));

  // By symbol of the last string, the keys of what it made and what it changed.
  const made = new Map();
  const changed = new Map();
  const note = (map, symbol, key) => map.set(symbol, [...(map.get(symbol) ?? []), key]);
  for (const [kind, parts] of [["mod", data.modules], ["node", data.nodes], ["edge", data.edges]])
    parts.forEach((part, k) => {
      const key = `${kind}:${number}:${k}`;
      note(made, part.origin, key);
      part.changes.forEach((symbol) => note(changed, symbol, key));
    });
  return { ...data, number, insertions, string, made, changed };
}

export function modelOf(robot) {
  const environments = robot.environments.map((data, i) => environmentModel(robot, data, i));
  return { ...robot, environments };
}

// The text of an inserted symbol, with its arguments or the name alone.
export function textOf(robot, one) {
  return one.rule === 0 ? robot.axiom : robot.rules[one.rule - 1].symbols[one.position - 1].text;
}
export function nameOf(robot, one) {
  return one.rule === 0 ? robot.axiom : robot.rules[one.rule - 1].symbols[one.position - 1].name;
}

// Evolved numbers have 17 digits; three tell enough where space is scarce. The
// number of a name, such as node3, has no point and stays.
export function shortened(text) {
  return text.replace(/-?\d+\.\d+(?:e[-+]?\d+)?/g, (number) => String(Number(Number(number).toPrecision(3))));
}

// "inclined = True and hot = False", or "always".
export function clauseOf(rule) {
  if (rule.terms.length === 0) return "always";
  return "if " + rule.terms.map((term, i) => (i === 0 ? "" : `${rule.connectives[i - 1]} `) + term).join(" ");
}

export function parse(key) {
  const [kind, ...numbers] = key.split(":");
  return [kind, ...numbers.map(Number)];
}

// The part of the robot that the key is of.
export function partOf(robot, key) {
  const [kind, e, k] = parse(key);
  return robot.environments[e][{ mod: "modules", node: "nodes", edge: "edges" }[kind]][k];
}
