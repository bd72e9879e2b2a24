# Sourced by the other scripts: installs what is missing (Debian 12 or newer) and builds. Quick and
# silent when nothing changed.

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

say() { printf '%s\n' "$*" >&2; }

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; elif command -v sudo >/dev/null; then sudo "$@"; else
    say "roomgen: need root or sudo to install packages: $*"
    exit 1
  fi
}

# What the program needs, and what its tests need besides.
build_packages="g++ cmake ninja-build ccache pkg-config libeigen3-dev libfcl-dev libassimp-dev
  libpolyclipping-dev libmeshoptimizer-dev
  nlohmann-json3-dev libosmesa6-dev libopencv-core-dev libopencv-imgproc-dev libpng-dev libjpeg-dev
  libsqlite3-dev libzip-dev libcli11-dev catch2 sweethome3d-furniture libcurl4-openssl-dev libssl-dev
  libpugixml-dev libedit-dev libseccomp-dev
  dpkg-dev wordnet-base"
test_packages="python3 python3-venv"

install_packages() {
  local missing="" package
  local have
  have="$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' 2>/dev/null)"
  for package in "$@"; do
    grep -q "^$package installed$" <<<"$have" || missing="$missing $package"
  done
  [ -z "$missing" ] && return
  say "Installing$missing"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get update -qq >&2
  # shellcheck disable=SC2086
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    $missing >&2
}

. "$root/scripts/cpr.sh"

# A tree that was configured before cpr or the tests' own tools were there knows nothing of them, and has fewer tests.
is_to_configure() {
  local tool
  [ -f "$1" ] || return 0
  for tool in "$cpr_prefix" "$root/build/venv/requirements.txt" "$root/build/node_modules"; do
    [ "$tool" -nt "$1" ] && return 0
  done
  return 1
}

# build PRESET TARGET: into build/PRESET, with a line of progress on a terminal and the log beside it.
build() {
  local preset="$1" target="$2" log
  cd "$root" || exit 1
  install_cpr
  mkdir -p "build/$preset"
  log="build/$preset/build.log"
  if is_to_configure "build/$preset/build.ninja"; then
    say "Configuring build/$preset"
    cmake --preset "$preset" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
  fi
  if ! ninja -C "build/$preset" -n "$target" 2>/dev/null | grep -q 'no work to do'; then
    say "Building $target in build/$preset (some minutes the first time)"
    if [ -t 2 ]; then
      cmake --build "build/$preset" --target "$target" | tee "$log" |
        awk '/^\[/ {printf "\r%s ", $1 > "/dev/stderr"} END {print "" > "/dev/stderr"}'
      [ "${PIPESTATUS[0]}" = 0 ] || { grep -A5 -E 'error|FAILED' "$log" >&2; exit 1; }
    else
      cmake --build "build/$preset" --target "$target" >"$log" 2>&1 ||
        { grep -A5 -E 'error|FAILED' "$log" >&2; exit 1; }
    fi
  fi
}
