#!/usr/bin/env python3
"""Whole runs on the ranks of an MPI job: mpi_evolve_test.py PLSC.

Any number of workers and ranks leaves the same results, and so does a run of
which a rank was killed, or that was stopped by Ctrl-C, once it has gone on.
Exit status 77 (skipped) where there is no mpirun or plsc has no MPI.
"""

import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

PLSC = sys.argv[1]
LIMIT = 120  # s, for what takes a few
RANK = "OMPI_COMM_WORLD_RANK"
ENVIRONMENT = {
    name: value for name, value in os.environ.items()
    if not name.startswith(("OMPI_", "PMI_", "PMIX_"))
} | {
    # Containers are root.
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
}
EXPERIMENT = """\
plsc_experiment: 1
name: tiny
seed: 3
population: 8
offspring: 8
generations: {generations}
scenario:
  seasons:
    - {{terrain: flat, duration: {duration} s}}
    - {{terrain: {{tilted: 5 deg}}, duration: {duration} s}}
    - {{name: again, terrain: flat, duration: {duration} s}}
"""


def run(*words):
    return subprocess.run(words, env=ENVIRONMENT, timeout=LIMIT, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def mpirun(ranks):
    return ("mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(ranks))


def check(is_true, what):
    if not is_true:
        sys.exit(f"FAILED: {what}")


def results(store):
    exported = run(PLSC, "export", store, "--jsonl")
    check(exported.returncode == 0, exported.stdout)
    check(exported.stdout.count("\n") > 8, f"an empty export: {exported.stdout}")
    return exported.stdout


def evolved(name, command):
    done = run(*command, "-o", name, "--quiet")
    check(done.returncode == 0, f"{' '.join(command)}: {done.stdout}")
    return results(name)


def environment_of(process):
    try:
        text = pathlib.Path(f"/proc/{process}/environ").read_bytes()
    except OSError:
        return {}
    pairs = (item.split("=", 1) for item in os.fsdecode(text).split("\0"))
    return dict(pair for pair in pairs if len(pair) == 2)


def processes(marker):
    """Of a job, by a variable in its environment: rank and parent by pid. Not
    those that have ended but were not waited for."""
    found = {}
    for folder in pathlib.Path("/proc").iterdir():
        if not folder.name.isdigit():
            continue
        variables = environment_of(folder.name)
        if variables.get("PLSC_TEST") != marker or RANK not in variables:
            continue
        try:
            stat = (folder / "stat").read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue
        if stat[0] != "Z":
            found[int(folder.name)] = (int(variables[RANK]), int(stat[1]))
    return found


def start(marker, command):
    """A job that evolves at least one generation before this returns."""
    job = subprocess.Popen(command, env=ENVIRONMENT | {"PLSC_TEST": marker},
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                           text=True, errors="replace")
    seen = []
    for line in job.stdout:
        seen.append(line)
        if line.startswith("generation 2/"):
            return job
    sys.exit(f"FAILED: no second generation: {''.join(seen)}")


def wait_until_gone(marker):
    # A worker dies as soon as its rank has, which is not at once for us.
    end = time.monotonic() + 20
    while left := processes(marker):
        check(time.monotonic() < end, f"left over: {left}")


def finished_after(marker, harm, words_said=""):
    """The results of a run on three ranks that was harmed and has gone on."""
    store = f"{marker}.sqlite"
    job = start(marker, (*mpirun(3), PLSC, "evolve", "long.yaml", "-o", store))
    harm(job)
    output = job.communicate(timeout=LIMIT)[0]
    check(job.returncode != 0, f"the job ended as if nothing were: {output}")
    wait_until_gone(marker)
    check(words_said in output, f"'{words_said}' is not in: {output}")
    check("generation 20/" not in output, "the run was over before the harm")
    for words in (mpirun(2), ()):
        # The second finds nothing to do.
        done = run(*words, PLSC, "evolve", "--resume", store, "--quiet")
        check(done.returncode == 0, done.stdout)
    return results(store)


def kill_rank(marker, rank):
    def harm(_):
        found = processes(marker)
        # Workers have the rank of the process that forked them.
        victims = [process for process, (of, parent) in found.items()
                   if of == rank and parent not in found]
        check(len(victims) == 1, f"one process of rank {rank}: {found}")
        os.kill(victims[0], signal.SIGKILL)
    return harm


def main():
    if not shutil.which("mpirun"):
        print("skipped: there is no mpirun (Debian: openmpi-bin)")
        return 77
    os.chdir(sys.argv[2])
    short = EXPERIMENT.format(generations=4, duration=2)
    pathlib.Path("tiny.yaml").write_text(short)
    pathlib.Path("long.yaml").write_text(
        EXPERIMENT.format(generations=20, duration=4))
    tried = run(*mpirun(2), PLSC, "evolve", "tiny.yaml", "-o", "try.sqlite")
    if "built without MPI" in tried.stdout:
        check(not pathlib.Path("try.sqlite").exists(), "ranks ran on their own")
        print("skipped: plsc was built without MPI")
        return 77

    evolve = (PLSC, "evolve", "tiny.yaml")
    expected = evolved("jobs1.sqlite", (*evolve, "--jobs", "1"))
    for jobs in ("2", "4"):
        check(evolved(f"jobs{jobs}.sqlite", (*evolve, "--jobs", jobs)) ==
              expected, f"{jobs} workers leave other results")
    for ranks in (2, 4):
        check(evolved(f"ranks{ranks}.sqlite", (*mpirun(ranks), *evolve)) ==
              expected, f"{ranks} ranks leave other results")
    check(evolved("both.sqlite", (*mpirun(2), *evolve, "--jobs", "2")) ==
          expected, "two ranks of two workers leave other results")
    check(evolved("all.sqlite", (*mpirun(2), *evolve, "--jobs", "0")) ==
          expected, "two ranks with all cores leave other results")
    with sqlite3.connect("all.sqlite") as store:
        workers = store.execute("SELECT workers FROM session").fetchone()[0]
    usable = len(os.sched_getaffinity(0))
    check(2 <= workers <= max(2, usable), f"{workers} workers, {usable} cores")

    pathlib.Path("tried.yaml").write_text(
        short + "profile: swift\nfitness: speed - 0.001 * energy\ntrials: 3\nnoise: {start_height: 30 um}\n")
    tried = (PLSC, "evolve", "tried.yaml")
    trials = evolved("tried1.sqlite", (*tried, "--jobs", "1"))
    check('"trials":[[{' in trials, "no trials are exported")
    check(evolved("tried3.sqlite", (*mpirun(3), *tried)) == trials,
          "three ranks leave other trials")

    wrong = run(*mpirun(2), PLSC, "evolve", "none.yaml", "-o", "none.sqlite")
    check(wrong.returncode == 1 and wrong.stdout.count("'none.yaml'") == 1,
          f"one rank alone says what is wrong: {wrong.stdout}")

    expected = evolved("long.sqlite", (PLSC, "evolve", "long.yaml"))
    for marker, harm, words_said in (
            ("remote", kill_rank("remote", 2), ""),
            ("first", kill_rank("first", 0), ""),
            ("launcher", lambda job: job.kill(), ""),
            # mpirun may kill rank 0 before it has said anything.
            ("interrupt", lambda job: job.send_signal(signal.SIGINT), ""),
            ("terminate", lambda job: job.send_signal(signal.SIGTERM), ""),
            ("asked", lambda job: job.send_signal(signal.SIGUSR1),
             "plsc evolve --resume asked.sqlite")):
        check(finished_after(marker, harm, words_said) == expected,
              f"{marker}: going on leads to other results")
    return 0


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as FOLDER:
        sys.argv.append(FOLDER)
        PLSC = os.path.abspath(PLSC)
        sys.exit(main())
