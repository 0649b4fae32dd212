# Sourced, not run: makes sure that the Debian packages named by the caller are
# installed. Used by tests/run.sh, examples/quickstart.sh and .ci/run, so that
# each works on a fresh machine.

# What building plsc alone needs; docs/dependencies.md says why each. CI recipes
# of docs/testing-robots.md install these.
PLSC_BUILD_PACKAGES="g++ cmake ninja-build pkg-config tao-pegtl-dev libfmt-dev \
libeigen3-dev libode-dev libyaml-cpp-dev libcli11-dev nlohmann-json3-dev \
librandom123-dev libsqlite3-dev libxxhash-dev libboost-dev"
# And what all of it and its tests need.
PLSC_PACKAGES="$PLSC_BUILD_PACKAGES gzip catch2 libopenmpi-dev openmpi-bin \
librsvg2-dev libcairo2-dev librsvg2-2 fonts-dejavu-core python3"

# Pages are bundled with npm, which a Node.js from elsewhere than Debian brings
# itself.
command -v npm >/dev/null 2>&1 || PLSC_PACKAGES="$PLSC_PACKAGES nodejs npm"
# What tests alone need: a browser to open the pages in, the readers of the
# exported robots, an editor for the language server.
PLSC_TEST_PACKAGES="chromium libmujoco-dev liburdfdom-dev libsdformat-dev \
neovim git dpkg-dev file"
# Builds with sanitizers and libFuzzer.
PLSC_CLANG_PACKAGES="clang-14 lld-14 libclang-rt-14-dev"

plsc_fail() {
  echo "$(basename "$0"): $1" >&2
  exit 1
}

# plsc_install PACKAGE...: installs what is missing with apt-get, as root or
# through sudo, and says so. Does nothing, and needs no network, when all are
# there.
plsc_install() {
  command -v dpkg-query >/dev/null 2>&1 && command -v apt-get >/dev/null 2>&1 ||
    plsc_fail "this script installs Debian packages and found no apt-get; on another system install by hand: $*"
  local missing="" package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      missing="$missing $package"
  done
  [ -n "$missing" ] || return 0

  local as_root=""
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null 2>&1 ||
      plsc_fail "these packages are missing and you are neither root nor have sudo; ask for:$missing"
    as_root="sudo"
  fi
  echo "installing with apt-get:$missing"
  local log
  log=$(mktemp)
  if ! { $as_root apt-get update &&
    $as_root env DEBIAN_FRONTEND=noninteractive \
      apt-get install -y --no-install-recommends $missing; } >"$log" 2>&1; then
    tail -n 15 "$log" >&2
    rm -f "$log"
    plsc_fail "apt-get could not install the packages (its last lines are above); is there a network, and does /etc/apt name Debian 12?"
  fi
  rm -f "$log"
}

# plsc_build PRESET [TARGET...]: configures and builds into build/PRESET.
plsc_build() {
  [ $# -gt 1 ] || set -- "$1" all
  cmake --preset "$1" >/dev/null ||
    plsc_fail "cmake could not configure; its message is above"
  cmake --build --preset "$1" --target "${@:2}" ||
    plsc_fail "the build failed; the compiler's message is above"
}
