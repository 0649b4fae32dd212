// Random robots of a size, as genotypes: brains of one oscillator a joint.

// Of Knuth's MMIX generator: the same robots each time.
export class Random {
  constructor(seed) {
    this.state = BigInt(seed);
  }
  // 0 to below `end`
  below(end) {
    this.state = (this.state * 6364136223846793005n + 1442695040888963407n) % (1n << 64n);
    return Number((this.state >> 33n) % BigInt(end));
  }
}

// What is mounted on a module, by slot; a joint carries only in front of it.
function grow(random, size) {
  const modules = [{ type: "C", slots: {} }];
  while (modules.length < size) {
    const parent = modules[random.below(modules.length)];
    const slot = parent.type[0] === "A" ? "front" : ["left", "front", "right"][random.below(3)];
    if (parent.slots[slot]) continue;
    const child = { type: ["B", "A1", "A2"][random.below(3)], slots: {} };
    parent.slots[slot] = child;
    modules.push(child);
  }
  return modules;
}

// Goes over the tree as the paper's turtle does.
function symbols(random, module) {
  return Object.entries(module.slots).flatMap(([slot, child]) => {
    const isJoint = child.type !== "B";
    const numbers = [0.5, 1 + random.below(20) / 10, 1 + random.below(20) / 10, 1 + random.below(10) / 10];
    const symbol = isJoint ? `${child.type}(${numbers.map((number) => number.toFixed(1)).join(", ")})` : child.type;
    return [`add_${slot}`, symbol, `move_${slot}`, ...symbols(random, child), "move_back"];
  });
}

// A genotype of `size` modules with at least one joint. Its parts may overlap.
export function randomGenotype(random, size) {
  for (;;) {
    const modules = grow(random, size);
    if (!modules.some(({ type }) => type[0] === "A")) continue;
    return `plsc 1\ngenotype robot\nalphabet plasticoding 1\niterations 1\nrule C -> { C ${symbols(random, modules[0]).join(" ")} }\n`;
  }
}
