#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A program finds the installed library, shared and static, by pkg-config;
# uninstall leaves no file behind.
. "$TOP/tests/support/cli.sh"
[ -z "$INSTRUMENTED" ] || skip "instrumented libraries are not installed"

prefix=$PWD/prefix
# -o all: what is built is installed, with whatever flags it was built.
for_make() {
    expect 0 make -C "$TOP" -o all "$1" BUILD="$BUILD" PREFIX="$prefix"
}
for_make install

cat >user.c <<END
#include <overroll/overroll.h>
#include <stdio.h>

int main(void)
{
    ovr_conditions given = ovr_conditions_unknown();
    ovr_contact contact;
    ovr_error err;
    given.M = 20;
    given.L = 10;
    if (ovr_contact_resolve(&given, &contact, &err) != OVR_OK) {
        fprintf(stderr, "%s\n", err.message);
        return 1;
    }
    printf("%.4f\n", contact.alphabar);
    return 0;
}
END
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
flags=$(pkg-config --cflags --libs overroll) || fail "no overroll.pc"
# shellcheck disable=SC2086 # lists of words
expect 0 $CC user.c $flags -Wl,-rpath,"$prefix/lib" -o user
expect 0 ./user
contains out '^17.841'
readelf -d user >dynamic
contains dynamic "NEEDED.*liboverroll.so.0"

rm "$prefix"/lib/liboverroll.so*
flags=$(pkg-config --static --cflags --libs overroll)
# shellcheck disable=SC2086
expect 0 $CC user.c $flags -o user
expect 0 ./user
contains out '^17.841'
expect 0 "$prefix/bin/overroll" --version

for_make uninstall
find "$prefix" ! -type d >left
[ ! -s left ] || fail "uninstall leaves $(cat left)"
