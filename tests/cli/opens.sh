#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Result files are read without warnings by h5dump, ncdump and, in Python,
# h5py, netCDF4 and xarray with both engines.
. "$TOP/tests/support/cli.sh"

cat >dent.ini <<'END'
# a physical case
[contact]
load = 100 kN/m
radius = 12 mm
modulus = 226 GPa
viscosity = 40 mPa.s
speed_1 = 1 m/s
speed_2 = 0.8 m/s
[lubricant]
alpha = 20 1/GPa
[domain]
level = 4
[time]
end = 1
[feature dent]
shape = dent
depth = 0.1
width = 0.5
start = -2
[output]
every = 2
END
echo 'fields = pressure, film_thickness, roughness, density, viscosity,' \
    'mass_flow, cavitated' >>dent.ini
expect 0 "$OVERROLL" run dent.ini -o si.h5 -q
sed '/_thickness/d; /end = 1/s/1/0.5/' dent.ini >short.ini
expect 0 "$OVERROLL" run short.ini -o short.h5 -q --set output.precision=f32
printf '[contact]\nM = 20\nL = 0\n[domain]\nlevel = 4\n[time]\nend = 0.5\n' \
    >bare.ini
expect 0 "$OVERROLL" run bare.ini -o bare.h5 -q

need h5dump ncdump
for file in si short bare; do
    expect 0 h5dump -H $file.h5
    expect 0 h5dump $file.h5
    [ ! -s err ] || fail "h5dump $file.h5 says: $(cat err)"
    expect 0 ncdump -h $file.h5
    [ ! -s err ] || fail "ncdump $file.h5 says: $(cat err)"
    contains out 'pressure\(time, x\)'
    contains out 'time = UNLIMITED'
    contains out 'step = UNLIMITED'
    contains out ':Conventions = "CF-1.8"'
    contains out ':format_version = 2'
    contains out 'status = "complete"'
    contains out 'film_thickness:kind = "height"'
    expect 0 ncdump $file.h5
done
expect 0 ncdump -h si.h5
contains out 'pressure:units = "Pa"'
contains out 'film_thickness:units = "m"'
contains out 'time:units = "s"'
contains out 'contact.load = 100000'
expect 0 ncdump -h bare.h5
contains out 'pressure:units = "1"'
contains out 'contact.M = 20'

need_python h5py netCDF4 xarray h5netcdf
cat >look.py <<'END'
import warnings
warnings.simplefilter("error")
import sys
import h5py, netCDF4, numpy, xarray
for name in sys.argv[1:]:
    raw = h5py.File(name, "r")
    assert raw.attrs["status"] == "complete"
    assert "M = 20" in raw["case"].attrs["text"] or "load" in name + \
        raw["case"].attrs["text"]
    assert [d[0].name for d in raw["pressure"].dims] == ["/time", "/x"]
    tables = {}
    for engine in "h5netcdf", "netcdf4":
        with xarray.open_dataset(name, engine=engine) as d:
            d.load()
            assert d.pressure.dims == ("time", "x"), d.pressure.dims
            assert d.time.dtype == numpy.float64
            for v in d.variables.values():
                assert "units" in v.attrs and "long_name" in v.attrs
            assert not numpy.isnan(d.pressure.values).any()
            assert (d.pressure.values == raw["pressure"][...]).all()
            tables[engine] = d
        with xarray.open_dataset(name, engine=engine, group="history") as h:
            h.load()
            assert h.min_film_thickness.dims == ("step",)
            for key in ("time", "min_film_thickness", "max_pressure", "load",
                        "central_film_thickness", "rigid_approach", "cycles",
                        "residual"):
                assert not numpy.isnan(h[key].values).any(), key
            assert h.attrs == {} and (numpy.diff(h.time.values) > 0).all()
    assert tables["h5netcdf"].identical(tables["netcdf4"])
    with netCDF4.Dataset(name) as n:
        assert n["pressure"].dimensions == ("time", "x")
        assert n.dimensions["time"].isunlimited()
        assert n["history"].dimensions["step"].isunlimited()
END
expect 0 "$PYTHON" look.py si.h5 short.h5 bare.h5
[ ! -s err ] || fail "$(cat err)"
