# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases, their keys, and the messages for wrong input."""
import copy
import pickle

import numpy as np
import pytest

import overroll as ovr


def test_names_mean_keys():
    c = ovr.Case(M=20, L=10, level=7, output_every=3, alpha="20 1/GPa",
                 feature_dent_start=-5, body_1_poisson=0.25,
                 **{"time.end": 6, "feature dent.depth": 0.1})
    assert c.given() == {
        "contact.M": "20", "contact.L": "10", "domain.level": "7",
        "output.every": "3", "contact.alpha": "20 1/GPa", "time.end": "6",
        "feature dent.start": "-5", "feature dent.depth": "0.1",
        "body 1.poisson": "0.25"}
    assert c["domain_level"] == c["level"] == "7"
    assert c["feature_dent_depth"] == c["feature dent.depth"] == "0.1"
    assert c["outlet"] == "usual"  # a default
    assert "end" in c and "feature.dent.depth" in c and "radius" not in c
    assert set(c) == set(c.given())
    with pytest.raises(KeyError):
        c["radius"]


def test_every_parameter_has_a_name():
    """The Python name of every parameter is mapped back to its key."""
    from overroll._tables import place
    for p in ovr.parameters():
        assert p.help and str(p).startswith(f"{p.section}.{p.key}: ")
        if p.named:
            assert place(f"{p.section}_x_y_{p.key}") == \
                f"{p.section} x_y.{p.key}"
        else:
            assert place(f"{p.section}_{p.key}") == f"{p.section}.{p.key}"


def test_values_come_back_the_same():
    number = 0.1 + 0.2
    c = ovr.Case(M=number, L=np.float64(10), until_steady=True,
                 output_at=[1, 2.5], level=np.int32(6))
    assert float(c["M"]) == number
    assert c["until_steady"] == "yes"
    assert c["output_at"] == "1, 2.5"
    assert c["level"] == "6"
    c["M"] = None
    with pytest.raises(KeyError):
        c["M"]


@pytest.mark.parametrize("again", [
    ovr.Case.copy, copy.deepcopy, lambda c: pickle.loads(pickle.dumps(c)),
    lambda c: ovr.Case.from_text(c.text)])
def test_copies_say_the_same(dent, again):
    other = again(dent)
    assert other.given() == dent.given()
    other["M"] = 30
    assert dent["M"] == "20"


def test_a_file_and_what_is_saved(dent):
    dent.save("dent.ini")
    c = ovr.Case("dent.ini", level=6)
    assert c.name == "dent.ini" and c["level"] == "6"
    assert c.given() == {**dent.given(), "domain.level": "6"}


def test_errors_name_file_line_key_and_what_was_meant():
    with open("wrong.ini", "w") as file:
        file.write("# a case\n[lubricant]\nviscocity = 1 Pa.s\n")
    with pytest.raises(ovr.BadInput) as caught:
        ovr.Case("wrong.ini")
    e = caught.value
    assert (e.file, e.line, e.key) == ("wrong.ini", 3, "viscocity")
    assert e.suggestion == "viscosity" and e.status == "bad input"
    assert str(e).startswith("wrong.ini:3: unknown key 'viscocity'")
    assert isinstance(e, ValueError)


@pytest.mark.parametrize("keys, key, suggestion", [
    ({"viscocity": "1 Pa.s"}, "viscocity", "viscosity"),
    ({"load": "300 kNm"}, "load", "kN/m"),
    ({"viscosity_law": "roeland"}, "viscosity_law", "roelands"),
    ({"contcat.M": 2}, None, "contact"),
    ({"contact.laod": 2}, "laod", "load"),
    ({"feature_dent_detph": 2}, "feature_dent_detph", "feature_dent_depth"),
    ({"level": 99}, "level", None),
    ({"M": float("nan")}, "M", None),
    ({"file": "x"}, "file", None),
    ({"M": "1 # comment"}, "M", None)])
def test_wrong_settings(keys, key, suggestion):
    with pytest.raises(ovr.BadInput) as caught:
        ovr.Case(**keys)
    e = caught.value
    assert (e.key, e.suggestion) == (key, suggestion), str(e)
    assert e.file is None and e.line is None


def test_what_contradicts_is_said_where_it_stands():
    with open("a.ini", "w") as file:
        file.write("[contact]\nM = 20\n\nload = 3 kN/m\n")
    with pytest.raises(ovr.BadInput) as caught:
        ovr.Case("a.ini", L=10).check()
    assert caught.value.file == "a.ini" and caught.value.line
    c = ovr.Case("a.ini", load=None, time_end=3)
    with pytest.raises(ovr.BadInput):
        ovr.run(c)
    with pytest.raises(ovr.BadInput, match="no_such.ini"):
        ovr.Case("no_such.ini")
    with pytest.raises(ovr.BadInput):
        ovr.steady()


def test_help(capsys):
    ovr.help("radius")
    assert "contact.radius: " in capsys.readouterr().out
    ovr.help("thickness")
    ovr.help()
    assert len(capsys.readouterr().out.splitlines()) > 100
    with pytest.raises(ovr.BadInput) as caught:
        ovr.help("raduis")
    assert caught.value.suggestion == "radius"
