#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Result files of 0.3.0, which lack the datasets and attributes that 0.4.0
# added, are read by all commands.
. "$TOP/tests/support/cli.sh"
need_python h5py

sized_dent_case 4 1 0.1 0.5 -2 >dent.ini
cat >>dent.ini <<'END'
[output]
every = 2
fields = pressure, film_thickness, roughness
END
expect 0 "$OVERROLL" run dent.ini -q -o new.h5
cp new.h5 old.h5
expect 0 "$PYTHON" - <<'END'
import h5py
SUMMARY = """P_max_resolved P_spike_resolved T_H_min_cavity surface_Rq
    X_cavitation_max T_X_cavitation_max film_Rq_predicted H_min_predicted
    film_Rq_foreseen H_min_foreseen steps_uncorrected min_film_located
    F_slope_1 F_slope_2""".split()
FILE = """H_min_cavity_overall X_H_min_cavity_overall T_H_min_cavity
    X_cavitation_max T_X_cavitation_max T_H_cen_low""".split()
CASE = """strip. lubricant.density_15 feature dent.across feature dent.angle
    feature dent.stagger feature dent.turn feature dent.extend_across
    feature dent.peklenik""".replace("feature dent", "feature_dent").split()


def remove(attrs, is_new, least):
    gone = [key for key in attrs if is_new(key)]
    assert len(gone) >= least, gone
    for key in gone:
        del attrs[key]


def of(names):
    return lambda key: any(
        key == name + unit for name in names
        for unit in ("", "_m", "_s", "_N_per_m"))


with h5py.File("old.h5", "r+") as f:
    for name in "max_pressure_resolved", "slope_force_1", "slope_force_2":
        del f["history"][name]
    for member in f["history"].values():
        member.attrs.pop("comment", None)
    remove(f["summary"].attrs, of(SUMMARY), 10)
    remove(f.attrs, of(FILE), 5)
    remove(f["case"].attrs,
           lambda key: key.replace(" ", "_").startswith(tuple(CASE)), 5)
    f.attrs["source"] = "overroll 0.3.0"
END

expect 0 "$OVERROLL" info new.h5
grep '^minimum film thickness' out >film || fail "no film: $(cat out)"
expect 0 "$OVERROLL" info old.h5
contains out '^written .* by overroll 0\.3\.0$'
contains out '^history .*T = 0 to 1'
grep '^minimum film thickness' out | cmp - film || fail 'another film'

expect 0 "$OVERROLL" export new.h5 --all
mv out new.csv
expect 0 "$OVERROLL" export old.h5 --all
cmp out new.csv || fail 'other fields'
for kind in snapshot history map trace; do
    expect 0 "$OVERROLL" plot old.h5 --kind $kind -o $kind.png
done
expect 0 "$OVERROLL" view old.h5 -o old.html
expect 0 "$OVERROLL" frames old.h5 -o frames --size 320x240 --time 0:0.2
expect 0 "$OVERROLL" info old.h5 --inputs again
contains err 'old.h5 was computed by overroll 0.3.0 and this is overroll 0\.'
cmp again/old.ini dent.ini || fail 'another case'
