#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The recipes of tools/packaging and tools/debian have the version of the
# headers, and require every library with which the Makefile links.
. "$TOP/tests/support/cli.sh"
ln -s "$TOP/tools" "$TOP/include" "$TOP/Makefile" .
at=tools/packaging

version=$(sed -n \
    's/.*OVERROLL_VERSION "\(.*\)"/\1/p' include/overroll/version.h)
grep -q "version: \"$version\"" $at/conda/meta.yaml ||
    fail 'meta.yaml: version'
grep -q "overroll-$version.tar.gz" $at/overroll.rb ||
    fail 'overroll.rb: version'
grep -q "^version: $version$" $at/CITATION.cff || fail 'CITATION.cff: version'

found=
# NAME as pkg-config, conda-forge, Homebrew and Debian call it
while read -r name conda brew debian; do
    grep -q "^    - $conda$" $at/conda/meta.yaml ||
        fail "meta.yaml: no $conda"
    grep -q "depends_on \"$brew\"" $at/overroll.rb ||
        fail "overroll.rb: no $brew"
    for file in $at/Containerfile tools/debian/control; do
        grep -Eq "(^| )$debian(,| |$)" "$file" || fail "$file: no $debian"
    done
    found="$found $name"
done <<END
gsl gsl gsl libgsl-dev
zlib zlib zlib zlib1g-dev
libdeflate libdeflate libdeflate libdeflate-dev
expat expat expat libexpat1-dev
nettle nettle nettle nettle-dev
fftw3 fftw fftw libfftw3-dev
fftw3f fftw fftw libfftw3-dev
hdf5 hdf5 hdf5 libhdf5-dev
END
for name in $(sed -n 's/^PKGS := //p' Makefile); do
    case " $found " in
    *" $name "*) ;;
    *) fail "no recipe asks for $name" ;;
    esac
done

if command -v ruby >/dev/null; then
    expect 0 ruby -c $at/overroll.rb
fi
if python3 -c 'import yaml' 2>/dev/null; then
    expect 0 python3 - <<'END'
import re
import yaml
at = "tools/packaging/"
cff = yaml.safe_load(open(at + "CITATION.cff"))
assert {"cff-version", "message", "title", "authors", "version"} <= set(cff)
recipe = re.sub(r"{{.*?}}", "x", open(at + "conda/meta.yaml").read())
assert yaml.safe_load(recipe)["requirements"]["host"]
END
fi
