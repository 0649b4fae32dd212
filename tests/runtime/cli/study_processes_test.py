#!/usr/bin/env python3
"""Studies that several processes work on, that are killed and stopped, and
that go on: all runs must end with the result tables of a study that was never
interrupted, bit for bit. Also examples/slurm.sh, with Slurm's part played here.

usage: study_processes_test.py PLSC REPOSITORY"""

import json
import os
import pathlib
import random
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

PLSC = pathlib.Path(sys.argv[1]).resolve()
REPOSITORY = pathlib.Path(sys.argv[2]).resolve()

STUDY = """plsc_study: 1
name: interrupted
seed: 5
repetitions: 2
base:
  population: 6
  offspring: 6
  generations: 5
  scenario:
    seasons: [{name: flat, terrain: flat, duration: 5 s}]
experiments:
  plastic: {}
  baseline: {encoding: baseline}
"""


def tables(path):
    """All result tables; what depends on the clock is in `session`."""
    with sqlite3.connect(f"file:{path}?mode=ro", uri=True) as store:
        names = [row[0] for row in store.execute(
            "SELECT name FROM sqlite_master WHERE type = 'table' "
            "AND name NOT LIKE 'sqlite_%' AND name != 'session' ORDER BY name")]
        assert "individual" in names, names
        return "\n".join(
            f"{name}\n" + "\n".join(
                sorted(map(repr, store.execute(f"SELECT * FROM {name}"))))
            for name in names)


def results(folder):
    runs = sorted(folder.rglob("*.sqlite"))
    return {str(run.relative_to(folder)): tables(run) for run in runs}


def study(folder, *arguments):
    return subprocess.Popen(
        [PLSC, "study", "run", "study.yaml", "-o", folder, "--quiet",
         "--jobs", "1", *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def finish(process, expected):
    out, err = process.communicate(timeout=300)
    assert process.returncode == expected, (process.returncode, out, err)
    return out, err


def status(folder):
    done = subprocess.run([PLSC, "study", "status", folder, "--format", "json"],
                          capture_output=True, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def wait_for_evaluations(folder, count):
    end = time.monotonic() + 60
    while not ((pathlib.Path(folder) / "study.yaml").exists() and sum(
            run["evaluations"] for run in status(folder)) >= count):
        assert time.monotonic() < end, "it did not happen in time"


def test_kills(expected):
    chance = random.Random(3)
    kills = 0
    while True:
        process = study("killed")
        try:
            process.wait(timeout=chance.uniform(0.05, 0.6) if kills < 15
                         else 300)
            break
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            process.communicate()
            kills += 1
    finish(process, 0)
    assert results(pathlib.Path("killed")) == expected
    print(f"{kills} kills: equal tables")


def test_stops(expected):
    """Ctrl-C and SIGTERM end it cleanly, and it says how to go on."""
    for number in (signal.SIGINT, signal.SIGTERM):
        folder = f"stopped{number.value}"
        for evaluations in (10, 70):
            process = study(folder)
            wait_for_evaluations(folder, evaluations)
            process.send_signal(number)
            out, err = finish(process, 130)
            assert (f"go on with\n  plsc study run study.yaml -o {folder}"
                    in err), err
            states = [run["state"] for run in status(folder)]
            assert states.count("unfinished") == 1, states
            assert states.count("missing") >= 1, states
        finish(study(folder), 0)
        assert results(pathlib.Path(folder)) == expected
    print("stopped and gone on with: equal tables")


def test_side_by_side(expected):
    """Two shards, and a third process that does the whole study meanwhile."""
    processes = [study("shared", "--shard", "1/2"),
                 study("shared", "--shard", "2/2"), study("shared")]
    states = set()
    while any(process.poll() is None for process in processes):
        if pathlib.Path("shared/study.yaml").exists():
            states.update(run["state"] for run in status("shared"))
    for process in processes:
        finish(process, 0)
    assert "running" in states and "damaged" not in states, states
    assert results(pathlib.Path("shared")) == expected
    out, _ = finish(study("shared"), 0)
    assert out == "4 runs: 0 done now, 4 before\n", out
    print(f"three processes in one folder, seen {sorted(states)}: equal tables")


def slurm(task, count, **more):
    """The script as Slurm starts it; requeueing is written down."""
    bin_folder = pathlib.Path("bin")
    bin_folder.mkdir(exist_ok=True)
    scontrol = bin_folder / "scontrol"
    scontrol.write_text('#!/bin/sh\necho "$@" >> requeued\n')
    scontrol.chmod(0o755)
    env = dict(os.environ, PATH=f"{PLSC.parent}:{bin_folder.resolve()}:"
               f"{os.environ['PATH']}", SLURM_ARRAY_JOB_ID="77",
               SLURM_ARRAY_TASK_ID=str(task), SLURM_ARRAY_TASK_MAX=str(count),
               SLURM_CPUS_PER_TASK="1", **more)
    return subprocess.Popen(
        [REPOSITORY / "examples/slurm.sh", "study.yaml", "slurm"], env=env,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def test_slurm(expected):
    script = REPOSITORY / "examples/slurm.sh"
    subprocess.run(["bash", "-n", script], check=True)
    wrong = subprocess.run([script], capture_output=True, text=True)
    assert wrong.returncode == 2 and "usage" in wrong.stderr, wrong
    # Out of time: stopped, and queued again.
    process = slurm(1, 2)
    wait_for_evaluations("slurm", 10)
    process.send_signal(signal.SIGUSR1)
    finish(process, 130)
    assert pathlib.Path("requeued").read_text() == "requeue 77_1\n"
    # Preempted: stopped; Slurm queues it again by itself.
    process = slurm(1, 2)
    wait_for_evaluations("slurm", 20)
    process.send_signal(signal.SIGTERM)
    finish(process, 130)
    assert pathlib.Path("requeued").read_text() == "requeue 77_1\n"
    # One task, another, and one of the first again.
    finish(slurm(2, 2), 0)
    finish(slurm(1, 1, SHARDS="2"), 0)
    assert results(pathlib.Path("slurm")) == expected
    print("slurm.sh stops, asks to be queued again, goes on: equal tables")


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        pathlib.Path("study.yaml").write_text(STUDY)
        finish(study("whole"), 0)
        expected = results(pathlib.Path("whole"))
        assert len(expected) == 4 and len(set(expected.values())) == 4
        test_kills(expected)
        test_stops(expected)
        test_side_by_side(expected)
        test_slurm(expected)
        os.chdir("/")


main()
