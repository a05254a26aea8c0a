#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The page of `overroll view` in a headless Chromium: it loads, draws, plays,
# seeks and shows at hover what h5py reads from the file.
. "$TOP/tests/support/cli.sh"

cat >dent.ini <<'END'
[contact]
load = 3.07e5 N/m
radius = 10 mm
modulus = 226 GPa
viscosity = 40 mPa.s
speed_1 = 1.4 m/s
speed_2 = 1.2 m/s
[lubricant]
alpha = 17 1/GPa
[domain]
level = 5
[time]
end = 3
[feature dent]
surface = 1
shape = dent
depth = 0.1
width = 0.5
start = -1.8
[output]
every = 3
END
expect 0 "$OVERROLL" run dent.ini -o dent.h5 -q
expect 0 "$OVERROLL" run dent.ini -o other.h5 -q --set feature.dent.depth=0.05

cat dent.ini - >stress.ini <<'END'
[stress]
every = 4
fields = max_shear
END
expect 0 "$OVERROLL" run stress.ini -o stress.h5 -q --set domain.level=6

# A dent whose material yields: maps of what stays, where the dent is.
cat stress.ini - >yields.ini <<'END'
[plastic]
hardening = none
yield = 0.7
anyway = yes
layers = 8
END
expect 0 "$OVERROLL" run yields.ini -o yields.h5 -q
expect 0 "$OVERROLL" view yields.h5 -o yields.html
# Axes: name, symbol (unit).
for axis in 'position, x (b)' 'pressure, p (p_h)' 'position, x (mm)' \
    'pressure, p (GPa)' 'film thickness, h (µm)'; do
    grep -qF "\"name\":\"$axis\"" yields.html || fail "no axis '$axis'"
done

# Two layers on the body below.
{
    sed '/^modulus/d' stress.ini
    printf '[body %s]\nmodulus = 206 GPa\n' 1 2
    printf '[coating 1]\nthickness = 0.3\nmodulus = 350 GPa\n'
    printf '[coating 1b]\nthickness = 0.2\nmodulus = 120 GPa\n'
} >coated.ini
expect 0 "$OVERROLL" run coated.ini -o coated.h5 -q --set domain.level=6
expect 0 "$OVERROLL" view coated.h5 -o coated.html

{
    sed 's/^alpha = .*/&\nrheology = eyring\neyring_stress = 5 MPa/' dent.ini
    printf '[heat]\nmodel = lobatto\ntemperature = 80 degC\n'
} >hot.ini
expect 0 "$OVERROLL" run hot.ini -o hot.h5 -q --set time.end=0.5

expect 0 "$OVERROLL" view dent.h5 -o page.html
expect 0 "$OVERROLL" view hot.h5 -o hot.html
expect 0 "$OVERROLL" view stress.h5 -o stress.html
expect 0 "$OVERROLL" view dent.h5 -o shear.html --stress tau_xz
grep -q '"stress":{"name":"tau_xz"' shear.html || fail 'no tau_xz in the page'
grep -q '"T1":' page.html && fail 'temperatures of a run without heat'
grep -q '"stress":' page.html && fail 'stresses that nobody asked for'
grep -q '"layers":' stress.html && fail 'layers of a body that has none'
refuses 'no stress .high.' view dent.h5 -o none.html --stress high
refuses 'exists; --force' view dent.h5 -o page.html
refuses 'no output: set -o' view dent.h5
refuses 'No such file' view none.h5 -o none.html
expect 0 "$OVERROLL" view dent.h5 other.h5 -o two.html
sed 's/"data":"[^"]*"/"data":"AAAA"/' page.html >broken.html

# A gear pair: its answers, and its drawing with the contact under way.
expect 0 "$OVERROLL" init gear --set gear.torque=60N.m \
    --set gear.speed=2000rpm --set domain.level=5 -o gear.ini
expect 0 "$OVERROLL" run gear.ini -o gear-whole.h5 -q
expect 0 "$OVERROLL" view gear-whole.h5 -o gear.html

# Nothing of the page comes from elsewhere, and no text ends its element.
title="</title></script><script>document.body.dataset.stolen=1</script>
<img src=x onerror=\"document.body.dataset.stolen=1\">&amp;'\`id\`\\u003c"
expect 0 "$OVERROLL" view dent.h5 -o title.html --title "$title"
for page in page.html two.html title.html; do
    # (An escaped title may say what it likes.)
    if grep -v '&lt;' $page | grep -nE '(src|href)=|https?:|@import|url\('; then
        fail "$page refers to something else"
    fi
    [ "$(grep -c '<script' $page)" -eq 2 ] || fail "$page: more scripts"
done

# Screens narrower than Chromium's own windows: frames of their size.
{
    printf '<!DOCTYPE html><body style="margin:0">'
    printf '<iframe src="page.html" style="width:390px;height:844px;border:0">'
    printf '</iframe>'
    printf '<iframe src="page.html" style="width:844px;height:390px;border:0">'
    printf '</iframe></body>\n'
} >frame.html
{
    printf '<!DOCTYPE html><body style="margin:0">'
    printf '<iframe src="stress.html" style="width:420px;height:900px;">'
    printf '</iframe></body>\n'
} >frame-stress.html

need chromium chromedriver
need_python h5py
"$PYTHON" "$TOP/tests/pictures/view.py" "$PWD"
