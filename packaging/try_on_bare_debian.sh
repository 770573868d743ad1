#!/bin/sh
# Makes the Debian packages, installs them in a Debian 12 that has nothing but
# itself, and tries what is installed. Needs root and debootstrap, takes some
# minutes and a gigabyte.
#   packaging/try_on_bare_debian.sh [BUILD_FOLDER]   (default: build/release)
set -eu
build=$(cd "${1:-build/release}" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
bare=$(mktemp -d)
chmod 755 "$bare" # its users are others than root
trap 'umount "$bare/proc" 2>/dev/null; rm -rf --one-file-system "$bare"' EXIT

debootstrap --variant=minbase bookworm "$bare" >&2
(cd "$build" && cpack -B "$bare/packages" >&2)
mount -t proc proc "$bare/proc"
cp "$here/try_installed.sh" "$bare/"
in_bare() { chroot "$bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
install_in_bare() {
  in_bare DEBIAN_FRONTEND=noninteractive apt-get install -qq -y \
    --no-install-recommends "$@" >&2
}

install_in_bare $(cd "$bare" && echo ./packages/tapfit_*.deb)
in_bare useradd --create-home engineer
echo "with the program alone:"
in_bare setpriv --reuid engineer --regid engineer --clear-groups \
  sh /try_installed.sh /usr
install_in_bare $(cd "$bare" && echo ./packages/libtapfit-dev_*.deb) \
  g++ make cmake python3 man-db bsdextrautils desktop-file-utils
echo "with the libraries:"
in_bare setpriv --reuid engineer --regid engineer --clear-groups \
  sh /try_installed.sh /usr
