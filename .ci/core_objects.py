#!/usr/bin/env python3
"""Prints the objects that a build folder has of the sources of another one.

core_objects.py CORE WHOLE: exits with status 1 unless WHOLE compiles each source
of CORE by the very command by which CORE would, text and generated headers
included. Then what WHOLE made is what CORE would make, and need not be made
again. An option that only says how much to optimise may differ.
"""

import json
import pathlib
import re
import sys


def commands(folder):
    """Of each source, by its place: what compiles it, and its object."""
    known = {}
    for entry in json.loads((folder / "compile_commands.json").read_text()):
        command = entry["command"].replace(str(folder), "BUILD")
        made = folder / re.search(r" -o (\S+)", command)[1]
        place = entry["file"].replace(str(folder), "BUILD")
        text = pathlib.Path(entry["file"]).read_text()
        known[place] = (re.sub(r" -O[0-3s]\b", "", command),
                        text.replace(str(folder), "BUILD"), made)
    return known


def main():
    core, whole = (pathlib.Path(f).resolve() for f in sys.argv[1:3])
    ours, theirs = commands(core), commands(whole)
    wrong = [place for place, (command, text, _) in ours.items()
             if theirs.get(place, ())[:2] != (command, text)]
    for header in (core / "generated").rglob("*"):
        there = whole / "generated" / header.relative_to(core / "generated")
        if header.is_file() and (
                not there.exists() or there.read_bytes() != header.read_bytes()):
            wrong.append(str(header))
    if wrong or not ours:
        sys.exit("the core alone would be compiled otherwise than with all else:"
                 + "".join(f"\n  {place}" for place in wrong))
    print("\n".join(str(theirs[place][2]) for place in ours))


if __name__ == "__main__":
    main()
