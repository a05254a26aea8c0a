#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What README.md promises a newcomer, on a fresh Debian 12 with git and nothing
# else, made in a folder: tools/check, then again as a plain user once all is
# there, and tools/demo.  Takes root, debootstrap, a network and 1 GB.
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

# there COMMAND: runs it in the sources on that machine.
there() {
    env -i HOME=/root TERM=dumb PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        chroot "$machine" sh -c "cd /overroll && $1"
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
