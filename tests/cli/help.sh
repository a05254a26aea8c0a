#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# overroll help: its examples are valid cases and studies without a warning, and
# defaults that a sentence describes are those of a resolved case.
. "$TOP/tests/support/cli.sh"

# example TOPIC: its indented lines that are sections and keys.
example() {
    "$OVERROLL" help "$1" | sed -n 's/^    \(\[.*\]\)$/\1/p
        s/^    \([a-zA-Z_0-9.]* = .*\)$/\1/p' >"$1.ini"
    [ "$(wc -l <"$1.ini")" -ge 3 ] || fail "no example in help $1"
}

# accepted TOPIC SETTINGS...: the example with the remaining keys is a case.
accepted() {
    topic=$1
    shift
    example "$topic"
    for setting; do
        set -- "$@" --set "$setting"
        shift
    done
    expect 0 "$OVERROLL" check "$topic.ini" -q "$@"
    [ ! -s err ] || fail "help $topic: $(cat err)"
}


# discs TOPIC SETTINGS...: the same with a lubricant, load and material.
discs() {
    accepted "$@" contact.load=200kN/m contact.modulus=226GPa \
        lubricant.viscosity=40mPa.s 'lubricant.alpha=20 1/GPa'
}

# roller TOPIC SETTINGS...: also with radius and speed.
roller() {
    discs "$@" contact.radius=10mm contact.mean_speed=3m/s
}

roller friction
discs rpm
roller grease
roller life time.end=6 time.step=0.02 feature.d.shape=dent \
    feature.d.depth=0.2um feature.d.width=50um feature.d.start=-3
roller wear contact.slide_to_roll=0.1 boundary.friction=0.1 \
    lubricant.rheology=eyring lubricant.eyring_stress=5MPa \
    lubricant.limiting_shear=0.08 feature.r.shape=roughness \
    feature.r.Rq=0.1um feature.r.length=2mm
awk 'BEGIN { print "x [mm], z [um]"
    for (k = 0; k < 400; k++) print k * 0.005, 0.1 * sin(k * 0.4) }' >ground.csv
roller roughness
awk 'BEGIN { for (j = 0; j < 40; j++) { for (k = 0; k < 60; k++)
    printf "%g ", 0.05 * sin(k * 0.5) * cos(j * 0.4); print "" } }' >ground.x3p
roller areal feature.ground.unit_z=um feature.ground.spacing=5um

# Studies, of a case that has their keys.
for name in dent rollers; do
    cat >$name.ini <<'END'
[contact]
load = 200 kN/m
radius = 10 mm
modulus = 226 GPa
mean_speed = 3 m/s
slide_to_roll = 0.1
[lubricant]
viscosity = 40 mPa.s
alpha = 20 1/GPa
rheology = eyring
eyring_stress = 5 MPa
limiting_shear = 0.08
END
done
cat >>dent.ini <<'END'
[time]
end = 4
[feature dent]
shape = dent
depth = 0.2 um
width = 0.1 mm
[feature rough]
shape = roughness
surface = 2
Rq = 0.02 um
length = 2 mm
END
cat >>rollers.ini <<'END'
[boundary]
law = exponential
Rq = 0.2 um
slope = 0.05
friction = 0.12
END
for topic in study random stribeck; do
    example $topic
    expect 0 "$OVERROLL" sweep $topic.ini --list -o results
    [ ! -s err ] || fail "help $topic: $(cat err)"
    wc -l <out >>cases
done
[ "$(tr -d '\n ' <cases)" = 646425 ] || fail "cases: $(cat cases)"

# Defaults. Of alpha with M and L, of z without and with a viscosity.
refuses 'unknown key .smoother. in .solver.; it is a key of .paper.' \
    steady --M 20 --L 10 --set solver.smoother=line
expect 0 "$OVERROLL" check --M 20 --L 10 -v
contains out 'alpha at p = 0 +17 1/GPa'
contains out 'Roelands +z = 0\.68'
expect 0 "$OVERROLL" check --M 20 --L 10 --set contact.radius=10mm \
    --set contact.modulus=226GPa --set contact.viscosity=0.04Pa.s -v
# alpha p0/(ln eta0 + 9.67) = 17e-9 198e6/(ln 0.04 + 9.67)
contains out 'Roelands +z = 0\.5217[78]'
# Of a strip: 2 b, a mesh across of at most 1.6 times that along.
printf '[contact]\nM = 20\nL = 10\n[strip]\n' >strip.ini
for level in 5 6 7; do
    expect 0 "$OVERROLL" check strip.ini --level $level
    sed -n 's/.*2 b wide.*x \([0-9]*\) nodes, mesh sizes \(.*\) x.*/\1 \2/p' \
        out >grid
    awk '{ ratio = 2/$1/$2; found = ratio > 0.6 && ratio < 1.605 }
        END { exit !found }' grid || fail "mesh of a strip: $(cat grid out)"
done

# A dent from X = -2 at u_m is at -1, 0 and 1.5 at T = 1, 2 and 3.5.
dent_case 4 4 0.05 0.8 -2 >moving.ini
expect 0 "$OVERROLL" run moving.ini -q -o moving.h5 \
    --set output.feature_at='-1, 0, 1.5'
expect 0 "$OVERROLL" export moving.h5 --at 0
[ "$(sed 1d out | cut -d, -f1 | tr '\n' ' ')" = '1 2 3.5 ' ] ||
    fail "snapshots: $(cat out)"

# A steady contact is solved with fully grown features and without [time].
dent_case 5 4 0.05 0.8 0 >steady.ini
for setting in feature.dent.grow=2 time.end=9; do
    expect 0 "$OVERROLL" steady steady.ini --json -q
    mv out plain
    expect 0 "$OVERROLL" steady steady.ini --json -q --set $setting
    film=$(number H_cen)
    [ -n "$film" ] && [ "$film" = "$(number H_cen plain)" ] ||
        fail "$setting: $(cat out)"
done

# Level 9 where the mesh of level 8 exceeds a tenth of H^(2/3): at M = 615, L =
# 2 with H = 7.1e-4, not at M = 20 with H = 0.084; 12 at most.
for row in '20 10 8' '615 2 9' '4900 0.5 12'; do
    # shellcheck disable=SC2086 # three words
    set -- $row
    expect 0 "$OVERROLL" check --M "$1" --L "$2" --json -q
    [ "$(number level)" -le "$3" ] || fail "M = $1: level $(number level)"
    [ "$3" = 12 ] || [ "$(number level)" = "$3" ] ||
        fail "M = $1: level $(number level)"
done
