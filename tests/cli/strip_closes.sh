#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Features that are not periodic in the width of a strip are rejected, and the
# values in the message are accepted, for each shape.
. "$TOP/tests/support/cli.sh"

# try NUMBER KEY VALUE LINE...: the feature is refused for that value of the
# key, with as many values of the key that do, or of another key.
try() {
    count=$1 key=$2 value=$3
    shift 3
    {
        printf '%s\n' '[contact]' 'M = 20' 'L = 10' '[domain]' 'level = 5' \
            '[strip]' 'width = 2' '[feature f]' "$@"
    } >case.ini
    case $key in *.*) name=$key ;; *) name=feature.f.$key ;; esac
    expect 2 "$OVERROLL" check case.ini --set "$name=$value"
    grep -o '[ =][0-9][0-9.e-]*' err | tr -d ' =' | tail -n "$count" >offered
    [ "$(wc -l <offered)" = "$count" ] || fail "$1 $key = $value: $(cat err)"
    while read -r other; do
        "$OVERROLL" check case.ini --set "$name=$other" >said 2>&1 ||
            fail "$1 $key = $value: $(cat err); $other: $(cat said)"
    done <offered
}

wave='shape = wave'
try 2 wavelength 0.3 "$wave" 'amplitude = 0.01' 'angle = 40 deg'
contains err 'wavelength = 0.3 is not periodic .* the nearest values are'
try 1 wavelength 1.9 "$wave" 'amplitude = 0.01' 'angle = 40 deg'
contains err 'must be at most'
try 2 wavelength_across 0.3 "$wave" 'amplitude = 0.01' 'wavelength = 0.5'
try 2 wavelength 0.31 "$wave" 'amplitude = 0.01' 'angle = 30 deg' \
    'wavelength_across = 0.34641016151377546'
try 2 wavelength_across 0.3 'shape = texture' 'depth = 0.01' 'width = 0.2' \
    'wavelength = 0.6'
for shape in groove ridge; do
    height=$([ $shape = groove ] && echo depth || echo height)
    try 2 repeat 0.35 "shape = $shape" "$height = 0.02" 'width = 0.1' \
        'angle = 35 deg' 'start = -2'
    # Without repeat both are offered.
    sed -i '/repeat/d' case.ini
    refuses "an endless $shape at an angle repeats along x; set repeat =" \
        check case.ini
done
for shape in dent bump indent; do
    height=$([ $shape = bump ] && echo height || echo depth)
    try 2 repeat 0.35 "shape = $shape" "$height = 0.02" 'width = 0.1' \
        'angle = 35 deg' 'start = -2' 'width_across = endless'
done
for shape in step chirp; do
    printf '%s\n' '[contact]' 'M = 20' 'L = 10' '[strip]' '[feature f]' \
        "shape = $shape" 'angle = 35 deg' >case.ini
    if [ $shape = step ]; then
        printf '%s\n' 'height = 0.02' 'flank = 0.1' >>case.ini
    else
        printf '%s\n' 'amplitude = 0.02' 'wavelength = 0.4' \
            'wavelength_end = 0.2' 'length = 3' >>case.ini
    fi
    refuses "a $shape at an angle is not periodic in the width" \
        check case.ini
done

# A map: widths of the strip.
awk 'BEGIN { for (j = 0; j < 40; j++) { for (i = 0; i < 80; i++)
    printf "%g ", sin(0.4 * i) * cos(0.3 * j); print "" } }' >map.txt
try 2 strip.width 3.1 'shape = areal' 'file = map.txt' 'unit_z = b^2/R' \
    'spacing = 0.05' 'scale = 0.01'
contains err 'set strip.width to'
