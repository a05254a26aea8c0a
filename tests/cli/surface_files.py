# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces written with struct and NumPy, read back by the program.

usage: surface_files.py OVERROLL   (in a folder for files)
"""
import io
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import zipfile
import zlib

import numpy as np

OVERROLL = sys.argv[1]
rng = np.random.default_rng(58)


def run(*arguments, code=0):
    """What is printed; with code=1 what is refused."""
    done = subprocess.run([OVERROLL, "profile", *arguments],
                          capture_output=True, text=True)
    refused = 0 < done.returncode < 100
    assert refused if code else done.returncode == 0, (arguments, done.stderr)
    return done.stdout if code == 0 else done.stderr


def read(*arguments):
    """x and z of the line, without levelling."""
    run(*arguments, "--level", "none", "--max-gap", "1m", "--convert",
        "line.csv", "--force")
    return np.loadtxt("line.csv", delimiter=",", comments="#").T


def check(name, found, dx, z, tolerance=1e-12):
    x, heights = found
    assert len(heights) == len(z), (name, len(heights), len(z))
    assert np.allclose(x - x[0], dx * np.arange(len(z)), rtol=1e-6), name
    error = np.max(np.abs(heights - z))
    assert error <= tolerance, (name, error)


def check_lines(name, z, dx, dy, tolerance=1e-12, *arguments):
    """Rows, columns and a band of a map."""
    ny, nx = z.shape
    for row in (0, ny // 3, ny - 1):
        check(name, read(name, *arguments, "--row", str(row + 1)), dx, z[row],
              tolerance)
    for column in (0, nx - 1):
        check(name, read(name, *arguments, "--column", str(column + 1)), dy,
              z[:, column], tolerance)
    middle = ny // 2
    check(name, read(name, *arguments, "--y", f"{middle * dy:.17g} m"), dx,
          z[middle], tolerance)
    if ny >= 5:
        check(name, read(name, *arguments, "--row", str(middle + 1), "--band",
                         f"{4.4 * dy:.17g} m"), dx,
              z[middle - 2:middle + 3].mean(axis=0), tolerance)


# A surface of 7 rows and 11 columns, in nanometres
NX, NY, DX, DY = 11, 7, 2e-6, 3e-6
counts = rng.integers(-3000, 3000, (NY, NX))


# ------------------------------------------------------------------------- SDF

def sdf_text(dialect, values):
    lines = [f"a{dialect}", "ManufacID = TEST", "CreateDate = 010120260000",
             "ModDate = 010120260000", f"NumPoints = {NX}",
             f"NumProfiles = {NY}", f"Xscale = {DX}", f"Yscale = {DY}",
             "Zscale = 1e-9", "Zresolution = -1", "Compression = 0",
             "DataType = 7", "CheckType = 0", "*"]
    lines += [" ".join(str(v) for v in row) for row in values]
    return ("\r\n".join(lines) + "\r\n*\r\n*\r\n").encode()


TYPES = {0: "u1", 1: "<u2", 2: "<u4", 3: "<f4", 4: "i1", 5: "<i2", 6: "<i4",
         7: "<f8"}


def sdf_binary(dialect, values, kind):
    counts_of = "<II" if dialect == "ISO-2.0" else "<HH"
    head = f"b{dialect}".encode() + b"TEST      " + b"010120260000" * 2
    head += struct.pack(counts_of, NX, NY)
    head += struct.pack("<ddddBBB", DX, DY, 1e-9, -1, 0, kind, 0)
    return head + values.astype(TYPES[kind]).tobytes()


for dialect in ("ISO-1.0", "ISO-2.0", "BCR-1.0", "NIST-1.0"):
    with open("t.sdf", "wb") as file:
        file.write(sdf_text(dialect, counts))
    check_lines("t.sdf", counts * 1e-9, DX, DY)
    for kind in TYPES:
        values = counts
        if kind in (0, 4):
            values = counts % 100
        elif kind in (1, 2):
            values = counts + 3000
        with open("t.sdf", "wb") as file:
            file.write(sdf_binary(dialect, values, kind))
        check_lines("t.sdf", values * 1e-9, DX, DY)

# Missing: the lowest value of a type
for kind, low in ((3, np.finfo("f4").min), (4, -128), (5, -2**15),
                  (6, -2**31), (7, np.finfo("f8").min)):
    values = (counts % 100).astype("f8")
    values[2, 4] = low
    with open("t.sdf", "wb") as file:
        file.write(sdf_binary("ISO-2.0", values, kind))
    out = run("t.sdf", "--row", "3", "--max-gap", "1m")
    assert re.search(r"missing heights +1 +\(filled: 1\)", out), (kind, out)


# ------------------------------------------------------------------------- SUR

def sur(values, bits, kind=2, packed=False, special=False, comment=b""):
    head = bytearray(512)
    ny, nx = values.shape

    def put(at, form, *what):
        struct.pack_into("<" + form, head, at, *what)

    head[:12] = b"DSCOMPRESSED" if packed else b"DIGITAL SURF"
    put(12, "hhhh", 0, 1, 1, kind)
    put(86, "h", special)
    low = int(values[values > values.min()].min() if special else values.min())
    put(98, "h", bits)
    put(100, "iiiii", low, int(values.max()), nx, ny, nx * ny)
    put(120, "fff", DX * 1e3, DY * 1e3, 1e-3)
    for at, unit in ((180, b"mm"), (196, b"mm"), (212, b"\xb5m")):
        head[at:at + len(unit)] = unit
    put(334, "hh", len(comment), 3)
    put(474, "f", 0.25)  # offset of z, um
    data = values.astype("<i2" if bits == 16 else "<i4").tobytes()
    if packed:
        parts = [data[k:k + 40] for k in range(0, len(data), 40)]
        zipped = [zlib.compress(part) for part in parts]
        data = struct.pack("<I", len(parts))
        data += b"".join(struct.pack("<II", len(a), len(b))
                         for a, b in zip(parts, zipped))
        data += b"".join(zipped)
    return bytes(head) + comment + b"prv" + data


for bits in (16, 32):
    for packed in (False, True):
        for comment in (b"", b"measured in May"):
            with open("t.sur", "wb") as file:
                file.write(sur(counts, bits, 2, packed, False, comment))
            # single precision in the header
            check_lines("t.sur", counts * 1e-9 + 0.25e-6, DX, DY, 1e-12)
        with open("t.pro", "wb") as file:
            file.write(sur(counts[:1], bits, 1, packed))
        check("t.pro", read("t.pro"), DX, counts[0] * 1e-9 + 0.25e-6, 1e-12)
values = counts.copy()
values[2, 4] = values.min() - 2
with open("t.sur", "wb") as file:
    file.write(sur(values, 16, special=True))
assert re.search("missing heights +1 ",
                 run("t.sur", "--row", "3", "--max-gap", "1m"))
whole = sur(counts, 32, 2, True)
for cut in (100, 511, 515, 519, 530, len(whole) - 1):
    with open("t.sur", "wb") as file:
        file.write(whole[:cut])
    assert "truncated" in run("t.sur", code=1), cut
bad = bytearray(whole)
bad[-5] ^= 255
with open("t.sur", "wb") as file:
    file.write(bad)
assert "damaged" in run("t.sur", code=1)

# ----------------------------------------------------------------------- NumPy
for kind in ("<f8", "<f4", ">f8", ">i2", "<i4", "u1", "<u2"):
    values = (counts % 100).astype(kind)
    for order in "CF":
        np.save("t.npy", np.array(values, order=order))
        check_lines("t.npy", values.astype("f8") * 1e-9, 1e-6, 1e-6, 1e-12,
                    "--spacing", "1um", "--unit-z", "nm")
    np.save("line.npy", values[0])
    check("line.npy", read("line.npy", "--spacing", "1um", "--unit-z", "nm"),
          1e-6, values[0].astype("f8") * 1e-9)
assert "set --spacing" in run("t.npy", code=1)
np.save("c.npy", counts.astype(complex))
assert "descr must be" in run("c.npy", "--spacing", "1um", "--unit-z", "nm",
                              code=1)
np.save("c.npy", np.zeros((2, 3, 4)))
assert "one or two dimensions" in run("c.npy", "--spacing", "1um", "--unit-z",
                                      "nm", code=1)

# ------------------------------------------------------------------------- X3P
buffer = io.BytesIO()
with zipfile.ZipFile(buffer, "w") as package:
    package.writestr("main.xml", f"""<?xml version="1.0"?>
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1>
<FeatureType>SUR</FeatureType><Axes><CX><AxisType>I</AxisType>
<Increment>{DX}</Increment></CX><CY><AxisType>I</AxisType>
<Increment>{DY}</Increment></CY><CZ><AxisType>A</AxisType>
<DataType>D</DataType></CZ></Axes></Record1><Record3><MatrixDimension>
<SizeX>{NX}</SizeX><SizeY>{NY}</SizeY><SizeZ>1</SizeZ></MatrixDimension>
<DataLink><PointDataLink>d.bin</PointDataLink></DataLink></Record3>
</p:ISO5436_2>""")
    package.writestr("d.bin", (counts * 1e-9).astype("<f8").tobytes())
with open("t.x3p", "wb") as file:
    file.write(buffer.getvalue())
check_lines("t.x3p", counts * 1e-9, DX, DY)


class Stream(io.RawIOBase):
    """A stream that cannot go back: sizes are written after the data."""

    def __init__(self):
        self.bytes = b""

    def writable(self):
        return True

    def write(self, data):
        self.bytes += bytes(data)
        return len(data)


# The same in archives as others write them: deflated, in a folder, with a
# comment, with 64-bit sizes, as a stream
with zipfile.ZipFile("t.x3p") as package:
    parts = {name: package.read(name) for name in package.namelist()}


def archive(method=zipfile.ZIP_DEFLATED, folder="", comment=b"", large=False,
            to=None):
    to = to or io.BytesIO()
    with zipfile.ZipFile(to, "w", method) as package:
        for part, data in parts.items():
            with package.open(folder + part, "w", force_zip64=large) as file:
                file.write(data)
        package.comment = comment
    return to.bytes if isinstance(to, Stream) else to.getvalue()


def write_bytes(name, data):
    with open(name, "wb") as file:
        file.write(data)


for content in (archive(), archive(zipfile.ZIP_STORED), archive(folder="a/b/"),
                archive(comment=b"PK\5\6 " * 9000), archive(large=True),
                archive(to=Stream()), archive(large=True, to=Stream())):
    write_bytes("v.x3p", content)
    check_lines("v.x3p", counts * 1e-9, DX, DY)
write_bytes("v.x3p", archive(zipfile.ZIP_LZMA))
assert "neither stored nor deflated" in run("v.x3p", code=1)
whole = archive()
for cut in (30, len(whole) // 2, len(whole) - 5):
    write_bytes("v.x3p", whole[:cut])
    assert "not a readable ZIP" in run("v.x3p", code=1)
at = whole.index(b"PK\1\2") + 8  # flags of the first entry
write_bytes("v.x3p", whole[:at] + bytes([whole[at] | 1]) + whole[at + 1:])
assert "encrypted" in run("v.x3p", code=1)

# ------------------------------------------------------------------------ text
with open("g.txt", "w", encoding="utf-8") as file:
    file.write(f"# Channel: Height\n# Width: {DX * NX * 1e6} µm\n"
               f"# Height: {DY * NY * 1e6} µm\n# Value units: m\n")
    for row in counts * 1e-9:
        file.write("\t".join(f"{v:.9e}" for v in row) + "\n")
check_lines("g.txt", counts * 1e-9, DX, DY)
wide = rng.normal(size=(12, 200))
np.savetxt("wide.csv", wide, delimiter=",")
check_lines("wide.csv", wide * 1e-6, 1e-6, 1e-6, 1e-15, "--spacing", "1um",
            "--unit-z", "um")
assert "12 rows of 200 heights" in run("wide.csv", code=1)
np.savetxt("narrow.csv", counts, delimiter=";", fmt="%d")
check_lines("narrow.csv", counts * 1e-9, 1e-6, 1e-6, 1e-15, "--spacing", "1um",
            "--unit-z", "nm")
with open("narrow.csv", "a") as file:
    file.write("1;2;3\n")
assert "narrow.csv:8: 3 columns, but the rows above have 11" in run(
    "narrow.csv", "--spacing", "1um", "--unit-z", "nm", code=1)

# x y z in random order, with two points missing: those rows have gaps
j, i = np.divmod(rng.permutation(NX * NY), NX)
keep = ~(((i == 4) & (j == 2)) | ((i == 5) & (j == 4)))
points = np.c_[i * DX * 1e6, j * DY * 1e6, counts[j, i]][keep]
for header in ("x um,y um,z nm\n", "x [µm];y [µm];z [nm]\n"):
    with open("xyz.csv", "w", encoding="utf-8") as file:
        file.write(header)
        for point in points:
            file.write(header[4 if header[2] == "u" else 6].join(
                f"{v:.6f}" for v in point) + "\n")
    for row in (0, 6):
        check("xyz.csv", read("xyz.csv", "--row", str(row + 1)), DX,
              counts[row] * 1e-9)
    assert re.search("missing heights +1 ",
                     run("xyz.csv", "--row", "3", "--max-gap", "1m"))

# ------------------------------------------------------------ choice of a line
for lay in (0, 30, 90, -60):
    # grooves of 8 um wavelength along the lay
    t = np.radians(lay)
    y, x = np.mgrid[0:120, 0:150] * 1e-6
    wave = 1e-7 * np.sin(2 * np.pi / 8e-6 * (x * np.sin(t) - y * np.cos(t)))
    np.save("lay.npy", wave + 1e-9 * rng.normal(size=wave.shape))
    arguments = ("lay.npy", "--spacing", "1um", "--unit-z", "m")
    report = json.loads(run(*arguments, "--json"))
    found = report["map"]["lay_degrees"]
    error = (found - lay + 90) % 180 - 90
    assert abs(error) < 1, (lay, found)
    assert report["map"]["Str"] < 0.1, report["map"]
    assert abs(report["map"]["Sq_m"] / np.std(wave) - 1) < 0.02
    # across the lay: the wave is seen whole (bilinear interpolation damps it)
    assert abs(report["Pq_m"] / 1e-7 * 2**0.5 - 1) < 0.1, (lay, report["Pq_m"])
    assert abs(report["waves"][0]["wavelength_m"] / 8e-6 - 1) < 0.05
    # along it there is little of it
    along = json.loads(run(*arguments, "--direction", str(lay), "--json"))
    assert along["Pq_m"] < 0.1 * report["Pq_m"], (lay, along["Pq_m"])
np.save("rough.npy", rng.normal(size=(60, 60)))
report = json.loads(run("rough.npy", "--spacing", "1um", "--unit-z", "nm",
                        "--json"))
assert report["map"]["lay_degrees"] is None and report["map"]["Str"] > 0.5
# An oblique line of a plane is the plane
y, x = np.mgrid[0:40, 0:60] * 1e-6
np.save("plane.npy", 2e-3 * x + 1e-3 * y)
x, z = read("plane.npy", "--spacing", "1um", "--unit-z", "m", "--direction",
            "25")
slope = 2e-3 * np.cos(np.radians(25)) + 1e-3 * np.sin(np.radians(25))
assert np.allclose(np.diff(z) / np.diff(x), slope, rtol=1e-9)

# An empty line is refused with one that has heights; by default one is chosen
hollow = wave.copy()
hollow[50:70] = np.nan
np.save("hollow.npy", hollow)
message = run("hollow.npy", "--spacing", "1um", "--unit-z", "m", "--row", "55",
              code=1)
assert "row 55 has no heights; --row = 50 has" in message, message
hollow = np.full((9, 9), np.nan)
hollow[7] = rng.normal(size=9)
np.save("hollow.npy", hollow)
assert "row 8 of 9" in run("hollow.npy", "--spacing", "1um", "--unit-z", "nm")

# ------------------------------------------------------------------ conversion
for name in ("c.x3p", "c.sdf"):
    run("t.x3p", "--row", "2", "--level", "none", "--convert", name, "--force")
    check(name, read(name), DX, counts[1] * 1e-9, 1e-18)
with zipfile.ZipFile("c.x3p") as package:
    import hashlib
    assert package.testzip() is None
    main = package.read("main.xml")
    digest = hashlib.md5(main).hexdigest()
    stored = package.read("md5checksum.hex").decode().split()
    assert stored[0].lower() == digest and stored[1].endswith("main.xml")
    points = package.read("bindata/data.bin")
    assert np.allclose(np.frombuffer(points, "<f8"), counts[1] * 1e-9)
    assert hashlib.md5(points).hexdigest() in main.decode().lower()
with open("c.sdf", "rb") as file:
    raw = file.read()
assert raw[:8] == b"bISO-1.0" and len(raw) == 81 + 8 * NX
assert struct.unpack("<HH", raw[42:46]) == (NX, 1)
assert struct.unpack("<d", raw[46:54])[0] == DX


# The picture of a map: its cells are means of heights about the mean plane.
# gnuplot is one that keeps its script and draws it.
def drawn(*arguments):
    """Cells of the map and the ends of the line on it, in um."""
    os.makedirs("bin", exist_ok=True)
    with open("bin/gnuplot", "w") as f:
        f.write('#!/bin/sh\nwhile IFS= read -r line; do\n'
                '  cp .?*.gp kept.gp\n  printf "%s\\n" "$line"\n'
                f'done | {shutil.which("gnuplot")} "$@"\n')
    os.chmod("bin/gnuplot", 0o755)
    path = {**os.environ, "PATH": "bin:" + os.environ["PATH"]}
    subprocess.run([OVERROLL, "profile", *arguments, "--plot", "map.png",
                    "--force"], check=True, env=path, stdout=subprocess.PIPE)
    assert open("map.png", "rb").read(8)[1:4] == b"PNG"
    text = open("kept.gp").read().split("EOD")[1]
    line, _, image = text.strip().split("\n\n\n")
    table = [row.split() for row in line.split("\n")[1:]]
    cells = [row.split() for row in image.strip().split("\n")[1:]]
    return np.array(cells, float), np.array(table, float)


if shutil.which("gnuplot"):
    ny, nx = 30, 1250  # three points a side in a cell
    j, i = np.mgrid[:ny, :nx].astype(float)
    z = rng.normal(size=(ny, nx)) + 0.3 * i - 2 * j + 5
    z[4:8, 30:36] = np.nan
    np.save("map.npy", z)
    cells, line = drawn("map.npy", "--spacing", "2um", "--unit-z", "um",
                        "--column", "11", "--level", "none")
    there = ~np.isnan(z)
    fit = np.linalg.lstsq(np.column_stack([np.ones(there.sum()), i[there],
                                           j[there]]), z[there], rcond=None)[0]
    flat = z - fit[0] - fit[1] * i - fit[2] * j
    padded = np.full((ny, 1251), np.nan)
    padded[:, :nx] = flat
    blocks = padded.reshape(ny // 3, 3, 417, 3).swapaxes(1, 2)
    blocks = blocks.reshape(ny // 3, 417, 9)
    with np.errstate(invalid="ignore"):
        count = (~np.isnan(blocks)).sum(axis=2)
        wanted = np.where(count, np.nansum(blocks, axis=2) / count, np.nan)
    assert cells.shape == wanted.shape, cells.shape
    assert (np.isnan(cells) == np.isnan(wanted)).all()
    assert np.nanmax(np.abs(cells - wanted)) < 1e-4
    assert np.allclose(line, [[20, 0], [20, 58]]), line

# An empty line through the centre: the direction that is named has heights
empty = np.full((60, 60), np.nan)
empty[:18] = rng.normal(size=(18, 60))
np.save("empty.npy", empty)
arguments = ("empty.npy", "--spacing", "1um", "--unit-z", "um",
             "--max-missing", "1")
named = run(*arguments, "--direction", "3", code=1)
other = re.search(r"--direction = (-?\d+) has", named).group(1)
run(*arguments, "--direction", other)
