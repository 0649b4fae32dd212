#!/usr/bin/env python3
"""The Debian packages that CPack makes: what they hold, what they ask for, and
that the program runs where it is unpacked.

usage: deb_test.py BUILD CPACK
"""

import pathlib
import subprocess
import sys
import tempfile


def run(*command, **options):
    return subprocess.run([str(word) for word in command], text=True,
                          check=True, stdout=subprocess.PIPE, **options).stdout


def main():
    build, cpack = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run(cpack, "-G", "DEB", "-B", folder, cwd=build)
        program = next(folder.glob("plsc_*.deb"))
        library = next(folder.glob("libplsc-dev_*.deb"))

        depends = run("dpkg-deb", "-f", program, "Depends")
        for needed in ("libode8", "libyaml-cpp0.7", "libsqlite3-0", "libfmt9"):
            assert needed in depends, (needed, depends)
        assert "-dev" not in depends, depends  # nothing to build with
        assert "r-mathlib" not in depends, depends  # is under the GPL
        assert "libode-dev" in run("dpkg-deb", "-f", library, "Depends")

        root = folder / "root"
        run("dpkg-deb", "-x", program, root)
        run("dpkg-deb", "-x", library, root)
        for wanted in ("usr/share/doc/plsc/copyright",
                       "usr/share/man/man1/plsc-trim.1",
                       "usr/share/bash-completion/completions/plsc",
                       "usr/share/zsh/site-functions/_plsc",
                       "usr/share/fish/vendor_completions.d/plsc.fish",
                       "usr/share/doc/plsc/examples/climber.pls",
                       "usr/include/plsc/compiler/compile.h"):
            assert (root / wanted).is_file(), wanted
        assert list(root.glob("usr/lib/**/cmake/plsc/plsc-config.cmake"))
        told = run(root / "usr/bin/plsc", "check",
                   root / "usr/share/doc/plsc/examples/climber.pls")
        assert "genotype climber" in told, told
        strange = [path for path in root.rglob("*") if path.is_file()
                   and not path.is_relative_to(root / "usr")]
        assert not strange, strange


if __name__ == "__main__":
    main()
