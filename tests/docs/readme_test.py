#!/usr/bin/env python3
"""Runs everything that README.md and docs/development.md show: each document's
genotype is a file, and each `$ command` of a console block is run in one folder
and its output compared.
`...` in the shown output stands for anything, also at the end of a line.

usage: readme_test.py PLSC REPOSITORY
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

# A short experiment, so that the tour's last command takes a second.
TINY = """plsc_experiment: 1
population: 4
offspring: 4
generations: 2
scenario:
  seasons:
    - {name: flat, terrain: flat, duration: 1 s, senses: {inclined: False}}
"""


def blocks(text, language):
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.M | re.S)


def commands(block):
    """[(command, expected output)] of a console block."""
    result = []
    for line in block.splitlines(keepends=True):
        if line.startswith("$ "):
            result.append([line[2:].strip(), ""])
        else:
            result[-1][1] += line
    return result


def matches(expected, actual):
    pattern = re.escape(expected.strip("\n")).replace(re.escape("..."), ".*")
    return re.fullmatch(pattern, actual.strip("\n"), re.S) is not None


def main():
    plsc, repository = map(pathlib.Path, sys.argv[1:])
    readme = (repository / "README.md").read_text()
    development = (repository / "docs/development.md").read_text()
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "shy.pls").write_text(blocks(readme, "pls")[0])
        (work / "worked.pls").write_text(blocks(development, "pls")[0])
        (work / "tiny.yaml").write_text(TINY)
        (work / "examples").symlink_to(repository / "examples")
        env = dict(os.environ, PATH=f"{plsc.parent}:{os.environ['PATH']}")
        shown = [c for text in (readme, development)
                 for block in blocks(text, "console") for c in commands(block)]
        for command, expected in shown:
            ran = subprocess.run(command, shell=True, cwd=work, env=env, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            if not matches(expected, ran.stdout):
                failures += 1
                print(f"$ {command}\nshown:\n{expected}\nprinted:\n{ran.stdout}")
        for script in re.findall(r"^(\S+\.sh)", blocks(readme, "sh")[0], re.M):
            if not os.access(repository / script, os.X_OK):
                failures += 1
                print(f"{script} is not there or cannot be run")
        for link in re.findall(r"\]\(([^)#]+)\)", readme):
            if not (repository / link).exists():
                failures += 1
                print(f"README links to {link}, which is not there")
    print(f"{len(shown)} commands, {failures} failures")
    return 1 if failures or len(shown) < 8 else 0


if __name__ == "__main__":
    sys.exit(main())
