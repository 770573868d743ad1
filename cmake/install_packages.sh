#!/bin/sh
# Installs the Debian packages of packages.txt that are missing. Says what it
# installs; does nothing, and needs no rights, when everything is there.
set -eu
list=$(dirname "$0")/packages.txt

if ! command -v dpkg-query >/dev/null; then
  echo "This is no Debian system: install the equivalents of $list" \
    "yourself, then build with CMake (see CONTRIBUTING.md)." >&2
  exit 1
fi

missing=
while read -r package; do
  case $package in '' | '#'*) continue ;; esac
  status=$(dpkg-query -W -f='${db:Status-Status} ' "$package" 2>/dev/null || :)
  case $status in 'installed '*) ;; *) missing="$missing $package" ;; esac
done <"$list"
[ -z "$missing" ] && exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Missing Debian packages, and neither root nor sudo to install them:" >&2
    echo "  apt-get install$missing" >&2
    exit 1
  fi
  as_root="sudo"
fi

echo "Installing Debian packages:$missing" >&2
# The lists of a fresh system are empty or old, so they are fetched first.
# shellcheck disable=SC2086 # both are lists of words
if ! { $as_root apt-get update -qq &&
  $as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -qq -y --no-install-recommends $missing; } >&2; then
  echo "Could not install the packages above: see apt-get's message, then" \
    "run 'apt-get install$missing' by hand." >&2
  exit 1
fi
