"""Sections from VABS and BECAS."""

import re

import numpy as np
import pytest
import section_files as files
from conftest import gxrod as run_gxrod
from imported import edit

import gxrod
from gxrod import FileError
from gxrod.importers import find_format, read_section_mesh, write_section_mesh
from gxrod.importers.command import main

# Stiffness, mesh-free: the rows X6, X9, X10 of the benchmarks, which VABS's and BECAS's own numbers approach.
SQUARE = {(0, 0): 3.4271267, (0, 1): 0.73160405, (1, 1): 0.75342845, (2, 2): 0.40979254, (3, 3): 9.4168816e-4, (3, 4): -4.5720525e-4, (4, 4): 2.4859098e-3, (5, 5): 2.2639290e-3}
BOX = {(0, 0): 1437379.5, (0, 3): 107400.6, (1, 1): 90118, (1, 4): -52009.6, (2, 2): 39278.5, (2, 5): -56335.0, (3, 3): 16765.6, (4, 4): 66188.0, (5, 5): 172493.4}
PIPE = {(0, 0): 10388591, (0, 3): 98519.7, (1, 1): 785267.4, (1, 4): -8234.3, (2, 2): 329035, (2, 5): -52084, (3, 3): 687073, (4, 4): 1882278, (5, 5): 5389347}


def near(found, wanted, tolerance):
    """The largest difference of the entries that are not zero, of each; and that the others are, on the scale of the diagonal."""
    scale = np.sqrt(np.outer(np.diagonal(found), np.diagonal(found)))
    for i in range(6):
        for j in range(i, 6):
            if (i, j) in wanted:
                assert abs(found[i, j] / wanted[i, j] - 1) < tolerance, (i, j, found[i, j], wanted[i, j])
            else:
                assert abs(found[i, j]) < 2e-4 * scale[i, j], (i, j, found[i, j])


def imported(source, folder):
    """The stiffness of the section as gxrod computes it from the deck."""
    if not gxrod._has_core():
        pytest.skip("gxrod has no compiled part here: it is built with -DGXROD_PYTHON_MODULE=ON")
    write_section_mesh(read_section_mesh(source), folder / "made.toml")
    return gxrod.Deck(folder / "made.toml").build().sections["section"].stiffness


def write_as(kind, folder, mesh, material):
    if kind == "becas":
        return files.write_becas(folder / "station", mesh, [material])
    return files.write_vabs(folder / "section.sg", mesh, [material], new=kind == "vabs", by_node=kind == "vabs by node")


@pytest.mark.parametrize("kind", ["vabs", "old vabs", "becas"])
def test_fibres_turn_as_in_the_square_of_the_user_guide(kind, tmp_path):
    near(imported(write_as(kind, tmp_path, files.square(), files.SQUARE), tmp_path), SQUARE, 1e-4)


@pytest.mark.parametrize("kind", ["vabs", "old vabs", "becas"])
def test_walls_turn_from_y_towards_z(kind, tmp_path):
    """A quarter turn of the square and of its walls: y becomes z, z becomes −y."""
    turned = {(0, 0): SQUARE[0, 0], (0, 2): SQUARE[0, 1], (1, 1): SQUARE[2, 2], (2, 2): SQUARE[1, 1], (3, 3): SQUARE[3, 3], (3, 5): SQUARE[3, 4], (4, 4): SQUARE[5, 5], (5, 5): SQUARE[4, 4]}
    near(imported(write_as(kind, tmp_path, files.square(turn=90.0), files.SQUARE), tmp_path), turned, 1e-4)


@pytest.mark.parametrize("kind", ["vabs", "old vabs", "becas"])
def test_a_box_of_plies(kind, tmp_path):
    near(imported(write_as(kind, tmp_path, files.box(), files.BOX), tmp_path), BOX, 1e-3)


def test_a_pipe_whose_walls_turn_within_elements(tmp_path):
    near(imported(write_as("vabs by node", tmp_path, files.pipe(), files.PIPE), tmp_path), PIPE, 1e-3)


def test_a_pipe_whose_walls_turn_from_element_to_element(tmp_path):
    """One angle an element, 24 on each arc: couplings are some tenths of a percent low."""
    near(imported(write_as("vabs", tmp_path, files.pipe(along=24), files.PIPE), tmp_path), PIPE, 1e-2)


def test_linear_elements_and_triangles_become_cubic(tmp_path):
    near(imported(write_as("vabs", tmp_path, files.square(order=1, count=6), files.SQUARE), tmp_path), SQUARE, 1e-3)
    mesh = files.square(order=1, count=4)
    halves = [(element, i) for i, nodes in enumerate(mesh.elements) for element in ([nodes[0], nodes[1], nodes[2]], [nodes[0], nodes[2], nodes[3]])]
    triangles = files.Mesh(mesh.nodes, [element for element, _ in halves], *([values[i] for _, i in halves] for values in (mesh.materials, mesh.fibres, mesh.walls)))
    near(imported(write_as("vabs", tmp_path, triangles, files.SQUARE), tmp_path), SQUARE, 2e-3)
    near(imported(write_as("becas", tmp_path, triangles, files.SQUARE), tmp_path), SQUARE, 2e-3)


def test_the_deck_runs(tmp_path, capsys):
    source = write_as("becas", tmp_path, files.box(along=(6, 4), plies=2), files.BOX)
    assert find_format(source) == find_format(source / "N2D.in") == "becas"
    assert main([str(source), "-o", str(tmp_path / "box.toml")]) == 0
    said = capsys.readouterr()
    assert "40 elements of 1 layers, 0.953 across (BECAS: station)" in said.out and said.err == ""
    deck = (tmp_path / "box.toml").read_text()
    assert 'angle = "15*pi/180"\ndirections = "wall_angle"' in deck
    run_gxrod("run", "box.toml", "--quiet", folder=tmp_path)


def test_isotropic_and_anisotropic_materials(tmp_path):
    mesh = files.square(order=1, count=2)
    path = files.write_vabs(tmp_path / "a.dat", mesh, [files.SQUARE])
    text = path.read_text()
    path.write_text(text[: text.rindex("1 1\n")] + "1 0\n210e9 0.3\n7850\n")
    [layer] = read_section_mesh(path).layers
    assert (layer.material.E, layer.material.nu, layer.material.density, layer.name) == (210e9, 0.3, 7850.0, "m1")
    flexibility = np.zeros((6, 6))
    E, G, nu = files.SQUARE[:3], files.SQUARE[3:6], files.SQUARE[6:9]
    for i, j, value in ((0, 0, 1 / E[0]), (3, 3, 1 / E[1]), (5, 5, 1 / E[2]), (0, 3, -nu[0] / E[0]), (0, 5, -nu[1] / E[0]), (3, 5, -nu[2] / E[1]), (1, 1, 1 / G[0]), (2, 2, 1 / G[1]), (4, 4, 1 / G[2])):
        flexibility[i, j] = flexibility[j, i] = value
    stiffness = np.linalg.inv(flexibility)
    rows = "\n".join(files.row(stiffness[i, i:]) for i in range(6))
    path.write_text(text[: text.rindex("1 1\n")] + f"1 2\n{rows}\n3.0\n")
    [layer] = read_section_mesh(path).layers
    assert np.allclose([*layer.material.E, *layer.material.G, *layer.material.nu, layer.material.density], [*files.SQUARE[:9], 3.0], rtol=1e-12)
    stiffness[0, 1] = stiffness[1, 0] = 10.0
    rows = "\n".join(files.row(stiffness[i, i:]) for i in range(6))
    path.write_text(text[: text.rindex("1 1\n")] + f"1 2\n{rows}\n3.0\n")
    with pytest.raises(FileError, match="the material m1 is anisotropic in a way that gxrod does not have"):
        read_section_mesh(path)


def test_files_as_sonata_writes_them(tmp_path):
    """The old format, commas between number and type of a material, and loads after the materials."""
    path = files.write_vabs(tmp_path / "sonata.vab", files.square(order=1, count=2), [files.SQUARE], new=False)
    text = path.read_text().replace("0 1\n1 0 0\n", "0 0\n1 1 0\n").replace("\n1 1\n", "\n1, 1\n")
    path.write_text(text + "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n10 0 0 0\n0 0\n")
    section = read_section_mesh(path)
    assert len(section.elements) == 4 and section.layers[0].name == "m1 22.5"


def test_strengths_of_becas(tmp_path):
    folder = files.write_becas(tmp_path / "s", files.square(order=1, count=2), [files.SQUARE])
    (folder / "FAILMAT.in").write_text(files.row([2, 1500, 40, 40, 70, 70, 70, 1200, 200, 200, *[0] * 9]) + "\n")
    section = read_section_mesh(folder)
    assert section.layers[0].material.strength == {"Xt": 1500, "Xc": 1200, "Yt": 40, "Yc": 200, "S12": 70, "S23": 70}
    (folder / "FAILMAT.in").write_text(files.row([2, 1500, 40, 40, 70, 60, 70, 1200, 200, 200, *[0] * 9]) + "\n")
    section = read_section_mesh(folder)
    assert section.layers[0].material.strength == {} and section.notes == ["strengths that differ across the fibres, or are incomplete, were left out: m1"]


def fault(path):
    with pytest.raises(FileError) as caught:
        read_section_mesh(path)
    return str(caught.value)


VABS_FAULTS = [
    ("9 4 1\n", "9.5 4 1\n", r"expected whole numbers \(numbers of nodes, elements and materials\); correct this line"),
    ("9 4 1\n", "10 4 1\n", r"s.sg:\d+: expected 3 numbers \(node 10 of 10: its number, x2, x3\), found 10; correct this line, or the count"),
    ("1 0 0\n0 0 0 0\n", "1 0 0\n0 1 0 0\n0.9 0.1\n", r"the section is oblique; give the mesh of the section across the rod"),
    ("1 1 2 3 4 0 0 0 0 0\n", "1 1 2 3 0 0 4 0 0 0\n", r"expected the nodes of a triangle"),
    ("1 1 2 3 4 0 0 0 0 0\n", "1 1 2 3 33 0 0 0 0 0\n", r"there is no node 33; correct this line, or add the node"),
    ("1 1 0\n2 1 0\n", "1 3 0\n2 1 0\n", r"s.sg:\d+: there is no layer 3, the file has 1; correct this line, or add the layer"),
    ("1 1 22.5\n", "1 7 22.5\n", r"there is no material 7, the file has 1"),
    ("\n1 1\n480", "\n1 3\n480", r"expected a type of material, 0 isotropic, 1 orthotropic, 2 anisotropic, found 3"),
    ("\n1 1\n480 120", "\n1 1\n480 1.2e", r'expected .* \(E1 E2 E3, .*\), found "1.2e"'),
]


@pytest.mark.parametrize("old, new, message", VABS_FAULTS)
def test_faults_of_vabs_files(old, new, message, tmp_path):
    path = edit(files.write_vabs(tmp_path / "s.sg", files.square(order=1, count=2), [files.SQUARE]), old, new)
    assert re.search(message, fault(path)), fault(path)


def test_twist_is_warned_of(tmp_path):
    path = files.write_vabs(tmp_path / "s.sg", files.square(order=1, count=2), [files.SQUARE])
    edit(path, "0 0 0 0\n", "1 0 0 0\n0.1 0 0\n")
    [warning] = read_section_mesh(path).warnings
    assert warning.startswith("the initial twist and curvatures 0.1, 0, 0 are not in the stiffness")


BECAS_FAULTS = [
    ("E2D.in", "1 1 2 3 4 0 0 0 0\n", "1 1 2 3 4 0 0 0\n", r"E2D.in:1: expected 5 or 7 or 9 numbers \(number of the element and its eight nodes, 0 for those that it does not have\), found 8; correct this line"),
    ("E2D.in", "1 1 2 3 4 0 0 0 0\n", "1 1 2 3 77 0 0 0 0\n", r"E2D.in:1: there is no node 77 in N2D.in"),
    ("EMAT.in", "1 1 22.5 0\n", "", r"EMAT.in: the element 1 has no line; give each element its material and angles"),
    ("EMAT.in", "1 1 22.5 0\n", "1 2 22.5 0\n", r"EMAT.in:1: there is no material 2, MATPROPS.in has 1"),
    ("N2D.in", "2 ", "1 ", r"N2D.in:2: the node 1 stands here again; give each node its own number"),
    ("MATPROPS.in", "480", "48o", r'MATPROPS.in:1: expected 10 numbers .*, found "48o"'),
]


@pytest.mark.parametrize("name, old, new, message", BECAS_FAULTS)
def test_faults_of_becas_folders(name, old, new, message, tmp_path):
    folder = files.write_becas(tmp_path / "s", files.square(order=1, count=2), [files.SQUARE])
    edit(folder / name, old, new)
    assert re.search(message, fault(folder)), fault(folder)


def test_side_nodes_in_another_order_are_refused(tmp_path):
    mesh = files.square(count=2)
    mesh.elements = [[*nodes[:4], nodes[5], nodes[4], *nodes[6:]] for nodes in mesh.elements]
    assert "is not on its side, between corners that follow each other" in fault(files.write_becas(tmp_path / "s", mesh, [files.SQUARE]))
    assert "give the nodes in VABS's order" in fault(files.write_vabs(tmp_path / "s.sg", mesh, [files.SQUARE]))


def test_folders_and_files_that_are_no_sections(tmp_path):
    assert "is a folder without N2D.in" in fault(tmp_path)
    folder = files.write_becas(tmp_path / "s", files.square(order=1, count=2), [files.SQUARE])
    (folder / "EMAT.in").unlink()
    assert "there is no EMAT.in; a folder of BECAS has N2D.in, E2D.in, EMAT.in, MATPROPS.in" in fault(folder)
    path = tmp_path / "a.txt"
    path.write_text("nothing")
    assert "nor an input of VABS" in fault(path)
