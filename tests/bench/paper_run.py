#!/usr/bin/env python3
"""How long the paper's run takes (100 + 100 robots, 200 generations, two
seasons of 50 s), extrapolated from its first generations. Reports; asserts
nothing.

usage: tests/bench/paper_run.py PLSC [GENERATIONS] [JOBS]
       tests/bench/paper_run.py RUN.sqlite...   reports on runs that are there

For each encoding the first GENERATIONS (default 20, besides the initial one)
are lived, on JOBS workers (default 2). A generation's cost is the work of its
simulations: the robots' sizes say how much each costs (the solver's time grows
by their square, see `physics_bench`), and the session's CPU time how much that
is in seconds, so that other programs on the machine disturb little. The rest of
the run is priced at the mean cost of the last ten generations, and with the
straight line through them."""

import contextlib
import pathlib
import sqlite3
import subprocess
import sys
import tempfile

RUN_GENERATIONS = 200


def costs_of(store):
    """Work by generation of birth, in units of a module's season squared."""
    rows = store.execute("""
        SELECT i.generation, b.absolute_size, s.steps, e.simulation
        FROM evaluation e JOIN individual i ON i.id = e.individual
        JOIN phenotype p ON p.key = e.phenotype JOIN body b ON b.key = p.body
        JOIN simulation s ON s.key = e.simulation ORDER BY i.id, e.season""")
    seen = set()
    costs, simulated, seasons, sizes = {}, {}, {}, {}
    for generation, size, steps, key in rows:
        seasons[generation] = seasons.get(generation, 0) + 1
        sizes[generation] = sizes.get(generation, 0) + size
        if key in seen:
            continue
        seen.add(key)
        simulated[generation] = simulated.get(generation, 0) + 1
        costs[generation] = costs.get(generation, 0) + steps * (size + 2) ** 2
    generations = sorted(seasons)
    return ([costs.get(g, 0) for g in generations],
            [1 - simulated.get(g, 0) / seasons[g] for g in generations],
            [sizes[g] / seasons[g] for g in generations])


def slope_of(values):
    n = len(values)
    mean_x, mean_y = (n - 1) / 2, sum(values) / n
    return (sum((x - mean_x) * (y - mean_y) for x, y in enumerate(values)) /
            sum((x - mean_x) ** 2 for x in range(n)))


def report(encoding, path, cores=2):
    with contextlib.closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as store:
        costs, known, sizes = costs_of(store)
        seconds, cpu = store.execute(
            "SELECT sum(seconds), sum(cpu_seconds) FROM session").fetchone()
        completed = store.execute("SELECT count(*) FROM generation").fetchone()[0]
    costs, known, sizes = costs[:completed], known[:completed], sizes[:completed]
    price = cpu / sum(costs)
    last = costs[-10:]
    mean, slope = sum(last) / len(last), slope_of(last)
    rest = RUN_GENERATIONS - completed
    flat = price * (sum(costs) + rest * mean)
    line = price * (sum(costs) + sum(
        max(0, mean + slope * (k + len(last) / 2)) for k in range(rest)))
    print(f"{encoding}: {completed} generations, {cpu:.0f} s CPU, {seconds:.0f} s")
    for g in range(0, completed, 5):
        print(f"  generation {g:>3}: mean size {sizes[g]:5.2f}, known already "
              f"{100 * known[g]:3.0f} %, {price * costs[g]:6.1f} s CPU")
    print(f"  the whole run: {flat / 60:.0f} min CPU at the last ten generations'"
          f" cost, {line / 60:.0f} min with their trend: "
          f"{flat / cores / 60:.0f} and {line / cores / 60:.0f} min on {cores} cores")


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help", "--smoke"):
        print(__doc__)
        return
    if sys.argv[1].endswith(".sqlite"):  # runs that are there already
        for path in sys.argv[1:]:
            report(pathlib.Path(path).stem, path)
        return
    generations = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    jobs = sys.argv[3] if len(sys.argv) > 3 else "2"
    with tempfile.TemporaryDirectory(prefix="plsc_paper_") as folder:
        for encoding in ("plasticoding", "baseline"):
            experiment = pathlib.Path(folder) / f"{encoding}.yaml"
            experiment.write_text(f"plsc_experiment: 1\nname: {encoding}\n"
                                  f"encoding: {encoding}\n"
                                  f"generations: {generations + 1}\n")
            path = pathlib.Path(folder) / f"{encoding}.sqlite"
            subprocess.run([sys.argv[1], "evolve", experiment, "-o", path,
                            "--jobs", jobs], stdout=subprocess.DEVNULL, check=True)
            report(encoding, path)


main()
