"""Results in Python are those that `gxrod export` writes, and that h5py itself reads."""

import copy
import pickle
import shutil
import subprocess

import gxrod
import h5py
import numpy as np
import pytest
from conftest import EXAMPLES, PROGRAM, SOURCE
from conftest import gxrod as run_gxrod
from conftest import read_csv


def numbers(table, *names):
    return np.array([[float(text) for text in table[name]] for name in names]).T


def of_vector(table, name, letters="xyz"):
    return numbers(table, *(f"{name}_{letter}" for letter in letters))


@pytest.fixture
def plank(runs):
    return gxrod.open_results(runs("plank"))


# What kind of run it is.


def test_a_file_says_what_became_of_the_run(plank, runs):
    assert (plank.status, plank.analysis, plank.units, plank.version) == ("complete", "dynamic", "m kg s", gxrod.__version__)
    assert plank.title == "A plank that is stepped on"
    assert plank.deck_name == "plank.toml"
    assert plank.deck_text == (runs.folder / "plank.toml").read_text()
    assert plank.deck["rod"]["plank"]["elements"] == 2
    assert plank.doubt() == ""
    assert plank.warnings == []
    assert plank.path == runs("plank")
    with h5py.File(runs("plank")) as file:
        assert plank.reason == file.attrs["reason"]
        assert plank.attributes["deck_sha256"] == file.attrs["deck_sha256"]


def test_a_resumed_run_has_the_deck_as_run_last(runs, tmp_path):
    path = shutil.copy(runs("plank"), tmp_path / "longer.vtkhdf")
    run_gxrod("resume", path, "--set", "analysis.end_time=0.6", folder=tmp_path)
    longer = gxrod.open_results(path)
    assert "end_time = 0.6" in longer.deck_text
    assert longer.deck["analysis"]["end_time"] == 0.6
    assert longer.time[-1] == pytest.approx(0.6)


def test_a_failed_run_says_why(runs, tmp_path):
    run_gxrod("run", runs.folder / "plank.toml", "--set", "parameters.E=1e-9", "-o", "failed.vtkhdf", "--quiet", folder=tmp_path, code=3)
    failed = gxrod.open_results(tmp_path / "failed.vtkhdf")
    assert failed.status == "failed"
    assert failed.reason.startswith("the step from t = ")
    assert len(failed["tip"].displacement) == len(failed.time)


# Over the steps.


@pytest.mark.parametrize("deck", ["plank", "robot_arm", "sway", "squeezer"])
def test_histories_and_ledger_are_those_of_the_export(runs, deck):
    results = gxrod.open_results(runs(deck))
    records = {f"history_{name}": history for name, history in results.histories.items()}
    records |= {"ledger": results.ledger, "solver": results.solver}
    for name, record in records.items():
        table = read_csv(runs.tables(deck) / f"{name}.csv")
        np.testing.assert_array_equal(record.time, numbers(table, results.time_name)[:, 0])
        for quantity, values in record.items():
            letters = "wxyz" if f"{quantity}_w" in table else "xyz"
            expected = numbers(table, quantity)[:, 0] if quantity in table else of_vector(table, quantity, letters)
            np.testing.assert_array_equal(values, expected)
            np.testing.assert_array_equal(getattr(record, quantity), values)


def test_samples_at_equal_times_are_those_of_the_export(runs, tmp_path):
    run_gxrod("run", runs.folder / "plank.toml", "--set", "output.history_interval=0.03", "-o", "sampled.vtkhdf", "--quiet", folder=tmp_path)
    run_gxrod("export", "sampled.vtkhdf", "--csv", "tables", folder=tmp_path)
    results = gxrod.open_results(tmp_path / "sampled.vtkhdf")
    assert list(results.sampled) == list(results.histories) == ["tip", "tip-seen"]
    tip = results.sampled["tip"]
    np.testing.assert_allclose(tip.time, 0.03 * np.arange(len(tip.time)), rtol=1e-14)
    assert tip.time[-1] <= results.time[-1] < tip.time[-1] + 0.03
    table = read_csv(tmp_path / "tables" / "sampled_tip.csv")
    np.testing.assert_array_equal(tip.time, numbers(table, "time")[:, 0])
    np.testing.assert_array_equal(tip.displacement, of_vector(table, "displacement"))
    assert tip.describe("displacement").shape == (len(tip.time), 3)
    assert (tip.at, results.sampled["tip-seen"].relative_to) == ("plank.end", "plank@0.5")
    # Between steps of 0.01 as short steps have it.
    between = np.interp(tip.time, results.time, results["tip"].displacement[:, 2])
    np.testing.assert_allclose(tip.displacement[:, 2], between, atol=0.02 * np.ptp(between))
    assert len(gxrod.open_results(runs("plank")).sampled) == 0


def test_quantities_say_what_they_are(plank):
    tip = plank["tip"]
    assert (tip.name, tip.at, tip.relative_to) == ("tip", "plank.end", "")
    assert tip.names == list(tip) == ["displacement", "orientation"]
    what = tip.describe("displacement")
    assert (what.frame, what.dimension, what.unit, what.shape) == ("spatial", "length", "m", (51, 3))
    seen = plank["tip-seen"]
    assert seen.relative_to == "plank@0.5"
    assert seen.describe("position").frame == "axes of plank@0.5"
    assert plank.ledger.describe("angular_momentum").unit == "kg·m²/s"
    assert plank.solver.describe("residual").unit == ""


def test_names_are_completed(plank):
    assert {"displacement", "orientation", "time", "to_pandas"} <= set(dir(plank["tip"]))
    assert {"energy_error"} <= set(dir(plank.ledger))
    assert {"position", "axis_x", "elements"} <= set(dir(plank.frames[0]))
    assert {"moment", "position", "nodes"} <= set(dir(plank.rod("plank")))
    assert plank._ipython_key_completions_() == ["tip", "tip-seen"]


def test_unknown_names_are_told_with_the_nearest_ones(plank):
    with pytest.raises(KeyError) as error:
        plank["tpi"]
    assert str(error.value) == "there is no history 'tpi'; did you mean 'tip'? there are tip, tip-seen"
    for wrong in (lambda: plank["tip"].displacment, lambda: plank["tip"]["displacment"], lambda: plank["tip"].describe("displacment")):
        with pytest.raises(gxrod.UnknownNameError, match="did you mean 'displacement'"):
            wrong()
    with pytest.raises(AttributeError, match="did you mean 'energy_error'"):
        plank.ledger.energy_eror
    with pytest.raises(KeyError, match="there is no rod 'plnk'; did you mean 'plank'"):
        plank.rod("plnk")
    with pytest.raises(KeyError, match="did you mean 'moment'"):
        plank.rod("plank").momnt()
    with pytest.raises(KeyError, match="did you mean 'velocity'"):
        plank.frames[0].velocty
    assert not hasattr(plank["tip"], "velocity")
    assert "tip" in plank and "tpi" not in plank


def test_inputs_are_there_if_the_deck_has_some(plank, runs, tmp_path):
    with pytest.raises(gxrod.UnknownNameError, match="has no inputs"):
        plank.inputs
    path = shutil.copy(runs("plank"), tmp_path / "inputs.vtkhdf")
    with h5py.File(path, "a") as file:
        file["inputs/tendon"] = np.arange(60.0)
        file["inputs/tendon"].attrs["description"] = "an input"
    inputs = gxrod.open_results(path).inputs
    np.testing.assert_array_equal(inputs["tendon"], np.arange(51.0))  # cut to the complete steps
    assert inputs.describe("tendon").description == "an input"
    with pytest.raises(KeyError, match="did you mean 'tendon'"):
        inputs["tendom"]


def test_load_factors_are_those_of_paths_or_the_time(runs):
    sway = gxrod.open_results(runs("sway"))
    table = read_csv(runs.tables("sway") / "history_crown.csv")
    assert sway.time_name == "arc_length"
    np.testing.assert_array_equal(sway.load_factor, numbers(table, "load_factor")[:, 0])
    np.testing.assert_array_equal(sway.columns["branch"], numbers(table, "branch")[:, 0])
    turn = gxrod.open_results(runs("campbell"))
    assert turn.time_name == "load_factor"
    np.testing.assert_array_equal(turn.load_factor, turn.time)


# The motion.


def test_frames_are_rows_of_the_file(runs):
    results = gxrod.open_results(runs("robot_arm"))
    frames = results.frames
    with h5py.File(runs("robot_arm")) as file:
        grid = file["VTKHDF"]
        times = grid["Steps/Values"][()]
        points = grid["Points"][()].reshape(len(times), -1, 3)
        moments = grid["CellData/moment"][()].reshape(len(times), -1, 3)
        radius = grid["PointData/radius"][()].reshape(len(times), -1)
        arc_length = grid["PointData/arc_length"][()]
    np.testing.assert_array_equal(frames.time, times)
    assert len(frames) == len(times) == len(list(frames))
    for i in (0, 7, -1):
        np.testing.assert_array_equal(frames[i].position, points[i])
        np.testing.assert_array_equal(frames[i].elements.moment, moments[i])
        np.testing.assert_array_equal(frames[i].radius, radius[i])
        assert frames[i].time == times[i]
    for part in (slice(None), slice(3, 20, 4), slice(None, None, -7), slice(5, 5)):
        np.testing.assert_array_equal(frames[part].position, points[part])
        np.testing.assert_array_equal(frames[part].elements.moment, moments[part])
        np.testing.assert_array_equal(frames[part].time, times[part])
        np.testing.assert_array_equal(frames[part].of_node(4), points[part, 4])
    np.testing.assert_array_equal(frames.of_node(-1, "position"), points[:, -1])
    np.testing.assert_array_equal(frames.arc_length, arc_length)
    np.testing.assert_array_equal(frames[3].arc_length, arc_length)
    assert frames.nearest(0.5 * (times[3] + times[4]) + 1e-9).number == 4
    assert frames[3].describe("velocity").shape == (31, 3)
    with pytest.raises(IndexError, match="there is no frame 51; there are 51"):
        frames[51]
    with pytest.raises(IndexError, match="there is no node 31"):
        frames.of_node(31)


TRUSS = """gravity = [0, -10, 3]
[section.steel]
shape = { circle = { radius = 0.05 } }
material = { E = 2e11, nu = 0.3, density = 7800 }
[rod.truss]
section = "steel"
mesh = { file = "truss_4.1.msh", group = "truss" }
[[support]]
at = "truss.left_foot"
fix = "all"
[analysis]
kind = "dynamic"
end_time = 1e-3
steps = 2
"""


@pytest.fixture
def truss(runs):
    """A rod that branches; without the library of Gmsh, the test is skipped."""
    shutil.copy(SOURCE / "meshes" / "truss_4.1.msh", runs.folder)
    (runs.folder / "truss.toml").write_text(TRUSS)
    done = subprocess.run([PROGRAM, "check", "truss.toml"], cwd=runs.folder, text=True, capture_output=True, check=False)
    if "libgmsh" in done.stderr:
        pytest.skip("needs libgmsh")


def test_contacts_are_rows_of_the_file(runs, plank):
    results = gxrod.open_results(runs("sliding_rod"))
    contacts = results.contacts
    assert len(contacts) == len(results.frames) == len(list(contacts))
    assert contacts.obstacles == ["floor"]
    with h5py.File(runs("sliding_rod")) as file:
        offsets = file["contacts/offsets"][()]
        columns = {name: file["contacts"][name][()] for name in ("rods", "places", "point", "normal_force", "friction_force", "gap", "slides")}
    np.testing.assert_array_equal(contacts.offsets, offsets)
    for number in (0, 5, -1):
        first, end = offsets[number], offsets[number + 1] if number >= 0 else offsets[-1]
        if number < 0:
            first = offsets[-2]
        frame = contacts[number]
        assert len(frame) == end - first > 0
        for name, values in columns.items():
            np.testing.assert_array_equal(frame[name], values[first:end])
        np.testing.assert_array_equal(frame.force, frame.normal_force + frame.friction_force)
        assert frame.time == results.frames[number].time
        assert set(frame.names) == {("roller", "floor")}
        np.testing.assert_allclose(frame.of("roller"), frame.force.sum(axis=0), atol=1e-12)
        np.testing.assert_allclose(frame.of("floor", "roller"), -frame.force.sum(axis=0), atol=1e-12)
        np.testing.assert_array_equal(frame.of("roller", "ceiling"), np.zeros(3))
    assert contacts[-1].slides.dtype == bool
    assert contacts.nearest(results.frames.time[3]).number == 3
    assert [frame.number for frame in contacts[2:5]] == [2, 3, 4]
    assert "places" in repr(contacts[-1])
    with pytest.raises(IndexError):
        contacts[len(contacts)]
    # Of a deck without contact.
    assert len(plank.contacts[0]) == 0
    assert plank.contacts.obstacles == []


def test_rods_that_branch_are_those_of_the_export(truss, runs):
    check_rod(runs, "truss", "truss")


@pytest.mark.parametrize("deck, rod", [("robot_arm", "arm"), ("right_angle", "leg"), ("twisted_ring", "left")])
def test_rods_are_those_of_the_export(runs, deck, rod):
    check_rod(runs, deck, rod)


def check_rod(runs, deck, rod):
    path = runs(deck)
    folder = runs.folder / f"along_{deck}"
    run_gxrod("export", path, "--along", rod, "--all", "-o", folder, folder=runs.folder)
    nodes, elements = (read_csv(folder / f"along_{rod}_{kind}.csv") for kind in ("nodes", "elements"))
    results = gxrod.open_results(path)
    found = results.rod(rod)
    count = len(results.frames)
    np.testing.assert_array_equal(np.tile(found.nodes, count), numbers(nodes, "point")[:, 0])
    np.testing.assert_array_equal(np.tile(found.cells, count), numbers(elements, "cell")[:, 0])
    np.testing.assert_array_equal(np.tile(found.arc_length, count), numbers(nodes, "arc_length")[:, 0])
    np.testing.assert_array_equal(np.tile(found.cell_arc_length, count), numbers(elements, "arc_length")[:, 0])
    for name, table in (("position", nodes), ("velocity", nodes), ("axis_y", nodes), ("moment", elements), ("strain", elements)):
        every = of_vector(table, name).reshape(count, -1, 3)
        np.testing.assert_array_equal(getattr(found, name)(), every[-1])
        np.testing.assert_array_equal(getattr(found, name)(frame=0), every[0])
        np.testing.assert_array_equal(getattr(found, name)(frame=slice(None)), every)
        np.testing.assert_array_equal(found.read(name, time=results.frames.time[1]), every[1])
    assert found.radius().shape == found.nodes.shape
    assert "material" in found.moment.__doc__


def test_rods_know_their_sections(runs):
    rods = gxrod.open_results(runs("right_angle")).rods
    with h5py.File(runs("right_angle")) as file:
        assert list(rods) == [name.decode() for name in file["rods/name"]]
        for row, rod in enumerate(rods.values()):
            assert (rod.section, rod.order) == (file["rods/section"][row].decode(), file["rods/order"][row])
            assert rod.length == file["rods/length"][row]


# What joins things.


def test_joints_and_springs_are_tables(runs):
    results = gxrod.open_results(runs("squeezer"))
    with h5py.File(runs("squeezer")) as file:
        for name in ("joints", "springs"):
            table = getattr(results, name)
            assert table.columns == list(file[name])
            assert len(table) == len(file[name]["name"])
            np.testing.assert_array_equal(table.arm_b, file[name]["arm_b"])
            assert list(table.name) == [text.decode() for text in file[name]["name"]]
    np.testing.assert_array_equal(results.joints.row("B")["arm_b"], results.joints.arm_b[list(results.joints.name).index("B")])
    assert results.joints.row("B")["name"] == "B" and results.joints.row(1)["name"] == "K"
    assert [row["name"] for row in results.joints][:2] == ["O", "K"]
    assert len(results.bushings) == len(results.gears) == len(results.sleeves) == 0
    with pytest.raises(KeyError, match="did you mean 'axis_a'"):
        results.joints.axis_aa
    with pytest.raises(KeyError, match="there is no row of joints 'Q'"):
        results.joints.row("Q")


GEARED = """[body.a]
mass = 1
inertia = [1, 1, 1]
at = [0, 0, 0]
[body.b]
mass = 1
inertia = [1, 1, 1]
at = [1, 0, 0]
[joint.one]
type = "hinge"
between = ["ground", "a"]
at = [0, 0, 0]
axis = [0, 0, 1]
[joint.two]
type = "hinge"
between = ["ground", "b"]
at = [1, 0, 0]
axis = [0, 0, 1]
[gear.pair]
joints = ["one", "two"]
ratio = -0.5
[joint.three]
type = "hinge"
between = ["ground", "c"]
at = [2, 0, 0]
axis = [0, 0, 1]
[body.c]
mass = 1
inertia = [1, 1, 1]
at = [2, 0, 0]
[gear.more]
joints = ["two", "three"]
ratio = 2
[analysis]
kind = "dynamic"
end_time = 0.02
time_step = 0.01
"""


def test_gears_are_those_of_the_deck_and_sleeves_have_their_points(runs, tmp_path):
    (runs.folder / "geared.toml").write_text(GEARED)
    gears = gxrod.open_results(runs("geared")).gears
    assert gears.row("pair") == {"name": "pair", "joints": ["one", "two"], "ratio": -0.5}
    assert list(gears.name) == ["pair", "more"] and gears.joints[1] == ["two", "three"]
    run_gxrod("run", EXAMPLES / "sliding_mass" / "sliding_mass.toml", "--set", "analysis.end_time=0.05", folder=tmp_path)
    sleeves = gxrod.open_results(tmp_path / "sliding_mass.vtkhdf").sleeves
    assert len(sleeves) == 1
    row = sleeves.row("sleeve")
    assert row["rod"] == 0 and row["place"] == pytest.approx(0.25)
    assert row["point_b"] == 81 and list(row["arm_b"]) == [0, 0, 0]


# Stages.


def test_modes(runs):
    results = gxrod.open_results(runs("modes"))
    assert list(results.stages) == ["bend", "tones"]
    bend, tones = results.stages.values()
    assert (bend.kind, bend.number, tones.kind, tones.number) == ("static", 0, "modes", 1)
    assert bend.rows == slice(0, len(results.time)) and tones.rows.stop == tones.rows.start
    np.testing.assert_array_equal(bend.time, results.time)
    table = read_csv(runs.tables("modes") / "stage_tones.csv")
    np.testing.assert_array_equal(tones.frequencies, numbers(table, "frequency")[:, 0])
    np.testing.assert_array_equal(tones.angular_frequencies, numbers(table, "omega")[:, 0])
    np.testing.assert_allclose(tones.angular_frequencies, 2 * np.pi * tones.frequencies)
    np.testing.assert_array_equal(tones.eigenvalues, numbers(table, "growth")[:, 0] + 1j * tones.omega)
    np.testing.assert_array_equal(tones.effective_masses, of_vector(table, "effective_mass", ("x", "y", "z", "rx", "ry", "rz")))
    assert list(tones.words) == table["words"]
    assert tones.total_mass.shape == (6,)
    assert tones.energy_shares.shape == (3, 1, 6)
    with h5py.File(runs("modes").with_name("modes.tones.vtkhdf")) as file:
        moves = file["VTKHDF/PointData/displacement"][()].reshape(3, -1, 3)
        np.testing.assert_array_equal(tones.shapes.displacement, moves)
        np.testing.assert_array_equal(tones.shapes.position, file["VTKHDF/Points"])
    assert len(tones.shapes) == 3
    assert tones.shapes.rotation_vector.shape == moves.shape
    with pytest.raises(AttributeError, match="did you mean 'frequencies'"):
        tones.frequncies
    with pytest.raises(AttributeError):
        bend.frequencies
    with pytest.raises(KeyError, match="did you mean 'tones'"):
        results.stages["tone"]


def test_eigenvalues_and_sweeps(runs):
    results = gxrod.open_results(runs("beck"))
    flutter, onset = results.stages["flutter"], results.stages["onset"]
    table = read_csv(runs.tables("beck") / "stage_flutter.csv")
    np.testing.assert_array_equal(flutter.damping_ratios, numbers(table, "damping_ratio")[:, 0])
    assert flutter.attributes["complete"] == 1
    assert np.iscomplexobj(flutter.shapes.displacement)
    table = read_csv(runs.tables("beck") / "stage_onset.csv")
    assert onset.key == "parameters.P"
    np.testing.assert_array_equal(onset.values, numbers(table, "value")[:, 0])
    np.testing.assert_array_equal(onset.angular_frequencies, numbers(table, "omega_1", "omega_2"))
    np.testing.assert_array_equal(onset.eigenvalues.real, numbers(table, "growth_1", "growth_2"))
    [row] = onset.onsets
    assert row["value"] == numbers(read_csv(runs.tables("beck") / "stage_onset_onset.csv"), "value")[0, 0]


def test_shapes_and_words_of_a_sweep(runs):
    results = gxrod.open_results(runs("campbell"))
    sweep = results.stages["campbell"]
    values, modes = sweep.angular_frequencies.shape
    assert sweep.mode_words.shape == (values, modes)
    assert list(sweep.mode_words[0]) == list(sweep.words)
    shapes = sweep.shapes
    nodes = shapes.position.shape[1]
    assert len(shapes) == values
    assert shapes.position.shape == (values, nodes, 3)
    assert shapes.displacement.shape == shapes.rotation_vector.shape == (values, modes, nodes, 3)
    # The blade stretches as it turns faster, and its shapes are a tenth of it; torsion moves the axis hardly or not.
    reach = shapes.position[:, -1, 0]
    assert reach[0] == pytest.approx(1.2, abs=1e-12)
    assert (np.diff(reach) > 0.0).all()
    largest = np.linalg.norm(shapes.displacement.real, axis=-1).max(axis=-1)
    np.testing.assert_allclose(largest[:, :5], 0.1, rtol=1e-6)
    # The first mode leaves the plane of rotation at all speeds, the second one stays in it.
    moves = np.abs(shapes.displacement[:, :, -1])
    assert (moves[:, 0, 2] > 100.0 * moves[:, 0, 1]).all()
    assert (moves[:, 1, 1] > 100.0 * moves[:, 1, 2]).all()
    assert all("flap" in words for words in sweep.mode_words[1:, 0])
    plain = gxrod.open_results(runs("beck")).stages["onset"]
    with pytest.raises(gxrod.FileError, match="there is no such file; it holds the shapes of stage onset"):
        plain.shapes


def test_a_campbell_diagram_marks_where_multiples_of_the_speed_meet_modes(runs):
    figures = pytest.importorskip("matplotlib.figure")
    from gxrod.plot.sweep import draw_sweep, read_sweep

    stage = gxrod.open_results(runs("campbell")).stages["campbell"]
    sweep = read_sweep(stage, "m kg s")
    figure = figures.Figure()
    draw_sweep(figure, sweep)
    axes = figure.axes[0]
    rpm, hertz = stage.speeds * 30 / np.pi, stage.angular_frequencies / (2 * np.pi)
    np.testing.assert_allclose(axes.get_xlim(), (0.0, rpm[-1]), rtol=1e-12)
    top = axes.get_ylim()[1]
    rings = sorted(float(line.get_xdata()[0]) for line in axes.lines if line.get_markersize() == 3.5)
    expected = []
    for multiple in range(1, 9):
        off = hertz - multiple * rpm[:, None] / 60
        for i, mode in zip(*np.nonzero(off[:-1] * off[1:] < 0)):
            part = off[i, mode] / (off[i, mode] - off[i + 1, mode])
            expected.append(rpm[i] + part * (rpm[i + 1] - rpm[i]))
            assert hertz[i, mode] < top
    np.testing.assert_allclose(rings, sorted(expected), rtol=1e-12)
    names = [text.get_text() for text in axes.texts]
    assert names == [f"{multiple}P" for multiple in range(1, 9)]


def test_buckling_factors(runs):
    buckling = gxrod.open_results(runs("lateral_buckling")).stages["buckling"]
    table = read_csv(runs.tables("lateral_buckling") / "stage_buckling.csv")
    np.testing.assert_array_equal(buckling.factors, numbers(table, "factor")[:, 0])
    assert buckling.attributes["limit"] > 10.0
    with pytest.raises(AttributeError, match="there is no finding of stage buckling 'eigenvalues'"):
        buckling.eigenvalues


def test_responses(runs):
    shake = gxrod.open_results(runs("damped_cantilever")).stages["shake"]
    table = read_csv(runs.tables("damped_cantilever") / "stage_shake.csv")
    np.testing.assert_array_equal(shake.angular_frequencies, numbers(table, "omega")[:, 0])
    np.testing.assert_array_equal(shake.frequencies, numbers(table, "frequency")[:, 0])
    for part in ("real", "imaginary"):
        expected = of_vector(table, "tip_displacement", [f"{letter}_{part}" for letter in "xyz"])
        found = shake.histories["tip"].displacement
        np.testing.assert_array_equal(found.real if part == "real" else found.imag, expected)
    with pytest.raises(AttributeError, match="did you mean 'displacement'"):
        shake.histories["tip"].displacment


def test_paths(runs):
    path = gxrod.open_results(runs("sway")).stages["path"]
    for table in ("critical_points", "branches"):
        expected = read_csv(runs.tables("sway") / f"stage_path_{table}.csv")
        found = getattr(path, table)
        assert set(found.columns) == set(expected)
        for name in expected:
            assert [type(text)(value) if not isinstance(value, float) else float(value) for text, value in zip(expected[name], found[name])] == \
                [float(text) if found[name].dtype.kind == "f" else text for text in expected[name]]
    assert path.shapes.position.shape == path.shapes.displacement.shape == (4, 97, 3)


def test_decks_without_stages_have_none(plank):
    assert list(plank.stages) == []


# Other forms.


def frame_of(pandas, path, index):
    """What `gxrod export` writes, without the columns that files of stages have."""
    columns = {name: [float(text) for text in texts] if name != "words" else texts for name, texts in read_csv(path).items()}
    return pandas.DataFrame(columns).set_index(index).drop(columns="stage", errors="ignore")


@pytest.mark.parametrize("deck", ["plank", "campbell"])
def test_pandas(runs, deck):
    pandas = pytest.importorskip("pandas")
    results = gxrod.open_results(runs(deck))
    for record, table in ((results["tip"], "history_tip"), (results.ledger, "ledger")):
        pandas.testing.assert_frame_equal(record.to_pandas(), frame_of(pandas, runs.tables(deck) / f"{table}.csv", results.time_name))


@pytest.mark.parametrize("deck, stage", [("modes", "tones"), ("beck", "onset"), ("lateral_buckling", "buckling")])
def test_stages_in_pandas(runs, deck, stage):
    pandas = pytest.importorskip("pandas")
    table = frame_of(pandas, runs.tables(deck) / f"stage_{stage}.csv", "value" if stage == "onset" else "number")
    found = gxrod.open_results(runs(deck)).stages[stage].to_pandas()
    pandas.testing.assert_frame_equal(found[list(table.columns)], table, check_dtype=False, check_index_type=False)


def test_more_in_pandas(runs):
    pytest.importorskip("pandas")
    shake = gxrod.open_results(runs("damped_cantilever")).stages["shake"]
    np.testing.assert_array_equal(shake.to_pandas()["tip_displacement_z"], shake.histories["tip"].displacement[:, 2])
    path = gxrod.open_results(runs("sway")).stages["path"]
    assert list(path.to_pandas()["kind"]) == list(path.critical_points.kind)
    joints = gxrod.open_results(runs("squeezer")).joints
    np.testing.assert_array_equal(joints.to_pandas()["arm_b_y"], joints.arm_b[:, 1])


def test_xarray(plank):
    pytest.importorskip("xarray")
    tip = plank["tip"].to_xarray()
    np.testing.assert_array_equal(tip.displacement.sel(component="z"), plank["tip"].displacement[:, 2])
    np.testing.assert_array_equal(tip.orientation.sel(quaternion="w"), plank["tip"].orientation[:, 0])
    assert tip.displacement.dims == ("time", "component")
    assert tip.displacement.attrs == {"long_name": "displacement since t = 0", "units": "m", "frame": "spatial", "dimension": "length"}
    assert tip.time.attrs == {"units": "s"} and tip.attrs == {"at": "plank.end"}
    tree = plank.to_xarray(frames=True)
    np.testing.assert_array_equal(tree["histories/tip"].displacement, tip.displacement)
    np.testing.assert_array_equal(tree["ledger"].energy_error, plank.ledger.energy_error)
    np.testing.assert_array_equal(tree["frames"].position.sel(component="x", time=0.5), plank.frames[-1].position[:, 0])
    np.testing.assert_array_equal(tree["frames/elements"].moment, plank.frames.elements.moment)
    assert tree["frames"].arc_length.dims == ("node",)
    assert tree.attrs["title"] == plank.title
    assert "frames" not in plank.to_xarray()


def test_without_pandas_xarray_and_h5py(plank, runs, absent):
    absent("pandas", "xarray")
    assert plank["tip"].displacement.shape == (51, 3)
    with pytest.raises(ImportError, match='python3 -m pip install "?pandas'):
        plank["tip"].to_pandas()
    with pytest.raises(ImportError, match='python3 -m pip install "?pandas'):
        gxrod.open_results(runs("modes")).stages["tones"].to_pandas()
    for call in (plank["tip"].to_xarray, plank.to_xarray):
        with pytest.raises(ImportError, match='python3 -m pip install "?xarray'):
            call()
    absent("h5py")
    with pytest.raises(ImportError, match="reading results of gxrod needs h5py"):
        gxrod.open_results(runs("plank"))


@pytest.mark.parametrize("deck", ["plank", "sway", "beck", "squeezer", "damped_cantilever", "modes"])
def test_everything_shows_itself(runs, deck):
    results = gxrod.open_results(runs(deck))
    parts = [results, results.frames, results.frames[0], results.frames[0].elements, results.ledger, results.histories, results.joints,
             results.stages, results.rods, *results.histories.values(), *results.stages.values(), *results.rods.values()]
    for part in parts:
        assert "object at 0x" not in repr(part)
        page = part._repr_html_()
        assert page.count("<tr>") == page.count("</tr>") and "<table>" in page
    assert deck in repr(results) and "complete" in repr(results)


def test_names_are_escaped_in_notebooks(runs, tmp_path):
    path = shutil.copy(runs("plank"), tmp_path / "a.vtkhdf")
    with h5py.File(path, "a") as file:
        file.attrs["title"] = "<b>plank</b>"
    assert "&lt;b&gt;plank" in gxrod.open_results(path)._repr_html_()


def test_results_are_copied_and_pickled(plank):
    for again in (pickle.loads(pickle.dumps(plank)), copy.deepcopy(plank)):
        np.testing.assert_array_equal(again["tip"].displacement, plank["tip"].displacement)
    tip = pickle.loads(pickle.dumps(plank["tip"]))
    np.testing.assert_array_equal(tip.displacement, plank["tip"].displacement)


# Files that are none.


@pytest.fixture
def at_once(monkeypatch):
    """Does not wait before it reads again."""
    monkeypatch.setattr("gxrod.results.source.PAUSE", 0.0)


def test_files_that_are_no_results(at_once, tmp_path, runs):
    (tmp_path / "text.vtkhdf").write_text("no results")
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file["x"] = 1.0
    data = runs("plank").read_bytes()
    (tmp_path / "cut.vtkhdf").write_bytes(data[: len(data) // 2])
    for name, says in (("none.vtkhdf", "there is no such file"), (".", "is a folder"), ("text.vtkhdf", "cannot be read as results"),
                       ("other.h5", "is not a results file of gxrod"), ("cut.vtkhdf", "cannot be read as results")):
        with pytest.raises(gxrod.FileError, match=says) as error:
            gxrod.open_results(tmp_path / name)
        assert str(error.value).startswith(str(tmp_path / name))


def test_a_changed_bit_is_doubted(runs, tmp_path):
    data = bytearray(runs("plank").read_bytes())
    data[len(data) // 2] ^= 1
    (tmp_path / "changed.vtkhdf").write_bytes(data)
    assert gxrod.open_results(tmp_path / "changed.vtkhdf").doubt() == "not all of its bytes are those that were written"


def test_missing_shapes_are_named(runs, tmp_path):
    path = shutil.copy(runs("modes"), tmp_path / "modes.vtkhdf")
    with pytest.raises(gxrod.FileError, match="modes.tones.vtkhdf: there is no such file; it holds the shapes of stage tones"):
        gxrod.open_results(path).stages["tones"].shapes


def test_damaged_files_raise_errors_of_gxrod(at_once, runs, tmp_path):
    """Whatever other things than expected a file has."""
    def damage(change):
        path = shutil.copy(runs("plank"), tmp_path / "damaged.vtkhdf")
        with h5py.File(path, "a") as file:
            change(file)
        return gxrod.open_results(path)

    def replace(file, name, value):
        del file[name]
        file[name] = value

    damaged = damage(lambda file: replace(file, "VTKHDF/Offsets", [0, 4, 9]))
    with pytest.raises(gxrod.FileError, match="its cells do not fit its points"):
        damaged.rod("plank")
    damaged = damage(lambda file: replace(file, "VTKHDF/Points", np.zeros((3, 3))))
    with pytest.raises(gxrod.FileError, match="cannot be read as results"):
        damaged.frames.position
    damaged = damage(lambda file: replace(file, "deck/text", "title = "))
    with pytest.raises(gxrod.FileError, match="its deck cannot be read"):
        damaged.deck
    damaged = damage(lambda file: (file.pop("histories/tip/displacement"), file.create_group("histories/tip/displacement")))
    with pytest.raises(gxrod.FileError, match="cannot be read as results"):
        damaged["tip"].displacement
