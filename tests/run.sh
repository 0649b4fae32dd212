#!/usr/bin/env bash
# Installs what is missing, builds, and runs all tests.
set -eu
cd "$(dirname "$0")/.."
. .ci/setup.sh

usage() {
  cat <<'TXT'
usage: tests/run.sh [--preset release|debug|sanitize] [--fast | --core | --watched]

Installs missing Debian packages (as root or with sudo), builds into
build/PRESET and runs all tests. Works on a fresh Debian 12 machine.

  --preset P  how to build (default: release)
  --fast      leave out the tests labelled slow
  --core      only the fast tests of the compiler, development, simulation and
              the language server; builds nothing else
  --watched   those and the fast tests of evolution, stores, studies, reports and
              commands: what .ci/run has sanitizers watch
TXT
}

preset=release
target=all
labels=()
while [ $# -gt 0 ]; do
  case "$1" in
    --preset)
      case "${2-}" in
        release | debug | sanitize) preset=$2 ;;
        *) usage >&2; echo "tests/run.sh: --preset needs release, debug or sanitize" >&2; exit 2 ;;
      esac
      shift 2 ;;
    --fast) labels=(-L fast); shift ;;
    --core) labels=(-L core); target=core_tests; shift ;;
    --watched) labels=(-L 'core|watched'); target=watched_tests; shift ;;
    -h | --help) usage; exit 0 ;;
    *) usage >&2; echo "tests/run.sh: unknown argument '$1'" >&2; exit 2 ;;
  esac
done

plsc_install $PLSC_PACKAGES $PLSC_TEST_PACKAGES
[ "$preset" != sanitize ] || plsc_install $PLSC_CLANG_PACKAGES
plsc_build "$preset" "$target"

# Hundreds of stores are written and synced, which waits for a disk: folders of
# tests are made in memory, where there is room for them and programs may run.
if [ -z "${TMPDIR-}" ] &&
  space=$(df --output=avail -B1M /dev/shm 2>/dev/null | tail -n 1) &&
  [ "${space:-0}" -gt 2000 ] &&
  folder=$(mktemp -d /dev/shm/plsc-tests-XXXXXX); then
  trap 'rm -rf "$folder"' EXIT
  printf '#!/bin/sh\n' >"$folder/program"
  chmod 755 "$folder" "$folder/program"
  if "$folder/program" 2>/dev/null; then export TMPDIR=$folder; fi
fi
# One more than there are cores: some tests wait for what they started.
ctest --preset "$preset" -j"$(($(nproc) + 1))" "${labels[@]}"
