"""What is said of files of BeamDyn."""

import re

import blades
import numpy as np
import pytest
from gxrod.importers import read_blade
from imported import edit, fault

BEAMDYN_FAULTS = [
    ("primary.dat", "member_total", "members", r"primary.dat: there is no line with member_total; give a whole file of BeamDyn"),
    ("primary.dat", "4   kp_total", "four   kp_total", r"primary.dat:5: expected a whole number for kp_total, found \"four\"; correct it"),
    ("primary.dat", "4   kp_total", "1   kp_total", r"primary.dat:5: 1 key points; expected three or more; give the curve's"),
    ("primary.dat", "4   kp_total", "5   kp_total", r"primary.dat:13: expected 4 numbers \(x, y, z and twist of key point 5 of 5\), found .*; correct this line, or the count that announces it"),
    ("primary.dat", "0 0.10000000000000001 10 9", "0 0 0 9", r"primary.dat:10: the same key point as the one before; remove one of them"),
    ("primary.dat", '"blade.dat"', '"other.dat"', r"primary.dat:14: the blade file other.dat is not there \(tried .*other.dat\); put it there, or name it with --blade"),
    ("blade.dat", "DISTRIBUTED PROPERTIES", "STATIONS", r"blade.dat: there is no line DISTRIBUTED PROPERTIES"),
    ("blade.dat", "mu1 ", "mu ", r"blade.dat: there is no line mu1 mu2 …"),
    ("blade.dat", "3   station_total", "4   station_total", r"blade.dat:\d+: the file ends here; expected 1 number \(the fraction of station 4 of 4\); look whether it is whole"),
    ("blade.dat", "  0.25\n", "  0.25x\n", r'blade.dat:26: expected 1 number \(the fraction of station 2 of 3\), found "0.25x"; correct this line'),
    ("blade.dat", "  0.25\n", "  0.25 7\n", r"blade.dat:26: expected 1 number \(the fraction of station 2 of 3\), found 2; correct this line"),
    ("blade.dat", "  0.25\n", "  1.5\n", r"blade.dat:41: this station, at 1, comes before the last one, at 1.5; expected them from root to tip; sort them"),
    ("blade.dat", "  0.0\n", "  0.1\n", r"blade.dat:11: the first station is at 0.1; expected 0; add one there"),
    ("blade.dat", "  1.0\n", "  0.9\n", r"blade.dat:41: the last station is at 0.9; expected 1; add one there"),
    ("blade.dat", "500000000 0 0 0 0\n", "-500000000 0 0 0 0\n", r"blade.dat:11: the stiffness has -5e\+08 on its diagonal \(edgewise shear\); expected numbers above 0; correct the matrix"),
    ("blade.dat", "500000000 0 0 0 0\n", "500000000 1e4 0 0 0\n", r"blade.dat:11: the stiffness is not symmetric: .*\((axial|edgewise shear), (axial|edgewise shear)\); correct the matrix"),
    ("blade.dat", "0 0 300 0 0 0\n", "0 0 310 0 0 0\n", r"blade.dat:11: the mass is not that of a rigid slice: 300 where 310 would be \(flapwise shear, flapwise shear\); correct the matrix"),
]


@pytest.mark.parametrize("name, old, new, message", BEAMDYN_FAULTS)
def test_faults_of_beamdyn_files(name, old, new, message, tmp_path):
    primary = blades.write_beamdyn(tmp_path)
    edit(tmp_path / name, old, new)
    assert re.search(message, fault(primary, format="beamdyn")), fault(primary, format="beamdyn")


def test_stiffness_must_take_energy(tmp_path):
    primary = blades.write_beamdyn(tmp_path)
    edit(tmp_path / "blade.dat", "300000000 0 0 0 0 0\n0 500000000 0 0 0 0\n", "300000000 4e8 0 0 0 0\n4e8 500000000 0 0 0 0\n")
    assert re.search(r"blade.dat:11: the stiffness is not positive definite: some motion would give no or negative energy; correct the matrix", fault(primary))


def test_a_blade_file_has_no_curve(tmp_path):
    blades.write_beamdyn(tmp_path)
    assert re.search("blade.dat: this is a BeamDyn blade file, which has no length and no curve; .*import the primary file", fault(tmp_path / "blade.dat"))
    assert read_blade(tmp_path / "primary.dat", blade_file=tmp_path / "blade.dat").title == "A small blade"


def test_what_is_left_out_of_beamdyn_files_is_said(tmp_path):
    primary = blades.write_beamdyn(tmp_path)
    edit(tmp_path / "blade.dat", "1   damp_type", "2   damp_type")
    edit(primary, "1   member_total", "2   member_total")
    edit(primary, "1   4 ", "1   2\n2   3 ")
    blade = read_blade(primary)
    assert blade.warnings == ["modal damping (damp_type 2) was left out: gxrod damps by strains"]
    assert any("an element for each member" in note for note in blade.notes)


def test_keys_that_no_deck_has_are_named_once(tmp_path):
    primary = blades.write_beamdyn(tmp_path)
    quiet = read_blade(primary)
    primary.write_text(primary.read_text() + "True  UsePitchAct - Whether a pitch actuator should be used\n10  order_elem - Order\n3 order_elem - again\n7  gravty - is no key\n")
    blade = read_blade(primary)
    assert [note for note in blade.notes if note not in quiet.notes] == ["not used, for BeamDyn's mesh, scheme and output: order_elem"]
    assert [each for each in blade.warnings if each not in quiet.warnings] == ["the key gravty is unknown and was not used", "the pitch actuator (UsePitchAct) was left out: the root is clamped"]


def test_damping_has_an_older_name_and_can_be_missing(tmp_path):
    primary = blades.write_beamdyn(tmp_path)
    damping = read_blade(primary).damping
    edit(tmp_path / "blade.dat", "damp_type", "damp_flag")
    assert np.array_equal(read_blade(primary).damping, damping)
    text = (tmp_path / "blade.dat").read_text()
    (tmp_path / "blade.dat").write_text("".join(line for line in text.splitlines(True) if "damp_flag" not in line))
    blade = read_blade(primary)
    assert blade.damping is None
    assert blade.warnings == ["the blade file has no damp_type: the blade is not damped, though it has mu1 … mu6"]


def test_one_station_is_too_few(tmp_path):
    assert re.search("blade.dat:11: 1 station; expected two or more", fault(blades.write_beamdyn(tmp_path, blades.SECTIONS[:1])))


def test_numbers_of_fortran_are_read(tmp_path):
    primary = blades.write_beamdyn(tmp_path)
    edit(tmp_path / "blade.dat", "  0.25\n", "  2.5D-1\n")
    assert read_blade(primary).fractions[1] == 0.25
    edit(tmp_path / "blade.dat", "  2.5D-1\n", "  nan\n")
    assert 'found "nan"' in fault(primary)
