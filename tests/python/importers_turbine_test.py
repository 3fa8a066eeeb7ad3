"""Turbines of OpenFAST: a tower and blades in one deck."""

import re
import subprocess

import blades
import conftest
import gxrod
import h5py
import numpy as np
import pytest
import turbines
from gxrod import FileError
from gxrod.importers import find_format, read_blade, read_turbine, write_deck, write_turbine
from gxrod.importers.command import main


def run(deck, *options):
    done = subprocess.run([conftest.PROGRAM, "run", deck.name, "--force", *options], cwd=deck.parent, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr + done.stdout
    return done.stdout


def frequencies(deck, key="frequency"):
    """Of its stage tones."""
    run(deck, "--until", "tones")
    with h5py.File(deck.with_suffix(".vtkhdf")) as file:
        return np.abs(file[f"stages/tones/{key}"][()])


TURNED = {"Azimuth": 30.0, "BlPitch_1": 10.0, "NacYaw": 20.0}


def elastodyn_axes():
    """ElastoDyn's axes of the turned turbine: c of the shaft, i of the coned blade 1, j of the pitched one; rows are x, y, z."""
    yaw, tilt, azimuth, cone, pitch = np.radians((20.0, -6.0, 30.0, -3.0, 10.0))
    # Nacelle d, shaft c, azimuth e, coned i, pitched j; here x downwind, y to the left, z up.
    d = np.array([[np.cos(yaw), np.sin(yaw), 0], [-np.sin(yaw), np.cos(yaw), 0], [0, 0, 1]])
    c1, c2 = np.cos(tilt) * d[0] + np.sin(tilt) * d[2], d[1]
    c3 = np.cross(c1, c2)
    e2, e3 = np.cos(azimuth) * c2 + np.sin(azimuth) * c3, -np.sin(azimuth) * c2 + np.cos(azimuth) * c3
    i1, i3 = np.cos(cone) * c1 - np.sin(cone) * e3, np.sin(cone) * c1 + np.cos(cone) * e3
    j1 = np.cos(pitch) * i1 - np.sin(pitch) * e2
    return d, np.array([c1, c2, c3]), np.array([j1, np.cross(i3, j1), i3])


def test_the_blades_stand_where_elastodyn_has_them(tmp_path):
    turbine = read_turbine(turbines.write_fst(tmp_path, **TURNED))
    _, (c1, _, _), (j1, _, i3) = elastodyn_axes()
    assert np.allclose(turbine.apex, [0, 0, 52] - 4.0 * c1, atol=1e-13)
    assert np.allclose(turbine.blade_root, turbine.apex + 2.0 * i3, atol=1e-13)
    assert np.allclose(turbine.blade_axes[:, 2], i3, atol=1e-15)
    assert np.allclose(turbine.blade_axes[:, 0], j1, atol=1e-15)


def test_a_turned_turbine_weighs_on_base_and_root_as_its_points_of_mass_do(tmp_path):
    turbine = read_turbine(turbines.write_fst(tmp_path, **TURNED, BlPitch_2=10.0, BlPitch_3=10.0, DTTorSpr=0.0))
    for each in (turbine.tower, turbine.blade):
        # So that hardly anything bends; and less stiff along, as round-off of the nodes' places times EA over the length of an element
        # is a force, of 1e-3 of the weight for EA = 1e16.
        each.stiffness[:, :3, :3] *= 1e-3
        each.stiffness[:, 3:, 3:] *= 1e3
    run(write_turbine(turbine, tmp_path / "t.toml")[-1], "--until", "weight")
    histories = gxrod.open_results(tmp_path / "t.vtkhdf").histories
    d, (c1, _, _), (j1, j2, i3) = elastodyn_axes()
    stations = sorted(blades.SECTIONS, key=lambda each: each.fraction)
    mass = moment = 0.0  # of a blade, about its root
    for a, b in zip(stations, stations[1:]):
        h = (b.fraction - a.fraction) * 20.0
        mass += (a.m + b.m) / 2 * h
        moment += h * (a.fraction * 20.0 * (a.m + b.m) / 2 + h * (a.m + 2 * b.m) / 6)
    g, apex = np.array([0, 0, -9.80665]), np.array([0, 0, 52.0]) - 4.0 * c1
    # All blades together have their centre on the shaft.
    along = (2.0 * mass + moment) * (i3 @ c1)
    first = 5000.0 * (np.array([0, 0, 40.0]) + np.array([1.0, 0.25, 1.5]) @ d) + 900.0 * (apex + 0.5 * c1 - [0, 0, 10.0]) + 3 * (mass * (apex - [0, 0, 10.0]) + along * c1)
    assert np.allclose(histories["tower_base"]["moment_spatial"][-1], np.cross(first, g), atol=1e-4 * np.linalg.norm(np.cross(first, g)))
    turn = np.radians(-5.0)  # a structural twist of 5 degrees
    section = np.array([i3, np.cos(turn) * j1 + np.sin(turn) * j2, np.cos(turn) * j2 - np.sin(turn) * j1])
    for number in (1, 2, 3):
        assert np.linalg.norm(histories[f"root_{number}"]["force"][-1]) == pytest.approx(mass * 9.80665, rel=1e-8)
    assert np.allclose(histories["root_1"]["force"][-1], section @ (mass * g), atol=1e-4 * mass * 9.8)
    assert np.allclose(histories["root_1"]["moment"][-1], section @ np.cross(moment * i3, g), atol=1e-4 * moment * 9.8)


def test_masses(tmp_path):
    turbine = read_turbine(turbines.write_turbine(tmp_path, YawBrMass=70.0, TipMass_1=30.0, TipMass_2=30.0, TipMass_3=30.0))
    deck = write_turbine(turbine, tmp_path / "t.toml")[-1]
    stations = sorted(blades.SECTIONS, key=lambda each: each.fraction)
    of_blade = sum((a.m + b.m) / 2 * (b.fraction - a.fraction) * 20.0 for a, b in zip(stations, stations[1:]))
    wanted = 300.0 * 40.0 + 5000.0 + 900.0 + 70.0 + 3 * (of_blade + 30.0)
    assert turbine.total_mass == pytest.approx(wanted, rel=1e-14)
    run(deck, "--until", "weight")
    base = gxrod.open_results(tmp_path / "t.vtkhdf").histories["tower_base"]["force_spatial"][-1, 2]
    assert abs(base) == pytest.approx(wanted * 9.80665, rel=1e-6)


def beam_on(turbine, elements=40):
    """The first circular frequency of a tower with a rigid rotor and nacelle: Euler-Bernoulli elements in numpy, fore-aft."""
    length, rows = turbine.tower.length, np.array(turbines.TOWER)
    h = length / elements
    K, M = np.zeros((2, 2 * elements + 2, 2 * elements + 2))
    for e in range(elements):
        m, stiffness = (np.interp((e + 0.5) / elements, rows[:, 0], rows[:, column]) for column in (1, 2))
        k = stiffness / h**3 * np.array([[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h], [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]])
        inertia = m * h / 420 * np.array([[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h], [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]])
        K[2 * e:2 * e + 4, 2 * e:2 * e + 4] += k
        M[2 * e:2 * e + 4, 2 * e:2 * e + 4] += inertia
    M[-2:, -2:] += on_top(turbine)
    flexibility, shape = np.linalg.inv(K[2:, 2:]), np.ones(2 * elements)
    for _ in range(30):  # the second frequency is five times the first
        shape = flexibility @ M[2:, 2:] @ shape
        shape /= np.max(np.abs(shape))
    return np.sqrt(shape @ K[2:, 2:] @ shape / (shape @ M[2:, 2:] @ shape))


def on_top(turbine):
    """Inertia 2×2 of nacelle, hub and blades against the tower top's displacement downwind and its turn about y, from points of mass along the blades."""
    nacelle = turbine.nacelle_inertia - turbine.nacelle_mass * (turbine.nacelle_centre[0]**2 + turbine.nacelle_centre[1]**2)
    points = [(turbine.nacelle_mass, turbine.top + turbine.nacelle_centre), (turbine.hub_mass, turbine.apex + turbine.hub_centre * turbine.shaft)]
    stations = np.linspace(0.0, 1.0, 2001)
    masses = np.interp(stations, turbine.blade.fractions, turbine.blade.mass[:, 0, 0]) * turbine.blade.length / 2000
    masses[[0, -1]] /= 2
    for copy in range(turbine.blades):
        angle = 2 * np.pi * copy / turbine.blades
        across, up = np.cross(turbine.shaft, [0, 0, 1.0]), np.cross([0, -1.0, 0], turbine.shaft)
        up, across = up / np.linalg.norm(up) * np.sign(up[2]), across / np.linalg.norm(across)
        axis = np.cos(np.radians(3.0)) * (np.cos(angle) * up + np.sin(angle) * across) - np.sin(np.radians(3.0)) * turbine.shaft
        points += [(m, turbine.apex + (2.0 + 20.0 * s) * axis) for m, s in zip(masses, stations)]
    inertia = np.zeros((2, 2))
    for m, point in points:
        x, _, z = point - turbine.top
        inertia += m * np.array([[1.0, z], [z, z * z + x * x]])  # r' = u + θ y × (x, z)
    inertia[1, 1] += nacelle / 2 + turbine.hub_inertia / 2
    return inertia


def test_the_first_tower_frequency_with_the_mass_of_the_rotor(tmp_path):
    turbine = read_turbine(turbines.write_turbine(tmp_path, NacCMyn=0.0))
    turbine.blade.stiffness *= 1e2  # as of a rigid rotor
    deck = write_turbine(turbine, tmp_path / "t.toml")[-1]
    deck.write_text(deck.read_text().replace("-9.80665", "0"))
    found = frequencies(deck)
    # Nodes of the tower are at its ten elements' ends; its rotary inertia, of a radius of 4 cm, is nothing.
    assert min(abs(2 * np.pi * f / beam_on(turbine) - 1.0) for f in found[:2]) < 1e-4


STEADY = """
[rotation]
axis    = {axis}
through = {through}
speed   = 8
[[stage]]
name   = "turn"
kind   = "steady"
steps  = 4
newton = {{ tolerance = 1e-10 }}
[[stage]]
name  = "tones"
kind  = "eigenvalues"
count = {count}
"""


def test_each_blade_stiffens_as_it_does_alone(tmp_path):
    """The rotor, its hub held in a frame that turns, has each tone of the single blade three times."""
    blade = blades.write_elastodyn(tmp_path, blades.SECTIONS, twist=5.0)
    turbine = read_turbine(turbines.write_turbine(tmp_path))
    deck = write_turbine(turbine, tmp_path / "rotor.toml")[-1]
    text = deck.read_text()
    text = text[:text.index("[rod.tower]")] + text[text.index("[body.hub]"):text.index("[joint.shaft]")]
    text = re.sub("gravity = .*", "", text) + '[[support]]\nat = "hub"\nfix = "all"\n' + STEADY.format(axis=list(turbine.shaft), through=list(turbine.apex), count=12)
    deck.write_text(text)
    single = write_deck(read_blade(blade, length=20.0), tmp_path / "single.toml")[-1]
    text = single.read_text().replace("elements = 50", "elements = 20")
    cone = np.radians(-3.0)
    axis = [float(np.cos(cone)), 0.0, float(-np.sin(cone))]  # the shaft in the blade's root axes
    text = re.sub("gravity = .*", "", text[:text.index("# Frequencies")]) + STEADY.format(axis=axis, through=[0.0, 0.0, -2.0], count=4)
    single.write_text(text)
    alone, together = frequencies(single, "omega"), frequencies(deck, "omega")
    assert len(alone) == 4 and len(together) == 12
    assert np.allclose(together, np.repeat(alone, 3), rtol=5e-8)  # places are written with 12 digits


def test_a_rotor_that_turns_reaches_its_speed(tmp_path):
    turbine = read_turbine(turbines.write_turbine(tmp_path, RotSpeed=30.0, DTTorSpr=1e7, DTTorDmp=1e4))
    deck = write_turbine(turbine, tmp_path / "t.toml")[-1]
    deck.write_text(deck.read_text() + '\n[[history]]\nname = "hub"\nat = "hub"\nquantities = ["angular_velocity"]\n')
    run(deck)
    speed = gxrod.open_results(tmp_path / "t.vtkhdf").histories["hub"]["angular_velocity"][-1]
    assert np.allclose(speed @ turbine.shaft, np.pi, rtol=1e-2)


def test_blades_of_beamdyn(tmp_path):
    beamdyn = blades.write_beamdyn(tmp_path)
    turbine = read_turbine(turbines.write_fst(tmp_path, beamdyn, TipRad=2.0 + read_blade(beamdyn).length))
    assert np.array_equal(turbine.blade.stiffness, read_blade(beamdyn).stiffness)
    turbine.tower.stiffness *= 1e6  # as of a clamp: each blade swings as it does alone
    deck = write_turbine(turbine, tmp_path / "t.toml")[-1]
    deck.write_text(deck.read_text().replace("-9.80665", "0"))
    single = write_deck(read_blade(beamdyn), tmp_path / "single.toml")[-1]
    single.write_text(single.read_text().replace("elements = 50", "elements = 20"))
    assert np.allclose(frequencies(deck), np.repeat(frequencies(single)[:4], 3), rtol=1e-4)


def test_the_command(tmp_path, capsys):
    path = turbines.write_fst(tmp_path)
    assert find_format(path) == "openfast"
    assert main([str(path), "-o", str(tmp_path / "t.toml")]) == 0
    said = capsys.readouterr()
    assert "3 blades of 20 m" in said.out
    assert "note: not imported: aerodynamics, hydrodynamics, moorings and controllers (AeroDyn," in said.err


def test_the_command_takes_another_blade(tmp_path, capsys):
    path, deck = turbines.write_fst(tmp_path), str(tmp_path / "t.toml")
    (tmp_path / "other").mkdir()
    elastodyn = str(blades.write_elastodyn(tmp_path / "other", blades.SECTIONS))
    for options, length in (([], 20), (["--length", "20.1"], 20.1)):
        assert main([str(path), "--blade", elastodyn, *options, "-o", deck]) == 0
        assert f"3 blades of {length:g} m" in capsys.readouterr().out
    hawc2 = str(blades.write_hawc2(tmp_path / "other", 20.0, full=False))
    assert main([str(path), "--blade", hawc2, "--set", "7", "1", "-o", deck]) == 2
    assert "there is no set #7" in capsys.readouterr().err
    assert main([str(path), "--inline", "-o", deck]) == 2
    assert "--inline is for blades, this is a turbine; leave it out" in capsys.readouterr().err


FAULTS = [
    ("22.0 TipRad", "1.0 TipRad", r"primary.dat:4: TipRad − HubRad is -1; expected more than 0"),
    ("16000.0 NacYIner", "16.0 NacYIner", r"primary.dat:2\d: NacYIner is that of a nacelle with -.* about its own centre of mass"),
    ("900.0 HubMass", "0 HubMass", r"primary.dat:2\d: HubMass is 0; expected more than 0; give the body's"),
    ("OverHang", "Over", r"primary.dat: there is no line with OverHang; give a whole primary file of ElastoDyn"),
    ('"tower.dat"', '"twr.dat"', r"primary.dat:\d+: the file twr.dat of TwrFile is not there \(tried .*\); put it there, or correct the name"),
]


@pytest.mark.parametrize("old, new, message", FAULTS)
def test_faults(old, new, message, tmp_path):
    path = turbines.write_turbine(tmp_path)
    path.write_text(path.read_text().replace(old, new))
    with pytest.raises(FileError) as caught:
        read_turbine(path)
    assert re.search(message, str(caught.value)), str(caught.value)


def test_what_differs_or_is_left_out_is_a_warning(tmp_path):
    turbine = read_turbine(turbines.write_turbine(tmp_path, BlPitch_2=3.0, PtfmMass=7.0))
    assert any("pitch angles 0, 3, 0 differ" in each for each in turbine.warnings)
    assert any("not used: PtfmMass" in each for each in turbine.warnings)
