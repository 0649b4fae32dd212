#!/usr/bin/env python3
"""Runs everything that README.md and the documents in docs/ show: each genotype
of a `pls` block is a file of its name, each `yaml` block that begins with such a
comment as `# study.yaml` is that file, and each `$ command` of a console block
is run in one folder a document and its output compared. README.md and
docs/optimisers.md are typed into one shell in a fresh copy of the repository
instead (typed.py), with nothing there that the copy has not.
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

import typed

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


def run_document(text, repository, env, pages):
    """Runs its commands in a folder of its own: (commands, failures)."""
    ran = failures = 0
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        for name, content in programs(text).items():
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
            failures += not told(command, expected, done.stdout)
    return ran, failures


def told(command, expected, actual):
    """Whether the output is the shown one; prints both if not."""
    if matches(expected, actual):
        return True
    print(f"$ {command}\nshown:\n{expected}\nprinted:\n{actual}")
    return False


def run_typed(text, before, plsc, repository, pages):
    """The same in a fresh copy, after the commands `before`."""
    shown = [c for b in blocks(text, "console") for c in commands(b)
             if pages or not MAKES_PAGE.search(c[0])]
    outputs = typed.run(before + [c for c, _ in shown], plsc, repository)
    failures = sum(not told(command, expected, output) for (command, expected), output
                   in zip(shown, outputs[len(before):]))
    return len(shown), failures


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


def broken_tour(readme, repository):
    """Files of the tour that are not as the README shows them."""
    for name, content in programs(readme).items():
        shipped = repository / "examples" / "tour" / name
        if not shipped.exists() or shipped.read_text() != content:
            yield f"README shows another {name} than examples/tour has"


def main():
    plsc, repository = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
    pages = sys.argv[3:] != ["--no-pages"]
    env = dict(os.environ, PATH=f"{plsc.parent}:{os.environ['PATH']}")
    readme = (repository / "README.md").read_text()
    total, failures = run_typed(readme, [], plsc, repository, pages)
    # The line that lets the shell find plsc.
    path_line = [commands(blocks(readme, "console")[0])[0][0]]
    for document in sorted((repository / "docs").rglob("*.md")):
        if "node_modules" in document.parts:  # of the VS Code extension
            continue
        text = document.read_text()
        if document.name == "optimisers.md":
            ran, failed = run_typed(text, path_line, plsc, repository, pages)
        else:
            ran, failed = run_document(text, repository, env, pages)
        total += ran
        failures += failed
    for problem in [*broken_tour(readme, repository), *typed.broken_recipes(plsc, repository)]:
        failures += 1
        print(problem)
    for name in broken_references(readme, repository):
        failures += 1
        print(f"README names {name}, which is not there or cannot be run")
    print(f"{total} commands, {failures} failures")
    # Fewer than are there today: a fence that this does not find any more.
    return 1 if failures or total < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
