#!/usr/bin/env python3
"""Reads what `plsc test --format junit` writes with an XML parser: it is well
formed whatever files and environments are called, and counts what it holds.

usage: junit_test.py PLSC
"""

import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

ROBOT = b"""plsc 1
genotype g
alphabet plasticoding 1
sense inclined: bool
rule C -> { C add_front A1(0.5, 1.0, 2.0, 3.0) }
environment flat { inclined = False }
"""
SKELETON = b'{"plsc_golden": 1, "environments": [{"environment": "%s"}]}'
NAMES = [b"plain", b"a&b<c>\"d'e", b"]]>", b"new\nline\ttab\rreturn",
         b"\x1b[31mred\x07", b"\xff\xfe not UTF-8 \xed\xa0\x80",
         "\u00e9\U0001f98e\ufffe\uffff".encode(), b"-", b"--help", b" "]


def main():
    plsc = os.fsencode(os.path.abspath(sys.argv[1]))
    with tempfile.TemporaryDirectory() as folder:
        work = os.fsencode(folder)
        for name in NAMES:
            with open(os.path.join(work, name + b".pls"), "wb") as file:
                file.write(ROBOT)
        # An environment of any text, a broken genotype with marks in its text.
        with open(os.path.join(work, b"plain.golden.json"), "wb") as file:
            file.write(SKELETON % rb'<&>\"\u0001\n=]]>')
        with open(os.path.join(work, b"broken.pls"), "wb") as file:
            file.write(b"plsc 1\n<&>\"]]>\x01\n")
        report = os.path.join(work, b"report.xml")
        ran = subprocess.run([plsc, b"test", work, b"--format", b"junit",
                              b"--output", report], stdout=subprocess.PIPE)
        direct = subprocess.run([plsc, b"test", work, b"--format", b"junit"],
                                stdout=subprocess.PIPE)
        with open(report, "rb") as file:
            written = file.read()
    assert ran.returncode == 1 and direct.returncode == 1
    assert written == direct.stdout
    root = ElementTree.fromstring(written)
    suites = root.findall("testsuite")
    cases = root.findall("testsuite/testcase")
    assert len(suites) == len(NAMES) + 1, len(suites)
    assert int(root.get("tests")) == len(cases)
    for kind in ("failure", "error"):
        assert int(root.get(kind + "s")) == len(root.findall(f".//{kind}"))
        assert root.findall(f".//{kind}"), kind
    for suite in suites:
        assert int(suite.get("tests")) == len(suite.findall("testcase"))
    names = {os.path.basename(suite.get("name")) for suite in suites}
    assert "a&b<c>\"d'e.pls" in names, names
    assert "new\nline\ttab\rreturn.pls" in names, names
    assert "\ufffd[31mred\ufffd.pls" in names, names
    print(f"{len(cases)} cases, well formed")


if __name__ == "__main__":
    main()
