#!/usr/bin/env python3
"""A run of evolution is killed at random instants, again and again, and goes
on each time; its result tables must be those of a run never interrupted, bit
for bit. Also: signals that ask, a dead worker, a second process, a full disk.

usage: kill_test.py PLSC [KILLS]"""

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
KILLS = int(sys.argv[2]) if len(sys.argv) > 2 else 60

EXPERIMENT = """plsc_experiment: 1
name: killed
seed: 11
population: 10
offspring: 10
generations: 6
scenario:
  seasons:
    - {name: flat, terrain: flat, duration: 3 s}
    - {name: tilted, terrain: {tilted: 5 deg}, duration: 3 s}
    - {name: again, terrain: flat, duration: 3 s}
"""

# Of every robot three lives a season, each a row.
TRIED = EXPERIMENT.replace("name: killed", "name: tried").replace(
    "scenario:", "profile: swift\nfitness: speed - 0.001 * energy\ntrials: 3\nown_lives: True\n"
    "noise: {start_height: 30 um, motor: 1 deg}\nscenario:")


def tables(path):
    """All result tables as text; what depends on the clock is in `session`."""
    with contextlib.closing(
            sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as store:
        names = [row[0] for row in store.execute(
            "SELECT name FROM sqlite_master WHERE type = 'table' "
            "AND name NOT LIKE 'sqlite_%' AND name != 'session' ORDER BY name")]
        assert "evaluation" in names and "individual" in names, names
        dump = []
        for name in names:
            rows = [repr(row) for row in store.execute(f"SELECT * FROM {name}")]
            dump.append(f"{name}: {len(rows)}\n" + "\n".join(sorted(rows)))
    return "\n".join(dump)


def evolve(*arguments, **options):
    return subprocess.Popen([PLSC, "evolve", *map(str, arguments), "--quiet"],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            text=True, **options)


def finish(*arguments, expected=0, **options):
    process = evolve(*arguments, **options)
    out, err = process.communicate(timeout=300)
    assert process.returncode == expected, (process.returncode, out, err)
    return err


def children_of(pid):
    text = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text()
    return [int(child) for child in text.split()]


def wait_for(condition, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "it did not happen in time"
        os.sched_yield()


def evaluations(path):
    try:
        with contextlib.closing(
            sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as store:
            return store.execute("SELECT count(*) FROM evaluation").fetchone()[0]
    except sqlite3.OperationalError:
        return 0


def test_kills(folder, experiment, wanted):
    """SIGKILL at instants spread over the whole run, from the first file access
    on: several times in each."""
    straight = folder / f"{experiment.stem}.sqlite"
    began = time.monotonic()
    finish(experiment, "-o", straight, "--jobs", "1")
    seconds = time.monotonic() - began
    expected = tables(straight)
    chance = random.Random(5)
    kills = runs = 0
    while kills < wanted:
        runs += 1
        path = folder / f"{experiment.stem}_killed{runs}.sqlite"
        finished = False
        while not finished:
            process = evolve(experiment, "-o", path, "--or-resume")
            try:
                process.wait(timeout=chance.uniform(0, seconds / 3)
                             if kills < wanted else None)
                finished = True
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
                kills += 1
            out, err = process.communicate()
            assert not finished or process.returncode == 0, (out, err)
        assert tables(path) == expected, f"run {runs} differs"
    print(f"{kills} kills in {runs} runs: equal tables")
    return expected


def test_signals(folder, experiment, expected):
    """Those who ask get a clean end within two seconds, and a hint."""
    for number in (signal.SIGINT, signal.SIGTERM):
        path = folder / f"asked{number}.sqlite"
        process = evolve(experiment, "-o", path)
        wait_for(lambda: evaluations(path) >= 10)
        asked = time.monotonic()
        process.send_signal(number)
        out, err = process.communicate(timeout=60)
        assert process.returncode == 130, (process.returncode, err)
        print(f"signal {number}: ended after {time.monotonic() - asked:.2f} s")
        assert f"plsc evolve --resume {path}" in err, err
        with contextlib.closing(sqlite3.connect(path)) as store:
            how = store.execute("SELECT how FROM session").fetchall()
        assert how == [("stopped",)], how
        finish("--resume", path)
        assert tables(path) == expected, f"signal {number} changed the results"


def test_dead_worker(folder, experiment, expected):
    path = folder / "worker.sqlite"
    process = evolve(experiment, "-o", path, "--jobs", "2")
    wait_for(lambda: evaluations(path) >= 10)
    os.kill(children_of(process.pid)[0], signal.SIGKILL)
    out, err = process.communicate(timeout=300)
    assert process.returncode == 0, err
    assert tables(path) == expected, "a dead worker changed the results"


def test_second_process(folder, experiment):
    path = folder / "twice.sqlite"
    process = evolve(experiment, "-o", path)
    wait_for(lambda: evaluations(path) >= 2)
    err = finish("--resume", path, expected=1)
    assert str(process.pid) in err, err
    process.send_signal(signal.SIGKILL)
    process.communicate()


def test_other_names(folder, experiment, expected):
    """Whatever a second process calls the store, and whatever is removed."""
    path = folder / "named.sqlite"
    process = evolve(experiment, "-o", path)
    wait_for(lambda: evaluations(path) >= 2)
    (folder / "soft.sqlite").symlink_to(path)
    os.link(path, folder / "hard.sqlite")
    (folder / "named.sqlite.lock").unlink(missing_ok=True)
    for name in ("named.sqlite", "soft.sqlite", "hard.sqlite"):
        err = finish("--resume", folder / name, expected=1)
        assert f"in use by process {process.pid}" in err, err
    (folder / "hard.sqlite").unlink()
    out, err = process.communicate(timeout=300)
    assert process.returncode == 0, err
    assert tables(path) == expected, "a second process changed the results"


def test_lost(folder, experiment, expected):
    """A store that is deleted, moved or replaced under its run, and a study's
    folder: each ends with the reason, and what is elsewhere is whole."""
    other = folder / "other.sqlite"
    shutil.copy(folder / "straight.sqlite", other)
    moved = folder / "moved.sqlite"
    path = folder / "lost.sqlite"

    def delete():
        path.unlink()

    def move():
        path.rename(moved)

    def replace():
        other.rename(path)

    def delete_journal():
        (folder / "lost.sqlite-wal").unlink()

    for lose in (delete, move, delete_journal, replace):
        process = evolve(experiment, "-o", path)
        wait_for(lambda: evaluations(path) >= 2)
        lose()
        out, err = process.communicate(timeout=60)
        assert process.returncode == 1, (lose, process.returncode, out, err)
        assert "deleted, moved or replaced" in err, (lose, err)
        assert "--resume" not in err, (lose, err)
        left = sorted(one.name for one in folder.glob("lost.sqlite*"))
        assert left == ([] if lose in (delete, move) else ["lost.sqlite"]), (
            lose, left)
        if lose == delete_journal:
            finish("--resume", path)
            assert tables(path) == expected, "a lost journal changed results"
            for one in folder.glob("lost.sqlite*"):  # who reads leaves some
                one.unlink()
    assert tables(path) == expected, "a store that came instead was changed"
    finish("--resume", moved)
    assert tables(moved) == expected, "moving changed the results"


def test_limits(folder, experiment, expected):
    """A file that may not grow, then a file system that is full."""
    def small_files():  # SIGXFSZ ends who does not see to it
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
        resource.setrlimit(resource.RLIMIT_FSIZE, (300_000, 300_000))
    path = folder / "limit.sqlite"
    err = finish(experiment, "-o", path, expected=1, preexec_fn=small_files)
    assert "error: cannot" in err and "limit.sqlite" in err, err
    finish("--resume", path)
    assert tables(path) == expected, "a limit changed the results"

    disk = folder / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=400k", "tmpfs", str(disk)]
    if os.geteuid() != 0 or subprocess.run(mount, capture_output=True).returncode:
        print("full disk: skipped, cannot mount")
        return
    try:
        path = disk / "run.sqlite"
        err = finish(experiment, "-o", path, expected=1)
        assert "no space left" in err.lower(), err
        assert f"plsc evolve --resume {path}" in err, err
        err = finish("--resume", path, expected=1)
        assert "no space left" in err.lower(), err
        subprocess.run(["mount", "-o", "remount,size=20m", str(disk)], check=True)
        finish("--resume", path)
        assert tables(path) == expected, "a full disk changed the results"
        subprocess.run(["mount", "-o", "remount,ro", str(disk)], check=True)
        err = finish(experiment, "-o", disk / "other.sqlite", expected=1)
        assert "Read-only file system" in err, err
        print("full disk: told, and gone on with")
    finally:
        subprocess.run(["umount", "-l", str(disk)], check=True)


def main():
    folder = pathlib.Path(tempfile.mkdtemp(prefix="plsc_kill_"))
    try:
        experiment = folder / "straight.yaml"
        experiment.write_text(EXPERIMENT)
        expected = test_kills(folder, experiment, KILLS)
        tried = folder / "tried.yaml"
        tried.write_text(TRIED)
        assert "trial: 540\n" in test_kills(folder, tried, KILLS // 4)
        test_signals(folder, experiment, expected)
        test_dead_worker(folder, experiment, expected)
        test_second_process(folder, experiment)
        test_other_names(folder, experiment, expected)
        test_lost(folder, experiment, expected)
        test_limits(folder, experiment, expected)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


main()
