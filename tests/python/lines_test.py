"""Ranges along rods and ends of lines in Python, compared with frames and histories."""

import numpy as np
import pytest

import gxrod
from conftest import gxrod as run_gxrod

LINE = """gravity = [0, 0, -9.81]
[fluid]
density = 1000
surface = 0
[seabed]
z = -10
stiffness = 1e5
[section.s]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 1, EIy = 1, EIz = 1 }
inertia = { rhoA = 10, rhoIy = 1e-3, rhoIz = 1e-3 }
fluid = { outer_diameter = 0.05 }
[rod.line]
section = "s"
catenary = { from = [0, 0, -9.98], to = [30, 0, 0], length = 36, bed = true }
elements = 20
order = 2
[[support]]
at = "line.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "line.end"
move = { x = "0.2*sin(2*t)*min(t, 1)^2" }
fix = ["y", "z", "rx", "rz"]
stages = "sway"
[[support]]
at = "line.end"
fix = ["position", "rx", "rz"]
stages = "hang"
[output]
line_ends = "line"
[[stage]]
name = "hang"
kind = "static"
steps = 1
[[stage]]
name = "sway"
kind = "dynamic"
end_time = 2
time_step = 0.05
integrator = "generalized-alpha"
"""


@pytest.fixture(scope="module")
def line(tmp_path_factory):
    folder = tmp_path_factory.mktemp("line")
    (folder / "line.toml").write_text(LINE, encoding="utf-8")
    run_gxrod("run", "line.toml", folder=folder)
    return gxrod.open_results(folder / "line.vtkhdf")


def test_quantities_that_follow_from_others(line):
    rod = line.rod("line")
    force, moment = rod.force(-1), rod.moment(-1)
    np.testing.assert_array_equal(rod.effective_tension(-1), force[:, 0])
    np.testing.assert_allclose(rod.shear_force(-1), np.hypot(force[:, 1], force[:, 2]))
    np.testing.assert_allclose(rod.bending_moment(-1), np.hypot(moment[:, 1], moment[:, 2]))
    depth = -0.5 * (rod.position(-1)[:-1:2, 2] + rod.position(-1)[2::2, 2])
    np.testing.assert_allclose(rod.effective_tension(-1) - rod.wall_tension(-1), 9810 * depth * np.pi * 0.025**2, rtol=0.02, atol=0.5)
    assert rod.describe("bending_curvature").dimension == "angle/length"
    assert np.median(rod.bed_force(0)[2:18, 2]) == pytest.approx((10 - 1000 * np.pi * 0.025**2) * 9.81, rel=0.05)


def test_ranges(line):
    rod = line.rod("line")
    timed = line.frames.time >= 0
    tensions = rod.effective_tension(slice(None))[timed]
    found = rod.range("effective_tension")
    np.testing.assert_array_equal(found.largest, tensions.max(axis=0))
    np.testing.assert_array_equal(found.time_of_least, line.frames.time[timed][tensions.argmin(axis=0)])
    np.testing.assert_allclose(rod.range("effective_tension", stage="sway").mean, tensions.mean(axis=0), rtol=1e-14)
    assert rod.range("moment/y", 0.5, 1.0).window == (0.5, 1.0)
    assert rod.range("bed_force").least.min() == 0.0 and len(rod.range("bed_force").arc_length) == 41
    assert "effective_tension of rod line" in repr(found)
    with pytest.raises(gxrod.Error, match="there is no component 'w'"):
        rod.range("moment/w")
    with pytest.raises(ValueError, match="nothing was written from 5 to 6"):
        rod.range("moment", 5, 6)
    with pytest.raises(gxrod.Error, match="there is no stage 'swim'"):
        rod.range("moment", stage="swim")


def test_line_ends(line):
    table = line.line_ends()
    assert list(dict.fromkeys(table.name)) == ["line.start", "line.end", "line"]
    tension = line["line_end"].effective_tension[line.time >= 0]
    [row] = [each for each in table if (each["name"], each["quantity"]) == ("line.end", "effective_tension")]
    assert row["largest"] == tension.max() and row["time_of_largest"] == line.time[line.time >= 0][tension.argmax()]
    assert row["static"] == tension[0]
    [row] = [each for each in table if (each["name"], each["quantity"]) == ("line", "touch_down_end")]
    assert row["largest"] == line["line_ground"].touch_down_end[line.time >= 0].max()
    assert len(line.line_ends(stage="sway")) == len(table)


def test_picture(line):
    figure = line.plot("range", quantity=["effective_tension", "bed_force/z"], window=(0.5, 1.5, None))
    assert [axes.get_title(loc="left") for axes in figure.get_axes()] == ["effective tension, t = 0.5 to 1.5", "bed force z, t = 0.5 to 1.5"]
    with pytest.raises(gxrod.Error, match="there is no rod 'x'"):
        line.plot("range", rod="x")
