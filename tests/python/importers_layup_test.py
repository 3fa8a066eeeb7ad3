"""Sections of windIO files, meshed from their layers and webs."""

import re

import numpy as np
import pytest

import gxrod
from gxrod import FileError
from gxrod.importers import read_windio_layup, write_section_mesh
from gxrod.importers.command import main

pytest.importorskip("yaml")

HEAD = """name: A small turbine
components:
    blade:
        outer_shape_bem:
            airfoil_position: {grid: [0.0, 0.5, 1.0], labels: [circular, circular, thin]}
            chord: {grid: [0.0, 1.0], values: [2.0, 1.0]}
            pitch_axis: {grid: [0.0, 1.0], values: [0.5, 0.4]}
        internal_structure_2d_fem:
            webs:
"""
WEB = """              - name: web
                start_nd_arc: {grid: [0.0, 1.0], values: [0.3, 0.3]}
                end_nd_arc: {grid: [0.0, 1.0], values: [0.7, 0.7]}
"""
LAYERS = """            layers:
"""
TAIL = """airfoils:
  - name: circular
    relative_thickness: 1.0
    coordinates: {x: [CX], y: [CY]}
  - name: thin
    relative_thickness: 0.2
    coordinates: {x: [TX], y: [TY]}
materials:
  - {name: steel, orth: 0, E: 2.0e11, G: 8.0e10, nu: 0.25, rho: 8000}
  - {name: glass, orth: 1, E: [40.0e9, 12.0e9, 12.0e9], G: [4.0e9, 4.0e9, 3.5e9], nu: [0.28, 0.28, 0.4], rho: 1900}
"""
ANGLES = np.linspace(0.0, 2.0 * np.pi, 201)


def layer(name, material, thickness, start=0.0, end=1.0, web=""):
    places = f"web: {web}" if web else f"start_nd_arc: {{grid: [0, 1], values: [{start}, {start}]}}\n                end_nd_arc: {{grid: [0, 1], values: [{end}, {end}]}}"
    return (f"              - name: {name}\n                material: {material}\n                thickness: {{grid: [0, 1], values: [{thickness}, {thickness}]}}\n"
            f"                fiber_orientation: {{grid: [0, 1], values: [0, 0]}}\n                {places}\n")


def write(folder, *layers, web=True, gap=None):
    """gap: at the trailing edge of the thin airfoil, over the chord; None: it is round."""
    thin = 0.5 * (1.0 + np.cos(ANGLES))
    shape = 0.1 * np.sin(ANGLES) * (1.0 - thin) ** 0.25 * 1.5 * (1.0 - 0.5 * thin)
    if gap is not None:
        shape = np.where(ANGLES <= np.pi, 1, -1) * (0.15 * np.sqrt(thin) * (1.0 - thin) + 0.5 * gap * thin)
    lists = {"CX": 0.5 * (1.0 + np.cos(ANGLES)), "CY": 0.5 * np.sin(ANGLES), "TX": thin, "TY": shape}
    tail = TAIL
    for key, values in lists.items():
        tail = tail.replace(key, ", ".join(f"{each:.8f}" for each in values))
    head = HEAD + WEB if web else HEAD.replace("            webs:\n", "")
    path = folder / "turbine.yaml"
    path.write_text(head + LAYERS + "".join(layers) + tail)
    return path


def stiffness(section, folder):
    if not gxrod._has_core():
        pytest.skip("gxrod has no compiled part here: it is built with -DGXROD_PYTHON_MODULE=ON")
    write_section_mesh(section, folder / "made.toml")
    return gxrod.Deck(folder / "made.toml").build().sections["section"].stiffness


def test_a_round_wall_is_a_tube(tmp_path):
    section = read_windio_layup(write(tmp_path, layer("outer", "steel", 0.01), layer("inner", "steel", 0.03), web=False), 0.0)
    K = stiffness(section, tmp_path)
    area, I = np.pi * (1.0 - 0.96**2), np.pi / 4 * (1.0 - 0.96**4)
    found = np.diagonal(K)[[0, 3, 4, 5]] / (2e11 * area, 8e10 * 2 * I, 2e11 * I, 2e11 * I)
    assert np.all(np.abs(found - 1.0) < 2e-3), found


def test_a_web_adds_its_area_and_is_joined_to_the_wall(tmp_path):
    without = read_windio_layup(write(tmp_path, layer("wall", "steel", 0.04), web=False), 0.0)
    layers = [layer("wall", "steel", 0.04), layer("first", "steel", 0.005, web="web"), layer("second", "steel", 0.005, web="web")]
    with_web = read_windio_layup(write(tmp_path, *layers), 0.0)
    inside = 2.0 * np.sqrt(0.96**2 - np.cos(2.0 * np.pi * 0.3) ** 2)
    assert with_web.area - without.area == pytest.approx(0.01 * inside, rel=0.01)
    K, plain = stiffness(with_web, tmp_path), stiffness(without, tmp_path)
    offset = K[0, 4] - plain[0, 4]  # ∫ E z
    assert offset == pytest.approx(2e11 * 0.01 * inside * np.cos(2.0 * np.pi * 0.3), rel=0.01)
    assert K[0, 0] - plain[0, 0] == pytest.approx(2e11 * 0.01 * inside, rel=0.03)
    assert K[5, 5] - plain[5, 5] == pytest.approx(2e11 * 0.01 * inside**3 / 12.0, rel=0.06)


def test_layers_with_an_end_keep_their_area(tmp_path):
    section = read_windio_layup(write(tmp_path, layer("skin", "glass", 0.004), layer("cap", "steel", 0.05, 0.2, 0.3), layer("core", "glass", 0.02, 0.3, 0.45), web=False), 0.0)
    areas = {each.name: 0.0 for each in section.layers}
    for element, number in zip(section.elements, section.element_layers):
        y, z = section.nodes[element].T
        areas[section.layers[number].name] += abs(np.dot(y, np.roll(z, -1)) - np.dot(z, np.roll(y, -1))) / 2
    around = lambda depth, thickness, part: part * np.pi * ((1.0 - depth) ** 2 - (1.0 - depth - thickness) ** 2)
    assert areas["steel"] == pytest.approx(around(0.004, 0.05, 0.1), rel=0.01)
    assert areas["glass"] == pytest.approx(around(0.0, 0.004, 1.0) + around(0.004, 0.02, 0.15), rel=0.01)


def test_walls_of_a_thin_airfoil_are_joined_at_its_trailing_edge(tmp_path, capsys):
    path = write(tmp_path, layer("skin", "glass", 0.004), layer("cap", "glass", 0.01, 0.25, 0.4), layer("web", "glass", 0.005, web="web"))
    assert main([str(path), "--layup", "1", "-o", str(tmp_path / "tip.toml")]) == 0
    assert re.search(r"elements of 1 layers, 1 across \(windIO 1: turbine.yaml\)", capsys.readouterr().out)
    assert np.all(np.linalg.eigvalsh(stiffness(read_windio_layup(path, 1.0), tmp_path)) > 0)
    # A closed thin wall twists by 4 A² G t/perimeter (Bredt), an open one hundreds of times as much.
    K = stiffness(read_windio_layup(write(tmp_path, layer("skin", "glass", 0.004), web=False), 1.0), tmp_path)
    perimeter = K[0, 0] / (40e9 * 0.004)
    assert K[3, 3] == pytest.approx(4.0 * (0.1474 - 0.002 * perimeter) ** 2 * 4e9 * 0.004 / perimeter, rel=0.06)


def bredt(folder, thickness, gap):
    """Torsion stiffness of the thin airfoil with one layer over that of a closed thin wall, 4 A² G t/perimeter."""
    section = read_windio_layup(write(folder, layer("skin", "glass", thickness), web=False, gap=gap), 1.0)
    x = np.linspace(0.0, 1.0, 20001)
    y = 0.15 * np.sqrt(x) * (1.0 - x) + 0.5 * gap * x
    perimeter = 2.0 * np.sum(np.hypot(np.diff(x), np.diff(y))) + gap
    area = 2.0 * np.trapz(y, x) - 0.5 * thickness * perimeter
    return stiffness(section, folder)[3, 3] / (4.0 * area**2 * 4e9 * thickness / perimeter)


@pytest.mark.parametrize("thickness, gap", [(0.001, 0.02), (0.002, 0.001), (0.002, 0.0)])
def test_trailing_edges_are_closed(thickness, gap, tmp_path):
    """A wall across a blunt edge; walls that meet before the edge, whose cell is shorter; a sharp edge. An open wall would be hundreds of times softer."""
    assert bredt(tmp_path, thickness, gap) == pytest.approx(1.0, abs=0.03 if gap > thickness else 0.06)


LAYUP_FAULTS = [
    ("material: glass", "material: gloss", "materials: there is no material gloss; add it"),
    ("labels: [circular, circular, thin]", "labels: [circular, circular, thick]", "there is no airfoil thick; add it to airfoils"),
    ("            layers:\n", "            layer:\n", "expected a key layers"),
    ("thickness: {grid: [0, 1], values: [0.004, 0.004]}", "thickness: {grid: [0, 1], values: [0.004]}", "expected 2 finite numbers, found an array of 1"),
]


@pytest.mark.parametrize("old, new, message", LAYUP_FAULTS)
def test_faults_of_layups(old, new, message, tmp_path):
    path = write(tmp_path, layer("skin", "glass", 0.004), web=False)
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    with pytest.raises(FileError, match=re.escape(message)):
        read_windio_layup(path, 0.5)


def test_other_files_have_no_layup(tmp_path, capsys):
    path = tmp_path / "blade.dat"
    path.write_text("Nothing of a blade.\n")
    assert main([str(path), "--layup", "0.5", "--format", "beamdyn"]) == 2
    assert "--layup is for windIO files, this is of the format beamdyn; leave it out" in capsys.readouterr().err
    with pytest.raises(FileError, match="there is no section at 1.5 of the span; give a fraction from 0 to 1"):
        read_windio_layup(write(tmp_path, layer("skin", "glass", 0.004)), 1.5)
