#!/usr/bin/env python3
"""A file that may not grow (ulimit -f) is a full disk: every command that
writes says so, exits with 1, and leaves nothing that was not there; and where
it may write, the same command is fine.

usage: limits_test.py PLSC REPOSITORY"""

import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # beside the sources
from tiny_files import EXPERIMENT, study

PLSC = str(pathlib.Path(sys.argv[1]).resolve())
REPOSITORY = pathlib.Path(sys.argv[2]).resolve()


def run(folder, command, limit=None):
    def small_files():
        # Python ignores SIGXFSZ; here it has its default again, which ends a
        # program that does not see to it.
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
    return subprocess.run([PLSC, *command], cwd=folder, text=True,
                          capture_output=True, preexec_fn=small_files,
                          restore_signals=True, timeout=120)


def files(folder):
    return {str(path.relative_to(folder)):
            path.read_bytes() if path.is_file() else None
            for path in folder.rglob("*")}


def make_inputs(folder):
    shutil.copy(REPOSITORY / "examples" / "gecko.pls", folder / "robot.pls")
    (folder / "loose.pls").write_text(
        "\n\n" + (folder / "robot.pls").read_text())
    (folder / "misspelt.pls").write_text(
        (folder / "robot.pls").read_text().replace("add_", "ad_", 1))
    (folder / "e.yaml").write_text(EXPERIMENT)
    (folder / "s.yaml").write_text(study(1))
    for command in (["evolve", "e.yaml", "-o", "run.sqlite", "--quiet"],
                    ["simulate", "robot.pls", "--record", "lives.json"]):
        done = run(folder, command)
        assert done.returncode == 0, done.stderr


COMMANDS = [
    ["evolve", "e.yaml", "-o", "new.sqlite", "--quiet"],
    ["evolve", "e.yaml", "-o", "new.sqlite", "--quiet", "--cache", "c.sqlite"],
    ["evolve", "--salvage", "run.sqlite", "-o", "new.sqlite", "--quiet"],
    ["study", "run", "s.yaml", "-o", "study", "--quiet"],
    ["export", "run.sqlite", "--csv", "tables"],
    ["export", "run.sqlite", "--jsonl", "-o", "run.jsonl"],
    ["export", "robot.pls", "--to", "mjcf", "-o", "robot.xml"],
    ["simulate", "robot.pls", "--record", "new.json"],
    ["simulate", "robot.pls", "--svg", "way.svg"],
    ["develop", "robot.pls", "--svg", "pictures"],
    ["draw", "robot.pls", "-o", "robot.svg"],
    ["report", "run.sqlite", "-o", "report.html"],
    ["relive", "run.sqlite", "--lives", "1", "--quiet"],
    ["random", "--seed", "1", "-o", "new.pls"],
    ["mutate", "robot.pls", "--seed", "1", "-o", "new.pls"],
    ["trim", "robot.pls", "-o", "new.pls"],
    ["test", "robot.pls", "--update"],
    ["fmt", "loose.pls"],
    ["fix", "misspelt.pls"],
    ["man", "--all", "pages"],
]


def check(folder, command):
    before = files(folder)
    refused = run(folder, command, limit=0)
    if "were not built" in refused.stderr:  # pages, without npm
        return
    told = refused.stderr + refused.stdout
    assert refused.returncode == 1, (command, refused)
    assert re.search("cannot (write|create).*File too large", told), (
        command, told)
    after = files(folder)
    changed = [name for name in after if before.get(name, 0) != after[name]]
    # An empty folder that was asked for is no harm.
    changed = [name for name in changed if after[name] is not None]
    assert not changed and not set(before) - set(after), (command, changed)
    done = run(folder, command)
    assert done.returncode == 0, (command, done)
    assert files(folder) != before, command


def main():
    folder = pathlib.Path(tempfile.mkdtemp(prefix="plsc_limits_"))
    try:
        make_inputs(folder)
        saved = files(folder)
        for command in COMMANDS:
            check(folder, command)
            for path in folder.iterdir():  # as it was, for the next
                if path.is_dir():
                    shutil.rmtree(path)
                elif path.name not in saved:
                    path.unlink()
                else:
                    path.write_bytes(saved[path.name])
    finally:
        shutil.rmtree(folder, ignore_errors=True)


main()
