#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# [random] in a study: samples compared with an independent program; 500
# samples of a lognormal contact compared with the exact distribution; failed
# samples in every probability; rows of a file remain together; common samples;
# rejected input.
. "$TOP/tests/support/cli.sh"
need_python math statistics csv json

cat >contact.ini <<'END'
[contact]
load = 300 kN/m
radius = 8 mm
modulus = 226 GPa
mean_speed = 1 m/s
[lubricant]
alpha = 20 1/GPa
viscosity = 40 mPa.s
[domain]
level = 3
END
cat >lognormal.ini <<'END'
[study]
case = contact.ini
results = no
[random]
draws = 500
shifts = 4
contact.load = lognormal 300 kN/m sd 20 %
contact.radius = lognormal 8 mm sd 0.4 mm
contact.modulus = lognormal 226 GPa sd 2 %
[limits]
hertz_pressure_Pa <= 1.1 GPa
END
expect 0 "$OVERROLL" sweep lognormal.ini -j 2
contains out '^500 samples: 500 finished, 0 failed, 0 with .*, order 4, level 3'
contains lognormal/summary.csv '^group,quantity,draws,.*q05_low,.*share_load'
expect 0 "$OVERROLL" sweep lognormal.ini --collect table.csv -q
expect 0 "$OVERROLL" sweep lognormal.ini --statistics --json \
    --quantity hertz_pressure_Pa,half_width_m
# p_h = sqrt(w E'/(2 pi R)) and b = 4 R p_h/E' are lognormal too: mean, sd,
# quantiles, probability and shares of the variance in closed form
cat >check.py <<'END'
import csv
import json
import math
from statistics import NormalDist

spread = {"load": .2, "radius": .05, "modulus": .02}
mean = {"load": 3e5, "radius": 8e-3, "modulus": 226e9}
s = {k: math.sqrt(math.log1p(v * v)) for k, v in spread.items()}
m = {k: math.log(mean[k]) - s[k]**2/2 for k in s}
told = {r["quantity"]: r for r in json.load(open("out"))["statistics"]}
rows = list(csv.DictReader(open("table.csv")))
for name, c, powers in [
        ("hertz_pressure_Pa", 1/math.sqrt(2*math.pi),
         {"load": .5, "radius": -.5, "modulus": .5}),
        ("half_width_m", 4/math.sqrt(2*math.pi),
         {"load": .5, "radius": .5, "modulus": -.5})]:
    mu = math.log(c) + sum(powers[k]*m[k] for k in s)
    sigma = math.sqrt(sum((powers[k]*s[k])**2 for k in s))
    law, row = NormalDist(mu, sigma), told[name]
    true = math.exp(mu + sigma**2/2)
    sd = true*math.sqrt(math.expm1(sigma**2))
    # plain draws would have 4 standard errors here; shifted points less
    assert abs(row["mean"] - true) < 4*sd/math.sqrt(500), (row["mean"], true)
    assert abs(row["sd"]/sd - 1) < 4/math.sqrt(2*500), (row["sd"], sd)
    for q in row["quantiles"]:
        exact = math.exp(law.inv_cdf(q["p"]))
        assert q["low"] is None or q["low"] <= exact, (q, exact)
        assert q["high"] is None or exact <= q["high"], (q, exact)
    values = sorted(math.log(float(r[name])) for r in rows)
    worst = max(max(abs(law.cdf(v) - i/500), abs(law.cdf(v) - (i + 1)/500))
                for i, v in enumerate(values))
    assert worst*math.sqrt(500) < 1.36, worst  # Kolmogorov, 5 %
    for r in rows:  # each by the formula, from its inputs in the table
        w, R, E = (float(r[k]) for k in
               ("load [N/m]", "radius [m]", "modulus [Pa]"))
        ph = math.sqrt(w*E/(2*math.pi*R))
        exact = ph if name[0] == "h" and name[1] == "e" else 4*R*ph/E
        assert abs(float(r[name])/exact - 1) < 1e-9
    total = math.expm1(sigma**2)
    for i in row["inputs"]:
        exact = math.expm1((powers[i["key"]]*s[i["key"]])**2)/total
        # 22 bins cost a dominant input a few points
        assert i["share_low"] - .03 <= exact <= i["share_high"] + .03, i
        assert (i["rho"] > 0) == (powers[i["key"]] > 0), i
limit, = told["hertz_pressure_Pa"]["limits"]
mu = sum(p*m[k] for k, p in (("load", .5), ("radius", -.5), ("modulus", .5)))
sigma = math.sqrt(sum((.5*s[k])**2 for k in s))
P = NormalDist(mu - math.log(2*math.pi)/2, sigma).cdf(math.log(1.1e9))
assert limit["P_low"] <= P <= limit["P_high"], (limit, P)
assert abs(P - (1 - .6696115881194814)) < 1e-9
END
"$PYTHON" check.py || fail 'not the exact distribution'
refuses "did you mean 'hertz_pressure_Pa'" sweep lognormal.ini --statistics \
    --quantity hertz_presure_Pa
# The same in a figure, by the numbers that gnuplot is given
if command -v gnuplot >/dev/null; then
    expect 0 "$OVERROLL" plot lognormal.ini --kind distribution -o d.svg \
        --quantity hertz_pressure_Pa --script d.gp -q
    contains d.svg 'load, rho \+0.9'
    contains d.svg 'share of the variance'
    contains d.dat '^1\.1(0*1)? 0'
    refuses 'draws a study; use' plot table.csv --kind distribution -o e.svg
    refuses 'd.svg' plot lognormal.ini --kind distribution -o d.svg
fi

# Draws by their index: splitmix64 and FNV-1a written down again
cat >plain.ini <<'END'
[study]
case = contact.ini
results = no
[random]
draws = 40
seed = 7
design = plain
contact.load = normal 300 kN/m sd 10 % within 250 to 350
lubricant.viscosity = triangular 10 mPa.s, 40 mPa.s, 50 mPa.s
[product]
contact.mean_speed = 1 m/s, 2 m/s
END
expect 3 "$OVERROLL" sweep plain.ini --collect plain.csv -q
cat >draws.py <<'END'
import csv
import math
from statistics import NormalDist

BITS = 2**64 - 1


def fnv(text):
    h = 14695981039346656037
    for c in text.encode():
        h = (h ^ c)*1099511628211 & BITS
    return h


def mixed(x):
    x = (x ^ x >> 30)*0xbf58476d1ce4e5b9 & BITS
    x = (x ^ x >> 27)*0x94d049bb133111eb & BITS
    return x ^ x >> 31


def u(seed, key, i):
    golden = 0x9e3779b97f4a7c15
    state = mixed(mixed(seed + golden & BITS) ^ fnv(key))
    return ((mixed(state + (i + 1)*golden & BITS) >> 11) + .5)*2**-53


rows = list(csv.DictReader(open("plain.csv")))
assert len(rows) == 80
law = NormalDist(300e3, 30e3)
a, b = law.cdf(250e3), law.cdf(350e3)
for n, row in enumerate(rows):
    i = n % 40
    assert row["name"].endswith(f"draw-{i + 1:04d}"), row["name"]
    load = law.inv_cdf(a + u(7, "contact.load", i)*(b - a))
    assert abs(float(row["load [N/m]"])/load - 1) < 1e-12, (row, load)
    v = u(7, "lubricant.viscosity", i)
    oil = 10 + math.sqrt(v*40*30) if v < .75 else \
        50 - math.sqrt((1 - v)*40*10)
    told = float(row["viscosity [Pa.s]"])
    assert abs(told/(oil*1e-3) - 1) < 1e-12, (row, oil)
END
"$PYTHON" draws.py || fail 'other draws'
# a sample that grows keeps what it had; another seed is another sample
sed 's/draws = 40/draws = 80/' plain.ini >more.ini
expect 3 "$OVERROLL" sweep more.ini --collect more.csv -q
sed -n '2,41s/[^,]*,//p' plain.csv >first
sed -n '2,41s/[^,]*,//p' more.csv | cmp - first || fail 'growth changes draws'
sed 's/seed = 7/seed = 8/' plain.ini >other.ini
expect 3 "$OVERROLL" sweep other.ini --collect other.csv -q
sed -n '2,41s/[^,]*,//p' other.csv | cmp -s - first && fail 'the same draws'
# a draw of a large study is made without the others, which took 310 MB: draw 7
# of 500000 is draw 7 of 40
sed '/results/d' plain.ini >few.ini
sed 's/draws = 40/draws = 500000/' few.ini >many.ini
expect 0 "$OVERROLL" sweep few.ini --task 7 -q
[ "$INSTRUMENTED" ] || memory=200000 # sanitizers reserve memory of their own
# shellcheck disable=SC3045 # dash and bash have it
(ulimit -v "${memory:-unlimited}" && "$OVERROLL" sweep many.ini --task 7 -q) \
    2>err || fail "$(cat err)"
cmp few/*draw-0007.ini many/*draw-0007.ini || fail 'draw 7 depends on others'
# the same draws in each case of [product]
expect 0 "$OVERROLL" sweep plain.ini -q
expect 0 "$OVERROLL" sweep plain.ini --statistics --quantity hertz_pressure_Pa
contains out '^40 samples with mean_speed = 1 m/s: 40 finished'
contains out '^maximum Hertzian pressure p_h, GPa .hertz_pressure_Pa.$'
[ "$(grep -c '^mean ' out)" -eq 2 ] || fail "$(cat out)"
[ "$(grep '^mean ' out | sort -u | wc -l)" -eq 1 ] ||
    fail "other draws: $(cat out)"
grep -q share out && fail 'of 40 draws indices are told'

# Failed draws are neither: P between k of all and k + failed of all
cat >failing.ini <<'END'
[study]
results = no
[set]
contact.M = 20
contact.L = 10
domain.level = 6
[random]
draws = 64
solver.tolerance = lognormal 1e-10 sd 500 %
[limits]
H_min >= 0
END
code=0
"$OVERROLL" sweep failing.ini -j 2 >out 2>err || code=$?
failed=$(sed -n 's/^64 samples: .* finished, \([0-9]*\) failed.*/\1/p' out)
if [ "$code" -eq 1 ] && [ "${failed:-0}" -gt 0 ]; then
    contains out '% of the samples failed'
    expect 0 "$OVERROLL" sweep failing.ini --statistics --json
    "$PYTHON" - "$failed" <<'END' || fail "$(cat out)"
import json
import sys
row = json.load(open("out"))["statistics"][0]
limit, failed = row["limits"][0], int(sys.argv[1])
assert row["failed"] == failed and row["known"] == 64 - failed
assert limit["P"] == 1 and limit["P_high"] == 1
assert limit["P_low"] < 1 - failed/64
END
else
    fail "no draw failed: $(cat out err)"
fi

# Rows of a file stay together; a list; whole numbers; 17 digits
printf '# GPa\n210 GPa\n220 GPa   # steel\n230 GPa\n' >moduli.txt
printf 'name,load [kN/m],r\na,100,5 mm\nb,200,6 mm\nc,300,7 mm\n' >measured.csv
cat >files.ini <<'END'
[study]
case = contact.ini
[random]
draws = 40
design = lhs
contact.modulus = file moduli.txt
feature.ground.seed = 1..1000000000
[random file measured.csv]
contact.load = column load
contact.radius = column r
END
cat >>contact.ini <<'END'
[feature ground]
shape = roughness
Rq = 0.1 um
length = 0.2 mm
shortest = 0.05 mm
seed = 1
start = -1
END
expect 3 "$OVERROLL" sweep files.ini --collect files.csv -q
"$PYTHON" - <<'END' || fail "$(cat files.csv)"
import csv
from collections import Counter
rows = list(csv.DictReader(open("files.csv")))
pairs = Counter((float(r["load [N/m]"]), float(r["radius [m]"])) for r in rows)
assert set(pairs) == {(1e5, 5e-3), (2e5, 6e-3), (3e5, 7e-3)}, pairs
assert all(13 <= n <= 14 for n in pairs.values()), pairs  # strata
assert set(float(r["modulus [Pa]"]) for r in rows) == {210e9, 220e9, 230e9}
seeds = [int(r["seed"]) for r in rows]
assert len(set(seeds)) == 40 and min(seeds) >= 1 and max(seeds) <= 10**9
END

# What is wrong is said before anything runs
wrong() { # PATTERN LINES
    printf '[study]\ncase = contact.ini\n[random]\n%b' "$2" >wrong.ini
    refuses "$1" sweep wrong.ini
    [ ! -e wrong ] || fail 'a folder was made for a wrong study'
}
load='contact.load = normal 300 kN/m sd 10 %\n'
wrong 'draws is missing' "$load"
wrong 'no key of the case is random' 'draws = 16\n'
wrong 'wrong.ini:4: draws: .7. must be' "draws = 7\n$load"
wrong 'draws = 20 must be a multiple of shifts = 8: use 16 or 24' \
    "draws = 20\nshifts = 8\n$load"
wrong 'draws = 97 must be .*: use 96 or 104' "draws = 97\n$load"
# Without shifts any number that is no large prime will do: 100 is 5 times 20
for shifts in '' 'shifts = 5'; do
    printf '[study]\ncase = contact.ini\nresults = no\n[random]\n%b%b\n' \
        "draws = 100\n$load" "$shifts" >round.ini
    expect 0 "$OVERROLL" sweep round.ini -q
    expect 0 "$OVERROLL" sweep round.ini --collect all.csv --force
    cut -d, -f1-8 all.csv >"round$shifts.csv"
    rm -r round
done
cmp round.csv 'roundshifts = 5.csv' || fail 'the default of 100 is not 5'

wrong 'must be plain, lhs or sobol' "draws = 16\ndesign = sobl\n$load"
wrong "did you mean 'draws'" "draw = 16\n$load"
wrong 'wrong.ini:5: .* must be normal A sd B' \
    'draws = 16\ncontact.load = normal 300 kN/m\n'
wrong 'standard deviation must be above 0' \
    'draws = 16\ncontact.load = normal 300 kN/m sd 0 N/m\n'
wrong 'ascending' 'draws = 16\ncontact.load = triangular 3 N/m, 1 N/m, 2 N/m\n'
wrong 'sample [0-9]* of contact.load is -.*use lognormal or within' \
    'draws = 16\ncontact.load = normal 1 kN/m sd 5 kN/m\n'
wrong 'given twice' "draws = 16\n$load$load"
wrong 'given twice' "draws = 16\n${load}[product]\ncontact.load = 1 N/m\n"
wrong "unknown key 'lod'|did you mean" \
    'draws = 16\ncontact.lod = normal 1 N/m sd 1 %\n'
wrong "wrong.ini:5: '.* sd 10': sd needs a unit, such as kN/m, or %" \
    'draws = 16\ncontact.load = normal 300 kN/m sd 10\n'
wrong 'sd 10 within 280 to 320.: sd needs a unit, such as kN/m, or %' \
    'draws = 16\ncontact.load = normal 300 kN/m sd 10 within 280 to 320\n'
wrong 'shape' 'draws = 16\nfeature.a.shape = normal 1 sd 2\n'
wrong "has no column 'w'" \
    'draws = 16\n[random file measured.csv]\ncontact.load = column w\n'
wrong 'must be .random. or' 'draws = 16\n[random numbers]\n'
wrong 'must be QUANTITY >= VALUE or' "draws = 16\n${load}[limits]\nH_min = 3\n"

# One key that all depends on: a share of 1, inside its interval.
cat >alone.ini <<'END'
[contact]
load = 300 kN/m
radius = 8 mm
modulus = 226 GPa
mean_speed = 1 m/s
viscosity = 40 mPa.s
alpha = 20 1/GPa
[domain]
level = 4
END
cat >one.ini <<'END'
[study]
case = alone.ini
results = no
output = one
[random]
draws = 64
contact.mean_speed = uniform 1 m/s to 3 m/s
END
expect 0 "$OVERROLL" sweep one.ini -q
expect 0 "$OVERROLL" sweep one.ini --statistics
[ "$(grep -c '^mean_speed  *1.0 (1.0 to 1.0) ' out)" -eq 2 ] ||
    fail "$(cat out)"
expect 0 "$OVERROLL" sweep one.ini --statistics --json
grep '"share_high": [^1]' out && fail 'an interval without 1'
true
