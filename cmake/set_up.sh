#!/bin/sh
# Installs what is missing, then configures and builds the release preset:
#   cmake/set_up.sh [TARGET]     (no target: everything)
# Speaks on standard error only, so that a caller's output stays clean.
set -eu
cd "$(dirname "$0")/.."

cmake/install_packages.sh

quiet=--quiet
[ -t 2 ] && quiet=
{
  # A build folder from another place or compiler is configured afresh.
  mkdir -p build
  cmake --preset release >build/configure.log 2>&1 ||
    cmake --fresh --preset release --log-level=WARNING
  # As measured; the tests take as long again as the program.
  built() { [ -e build/release/tapfit ]; }
  tested() { [ -e build/release/tests/end_to_end_tests ]; }
  minutes=20
  if [ "${1:-}" = tapfit ] || built; then minutes=10; fi
  if ! built || { [ "${1:-}" != tapfit ] && ! tested; }; then
    echo "Building tapfit: about $minutes minutes on two cores the first time ..."
  fi
  # shellcheck disable=SC2086 # no option at all where $quiet is empty
  cmake --build --preset release -j "$(nproc)" ${1:+--target "$1"} -- $quiet
} >&2
