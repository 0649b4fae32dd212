// What lights up when something is pointed at: `lit` is the thing itself and
// what made it or what it made, `kin` what these were inserted for or helped by.
import { parse, partOf } from "./model.js";

class Links {
  constructor(robot) {
    this.robot = robot;
    this.lit = new Set();
    this.kin = new Set();
  }
  insertion(e, id) {
    return this.robot.environments[e].insertions[id - 1];
  }
  rule(one, set) {
    if (one.rule === 0) return;
    set.add(`rule:${one.rule}`);
    set.add(`symbol:${one.rule}:${one.position}`);
  }
  // What an insertion was inserted for.
  ancestors(e, id) {
    for (let at = this.insertion(e, id).parent; at; at = this.insertion(e, at).parent) {
      this.kin.add(`in:${e}:${at}`);
      this.rule(this.insertion(e, at), this.kin);
    }
  }
  // A symbol of the last string: itself, its rule, what it made.
  symbol(e, index) {
    const environment = this.robot.environments[e];
    this.lit.add(`ev:${e}:${index}`);
    this.lit.add(`in:${e}:${environment.string[index - 1]}`);
    for (const key of environment.made.get(index) ?? []) this.lit.add(key);
    for (const key of environment.changed.get(index) ?? []) this.lit.add(key);
  }
  // An insertion, all that came of it, but not what it came of.
  descendants(e, id) {
    const waiting = [id];
    while (waiting.length > 0) {
      const at = waiting.pop();
      const one = this.insertion(e, at);
      this.lit.add(`in:${e}:${at}`);
      if (one.last) this.symbol(e, one.last);
      waiting.push(...one.children);
    }
  }
  partner(e, index) {
    const partner = this.robot.environments[e].events[index - 1].partner;
    if (partner) this.kin.add(`ev:${e}:${partner}`);
  }
  // The whole story of a symbol of the last string.
  story(e, index) {
    const id = this.robot.environments[e].string[index - 1];
    this.symbol(e, index);
    this.rule(this.insertion(e, id), this.lit);
    this.ancestors(e, id);
    this.partner(e, index);
  }
  // Modules at the same place in the other environments.
  twins(e, place) {
    for (const other of this.robot.environments)
      if (other.number !== e)
        other.modules.forEach((module, k) => module.place === place && this.kin.add(`mod:${other.number}:${k}`));
  }
  // All insertions of a rule, or of one symbol of it.
  written(rule, position) {
    for (const { number, insertions } of this.robot.environments)
      insertions.forEach((one, i) => {
        if (one.rule !== rule || (position && one.position !== position)) return;
        this.lit.add(`in:${number}:${i + 1}`);
        if (one.last) this.symbol(number, one.last);
      });
  }
}

export function linksOf(robot, key) {
  const links = new Links(robot);
  const [kind, first, second] = parse(key);
  links.lit.add(key);
  if (kind === "rule") {
    links.written(first, 0);
  } else if (kind === "symbol") {
    links.kin.add(`rule:${first}`);
    links.written(first, second);
  } else if (kind === "in") {
    links.rule(links.insertion(first, second), links.lit);
    links.descendants(first, second);
    links.ancestors(first, second);
  } else if (kind === "ev") {
    links.story(first, second);
  } else {
    const part = partOf(robot, key);
    links.story(first, part.origin);
    for (const change of part.changes) {
      const before = new Set(links.lit);
      links.story(first, change);
      // What else the change concerned is not this part's story.
      for (const other of links.lit) if (!before.has(other) && /^(mod|node|edge):/.test(other)) links.lit.delete(other);
    }
    if (kind === "mod") links.twins(first, part.place);
  }
  for (const one of links.lit) links.kin.delete(one);
  return { lit: links.lit, kin: links.kin };
}
