#!/usr/bin/env python3
"""Robots live again while the process is killed, asked to stop, loses a worker
or its disk; in the end the file has the rows of one that nobody disturbed.

usage: relive_kill_test.py PLSC"""

import contextlib
import os
import pathlib
import random
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

PLSC = sys.argv[1]
KILLS = 15

EXPERIMENT = """plsc_experiment: 1
name: relived
seed: 11
population: 8
offspring: 8
generations: 2
scenario:
  profile: swift
  seasons:
    - {name: flat, terrain: flat, duration: 20 s}
    - {name: tilted, terrain: {tilted: 5 deg}, duration: 20 s}
"""
WHAT = ["--lives", "6", "--swap", "3", "--engine-check"]


def tables(path):
    with contextlib.closing(
            sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as file:
        return {name: file.execute(f"SELECT * FROM {name}").fetchall()
                for name in ("relived", "program", "season", "robot", "life")}


def lives(path):
    try:
        return len(tables(path)["life"])
    except sqlite3.OperationalError:
        return 0


def relive(run, *arguments, **options):
    return subprocess.Popen(
        [PLSC, "relive", run, *WHAT, *arguments, "--quiet"], text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)


def finish(process, expected=0):
    out, err = process.communicate(timeout=300)
    assert process.returncode == expected, (process.returncode, out, err)
    return out, err


class Place:
    """A copy of the run in a folder of its own."""

    def __init__(self, folder, run, name):
        (folder / name).mkdir()
        self.run = folder / name / "1.sqlite"
        self.file = folder / name / "1.relived.sqlite"
        shutil.copy(run, self.run)

    def wait_for(self, count):
        end = time.monotonic() + 120
        while lives(self.file) < count:
            assert time.monotonic() < end, "it did not happen in time"
            time.sleep(0.005)


def test_kills(place, expected, seconds):
    chance = random.Random(5)
    for _ in range(KILLS):
        process = relive(place.run, "--jobs", "2")
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(timeout=chance.uniform(0, seconds / 5))
        process.send_signal(signal.SIGKILL)
        process.communicate()
    finish(relive(place.run))
    assert tables(place.file) == expected, "kills changed the lives"


def test_signal(place, expected):
    process = relive(place.run)
    place.wait_for(10)
    process.send_signal(signal.SIGINT)
    _, err = finish(process, expected=130)
    assert "stopped after" in err and f"plsc relive {place.run}" in err, err
    there = lives(place.file)
    assert 10 <= there < len(expected["life"]), there
    finish(relive(place.run))
    assert tables(place.file) == expected, "a signal changed the lives"


def test_dead_worker(place, expected):
    process = relive(place.run, "--jobs", "2")
    place.wait_for(10)
    children = pathlib.Path(
        f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    os.kill(int(children[0]), signal.SIGKILL)
    finish(process)
    assert tables(place.file) == expected, "a dead worker changed the lives"


def test_second_process(place):
    process = relive(place.run)
    place.wait_for(4)
    _, err = finish(relive(place.run), expected=1)
    assert str(process.pid) in err, err
    process.send_signal(signal.SIGKILL)
    process.communicate()


def test_full_disk(place, expected):
    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (60_000, 60_000))
    _, err = finish(relive(place.run, preexec_fn=small_files), expected=1)
    assert "File too large" in err, err
    assert 0 < lives(place.file) < len(expected["life"])
    finish(relive(place.run))
    assert tables(place.file) == expected, "a full disk changed the lives"


def main():
    folder = pathlib.Path(tempfile.mkdtemp(prefix="plsc_relive_"))
    try:
        (folder / "e.yaml").write_text(EXPERIMENT)
        run = folder / "run.sqlite"
        subprocess.run([PLSC, "evolve", folder / "e.yaml", "-o", run, "--quiet"],
                       check=True, stdout=subprocess.DEVNULL)
        straight = Place(folder, run, "straight")
        began = time.monotonic()
        finish(relive(straight.run, "--jobs", "1"))
        seconds = time.monotonic() - began
        expected = tables(straight.file)
        test_kills(Place(folder, run, "killed"), expected, seconds)
        test_signal(Place(folder, run, "asked"), expected)
        test_dead_worker(Place(folder, run, "worker"), expected)
        test_second_process(Place(folder, run, "twice"))
        test_full_disk(Place(folder, run, "full"), expected)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


main()
