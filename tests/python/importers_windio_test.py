"""Files of windIO."""

import re
from dataclasses import replace

import blades
import numpy as np
import pytest
from gxrod.importers import read_blade
from imported import curve_of, edit, fault

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


@pytest.mark.parametrize("version, beside, name", [(1, "stiff_matrix:", "six_x_six/point_mass"), (2, "stiffness_matrix:", "elastic_properties/point_mass")])
def test_keys_beside_the_matrices_are_warned_of(version, beside, name, tmp_path):
    pytest.importorskip("yaml")
    path = blades.write_windio(tmp_path, version, fractions=curve_of().fractions)
    assert read_blade(path).warnings == []
    edit(path, beside, f"point_mass: 3\n                {beside}")
    assert read_blade(path).warnings == [f"not used: {name}"]


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
