#!/bin/sh
# Installs the Debian package into a bare Debian 12 made by debootstrap, as a
# user would, and runs it there. Not part of the usual tests: it fetches a whole
# system (100 MB) and needs root.
#
# usage: tests/package/deb_chroot.sh [MIRROR]
set -eu
cd "$(dirname "$0")/../.."
. .ci/setup.sh
plsc_install debootstrap dpkg-dev file
mirror=${1-http://deb.debian.org/debian}
[ -x build/release/runtime/cli/plsc ] || plsc_fail "build first: tests/run.sh"

work=$(mktemp -d)
trap 'umount "$work/root/proc" 2>/dev/null || true; rm -rf "$work"' EXIT
(cd build/release && cpack -G DEB -B "$work" >/dev/null)
debootstrap --variant=minbase bookworm "$work/root" "$mirror" >"$work/log" ||
  { tail -n 5 "$work/log" >&2; plsc_fail "debootstrap failed"; }
cp "$work"/*.deb examples/climber.pls "$work/root/"
cp examples/small.yaml "$work/root/"
cp -r examples/embed "$work/root/"
mount -t proc proc "$work/root/proc"
# The machine's own way to the archive, if it is a particular one.
cp /etc/resolv.conf "$work/root/etc/" 2>/dev/null || true
cp /etc/apt/apt.conf.d/*proxy* "$work/root/etc/apt/apt.conf.d/" 2>/dev/null || true

chroot "$work/root" sh -eu <<'INSIDE'
export DEBIAN_FRONTEND=noninteractive
apt-get -qq update
apt-get -qq install -y --no-install-recommends /plsc_*.deb >/log 2>&1 ||
  { tail -n 5 /log >&2; exit 1; }
plsc --version
plsc simulate /climber.pls
plsc evolve /small.yaml -o /run.sqlite --quiet >/dev/null
plsc show /run.sqlite
apt-get -qq install -y --no-install-recommends /libplsc-dev_*.deb >/log 2>&1 ||
  { tail -n 5 /log >&2; exit 1; }
cmake -S /embed -B /build >/dev/null
cmake --build /build
/build/embed /climber.pls
apt-get -qq purge -y plsc >/log 2>&1 || { tail -n 5 /log >&2; exit 1; }
[ ! -e /usr/bin/plsc ]
INSIDE
echo "installed, run and removed in a bare Debian 12"
