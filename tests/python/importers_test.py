"""Blades of other programs: matrices by energies, axes by rotations, and decks of them; the program."""

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
from conftest import read_csv
from conftest import gxrod as run_gxrod
from gxrod import FileError
from gxrod.importers import ImportFault, find_format, read_blade, write_deck
from gxrod.importers.axes import rotation_about_z
from gxrod.importers.command import main
from gxrod.importers.curve import Curve
from imported import FORMATS, by_energies, curve_of, edit, fault, near, read_as

ALONG, FLAPWISE, EDGEWISE = 0, 1, 2


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
    assert (first, second) == ("1st bending about z of blade", "1st bending about y of blade")


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


def test_other_files_are_refused(tmp_path):
    path = tmp_path / "notes.txt"
    path.write_text("Nothing of a blade.\n")
    assert re.search("notes.txt: neither a BeamDyn primary file, a windIO yaml, .*--format beamdyn | windio", fault(path))
    assert re.search('there is no format "nastran"; give one of beamdyn, windio, hawc2, elastodyn', fault(path, format="nastran"))
    assert re.search("has a section, not a blade; read it with read_section_mesh", fault(path, format="vabs"))
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
    assert (tmp_path / "elastodyn.toml").exists() and "note: ElastoDyn has bending" in capsys.readouterr().err
    with pytest.raises(SystemExit) as ended:
        main([str(elastodyn), "--length", "-1"])
    assert ended.value.code == 2


def test_titles_are_texts_of_toml(tmp_path):
    path = edit(blades.write_beamdyn(tmp_path), "A small blade", 'A "small"\tblade\\')
    write_deck(read_blade(path), tmp_path / "deck.toml")
    assert tomllib.loads((tmp_path / "deck.toml").read_text())["title"] == 'A "small"blade\\'


def test_importing_it_loads_neither_yaml_nor_sectionproperties():
    code = f"import sys; sys.path.insert(0, {str(pathlib.Path(gxrod.__file__).parents[1])!r}); import gxrod.importers; print(sorted({{'yaml', 'sectionproperties', 'h5py'}} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-B", "-c", code], text=True, capture_output=True, check=True).stdout == "[]\n"


def test_faults_are_errors_of_gxrod():
    assert issubclass(ImportFault, FileError)
