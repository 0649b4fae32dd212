#!/usr/bin/env python3
"""What libraries compute is of the same bits everywhere: they call none of the
C library's functions that it rounds in its own way (sim/maths).

  calls_test.py NM LIBRARY... [--but OBJECT]

OBJECT, whose name begins so, does call them: else this test would see nothing.
"""

import re
import subprocess
import sys

FUNCTIONS = re.compile(
    r"(a?(sin|cos|tan)h?|atan2|sincos|exp(2|10|m1)?|log(2|10|1p)?|pow|hypot|cbrt|"
    r"fmod|remainder|remquo|erfc?|[lt]gamma|j[01n]|y[01n])(f|l)?(@.*)?$")


def calls(nm, library):
    """(object, function) for each that it calls."""
    out = subprocess.run([nm, "--undefined-only", "--print-file-name", library],
                         check=True, capture_output=True, text=True).stdout
    for line in out.splitlines():
        where, _, name = line.rpartition(" U ")
        # A finite variant, as old compilers' -ffinite-math has, counts.
        name = re.sub(r"^__(\w+)_finite$", r"\1", name)
        if FUNCTIONS.match(name):
            yield where.split(":")[-2 if where.count(":") > 1 else -1], name


def main():
    nm, *libraries = sys.argv[1:]
    but = None
    if "--but" in libraries:
        but = libraries.pop()
        libraries.remove("--but")
    found = [(library, *call) for library in libraries for call in calls(nm, library)]
    wrong = [call for call in found if not (but and call[1].startswith(but))]
    for library, where, name in wrong:
        print(f"{library}: {where} calls {name}; see sim/maths", file=sys.stderr)
    if but and len(wrong) == len(found):
        print(f"{but} calls nothing: is it still there?", file=sys.stderr)
        return 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
