#!/usr/bin/env python3
"""A command that fails before it begins leaves nothing behind, so that it is
fine when its cause is mended; and what lies beside an output under the name of
a companion of it is neither used nor touched.

usage: leftovers_test.py PLSC"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # beside the sources
from tiny_files import EXPERIMENT, study

PLSC = str(pathlib.Path(sys.argv[1]).resolve())


def run(folder, *command):
    return subprocess.run([PLSC, *command], cwd=folder, text=True,
                          capture_output=True, timeout=120)


def everything(folder):
    found = {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        if path.is_symlink():
            found[name] = os.readlink(path)
        elif path.is_file():
            found[name] = path.read_bytes()
        else:
            found[name] = None
    return found


def text(path):
    path.write_text("days of somebody's work\n")


def link(path):
    path.symlink_to("victim")


def folder_of(path):
    path.mkdir()


EVOLVE = ["evolve", "e.yaml", "-o", "run.sqlite", "--quiet"]
STUDY_RUN = ["study", "run", "s.yaml", "-o", "study", "--quiet"]

# A command, what is wrong at first, and what it says then.
FAILURES = [
    (EVOLVE + ["--cache", "c.sqlite"], text, "c.sqlite", "c.sqlite"),
    (EVOLVE + ["--cache", "c.sqlite"], folder_of, "c.sqlite", "c.sqlite"),
    (EVOLVE + ["--json-log", "l.json"], folder_of, "l.json", "l.json"),
    (EVOLVE + ["--cache", "c.sqlite", "--json-log", "l.json"], text,
     "run.sqlite-wal", "run.sqlite-wal"),
    (EVOLVE + ["--cache", "c.sqlite", "--json-log", "l.json"], text,
     "c.sqlite-shm", "c.sqlite-shm"),
    (EVOLVE + ["--cache", "c.sqlite", "--json-log", "l.json"], link,
     "run.sqlite-journal", "run.sqlite-journal"),
    (EVOLVE + ["--cache", "c.sqlite", "--json-log", "l.json"], folder_of,
     "run.sqlite", "run.sqlite"),
    (STUDY_RUN + ["--cache", "c.sqlite"], text, "c.sqlite", "c.sqlite"),
    (STUDY_RUN + ["--cache", "c.sqlite"], link, "c.sqlite-wal",
     "c.sqlite-wal"),
    (STUDY_RUN + ["--cache", "c.sqlite"], text, "study", "study"),
]


def check_failure(folder, command, plant, name, named):
    plant(folder / name)
    before = everything(folder)
    failed = run(folder, *command)
    assert failed.returncode == 1, (command, name, failed)
    assert f"'{named}'" in failed.stderr, (command, name, failed.stderr)
    after = everything(folder)
    assert after == before, (command, name, set(after) ^ set(before))
    path = folder / name
    if path.is_dir() and not path.is_symlink():
        path.rmdir()
    else:
        path.unlink()
    done = run(folder, *command)
    assert done.returncode == 0, (command, name, done)


def check_study_companions(folder):
    """A run of a study is refused where another's journal lies; the others'
    results stay."""
    assert run(folder, *STUDY_RUN).returncode == 0
    store = folder / "study" / "one" / "2.sqlite"
    store.unlink()
    text(folder / "study" / "one" / "2.sqlite-wal")
    before = everything(folder)
    failed = run(folder, *STUDY_RUN)
    assert failed.returncode == 1, failed
    assert "2.sqlite-wal' is in the way" in failed.stderr, failed.stderr
    assert everything(folder) == before
    (folder / "study" / "one" / "2.sqlite-wal").unlink()
    assert run(folder, *STUDY_RUN).returncode == 0


def check_salvage_and_neighbours(folder):
    """Nothing that has a neighbour's name is followed, cut or deleted."""
    assert run(folder, *EVOLVE).returncode == 0
    for name in ("again.sqlite.new", "again.sqlite.lock", "study.yaml.1"):
        link(folder / name)
    planted = everything(folder)
    done = run(folder, "evolve", "--salvage", "run.sqlite", "-o",
               "again.sqlite", "--quiet")
    assert done.returncode == 0, done
    after = everything(folder)
    assert {name: after[name] for name in planted} == planted
    text(folder / "more.sqlite-wal")
    failed = run(folder, "evolve", "--salvage", "run.sqlite", "-o",
                 "more.sqlite", "--quiet")
    assert failed.returncode == 1 and "more.sqlite-wal" in failed.stderr, failed


def with_folder(check, *arguments):
    folder = pathlib.Path(tempfile.mkdtemp(prefix="plsc_leftovers_"))
    try:
        (folder / "e.yaml").write_text(EXPERIMENT)
        (folder / "s.yaml").write_text(study(2))
        (folder / "victim").write_text("kept\n")
        check(folder, *arguments)
        assert (folder / "victim").read_text() == "kept\n", arguments
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def main():
    for failure in FAILURES:
        with_folder(check_failure, *failure)
    with_folder(check_study_companions)
    with_folder(check_salvage_and_neighbours)


main()
