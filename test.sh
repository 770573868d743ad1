#!/bin/sh
# Builds everything and runs every test.   ./test.sh [CTEST OPTION ...]
set -eu
cd "$(dirname "$0")"
cmake/set_up.sh
exec ctest --preset release -j 2 "$@"
