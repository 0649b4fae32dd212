#!/usr/bin/env python3
"""A (1+1) search of the oscillators of a robot, by asking plsc.

Python's standard library alone. `plsc evaluate --stdin` reads genotypes as JSON
lines and answers with fitness and descriptors, so any optimiser, in any
language, can drive it; this one is the simplest there is. A child is its parent
with noise on the numbers of its joints; it replaces the parent if its fitness,
the mean over the seasons, is no worse.

    examples/one_plus_one.py examples/climber.pls --evaluations 50 -o best.pls
"""

import argparse
import json
import random
import re
import subprocess
import sys

# A joint and its numbers: weight, amplitude, period (s), phase offset. Their
# ranges are those of the language (docs/language.md).
JOINT = re.compile(r"\b(A1|A2)\(([^()]*)\)")
NUMBER = re.compile(r"-?[0-9.]+(e-?[0-9]+)?")
RANGES = [(-1, 1), (1, 10), (1, 10), (1, 10)]


class Evaluator:
    """plsc, which stays and answers one line with one line."""

    def __init__(self, plsc, options):
        self.process = subprocess.Popen(
            [plsc, "evaluate", "--stdin", *options],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.asked = 0

    def fitness(self, genotype):
        """Mean over the seasons, m/s; nothing if one was not completed."""
        self.asked += 1
        request = {"id": self.asked, "genotype": genotype}
        self.process.stdin.write(json.dumps(request) + "\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:
            sys.exit("plsc has gone away")
        answer = json.loads(line)
        if "error" in answer:
            sys.exit(f"plsc refuses the genotype: {answer['error']}")
        seasons = list(answer["fitness"].values())
        return None if None in seasons else sum(seasons) / len(seasons)

    def close(self):
        self.process.stdin.close()
        return self.process.wait()


def mutated(genotype, sigma, rng):
    """Normal noise on a fifth of the joints' numbers, kept in their ranges."""
    def noisy(word, low, high):
        if rng.random() >= 0.2 or not NUMBER.fullmatch(word):
            return word  # a name stands for a constant, which stays
        number = float(word) + rng.gauss(0, sigma * (high - low))
        return repr(min(max(number, low), high))

    def joint(match):
        words = [word.strip() for word in match[2].split(",")]
        noise = (noisy(word, *limits) for word, limits in zip(words, RANGES))
        return f"{match[1]}({', '.join(noise)})"
    return JOINT.sub(joint, genotype)


def search(genotype, evaluator, options):
    rng = random.Random(options.seed)
    best = evaluator.fitness(genotype)
    print(f"{1:>5} {'none' if best is None else f'{best:.6f}'}")
    for evaluation in range(2, options.evaluations + 1):
        child = mutated(genotype, options.sigma, rng)
        fitness = evaluator.fitness(child)
        if fitness is not None and (best is None or fitness >= best):
            genotype, best = child, fitness
            print(f"{evaluation:>5} {best:.6f}", flush=True)
    return genotype


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("genotype", help="the file to begin with")
    parser.add_argument("--evaluations", type=int, default=50)
    parser.add_argument("--sigma", type=float, default=0.2,
                        help="of the noise, in parts of a number's range")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--plsc", default="plsc", help="the program")
    parser.add_argument("--scenario", help="passed on to plsc")
    parser.add_argument("-o", "--output", help="where the best one goes")
    options = parser.parse_args()
    with open(options.genotype, encoding="utf-8") as file:
        genotype = file.read()
    evaluator = Evaluator(
        options.plsc,
        ["--scenario", options.scenario] if options.scenario else [])
    best = search(genotype, evaluator, options)
    evaluator.close()
    if options.output:
        with open(options.output, "w", encoding="utf-8") as file:
            file.write(best)


if __name__ == "__main__":
    main()
