#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installed manual pages and completion: overroll-case(5) contains every
# parameter of the table, and every option and key is completed.
. "$TOP/tests/support/cli.sh"

page=$BUILD/overroll-case.5
completion=$BUILD/overroll.bash
expect 0 "$OVERROLL" help --roff
sed -n '/^\.SH PARAMETERS/,/^\.SH SEE ALSO/p' "$page" | sed '1d;$d' >written
diff written out || fail 'overroll-case.5 is not the table'
grep -q '^\.B eyring_stress' "$page" || fail 'overroll-case.5 lacks a key'

[ "$(grep -c '^\.B eyring_stress' "$TOP/src/case/overroll-case.5")" -eq 0 ] ||
    fail 'overroll-case.5 in the tree holds rows of the table'

# Values are completed: those of options, keys behind --set, their words
if command -v bash >/dev/null; then
    # shellcheck disable=SC2016 # no expansion wanted
    complete='. "$COMPLETION"; COMP_WORDS=("$@")
        COMP_CWORD=$(($# - 1)); _overroll; echo "${COMPREPLY[*]}"'
    completes() { # WANTED WORDS...
        wanted=$1
        shift
        got=$(COMPLETION=$completion bash -c "$complete" bash "$@")
        [ "$got" = "$wanted" ] || fail "'$*' completes to '$got'"
    }
    completes 'map' overroll plot a.h5 --kind m
    kinds='snapshot history map trace stress risk depth passes element plastic'
    completes "$kinds distribution" \
        overroll plot a.h5 --kind ''
    completes 'csv' overroll export a.h5 --format c
    completes 'upstream1 upstream2' overroll run a.ini --scheme up
    completes 'contact.load=' overroll run a.ini --set contact.lo
    completes 'feature.dent.depth=' overroll run a.ini --set feature.dent.dep
    completes 'upstream1 upstream2' overroll run a.ini --set time.scheme = up
    completes 'yes no' overroll run a.ini --set feature.d.invert =
    completes 'contact.load' overroll find a.ini contact.lo
    completes 'between' overroll find a.ini contact.load betw
    completes '--kind' overroll plot a.h5 --ki
fi

# Every command and option is in overroll(1)
for option in set M L level scheme smoother force json help version; do
    grep -q -e "\\\\-\\\\-$option" "$TOP/src/cli/overroll.1" ||
        fail "overroll.1 lacks --$option"
done

expect 0 "$OVERROLL" help
commands=$(sed -n 's/^  \([a-z]*\)  .*/\1/p' out)
for command in $commands; do
    grep -qE "^\.(BI \"|B overroll )$command" "$TOP/src/cli/overroll.1" ||
        fail "overroll.1 lacks $command"
done

# help explains every section and command
for topic in contact lubricant domain solver time load speed feature output \
    paper steady run check init help units alpha feature.depth; do
    expect 0 "$OVERROLL" help $topic
    [ -s out ] || fail "nothing on $topic"
done
refuses "no topic 'levl'; did you mean 'level'" help levl

# ... and the terms and symbols of the field, in any spelling.
while IFS=: read -r words in; do
    expect 0 "$OVERROLL" help "$words"
    grep -qF "$in" out || fail "help $words without $in: $(cat out)"
done <<E
hertz:half width
HERTZ:half width
stribeck:mean_speed = log
roughness:shape = roughness
Rq:[boundary]
sigma:boundary.Rq
SRR:contact.slide_to_roll
Eyring:a value of lubricant.rheology
carreau:a value of lubricant.rheology
Young's modulus:[body]
maximum pressure:p_h
traction:See also: overroll help friction
slide-to-roll:(u1 - u2)
Viscosity:[lubricant]
VI:viscosity_index
E:Young's modulus
eta0:lubricant.viscosity
tau0:eyring_stress
wear:wear_1
film thickness:H_min
filmthickness:H_min
efficiency:power loss
movie:usage: overroll frames
csv:usage: overroll export
dlc:[coating]
bearing:[roller_bearing]
F-operation:removes the plane
S-filter:lambda_s
L-filter:lambda_c
areal:needs file
Sq:root mean square height
Sa:arithmetic
Ssk:skewness
Sku:kurtosis
Str:texture aspect ratio
peklenik:correlation lengths along and across
stagger:wavelength_across
spacing_across:distance of the rows
round dent:shape = indent
scratch:shape = groove
oblique:from the y axis
sensitivity:elasticities
footprint:extent across rolling
E
expect 0 "$OVERROLL" help lambda ratio
grep -q 'composite roughness' out || fail "no lambda ratio: $(cat out)"
expect 0 "$OVERROLL" run -h
grep -q '^usage: overroll run' out || fail "-h: $(cat out)"
expect 0 "$OVERROLL" init roller --output roller.ini
[ -s roller.ini ] || fail 'init --output wrote nothing'

# Usual symbols in a case lead to the keys.
while read -r given meant; do
    refuses "did you mean '$meant'" check roller.ini --set "$given=1"
done <<E
contact.E modulus' in .body 1. .Young's modulus., or 'modulus
contact.R radius
contact.u1 speed_1
lubricant.tau0 eyring_stress
E
refuses 'did you mean .body 1.' check roller.ini --set body1.x=1
refuses 'did you mean .lubricant.' check roller.ini --set oil.x=1

cp "$TOP"/src/*/overroll*.[1357] "$page" .
version=$(sed -n 's/.*OVERROLL_VERSION "\(.*\)"/\1/p' \
    "$TOP/include/overroll/version.h")
for page in overroll*.[1357]; do
    grep -q "^\.TH.*\"overroll $version\"" "$page" ||
        fail "$page: not version $version"
done
# Each public header is described.
for header in "$TOP"/include/overroll/*.h; do
    name=$(basename "$header")
    [ "$name" = overroll.h ] ||
        grep -qE "^\.IR? .*\b$name" overroll-library.3 ||
        fail "overroll-library.3 lacks $name"
done
# References lead somewhere.
# shellcheck disable=SC2013 # names without blanks
for name in $(sed -n 's/^\.BR \(overroll[a-z\\-]*\) (\([1357]\)).*/\1.\2/p' \
    overroll*.[1357] | sed 's/.-/-/g' | sort -u); do
    [ -e "$name" ] || fail "no page $name"
done
if command -v mandoc >/dev/null; then
    mandoc -Tlint -Wwarning overroll*.[1357] |
        grep -v 'date' >warnings
    [ ! -s warnings ] || fail "$(cat warnings)"
fi
if command -v groff >/dev/null; then
    for page in overroll*.[1357]; do
        groff -man -ww -Tutf8 "$page" 2>warnings >/dev/null
        [ ! -s warnings ] || fail "$page: $(cat warnings)"
    done
fi
