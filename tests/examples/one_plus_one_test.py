#!/usr/bin/env python3
"""examples/one_plus_one.py drives plsc through pipes: the same seed finds the
same robot, the robot is no worse than the one that it began with, and plsc
itself says so.

usage: one_plus_one_test.py PLSC REPOSITORY
"""

import json
import pathlib
import subprocess
import sys
import tempfile

SCENARIO = """plsc_scenario: 1
name: short
seasons:
  - {name: flat, terrain: flat, duration: 2 s}
  - {name: tilted, terrain: {tilted: 5 deg}, duration: 2 s}
"""


def fitness(plsc, genotype, scenario):
    out = subprocess.run(
        [plsc, "simulate", genotype, "--scenario", scenario, "--format", "json"],
        check=True, capture_output=True, text=True).stdout
    values = [json.loads(line)["fitness"] for line in out.splitlines()]
    return sum(values) / len(values)


def search(plsc, repository, folder, output, seed):
    return subprocess.run(
        [sys.executable, repository / "examples/one_plus_one.py",
         repository / "examples/snake.pls", "--plsc", plsc, "--evaluations",
         "25", "--scenario", folder / "short.yaml", "--seed", str(seed), "-o",
         folder / output],
        check=True, capture_output=True, text=True).stdout


def main():
    plsc, repository = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "short.yaml").write_text(SCENARIO)
        first = search(plsc, repository, folder, "a.pls", 1)
        again = search(plsc, repository, folder, "b.pls", 1)
        other = search(plsc, repository, folder, "c.pls", 2)
        found = (folder / "a.pls").read_text()
        assert first == again, (first, again)
        assert found == (folder / "b.pls").read_text()
        assert found != (folder / "c.pls").read_text(), other
        begun = fitness(plsc, repository / "examples/snake.pls",
                        folder / "short.yaml")
        best = fitness(plsc, folder / "a.pls", folder / "short.yaml")
        told = [float(line.split()[1]) for line in first.splitlines()]
        assert abs(told[0] - begun) < 1e-6, (told, begun)
        assert abs(told[-1] - best) < 1e-6, (told, best)
        assert told == sorted(told) and best > begun, told


if __name__ == "__main__":
    main()
