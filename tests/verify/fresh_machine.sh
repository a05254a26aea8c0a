#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Statements of README.md on a fresh Debian 12 with only git, created in a
# folder: tools/check, again as a plain user after the installation of
# dependencies, tools/demo, the installation, the program of
# overroll-library(3), the tour, the cases of init, the web page.
# Needs root, debootstrap, a network and 1 GB.
. "$TOP/tests/support/cli.sh"
[ -z "$INSTRUMENTED" ] || skip "once is enough"
[ "$(id -u)" -eq 0 ] || skip "needs root"
need debootstrap git

machine=$PWD/machine
mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
debootstrap --variant=minbase --include=git bookworm "$machine" "$mirror" \
    >log 2>&1 || skip "no fresh machine: $(tail -n 1 log)"
rm -rf "$machine"/var/lib/apt/lists/*
cp /etc/resolv.conf "$machine/etc/resolv.conf"
git clone -q "$TOP" "$machine/overroll" || fail "cannot clone"

# there COMMAND: runs it in the sources on that machine, whose /proc and shared
# memory go with the command.
there() {
    # shellcheck disable=SC2016 # expanded there
    env -i HOME=/root TERM=dumb PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        unshare --mount --propagation private sh -ec \
        'mount -t proc proc "$0/proc"; mkdir -p "$0/dev/shm"
        mount -t tmpfs -o mode=1777 tmpfs "$0/dev/shm"
        exec chroot "$0" sh -c "$1"' \
        "$machine" "cd /overroll && $1"
}

expect 127 there make
expect 0 there tools/check
tail -n 1 out | grep -q '^[0-9]* passed, 0 failed' ||
    fail "tools/check ends in: $(tail -n 1 out)"
expect 0 there 'useradd user && chown -R user . && rm -rf build'
expect 0 there 'su user -c tools/check'
expect 0 there 'su user -c tools/demo'
tail -n 1 out | grep -q '^demo: ' ||
    fail "tools/demo ends in: $(tail -n 1 out)"
[ -s "$machine/overroll/build/demo/dent.h5" ] || fail "no result file"
[ -s "$machine/overroll/build/demo/dent.png" ] || fail "no picture"

# Installed: a program of one's own, and the tour of README.md.
expect 0 there 'make install && ldconfig'
sed -n '/^\.\\" ridge/,/^\.EE/p' "$TOP/src/run/overroll-library.3" |
    sed '1,2d; $d; s/\\-/-/g; s/\\e/\\/g' >"$machine/tmp/user.c"
# shellcheck disable=SC2016 # expanded there
expect 0 there 'cd /tmp && cc user.c $(pkg-config --cflags --libs overroll) \
    -lm -o user && ./user'
contains out '^T = 3.44  H_min = 0.06'
mkdir "$machine/tmp/tour"
# shellcheck disable=SC2016 # no expansion wanted
sed -n '/^```sh$/,/^```$/p' "$TOP/README.md" | grep -v '^```' \
    >"$machine/tmp/tour/tour"
expect 0 there 'TMPDIR=/tmp/tour sh -eu /tmp/tour/tour'
find "$machine/tmp/tour" -name study.nc -size +0 | grep -q . ||
    fail "the tour ends without study.nc"
# A case that init writes runs at its own level without a warning.
for kind in roller gear cam bearing indented coated numbers starved discs hot \
    strip; do
    expect 0 there "build/overroll init $kind -o /tmp/$kind.ini &&
        build/overroll run /tmp/$kind.ini -o /tmp/$kind.h5"
    ! grep warning err || fail "init $kind warns: $(cat err)"
done
# The web page, with the compilers and the Node of this system.
expect 0 there 'tools/install-deps web && make web'
[ -s "$machine/overroll/build/web/overroll.html" ] || fail "no web page"
