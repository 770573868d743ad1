#!/bin/sh
# Tries what is installed below a prefix as its users meet it: the program, its
# pages, man page, completion, desktop entry and demonstration; where the
# libraries are there, a project built on them; where Python is, its example.
#   packaging/try_installed.sh [PREFIX]     (default: /usr)
set -eu
prefix=$(cd "${1:-/usr}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PATH="$prefix/bin:$PATH" TAPFIT_NO_CACHE=1
pages=$prefix/share/doc/tapfit
truss=$prefix/share/tapfit/recordings/paper-truss
wing=$prefix/share/tapfit/recordings/paper-solar-wing

fail() {
  echo "try_installed: $*" >&2
  exit 1
}
# says FILE WORDS: the file holds them.
says() { grep -qF -- "$2" "$1" || fail "$1 does not say '$2': $(cat "$1")"; }
tried() { echo "tried: $*"; }

[ "$(command -v tapfit)" = "$prefix/bin/tapfit" ] || fail "no $prefix/bin/tapfit"
cd "$work" # nothing of a source tree beside it
tapfit --version >version
says version tapfit
tapfit update "$truss" >update
says update "error ladder"
tried program

# Where no test is named: the one that is installed.
tapfit hits --help >help
says help "$prefix/share/tapfit/recordings/solar-panel-frame"
printf 'wait\nq\n' >keys
tapfit tour --keys keys --width 120 --height 30 >screen
says screen run-01.flac
tried demonstration

page=$prefix/share/man/man1/tapfit.1
[ -e "$page" ] || page=$page.gz
[ -s "$page" ] || fail "no man page"
if command -v man >/dev/null; then
  man --warnings -l "$page" >man 2>warnings
  [ ! -s warnings ] || fail "$(cat warnings)"
  # Every command of the program stands in it.
  col -b <man >plain
  tapfit --help | LC_ALL=C sed -n '/^Commands:/,$s/^  \([a-z]\{1,\}\)[, ].*/\1/p' >commands
  [ "$(wc -l <commands)" -gt 20 ] || fail "no commands in --help"
  while read -r command; do
    grep -qE "^ +$command( |\$)" plain || fail "man page: no '$command'"
  done <commands
  tried man page
fi

if command -v bash >/dev/null; then
  bash -eu -c '
    . "$1/share/bash-completion/completions/tapfit"
    COMP_WORDS=(tapfit mod) COMP_CWORD=1
    _tapfit || : # compopt is for the shell at work
    echo "${COMPREPLY[@]}"
    COMP_WORDS=(tapfit modes --js) COMP_CWORD=2
    _tapfit || :
    echo "${COMPREPLY[@]}"' bash "$prefix" >completed
  says completed "modes model"
  says completed --json
  tried completion
fi

entry=$prefix/share/applications/tapfit.desktop
says "$entry" "Exec=tapfit"
if command -v desktop-file-validate >/dev/null; then
  desktop-file-validate "$entry" || fail "$entry"
  tried desktop entry
fi

for page in README.md docs/commands.md docs/tutorial.md docs/effects/joint.md; do
  [ -s "$pages/$page" ] || fail "no page $page"
done
tried pages

package=$(find "$prefix"/lib* -name tapfitConfig.cmake)
if [ -n "$package" ] && command -v cmake >/dev/null; then
  cmake -S "$pages/examples/modes_of_a_test" -B build \
    -DCMAKE_PREFIX_PATH="$prefix" >configured 2>&1 || fail "$(cat configured)"
  cmake --build build >built 2>&1 || fail "$(cat built)"
  build/modes_of_a_test "$wing" >modes
  says modes Hz
  tried project on the libraries
fi

if command -v python3 >/dev/null; then
  python3 "$pages/examples/python/modes.py" "$wing" >from_json
  says from_json Hz
  # The same frequencies, from the libraries and by way of --json.
  if [ -s modes ]; then
    awk '{print $1}' modes >of_libraries
    awk '{print $1}' from_json >of_python
    cmp of_libraries of_python || fail "modes differ"
  fi
  tried Python example
fi
