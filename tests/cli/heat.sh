#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# [heat]: a steady contact and a run from a case to files; resume; incompatible
# options.
. "$TOP/tests/support/cli.sh"

cat >hot.ini <<'END'
[contact]
load = 300 kN/m
modulus = 226 GPa
radius = 12 mm
mean_speed = 3 m/s
slide_to_roll = 0.4
[lubricant]
viscosity = 38 mPa.s
alpha = 22 1/GPa
rheology = eyring
eyring_stress = 5 MPa
[heat]
model = lobatto
temperature = 80 degC
[body 2]
material = silicon-nitride
[domain]
level = 5
[output]
file = hot.h5
fields = pressure, temperature_1, temperature_2, temperature_mean
END
expect 0 "$OVERROLL" check hot.ini
contains out '^#   thermal parameters +Theta = .*; 5 or 7 points across'
contains out '^#   Peclet numbers of the surfaces +[0-9]'
contains out 'expected discretization error .*0.01 of the .* temperature rise'
expect 0 "$OVERROLL" run hot.ini --json
for key in T_max_rise T_1_max_rise T_2_max_rise; do
    awk -v x="$(number $key)" 'BEGIN { exit !(x > 1 && x < 100) }' ||
        fail "$key is '$(number $key)'"
done
# silicon nitride conducts worse: that surface is the hotter one
awk -v a="$(number T_1_max_rise)" -v b="$(number T_2_max_rise)" \
    'BEGIN { exit !(b > a) }' || fail 'surface 2 is not the hotter'
awk -v d="$(number energy_defect)" 'BEGIN { exit !(d < 3e-3 && d > -3e-3) }' ||
    fail "energy_defect is $(number energy_defect)"
mu=$(number mu_slide)
expect 0 "$OVERROLL" info hot.h5
expect 0 "$OVERROLL" steady hot.ini --json --set heat.model=none
if grep -q '"T_max_rise"\|"heat_flow' out; then
    fail 'temperatures where there is no heat'
fi
awk -v hot="$mu" -v cold="$(number mu_slide)" \
    'BEGIN { exit !(hot < cold && hot > 0) }' || fail "mu $mu is not below"

# A run of slip that rises and a dent, whole and in two pieces
cp hot.ini run.ini
cat >>run.ini <<'END'
[time]
end = 2
[sliding]
history = ramp
to = 0.8
duration = 1
[feature dent]
shape = dent
depth = 0.05
width = 0.6
start = -2.5
END
expect 0 "$OVERROLL" run run.ini -o whole.h5 --json
awk -v x="$(number T_max_rise)" 'BEGIN { exit !(x > 1 && x < 100) }' ||
    fail "T_max_rise is $(number T_max_rise)"
awk -v d="$(number energy_defect_max)" \
    'BEGIN { exit !(d < 0.02 && d > -0.02 && d != 0) }' ||
    fail "energy_defect_max is $(number energy_defect_max)"
expect 0 "$OVERROLL" run run.ini -o short.h5 -q --set time.end=1
expect 0 "$OVERROLL" resume short.h5 --set time.end=2 -q
for file in whole short; do
    "$OVERROLL" export $file.h5 >$file.txt
    "$OVERROLL" export $file.h5 --all >>$file.txt
done
cmp whole.txt short.txt || fail 'interrupted, it is another run'
contains whole.txt 'energy_defect'
contains whole.txt 'temperature_1'

# Points across by the steady start, of which a run that goes on knows
sed '/rheology/d;/eyring/d' hot.ini >newtonian.ini
sed 's/slide_to_roll.*/slide_to_roll = 1/' newtonian.ini >seven.ini
for points in auto 5; do
    expect 0 "$OVERROLL" steady seven.ini --json --set heat.points=$points
    contains out "\"heat_points\": $([ $points = 5 ] && echo 5 || echo 7),"
    grep 'set heat.points = 7' err >told
    [ -s told ] && [ $points = auto ] && fail 'told what was done'
    [ -s told ] || [ $points = auto ] || fail '5 points were not warned of'
done
printf '[time]\nend = 0.2\n' >>seven.ini
expect 0 "$OVERROLL" run seven.ini -o seven.h5 -q
expect 0 "$OVERROLL" run seven.ini -o cut.h5 -q --set time.end=0.1
expect 0 "$OVERROLL" resume cut.h5 --set time.end=0.2 -q
for file in seven cut; do
    "$OVERROLL" export $file.h5 --all >$file.txt
done
cmp seven.txt cut.txt || fail 'interrupted, it has other points'

# A run in which features pass has 7 points from its start.
cat hot.ini - >pass.ini <<'END'
[time]
end = 0.1
[feature d]
shape = dent
depth = 0.02
width = 0.5
END
expect 0 "$OVERROLL" run pass.ini --json -q -o pass.h5
contains out '"heat_points": 7,'

# Starved: the oil is conserved
expect 0 "$OVERROLL" run run.ini -o starved.h5 --json --set time.end=0.5 \
    --set cavitation.model=conserving --set supply.model=film \
    --set supply.thickness_1=0.08 --set supply.thickness_2=0.08
awk -v d="$(number mass_defect)" -v r="$(number film_ratio)" \
    'BEGIN { exit !(d * d < 1e-6 && r < 0.9 && r > 0.1) }' ||
    fail "mass_defect $(number mass_defect), film_ratio $(number film_ratio)"

# Of fourth order where that is asked for
for file in hot newtonian; do
    expect 0 "$OVERROLL" steady $file.ini --json --set domain.order=4
    contains out '"order": 4' || fail "$file.ini: not of fourth order"
done
refuses 'also set in \[lubricant\]' check hot.ini \
    --set 'lubricant.temperature=90 degC'

# Slow surfaces are as good as fast ones; one that stands still has no steady
# temperature, at the start or later, but one that turns round has
expect 0 "$OVERROLL" check hot.ini --set 'contact.mean_speed=0.1 m/s'
grep 'Peclet number\|does not move' err && fail 'no surface is that slow'
expect 0 "$OVERROLL" check hot.ini --set 'contact.mean_speed=1 mm/s'
contains err 'temperature of surface 1 is too low, .* the model covers'
expect 0 "$OVERROLL" check hot.ini --set 'contact.slide_to_roll=2'
contains err 'surface 2 does not move and has no steady temperature'
expect 0 "$OVERROLL" check run.ini --set sliding.to=2 --set time.end=9
contains err 'surface 2 does not move at T = '
expect 0 "$OVERROLL" check run.ini --set sliding.to=2.5 --set time.end=9
grep 'Peclet number\|does not move' err && fail 'it turns round'

# Surfaces against each other
expect 0 "$OVERROLL" steady hot.ini --json --set contact.slide_to_roll=2.5
awk -v d="$(number energy_defect)" -v x="$(number T_max_rise)" \
    'BEGIN { exit !(d < 3e-3 && d > -3e-3 && x > 1 && x < 200) }' ||
    fail "defect $(number energy_defect), $(number T_max_rise) K"
expect 0 "$OVERROLL" run run.ini -o against.h5 --set sliding.from=2.5 \
    --set time.end=0.2 -q

expect 0 "$OVERROLL" steady hot.ini --set domain.inlet=-1.05
contains err 'domain is too short: surface 1 enters'

# Far beyond what laws are measured for it converges, and says so.
expect 0 "$OVERROLL" steady hot.ini --set 'contact.mean_speed=8.7 m/s' \
    --set contact.slide_to_roll=1.5 --set 'lubricant.eyring_stress=15 MPa'
contains err 'heat: the film is up to'
expect 0 "$OVERROLL" steady newtonian.ini --set 'contact.load=60 kN/m'

# Given up before there is any heat: the film is too thin for the grid
cat >thin.ini <<'END'
[contact]
load = 1e6 N/m
radius = 10 mm
modulus = 226 GPa
mean_speed = .03 m/s
[lubricant]
viscosity = .01 Pa.s
alpha = 17 1/GPa
[heat]
model = lobatto
temperature = 330 K
[domain]
level = 7
[time]
end = 0.1
END
for verb in steady run; do
    expect 1 "$OVERROLL" $verb thin.ini
    contains err 'the film is too thin for the grid'
done

# Temperatures where nothing has them: not stored where heat is off, refused
# where the case does not know of it.
cat >cold.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[time]
end = 0.1
[output]
fields = pressure, temperature_1
END
expect 2 "$OVERROLL" run cold.ini -o cold.h5
contains err '^cold.ini:9: fields: temperature_1 has no values without \[heat\]'
expect 0 "$OVERROLL" run cold.ini -o cold.h5 --set heat.model=none
contains err 'temperatures and fluxes are not stored, because .heat. is off'
expect 0 "$OVERROLL" export cold.h5 --at 0
contains out 'pressure'
! grep -q temperature out || fail "$(head -1 out)"

# Laws without S0 need beta; an isoviscous oil needs no alpha.
cat >beta.ini <<'END'
[contact]
modulus = 226 GPa
hertz_pressure = 0.05 GPa
radius = 12.7 mm
mean_speed = 3 m/s
slide_to_roll = 0.5
[lubricant]
viscosity = 20 mPa.s
viscosity_law = isoviscous
density_law = incompressible
[heat]
model = lobatto
temperature = 60 degC
[domain]
level = 6
END
sed 's/^viscosity_law.*/alpha = 1e-3 1\/GPa\nviscosity_law = barus/' beta.ini \
    >barus.ini
for name in beta barus; do
    refuses 'needs beta with this viscosity law; set beta' steady $name.ini
    refuses 'S0: has no effect with viscosity_law' steady $name.ini \
        --set lubricant.S0=1.1
    expect 0 "$OVERROLL" steady $name.ini --set 'lubricant.beta=0.03 1/K' --json
    number H_cen >H.$name
    number T_max_rise >T.$name
done
paste H.beta H.barus T.beta T.barus | awk '{
    exit !($1 > 0 && ($1 / $2 - 1) ^ 2 < 1e-6 &&
           $3 > 0.1 && ($3 / $4 - 1) ^ 2 < 1e-4) }' ||
    fail "isoviscous and Barus: $(cat H.beta H.barus T.beta T.barus)"

# A grid too coarse for the pressure spike of a rolling contact, whose heat it
# overestimates, and one that resolves it
cat >spike.ini <<'END'
[contact]
modulus = 226 GPa
hertz_pressure = 1.91206 GPa
radius = 6.47949 mm
mean_speed = 6.26876 m/s
slide_to_roll = 0
[lubricant]
viscosity = 8.45026 mPa.s
alpha = 21.9051 1/GPa
rheology = eyring
eyring_stress = 6.8229 MPa
limiting_shear = 0.050052
[domain]
level = 4
[heat]
model = lobatto
temperature = 73.2063 degC
END
marked='temperatures are not resolved.*error of [0-9]* %.*domain.level = 5'
expect 0 "$OVERROLL" steady spike.ini
contains err "$marked"
contains out '^maximum film temperature .*(not resolved)'
expect 0 "$OVERROLL" steady spike.ini --json
contains out '"T_max_resolved": false'
contains out '"energy_defect": -0.[12]'
expect 0 "$OVERROLL" steady spike.ini --json --level 5
contains out '"T_max_resolved": true'
! grep -q 'not resolved' err || fail 'a resolved film is marked'
# A film with an exact energy balance whose hottest point is a peak at the
# pressure spike, narrower than the mesh: the rise is 30 % too small
cat >narrow.ini <<'END'
[contact]
load = 150 kN/m
radius = 10 mm
modulus = 226 GPa
mean_speed = 8.19 m/s
slide_to_roll = 0.01
[lubricant]
viscosity = 30 mPa.s
alpha = 20 1/GPa
[domain]
level = 7
[heat]
model = lobatto
temperature = 60 degC
END
rise() {
    sed -n 's/.*"T_max_rise": \([0-9.]*\).*/\1/p' "$1"
}
expect 0 "$OVERROLL" steady narrow.ini
contains err 'maximum film temperature is not resolved.*few nodes wide'
contains out '^maximum film temperature .*(not resolved)'
expect 0 "$OVERROLL" steady narrow.ini --json
contains out '"T_max_resolved": false'
narrow=$(rise out)
expect 0 "$OVERROLL" steady narrow.ini --json --level 10
fine=$(rise out)
awk "BEGIN {exit !($narrow < 0.9*$fine)}" ||
    fail "a rise of $narrow K is marked, on level 10 it is $fine K"
# A run whose last film is resolved, the hottest one is not
cat >faster.ini <<'END'
[contact]
load = 120 kN/m
radius = 10 mm
modulus = 226 GPa
mean_speed = 3 m/s
slide_to_roll = 0.05
[lubricant]
viscosity = 30 mPa.s
alpha = 20 1/GPa
[heat]
model = lobatto
temperature = 60 degC
[domain]
level = 6
[time]
end = 5
[speed]
history = sine
amplitude = 0.3
period = 4
END
expect 0 "$OVERROLL" run faster.ini
contains out '^maximum film temperature rise .*not resolved'
! grep -q '^maximum film temperature  .*not resolved' out ||
    fail 'the last film is marked'
contains err 'heat: .*not resolved'
expect 0 "$OVERROLL" run faster.ini --json
contains out '"T_max_resolved": false'
# An Eyring lubricant has no such peak
expect 0 "$OVERROLL" steady narrow.ini --json --set lubricant.rheology=eyring \
    --set lubricant.eyring_stress=5MPa
contains out '"T_max_resolved": true'
narrow=$(rise out)
expect 0 "$OVERROLL" steady narrow.ini --json --level 10 \
    --set lubricant.rheology=eyring --set lubricant.eyring_stress=5MPa
fine=$(rise out)
awk "BEGIN {exit !($narrow > 0.99*$fine && $narrow < 1.01*$fine)}" ||
    fail "a rise of $narrow K is not marked, on level 10 it is $fine K"
# Its temperature profile is far from what 5 points resolve
expect 0 "$OVERROLL" steady spike.ini --level 6 --set heat.points=5 \
    --set 'contact.mean_speed=25 m/s'
contains err 'may be wrong by more than 10 %, because heat.points is 5'

# A start that is found without heat only: what may help, and no invented film
cat >rough.ini <<'END'
[contact]
hertz_pressure = 1.23543 GPa
radius = 6.84 mm
modulus = 226 GPa
mean_speed = 54.6988366 m/s
slide_to_roll = 0.876422
[lubricant]
viscosity = 11 mPa.s
alpha = 16 1/GPa
rheology = eyring
eyring_stress = 7.97008 MPa
[heat]
model = lobatto
temperature = 60 degC
[domain]
outlet = 2.5
level = 4
[feature f1]
surface = 1
shape = roughness
Rq = 0.386931274 um
length = 12
hurst = 0.8
rolloff = 300 um
shortest = 8.14839303 um
seed = 66078
start = 2.6
END
expect 1 "$OVERROLL" steady rough.ini
contains out '^maximum film temperature +unknown'
contains err 'converged without heat.*; lower features, less sliding'
