"""Files of ElastoDyn."""

import re
from dataclasses import replace

import blades
import numpy as np
import pytest
from gxrod.importers import read_blade
from imported import edit, fault


def test_an_elastodyn_blade_has_bending_and_mass(tmp_path):
    sections = [replace(each, fraction=f) for each, f in zip(blades.SECTIONS, (0.0, 0.25, 1.0))]
    blade = read_blade(blades.write_elastodyn(tmp_path, sections, twist=10.0, factors=(1.5, 2.0, 3.0), tuner=0.9), length=60.0)
    assert np.allclose(blade.stiffness[:, 5, 5], [2.0 * each.EI[1] for each in sections])  # about z: flapwise
    assert np.allclose(blade.stiffness[:, 4, 4], [3.0 * each.EI[0] for each in sections])
    assert np.allclose(blade.mass[:, 0, 0], [1.5 * each.m for each in sections])
    assert np.allclose(blade.twist, -np.radians(10.0))
    assert np.array_equal(blade.points, [[0, 0, 0], [0, 0, 60]])
    assert any("ElastoDyn has bending and mass only" in note for note in blade.notes)
    assert any("FlStTunr" in each for each in blade.warnings)


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
