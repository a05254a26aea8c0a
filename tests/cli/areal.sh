#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# shape = areal: the same map as SDF, X3P and text matrix; parameters of the
# map, width of the strip, rejected values.
. "$TOP/tests/support/cli.sh"
need_python zipfile

"$PYTHON" - <<'END'
import math, struct, zipfile
nx, ny, d = 80, 60, 2e-6
z = [[2e-7 * math.cos(2 * math.pi * (i / 20 + j / 30)) + 1e-8 * i
      for i in range(nx)] for j in range(ny)]
with open("map.sdf", "w") as f:
    f.write(f"aISO-1.0\nManufacID = none\nCreateDate = 010120260000\n"
            f"ModDate = 010120260000\nNumPoints = {nx}\nNumProfiles = {ny}\n"
            f"Xscale = {d}\nYscale = {d}\nZscale = 1e-12\nZresolution = -1\n"
            f"Compression = 0\nDataType = 7\nCheckType = 0\n*\n")
    for row in z:
        f.write(" ".join(f"{1e12 * v:.17g}" for v in row) + "\n")
    f.write("*\n")
with open("map.txt", "w") as f:
    for row in z:
        f.write("\t".join(f"{1e6 * v:.17g}" for v in row) + "\n")
axis = "".join(f"<C{n}><AxisType>{t}</AxisType><DataType>D</DataType>"
               f"<Increment>{i}</Increment><Offset>0</Offset></C{n}>"
               for n, t, i in (("X", "I", d), ("Y", "I", d), ("Z", "A", 1)))
main = (f"<p:ISO5436_2 xmlns:p='http://www.opengps.eu/2008/ISO5436_2'>"
        f"<Record1><Revision>ISO5436 - 2000</Revision><FeatureType>SUR"
        f"</FeatureType><Axes>{axis}</Axes></Record1><Record3>"
        f"<MatrixDimension><SizeX>{nx}</SizeX><SizeY>{ny}</SizeY><SizeZ>1"
        f"</SizeZ></MatrixDimension><DataLink><PointDataLink>bindata/data.bin"
        f"</PointDataLink></DataLink></Record3></p:ISO5436_2>")
with zipfile.ZipFile("map.x3p", "w") as f:
    f.writestr("main.xml", main)
    f.writestr("bindata/data.bin",
               b"".join(struct.pack("<d", v) for row in z for v in row))
END

cat >map.ini <<'END'
[contact]
load = 300 kN/m
radius = 8 mm
modulus = 226 GPa
mean_speed = 3 m/s
[lubricant]
alpha = 20 1/GPa
viscosity = 60 mPa.s
[domain]
level = 4
[strip]
[time]
end = 0.1
[feature map]
shape = areal
file = map.sdf
max_missing = 0.1
END

# Of a map one line is converted, and said to be.
expect 0 "$OVERROLL" profile map.sdf --row 7 --convert line.csv
contains err 'line.csv holds one line of the map'
[ "$(grep -vc '^#' line.csv)" -eq 80 ] || fail 'not one row of 80 points'
expect 0 "$OVERROLL" profile line.csv --convert again.csv
[ ! -s err ] || fail 'a profile is called a map'

# The wave has Sq 0.2 um/sqrt(2); the plane below it is removed.
for file in map.sdf map.x3p map.txt; do
    set -- --set "feature.map.file=$file"
    [ $file != map.txt ] ||
        set -- "$@" --set 'feature.map.spacing=2 um' \
            --set feature.map.unit_z=um
    expect 0 "$OVERROLL" check map.ini "$@"
    contains out '80 x 60 points, 0.158 mm x 0.118 mm: Sq 0\.141[0-9]* um'
    contains out 'F-operation: least-squares plane removed'
    # 59 intervals less 5 %, in b = 0.164 mm.
    contains out '^#   strip +0\.681[0-9]* b wide, periodic'
done
expect 0 "$OVERROLL" run map.ini -o map.h5 -q
expect 0 "$OVERROLL" run map.ini -o same.h5 -q --set feature.map.file=map.x3p
for file in map same; do
    "$OVERROLL" export $file.h5 --snapshot last --areal -o $file.csv
done
cmp map.csv same.csv || fail "SDF and X3P give other films"

# Rows that are further apart than the points of one.
set -- --set feature.map.file=map.txt --set 'feature.map.spacing=2 um' \
    --set feature.map.unit_z=um
expect 0 "$OVERROLL" check map.ini "$@" \
    --set 'feature.map.spacing_across=4 um' --set feature.map.outliers=20
contains out 'spacing 2 um x 4 um, z in um'
contains out '80 x 60 points, 0.158 mm x 0.236 mm: Sq'
contains out ' 0 outliers beyond 20 robust'
expect 0 "$OVERROLL" profile map.txt --spacing '2 um' --unit-z um \
    --spacing-across '0.01 mm' --json
"$PYTHON" -c 'import json
assert abs(json.load(open("out"))["map"]["dy_m"] - 1e-5) < 1e-18'

# Other windows and widths.
expect 0 "$OVERROLL" check map.ini --set 'feature.map.to_across=0.1 mm' \
    --set 'feature.map.turn=yes' --set 'feature.map.lambda_c=0.1 mm' \
    --set feature.map.level=polynomial --set feature.map.degree=4
contains out 'window: 60 x 51 of 60 x 80 points'
contains out 'polynomial of degree 4 removed'
contains out 'L-filter: Gaussian, nesting index 0.1 mm'
refuses 'is not periodic in a strip 2 b wide; set strip.width to 1\.36[0-9]*' \
    check map.ini --set strip.width=2
expect 0 "$OVERROLL" check map.ini --set strip.width=2 \
    --set feature.map.extend_across=none
refuses 'strip.width to at least 0\.717' check map.ini --set strip.width=0.5 \
    --set feature.map.extend_across=none
refuses 'must be none, mean, plane or polynomial' \
    check map.ini --set feature.map.level=circle
refuses 'lambda_c must be longer than lambda_s' check map.ini \
    --set 'feature.map.lambda_c=10 um' --set 'feature.map.lambda_s=20 um'
refuses "feature 'map': taper_across = 5 b must be at most half the width" \
    check map.ini --set feature.map.taper_across=5
refuses "feature 'map': the map is 0\.09[0-9]* b long, less than 4 mesh" \
    check map.ini --set feature.map.stretch=0.1
sed '/strip/d' map.ini >line.ini
refuses 'an areal surface needs \[strip\]' check line.ini

# profile: parameters of the surface as measured and after the filters.
expect 0 "$OVERROLL" profile map.sdf --json
contains out '"Ssk": '
expect 0 "$OVERROLL" profile map.sdf --lambda-s '60 um'
contains out '^kurtosis Sku '
