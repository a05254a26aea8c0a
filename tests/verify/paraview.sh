#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# VTK's netCDF reader, which is ParaView's, reads every field of a result at
# every time as h5py does.
. "$TOP/tests/support/cli.sh"
for PYTHON in python3 /usr/bin/python3; do
    "$PYTHON" -c 'import h5py, vtkmodules.vtkIONetCDF' 2>/dev/null && break
done
"$PYTHON" -c 'import h5py, vtkmodules.vtkIONetCDF' 2>/dev/null ||
    skip 'no Python with h5py and VTK (python3-vtk9)'

cat >dent.ini <<'END'
[contact]
M = 20
L = 10
radius = 10 mm
modulus = 226 GPa
viscosity = 40 mPa.s
[domain]
level = 5
[time]
end = 1
[feature dent]
shape = dent
depth = 0.1
width = 1
start = -2
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
