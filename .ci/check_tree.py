#!/usr/bin/env python3
"""Checks of the source tree that no compiler makes: includes follow the
architecture's arrows, which go one way; each library stays behind its door;
few sources see what is dear to compile; every source has a test of its name
(or a reason in tests/exempt.txt), every test is built, every folder says what
it is for."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# The rooms, the lowest first: folder -> the folders above it in this list that
# it may include from (docs/architecture.md). A room may include itself.
ARROWS = {
    "grammar": "",
    "compiler": "grammar",
    "compiler/changes": "compiler grammar",
    "sim/maths": "",
    "sim": "sim/maths",
    "sim/ode": "sim",
    "sim/articulated": "sim sim/maths",
    "runtime/text": "compiler/changes grammar",
    "runtime/formula": "runtime/text grammar sim/maths",
    "runtime/workers": "",
    "runtime/server": "grammar",
    "runtime/authors": "compiler grammar",
    "runtime/develop": "runtime/text compiler grammar sim sim/maths",
    "runtime/scenario": "runtime/formula runtime/text compiler grammar sim",
    "runtime/life": "runtime/develop runtime/scenario runtime/formula runtime/text compiler grammar sim",
    "runtime/compare": "runtime/develop runtime/text compiler compiler/changes grammar sim",
    "runtime/recording": "runtime/life runtime/scenario runtime/text grammar sim",
    "runtime/advice": "runtime/compare runtime/develop runtime/text compiler grammar sim",
    "runtime/vary": "compiler grammar sim/maths",
    "runtime/evolve": "runtime/vary runtime/life runtime/scenario runtime/develop runtime/workers runtime/formula runtime/text compiler grammar sim",
    "runtime/pictures": "runtime/recording runtime/compare runtime/develop runtime/text compiler grammar sim",
    "runtime/exports": "runtime/recording runtime/life runtime/scenario runtime/text grammar sim sim/maths",
    "runtime/store": "runtime/evolve runtime/vary runtime/life runtime/scenario runtime/develop runtime/text compiler grammar sim",
    "runtime/relive": "runtime/store runtime/evolve runtime/vary runtime/life runtime/scenario runtime/develop runtime/text compiler grammar sim",
    "runtime/history": "runtime/pictures runtime/compare runtime/develop runtime/text compiler grammar sim",
    "runtime/study": "runtime/store runtime/evolve runtime/formula runtime/text grammar",
    "runtime/report": "runtime/study runtime/relive runtime/store runtime/evolve runtime/vary runtime/pictures runtime/life runtime/scenario runtime/develop runtime/text compiler grammar sim",
    "runtime/lsp": "runtime/advice runtime/text compiler grammar",
    "runtime/service": "runtime/lsp runtime/history runtime/pictures runtime/recording runtime/advice runtime/compare runtime/life runtime/scenario runtime/develop runtime/text compiler/changes compiler grammar sim",
    "runtime/web": "runtime/service runtime/text",
    "runtime/pages": "runtime/text",
    "runtime/cli/explanations": "grammar",
    "runtime/cli/diagnostics": "runtime/cli/explanations *",
    "runtime/cli/files": "runtime/cli/diagnostics *",
    "runtime/cli/arguments": "runtime/cli/files *",
    "runtime/cli/running": "runtime/cli/files *",
    "runtime/cli/live": "runtime/cli/files *",
    "runtime/cli/robots": "runtime/cli/running runtime/cli/files *",
    "runtime/cli/testing": "runtime/cli/files *",
    "runtime/cli/commands": "runtime/cli/explanations runtime/cli/diagnostics runtime/cli/files runtime/cli/arguments runtime/cli/running runtime/cli/live runtime/cli/robots runtime/cli/testing *",
    "runtime/cli": "runtime/cli/arguments runtime/cli/files *",
}
# Library -> where its headers may be included.
DOORS = {
    r"tao/pegtl": r"grammar/",
    r"ode/": r"sim/ode/",
    r"yaml-cpp/": r"runtime/text/yaml_[a-z_]*\.(h|cc)",
    r"CLI/": r"runtime/cli/arguments/(options|arguments|description)\.cc",
    r"Random123/": r"runtime/vary/rng\.cc",
    r"sqlite3\.h": r"runtime/store/database\.cc",
    r"xxhash\.h": r"runtime/text/key\.cc",
    r"(librsvg/|cairo\.h|glib)": r"runtime/cli/files/png\.cc",
    r"boost/": r"runtime/server/http_server\.cc",
    r"mpi\.h": r"runtime/workers/mpi_[a-z_]*\.cc",
    r"charconv": r"grammar/number\.cc",
}
# What reads numbers with the language of the system, or not all of a text.
NUMBER_READERS = re.compile(r"\b(strto(d|f|ld|l|ll|ul|ull)|sto(d|f|ld|i|l|ll|ul|ull)|sscanf)\(")
# The rooms that build alone (preset core): as a page's module, too, which has
# no threads, files, clocks or processes.
CORE = """grammar compiler compiler/changes sim/maths sim sim/ode
sim/articulated runtime/text runtime/formula runtime/authors
runtime/develop runtime/scenario runtime/life runtime/compare runtime/recording
runtime/advice runtime/vary runtime/pictures runtime/history
runtime/lsp runtime/service runtime/web""".split()
NOT_IN_CORE = re.compile(
    r"(barrier|chrono|condition_variable|csignal|cstdio|ctime|filesystem|fstream|"
    r"future|iostream|latch|mutex|random|semaphore|shared_mutex|stop_token|thread|"
    r"(dirent|dlfcn|fcntl|poll|pthread|signal|spawn|stdio|time|unistd|mpi|sqlite3)"
    r"\.h|(sys|CLI)/.*)$")
# What is private to another concept: its source's second header.
PRIVATE = {"sim/ode/ode_contacts": "sim/ode/ode_engine"}
# What is dear to compile -> the most sources of the product and of tests that
# may see it, through any number of headers.
MOST_REACHED = {"Eigen/": (60, 70)}
MOST_CONCEPTS = 40  # of a folder: what one can look over
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


def allowed(folder):
    """Where a folder's files may include from; `*` is all that is no command."""
    names = ARROWS[folder].split()
    if "*" in names:
        names += [f for f in ARROWS if not f.startswith("runtime/cli")]
    return {folder, *names} - {"*"}


def check_arrows(problems):
    """The list itself: nothing points upward, so nothing goes in a circle."""
    above = set()
    for folder in ARROWS:
        for name in sorted(allowed(folder) - {folder}):
            if name not in ARROWS:
                problems.append(f"ARROWS: {folder} names {name}, which is no room")
            elif name not in above:
                problems.append(f"ARROWS: {folder} points up to {name}")
        above.add(folder)


def check_core(problems):
    """The core is closed, and is what the preset builds."""
    for folder in CORE:
        for name in sorted(allowed(folder) - set(CORE)):
            problems.append(f"CORE: {folder} may include {name}, which is no part of it")
    built = (ROOT / "runtime/CMakeLists.txt").read_text().partition("PLSC_CORE_ONLY")[0]
    for folder in ARROWS:
        room = re.fullmatch(r"runtime/(\w+)", folder)
        if room and bool(re.search(rf"\b{room[1]}\b", re.sub("#.*", "", built))) != (
                folder in CORE):
            problems.append(f"CORE: {folder} and runtime/CMakeLists.txt disagree")


def check_includes(problems):
    for source in SOURCES:
        name = source.relative_to(ROOT).as_posix()
        folder = folder_of(name)
        if folder is None or source.parent.relative_to(ROOT).as_posix() != folder:
            if not name.startswith("runtime/package/"):
                problems.append(f"{name}: stands in no room of ARROWS")
            continue
        text = source.read_text()
        if found := NUMBER_READERS.search(text):
            problems.append(f"{name}: {found[0]}) belongs behind grammar/number.h")
        for include in INCLUDE.findall(text):
            if folder in CORE and NOT_IN_CORE.match(include):
                problems.append(f"{name}: <{include}> is not in a core room")
            target = folder_of(include)
            if target is not None and target not in allowed(folder):
                problems.append(f"{name}: {folder}/ must not include {include}")
            for library, door in DOORS.items():
                if re.match(library, include) and not re.match(door, name):
                    problems.append(f"{name}: <{include}> belongs behind {door}")


def concept_of(path):
    """x.h and x.cc are one concept, and so is what is private to it."""
    stem = path.rpartition(".")[0]
    return PRIVATE.get(stem, stem)


def check_concepts(problems):
    """Within the rooms: no two concepts include each other, directly or through
    others, and no room has too many."""
    uses = {}
    for source in SOURCES:
        name = source.relative_to(ROOT).as_posix()
        concept = concept_of(name)
        uses.setdefault(concept, set()).update(
            concept_of(i) for i in INCLUDE.findall(source.read_text())
            if folder_of(i) is not None)
        uses[concept].discard(concept)
    state = {}

    def visit(concept, path):
        if state.get(concept) == "done":
            return
        if state.get(concept) == "open":
            circle = path[path.index(concept):] + [concept]
            problems.append("includes in a circle: " + " -> ".join(circle))
            return
        state[concept] = "open"
        for used in sorted(uses.get(concept, ())):
            visit(used, path + [concept])
        state[concept] = "done"

    for concept in sorted(uses):
        visit(concept, [])
    for folder in ARROWS:
        count = sum(1 for c in uses if c.rpartition("/")[0] == folder)
        if count > MOST_CONCEPTS and folder != "runtime/cli/commands":
            problems.append(f"{folder}: {count} concepts, more than {MOST_CONCEPTS}")


def check_reach(problems):
    """Headers stay light: few sources see what takes long to compile."""
    includes, seen = {}, {}

    def sees(path, library):
        if (path, library) not in seen:
            seen[path, library] = False
            if path not in includes:
                includes[path] = INCLUDE.findall(path.read_text())
            # As the compiler finds them; the tests' own folder comes second.
            files = (next((base / i for base in (ROOT, ROOT / "tests")
                           if (base / i).is_file()), None)
                     for i in includes[path])
            seen[path, library] = any(
                i.startswith(library) for i in includes[path]) or any(
                    [sees(f, library) for f in files if f])
        return seen[path, library]

    tests = sorted((ROOT / "tests").rglob("*.cc"))
    product = [p for p in SOURCES if p.suffix == ".cc"]
    for library, most in MOST_REACHED.items():
        for kind, sources, limit in zip(("product", "test"), (product, tests), most):
            count = sum(sees(p, library) for p in sources)
            if count > limit:
                problems.append(f"{library} reaches {count} {kind} sources, more than {limit}")


def check_table(problems):
    """docs/architecture.md shows these rooms, in this order, with their arrows."""
    rows = re.findall(r"^\| `([a-z/]+)/` \|.*\| ([^|]+) \|$",
                      (ROOT / "docs/architecture.md").read_text(), re.MULTILINE)

    def short(name):
        return "all before cli" if name == "*" else name.removeprefix("runtime/")

    wanted = [(short(folder), ", ".join(map(short, names.split())) or "-")
              for folder, names in ARROWS.items()]
    if [room for room, _ in rows] != [room for room, _ in wanted]:
        problems.append("docs/architecture.md: the table's rooms are not those of ARROWS")
        return
    for (room, shown), (_, names) in zip(rows, wanted):
        if set(shown.split(", ")) != set(names.split(", ")):
            problems.append(f"docs/architecture.md: {room}/ may include: {names}")


def check_paths(problems):
    """Documents name files, folders and concepts that exist."""
    path = re.compile(r"(?<![\w/.-])(?:grammar|compiler|sim|runtime|tests)/[\w/.*-]+")
    example = ("a/b", "tests/a/b", "tests/fuzz/corpus/TARGET")
    for document in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md"),
                     *(f / "README.md" for f in {s.parent for s in SOURCES})]:
        if not document.exists() or "node_modules" in document.parts:
            continue
        text = document.read_text()
        for found in re.findall(r"`([a-z_/]+/[a-z_]+\.(?:h|cc))`", text):
            bases = ("", "runtime")
            if not found.startswith(example) and not any((ROOT / b / found).exists() for b in bases):
                problems.append(f"{document.relative_to(ROOT)}: there is no {found}")
        for found in sorted(set(path.findall(text))):
            name = found.rstrip("./-")
            if name.startswith(example) or any(ROOT.glob(name)) or any(ROOT.glob(name + ".*")):
                continue
            problems.append(f"{document.relative_to(ROOT)}: there is no {name}")


def check_commands(problems):
    """A command joins at one place: nothing but the registry names commands of
    several groups, neither their structs nor their words."""
    arguments = ROOT / "runtime/cli/arguments"
    groups = {}
    for header in sorted(arguments.glob("*.h")):
        for struct in re.findall(r"^struct (\w+Command) \{", header.read_text(), re.M):
            groups[struct] = header.stem
        source = header.with_suffix(".cc")
        for word in re.findall(r'(?:\.Command\(|AddToStudy\(options, )\s*"(\w+)"',
                               source.read_text() if source.exists() else ""):
            groups[f'"{word}"'] = header.stem
    if len(groups) < 2 * 30:
        problems.append("check_commands: finds no commands in runtime/cli/arguments")
    registry = (arguments / "registry.cc").read_text()
    for struct in groups:
        if not struct.startswith('"') and not re.search(rf"\b{struct}\b", registry):
            problems.append(f"{struct}: is not registered in runtime/cli/arguments/registry.cc")
    for source in SOURCES:
        # The service's questions are often called as the command that answers
        # them at a terminal.
        if source in (arguments / "registry.cc", ROOT / "runtime/service/asks.cc"):
            continue
        text = re.sub(r"//.*", "", source.read_text())
        for kind, most in (("struct", 1), ("word", 2)):
            named = sorted({groups[w] for w in re.findall(r'\w+Command\b|"\w+"', text)
                            if w in groups and w.startswith('"') == (kind == "word")})
            if len(named) > most:
                problems.append(f"{source.relative_to(ROOT)}: names commands of {', '.join(named)}: "
                                "the list of commands is registry.cc")


def check_folders(problems):
    """Every folder says what is in it, and what is not."""
    for base in ("grammar", "compiler", "sim", "runtime", "tests"):
        folders = {p.parent for p in (ROOT / base).rglob("*")
                   if p.suffix in (".h", ".cc", ".py", ".mjs")}
        for folder in sorted(folders):
            name = folder.relative_to(ROOT).as_posix()
            if name.startswith(("runtime/pages/src/", "runtime/package/forward")):
                continue
            if not (folder / "README.md").exists():
                problems.append(f"{name}/: no README.md")


def check_lists(problems):
    """Every test is built: it stands in exactly one CMake list."""
    lists = {}
    for file in sorted((ROOT / "tests").rglob("CMakeLists.txt")):
        for word in re.findall(r"[\w./]+_test\.cc", file.read_text()):
            path = (file.parent / word).resolve()
            lists.setdefault(path, []).append(file.relative_to(ROOT).as_posix())
    for test in sorted((ROOT / "tests").rglob("*_test.cc")):
        found = lists.pop(test, [])
        if len(found) != 1:
            problems.append(f"{test.relative_to(ROOT)}: stands in {len(found)} CMake lists")
    for path, files in lists.items():
        problems.append(f"{files[0]}: {path} does not exist")


def check_mirror(problems):
    exempt = {}
    for line in (ROOT / "tests/exempt.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            path, _, reason = line.partition(": ")
            if path in exempt:
                problems.append(f"tests/exempt.txt: {path} stands there twice")
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
    check_arrows(problems)
    check_core(problems)
    check_includes(problems)
    check_concepts(problems)
    check_reach(problems)
    check_table(problems)
    check_paths(problems)
    check_commands(problems)
    check_folders(problems)
    check_lists(problems)
    check_mirror(problems)
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
