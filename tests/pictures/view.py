# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives the pages that view.sh wrote to the given folder."""
import re
import sys
import time

import h5py
import numpy as np

from browser import Browser

folder = sys.argv[1]
LEFT, RIGHT = "\ue012", "\ue014"
HOME, END = "\ue011", "\ue010"


def shown(browser):
    return int(browser.run("return document.body.dataset.drawn"))


def numbers(text):
    """Parses 'x = 1.2 mm p = 3 GPa' to values in SI units by name."""
    scale = {"mm": 1e-3, "µm": 1e-6, "nm": 1e-9, "GPa": 1e9, "MPa": 1e6,
             "kPa": 1e3, "": 1}
    text = text.replace("\u2212", "-").replace("roughness", "s =")
    found = re.findall(r"([xphs]) = (\S+) ?(\S*?)(?= {2}|$)", text)
    return {name: float(v) * scale[unit] for name, v, unit in found}


def painted(browser, canvas):
    """Returns the number of different colours of a canvas."""
    return browser.run("""
        const c = document.querySelectorAll("canvas")[arguments[0]];
        const d = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
        const seen = new Set();
        for (let i = 0; i < d.length; i += 4)
            if (d[i + 3]) seen.add(d[i] << 16 | d[i + 1] << 8 | d[i + 2]);
        return seen.size;""", canvas)


def box(browser, selector):
    return browser.run("""
        const r = document.querySelector(arguments[0]).getBoundingClientRect();
        return [r.left, r.top, r.width, r.height];""", selector)


def load(browser, page):
    browser.open(f"file://{folder}/{page}")
    if page.startswith("frame"):
        return
    browser.wait("return document.body.dataset.drawn !== undefined")
    trouble = browser.run("return document.getElementById('trouble').textContent")
    assert not trouble, trouble


def hover(browser, file, shot, number=0):
    """Compares values at three positions with the file, in SI units."""
    x = file["x"][:]
    for part in (0.35, 0.6, 0.8):
        left, top, width, height = box(browser, "canvas.plot")
        browser.pointer(left + part * width, top + height / 3)
        browser.wait(f"return document.getElementById('values{number}')"
                     ".textContent.startsWith('x')")
        time.sleep(0.1)
        text = browser.run(
            f"return document.getElementById('values{number}').textContent")
        read = numbers(text)
        i = int(np.argmin(abs(x - read["x"])))
        for name, field, share in (("p", "pressure", 5e-5),
                                   ("h", "film_thickness", 0),
                                   ("s", "roughness", 1e-4)):
            truth = file[field][shot, i]
            whole = np.ptp(file[field][:])
            allowed = 6e-4 * abs(truth) + share * whole
            assert abs(read[name] - truth) <= allowed, (text, field, truth)


def seeks(browser, shots):
    browser.run("""const s = document.getElementById("scrub");
        s.value = arguments[0]; s.dispatchEvent(new Event("input"));""",
                shots // 2)
    browser.wait(f"return document.body.dataset.drawn == {shots // 2}")
    browser.keys(RIGHT)
    browser.wait(f"return document.body.dataset.drawn == {shots // 2 + 1}")
    browser.keys(LEFT, LEFT)
    browser.wait(f"return document.body.dataset.drawn == {shots // 2 - 1}")
    browser.keys(END)
    browser.wait(f"return document.body.dataset.drawn == {shots - 1}")
    browser.keys(HOME)
    browser.wait("return document.body.dataset.drawn == 0")
    left, top, width, height = box(browser, "canvas.history")
    browser.pointer(left + 0.5 * width, top + height / 2, click=True)
    browser.wait("return document.body.dataset.drawn > 0")
    assert abs(shown(browser) / (shots - 1) - 0.5) < 0.1, shown(browser)


def choose(browser, name, value):
    browser.run("""const s = document.getElementById(arguments[0]);
        s.value = arguments[1]; s.dispatchEvent(new Event("change"));""",
                name, value)


def stresses(browser):
    """The field below the film equals the file's, on both scales; the mark is
    at its maximum."""
    file = h5py.File(f"{folder}/stress.h5")
    group, b = file["stress/surface_1"], file.attrs["scale_length"]
    x, z = group["x"][:] / b, group["depth"][:] / b
    assert painted(browser, 1) > 100
    for shot in (0, len(group["time"]) // 2, len(group["time"]) - 1):
        field = group["max_shear"][shot] / file.attrs["scale_pressure"]
        drawn = int(np.argmin(abs(file["time"][:] - group["time"][shot])))
        browser.run("""const s = document.getElementById("scrub");
            s.value = arguments[0]; s.dispatchEvent(new Event("input"));""",
                    drawn)
        browser.wait(f"return document.body.dataset.drawn == {drawn}")
        for scale in ("linear", "log"):
            choose(browser, "depth", scale)
            time.sleep(0.2)
            left, top, width, height = box(browser, "canvas.stress")
            for part in (0.3, 0.5, 0.7):
                browser.pointer(left + part * width, top + 0.6 * height)
                time.sleep(0.1)
                X, Z, v = map(float, browser.run(
                    "return document.querySelector('canvas.stress')"
                    ".dataset.pointed").split())
                rows = [np.interp(X, x, row) for row in field]
                truth = np.interp(np.log(Z), np.log(z), rows)
                assert abs(v - truth) < 0.01, (shot, scale, X, Z, v, truth)
        X, Z, worst = map(float, browser.run(
            "return document.querySelector('canvas.stress')"
            ".dataset.worst").split())
        deep = z >= 8 * (file["x"][1] - file["x"][0]) / b * (1 - 1e-9)
        seen = (x > -1.8) & (x < 1.5)
        most = field[deep][:, seen].max()
        assert abs(worst / most - 1) < 0.02, (shot, worst, most)


def layered(browser):
    """White lines mark the interfaces of layers on both scales."""
    lines = []
    for scale in ("linear", "log"):
        choose(browser, "depth", scale)
        time.sleep(0.2)
        left, top, width, _ = box(browser, "canvas.stress")
        lines = [float(y) for y in browser.run(
            "return document.querySelector('canvas.stress')"
            ".dataset.layers").split()]
        assert len(lines) == 2, lines
        for y, Z in zip(lines, (0.3, 0.5)):
            browser.pointer(left + 0.4 * width, top + y)
            time.sleep(0.1)
            pointed = float(browser.run(
                "return document.querySelector('canvas.stress')"
                ".dataset.pointed").split()[1])
            assert abs(pointed / Z - 1) < 0.05, (scale, y, pointed, Z)
    white = browser.run("""
        const c = document.querySelector("canvas.stress");
        const f = c.height / c.getBoundingClientRect().height, w = c.width;
        const d = c.getContext("2d").getImageData(0, 0, w, c.height).data;
        return arguments[0].map((y) => {
          let n = 0;
          for (let x = w >> 2; x < w >> 1; x++) {
            const i = 4 * (Math.round(y * f) * w + x);
            if (Math.min(d[i], d[i + 1], d[i + 2]) > 200) n++;
          }
          return n / ((w >> 1) - (w >> 2)); });""", lines)
    assert min(white) > 0.9, white


def yielded(browser):
    """Plastic strains are drawn below the film at the present position of the
    material; they move with the surface."""
    file = h5py.File(f"{folder}/yields.h5")
    group = file["plastic/surface_1"]
    b = file.attrs["scale_length"]
    xi, z = group["material"][:] / b, group["depth"][:] / b
    names = browser.run("return [...document.getElementById('below').options]"
                        ".map((o) => o.textContent)")
    assert names == ["max shear", "plastic strain", "residual stress along x",
                     "residual stress along z", "residual shear stress"], names
    choose(browser, "depth", "log")
    for below, name, unit in ((1, "cumulative", 1),
                              (2, "residual_x", file.attrs["scale_pressure"])):
        choose(browser, "below", str(below))
        values = group[name][:] / unit
        assert abs(values).max() > 0
        for T in (1.6, 2.0):
            shot = int(np.argmin(abs(file["time"][:] /
                                     file.attrs["scale_time"] - T)))
            now = file["time"][shot] / file.attrs["scale_time"]
            browser.run("""const s = document.getElementById("scrub");
                s.value = arguments[0];
                s.dispatchEvent(new Event("input"));""", shot)
            browser.wait(f"return document.body.dataset.drawn == {shot}")
            time.sleep(0.2)
            left, top, width, height = box(browser, "canvas.stress")
            browser.pointer(left + 0.55 * width, top + 0.5 * height)
            time.sleep(0.1)
            X, Z, v = map(float, browser.run(
                "return document.querySelector('canvas.stress')"
                ".dataset.pointed").split())
            at = X - (-1.8 + 1.4 / 1.3 * now)
            near = abs(xi - at) < 0.06
            rows = (z > Z / 1.6) & (z < Z * 1.6)
            field = values[np.ix_(rows, near)]
            assert field.size, (X, Z)
            assert field.min() - 1e-12 <= v <= field.max() + 1e-12, \
                (name, T, X, Z, v, field.min(), field.max())
    choose(browser, "below", "0")


def temperatures(browser):
    """Three temperature curves are drawn below the film; the values in their
    texts are in the file."""
    file = h5py.File(f"{folder}/hot.h5")
    fields = [file[f"temperature_{name}"] for name in ("1", "2", "middle")]
    shot = len(file["time"]) - 1
    browser.keys(END)
    browser.wait(f"return document.body.dataset.drawn == {shot}")
    assert painted(browser, 1) > 8
    left, top, width, height = box(browser, "canvas.heat")
    for part in (0.3, 0.6, 0.9):
        browser.pointer(left + part * width, top + height / 2)
        time.sleep(0.2)
        text = browser.run(
            "return document.getElementById('values0').textContent")
        i = int(np.argmin(abs(file["x"][:] - numbers(text)["x"])))
        said = re.search("surface 1 (.*), surface 2 (.*), "
                         "middle of the film (.*) °C", text)
        for value, field in zip(said.groups(), fields):
            assert abs(float(value) + 273.15 - field[shot, i]) < 0.06, text


def plays(browser):
    browser.keys(HOME)
    browser.wait("return document.body.dataset.drawn == 0")
    browser.keys(" ")
    browser.wait("return document.body.dataset.drawn >= 2")
    browser.keys(" ")
    time.sleep(0.3)
    at = shown(browser)
    time.sleep(0.5)
    assert shown(browser) == at, "it plays on"
    browser.keys("u")
    time.sleep(0.2)
    text = browser.run("return document.getElementById('time').textContent")
    assert text.startswith("T = "), text
    browser.keys("u", "z", "l")


def ink_at_edge(browser, canvas):
    """True if anything is drawn in the last two pixel columns above the boxes,
    where legends are."""
    return browser.run("""
        const c = document.querySelectorAll("canvas")[arguments[0]];
        const g = c.getContext("2d"), d = g.getImageData(c.width - 2, 0, 2, 16).data;
        for (let i = 3; i < d.length; i += 4) if (d[i]) return true;
        return false;""", canvas)


def phone():
    """On an upright screen 390 px wide, legends are complete. On a horizontal
    one, controls are visible without scrolling."""
    browser = Browser(500, 844)
    try:
        load(browser, "frame.html")
        browser.call("POST", "/frame", {"id": 0})
        browser.wait("return document.body.dataset.drawn !== undefined")
        assert browser.run("return window.innerWidth") == 390
        for canvas in range(2):
            assert painted(browser, canvas) > 8
            assert not ink_at_edge(browser, canvas), f"canvas {canvas} is cut"
        browser.call("POST", "/frame", {"id": None})
        browser.call("POST", "/frame", {"id": 1})
        for button in ("#play", "#scrub", "#last"):
            left, top, width, height = box(browser, button)
            assert top >= 0 and top + height <= 390, (button, top, height)
    finally:
        browser.close()


def controls_in_view():
    """With temperatures or stresses below the film, controls remain visible;
    on a phone the texts above the stresses do not overlap."""
    browser = Browser(1300, 900)
    try:
        for page in ("page.html", "hot.html", "stress.html", "two.html"):
            load(browser, page)
            high = browser.run("return window.innerHeight")
            assert high <= 900
            for button in ("#play", "#scrub", "#last"):
                left, top, width, height = box(browser, button)
                assert top >= 0 and top + height <= high, (page, button, top)
        load(browser, "frame-stress.html")
        browser.call("POST", "/frame", {"id": 0})
        browser.wait("return document.body.dataset.drawn !== undefined")
        assert browser.run("return window.innerWidth") == 420
        free = browser.run("return document.querySelector('canvas.stress')"
                           ".dataset.free")
        assert float(free) >= 0, free
    finally:
        browser.close()


def narrow():
    browser = Browser(500, 900, dark=True)
    try:
        load(browser, "two.html")
        assert browser.run("return document.documentElement.scrollWidth <= "
                           "window.innerWidth"), "wider than a phone"
        for canvas in range(4):
            assert painted(browser, canvas) > 8
        assert not browser.log()
    finally:
        browser.close()


PIXELS = "return document.querySelector('canvas.element').toDataURL()"


def main():
    file = h5py.File(f"{folder}/dent.h5")
    shots = len(file["time"])
    browser = Browser()
    try:
        load(browser, "page.html")
        for canvas in range(2):
            assert painted(browser, canvas) > 8
        seeks(browser, shots)
        hover(browser, file, shown(browser))
        browser.keys(END)
        browser.wait(f"return document.body.dataset.drawn == {shots - 1}")
        hover(browser, file, shots - 1)
        plays(browser)
        assert not browser.log(), browser.log()

        load(browser, "two.html")
        browser.keys(HOME)
        browser.wait("return document.body.dataset.drawn == 0")
        browser.keys(*[RIGHT] * 9)
        browser.wait("return document.body.dataset.drawn == 9")
        hover(browser, h5py.File(f"{folder}/other.h5"), 9, 1)
        assert not browser.log()

        load(browser, "stress.html")
        stresses(browser)
        log = browser.log()
        assert not log, log

        load(browser, "coated.html")
        layered(browser)
        load(browser, "yields.html")
        yielded(browser)
        log = browser.log()
        assert not log, log

        load(browser, "hot.html")
        temperatures(browser)
        log = browser.log()
        assert not log, log

        load(browser, "gear.html")
        for canvas in range(3):
            assert painted(browser, canvas) > 8
        browser.keys(HOME)
        browser.wait("return document.body.dataset.drawn == 0")
        before = browser.run(PIXELS)
        browser.keys(END)
        browser.wait("return document.body.dataset.drawn > 0")
        assert browser.run(PIXELS) != before, "the contact stands still"
        said = browser.run(
            "return document.querySelector('.answers').textContent")
        assert "gear pair60 N.m at 2000 rpm" in said, said
        assert not browser.log()

        load(browser, "title.html")
        assert not browser.run("return document.body.dataset.stolen")
        assert browser.run("return document.images.length") == 0
        title = browser.run("return document.querySelector('h1').textContent")
        assert "</script><script>" in title, title
        assert not browser.log()

        browser.open(f"file://{folder}/broken.html")
        browser.wait("return !document.getElementById('trouble').hidden")
        trouble = browser.run(
            "return document.getElementById('trouble').textContent")
        assert trouble.startswith("This page cannot show"), trouble
    finally:
        browser.close()
    narrow()
    phone()
    controls_in_view()


main()
