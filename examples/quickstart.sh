#!/usr/bin/env bash
# The main job from nothing: installs what is missing, builds plsc, grows a
# hand-written robot in two environments, lives its seasons, and evolves.
set -eu
cd "$(dirname "$0")/.."
. .ci/setup.sh

case "${1-}" in
  "") ;;
  -h | --help)
    cat <<'TXT'
usage: examples/quickstart.sh

Installs missing Debian packages (as root or with sudo), builds plsc into
build/release and runs the main job on examples/climber.pls. Pictures and the
evolved robots go to examples/output, which is made anew. At most 10 minutes on
2 cores.
TXT
    exit 0 ;;
  *) echo "quickstart.sh: unknown argument '$1' (it takes none but --help)" >&2; exit 2 ;;
esac

output=examples/output
robot=examples/climber.pls
plsc=build/release/runtime/cli/plsc

say() { printf '\n== %s\n' "$*"; }
run() {
  printf '$ plsc %s\n' "$*"
  "$plsc" "$@"
}

say "packages and build"
plsc_install $PLSC_PACKAGES
plsc_build release plsc
rm -rf "$output"
mkdir -p "$output"

say "1. is it a genotype?"
run check "$robot"
say "2. one genotype, two environments, two bodies"
run develop "$robot" --svg "$output"
say "3. both seasons in the simulator"
run simulate "$robot" --descriptors
say "4. evolution: 4000 robots that shall walk in both seasons"
run evolve examples/walkers.yaml -o "$output/walkers.sqlite"
run replay "$output/walkers.sqlite" best
run view "$output/walkers.sqlite" best -o "$output/walkers.html" ||
  say "no page: plsc was built without npm"
say "done: pictures and the run are in $output"
say "to write a robot and watch it walk: $plsc live $robot --open"
