#!/bin/sh
# Builds tapfit where needed and opens a test bundle in the terminal:
#   ./run.sh [BUNDLE [OPTION ...]]     (default: the solar panel frame)
#   ./run.sh --version, ./run.sh --help
# Where standard output is no terminal, the whole chain runs without one.
set -eu
root=$(dirname "$0")
"$root/cmake/set_up.sh" tapfit

case ${1:-} in
  -*) exec "$root/build/release/tapfit" "$@" ;;
esac
[ $# -gt 0 ] || set -- "$root/recordings/solar-panel-frame"
# A bare system names no character set; Debian always has this one.
[ -n "${LC_ALL:-${LC_CTYPE:-${LANG:-}}}" ] || export LC_ALL=C.UTF-8
if [ -t 1 ] && [ -t 0 ]; then
  exec "$root/build/release/tapfit" "$@"
fi
exec "$root/build/release/tapfit" run "$@"
