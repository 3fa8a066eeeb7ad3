"""Files of HAWC2."""

import re

import blades
import numpy as np
import pytest
from gxrod.importers import read_blade
from imported import curve_of, edit, fault


def test_an_st_file_alone_is_straight(tmp_path):
    st = blades.write_hawc2(tmp_path, 50.0, full=False).with_suffix(".st")
    blade = read_blade(st)
    assert np.array_equal(blade.points, [[0, 0, 0], [0, 0, 50]])
    assert not np.any(blade.twist)
    assert any("import the htc file" in note for note in blade.notes)


@pytest.mark.parametrize("share, fractions", [(0.8, [0.0, 0.2, 0.8, 1.0]), (1.25, [0.0, 0.3125, 1.0]), (1.004, [0.0, 0.25, 1.0])])
def test_an_st_file_of_another_length_is_held_or_cut(share, fractions, tmp_path):
    blade = read_blade(blades.write_hawc2(tmp_path, share * curve_of().length, full=True))
    assert np.allclose(blade.fractions, fractions, atol=1e-14)
    first, second, last = (each.m for each in blades.SECTIONS)
    cut = second + (1.0 - 0.3125) / (1.25 - 0.3125) * (last - second)
    assert np.allclose(blade.mass[:, 0, 0], {0.8: [first, second, last, last], 1.25: [first, second, cut], 1.004: [first, second, last]}[share])
    assert any("st file ends at" in note for note in blade.notes) == (share != 1.004)


def test_masses_at_nodes_and_unknown_commands_are_warned_of(tmp_path):
    htc = edit(blades.write_hawc2(tmp_path, curve_of().length, full=True), "    name blade1 ;", "    name blade1 ;\n    nbodies 10 ;\n    concentrated_mass 3 0 0 0 500 1 1 1 ; a tip mass\n    gravty 1 ;")
    blade = read_blade(htc)
    assert blade.warnings == ["HAWC2's damping by mass and stiffness was left out (damping_posdef 0 0 0 1e-3 1e-3 1e-3)",
                              "the concentrated mass 3 0 0 0 500 1 1 1 was left out; add a [body.NAME] there", "the command gravty is unknown and was not used"]
    assert "not used, for HAWC2's mesh and output: nbodies, nsec" in blade.notes


HAWC2_FAULTS = [
    ("blade.htc", "./data/blade.st", "./data/other.st", r"blade.htc:\d+: the st file ./data/other.st is not there \(tried .*\); put it there, or name it with --st"),
    ("blade.htc", "name blade1", "name rotor", r"blade.htc: which body is meant: shaft, rotor; name it with --body"),
    ("blade.htc", "      filename ./data/blade.st ;\n", "", r"blade.htc:\d+: the body blade1 names no st file; add timoschenko_input with filename"),
    ("blade.htc", "-1 -2 40 1 ;", "-1 -2 40 ;", r"blade.htc:\d+: expected 4 numbers \(x, y, z and twist\), found .*; correct this line"),
    ("blade.htc", "set 1 1", "set 2 1", r"blade.st: there is no set #2; name another with --set NUMBER SUBSET"),
    ("blade.htc", "set 1 1", "set 1 3", r"blade.st:\d+: the file ends here; expected the subset \$3 of set #1"),
    ("blade.st", "$1 3", "$1 4", r"blade.st:8: the file ends here; expected 19 numbers \(row 4 of 4 of subset \$1\)"),
    ("blade.st", "$1 3", "$1", r'blade.st:5: expected the number of rows after \$, found ""'),
    ("blade.st", "0 300 ", "0 300 7 ", r"blade.st:6: expected 19 columns \(isotropic sections\) or 30 \(full matrices, FPM\), found 20; correct the table"),
    ("blade.st", "0 300 ", "0 -300 ", r"blade.st:6: the mass has"),
]


@pytest.mark.parametrize("name, old, new, message", HAWC2_FAULTS)
def test_faults_of_hawc2_files(name, old, new, message, tmp_path):
    htc = blades.write_hawc2(tmp_path, curve_of().length, full=False)
    edit(tmp_path / name, old, new)
    assert re.search(message, fault(htc)), fault(htc)


def test_bodies_and_sets_are_chosen(tmp_path):
    htc = blades.write_hawc2(tmp_path, curve_of().length, full=False)
    assert re.search('there is no body "blade9" with a c2_def; there are shaft, blade1', fault(htc, body="blade9"))
    assert re.search("the body shaft names no st file", fault(htc, body="shaft"))
    edit(tmp_path / "blade.st", "#1 ; the blade", "#1 ; others\n$1 1\n0 1\n#2 ; the blade")
    assert re.search(r"set #1 has no subset \$2", fault(htc, chosen=(1, 2)))
    assert read_blade(htc, chosen=(2, 1)).mass[0, 0, 0] == 300.0
    assert read_blade(htc, chosen=(2, 1), st_file=tmp_path / "blade.st").title == "blade1"
    text = htc.read_text()
    head, body = text[: text.index("name blade1")], text[text.index("name blade1"):]
    htc.write_text(head + re.sub(r" sec [234]", " off", body))
    assert re.search("the c2_def of blade1 has 1 lines sec; expected two or more", fault(htc))
