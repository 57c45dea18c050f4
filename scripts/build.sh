# SPDX-License-Identifier: Apache-2.0
# Sourced by scripts/demo and scripts/test: goes to the repository's root, installs the packages of
# packages.txt that are missing, and builds. What is there already is not done again.
set -eu

cd "$(dirname "$0")/.."

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# The packages of the groups that are named; a group begins with a line "# GROUP: ...".
packages_of() {
  group=""
  while read -r line; do
    case $line in
      '# '*:*) group=${line#'# '} group=${group%%:*} ;;
      '' | '#'*) ;;
      *) case " $* " in *" $group "*) echo "$line" ;; esac ;;
    esac
  done <packages.txt
}

install_missing_packages() {
  missing=""
  for package in $(packages_of "$@"); do
    is_installed "$package" || missing="$missing $package"
  done
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

# A compiler cache is used where there is one, never needed. Precompiled headers carry times, which
# it must not mind.
if command -v ccache >/dev/null; then
  export CCACHE_SLOPPINESS=pch_defines,time_macros CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi

configure() {
  cmake --preset release "$@"
}

# What is asked for, or everything: build [--target NAME].
build() {
  cmake --build --preset release --parallel "$(nproc)" "$@"
}
