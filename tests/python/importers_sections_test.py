"""Sections of sectionproperties."""

import re
from math import pi

import numpy as np
import pytest
from conftest import SOURCE
from gxrod.importers import from_sectionproperties
from imported import near


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
