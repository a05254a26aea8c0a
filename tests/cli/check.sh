#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# check: its output is itself a case with the same meaning.
. "$TOP/tests/support/cli.sh"

cat >a.ini <<'END'
[contact]
M = 30          # a comment
L = 7
radius = 10 mm
modulus = 226 GPa
[time]
end = 2
[feature scratch]
shape = dent
depth = 0.1 um
width = 0.5
start = -5
END
expect 0 "$OVERROLL" check a.ini
! grep -q "^depth" out || fail 'parameters without -v'
[ "$(wc -l <out)" -le 24 ] || fail "a summary of $(wc -l <out) lines"
expect 0 "$OVERROLL" check a.ini -v
contains out '^#   dimensionless speed parameter +0\.0041'
contains out '^#   central film thickness, Moes +H = 0\.'
contains out "^#   minimum film thickness, overroll fit +H = 0\\."
contains out "density 1\\.[0-9]+ at p_h"
contains out '^depth = 0.1 um$'
contains out '^scheme = auto +# default$'
cp out b.ini
mv out first
expect 0 "$OVERROLL" check b.ini -v
sed 's/ *# default//' first >first.plain
sed 's/ *# default//' out >second.plain
cmp first.plain second.plain || fail "$(diff first.plain second.plain)"

expect 0 "$OVERROLL" check a.ini --json
contains out '"H_cen_moes": 0\.'
contains out '"memory_bytes": '
contains out '"transient": true'

# When a feature comes, passes and leaves (u = 1: X = -4 from -5.5 on, 1.5 to
# -0.5), its diameter, and the place for its snapshots; no keys of profiles or
# of other histories.
contains first '^#     enters the contact at +T = 0\.5'
contains first '^#     centre at X = 0 at +T = 5 \(after the end\)'
contains first 'diameter at half depth +0\.1239 \('
contains first '^#   snapshots +[0-9]+, up to [0-9.]+ MB on disk$'
grep -qE '^(scale|seed|hurst|copies|grow_from|amplitude|error|relax_.*) =' \
    first && fail 'keys that do not apply'

# end = auto: once the last has left (11 from X = -9.5 to 1.5 at speed 1), and
# not much later than the film forgets; endless ones refuse it.
cat >e.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 5
[time]
end = auto
[feature it]
shape = dent
depth = 0.05
diameter = 0.2
repeat = 4
copies = 2
END
expect 0 "$OVERROLL" check e.ini --set 'feature it.start=-5' -v
contains out 'leaves the contact at +T = 11\.3'
contains out '^#   time steps +at most '
expect 0 "$OVERROLL" run e.ini -o e.h5 --json
contains out '"settled": true'
contains out '"T_end": 1[2-9]\.'
expect 0 "$OVERROLL" resume e.h5
contains err 'already complete'
expect 2 "$OVERROLL" check e.ini --set 'feature it.copies=endless'
contains err "e.ini:7: end: auto: feature 'it' is endless"
expect 2 "$OVERROLL" check e.ini --set load.history=sine --set load.period=1 \
    --set load.amplitude=0.1
contains err 'e.ini:7: end: auto: the history of \[load\] never ends'
expect 2 "$OVERROLL" check --M 20 --L 10 --set time.end=auto
contains err 'nothing passes'

# The friction of a Newtonian film is dominated by a spike that no grid
# resolves, so that the expected error leaves it out.
expect 0 "$OVERROLL" check --M 20 --L 10
contains out 'discretization error .*; not the friction of a Newtonian'
expect 0 "$OVERROLL" check --M 20 --L 10 --set lubricant.rheology=eyring \
    --set lubricant.eyring_number=0.3
contains out 'discretization error .*central and minimum film thickness, fric'

# A dent deeper than the film thickness leaves no prediction of its minimum, in
# check and in the report of the run.
expect 0 "$OVERROLL" init roller
mv out deep.ini
for depth in 0.4 5; do
    expect 0 "$OVERROLL" check deep.ini --set "feature.dent.depth=$depth um"
    mv out deep
    expect 0 "$OVERROLL" run deep.ini --set "feature.dent.depth=$depth um" \
        --level 5 --force
    case $depth in
    5)
        contains deep '^#   minimum film thickness  +no prediction: '
        ! grep '^predicted minimum film' out || fail 'a minimum of zero'
        expect 0 "$OVERROLL" check deep.ini --json \
            --set "feature.dent.depth=$depth um"
        contains out '"H_min_predicted": null'
        contains out '"H_min_predicted_m": null'
        contains out '"prediction_missing": "the remaining roughness is'
        ;;
    *)
        contains deep '^#   minimum film thickness  +H = 0\.1'
        contains out '^predicted minimum film thickness +0\.1'
        ;;
    esac
done

# The expected error of a steady contact is without the features that it leaves
# out.
printf '[contact]\nM = 20\nL = 10\n[feature w]\nshape = wave\n' >left.ini
printf 'amplitude = 0.02\nwavelength = 0.3\n' >>left.ini
expected() {
    expect 0 "$OVERROLL" check left.ini --json "$@"
    sed -n 's/^ *"expected_error": \(.*\),$/\1/p' out
}
moving=$(expected)
still=$(expected --set feature.w.amplitude=1e-9)
if [ -z "$moving" ] || [ "$moving" != "$still" ]; then
    fail "error $moving, $still"
fi
[ "$(expected --set time.end=1)" != "$moving" ] || fail 'no error of a wave'

# A level that is chosen, and what it is to reach
expect 0 "$OVERROLL" check a.ini --level auto
contains out '^#   grid +level 7, '
contains out '^# +expected discretization error +[0-9.e-]* at most .central'
contains out '^# +shortest wavelength .*, [0-9.]* nodes$'
expect 0 "$OVERROLL" check --M 20 --L 10 --level auto --json \
    --set domain.accuracy=1e-5 --set domain.accuracy_of=H_cen
contains out '"level": 8'
expect 0 "$OVERROLL" check --M 900 --L 2 --level auto --set domain.accuracy=1e-8
contains err 'level = auto uses at most level 14, whose expected error is '
# The usual one: 8 of a steady contact, in time the first that does
expect 0 "$OVERROLL" check --M 20 --L 10
contains out '^#   grid +level 8, '
expect 0 "$OVERROLL" check --M 20 --L 10 --set time.end=4
contains out '^#   grid +level 6, '
contains out '^#   level +6, the first with a likely error below 0.001$'
expect 0 "$OVERROLL" check --M 1000 --L 14 --set time.end=4
contains out '^#   grid +level 8, '
contains err 'level = usual uses at most level 8, whose expected error is '

expect 0 "$OVERROLL" help
contains out '^  check '
expect 0 "$OVERROLL" check --help
contains out '^usage: overroll check'

# Text in JSON is escaped; bytes that are not UTF-8 are replaced.
printf '[contact]\nM = 20\nL = 10\n' >t.ini
printf '[output]\ntitle = a "\303\244 \\ \377"\n' >>t.ini
expect 0 "$OVERROLL" check t.ini --json
contains out '"text": "a \\"ä \\\\ \\ufffd\\""'
if command -v python3 >/dev/null; then
    python3 -c 'import json; json.load(open("out"))' || fail 'not JSON'
fi

# Of rough surfaces that roll: what is foreseen, and the run's own beside it
cat >rough.ini <<'EOF'
[contact]
M = 50
L = 8
radius = 10 mm
modulus = 226 GPa
[domain]
level = 5
[time]
end = 3
[feature ground]
shape = wave
amplitude = 0.005
wavelength = 1
grow = 1
EOF
expect 0 "$OVERROLL" check rough.ini
contains out "^#   film thickness roughness Rq +0\\.00.*; surfaces: 0\\.003"
contains out '^#   film .* Rq .*m., largest in .X. < 0\.75$'
# 0.005/sqrt(2) of a wave, its mean over windows of 2 b removed
contains out '^#   composite Rq of the surfaces +0\.00353.* [un]m.*whole length'
contains out '^#   minimum film thickness +H = 0\.0[0-9]+ \(.* um\)'
contains out '^# Predicted film of the rough surfaces .amplitude reduction'
expect 0 "$OVERROLL" check rough.ini --json
foreseen=$(sed -n 's/.*"film_Rq_predicted": \(.*\),/\1/p' out)
[ "$foreseen" != null ] || fail 'nothing is predicted'
contains out '"prediction_missing": null'
contains out '"not_foreseen": null'
contains out "\"film_Rq_foreseen\": $foreseen"
expect 0 "$OVERROLL" run rough.ini
contains out '^maximum film thickness roughness Rq +0\.00[0-9]+ '
contains out "^predicted film thickness roughness Rq +0\\.00.*: 0\\.003.* b.2/R"
expect 0 "$OVERROLL" run rough.ini --json
contains out "\"film_Rq_foreseen\": $foreseen"
own=$(sed -n 's/.*"film_Rq_max": \(.*\),/\1/p' out)
echo "$own $foreseen" | awk '{ exit !($1 > 0.8*$2 && $1 < 1.2*$2) }' ||
    fail "film_Rq_max $own is far from what was foreseen, $foreseen"
expect 0 "$OVERROLL" check rough.ini --set contact.M=1.5
contains out 'film thickness roughness Rq +no prediction: .* is valid for'
expect 0 "$OVERROLL" check rough.ini --set contact.slide_to_roll=0.2
contains out 'less certain: the surfaces slide: Rq was predicted 0.6 to'
expect 0 "$OVERROLL" check rough.ini --set contact.slide_to_roll=-0.2
contains out 'less certain: the surfaces slide'

# A moving wave that the run begins with is grown into the steady start.  Its
# cost is predicted within ten times, also in a shear-thinning film that is a
# third as thick as the wave is high.  Cycles stand for time.
cat >begun.ini <<'END'
[contact]
hertz_pressure = 1 GPa
radius = 10 mm
modulus = 226 GPa
mean_speed = 0.5 m/s
[lubricant]
viscosity = 40 mPa.s
alpha = 17 1/GPa
rheology = eyring
eyring_stress = 6 MPa
[domain]
level = 8
[time]
end = 0.1
[feature d]
shape = wave
amplitude = 0.2
wavelength = 0.5
END
# predicted CASE ARGUMENTS...: seconds
predicted() {
    expect 0 "$OVERROLL" check "$@"
    awk '/estimated cost/ { print $4 * ($5 ~ /^min/ ? 60 : 1) }' out
}
# as_cycles FACTOR CASE SETTING [OTHER]: seconds predicted with the setting, and
# with or without the other, are as the cycles of the runs within a factor.
count=cycles_total
as_cycles() {
    factor=$1 case=$2
    dear=$(predicted "$case" --set "$3")
    cheap=$(predicted "$case" ${4:+--set "$4"})
    expect 0 "$OVERROLL" run "$case" --json -q --force --set "$3"
    many=$(number "$count")
    expect 0 "$OVERROLL" run "$case" --json -q --force ${4:+--set "$4"}
    few=$(number "$count")
    echo "$dear $cheap $many $few $factor" |
        awk '{ r = $1 / $2 / ($3 / $4); exit !(r > 1 / $5 && r < $5) }' ||
        fail "$3: predicted $dear and $cheap s, took $many and $few cycles"
}
as_cycles 10 begun.ini feature.d.amplitude=0.2 feature.d.amplitude=0.01

# So is that of a steady solution, which holds the moving wave, and of steps to
# a given tolerance, in a line contact and in a strip.
sed '/^\[time\]/,/^end/d' begun.ini >held.ini
count=cycles
as_cycles 10 held.ini feature.d.amplitude=0.2 feature.d.amplitude=0.01
count=cycles_total
cat >steps.ini <<'END'
[contact]
M = 20
L = 10
slide_to_roll = 0.5
[domain]
level = 5
[time]
end = 1
[feature d]
shape = dent
depth = 0.05
width = 0.6
start = inlet
END
as_cycles 2 steps.ini solver.tolerance=1e-10
echo '[strip]' >>steps.ini
as_cycles 2 steps.ini solver.tolerance=1e-10

# The balance of the paper hardly converges in thick films.
count=cycles
cat >balance.ini <<'END'
[contact]
M = 0.3
L = 2
[domain]
level = 4
[paper]
paper_balance = yes
END
as_cycles 3 balance.ini contact.M=0.1

# High waves in the thick film of a strip grow out of smooth surfaces.
cat >thick.ini <<'END'
[contact]
M = 0.5
L = 11
[domain]
level = 4
[strip]
[feature w]
shape = wave
amplitude = 9
wavelength = 0.8
END
as_cycles 10 thick.ini feature.w.amplitude=9 feature.w.amplitude=1

# The time includes the preparation of rough surfaces, which check does too: by
# filters across in a strip, by alternations between ranks and spectrum.
cat >prepared.ini <<'END'
[contact]
M = 20
L = 5
[domain]
level = 4
[feature r]
shape = roughness
Rq = 0.001
length = 12
start = 2
END
# spent ARGUMENTS...: CPU time of check
spent() {
    "$OVERROLL" check prepared.ini "$@" >out 2>err
    times >cpu
    awk 'NR == 2 { split($1, a, /[ms]/); print 60 * a[1] + a[2] }' cpu
}
for more in 'strip.width=4 --set feature.r.shortest=0.05' \
    'feature.r.skewness=-1 --set feature.r.shortest=0.004'; do
    # shellcheck disable=SC2086
    {
        dear=$(predicted prepared.ini --set $more)
        cheap=$(predicted prepared.ini --set ${more%=*}=0.4)
        echo "$dear $cheap $(spent --set $more) $(spent --set ${more%=*}=0.4)"
    } >>costs
done
awk '{ r[NR] = ($1 - $2) / ($3 - $4) }
    END { exit !(r[1] > r[2] / 3 && r[1] < 3 * r[2]) }' costs ||
    fail "predicted and CPU times, dear and cheap surfaces: $(cat costs)"

# The bounds stated for waves on a sliding surface.
sed 's/= 1 GPa/= 1.6 GPa/; /^\[domain/,$d' begun.ini >waves.ini
cat >>waves.ini <<'END'
limiting_shear = 0.08
[domain]
level = 7
[time]
end = 6
[feature w]
surface = 1
shape = wave
amplitude = 20 nm
wavelength = 420 um
END
# bounded LOW HIGH ARGUMENTS...: predicted film roughness by that of the run
bounded() {
    low=$1 high=$2
    shift 2
    expect 0 "$OVERROLL" run waves.ini --json -q "$@"
    echo "$(number film_Rq_predicted) $(number film_Rq_max) $low $high" |
        awk '{ exit !($1 > $3*$2 && $1 < $4*$2) }' ||
        fail "$*: $(grep 'film_Rq_[pm]' out)"
}
bounded 0.88 1.12
bounded 0.25 1.4 --set contact.slide_to_roll=1
bounded 0.25 1.4 --set contact.slide_to_roll=-1
sed -i 's/420 um/60 um/' waves.ini
bounded 0.25 1.4 --set contact.slide_to_roll=1
bounded 0.25 1.4 --set contact.slide_to_roll=-1
sed -i 's/= eyring/= newtonian/; /eyring_stress/d' waves.ini
bounded 0.6 1.4 --set contact.slide_to_roll=1
bounded 0.6 1.4 --set contact.slide_to_roll=-1

# At rest the pressure flattens it, in a steady run too, which reports its Rq.
sed -i '/^\[time\]/,/^end/d' waves.ini
expect 0 "$OVERROLL" run waves.ini --set contact.slide_to_roll=-2
contains out '^film thickness roughness Rq +[0-9]'
expect 0 "$OVERROLL" run waves.ini -q --json --set contact.slide_to_roll=-2
echo "$(number film_Rq_predicted) $(number film_Rq) $(number surface_Rq)" |
    awk '{ exit !($1 < 0.05*$3 && $2 < 0.05*$3 && $2 > 0) }' ||
    fail "at rest: $(grep '_Rq' out)"
expect 0 "$OVERROLL" check waves.ini --set contact.slide_to_roll=-2.1
contains out 'no prediction: .* against the entrainment speed'
# A steady solution that leaves the wave out is not compared with it.
expect 0 "$OVERROLL" steady rough.ini
! grep -q 'film thickness roughness Rq' out || fail 'of waves left out'

# The predicted memory of a long measured profile, most of which is needed to
# read and filter the profile, compared with the resident set of the process.
if [ -z "$INSTRUMENTED" ] && command -v python3 >/dev/null; then
    awk 'BEGIN { print "x [um],z [um]"; for (i = 0; i < 160000; i++)
        printf "%g,%.4f\n", i/4, sin(i/20)/20 + sin(i/3)/50 }' >long.csv
    cat >long.ini <<'E2'
[contact]
M = 20
L = 10
radius = 12 mm
modulus = 226 GPa
[time]
end = 1
[feature p]
shape = profile
file = long.csv
lambda_c = 250 um
E2
    printf '[contact]\nM = 20\nL = 10\n' >short.ini
    expect 0 python3 - <<'E2'
import json, os, resource, subprocess
program = os.environ["OVERROLL"]
def check(case):
    done = subprocess.run([program, "check", case, "--json"],
                          stdout=subprocess.PIPE, check=True)
    most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024
    return json.loads(done.stdout)["memory_bytes"], most
_, program_itself = check("short.ini")
predicted, most = check("long.ini")
assert predicted > 2e7, predicted
assert 0.5 < (most - program_itself) / predicted < 2, (predicted, most)
E2
fi
