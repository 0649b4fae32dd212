#!/usr/bin/env python3
"""No program that was built looks for libraries in the current folder.

usage: runpath_test.py BUILD
"""

import os
import pathlib
import sys
import tempfile

import runpath


def programs(build):
    for folder, folders, files in os.walk(build):
        folders[:] = [name for name in folders
                      if name not in ("node_modules", "_deps", "CMakeFiles")]
        for name in files:
            path = pathlib.Path(folder) / name
            if (not path.is_symlink() and path.is_file()
                    and os.access(path, os.X_OK)
                    and path.open("rb").read(4) == b"\x7fELF"):
                yield path


def check_the_check(program):
    """A program with an empty entry is seen as one."""
    entries = runpath.library_paths(program)
    text = ":".join(entries).encode()
    data = program.read_bytes()
    assert data.count(b"\0" + text + b"\0") >= 1, (program, entries)
    with tempfile.TemporaryDirectory() as folder:
        worse = pathlib.Path(folder) / "worse"
        for bad in (text[:-1] + b":", b"." + text[1:]):
            worse.write_bytes(data.replace(text + b"\0", bad + b"\0"))
            try:
                runpath.check(worse)
            except AssertionError:
                continue
            sys.exit(f"not seen: {bad}")


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    found = list(programs(build))
    assert build / "runtime/cli/plsc" in found, found
    with_entries = [path for path in found if runpath.check(path) > 0]
    # Only where MPI lies in a folder of its own are there any.
    if with_entries:
        check_the_check(with_entries[0])
    print(f"{len(found)} programs, {len(with_entries)} of them name folders")


main()
