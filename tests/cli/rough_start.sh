#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A steady start with rough surfaces under the whole film: the features grow
# from smooth surfaces.
. "$TOP/tests/support/cli.sh"

{
    cat <<END
[contact]
load = 3.07e5 N/m
radius = 10 mm
modulus = 226 GPa
viscosity = 40 mPa.s
mean_speed = 1.3 m/s
slide_to_roll = 0.3
[lubricant]
viscosity_law = roelands
density_law = dowson-higginson
alpha = 17 1/GPa
z = 0.68
[domain]
inlet = -4
outlet = 1.5
level = 8
[time]
end = 0.005
END
    for side in '1 ground periodic' '2 honed mirror'; do
        # shellcheck disable=SC2086 # three words
        set -- $side
        cat <<END
[feature on$1]
surface = $1
shape = profile
file = $TOP/profiles/$2.csv
level = line
extend = $3
taper = 60 um
start = 1.5
END
    done
} >both.ini
expect 0 "$OVERROLL" run both.ini -o both.h5 --json
contains out '"way": "from smooth surfaces, with growing features"'
contains out '"converged": true'

# Mass-conserving cavitation after the features have grown: damped cycles find
# the film where ordinary ones diverge.
cat >waves.ini <<END
[contact]
M = 128.15
L = 9.4387
modulus = 226 GPa
slide_to_roll = 0.583
[domain]
level = 8
[time]
end = 0.002
[cavitation]
model = conserving
[feature f0]
surface = 2
shape = wave
amplitude = 0.0559
wavelength = 0.515
origin = 0
[feature f1]
surface = 2
shape = wave
amplitude = 0.0488
wavelength = 0.477
origin = 0
END
expect 0 "$OVERROLL" run waves.ini -o waves.h5 --json
contains out '"way": "from smooth surfaces, with growing features"'
