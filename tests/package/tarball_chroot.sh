#!/bin/sh
# Unpacks the tarball where nothing of this system is and compares what it evolves
# there with the native program, bit for bit: in a root that holds a static
# busybox and nothing else, not even /proc, and in Debian 11 and 13 made by
# debootstrap. Not part of the usual tests: it fetches whole systems and needs root.
#
# usage: tests/package/tarball_chroot.sh [MIRROR [SYSTEM...]]
#        SYSTEM: busybox, bullseye, trixie (default: all of them)
set -eu
cd "$(dirname "$0")/../.."
. .ci/setup.sh
plsc_install debootstrap busybox-static
mirror=${1-http://deb.debian.org/debian}
[ $# -eq 0 ] || shift
plsc=$PWD/build/release/runtime/cli/plsc
[ -x "$plsc" ] || plsc_fail "build first: tests/run.sh"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd build/release && cpack -G TGZ -B "$work/made" >/dev/null)
cat >"$work/study.yaml" <<'YAML'
plsc_study: 1
name: small
seed: 3
repetitions: 2
base:
  population: 6
  offspring: 6
  generations: 3
  scenario:
    seasons:
      - {name: flat, terrain: flat, duration: 5 s}
experiments:
  plastic:
    encoding: plasticoding
YAML
cat >"$work/run.yaml" <<'YAML'
plsc_experiment: 1
seed: 1
population: 6
offspring: 6
generations: 3
YAML

# The tables of all runs that plsc made in the folder.
tables() {
  for run in "$1"/run.sqlite "$1"/study/plastic/*.sqlite; do
    "$plsc" export "$run" --jsonl
  done
}

mkdir "$work/native"
"$plsc" evolve "$work/run.yaml" -o "$work/native/run.sqlite" --quiet >/dev/null
"$plsc" study run "$work/study.yaml" -o "$work/native/study" >/dev/null
tables "$work/native" >"$work/native.jsonl"

for system in ${*:-busybox bullseye trixie}; do
  root=$work/$system
  if [ "$system" = busybox ]; then
    mkdir -p "$root/bin" "$root/tmp"
    cp /bin/busybox "$root/bin/"
    for tool in sh readlink; do ln -s busybox "$root/bin/$tool"; done
  else
    debootstrap --variant=minbase "$system" "$root" "$mirror" >"$work/log" ||
      { tail -n 5 "$work/log" >&2; plsc_fail "debootstrap failed"; }
  fi
  mkdir "$root/opt" 2>/dev/null || true
  tar -xzf "$work"/made/*.tar.gz -C "$root/opt"
  cp examples/climber.pls "$work/run.yaml" "$work/study.yaml" "$root/"
  env -i "$(command -v chroot)" "$root" /bin/sh -eu <<'INSIDE'
plsc=$(echo /opt/plsc-*/bin/plsc)
"$plsc" --version
"$plsc" check /climber.pls
"$plsc" simulate /climber.pls
"$plsc" evolve /run.yaml -o /run.sqlite --jobs 2 --quiet >/robot.pls
"$plsc" study run /study.yaml -o /study --jobs 2
"$plsc" show /run.sqlite
if "$plsc" draw /climber.pls -o /climber.png; then exit 1; fi
INSIDE
  tables "$root" >"$work/$system.jsonl"
  cmp "$work/native.jsonl" "$work/$system.jsonl"
  echo "$system: the same bits as here"
done
