#!/usr/bin/env python3
"""What `cmake --install` leaves is enough for other projects: all installed
headers compile, examples/embed builds against it with find_package and
says of a robot what plsc says, and so does its source as it was first
published, with the header names of that time.

usage: install_test.py BUILD REPOSITORY CMAKE CXX
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import runpath


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def check_headers(prefix, folder, cxx):
    root = prefix / "include/plsc"
    headers = sorted(str(path.relative_to(root)) for path in root.rglob("*.h"))
    for wanted in ("compiler/compile.h", "sim/simulate.h", "grammar/result.h",
                   "runtime/develop/develop.h", "runtime/life/evaluation.h",
                   "runtime/life/season_json.h",
                   # What docs/library.md and its example named at first.
                   "runtime/develop.h", "runtime/evaluation.h",
                   "runtime/scenario.h", "runtime/scenario_profile.h",
                   "runtime/formats/season_json.h"):
        assert wanted in headers, wanted
    assert "grammar/rules.h" not in headers  # would need PEGTL
    source = folder / "headers.cc"
    # A few processes rather than a hundred: in an order and in its reverse, so
    # that none is only right behind another.
    for order in (headers, headers[::-1]):
        source.write_text("".join(f'#include "{header}"\n' for header in order))
        run(cxx, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror",
            "-I", root, "-isystem", "/usr/include/eigen3", source)
    return len(headers)


def check_embedding(prefix, folder, repository, cmake, project):
    """Builds the project into a folder of its name."""
    build = folder / project.name
    run(cmake, "-S", project, "-B", build,
        f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror")
    run(cmake, "--build", build)
    genotype = repository / "examples/climber.pls"
    told = run(build / "embed", genotype).splitlines()
    plsc = prefix / "bin/plsc"
    seasons = [json.loads(line) for line in
               run(plsc, "simulate", genotype, "--format", "json").splitlines()]
    # The size counts no touch sensors (paper, "Size").
    bodies = [(s["season"], s["body_descriptors"]) for s in seasons]
    wanted = [f"{season}: {body['absolute_size'] + body['touch_sensor_count']} "
              "modules" for season, body in bodies]
    wanted += [f"{s['season']}: {s['fitness']:.4f} m/s" for s in seasons]
    assert told == wanted, (told, wanted)
    broken = folder / "broken.pls"
    broken.write_text("plsc 1\ngenotype\n")
    done = subprocess.run([build / "embed", broken], text=True,
                          capture_output=True)
    assert done.returncode == 1 and f"{broken}:" in done.stderr, done


def main():
    build, repository = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
    cmake, cxx = sys.argv[3:5]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prefix = folder / "prefix"
        for component in ("program", "dev"):
            run(cmake, "--install", build, "--prefix", prefix, "--component",
                component)
        # Nothing of this machine's folders.
        for config in (prefix / "lib").rglob("*.cmake"):
            text = config.read_text()
            assert str(build) not in text and str(repository) not in text, config
        count = check_headers(prefix, folder, cxx)
        runpath.check(prefix / "bin/plsc")
        for project in ("examples/embed", "tests/package/embed_0.1"):
            check_embedding(prefix, folder, repository, cmake,
                            repository / project)
            runpath.check(folder / pathlib.Path(project).name / "embed")
        print(f"{count} headers, two programs")


if __name__ == "__main__":
    main()
