#!/usr/bin/env python3
"""Runs everything that README.md and the documents in docs/ show: each genotype
of a `pls` block is a file of its name, each `yaml` block that begins with such a
comment as `# study.yaml` is that file, and each `$ command` of a console block
is run in one folder a document and its output compared.
`...` in the shown output stands for anything, also at the end of a line.

usage: readme_test.py PLSC REPOSITORY [--no-pages]

With --no-pages, of a program built without npm, commands that make HTML
pages are left out.
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


def programs(text):
    """{file name: text} of the document's blocks that have a name."""
    result = {}
    for program in blocks(text, "pls"):
        name = re.search(r"^genotype (\w+)", program, re.M)
        if name:
            result[name[1] + ".pls"] = program
    for block in blocks(text, "yaml"):
        name = re.match(r"# (\w+\.yaml)\n", block)
        if name:
            result[name[1]] = block
    return result


MAKES_PAGE = re.compile(r"plsc (view|report) .*-o ")


def run_document(text, files, repository, env, pages):
    """Runs its commands in a folder of its own: (commands, failures)."""
    ran = failures = 0
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        for name, content in {**programs(text), **files}.items():
            (work / name).write_text(content)
        (work / "examples").symlink_to(repository / "examples")
        shown = [c for b in blocks(text, "console") for c in commands(b)]
        for command, expected in shown:
            if not pages and MAKES_PAGE.search(command):
                continue
            done = subprocess.run(command, shell=True, cwd=work, env=env,
                                  text=True, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT)
            ran += 1
            if not matches(expected, done.stdout):
                failures += 1
                print(f"$ {command}\nshown:\n{expected}\nprinted:\n{done.stdout}")
    return ran, failures


def broken_references(readme, repository):
    """Scripts and files that the README names and that are not there."""
    result = []
    for script in re.findall(r"^(\S+\.sh)", blocks(readme, "sh")[0], re.M):
        if not os.access(repository / script, os.X_OK):
            result.append(script)
    for link in re.findall(r"\]\(([^)#]+)\)", readme):
        if not (repository / link).exists():
            result.append(link)
    return result


def main():
    plsc, repository = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
    pages = sys.argv[3:] != ["--no-pages"]
    env = dict(os.environ, PATH=f"{plsc.parent}:{os.environ['PATH']}")
    readme = (repository / "README.md").read_text()
    total, failures = run_document(readme, {"tiny.yaml": TINY}, repository, env, pages)
    for document in sorted((repository / "docs").rglob("*.md")):
        if "node_modules" in document.parts:  # of the VS Code extension
            continue
        ran, failed = run_document(document.read_text(), {}, repository, env, pages)
        total += ran
        failures += failed
    for name in broken_references(readme, repository):
        failures += 1
        print(f"README names {name}, which is not there or cannot be run")
    print(f"{total} commands, {failures} failures")
    # Fewer than are there today: a fence that this does not find any more.
    return 1 if failures or total < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
