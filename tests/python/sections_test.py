"""gxrod.Section: cross-sections by themselves, and those of models."""

import numpy as np
import pytest

import gxrod

STEEL = {"E": 2.1e11, "nu": 0.3, "density": 7850}


def test_a_profile_has_its_constants():
    section = gxrod.Section.profile("IPE 200", STEEL, units="m, N")
    constants = section.constants
    assert constants["source"] == "IPE 200"
    assert constants["area"] == pytest.approx(2848.4107e-6, rel=1e-6)
    assert constants["second_moment_y"] == pytest.approx(19431683e-12, rel=1e-6)
    assert constants["warping_length"] == pytest.approx(0.695747, rel=1e-4)
    assert section.stiffness[4, 4] == pytest.approx(2.1e11 * 19431683e-12, rel=1e-6)
    assert section.mass[0, 0] == pytest.approx(7850 * 2848.4107e-6, rel=1e-6)
    np.testing.assert_allclose(section.shear_centre, 0, atol=1e-8)


def test_stresses_of_bending_are_those_of_a_beam():
    section = gxrod.Section.profile("UPN 140", STEEL, units="m, N", origin="given")
    np.testing.assert_allclose(section.tension_centre, [17.55426e-3, 0], atol=1e-8)
    stress = section.stress([0, 0, 0, 0, 1.0, 0])
    z = section.points[:, 1]
    np.testing.assert_allclose(stress[:, 0], z / section.constants["second_moment_y"], atol=2e-4 * np.abs(stress).max())
    assert section.von_mises([0, 0, 0, 0, 1.0, 0]).max() == pytest.approx(0.07 / section.constants["second_moment_y"], rel=1e-3)
    assert len(section.layers) == len(section.points)
    with pytest.raises(ValueError, match="six resultants"):
        section.stress([1.0])


def test_a_section_goes_back_into_a_deck(tmp_path):
    section = gxrod.Section.profile("L 100x100x10", STEEL, millimetre=1e-3)
    again = gxrod.Section.from_table(section.to_deck())
    np.testing.assert_array_equal(again.stiffness, section.stiffness)
    section.draw(tmp_path / "angle.svg", [1, 0, 0, 0, 0, 0])
    assert "von Mises" in (tmp_path / "angle.svg").read_text(encoding="utf-8")
    matrices = gxrod.Section.from_table({"stiffness_matrix": section.stiffness.tolist()})
    np.testing.assert_allclose(matrices.stiffness, section.stiffness, rtol=1e-12, atol=1e-6)
    with pytest.raises(ValueError, match="no shape on cells"):
        matrices.points
    assert "stiffness" in repr(matrices)


def test_faults_are_those_of_a_deck():
    with pytest.raises(gxrod.DeckError, match='no profile "IPE 205"'):
        gxrod.Section.profile("IPE 205", STEEL, units="m, N")
    with pytest.raises(TypeError, match="Section.profile"):
        gxrod.Section()


PLAIN = """[section.s]
shape = {{ {} }}
material = {{ E = 1.0, nu = 0.3 }}
[rod.r]
section = "s"
line = {{ from = [0, 0, 0], to = [50, 0, 0] }}
elements = 2
[[support]]
at = "r.start"
fix = "all"
[analysis]
kind = "static"
[output]
stresses = "von-mises"
"""
CIRCLE, SQUARE = "circle = { radius = 1 }", "rectangle = { width_y = 1, height_z = 1 }"
TUBE = "tube = { outer_radius = 0.1, inner_radius = 0.09 }"


def stress_at(section, resultant, place):
    """(xx, yy, zz, yz, xz, xy) of a unit resultant at the nearest point."""
    points = np.array(section.points)[:, :2]
    return section.stress(np.eye(6)[resultant])[((points - place)**2).sum(axis=1).argmin()]


# Resultants N Vy Vz T My Mz; closed forms and series.
@pytest.mark.parametrize("shape, resultant, place, component, exact, tolerance", [
    (CIRCLE, 1, (0, 0), 5, 0.4407367655, 2e-5), (CIRCLE, 1, (0, 1), 5, 0.3917660138, 2e-4),
    (CIRCLE, 3, (0, 1), 5, -0.6366197724, 2e-4), (CIRCLE, 4, (0, 1), 0, 1.2732395447, 2e-4),
    (SQUARE, 3, (0, 0.5), 5, -4.803875538, 5e-4), (SQUARE, 1, (0, 0), 5, 1.39658929, 2e-4), (SQUARE, 1, (0, 0.5), 5, 1.71853322, 2e-4),
    (TUBE, 1, (0, 0.09), 5, 348.590870, 2e-4), (TUBE, 1, (0, 0.1), 5, 321.535206, 2e-4), (TUBE, 3, (0.1, 0), 4, 1851.177006, 2e-4)])
def test_plain_shapes_have_the_stresses_of_their_closed_forms(shape, resultant, place, component, exact, tolerance):
    section = gxrod.Deck.from_text(PLAIN.format(shape)).build().sections["s"]
    assert stress_at(section, resultant, place)[component] == pytest.approx(exact, rel=tolerance)


def test_a_profile_has_the_stresses_of_finer_cells():
    section = gxrod.Section.profile("IPE 200", {"E": 2.1e5, "nu": 0.3}, units="mm, N")
    assert stress_at(section, 2, (0, 0))[4] == pytest.approx(0.00101379, rel=1e-5)
    assert stress_at(section, 2, (2.8, 0))[4] == pytest.approx(0.00101383, rel=1e-5)
    assert stress_at(section, 4, (50, 100))[0] == pytest.approx(5.14623e-6, rel=1e-5)
    assert section.von_mises([0, 0, 1, 0, 0, 0]).max() == pytest.approx(1.75600e-3, rel=1e-5)
