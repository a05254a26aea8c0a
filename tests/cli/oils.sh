#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Bodies, rotational speeds, forces, data sheets, lubricant relations with
# their constants, and tables: from a case to the resolved contact.
. "$TOP/tests/support/cli.sh"

# number KEY: its value in `out`, JSON
number() {
    sed -n "s/^ *\"$1\": \([-0-9.e+]*\),*\$/\1/p" out
}

# near KEY WANTED RELATIVE
near() {
    awk -v is="$(number "$1")" -v wanted="$2" -v tolerance="$3" 'BEGIN {
        d = is - wanted; d = d < 0 ? -d : d; w = wanted < 0 ? -wanted : wanted
        exit !(is != "" && d <= tolerance * w) }' ||
        fail "$1 is '$(number "$1")', wanted $2 within $3"
}

cat >discs.ini <<'END'
[contact]
width = 10 mm
load = 2000 N
speed_1 = 1000 rpm
speed_2 = 500 rpm
[body 1]
material = steel
radius = 40 mm
[body 2]
modulus = 82 GPa
poisson = 0.206
radius = 60 mm
[lubricant]
temperature = 70 degC
viscosity_40 = 46 mm2/s
viscosity_100 = 6.8 mm2/s
density_15 = 870 kg/m3
alpha = 20 1/GPa
END
expect 0 "$OVERROLL" check discs.ini --json
near load_N_per_m 2e5 1e-12
near load_N 2000 1e-12
near radius_m 0.024 1e-12
# 2/(0.91/206 + (1 - 0.206^2)/82) GPa
near modulus_Pa 124.2615e9 1e-6
# (1000*0.04 + 500*0.06) pi/60
near mean_speed_m_per_s 3.665191 1e-6
# nu(70 degC) by ASTM D341, computed apart: 14.84726 mm2/s; times 838.9 kg/m3
near viscosity_Pa_s 0.012455325 1e-6
near alpha_per_Pa 2e-8 1e-12

# an internal contact
expect 0 "$OVERROLL" check discs.ini --json --set 'body 2.radius=-60 mm'
near radius_m 0.12 1e-12
expect 0 "$OVERROLL" check discs.ini --json --set 'body 2.radius=flat' \
    --set 'contact.speed_2=1 m/s'
near radius_m 0.04 1e-12
expect 2 "$OVERROLL" check discs.ini --set 'body 2.radius=flat'
contains err 'speed_2.*needs a radius in \[body 2\]'
expect 2 "$OVERROLL" check discs.ini --set 'body 2.radius=-30 mm'
contains err 'do not touch'
expect 2 "$OVERROLL" check discs.ini --set 'contact.radius=1 mm'
contains err 'radius.*is already determined by'
sed '/width/d' discs.ini >no_width.ini
expect 2 "$OVERROLL" check no_width.ini
contains err 'no_width.ini:2: load: 2000 N needs contact.width'
expect 2 "$OVERROLL" check discs.ini --set 'lubricant.viscosity=40 mPa.s'
contains err 'viscosity'

# A law with constants of its own runs, and its table gives the same film.
cat >doolittle.ini <<'END'
[contact]
M = 20
L = 10
[lubricant]
viscosity_law = doolittle
density_law = tait
doolittle_B = 4.2
doolittle_R0 = 0.66
tait_K0 = 1.3 GPa
tait_K0_slope = 11
[domain]
level = 6
END
expect 0 "$OVERROLL" check doolittle.ini --json
near alpha_per_Pa 1.844557e-8 1e-6
expect 0 "$OVERROLL" steady doolittle.ini --json
film=$(number H_cen)
[ -n "$film" ] || fail 'no film'
awk 'BEGIN {
    print "# pressure [MPa], viscosity [mPa.s]"
    for (i = 0; i <= 400; i++) {
        p = 4 * i
        v = 1 - log(1 + 12 * p / 1300) / 12
        printf "%.17g %.17g\n", p, \
            10 * exp(4.2 * 0.66 * (1 / (v - 0.66) - 1 / 0.34))
    }
}' >eta.txt
awk 'BEGIN {
    print "density (g/cm3); p in MPa"
    for (i = 0; i <= 400; i++) {
        p = 4 * i
        printf "%.17g; %.17g\n", 0.85 / (1 - log(1 + 12 * p / 1300) / 12), p
    }
}' >rho.txt
sed '/law/d;/doolittle/d;/tait/d' doolittle.ini >table.ini
expect 0 "$OVERROLL" steady table.ini --json \
    --set lubricant.viscosity_law=table --set lubricant.density_law=table \
    --set lubricant.viscosity_file=eta.txt --set lubricant.density_file=rho.txt
near H_cen "$film" 2e-3

expect 2 "$OVERROLL" check doolittle.ini --set 'lubricant.alpha=20 1/GPa'
contains err 'alpha is already determined by viscosity_law'
sed '/tait_K0 /d' doolittle.ini >lacks.ini
expect 2 "$OVERROLL" check lacks.ini
contains err 'needs tait_K0'
for wrong in 'pressure [MPa] viscosity
0 1' 'pressure [MPa], viscosity [mPa.s]
0 1
1 x' 'pressure [MPa], viscosity [mPa.s]
0 2
10 1' ''; do
    printf '%s\n' "$wrong" >eta.txt
    expect 2 "$OVERROLL" check table.ini \
        --set lubricant.viscosity_law=table \
        --set lubricant.viscosity_file=eta.txt
    contains err 'eta.txt'
done

# A mineral oil by grade and index: the viscosity by Walther between 40 and 100
# degC as before, with 870 kg/m3; alpha by Roelands' relation from it.
sed '/^viscosity_40/,/^alpha/d' discs.ini >mineral.ini
printf 'iso_vg = 46\nviscosity_index = 95\noil = mineral\n' >>mineral.ini
sed '/^viscosity_40/,/^alpha/d' discs.ini >whole.ini
printf 'iso_vg = 46\nviscosity_index = 95\ndensity_15 = 870 kg/m3\n' >>whole.ini
printf 'alpha = 20 1/GPa\n' >>whole.ini
expect 0 "$OVERROLL" check whole.ini --json
eta=$(number viscosity_Pa_s)
expect 0 "$OVERROLL" check mineral.ini --json
near viscosity_Pa_s "$eta" 1e-12
near alpha_per_Pa "$(awk -v eta="$eta" \
    'BEGIN { printf "%.17g", 0.68 * (log(eta) + 9.67) / 198e6 }')" 1e-12
contains err 'alpha = .* is an estimate from the viscosity'
# What is given is taken, and nothing said.
printf 'alpha = 20 1/GPa\n' >>mineral.ini
expect 0 "$OVERROLL" check mineral.ini --json
near alpha_per_Pa 2e-8 1e-12
! grep estimate err || fail 'an alpha that was given is called an estimate'
sed '/iso_vg/d; /viscosity_index/d; /^alpha/d; /^temperature/d' mineral.ini \
    >none.ini
refuses 'oil = mineral needs iso_vg' check none.ini
# A grade alone does not determine viscosity at temperature: one message lists
# everything that is missing.
sed '/viscosity_index/d' mineral.ini >grade.ini
refuses 'the viscosity from a data sheet needs viscosity_index' check grade.ini
sed '/^temperature/d; /^oil/d; /^density/d; /^alpha/d' grade.ini >bare.ini
refuses 'needs temperature.*viscosity_index.*95.*alpha' check bare.ini
# Without a density the viscosity is that of an oil of 870 kg/m3.
printf 'iso_vg = 68\nviscosity_index = 95\ntemperature = 60 degC\n' >sheet
for density in 870 900 default; do
    {
        printf '[contact]\nload = 200 kN/m\nradius = 10 mm\n'
        printf 'modulus = 226 GPa\nmean_speed = 2 m/s\n[lubricant]\n'
        printf 'alpha = 20 1/GPa\n'
        cat sheet
        [ $density = default ] || echo "density_15 = $density kg/m3"
    } >density.ini
    expect 0 "$OVERROLL" check density.ini -v
    grep '^#   viscosity eta0' out >eta.$density
    cp out density.$density
done
cmp eta.default eta.870 || fail 'the default density is not 870 kg/m3'
! cmp -s eta.default eta.900 || fail 'density has no effect'
contains density.default '^density_15 = 870 kg/m3 +# default'
printf 'viscosity_100 = 6.8 mm2/s\n' >>mineral.ini
refuses 'viscosity_100 and viscosity_index determine each other' \
    check mineral.ini
sed -i '/^viscosity_100/d' mineral.ini
# VG 68 or 100 at 80 degC, one study: other viscosities, other alphas.
cat >study.ini <<'END'
[study]
case = base.ini
[product]
lubricant.iso_vg = 68, 100
END
sed '/^alpha/d; s/^temperature.*/temperature = 80 degC/' mineral.ini >base.ini
printf '[domain]\nlevel = 5\n' >>base.ini
expect 0 "$OVERROLL" sweep study.ini -o grades -q
expect 0 "$OVERROLL" sweep study.ini -o grades -q --collect grades.csv
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    { h[NR] = $at["central_film_m"]; a[NR] = $at["alphabar"] }
    END { exit !(NR == 3 && h[3] > 1.15 * h[2] && a[3] > 1.02 * a[2]) }' \
    grades.csv || fail "grades: $(cat grades.csv)"
