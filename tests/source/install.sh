#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# pkg-config finds the installed library, shared and static, and a program links
# with it. uninstall leaves no file and no empty folder.
. "$TOP/tests/support/cli.sh"
[ -z "$INSTRUMENTED" ] || skip "instrumented libraries are not installed"

prefix=$PWD/prefix
# -o all: what is built is installed, with whatever flags it was built.
for_make() {
    expect 0 make -C "$TOP" -o all "$1" BUILD="$BUILD" PREFIX="$prefix"
}
for_make install

# The example of overroll-library(3): 40 lines.
man=$prefix/share/man
sed -n '/^\.\\" ridge/,/^\.EE/p' "$man/man3/overroll-library.3" |
    sed '1,2d; $d; s/\\-/-/g; s/\\e/\\/g' >user.c
[ "$(wc -l <user.c)" -eq 40 ] || fail 'the example is not of 40 lines'
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
# Compiled as its SYNOPSIS says, pasted; and without any warning.
sed -n '/^\.B cc user/,/^\.fi/p' "$man/man3/overroll-library.3" |
    sed '$d; s/^\.B *//; s/"//g; s/\\-/-/g; s/\\e/\\/g' >compile
[ "$(wc -l <compile)" -eq 2 ] || fail "$(cat compile)"
expect 0 sh -e compile
expect 0 ./user
contains out '^T = 0.00  H_min = 0.073. at 0.96'
contains out '^T = 3.44  H_min = 0.06.. at -0.51'
# Only compiled: clang refuses a linker's words where nothing is linked.
flags=$(pkg-config --cflags overroll) || fail "no overroll.pc"
# shellcheck disable=SC2086 # lists of words
expect 0 $CC -Wall -Wextra -Wpedantic -Werror -c user.c $flags -o user.o
readelf -d user >dynamic
contains dynamic "NEEDED.*liboverroll.so.0"

rm "$prefix"/lib/liboverroll.so*
flags=$(pkg-config --static --cflags --libs overroll)
# shellcheck disable=SC2086
expect 0 $CC user.c $flags -o user
expect 0 ./user
contains out '^T = 3.44  H_min = 0.06.. at -0.51'
expect 0 "$prefix/bin/overroll" --version

# Manual pages are where man looks, and bash completes.
for page in man1/overroll.1 man3/overroll-library.3 man5/overroll-case.5 \
    man5/overroll-study.5 man5/overroll-result.5 man7/overroll-theory.7 \
    man7/overroll-reading.7 man7/overroll-pictures.7 \
    man7/overroll-recipes.7 man7/overroll-tutorial.7; do
    [ -s "$man/$page" ] || fail "$page is not installed"
done
completed() {
    bash -c '. "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
        _overroll; echo "${COMPREPLY[@]}"' \
        "$prefix/share/bash-completion/completions/overroll" "$@"
}
[ "$(completed overroll sw)" = sweep ] || fail 'sw is not completed to sweep'
[ "$(completed overroll sweep --col)" = --collect ] || fail '--col'

# What was installed is taken out, whatever this version would install, and
# nothing else; where nothing is, it says where it looked.
: >"$prefix/include/overroll/of_mine.h"
: >"$prefix/include/overroll/of_an_older_version.h"
echo "$prefix/include/overroll/of_an_older_version.h" \
    >>"$prefix/share/overroll/manifest"
for_make uninstall
find "$prefix" ! -type d >left
[ "$(cat left)" = "$prefix/include/overroll/of_mine.h" ] ||
    fail "uninstall leaves $(cat left)"
expect 2 make -C "$TOP" -o all uninstall BUILD="$BUILD" PREFIX="$prefix"
contains err "nothing is installed in $prefix: .*PREFIX=... looks elsewhere"
# Empty folders that install has created are removed, also after it was run
# twice. Others remain.
find "$prefix" -type d | sort >left
printf '%s\n' "$prefix" "$prefix/include" "$prefix/include/overroll" |
    cmp -s - left || fail "uninstall leaves $(cat left)"
rm -r "$prefix"
mkdir -p "$prefix/lib" "$prefix/share/man"
for_make install
for_make install
mkdir "$prefix/bin/mine"
for_make uninstall
find "$prefix" | sort >left
printf '%s\n' "$prefix" "$prefix/bin" "$prefix/bin/mine" "$prefix/lib" \
    "$prefix/share" "$prefix/share/man" |
    cmp -s - left || fail "uninstall leaves $(cat left)"

# What make bench needs beyond tools/demo it says in a line.
printf '#!/bin/sh\ncase "$*" in *cmocka*) exit 1 ;; esac\n' >without
echo 'exec pkg-config "$@"' >>without
chmod +x without
expect 2 make -s -C "$TOP" bench BUILD="$BUILD" PKG_CONFIG="$PWD/without"
contains err 'make bench needs cmocka .*tools/install-deps check bench'
[ "$(wc -l <err)" -eq 1 ] || fail "more than a line: $(cat err)"
