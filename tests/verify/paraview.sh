#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK's netCDF reader, which ParaView uses, reads the same values as h5py for
# every field of a result at every time.
. "$TOP/tests/support/cli.sh"
for PYTHON in python3 /usr/bin/python3; do
    "$PYTHON" -c 'import h5py, vtkmodules.vtkIONetCDF' 2>/dev/null && break
done
"$PYTHON" -c 'import h5py, vtkmodules.vtkIONetCDF' 2>/dev/null ||
    skip 'no Python with h5py and VTK (python3-vtk9)'

sized_dent_case 5 1 0.1 1 -2 >dent.ini
cat >>dent.ini <<'END'
[output]
every = 5
END
expect 0 "$OVERROLL" run dent.ini -o dent.h5 -q
cat >look.py <<'END'
import h5py
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

stored = h5py.File("dent.h5")
reader = vtkNetCDFCFReader()
reader.SetFileName("dent.h5")
reader.UpdateInformation()
steps = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
about = reader.GetOutputInformation(0)
times = [about.Get(steps, k) for k in range(about.Length(steps))]
assert numpy.array_equal(times, stored["time"][...]), times
for k, time in enumerate(times):
    reader.UpdateTimeStep(time)
    points = reader.GetOutput().GetPointData()
    for name in "pressure", "film_thickness", "roughness":
        read = vtk_to_numpy(points.GetArray(name))
        assert numpy.array_equal(read, stored[name][k]), (name, time)
print(len(times), "times")
END
expect 0 "$PYTHON" look.py
contains out '^[0-9]+ times'

# A strip is an image in x and y, also with the reader's default of spherical
# coordinates.
cat >strip.ini <<'END'
[contact]
M = 20
L = 10
[domain]
level = 4
[strip]
[time]
end = 1
[feature dent]
shape = dent
depth = 0.08
width = 1
start = -2
[output]
every = 5
END
expect 0 "$OVERROLL" run strip.ini -o strip.h5 -q
cat >strip.py <<'END'
import h5py
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

stored = h5py.File("strip.h5")
reader = vtkNetCDFCFReader()
reader.SetFileName("strip.h5")
reader.SphericalCoordinatesOn()
for k, time in enumerate(stored["time"][...]):
    reader.UpdateTimeStep(time)
    image = reader.GetOutput()
    x, y = stored["x"][...], stored["y"][...]
    assert image.GetDimensions() == (len(x), len(y), 1)
    assert numpy.allclose(image.GetBounds(), [x[0], x[-1], y[0], y[-1], 0, 0])
    for name in "pressure", "film_thickness", "roughness":
        read = vtk_to_numpy(image.GetPointData().GetArray(name))
        assert numpy.array_equal(read, stored[name][k].ravel()), (name, time)
print(len(stored["time"]), "times")
END
expect 0 "$PYTHON" strip.py
contains out '^[2-9] times'

# ParaView itself draws it: dark and light, as the film is at its ends.
command -v pvbatch >/dev/null && command -v xvfb-run >/dev/null || exit 0
cat >draw.py <<'END'
from paraview.simple import *
strip = NetCDFReader(FileName=["strip.h5"])
strip.UpdatePipeline()
view = CreateView("RenderView")
view.ViewSize = [600, 400]
shown = Show(strip, view)
ColorBy(shown, ("POINTS", "pressure"))
shown.RescaleTransferFunctionToDataRange()
view.ViewTime = strip.TimestepValues[-1]
view.ResetCamera()
SaveScreenshot("strip.png", view)
END
xvfb-run -a timeout 100 pvbatch draw.py >drawn 2>&1 || fail "$(tail -3 drawn)"
python3 - <<'END' || fail "strip.png is of one colour"
import struct, zlib
data = open("strip.png", "rb").read()
at, pixels = 8, b""
while at < len(data):
    size, kind = struct.unpack(">I4s", data[at:at + 8])
    if kind == b"IDAT":
        pixels += data[at + 8:at + 8 + size]
    at += size + 12
assert len(set(zlib.decompress(pixels))) > 50
END
