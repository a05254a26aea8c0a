# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# For tests of plastic deformation: a dent with rims in body 1 that rolls
# through a steel contact at 1.2 GPa.

# indent LEVEL END START: the case up to its [output], whose keys follow.
indent() {
    cat <<END
[contact]
load = 300 kN/m
radius = 8 mm
speed_1 = 3.0 m/s
speed_2 = 3.0 m/s
[body 1]
modulus = 206 GPa
[body 2]
modulus = 206 GPa
[lubricant]
viscosity = 40 mPa.s
alpha = 17 1/GPa
p0 = 198 MPa
z = 0.68
[domain]
level = $1
order = 2
[time]
end = $2
[feature dent]
shape = indent
depth = 1.5 um
shoulder = 0.25 um
width = 0.6
start = $3
[output]
END
}
