"""Mooring lines of MoorDyn: what is read, the deck of them, and what is said of files that are wrong."""

import re
import tomllib
from math import dist, pi, sqrt

import numpy as np
import pytest
from conftest import gxrod as run_gxrod
from gxrod import FileError
from gxrod.importers import FORMATS, find_format, read_blade, read_moordyn, write_mooring
from gxrod.importers.command import main
from gxrod.importers.moordyn_bodies import euler_rotation, rotation_by, rotation_of, rotation_vector_of
from gxrod.importers.mooring_rest import find_rest
from imported import edit

# A chain and a cable meet at a buoy; a second chain goes to the vessel directly.
LINES = """--------------------- MoorDyn Input File ------------------------------------
Two lines and a buoy
----------------------- LINE TYPES ------------------------------------------
TypeName   Diam    Mass/m     EA         BA/-zeta    EI         Cd     Ca     CdAx    CaAx
(name)     (m)     (kg/m)     (N)        (N-s/-)     (N-m^2)    (-)    (-)    (-)     (-)
chain      0.2     200.0      8.0e8      -1.0        0          1.37   1.0    0.64    0.5
cable-1/2  0.1     25.0       3.0e8      6.0e5       4.0e4      1.2    0.9    0.01    0.0   ! thin
---------------------- POINTS ------------------------------------------------
ID    Attachment  X       Y       Z       Mass   Volume  CdA    Ca
(#)   (word/ID)   (m)     (m)     (m)     (kg)   (m^3)   (m^2)  (-)
1     Fixed       300.0   400.0   -100.0  0      0       0      0
2     Free        60.0    80.0    -50.0   500    4       3.0    0.5
3     Vessel      0.0     0.0     -10.0   0      0       0      0
4     Anchor      -500.0  0.0     -100.0  0      0       0      0
---------------------- LINES --------------------------------------------------
ID    LineType   AttachA  AttachB  UnstrLen  NumSegs  LineOutputs
(#)   (name)     (#)      (#)      (m)       (-)      (-)
1     chain      1        2        450.0     45       p
2     cable-1/2  2        3        120.0     24       -
3     chain      4        3        540.0     54       -
# 4   chain      4        3        541.0     54       -
---------------------- OPTIONS ------------------------------------------------
0.001     dtM        time step
1.0e5     kbot       bottom stiffness (Pa/m)
2.0e4     cBot       bottom damping (Pa-s/m)
1030      WtrDnsty   water density (kg/m^3)
100       WtrDpth    water depth (m)
9.81      g          gravity
0.4       FrictionCoefficient
10.0      TmaxIC     of the start
------------------------- need this line --------------------------------------
"""


NOT_USED = "not used, for MoorDyn's time steps, its way to the start and its output: dtM, TmaxIC"


@pytest.fixture
def lines(tmp_path):
    path = tmp_path / "lines.txt"
    path.write_text(LINES)
    return path


def deck_of(path):
    written, *_ = write_mooring(read_moordyn(path), path.with_suffix(".toml"))
    return tomllib.loads(written.read_text())


def supports_of(deck, at):
    return [each for each in deck["support"] if each["at"] == at]


def test_types_points_lines_and_options_are_read(lines):
    mooring = read_moordyn(lines)
    chain, cable = mooring.types
    assert (chain.name, chain.diameter, chain.mass, chain.EA, chain.EI, chain.damping) == ("chain", 0.2, 200.0, 8e8, 0.0, 0.0)
    assert (chain.drag, chain.added_mass) == ((1.37, 0.64), (1.0, 0.5))
    assert (cable.EI, cable.damping, cable.drag, cable.added_mass) == (4e4, 6e5, (1.2, 0.01), (0.9, 0.0))
    assert [line.length for line in mooring.lines] == [450.0, 120.0, 540.0]
    assert [[place.kind for place in line.ends] for line in mooring.lines] == [["fixed", "free"], ["free", "coupled"], ["fixed", "coupled"]]
    assert mooring.lines[2].ends[0].at == (-500.0, 0.0, -100.0)
    buoy = mooring.lines[0].ends[1]
    assert (buoy.mass, buoy.volume, buoy.drag_area, buoy.added_mass) == (500.0, 4.0, 3.0, 0.5)
    assert (mooring.gravity, mooring.density, mooring.depth, mooring.friction) == (9.81, 1030.0, 100.0, 0.4)
    assert (mooring.ground_stiffness, mooring.ground_damping) == (1e5, 2e4)
    assert mooring.title == "Two lines and a buoy"
    assert mooring.notes == [NOT_USED, "damping by a ratio (BA/-zeta below 0) was left out: it damps the segments of MoorDyn's mesh"]
    assert mooring.warnings == []


def test_without_options_moordyns_defaults_hold(lines):
    text = lines.read_text()
    lines.write_text(text[: text.index("---------------------- OPTIONS")])
    mooring = read_moordyn(lines)
    assert (mooring.density, mooring.ground_stiffness, mooring.ground_damping, mooring.friction) == (1025.0, 3e6, 3e5, 0.0)
    assert mooring.depth == 100.0  # that of the deepest point
    assert "friction" not in deck_of(lines)["seabed"]


def test_the_deck_has_water_ground_and_sections(lines):
    deck = deck_of(lines)
    assert deck["gravity"] == [0, 0, -9.81]
    assert deck["fluid"] == {"density": 1030, "surface": 0}
    assert deck["seabed"] == {"z": -100.1, "stiffness": 1e5, "damping": 2e4, "friction": 0.4}
    cable = deck["section"]["cable-1_2"]
    assert cable["fluid"] == {"outer_diameter": 0.1, "drag": {"normal": 1.2, "tangential": 0.01}, "added_mass": {"normal": 0.9, "tangential": 0}}
    assert (cable["stiffness"]["EA"], cable["stiffness"]["EIy"], cable["stiffness"]["EIz"]) == (3e8, 4e4, 4e4)
    # A solid rod: EI/GJ = E I/(G 2 I), EA/GA = E/G, with E/G = 2.6.
    assert cable["stiffness"]["EIy"] / cable["stiffness"]["GJ"] == pytest.approx(1.3, rel=1e-5)
    assert cable["stiffness"]["EA"] / cable["stiffness"]["GAy"] == pytest.approx(2.6, rel=1e-5)
    assert cable["inertia"]["rhoA"] == 25.0
    assert cable["inertia"]["rhoIy"] == pytest.approx(25.0 / (pi * 0.05**2) * pi * 0.05**4 / 4, rel=1e-5)
    assert cable["damping"]["kelvin_voigt"] == [2e-3, 0, 0, 0, 0, 0]
    assert "damping" not in deck["section"]["chain"]


def test_a_line_without_bending_stiffness_gets_a_small_one(lines):
    chain = deck_of(lines)["section"]["chain"]["stiffness"]
    weight = 9.81 * (200.0 - 1030.0 * pi * 0.1**2)
    assert sqrt(chain["EIy"] / (weight * 540.0 / 2.0)) == pytest.approx(0.1 * 10.0, rel=1e-5)
    assert chain["EIy"] <= 8e8 * 0.2**2 / 16
    assert "EI is 0 in the file" in lines.with_suffix(".toml").read_text()
    edit(lines, "450.0     45", "450.0     1")
    edit(lines, "540.0     54", "540.0     1")
    assert deck_of(lines)["section"]["chain"]["stiffness"]["EIy"] == pytest.approx(8e8 * 0.2**2 / 16)


def test_lines_hang_between_points_and_meet_in_free_ones(lines):
    deck = deck_of(lines)
    assert deck["rod"]["line1"] == {"section": "chain", "catenary": {"from": [300, 400, -100], "to": [60, 80, -50], "length": 450, "bed": True}, "elements": 45}
    assert deck["joint"] == {"line2_A": {"type": "ball", "between": ["line1.end", "line2.start"]}} and "connect" not in deck
    assert deck["body"]["point2"] == {"at": "line1.end", "mass": 500, "fluid": {"volume": 4, "drag_area": [3, 3, 3], "added_mass": [2060, 2060, 2060]}}
    assert [each["fix"] for each in supports_of(deck, "line3.end")] == ["position"]
    assert not supports_of(deck, "line1.end") and not supports_of(deck, "line2.start")
    hang, move = deck["stage"]
    assert (hang["kind"], hang["steps"], move["kind"]) == ("static", 1, "dynamic")
    assert {each["at"] for each in deck["history"]} == {f"line{i}.{end}" for i in (1, 2, 3) for end in ("start", "end")}


def hinges_of(deck):
    return [each for each in deck["support"] if "rx" in each.get("fix", "")]


def test_a_hinge_keeps_each_line_from_spinning(lines):
    deck = deck_of(lines)
    assert [(each["at"], each["fix"]) for each in hinges_of(deck)] == [(at, ["position", "rx", "rz"]) for at in ("line1.start", "line2.end", "line3.start")]
    axes = np.array(hinges_of(deck)[0]["axes"])
    assert np.allclose(axes, [[-0.6, -0.8, 0], [0.8, -0.6, 0], [0, 0, 1]])
    assert np.allclose(axes @ axes.T, np.eye(3)) and np.linalg.det(axes) == pytest.approx(1.0)


def test_a_line_between_free_points_is_kept_by_a_corner(lines):
    edit(lines, "3     Vessel ", "3     Free   ")
    deck = deck_of(lines)  # line 2 is between the points 2 and 3, which are free
    assert deck["connect"] == [{"points": ["line1.end", "line2.start"]}]
    assert deck["joint"] == {"line3_B": {"type": "ball", "between": ["line2.end", "line3.end"]}}
    assert [each["at"] for each in hinges_of(deck)] == ["line1.start", "line3.start"]
    assert "rigid corners" in lines.with_suffix(".toml").read_text()


def test_a_buoy_without_mass_gets_a_little(lines):
    edit(lines, "500    4 ", "0      4 ")
    assert deck_of(lines)["body"]["point2"]["mass"] == pytest.approx(1e-3 * 1030 * 4)
    edit(lines, "0      4       3.0    0.5", "0      0       0      0")
    assert "body" not in deck_of(lines)


def test_a_taut_line_is_pulled_to_its_place(lines):
    edit(lines, "540.0     54", "500.0     50")
    deck = deck_of(lines)
    start, end = (np.array(deck["rod"]["line3"]["line"][key]) for key in ("from", "to"))
    assert np.array_equal(start, [-500, 0, -100])
    assert np.linalg.norm(end - start) == pytest.approx(500.0, rel=1e-11)
    [held] = supports_of(deck, "line3.end")
    assert "fix" not in held
    assert np.allclose(end + [held["move"][axis] for axis in "xyz"], [0, 0, -10], atol=1e-8)
    assert deck["stage"][0]["steps"] == 10


def test_a_taut_line_can_be_pulled_by_its_hinge(lines):
    edit(lines, "1     Fixed       300.0   400.0   -100.0", "1     Free        -700.0  100.0   -100.0")
    edit(lines, "2     Free        60.0    80.0    -50.0", "2     Coupled     -300.0  400.0   -100.0")
    edit(lines, "1        2        450.0", "1        2        300.0")
    deck = deck_of(lines)
    [held] = supports_of(deck, "line1.end")
    assert held["fix"] == ["position", "rx", "rz"] and "move" not in held  # the free end is where it is straight
    assert np.allclose(deck["rod"]["line1"]["line"]["to"], [-300, 400, -100])


def test_free_points_start_where_no_line_is_taut(lines):
    edit(lines, "450.0     45", "395.0     38")
    mooring = read_moordyn(lines)
    assert any(line.length < dist(*(place.at for place in line.ends)) for line in mooring.lines)
    deck = deck_of(lines)
    for name in ("line1", "line2"):
        hangs = deck["rod"][name]["catenary"]
        assert dist(hangs["from"], hangs["to"]) < 0.9991 * hangs["length"]
    assert deck["rod"]["line1"]["catenary"]["from"] == [300, 400, -100]
    assert deck["rod"]["line1"]["catenary"]["to"] == deck["rod"]["line2"]["catenary"]["from"]
    assert "free points and bodies start where no line is taut" in lines.with_suffix(".toml").read_text()
    edit(lines, "395.0     38", "100.0     38")
    with pytest.raises(FileError, match="too short to reach"):
        write_mooring(read_moordyn(lines), lines.with_suffix(".toml"))


RODS = """---------------------- ROD TYPES ------------------------------------
TypeName Diam Mass/m Cd Ca CdEnd CaEnd
(name) (m) (kg/m) (-) (-) (-) (-)
stub 0.1 25 1 1 1 1
---------------------- BODIES ------------------------------------
ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*
(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1 Free 10 0 -20 0 0 0 100 0 1 0.1 0 0
---------------------- RODS ------------------------------------
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs
(#) (name) (#/key) (m) (m) (m) (m) (m) (m) (-) (-)
1 stub Body1 1 0 0 -1 0 0 1 -
2 stub Free 60 80 -50 60 80 -50 0 -
"""


def put_bodies(lines, body="Free"):
    """Line 1 ends on the free rod without length, with line 2, which ends on the body's rod; line 3 on a point of the body."""
    edit(lines, "---------------------- POINTS", RODS.replace("1 Free 10", f"1 {body} 10") + "---------------------- POINTS")
    edit(lines, "3     Vessel      0.0     0.0     -10.0", "3     Body1       0.0     2.0     -1.0 ")
    edit(lines, "1     chain      1        2 ", "1     chain      1        R2A ")
    edit(lines, "2     cable-1/2  2        3 ", "2     cable-1/2  R2B      R1A ")


def test_lines_on_coupled_bodies_of_moordyn_are_held(lines):
    put_bodies(lines, "Coupled")
    deck = deck_of(lines)
    assert deck["rod"]["line2"]["catenary"]["to"] == [11, 0, -20]
    assert deck["rod"]["line3"]["catenary"]["to"] == [10, 2, -21]
    assert [each["fix"] for each in supports_of(deck, "line2.end")] == ["all"]
    assert [each["fix"] for each in supports_of(deck, "line3.end")] == ["position"]
    assert deck["connect"] == [{"points": ["line1.end", "line2.start"]}]  # by the free rod without length
    assert [each["at"] for each in hinges_of(deck)] == ["line3.start"]  # the clamped end keeps the two others from spinning
    assert "body" not in deck and [each["name"] for each in deck["stage"]] == ["hang", "move"]
    text = " ".join([*read_moordyn(lines).notes, *read_moordyn(lines).warnings])
    assert "body 1 of MoorDyn was left out" in text and "rod 1 of MoorDyn was left out" in text and "rod 2" not in text
    edit(lines, "1 Coupled 10 0 -20 0 0 0", "1 Coupled 10 0 -20 0 0 5")
    yaw = np.radians(5.0)
    assert np.allclose(deck_of(lines)["rod"]["line2"]["catenary"]["to"], [10 + np.cos(yaw), np.sin(yaw), -20])


def test_a_body_turns_about_x_then_y_then_z_with_it(lines):
    # By MoorDyn 2.7.2, MoorDyn_GetPointPos: the point (1, 2, 3) of a body with the angles 30, 40, 50 is there.
    put_bodies(lines, "Fixed")
    edit(lines, "1 Fixed 10 0 -20 0 0 0", "1 Fixed 10 0 -20 30 40 50")
    edit(lines, "3     Body1       0.0     2.0     -1.0 ", "3     Body1       1.0     2.0     3.0 ")
    assert np.allclose(deck_of(lines)["rod"]["line3"]["catenary"]["to"], [10 + 1.24711853, 0.34187216, -20 + 3.51109937], atol=1e-7)


def test_a_free_body_can_be_turned(lines):
    put_bodies(lines)
    edit(lines, "100 0 1 0.1 0 0", "100 0.5 1|2|3 0.1 0.4|7 0.5")
    edit(lines, "2.0     -1.0    0      0       0      0", "2.0     -1.0    50     0.02    0.3    1")
    [straight] = read_moordyn(lines).bodies
    edit(lines, "1 Free 10 0 -20 0 0 0", "1 Free 10 0 -20 30 40 50")
    mooring = read_moordyn(lines)
    [turned] = mooring.bodies
    for key in ("mass", "inertia", "centre_of_mass", "volume", "drag_area", "added_mass"):  # in its own axes
        assert np.allclose(getattr(turned, key), getattr(straight, key))
    axes = euler_rotation(*np.radians([30, 40, 50]))
    assert np.allclose(rotation_of(turned), axes)
    point = next(place for line in mooring.lines for place in line.ends if place.name == "point3")
    assert np.allclose(point.at, np.array([10, 0, -20]) + axes @ [0, 2, -1])
    assert np.allclose(deck_of(lines)["body"]["body1"]["rotation_vector"], turned.rotation_vector)


@pytest.mark.parametrize("angles", [(0, 0, 0), (180, 0, 0), (0, 180, 0), (0, 0, 180), (120, -70, 200), (0, 0, 1e-9)])
def test_rotation_vectors_give_the_rotation_again(angles):
    axes = euler_rotation(*np.radians(angles))
    vector = np.array(rotation_vector_of(axes))
    assert np.allclose(rotation_by(vector), axes, atol=1e-12) and np.linalg.norm(vector) <= pi + 1e-9


def test_a_free_body_has_what_is_fixed_to_it(lines):
    put_bodies(lines)
    edit(lines, "100 0 1 0.1 0 0", "100 0.5 1|2|3 0.1 0.4|7 0.5")
    edit(lines, "2.0     -1.0    0      0       0      0", "2.0     -1.0    50     0.02    0.3    1")
    [body] = read_moordyn(lines).bodies
    rod, weight = 25.0 * 2.0, 50.0
    assert body.mass == 100.0 + rod + weight
    centre = np.array([0.0, 2.0 * weight, 0.5 * 100.0 - 1.0 * weight]) / body.mass
    assert np.allclose(body.centre_of_mass, centre)
    inertia = np.zeros(3)  # about the body's point, then about the centre
    for mass, (x, y, z), own in ((100.0, (0, 0, 0.5), (1, 2, 3)), (weight, (0, 2, -1), (0, 0, 0)),
                                 (rod, (0, 0, 0), (rod * 0.1**2 / 8, *[rod * (2.0**2 / 12 + 0.1**2 / 16)] * 2))):
        inertia += np.array(own) + mass * np.array([y * y + z * z, x * x + z * z, x * x + y * y])
    x, y, z = centre
    assert np.allclose(body.inertia, inertia - body.mass * np.array([y * y + z * z, x * x + z * z, x * x + y * y]))
    volume = pi / 4 * 0.1**2 * 2.0
    assert body.volume == pytest.approx(0.1 + 0.02 + volume)
    assert np.allclose(body.drag_area, [0.4 + 0.3 + pi / 4 * 0.1**2, 0.4 + 0.3 + 0.2, 0.4 + 0.3 + 0.2])
    caps = 1030.0 * 4 / 3 * pi * 0.05**3
    assert np.allclose(body.added_mass, np.array([caps, 1030 * volume, 1030 * volume]) + 0.5 * 1030 * 0.1 + 1030 * 0.02)
    assert "drag that resists turns was left out, of body 1 (the numbers of CdA for rotations)" in read_moordyn(lines).warnings


def test_lines_are_fixed_to_free_bodies_or_turn_on_them(lines):
    put_bodies(lines)
    deck = deck_of(lines)
    assert deck["joint"]["line2_B"] == {"type": "weld", "between": ["body1", "line2.end"], "at": deck["rod"]["line2"]["catenary"]["to"]}
    assert deck["joint"]["line3_B"] == {"type": "ball", "between": ["body1", "line3.end"], "at": deck["rod"]["line3"]["catenary"]["to"]}
    at = np.array(deck["body"]["body1"]["at"])
    assert np.allclose(np.array(deck["joint"]["line2_B"]["at"]) - at, [1, 0, 0]) and np.allclose(np.array(deck["joint"]["line3_B"]["at"]) - at, [0, 2, -1])
    assert [each["at"] for each in hinges_of(deck)] == ["line1.start", "line3.start"]
    assert [(each["at"], each["fix"]) for each in deck["support"] if each.get("stages") == "hang"] == [("line1.end", "position"), ("body1", "position")]
    assert [each["name"] for each in deck["stage"]] == ["hang", "free", "move"]
    mooring = read_moordyn(lines)
    assert "left out" not in " ".join(mooring.notes).replace("damping by a ratio (BA/-zeta below 0) was left out", "")
    assert mooring.warnings == ["free points and bodies without lines were left out: point2"]


def test_a_free_rod_is_a_body_along_it(lines):
    put_bodies(lines)
    edit(lines, "2 stub Free 60 80 -50 60 80 -50 0 -", "2 stub Free 60 80 -50 60 80 -53 3 -")
    rod = next(body for body in read_moordyn(lines).bodies if body.name == "rod2")
    assert (rod.at, rod.mass) == ((60, 80, -51.5), 75.0)
    assert np.allclose(rod.rotation_vector, [0, pi / 2, 0])  # x comes to point down
    assert np.allclose(rod.inertia, [75 * 0.1**2 / 8, *[75 * (9 / 12 + 0.1**2 / 16)] * 2])
    assert np.allclose(rod.drag_area, [pi / 4 * 0.1**2, 0.3, 0.3])
    edit(lines, "2 stub Free", "2 pole Free")
    with pytest.raises(FileError, match=r'lines.txt:\d+: there is no rod type "pole"; give one of stub'):
        read_moordyn(lines)


def test_a_body_that_hangs_on_one_point_does_not_turn(lines):
    put_bodies(lines)
    edit(lines, "R2B      R1A ", "R2B      3   ")
    assert [each["fix"] for each in supports_of(deck_of(lines), "body1")] == ["position", ["rx", "ry", "rz"]]


# A weight between two light lines, and a float on a third.
REST = """---------------------- LINE TYPES ------------------------------------------
TypeName   Diam    Mass/m     EA         BA/-zeta    EI         Cd     Ca     CdAx    CaAx
(name)     (m)     (kg/m)     (N)        (N-s/-)     (N-m^2)    (-)    (-)    (-)     (-)
cord       0.01    0.0786     1.0e8      0           1.0        1.2    1.0    0.0     0.0
---------------------- BODIES ------------------------------------
ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*
1  Free       5  3 -20 0 0 0 500 0 10 0.1 0 0
2  Free       70 2 -40 0 0 0 100 0 10 0.6 0 0
---------------------- POINTS ------------------------------------------------
ID    Attachment  X       Y       Z       Mass   Volume  CdA    Ca
1     Fixed       -40.0   0.0     -10.0   0      0       0      0
2     Fixed       40.0    0.0     -10.0   0      0       0      0
3     Body1       0.0     0.0     0.0     0      0       0      0
4     Fixed       75.0    0.0     -100.0  0      0       0      0
5     Body2       0.0     0.0     0.0     0      0       0      0
---------------------- LINES --------------------------------------------------
ID    LineType   AttachA  AttachB  UnstrLen  NumSegs  LineOutputs
1     cord       1        3        50.0      10       -
2     cord       3        2        50.0      10       -
3     cord       4        5        60.0      12       -
---------------------- OPTIONS ------------------------------------------------
1000      WtrDnsty
110       WtrDpth
------------------------- need this line --------------------------------------
"""


def test_free_bodies_start_where_they_rest(lines):
    lines.write_text(REST)
    places = find_rest(read_moordyn(lines), {"body1", "body2"})
    assert np.allclose(places["body1"], [0, 0, -10 - sqrt(50**2 - 40**2)], atol=0.1)  # the lines stretch by some thousandths
    assert np.allclose(places["body2"], [75, 0, -40], atol=0.1)
    deck = deck_of(lines)
    assert np.allclose(deck["body"]["body2"]["at"], [75, 0, -40], atol=0.1)
    assert "line" in deck["rod"]["line3"]  # upright, so straight


# riser.txt of MoorDyn's tests; BSD 3-Clause License, Copyright (c) 2022, Matt Hall.
RISER = """riser
------------------------- LINE TYPES --------------------------------------------------
LineType  Diam    MassDenInAir    EA       BA/-zeta    EI    Can   Cat  Cdn   Cdt
(-)       (m)       (kg/m)        (N)      (Pa-s/-)  (n-m^2) (-)   (-)  (-)   (-)
cable     0.116      25         362e6      -1.0      38e3    1.0   0.0  1.1   0.008
bouyancy  0.361      59         362e6      -1.0      38e3    1.0  0.469 2.617 0.345
nylon     0.116      25         362e6      -1.0      38e3    1.0   0.0  1.1   0.008
---------------------- ROD TYPES ------------------------------------
TypeName      Diam     Mass/m    Cd     Ca      CdEnd    CaEnd
(name)        (m)      (kg/m)    (-)    (-)     (-)      (-)
conn          0.116    25        1.1    1.0     1.1      1.0
conn_stiff    0.116    25        1.1    1.0     1.1      1.0
clamp         0.116    25        1.2    1.0     1.2      1.0
---------------------------- BODIES -----------------------------------------------------
ID   Attachment  X0     Y0    Z0      r0      p0     y0     Mass  CG*   I*        Volume  CdA*     Ca
(#)     (-)      (m)    (m)   (m)     (deg)   (deg)  (deg)  (kg)  (m)   (kg-m^2)  (m^3)   (m^2)    (-)
1      Free      452.0   0    -313.0  0       0      0      29.5   0    0.098     0.014   0.5|0.5  1.0
---------------------- RODS ----------------------------------------
ID   RodType  Attachment  Xa    Ya    Za     Xb     Yb    Zb      NumSegs  RodOutputs
(#)  (name)    (#/key)    (m)   (m)   (m)    (m)    (m)   (m)     (-)       (-)
1    clamp       Body1    0.1   0     0.0    -0.1   0     0.0     1         -
2    conn        Free     375.0 0     -250.0 375.0  0     -250.0  0         -
3    conn        Free     290.0 0     -215.0 290.0  0     -215.0  0         -
----------------------- POINTS ----------------------------------------------
Node      Type      X        Y         Z        M        V         CdA   CA
(-)       (-)      (m)      (m)       (m)      (kg)     (m^3)     (m^2)  (-)
1         Fixed    600.0     0      -320.0       0        0          0     0
2         Fixed    452.0     0      -320.0       0        0          0     0
3         Body1    0.0       0         0.0       0        0          0     0
4         Coupled  0.0       0       -63.6       0        0          0     0
-------------------------- LINES -------------------------------------------------
Line     LineType NodeA     NodeB  UnstrLen   NumSegs     Flags/Outputs
(-)      (-)       (-)       (-)    (m)         (-)          (-)
1        nylon       2         3      7.0        1           -
2        cable       1       R1A    150.0       15           -
3        cable     R1B       R2A    110.0       11           -
4      bouyancy    R2B       R3A     80.0        8           -
5        cable     R3B         4    340.0       34           -
--------------------------- SOLVER OPTIONS ------------------------------------
3.0e6      kb           - bottom stiffness
3.0e5      cb           - bottom damping
320        WtrDpth      - water depth
--------------------------- need this line ------------------------------------
"""


def test_a_lazy_wave_riser_runs_at_once(lines):
    h5py = pytest.importorskip("h5py")
    lines.write_text(RISER)
    deck = deck_of(lines)
    ends = [np.array(deck["rod"]["line4"]["line"][key]) for key in ("from", "to")]
    assert np.linalg.norm(ends[1] - ends[0]) == pytest.approx(80.0, rel=1e-8)  # it floats
    lines.with_suffix(".toml").write_text(lines.with_suffix(".toml").read_text().replace("end_time   = 60", "end_time   = 1"))
    run_gxrod("run", "lines.toml", "--quiet", folder=lines.parent)
    with h5py.File(lines.parent / "lines.vtkhdf") as file:
        at_rest = file["histories/line5_B/effective_tension"][-1]
        assert at_rest == pytest.approx(60060.0, rel=5e-3)  # that of MoorDyn with ever finer segments
        body = file["histories/body1/position"][-1]
        assert np.allclose(body, [450.43, 0.0, -313.18], atol=0.05) and np.linalg.norm(body - deck["body"]["body1"]["at"]) < 0.2


def test_what_is_left_out_is_said(lines):
    edit(lines, "8.0e8      -1.0", "8.0e8|1e9  -1.0|9")
    edit(lines, "0.4       Fric", "1 WaveKin\n2 Currents\nbed.txt WtrDpth\n0.4       Fric")
    edit(lines, "---------------------- OPTIONS", "---------------------- FAILURE\nID Point\n1 2\n---------------------- OPTIONS")
    text = "\n".join(read_moordyn(lines).warnings)
    for words in ("the static one", "waves were left out", "currents were left out", "ground by the file bed.txt", "the section FAILURE was left out"):
        assert words in text
    write_mooring(read_moordyn(lines), lines.with_suffix(".toml"))
    assert "the section FAILURE was left out" in lines.with_suffix(".toml").read_text()
    assert read_moordyn(lines).types[0].EA == 8e8


def test_options_that_nobody_knows_are_warned_of(lines):
    edit(lines, "1030      WtrDnsty", "1030      WtrDens")
    edit(lines, "10.0      TmaxIC", "7 foo\n7 FOO\n2.0 StatDynFricScale\n1 StatDynFricScale\nlost\n10.0      TmaxIC")
    mooring = read_moordyn(lines)
    assert mooring.density == 1025.0  # as in MoorDyn, which does not know WtrDens
    assert mooring.warnings == ["friction has one coefficient here, at rest and sliding (option StatDynFricScale is 2.0)", 'line 34 of the options, "lost", names no option and was not used',
                                "the option WtrDens is unknown and was not used; is WtrDnsty meant?", "the option foo is unknown and was not used"]
    write_mooring(mooring, lines.with_suffix(".toml"))
    assert "# warning: the option WtrDens is unknown" in lines.with_suffix(".toml").read_text()


def test_what_no_line_holds_is_warned_of(lines):
    edit(lines, "4     Anchor      -500.0  0.0     -100.0  0 ", "5     Free        7.0     0.0     -10.0   9      0       0      0\n4     Anchor      -500.0  0.0     -100.0  3 ")
    mooring = read_moordyn(lines)
    assert "free points and bodies without lines were left out: point5" in mooring.warnings
    assert "mass, volume and drag of points that are held were left out; no line feels them: point4" in mooring.notes


def is_taken(path):
    path.with_suffix(".toml").unlink(missing_ok=True)
    deck = deck_of(path)
    run_gxrod("check", "lines.toml", folder=path.parent)
    return deck


def test_a_clump_weight_without_volume_makes_a_deck(lines):
    edit(lines, "450.0     45", "440.0     44")
    edit(lines, "500    4       3.0    0.5", "5000   0       0      0")
    assert is_taken(lines)["body"]["point2"] == {"at": "line1.end", "mass": 5000}
    edit(lines, "5000   0       0      0", "5000   0       3.0    0")
    assert is_taken(lines)["body"]["point2"]["fluid"]["height"] == pytest.approx(2 * sqrt(3 / pi), rel=1e-5)


@pytest.mark.parametrize("density", ["0", "1030"])
@pytest.mark.parametrize("stiffness", ["0", "1e5"])
def test_without_water_or_ground_there_is_a_deck(density, stiffness, lines):
    edit(lines, "450.0     45", "440.0     44")
    edit(lines, "1030      WtrDnsty", f"{density}      WtrDnsty")
    edit(lines, "1.0e5     kbot", f"{stiffness}     kbot")
    deck = is_taken(lines)
    assert ("fluid" in deck, "seabed" in deck) == (density != "0", stiffness != "0")
    assert ("kBot is 0" in " ".join(read_moordyn(lines).warnings)) == (stiffness == "0")
    assert deck["rod"]["line1"]["catenary"].get("bed", False) == (stiffness != "0")


HEIGHTS = "2 3\n-600 600\n-500 0 500\n" + "".join(f"{x} {y} {-110 + 0.01 * x + 0.02 * y}\n" for y in (500, 0, -500) for x in (-600, 600))
DEPTHS = "--- bathymetry\nnGridX 2\nnGridY 3\n -600 600\n" + "".join(f"{y} {116 - 0.02 * y} {104 - 0.02 * y}\n" for y in (-500, 0, 500))


@pytest.mark.parametrize("text, option", [(HEIGHTS, "SeafloorFile"), (DEPTHS, "WtrDpth")])
def test_a_ground_by_a_file_is_a_grid(text, option, lines):
    edit(lines, "450.0     45", "440.0     44")
    edit(lines, "100       WtrDpth", f"grounds/bed.txt       {option}")
    (lines.parent / "grounds").mkdir()
    (lines.parent / "grounds" / "bed.txt").write_text(text)
    deck = is_taken(lines)
    assert deck["seabed"]["grid"] == {"file": "lines_seabed.csv"} and "z" not in deck["seabed"]
    heights = np.loadtxt(lines.with_name("lines_seabed.csv"), delimiter=",")
    assert len(heights) == 6 and np.allclose(heights[:, 2], -110 + 0.01 * heights[:, 0] + 0.02 * heights[:, 1] - 0.1)
    assert "bed" not in deck["rod"]["line1"]["catenary"] and deck["stage"][0]["steps"] == 10
    assert read_moordyn(lines).warnings == []


GROUND_FAULTS = [
    ("2 3\n", "1 3\n", "bed.txt:2: expected 1 number"),
    ("600 500 -94.0\n", "", "there is no height at x = 600, y = 500"),
    ("-500 0 500\n", "-500 500 0\n", "the places y of the grid do not increase"),
    ("600 500 -94.0\n", "600 500\n", "expected 3 numbers"),
]


@pytest.mark.parametrize("old, new, message", GROUND_FAULTS)
def test_faults_of_a_ground_by_a_file(old, new, message, lines):
    edit(lines, "100       WtrDpth", "bed.txt       SeafloorFile")
    (lines.parent / "bed.txt").write_text(HEIGHTS)
    edit(lines.parent / "bed.txt", old, new)
    with pytest.raises(FileError, match=re.escape(message)):
        read_moordyn(lines)


def test_types_whose_names_differ_in_signs_alone_are_two_sections(lines):
    edit(lines, "cable-1/2  0.1     25.0 ", "cable-1/2  0.1     25.0 ")
    edit(lines, "chain      0.2     200.0", "cable-1:2  0.2     200.0")
    lines.write_text(lines.read_text().replace("1     chain ", "1     cable-1:2 ").replace("3     chain ", "3     cable-1:2 "))
    deck = deck_of(lines)
    assert sorted(deck["section"]) == ["cable-1_2", "cable-1_2_"] and deck["rod"]["line2"]["section"] == "cable-1_2_"


def test_a_line_that_would_lie_loosely_hangs_through_the_ground_at_first(lines):
    edit(lines, "450.0     45", "440.0     44")
    edit(lines, "540.0     54", "640.0     64")
    deck = is_taken(lines)
    assert "bed" not in deck["rod"]["line3"]["catenary"] and deck["rod"]["line1"]["catenary"]["bed"]
    assert deck["stage"][0]["steps"] == 10


def test_a_line_that_would_hang_double_is_refused(lines):
    edit(lines, "4     Anchor      -500.0  0.0     -100.0", "4     Anchor      0.0  0.0     -100.0")
    with pytest.raises(FileError, match="the ends of line3 are above each other, and its length, 540, is more than their distance, 90"):
        deck_of(lines)


def test_without_gravity_there_is_no_surface(lines):
    edit(lines, "450.0     45", "440.0     44")
    edit(lines, "9.81      g ", "0      g ")
    assert is_taken(lines)["fluid"] == {"density": 1030}


def test_columns_by_the_names_of_version_1_are_read_so(lines):
    edit(lines, "Cd     Ca     CdAx    CaAx", "Can    Cat    Cdn     Cdt")
    chain = read_moordyn(lines).types[0]
    assert (chain.drag, chain.added_mass) == ((0.64, 0.5), (1.37, 1.0))


def test_tables_of_stiffness_are_laws(lines):
    edit(lines, "8.0e8", "stretch.txt")
    table = lines.with_name("stretch.txt")
    table.write_text("Strain Tension\n(-) (N)\n0 0\n0.01 2e6\n0.03 1e7\n", encoding="utf-8")
    section = is_taken(lines)["section"]["chain"]
    assert section["law"] == {"tension_strain": {"table": [[0, 0], [0.01, 2e6], [0.03, 1e7]]}} and section["stiffness"]["EA"] == 2e8
    table.write_text("Strain Tension\n(-) (N)\n0.01 2e6\n0.03 1e7\n", encoding="utf-8")
    with pytest.raises(FileError, match=r"lines.txt:6: stretch.txt: expected two lines of a head, then rows of a strain and a tension that rise from 0 0"):
        read_moordyn(lines)


FAULTS = [
    ("LINE TYPES", "TYPES OF LINES", r"lines.txt: there is no section LINE TYPES with rows; give a whole input file of MoorDyn, version 2"),
    ("8.0e8", "stiff.txt", r'lines.txt:6: EA is neither a number nor a file of strains and tensions: "stiff.txt" is not there'),
    ("chain      0.2 ", "chain      0.0 ", r"lines.txt:6: diameter, mass and EA must be above 0"),
    ("1.37   1.0    0.64    0.5", "1.37", r"lines.txt:6: expected 8 columns or more \(Ca\), found 7; correct this line; files of MoorDyn's version 1 have others"),
    ("1     Fixed ", "1     Glued ", r'lines.txt:11: expected Fixed, Coupled, Free or a body, found "Glued"; correct this line'),
    ("1     Fixed ", "1     Body2 ", r"lines.txt:11: there is no body 2; add it"),
    ("300.0   400.0", "300.0   y", r'lines.txt:11: expected a number for the place Y, found "y"'),
    ("1     chain ", "1     rope ", r'lines.txt:18: there is no line type "rope"; give one of chain, cable-1/2'),
    ("1        2        450.0", "1        7        450.0", r'lines.txt:18: there is no point "7"; give one of 1, 2, 3, 4'),
    ("450.0     45", "450.0     4.5", r"lines.txt:18: UnstrLen must be above 0 and NumSegs a whole number"),
    ("1.0e5     kbot", "-1      kbot", r"lines.txt:24: kbot is below 0"),
    ("2     cable-1/2  2 ", "1     cable-1/2  2 ", r"lines.txt:19: the ID 1 stands in line 18, too"),
    ("1.0e5     kbot", "soft      kbot", r'lines.txt:24: expected a number for kbot, found "soft"'),
]


@pytest.mark.parametrize("old, new, message", FAULTS)
def test_faults_of_moordyn_files(old, new, message, lines):
    edit(lines, old, new)
    with pytest.raises(FileError) as caught:
        read_moordyn(lines)
    assert re.search(message, str(caught.value)), str(caught.value)


def test_the_program_writes_the_deck_and_says_what_it_left_out(lines, tmp_path, capsys):
    assert find_format(lines) == "moordyn" and "moordyn" in FORMATS
    assert main([str(lines), "-o", str(tmp_path / "out.toml")]) == 0
    printed = capsys.readouterr()
    assert printed.out.splitlines() == ["3 lines of 2 types, 1110 m (MoorDyn: lines.txt)", str(tmp_path / "out.toml")]
    assert printed.err == f"note: {NOT_USED}\nnote: damping by a ratio (BA/-zeta below 0) was left out: it damps the segments of MoorDyn's mesh\n"
    assert main([str(lines), "-o", str(tmp_path / "nowhere" / "out.toml")]) == 4
    with pytest.raises(FileError, match="has lines, not a blade; read it with read_moordyn"):
        read_blade(lines)


def test_gxrod_takes_the_deck(lines):
    edit(lines, "450.0     45", "440.0     44")  # 450 would lie loosely
    deck_of(lines)
    run_gxrod("check", "lines.toml", folder=lines.parent)
