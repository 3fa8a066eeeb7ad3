"""Blades of other programs: matrices by energies, axes by rotations, and what is said of files that are wrong."""

import json
import pathlib
import re
import subprocess
import sys
import tomllib
from dataclasses import replace
from math import pi

import blades
import gxrod
import numpy as np
import pytest
from conftest import SOURCE, read_csv
from conftest import gxrod as run_gxrod
from gxrod import FileError
from gxrod.importers import ImportFault, find_format, from_sectionproperties, read_blade, write_deck
from gxrod.importers.axes import rotation_about_z
from gxrod.importers.command import main
from gxrod.importers.curve import Curve

ALONG, FLAPWISE, EDGEWISE = 0, 1, 2


def by_energies(kind, section):
    """The matrix in gxrod's axes."""
    energy = getattr(section, kind)

    def of_gxrod(s):
        x, y, z, rx, ry, rz = s
        return energy((y, z, x, ry, rz, rx))

    return blades.polarize(of_gxrod)


def near(found, wanted, tolerance=1e-13):
    """Entry by entry, on the scale of the diagonal."""
    scale = np.sqrt(np.einsum("...i,...j->...ij", np.diagonal(wanted, axis1=-2, axis2=-1), np.diagonal(wanted, axis1=-2, axis2=-1)))
    return np.max(np.abs(found - wanted) / scale) < tolerance


def curve_of(keys=blades.KEYS):
    return Curve(np.array(keys)[:, :3])


FORMATS = ("beamdyn", "windio 1", "windio 2", "hawc2 isotropic", "hawc2 full")


def read_as(kind, folder, **changes):
    curve = curve_of()
    if "windio" in kind:
        pytest.importorskip("yaml")
        return read_blade(blades.write_windio(folder, int(kind[-1]), fractions=curve.fractions, **changes))
    if "hawc2" in kind:
        return read_blade(blades.write_hawc2(folder, curve.length, kind == "hawc2 full", **changes))
    return read_blade(blades.write_beamdyn(folder, **changes))


@pytest.mark.parametrize("kind", FORMATS)
def test_each_format_gives_the_same_blade(kind, tmp_path):
    blade = read_as(kind, tmp_path)
    assert np.array_equal(blade.fractions, [0.0, 0.25, 1.0])
    assert near(blade.stiffness, np.array([by_energies("strain_energy", each) for each in blades.SECTIONS]))
    assert near(blade.mass, np.array([by_energies("kinetic_energy", each) for each in blades.SECTIONS]))
    assert np.array_equal(blade.stiffness, blade.stiffness.transpose(0, 2, 1))
    assert np.allclose(blade.points, np.array(blades.KEYS)[:, :3], rtol=0, atol=1e-15)
    assert np.allclose(blade.twist, -np.radians(np.array(blades.KEYS)[:, 3]), rtol=1e-15)
    assert np.allclose(blade.twist_fractions, curve_of().fractions, atol=1e-15)
    assert blade.total_mass == pytest.approx((275.0 * 0.25 + 135.0 * 0.75) * curve_of().length, rel=1e-14)


def test_the_format_is_that_of_the_contents(tmp_path):
    curve = curve_of()
    assert find_format(blades.write_beamdyn(tmp_path)) == "beamdyn"
    assert find_format(blades.write_windio(tmp_path, 1, fractions=curve.fractions)) == "windio"
    htc = blades.write_hawc2(tmp_path, curve.length, full=False)
    assert find_format(htc) == find_format(htc.with_suffix(".st")) == "hawc2"
    assert find_format(blades.write_elastodyn(tmp_path, blades.SECTIONS)) == "elastodyn"


def test_damping_is_by_strain(tmp_path):
    # BeamDyn's mu 1 … 6: shear flapwise, edgewise, extension, bending about x (edgewise), about y (flapwise), torsion.
    assert np.array_equal(read_as("beamdyn", tmp_path).damping, [3e-3, 1e-3, 2e-3, 6e-3, 4e-3, 5e-3])
    undamped = read_as("beamdyn", tmp_path, mu=None)
    assert undamped.damping is None and not undamped.notes


def test_an_elastodyn_blade_has_bending_and_mass(tmp_path):
    sections = [replace(each, fraction=f) for each, f in zip(blades.SECTIONS, (0.0, 0.25, 1.0))]
    blade = read_blade(blades.write_elastodyn(tmp_path, sections, twist=10.0, factors=(1.5, 2.0, 3.0), tuner=0.9), length=60.0)
    assert np.allclose(blade.stiffness[:, 5, 5], [2.0 * each.EI[1] for each in sections])  # about z: flapwise
    assert np.allclose(blade.stiffness[:, 4, 4], [3.0 * each.EI[0] for each in sections])
    assert np.allclose(blade.mass[:, 0, 0], [1.5 * each.m for each in sections])
    assert np.allclose(blade.twist, -np.radians(10.0))
    assert np.array_equal(blade.points, [[0, 0, 0], [0, 0, 60]])
    assert any("ElastoDyn has bending and mass only" in note for note in blade.notes)
    assert any("FlStTunr" in note for note in blade.notes)


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


# The curve and its axes


def test_a_curve_is_the_spline_of_gxrod():
    circle = np.array([[np.sin(a), 0.0, 1.0 - np.cos(a)] for a in np.linspace(0.0, 1.2, 25)])
    assert Curve(circle).length == pytest.approx(1.2, rel=1e-5)
    bent = curve_of()
    assert not bent.is_straight
    tangent = (np.diff([bent._derivative(np.array([t]))[0] for t in (20.0, 20.0 + 1e-6)], axis=0) / 1e-6)[0]
    assert np.all(np.isfinite(tangent))
    straight = Curve(np.array([[0.0, 0, 0], [1, 0, 1], [3, 0, 3]]))
    assert straight.is_straight
    assert np.allclose(straight.fractions, [0, 1 / 3, 1])


def test_what_is_carried_along_a_curve_does_not_turn_about_it():
    """Against the equation of a Bishop frame, y' = −(y · t') t, in small steps."""
    curve = curve_of()
    at = np.linspace(0.0, 1.0, 20001)
    tangents = curve.tangents(at)
    y = np.array([1.0, 0.0, 0.0]) - tangents[0, 0] * tangents[0]
    start = y = y / np.linalg.norm(y)
    for before, after in zip(tangents, tangents[1:]):
        y = y - (y @ (after - before)) * (before + after) / 2.0
    assert np.allclose(curve.carry(start, np.array([0.0, 1.0]))[1], y, atol=1e-6)


def beamdyn_axes(tangent, twist_degrees):
    """x, y, z of a section of BeamDyn as columns: x across the tangent in the root's x-z plane, then turned by −twist about the tangent."""
    x = np.array([tangent[2], 0.0, -tangent[0]]) / np.hypot(tangent[0], tangent[2])
    axes = np.column_stack((x, np.cross(tangent, x), tangent))
    return axes @ rotation_about_z(-np.radians(twist_degrees))


@pytest.mark.parametrize("kind", ["beamdyn", "hawc2 full"])
def test_gxrod_lays_the_sections_as_the_format_says(kind, tmp_path):
    blade = read_as(kind, tmp_path)
    write_deck(blade, tmp_path / "laid.toml", inline=True)
    text = (tmp_path / "laid.toml").read_text()
    place = blade.twist_fractions[2]
    text = text.replace('at   = "blade.end"\nquantities = ["displacement", "rotation_vector"]', f'at   = "blade@{place:.12g}"\nquantities = ["position", "orientation"]')
    node = f'\n[[load]]\nat = "blade@{place:.12g}"\nforce = [0, 0, 0]\n'  # histories alone place none
    (tmp_path / "laid.toml").write_text(text.replace("[9.81, 0, 0]", "[1e-9, 0, 0]") + node)
    run_gxrod("run", "laid.toml", "--quiet", folder=tmp_path)
    run_gxrod("export", "laid.vtkhdf", "--csv", "tables", folder=tmp_path)
    table = read_csv(next((tmp_path / "tables").glob("*tip*")))
    first = {name: float(values[0]) for name, values in table.items()}
    position = [first[f"position_{axis}"] for axis in "xyz"]
    w, x, y, z = (first[f"orientation_{axis}"] for axis in "wxyz")
    axes = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
    assert np.allclose(position, blades.KEYS[2][:3], atol=1e-6)
    wanted = beamdyn_axes(axes[:, ALONG], blades.KEYS[2][3])
    assert np.allclose(axes[:, FLAPWISE], wanted[:, 0], atol=1e-6)
    assert np.allclose(axes[:, EDGEWISE], wanted[:, 1], atol=1e-6)


# Decks

UNIFORM = [blades.Section(f, GA=(1e12, 1e12), J=(1e-2, 1e-2)) for f in (0.0, 1.0)]
STRAIGHT = ((0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 20.0, 0.0), (0.0, 0.0, 60.0, 0.0))


def tones(path, code=0):
    """Frequencies in cycles per time, with what moves."""
    printed = run_gxrod("run", path, "--force", folder=path.parent, code=code)
    return [(float(row[1]), row[2]) for row in re.findall(r"^ +(\d+) +(\S+) +ω \S+ +(.*)$", printed, re.M)]


@pytest.mark.parametrize("kind", ["beamdyn", "hawc2 isotropic", "hawc2 full", "windio 1", "elastodyn"])
def test_a_deck_runs_at_once(kind, tmp_path):
    """A uniform cantilever: f = 1.8751² √(EI/m)/(2π L²)."""
    if kind == "elastodyn":
        blade = read_blade(blades.write_elastodyn(tmp_path, UNIFORM), length=60.0)
    elif kind == "beamdyn":
        blade = read_as(kind, tmp_path, sections=UNIFORM, keys=STRAIGHT)
    elif kind == "windio 1":
        pytest.importorskip("yaml")
        blade = read_blade(blades.write_windio(tmp_path, 1, UNIFORM, STRAIGHT, Curve(np.array(STRAIGHT)[:, :3]).fractions))
    else:
        blade = read_blade(blades.write_hawc2(tmp_path, 60.0, kind == "hawc2 full", UNIFORM, STRAIGHT))
    assert blade.length == pytest.approx(60.0, rel=1e-14)
    assert blade.total_mass == pytest.approx(300.0 * 60.0, rel=1e-12)
    assert write_deck(blade, tmp_path / "uniform.toml", inline=True) == [tmp_path / "uniform.toml"]
    (flapwise, first), (edgewise, second), *_ = tones(tmp_path / "uniform.toml")
    wanted = lambda EI: 1.875104068711961**2 * np.sqrt(EI / 300.0) / (2.0 * pi * 60.0**2)
    assert flapwise == pytest.approx(wanted(1e9), rel=2e-5)
    assert edgewise == pytest.approx(wanted(4e9), rel=2e-5)
    assert (first, second) == ("bending about z of blade", "bending about y of blade")


def test_a_twisted_beam_bends_as_in_beamdyn(tmp_path):
    """bd_static_twisted_with_k1 of OpenFAST's regression tests, by BeamDyn with elements refined; its term of extension by twist moves the tip by 7e-5 m."""
    made = [blades.Section(f, EA=2.5e10, GA=(8.2604167e9, 8.2604167e9), EI=(0.520833e9, 0.130208333e9), GJ=0.141872656e9) for f in (0.0, 1.0)]
    blade = read_as("beamdyn", tmp_path, sections=made, keys=[(0.0, 0.0, z, 9.0 * z) for z in range(11)])
    write_deck(blade, tmp_path / "twisted.toml", inline=True)
    text = (tmp_path / "twisted.toml").read_text().replace("[9.81, 0, 0]", "[0, 0, 0]").replace("steps = 4", "steps = 10")
    (tmp_path / "twisted.toml").write_text(text + '\n[[load]]\nat = "blade.end"\nforce = [0, -4e6, 0]\n')
    run_gxrod("run", "twisted.toml", "--quiet", folder=tmp_path)
    run_gxrod("export", "twisted.vtkhdf", "--csv", "tables", folder=tmp_path)
    table = read_csv(next((tmp_path / "tables").glob("*tip*")))
    assert np.allclose([float(table[f"displacement_{axis}"][-1]) for axis in "xyz"], [1.71806255, -3.59320805, -1.14159696], rtol=0, atol=1e-4)


def test_sections_stand_in_a_file_beside_the_deck(tmp_path):
    blade = read_as("beamdyn", tmp_path)
    assert write_deck(blade, tmp_path / "small.toml", rod="wing") == [tmp_path / "small.csv", tmp_path / "small.toml"]
    deck = (tmp_path / "small.toml").read_text()
    assert 'sections = { file = "small.csv", damping = { kelvin_voigt = [' in deck
    assert 'at  = "wing.start"' in deck and "[rod.wing]" in deck
    assert len(deck.splitlines()) < 60
    header, *rows = (tmp_path / "small.csv").read_text().splitlines()
    names = header.split(",")
    assert names[:4] == ["fraction", "twist", "K11", "K12"] and len(names) == 44 and names[22:24] == ["K66", "M11"]
    table = np.array([[float(each) for each in row.split(",")] for row in rows])
    # The stations, and where the twist is given between them.
    inner = curve_of().fractions[1:3]
    assert np.allclose(table[:, 0], sorted([0.0, 0.25, 1.0, *inner]), atol=1e-14)
    for fraction, twist, *entries in table:
        assert twist == pytest.approx(np.interp(fraction, blade.twist_fractions, blade.rod_twist()), abs=1e-13)
        wanted = [np.array([np.interp(fraction, blade.fractions, each) for each in matrices.reshape(3, 36).T]).reshape(6, 6)[np.triu_indices(6)] for matrices in (blade.stiffness, blade.mass)]
        assert np.allclose(entries, np.concatenate(wanted), rtol=1e-13, atol=1e-12 * np.max(wanted[0]))


def find_all(node, key):
    """The values of a key, however deep."""
    inner = node.values() if isinstance(node, dict) else node if isinstance(node, list) else ()
    return [each for value in inner for each in find_all(value, key)] + ([node[key]] if isinstance(node, dict) and key in node else [])


def test_a_file_gives_what_the_long_form_gives(tmp_path):
    if not any('"file"' in json.dumps(each) for each in find_all(json.loads(run_gxrod("schema", folder=tmp_path)), "sections")):
        pytest.skip("this gxrod reads no files of sections")
    blade = read_as("beamdyn", tmp_path)
    write_deck(blade, tmp_path / "short.toml")
    write_deck(blade, tmp_path / "long.toml", inline=True)
    short, long = tones(tmp_path / "short.toml"), tones(tmp_path / "long.toml")
    assert np.allclose([f for f, _ in short], [f for f, _ in long], rtol=1e-6)


def test_without_mass_a_deck_is_static(tmp_path):
    massless = [replace(each, m=0.0, J=(0.0, 0.0)) for each in UNIFORM]
    blade = read_as("beamdyn", tmp_path, sections=massless, keys=STRAIGHT)
    write_deck(blade, tmp_path / "still.toml", inline=True)
    run_gxrod("run", "still.toml", "--quiet", folder=tmp_path)
    run_gxrod("export", "still.vtkhdf", "--csv", "tables", folder=tmp_path)
    table = read_csv(next((tmp_path / "tables").glob("*tip*")))
    tip = [float(table[name][-1]) for name in table if name.startswith("displacement")]
    assert tip[0] == pytest.approx(60.0**3 / (3.0 * 1e9) + 60.0 / 1e12, rel=1e-6)  # 1 N along x
    write_deck(blade, tmp_path / "still.toml")
    assert (tmp_path / "still.csv").read_text().splitlines()[0].endswith("K66")


# Faults


def edit(path, old, new, count=1):
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, count))
    return path


def fault(path, **options):
    with pytest.raises(FileError) as caught:
        read_blade(path, **options)
    return str(caught.value)


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
    notes = " ".join(read_blade(primary).notes)
    assert "modal damping" in notes and "an element for each member" in notes


def test_one_station_is_too_few(tmp_path):
    assert re.search("blade.dat:11: 1 station; expected two or more", fault(blades.write_beamdyn(tmp_path, blades.SECTIONS[:1])))


def test_numbers_of_fortran_are_read(tmp_path):
    primary = blades.write_beamdyn(tmp_path)
    edit(tmp_path / "blade.dat", "  0.25\n", "  2.5D-1\n")
    assert read_blade(primary).fractions[1] == 0.25
    edit(tmp_path / "blade.dat", "  2.5D-1\n", "  nan\n")
    assert 'found "nan"' in fault(primary)


WINDIO_FAULTS = [
    (1, "six_x_six:", "six_by_six:", r"blade.yaml:4: components/blade/elastic_properties_mb: expected a key six_x_six, found six_by_six; give a windIO file of a blade with its 6×6 matrices"),
    (1, "grid: [0.0, 0.25, 1.0]", "grid: [0.0, 0.25, one]", r"blade.yaml:9: .*stiff_matrix/grid: expected numbers; correct it"),
    (1, "grid: [0.0, 0.25, 1.0]", "grid: [0.0, 1.0]", r"blade.yaml:10: .*stiff_matrix/values: expected 2 × 21 finite numbers, found an array of 3 × 21; correct it"),
    (1, "grid: [0.0, 0.25, 1.0]", "grid: [0.0, 0.25, .inf]", r"stiff_matrix/grid: expected n finite numbers"),
    (1, "name: A small blade", "name: [A small blade", r"blade.yaml:\d: this is no YAML: .*; correct the text"),
    (2, "mass: [300.0", "mass: [-300.0", r"blade.yaml:4: components/blade: station 1: the mass has -300 on its diagonal \(axial\); expected numbers above 0; correct the matrix"),
    (2, "stiffness_matrix:", "stiffness:", r"expected a key stiffness_matrix, found structural_damping, stiffness, inertia_matrix"),
]


@pytest.mark.parametrize("version, old, new, message", WINDIO_FAULTS)
def test_faults_of_windio_files(version, old, new, message, tmp_path):
    pytest.importorskip("yaml")
    path = edit(blades.write_windio(tmp_path, version, fractions=curve_of().fractions), old, new)
    assert re.search(message, fault(path)), fault(path)


def test_windio_needs_yaml(tmp_path, absent):
    path = blades.write_windio(tmp_path, 1, fractions=curve_of().fractions)
    absent("yaml")
    assert re.search("blade.yaml: windIO files need the Python module yaml, .*apt install python3-yaml", fault(path))


def test_windio_matrices_may_have_grids_of_their_own(tmp_path):
    pytest.importorskip("yaml")
    path = blades.write_windio(tmp_path, 2, fractions=curve_of().fractions)
    text = path.read_text()
    stations = text.rindex("grid: [0.0, 0.25, 1.0]")
    path.write_text(text[:stations] + text[stations:].replace("0.25", "0.5", 1))
    blade = read_blade(path)
    assert np.array_equal(blade.fractions, [0.0, 0.25, 0.5, 1.0])
    assert np.allclose(blade.mass[:, 0, 0], [300.0, 275.0, 250.0, 20.0])


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


ELASTODYN_FAULTS = [
    ("NBlInpSt", "Count", {"length": 60.0}, r"elastodyn.dat: there is no line with NBlInpSt; give a whole blade file of ElastoDyn"),
    ("EdgStff\n", "Edge\n", {"length": 60.0}, r"elastodyn.dat:10: there is no column EdgStff among BlFract, PitchAxis, .*; give a blade file of ElastoDyn"),
    ("1.0   AdjBlMs", "one   AdjBlMs", {"length": 60.0}, r'elastodyn.dat:6: expected a number for AdjBlMs, found "one"'),
    ("A small", "A small", {}, r"elastodyn.dat: an ElastoDyn blade file does not say how long the blade is; give --length, the TipRad − HubRad of ElastoDyn's primary file"),
    ("\n1 0.25 0 20", "\n1 0.25 0 -20", {"length": 60.0}, r"elastodyn.dat:14: the mass has -20 on its diagonal"),
]


@pytest.mark.parametrize("old, new, options, message", ELASTODYN_FAULTS)
def test_faults_of_elastodyn_files(old, new, options, message, tmp_path):
    path = edit(blades.write_elastodyn(tmp_path, blades.SECTIONS), old, new)
    assert re.search(message, fault(path, **options)), fault(path, **options)


def test_other_files_are_refused(tmp_path):
    path = tmp_path / "notes.txt"
    path.write_text("Nothing of a blade.\n")
    assert re.search("notes.txt: neither a BeamDyn primary file, a windIO yaml, .*--format beamdyn | windio", fault(path))
    assert re.search('there is no format "vabs"; give one of beamdyn, windio, hawc2, elastodyn', fault(path, format="vabs"))
    assert re.search("absent.dat: cannot be read: No such file or directory", fault(tmp_path / "absent.dat"))


# The program


def test_the_program_says_what_it_read_and_wrote(tmp_path, capsys):
    path = blades.write_beamdyn(tmp_path)
    assert main([str(path), "-o", str(tmp_path / "out.toml")]) == 0
    first, *rest = capsys.readouterr().out.splitlines()
    assert re.fullmatch(r"3 stations, 40.\d+ m, \d+(\.\d+)? kg \(BeamDyn: primary.dat, blade.dat\)", first)
    assert rest == [str(tmp_path / "out.csv"), str(tmp_path / "out.toml")]


def test_the_program_ends_with_gxrods_codes(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    elastodyn = blades.write_elastodyn(tmp_path, blades.SECTIONS)
    assert main([str(elastodyn)]) == 2
    assert "gxrod-import: " in capsys.readouterr().err
    assert main([str(tmp_path / "absent.dat")]) == 4
    assert main([str(elastodyn), "--length", "60", "-o", "nowhere/blade.toml"]) == 4
    assert "nowhere/blade.csv: cannot be written: No such file or directory" in capsys.readouterr().err
    assert main([str(elastodyn), "--length", "60"]) == 0
    assert (tmp_path / "elastodyn.toml").exists() and "note: ElastoDyn has bending" in capsys.readouterr().out
    with pytest.raises(SystemExit) as ended:
        main([str(elastodyn), "--length", "-1"])
    assert ended.value.code == 2


def test_titles_are_texts_of_toml(tmp_path):
    path = edit(blades.write_beamdyn(tmp_path), "A small blade", 'A "small"\tblade\\')
    write_deck(read_blade(path), tmp_path / "deck.toml")
    assert tomllib.loads((tmp_path / "deck.toml").read_text())["title"] == 'A "small"blade\\'


# Sections of sectionproperties


def mesh(make, size, **numbers):
    pytest.importorskip("sectionproperties")
    from sectionproperties.analysis import Section
    from sectionproperties.pre import Material

    material = Material("steel", elastic_modulus=2e11, poissons_ratio=numbers.pop("nu"), yield_strength=1.0, density=7850.0, color="grey")
    return Section(make(material=material, **numbers).create_mesh(mesh_sizes=[size]))


def test_a_rectangle():
    pytest.importorskip("sectionproperties")
    from sectionproperties.pre.library import rectangular_section

    section = mesh(rectangular_section, 2e-5, nu=0.0, b=0.1, d=0.2)
    stiffness, mass = from_sectionproperties(section)
    E, G, A = 2e11, 1e11, 0.02
    odd = np.arange(1, 60, 2)
    J = 0.2 * 0.1**3 / 3 * (1 - 192 / pi**5 * 0.1 / 0.2 * np.sum(np.tanh(odd * pi * 0.2 / 0.2) / odd**5))  # Saint-Venant's series, sides 0.2 and 0.1
    wanted = np.diag([E * A, 5 / 6 * G * A, 5 / 6 * G * A, G * J, E * 0.1 * 0.2**3 / 12, E * 0.2 * 0.1**3 / 12])
    assert near(stiffness, wanted, 2e-5)
    assert near(mass, 7850 * np.diag([A, A, A, (0.1 * 0.2**3 + 0.2 * 0.1**3) / 12, 0.1 * 0.2**3 / 12, 0.2 * 0.1**3 / 12]), 1e-12)
    # About a corner: the rod's y is x, its z is y.
    moved, moved_mass = from_sectionproperties(section, at=(0.0, 0.0))
    assert moved[0, 4] == pytest.approx(E * A * 0.1) and moved[0, 5] == pytest.approx(-E * A * 0.05)
    assert moved[4, 4] == pytest.approx(E * 0.1 * 0.2**3 / 3) and moved[4, 5] == pytest.approx(-E * 0.1**2 / 2 * 0.2**2 / 2)
    assert moved_mass[4, 4] == pytest.approx(7850 * 0.1 * 0.2**3 / 3) and moved_mass[0, 5] == pytest.approx(-7850 * A * 0.05)


def test_a_section_that_is_turned():
    """Its matrices are those of the other, turned: products of inertia and the coupling of the shear stiffnesses have the right sign."""
    pytest.importorskip("sectionproperties")
    from sectionproperties.pre.library import rectangular_section

    numbers = {"nu": 0.3, "b": 0.2, "d": 0.05}
    lying = from_sectionproperties(mesh(rectangular_section, 2e-5, **numbers))
    turned = from_sectionproperties(mesh(lambda **all: rectangular_section(**all).rotate_section(angle=30.0), 2e-5, **numbers))
    c, s = np.cos(pi / 6), np.sin(pi / 6)
    both = np.kron(np.eye(2), [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
    for found, other in zip(turned, lying):
        assert near(found, both @ other @ both.T, 2e-5)
    assert abs(turned[0][1, 2]) > 1e-2 * turned[0][1, 1] and abs(turned[0][4, 5]) > 0.1 * turned[0][4, 4]


def test_a_channel():
    """Thin-walled formulas, to the thickness over the width."""
    pytest.importorskip("sectionproperties")
    from sectionproperties.pre.library import channel_section

    t, h, b = 0.002, 0.198, 0.099  # of the middle lines
    stiffness, mass = from_sectionproperties(mesh(channel_section, 1e-6, nu=0.3, d=h + t, b=b + t / 2, t_f=t, t_w=t, r=0.0, n_r=1), at=(t / 2, h / 2 + t / 2))
    E, G, A = 2e11, 2e11 / 2.6, t * (h + 2 * b)
    about_web, about_axis = 2 * t * b**3 / 3, t * h**3 / 12 + t * b * h**2 / 2
    centroid, shear_centre = t * b**2 / A, -(b**2) * h**2 * t / (4 * about_axis)
    assert stiffness[0, 0] == pytest.approx(E * A, rel=1e-3)
    assert stiffness[4, 4] == pytest.approx(E * about_axis, rel=1e-3)
    assert stiffness[5, 5] == pytest.approx(E * about_web, rel=2e-3)
    assert stiffness[0, 5] / stiffness[0, 0] == pytest.approx(-centroid, rel=2e-3)
    # A force along z through the shear centre does not twist: it has the moment −y times as much about the web.
    assert stiffness[3, 2] / stiffness[2, 2] == pytest.approx(shear_centre, rel=2e-3)
    torsion = 1.0 / np.linalg.inv(stiffness)[3, 3]
    assert torsion == pytest.approx(G * t**3 / 3 * (h + 2 * b), rel=2e-3)
    assert mass[0, 0] == pytest.approx(7850 * A, rel=1e-3)


def test_the_page_runs():
    pytest.importorskip("sectionproperties")
    [block] = re.findall(r"^```python\n(.*?)^```", (SOURCE / "docs" / "guide" / "import.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    names = {}
    exec(compile(block, "import.md", "exec"), names)
    channel = names["deck"]["section"]["channel"]
    assert np.array(channel["stiffness_matrix"]).shape == np.array(channel["mass_matrix"]).shape == (6, 6)


def test_a_section_needs_materials():
    pytest.importorskip("sectionproperties")
    from sectionproperties.analysis import Section
    from sectionproperties.pre.library import rectangular_section

    with pytest.raises(ValueError, match="the section has no materials; give them to its geometry"):
        from_sectionproperties(Section(rectangular_section(b=1.0, d=1.0).create_mesh(mesh_sizes=[0.1])))


def test_importing_it_loads_neither_yaml_nor_sectionproperties():
    code = f"import sys; sys.path.insert(0, {str(pathlib.Path(gxrod.__file__).parents[1])!r}); import gxrod.importers; print(sorted({{'yaml', 'sectionproperties', 'h5py'}} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-B", "-c", code], text=True, capture_output=True, check=True).stdout == "[]\n"


def test_faults_are_errors_of_gxrod():
    assert issubclass(ImportFault, FileError)
