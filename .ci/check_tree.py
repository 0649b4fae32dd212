#!/usr/bin/env python3
"""Checks of the source tree that no compiler makes: includes follow the
architecture's arrows, each library stays behind its door, every source has a
test of its name (or a reason in tests/exempt.txt)."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Folder -> folders that it may include from (docs/architecture.md).
ARROWS = {
    "grammar": {"grammar"},
    "compiler": {"compiler", "grammar"},
    "sim": {"sim"},
    "runtime": {"runtime", "compiler", "grammar", "sim"},
    "runtime/evolve": {"runtime/evolve", "runtime", "compiler", "grammar", "sim"},
    "runtime/store": {"runtime/store", "runtime/evolve", "runtime", "compiler", "grammar", "sim"},
    "runtime/study": {"runtime/study", "runtime/store", "runtime/evolve", "runtime", "compiler", "grammar", "sim"},
    "runtime/report": {"runtime/report", "runtime/study", "runtime/store", "runtime/evolve", "runtime", "compiler", "grammar", "sim"},
    "runtime/exports": {"runtime/exports", "runtime", "compiler", "grammar", "sim"},
    "runtime/lsp": {"runtime/lsp", "runtime", "compiler", "grammar"},
    "runtime/pages": {"runtime/pages", "runtime"},
    "runtime/cli": {"runtime/cli", "runtime/exports", "runtime/lsp", "runtime/report", "runtime/pages", "runtime/study", "runtime/store", "runtime/evolve", "runtime", "compiler", "grammar", "sim"},
}
# Library -> where its headers may be included.
DOORS = {
    r"tao/pegtl": r"grammar/",
    r"ode/": r"sim/",
    r"yaml-cpp/": r"runtime/yaml_[a-z_]*\.(h|cc)",
    r"CLI/": r"runtime/cli/arguments[a-z_]*\.cc",
    r"Random123/": r"runtime/evolve/rng\.cc",
    r"sqlite3\.h": r"runtime/store/database\.cc",
    r"xxhash\.h": r"runtime/key\.cc",
    r"Rmath\.h": r"runtime/report/wilcoxon\.cc",
    r"mpi\.h": r"runtime/evolve/mpi_[a-z_]*\.cc",
}
INCLUDE = re.compile(r'^#include [<"]([^>"]+)[>"]', re.MULTILINE)
SOURCES = [p for f in ("grammar", "compiler", "sim", "runtime")
           for p in sorted((ROOT / f).rglob("*")) if p.suffix in (".h", ".cc")]


def folder_of(path):
    """The most specific architecture folder that holds a repository path."""
    best = None
    for folder in ARROWS:
        if path.startswith(folder + "/") and (best is None or len(folder) > len(best)):
            best = folder
    return best


def check_includes(problems):
    for source in SOURCES:
        name = source.relative_to(ROOT).as_posix()
        folder = folder_of(name)
        for include in INCLUDE.findall(source.read_text()):
            target = folder_of(include)
            if target is not None and target not in ARROWS[folder]:
                problems.append(f"{name}: {folder}/ must not include {include}")
            for library, door in DOORS.items():
                if re.match(library, include) and not re.match(door, name):
                    problems.append(f"{name}: <{include}> belongs behind {door}")


def check_mirror(problems):
    exempt = {}
    for line in (ROOT / "tests/exempt.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            path, _, reason = line.partition(": ")
            exempt[path] = reason
            if not reason:
                problems.append(f"tests/exempt.txt: {path} has no reason")
    for source in SOURCES:
        if source.suffix != ".cc":
            continue
        name = source.relative_to(ROOT)
        test = ROOT / "tests" / name.parent / f"{name.stem}_test.cc"
        has_test = test.exists()
        if has_test == (name.as_posix() in exempt):
            problems.append(
                f"{name}: has a test and an exemption" if has_test else
                f"{name}: no {test.relative_to(ROOT)} and no line in tests/exempt.txt")
    for path in exempt:
        if not (ROOT / path).exists():
            problems.append(f"tests/exempt.txt: {path} does not exist")


def main():
    problems = []
    check_includes(problems)
    check_mirror(problems)
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
