# SPDX-License-Identifier: Apache-2.0
# Sourced by scripts/demo and scripts/test: goes to the repository's root, installs the packages of
# packages.txt that are missing, and builds. What is there already is not done again.
set -eu

cd "$(dirname "$0")/.."

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

install_missing_packages() {
  missing=""
  while read -r package; do
    case $package in '' | '#'*) continue ;; esac
    is_installed "$package" || missing="$missing $package"
  done <packages.txt
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    echo "These packages are missing; install them with" >&2
    echo "  sudo apt-get install --no-install-recommends$missing" >&2
    exit 2
  fi
  export DEBIAN_FRONTEND=noninteractive
  apt-get update
  # Unquoted on purpose: one word per package.
  apt-get install --yes --no-install-recommends $missing
}

# Everything, or what is asked for: build [--target NAME].
build() {
  [ -f build/release/build.ninja ] || cmake --preset release
  cmake --build --preset release --parallel "$(nproc)" "$@"
}
