"""Lines of MoorPy's library as sections."""

import re
import tomllib
from math import pi

import pytest
from gxrod import FileError
from gxrod.importers import find_format, read_moorprops, write_section
from gxrod.importers.command import main
from imported import edit

LIBRARY = """lineProps:
  chain:
    mass_d2: 20.0e+3
    EA_d3: -4.0e+7
    EA_d2: 85.0e+9
    MBL_d2: 1.0e+9
    dvol_dnom: 1.8
    Cd: 1.3
    Cd_ax: 0.6
    Ca: 1.0
    Ca_ax: 0.5
  rope:
    mass_d2: 700
    MBL_0: 1.0e+4
    MBL_d2: 3.0e+8
    EA_MBL: 14
    density: 1400
    Cd: 2.0
"""


@pytest.fixture
def library(tmp_path):
    pytest.importorskip("yaml")
    path = tmp_path / "props.yaml"
    path.write_text(LIBRARY)
    return path


def test_a_line_is_of_its_nominal_diameter(library):
    chain = read_moorprops(library, "chain", 0.1)
    assert chain.mass == pytest.approx(200.0, rel=1e-14)
    assert chain.EA == pytest.approx(85e7 - 4e4, rel=1e-14)
    assert chain.diameter == pytest.approx(0.18, rel=1e-14)
    assert (chain.drag, chain.added_mass) == ((1.3, 0.6), (1.0, 0.5))
    assert chain.EI == pytest.approx(1e-3 * chain.EA * 0.18**2 / 16, rel=1e-14)


def test_ropes_have_stiffness_by_their_strength_and_volume_by_their_density(library):
    rope = read_moorprops(library, "rope", 0.2)
    assert rope.EA == pytest.approx(14 * (1e4 + 3e8 * 0.04), rel=1e-14)
    assert pi / 4 * rope.diameter**2 * 1400 == pytest.approx(28.0, rel=1e-14)
    assert (rope.drag, rope.added_mass) == ((2.0, 0.0), (0.0, 0.0))


def test_what_is_not_used_of_a_material_is_named(library):
    edit(library, "    EA_MBL: 14\n", "    EA_MBL: 14\n    EAd_MBL: 20\n    cost_d: 3\n")
    assert read_moorprops(library, "rope", 0.2).notes == ["not used: EAd_MBL, cost_d"]
    assert read_moorprops(library, "chain", 0.1).notes == []


def test_the_section_is_that_of_a_deck(library, tmp_path):
    [path] = write_section(read_moorprops(library, "chain", 0.1), tmp_path / "section.toml", name="leg")
    section = tomllib.loads(path.read_text())["section"]["leg"]
    assert section["stiffness"]["EA"] == 8.4996e8 and section["inertia"]["rhoA"] == 200
    assert section["fluid"] == {"outer_diameter": 0.18, "drag": {"normal": 1.3, "tangential": 0.6}, "added_mass": {"normal": 1, "tangential": 0.5}}


def test_the_program_writes_a_section(library, tmp_path, capsys):
    assert find_format(library) == "moorpy"
    assert main([str(library), "--line", "chain", "--diameter", "0.1", "-o", str(tmp_path / "section.toml")]) == 0
    assert capsys.readouterr().out.splitlines() == ["chain, 200 kg/m, EA 8.4996e+08 N, volume-equivalent diameter 0.18 m", str(tmp_path / "section.toml")]
    assert "imported by gxrod-import from MoorPy: props.yaml, nominal diameter 0.1 m" in (tmp_path / "section.toml").read_text()
    assert main([str(library)]) == 2
    assert "give --line NAME --diameter D" in capsys.readouterr().err
    assert main([str(library), "--line", "chain", "--diameter", "0.1", "-o", str(tmp_path / "nowhere" / "section.toml")]) == 4


@pytest.mark.parametrize("old, new, name, diameter, message", [
    ("chain:", "chains:", "chain", 0.1, 'props.yaml: lineProps: there is no "chain"; give --line chains | rope'),
    ("20.0e+3", "heavy", "chain", 0.1, 'props.yaml: lineProps: chain: expected a number for mass_d2, found "heavy"; correct it'),
    ("density", "weight", "rope", 0.1, "props.yaml: lineProps: rope: there is no dvol_dnom or density; give one of them"),
    ("chain:", "chain:", "chain", 3000.0, "mass and EA come out as 1.8e.11 and -.*, not above 0; give another diameter than 3000 m"),
    ("lineProps:", "lineProps: [", "chain", 0.1, "props.yaml: expected a YAML file with lineProps"),
    ("lineProps:", "other:", "chain", 0.1, "props.yaml: expected a YAML file with lineProps"),
])
def test_faults_of_the_library(old, new, name, diameter, message, library):
    edit(library, old, new)
    with pytest.raises(FileError) as caught:
        read_moorprops(library, name, diameter)
    assert re.search(message, str(caught.value)), str(caught.value)


def test_the_library_needs_yaml(library, absent):
    absent("yaml")
    with pytest.raises(FileError, match="MoorPy's library needs PyYAML; install python3-yaml"):
        read_moorprops(library, "chain", 0.1)
