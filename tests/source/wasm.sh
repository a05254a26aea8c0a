#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every source file compiles for WebAssembly with the C library of the web page
# (make web). A call of a missing function is detected here, without building
# the libraries, which takes minutes.
. "$TOP/tests/support/cli.sh"
need clang
[ -e /usr/include/wasm32-wasi ] || skip 'no wasi-libc'
mkdir include

# The headers of the libraries are those installed here, and no others: the C
# library of this system would hide what is missing in the page's.
cat >libraries.c <<'END'
#include <expat.h>
#include <fftw3.h>
#include <gsl/gsl_cdf.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <libdeflate.h>
#include <nettle/md5.h>
#include <zlib.h>
END
# shellcheck disable=SC2086 # CC may be a command and its options
(cd "$TOP" && $CC $TEST_CFLAGS -M "$OLDPWD/libraries.c") |
    tr ' ' '\n' >headers || fail 'no headers of the libraries'
while read -r path; do
    case $path in
    */gsl/*.h | */nettle/*.h) path=${path%/*} ;;
    */hdf5*.h | */H5*.h | */fftw3.h | */expat*.h | */libdeflate.h | */zlib.h | \
        */zconf.h) ;;
    *) continue ;;
    esac
    ln -sfn "$path" "include/${path##*/}" || fail "$path"
done <headers

# The command that the driver would start for the first file, with all others
# behind it: one process, which takes a fifth of the time of one for each.
flags=$(make -s -C "$TOP" BUILD="$BUILD" WEB_LIBS="$PWD" web-flags)
compiles() { # FILE...
    first=$1
    shift
    # shellcheck disable=SC2086 # many options
    command=$(${flags% -w} -Wno-everything \
        -Werror=implicit-function-declaration -DOVR_ISA=base \
        -fsyntax-only -### "$first" 2>&1 | tail -n 1) # (-w would win)
    eval "$command \"\$@\""
}
here=$PWD
cd "$TOP" || exit 1
for call in 'popen("", "r")' 'missing_here()'; do
    printf '#include <stdio.h>\n#include <unistd.h>\nvoid f(void);\n%s\n' \
        "void f(void) { (void)$call; }" >"$here/probe.c"
    compiles src/web/system.c "$here/probe.c" 2>/dev/null &&
        fail "$call is not missed"
done
compiles src/*/*.c src/*/*/*.c || fail 'does not compile for the page'
