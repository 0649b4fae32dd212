#!/usr/bin/env bash
# Makes the pictures of README.md and docs/figures.md anew, from a real study:
# about five minutes on two cores, most of it for the study, which is kept in
# build/figures for the next time.
set -eu
cd "$(dirname "$0")/../.."
. .ci/setup.sh
case "${1-}" in
  "") ;;
  *) echo "usage: docs/images/make.sh"; [ "$1" = --help ] && exit 0 || exit 2 ;;
esac

plsc_install $PLSC_PACKAGES $PLSC_TEST_PACKAGES
plsc_build release
plsc=build/release/runtime/cli/plsc
work=build/figures
images=docs/images
mkdir -p "$work"

"$plsc" study run examples/small_study.yaml -o "$work/study" --quiet
run=$work/study/plastic/1.sqlite
"$plsc" report "$work/study" -o "$work/report.html"
"$plsc" draw "$run" best -o "$images/evolved.svg"
"$plsc" view "$work/study/plastic/2.sqlite" best "$work/study/baseline/1.sqlite" best \
  -o "$work/replay.html"
"$plsc" view --explain examples/climber.pls -o "$work/explain.html"

# A server, which ends by itself when its page has been closed.
"$plsc" live examples/climber.pls --idle 20 >"$work/live.address" &

PLSC_NODE_MODULES=build/release/tests/pages/npm/node_modules \
  node docs/images/screenshots.mjs "$work" "$images"
