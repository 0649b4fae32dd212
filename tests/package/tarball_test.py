#!/usr/bin/env python3
"""The tarball that CPack makes runs with nothing of the machine but its kernel
and a shell, and gives the bits of the program that was built beside it.

usage: tarball_test.py BUILD REPOSITORY CPACK
"""

import pathlib
import subprocess
import sys
import tarfile
import tempfile


def run(*command, status=0, env=None):
    """What it printed: results, and if it must fail what it complained of."""
    done = subprocess.run([str(word) for word in command], text=True,
                          env=env or {}, capture_output=True)
    if done.returncode != status:
        sys.exit(f"{' '.join(map(str, command))}: {done.returncode}\n"
                 f"{done.stdout}{done.stderr}")
    return done.stdout if status == 0 else done.stderr


def check_libraries(plsc):
    """Whatever is loaded lies in the tarball."""
    folder = plsc.parent.parent / "lib/plsc"
    loader = next(folder.glob("ld-linux*"))
    listed = run(loader, "--inhibit-cache", "--library-path", folder, "--list",
                 folder / "plsc")
    for line in listed.splitlines():
        words = line.split()
        if "=>" in words:
            assert words[2].startswith(str(folder)), line
    for absent in ("libmpi", "librsvg", "libRmath"):
        assert absent not in listed, listed


def check_refusals(plsc, robot, experiment, folder):
    picture = folder / "robot.png"
    told = run(plsc, "draw", robot, "-o", picture, status=1)
    assert "built without librsvg" in told, told
    assert not picture.exists()
    told = run(plsc, "evolve", experiment, "-o", folder / "ranks.sqlite",
               status=1, env={"OMPI_COMM_WORLD_SIZE": "2",
                              "OMPI_COMM_WORLD_RANK": "0"})
    assert "built without MPI" in told, told


def check_bits(plsc, native, experiment, folder):
    """Equal runs, each with what the other one simulated before it."""
    study = folder / "study.yaml"
    study.write_text(STUDY)
    for first, second in ((plsc, native), (native, plsc)):
        made = pathlib.Path(tempfile.mkdtemp(dir=folder))
        tables = []
        for program in (first, second):
            store = made / f"{len(tables)}.sqlite"
            told = subprocess.run(
                [program, "evolve", experiment, "-o", store, "--jobs", "2",
                 "--cache", made / "cache"], text=True, env={}, check=True,
                capture_output=True).stderr
            tables.append(run(program, "export", store, "--jsonl"))
        assert "100 % of seasons known already" in told, told
        assert tables[0] == tables[1]
    tables = []
    for program in (plsc, native):
        studied = pathlib.Path(tempfile.mkdtemp(dir=folder)) / "study"
        run(program, "study", "run", study, "-o", studied, "--jobs", "2")
        tables.append(run(native, "export", studied / "plastic/1.sqlite",
                          "--jsonl"))
    assert tables[0] == tables[1]


EXPERIMENT = """plsc_experiment: 1
seed: 5
population: 4
offspring: 4
generations: 2
scenario:
  seasons:
    - {name: flat, terrain: flat, duration: 1 s}
"""
STUDY = """plsc_study: 1
name: small
seed: 6
repetitions: 1
base:
  population: 4
  offspring: 4
  generations: 2
  scenario:
    seasons:
      - {name: flat, terrain: flat, duration: 1 s}
experiments:
  plastic:
    encoding: plasticoding
"""


def main():
    build, repository = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
    cpack = sys.argv[3]
    native = build / "runtime/cli/plsc"
    robot = repository / "examples/climber.pls"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([cpack, "-G", "TGZ", "-B", str(folder / "made")],
                       cwd=build, check=True, stdout=subprocess.DEVNULL)
        made = list((folder / "made").glob("*.tar.gz"))
        assert len(made) == 1 and made[0].name.startswith("plsc-"), made
        with tarfile.open(made[0]) as tarball:
            tarball.extractall(folder)
        root = folder / made[0].name.removesuffix(".tar.gz")
        for wanted in ("lib/plsc/libc.so.6", "lib/plsc/libode.so.8",
                       "share/man/man1/plsc-evolve.1",
                       "share/doc/plsc/copyright",
                       "share/doc/plsc/examples/climber.pls"):
            assert (root / wanted).is_file(), wanted
        plsc = root / "bin/plsc"
        check_libraries(plsc)

        # Through a link, and moved.
        root.rename(folder / "a folder")
        plsc = folder / "link"
        plsc.symlink_to(folder / "a folder/bin/plsc")
        assert run(plsc, "--version") == run(native, "--version")
        for command in (("check", robot), ("simulate", robot)):
            assert run(plsc, *command) == run(native, *command), command
        # Libraries of the machine are kept out.
        run(plsc, "--version", env={"LD_PRELOAD": "libsqlite3.so.0",
                                    "LD_LIBRARY_PATH": "/usr/lib"})

        experiment = folder / "experiment.yaml"
        experiment.write_text(EXPERIMENT)
        check_bits(plsc, native, experiment, folder)
        check_refusals(plsc, robot, experiment, folder)


if __name__ == "__main__":
    main()
