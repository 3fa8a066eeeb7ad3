"""Stresses of results files: those of beam theory, and the same from every side."""

import gxrod
import numpy as np
import pytest
from conftest import gxrod as run_gxrod

# A cantilever, 2 long, 0.05 wide and 0.1 high, with a small force at its end: so small that it stays straight.
BEAM = """title = "A cantilever"
units = "m N"
[material.steel]
E = 2.1e11
nu = 0.3
density = 7850
yield_stress = 2e5
[layup.thick]
plies = [["steel", 0.05, 0]]
[section.plate]
shape = { walls = { corners = [[0, -0.05], [0, 0.05]], closed = false, line = "middle", layup = "thick" } }
[section.given]
stiffness = { EA = 1e9, GAy = 4e8, GAz = 4e8, GJ = 1e6, EIy = 1e6, EIz = 1e6 }
[rod.beam]
section = "plate"
line = { from = [0, 0, 0], to = [2, 0, 0] }
y_axis = [0, 1, 0]
elements = 8
order = 2
[rod.spare]
section = "given"
line = { from = [0, 1, 0], to = [1, 1, 0] }
elements = 2
[[support]]
at = "beam.start"
fix = "all"
[[support]]
at = "spare.start"
fix = "all"
[[load]]
at = "beam.end"
force = [0.3, 0, -1]
[analysis]
kind = "static"
steps = 4
[output]
every = 1
stresses = "von-mises"
"""
AREA, INERTIA = 0.05 * 0.1, 0.05 * 0.1**3 / 12.0


@pytest.fixture(scope="module")
def beam(tmp_path_factory):
    folder = tmp_path_factory.mktemp("stresses")
    (folder / "beam.toml").write_text(BEAM)
    run_gxrod("run", "beam.toml", "--quiet", folder=folder)
    return gxrod.open_results(folder / "beam.vtkhdf")


def bending(s, z):
    """Beam theory: tension above, of a force downwards."""
    return 0.3 / AREA + 1.0 * (2.0 - s) * z / INERTIA


@pytest.mark.parametrize("s", [0.0, 0.3, 1.125, 2.0])
def test_stresses_at_any_place_are_those_of_beam_theory(beam, s):
    stress = beam.stress("beam", s=s)
    y, z = stress.points.T
    np.testing.assert_allclose(stress.xx, bending(s, z), atol=1e-4 * bending(0.0, 0.05))
    np.testing.assert_allclose(stress.yy, 0.0, atol=1e-4 * bending(0.0, 0.05))
    assert stress.time == 1.0
    np.testing.assert_allclose(stress.resultants, [0.3, 0.0, -1.0, 0.0, 2.0 - s, 0.0], atol=1e-4)
    assert np.abs(stress.xz).max() == pytest.approx(1.5 / AREA, rel=0.08)  # that on average over the width


def test_stresses_at_a_time_are_those_of_the_nearest_frame(beam):
    half, whole = beam.stress("beam", s=0.3, t=0.55), beam.stress("beam", s=0.3)
    assert half.time == 0.5
    np.testing.assert_allclose(2.0 * half.tensor, whole.tensor, atol=1e-5 * np.abs(whole.tensor).max())


def test_the_worst_point_is_at_an_edge(beam):
    stress = beam.stress("beam", s=0.3)
    worst = stress.worst
    assert worst["point"][1] == pytest.approx(0.05)
    assert worst["von_mises"] == stress.von_mises.max() == stress.von_mises[worst["index"]]
    assert worst["von_mises"] == pytest.approx(bending(0.3, 0.05), rel=1e-4)
    assert worst["layer"] == beam.sections["plate"].layers[0]
    np.testing.assert_allclose(stress.principal[worst["index"]], [bending(0.3, 0.05), 0.0, 0.0], atol=1e-3 * worst["von_mises"])


def test_the_worst_of_middles_is_that_of_the_frames(beam):
    rod, last = beam.rod("beam"), beam.frames[-1].elements
    for cell, s in zip(rod.cells, rod.cell_arc_length):
        worst = beam.stress("beam", s=s).worst["von_mises"]
        assert worst == pytest.approx(last.von_mises[cell], rel=1e-6)
        assert last.exposure[cell] == pytest.approx(worst / 2e5, rel=1e-6)
    np.testing.assert_array_equal(rod.von_mises(-1), last.von_mises[rod.cells])
    assert "section" not in rod.names


def test_envelopes_have_the_largest_of_all_steps(beam):
    envelope = beam.envelope("beam")
    assert envelope.criterion == "von-mises"
    assert len(envelope) == 3 * 8 == len(envelope.von_mises) == len(envelope.exposure)
    # At the free end shear is more.
    np.testing.assert_allclose(envelope.von_mises.value[:-1], bending(envelope.arc_length, 0.05)[:-1], rtol=1e-3)
    assert envelope.von_mises.value[-1] > bending(2.0, 0.05)
    worst = envelope.worst("exposure")
    assert (worst["arc_length"], worst["time"], worst["element"]) == (0.0, 1.0, 0)
    assert worst["value"] == pytest.approx(bending(0.0, 0.05) / 2e5, rel=1e-4)
    assert abs(worst["point"][1]) == pytest.approx(0.05)
    section = beam.sections["plate"]
    assert (section.stress(worst["resultants"])[:, 0]).max() == pytest.approx(bending(0.0, 0.05), rel=1e-4)


def test_what_is_not_there_is_said(beam, runs):
    assert list(beam.sections) == ["plate"]
    with pytest.raises(ValueError, match="s = 2.5 is not on rod beam, which is 2 long"):
        beam.stress("beam", s=2.5)
    with pytest.raises(gxrod.UnknownNameError, match="did you mean 'beam'"):
        beam.stress("bem", s=0.5)
    with pytest.raises(gxrod.UnknownNameError, match="rod spare has no stresses at s = 0.5"):
        beam.stress("spare", s=0.5)
    with pytest.raises(gxrod.UnknownNameError, match="rod spare has no stresses"):
        beam.envelope("spare").worst()
    plank = gxrod.open_results(runs("plank"))
    assert list(plank.sections) == []
    for ask in (lambda: plank.stress("plank", s=1.0), lambda: plank.envelope("plank")):
        with pytest.raises(gxrod.UnknownNameError, match="has no stresses: run it with stresses"):
            ask()


def test_they_are_shown_in_lines(beam):
    assert repr(beam.stress("beam", s=0.3)).startswith("stress of beam at s = 0.3, time 1:")
    assert "von Mises" in repr(beam.stress("beam", s=0.3))
    assert repr(beam.envelope("beam")).startswith("envelope of beam: 24 places, exposure by von-mises")
    assert repr(beam.sections["plate"]).startswith("section plate: ")


@pytest.mark.parametrize("what, options", [("stress", {"measure": "exposure"}), ("section", {}), ("section", {"rod": "beam", "at": 0.3, "times": [0.5]})])
def test_pictures(beam, what, options):
    pytest.importorskip("matplotlib")
    figure = beam.plot(what, **options)
    texts = " ".join(text.get_text() for part in [figure, *figure.subfigs] for text in [*part.texts, *([part._suptitle] if part._suptitle else [])])
    assert ("s = 0.3, load factor = 0.5" in texts) == ("at" in options)
    axes = [axes for part in figure.subfigs for axes in part.axes]
    assert len(axes) == (1 if what == "stress" else 2)
    if what == "stress":
        [curve, *_] = [line for line in axes[0].lines if len(line.get_xdata()) == 24]
        assert np.nanmax(curve.get_ydata()) == pytest.approx(bending(0.0, 0.05) / 2e5, rel=1e-4)
