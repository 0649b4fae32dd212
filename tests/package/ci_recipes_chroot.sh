#!/bin/sh
# Follows a CI recipe of docs/testing-robots.md in a bare Debian 12 made by
# debootstrap, as the CI would: packages, build, check, test. Not part of the
# usual tests: it fetches a whole system and builds plsc anew, and needs root.
#
# usage: tests/package/ci_recipes_chroot.sh [GitHub|GitLab [MIRROR]]
#
# PLSC_ONLY_CONFIGURE=1 leaves out what needs the program: whether packages are
# missing is known when cmake has configured.
set -eu
cd "$(dirname "$0")/../.."
. .ci/setup.sh
plsc_install debootstrap git python3
recipe=${1-GitHub}
mirror=${2-http://deb.debian.org/debian}

work=$(mktemp -d)
trap 'umount "$work/root/proc" 2>/dev/null || true; rm -rf "$work"' EXIT
debootstrap --variant=minbase bookworm "$work/root" "$mirror" >"$work/log" ||
  { tail -n 5 "$work/log" >&2; plsc_fail "debootstrap failed"; }
mount -t proc proc "$work/root/proc"
# The machine's own way to the archive, if it is a particular one.
cp /etc/resolv.conf "$work/root/etc/" 2>/dev/null || true
cp /etc/apt/apt.conf.d/*proxy* "$work/root/etc/apt/apt.conf.d/" 2>/dev/null || true
git clone -q --no-local . "$work/root/plsc.git"
mkdir "$work/root/project"
cp -r examples "$work/root/project/robots"
python3 tests/docs/typed.py "$recipe" >"$work/root/recipe"
[ -z "${PLSC_ONLY_CONFIGURE-}" ] ||
  sed -i '/^cmake --build/d; /^\/opt\/plsc/d' "$work/root/recipe"

chroot "$work/root" env DEBIAN_FRONTEND=noninteractive \
  PLSC_REPOSITORY=/plsc.git CI_PROJECT_DIR=/project \
  sh -euc 'cd /project; . /recipe'
echo "the recipe for $recipe works in a bare Debian 12"
