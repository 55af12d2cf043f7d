# Shared by the scripts of this folder; sourced, not run.
set -euo pipefail

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '\n== %s\n' "$*"; }

# What the library, the program and the tests need on Debian 12.
packages=(
  g++ cmake ninja-build
  libvtk9-dev libvtk9-qt-dev qtbase5-dev libgeographiclib-dev zlib1g-dev libbz2-dev
  libcli11-dev nlohmann-json3-dev
  libgtest-dev libbenchmark-dev
  python3-numpy python3-matplotlib
  xvfb xauth libgl1-mesa-dri
)

# missing_packages PACKAGE...: those that are not installed.
missing_packages() {
  local package
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed ||
      printf '%s ' "$package"
  done
}

# install_packages [PACKAGE...]: installs what is missing of these packages, by default of all that a build needs.
install_packages() {
  local missing as_root=()
  [ $# -gt 0 ] || set -- "${packages[@]}"
  missing=$(missing_packages "$@")
  if [ -z "$missing" ]; then
    say "Packages: all that is needed is installed"
    return
  fi
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "Only root can install the missing packages, and there is no sudo: $missing" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  say "Packages: installing $missing"
  "${as_root[@]}" apt-get update -qq
  # Word splitting is meant: one word a package.
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends $missing >/dev/null
}

# build PRESET [-DNAME=VALUE...] [OPTION...]: configures with the values, then builds what changed with the options.
build() {
  local preset=$1 log="$project/build/configure-$1.log" values=()
  shift
  while [[ ${1:-} == -D* ]]; do
    values+=("$1")
    shift
  done
  say "Building the $preset preset in build/$preset"
  mkdir -p "$project/build"
  cd "$project"
  cmake --preset "$preset" -DPython3_EXECUTABLE=/usr/bin/python3 "${values[@]}" >"$log" 2>&1 || {
    cat "$log" >&2
    exit 1
  }
  cmake --build --preset "$preset" "$@"
}

# Runs a command with an X server: the one at hand, else a virtual one that ends with the command.
with_display() {
  if [ -n "${DISPLAY:-}" ]; then
    "$@"
  else
    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"
  fi
}
