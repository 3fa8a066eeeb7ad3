"""What a simulation from Python withstands: callbacks that fail, values that are not numbers, threads, other users of HDF5; and the calls that other tests leave out."""

import concurrent.futures
import math
import os
import pathlib
import pickle
import subprocess
import sys

import numpy as np
import pytest
from conftest import EXAMPLES, SWING, TONES

import gxrod

if not gxrod._has_core():
    pytest.skip("gxrod has no compiled part here: it is built with -DGXROD_PYTHON_MODULE=ON", allow_module_level=True)


@pytest.fixture
def model():
    return gxrod.Deck.from_text(SWING).build()


# Callbacks and inputs.


def test_a_run_goes_on_to_the_last_bit_after_a_callback_that_failed(model, tmp_path):
    """With a results file, which is complete in the end."""
    seen = []

    def fail_at_the_tenth(sim):
        seen.append(sim.time)
        if len(seen) == 10:
            raise ZeroDivisionError("mine")

    with gxrod.Simulation(model, results=tmp_path / "a.vtkhdf") as sim:
        with pytest.raises(ZeroDivisionError, match="mine"):
            sim.run(on_step=fail_at_the_tenth)
        assert sim.time == pytest.approx(0.2) and not sim.finished
        assert sim.run(on_step=fail_at_the_tenth).status == "complete"
    alone = gxrod.Simulation(model)
    alone.run()
    assert len(seen) == 25 and (sim.state.position == alone.state.position).all()
    assert (gxrod.open_results(tmp_path / "a.vtkhdf")["tip"].position == alone.records["tip"].position).all()


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, np.float64("nan"), "much", None, [1.0, 2.0]])
def test_an_input_that_is_no_number_changes_nothing(model, value):
    sim = gxrod.Simulation(model)
    sim.advance(steps=2)
    sim.inputs["tendon"] = 0.5
    with pytest.raises((gxrod.Error, TypeError, ValueError)):
        sim.inputs["tendon"] = value
    assert sim.inputs["tendon"] == 0.5
    sim.run()
    assert sim.finished and np.isfinite(sim.state.position).all()


def test_inputs_are_numbers_of_any_kind(model):
    ends = set()
    for value in (1, 1.0, np.float32(1), np.int64(1), np.array(1.0), True):
        sim = gxrod.Simulation(model)
        sim.inputs["tendon"] = value
        sim.run()
        ends.add(tuple(sim["tip"].position))
    assert len(ends) == 1


@pytest.mark.parametrize("arguments, kind", [({"until": math.nan}, gxrod.Error), ({"until": -math.inf}, gxrod.Error), ({"until": "soon"}, TypeError),
                                             ({"until": 0.1, "steps": 1}, TypeError), ({"steps": "two"}, TypeError)])
def test_where_to_go_is_one_number(model, arguments, kind):
    sim = gxrod.Simulation(model)
    with pytest.raises(kind):
        sim.advance(**arguments)
    assert sim.time == 0.0 and sim.step().time == 0.02


def test_no_steps_and_endless_ones(model):
    sim = gxrod.Simulation(model)
    sim.advance(steps=0)
    assert sim.time == 0.0
    sim.advance(until=math.inf)
    assert sim.finished and sim.time == 0.5


def test_a_callback_can_save_return_and_change_inputs(model):
    """It may use all of the simulation."""
    sim, points = gxrod.Simulation(model), []

    def interfere(each):
        each.inputs["tendon"] = 0.1 * len(points)
        if len(points) < 5:
            points.append(each.save())
        elif len(points) == 5:
            points.append(None)
            each.restore(points[1])

    sim.run(on_step=interfere)
    assert sim.finished and points[1].time == pytest.approx(0.04)
    assert (np.diff(sim.records.time) > 0).all() and len(sim.records.time) == 26


# Views, copies, pickles.


def test_views_are_plain_rows_and_the_rest_are_copies(model):
    sim = gxrod.Simulation(model)
    for name in dir(sim.state):
        view = getattr(sim.state, name)
        assert view.dtype == np.float64 and view.flags.c_contiguous and not view.flags.writeable and not view.flags.owndata, name
        assert np.shares_memory(view, getattr(sim.state, name))
    kept = [sim["tip"].position, sim.elements.force, sim.ledger.angular_momentum, sim.records["tip"].position, sim.records.time]
    before = [each.copy() for each in kept]
    part = sim.state.position[::2, 2]
    sim.advance(steps=3)
    assert all((each == old).all() for each, old in zip(kept, before))
    assert (part == sim.state.position[[0, 2, 4], 2]).all()
    for each in kept:
        each[...] = 7.0  # it is the user's own
    assert (sim.records["tip"].position != 7.0).all() and len(sim.records.time) == 4


@pytest.mark.parametrize("make", [lambda: gxrod.DeckError(["wrong"]), lambda: gxrod.ConvergenceError("no", 1.0, 0.1, "singular", ["a"], ["b"]),
                                  lambda: gxrod.FileError("a.toml: gone"), lambda: gxrod.EvaluationError("1/0"), lambda: gxrod.UnknownNameError("no x")])
def test_errors_are_pickled_whole(make):
    error = make()
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is type(error) and str(again) == str(error) and vars(again) == vars(error)


def test_checkpoints_go_to_other_processes(model):
    """A process of its own continues to the same bits."""
    sim = gxrod.Simulation(model)
    sim.advance(steps=7)
    point = sim.save()
    sim.run()
    with concurrent.futures.ProcessPoolExecutor(1) as processes:
        end = processes.submit(continue_from, model, point).result()
    assert (end == sim.state.position).all()


def continue_from(model, point):
    sim = gxrod.Simulation(model)
    sim.restore(point)
    sim.run()
    return sim.state.position.copy()


# Threads.


def test_the_number_of_threads_changes_no_bit(model):
    many = gxrod.Deck.from_text(SWING).build({"rod.arm.elements": 400, "analysis.end_time": 0.1})
    ends = []
    for threads in (1, 2, 3):
        sim = gxrod.Simulation(many, threads=threads)
        sim.inputs["tendon"] = 1.0
        assert sim.run().threads == threads
        ends.append((sim.state.position.copy(), sim.records.ledger.energy_error))
    assert all((a == b).all() for other in ends[1:] for a, b in zip(ends[0], other))


def test_an_error_in_one_thread_leaves_the_others(model):
    def drive(moment):
        sim = gxrod.Simulation(gxrod.Deck.from_text(SWING).build({"load[0].moment": [0, moment, 0]}))
        sim.run()
        return sim.state.position.copy()

    with concurrent.futures.ThreadPoolExecutor(3) as threads:
        runs = [threads.submit(drive, moment) for moment in ("2*t", "t < 0.1 ? 0 : 1e9", "2*t")]
    assert isinstance(runs[1].exception(), gxrod.ConvergenceError)
    assert (runs[0].result() == runs[2].result()).all()


# Other users of HDF5. Each order in a process of its own, as the first import decides which library is loaded.


USE_BOTH = """
with h5py.File("mine.h5", "w") as mine:
    mine["a"] = [1.0, 2.0]
    with gxrod.Simulation("swing.toml", results="swing.vtkhdf") as sim:
        sim.advance(steps=5)
        mine["b"] = sim.records["tip"].position
        sim.run()
with h5py.File("mine.h5") as mine, h5py.File("swing.vtkhdf") as theirs:
    assert mine["b"].shape == (6, 3) and len(theirs["histories/time"]) == 26
assert (gxrod.open_results("swing.vtkhdf")["tip"].position == sim.records["tip"].position).all()
try:
    gxrod.Simulation("swing.toml", results="missing/swing.vtkhdf")
except gxrod.FileError:
    print("done")
"""


@pytest.mark.parametrize("imports", ["import h5py, gxrod", "import gxrod; gxrod.Simulation; import h5py"], ids=["h5py first", "gxrod first"])
def test_h5py_is_imported_before_or_after(imports, tmp_path):
    pytest.importorskip("h5py")
    (tmp_path / "swing.toml").write_text(SWING)
    done = subprocess.run([sys.executable, "-B", "-c", imports + USE_BOTH], cwd=tmp_path, text=True, capture_output=True, check=False,
                          env={**os.environ, "PYTHONPATH": str(pathlib.Path(gxrod.__file__).parents[1])})
    assert (done.returncode, done.stdout, done.stderr) == (0, "done\n", "")


# What other tests leave out.


def test_ends_and_what_comes_after(model, tmp_path):
    sim = gxrod.Simulation(model, results=tmp_path / "a.vtkhdf")
    sim.advance(steps=3)
    sim.close()
    sim.close()
    assert sim.finished and sim.time == pytest.approx(0.06) and np.isfinite(sim.state.position).all()
    with pytest.raises(gxrod.Error, match="interrupted at t = 0.06"):
        sim.step()
    with pytest.raises(gxrod.FileError):
        gxrod.Simulation(model, results=tmp_path / "missing" / "a.vtkhdf")


def test_stages_have_names_and_a_last_one_may_have_no_steps():
    sim = gxrod.Simulation(gxrod.Deck.from_text(TONES))
    assert sim.stage == "bend" and sim.summary.status == "running"
    while not sim.finished:
        step = sim.step()
    assert sim.stage == "tones" and step is None and sim.summary.found[0]["shapes"]
    with pytest.raises(gxrod.UnknownNameError, match="status"):
        sim.summary.statsu
    assert {"status", "steps", "keys"} <= set(dir(sim.summary))


def test_decks_and_models_show_what_they_are(tmp_path):
    (tmp_path / "swing.toml").write_text(SWING)
    deck = gxrod.Deck(str(tmp_path / "swing.toml"))
    assert deck.file == str(tmp_path / "swing.toml") and repr(deck) == f"gxrod.Deck({deck.file!r})"
    model = deck.build({"parameters.EI": 5.0})
    assert "parameters.EI  5.0" in repr(model) and all(isinstance(note, str) for note in model.notes)
    assert model.rods["arm"].cells.tolist() == [[0, 1], [1, 2], [2, 3], [3, 4]] and model.bodies == {}
    top = gxrod.Deck(EXAMPLES / "heavy_top" / "heavy_top.toml").build()
    assert top.bodies == {"top": 0} and top.node("top") == 0 and top.elements == 0


def test_matrices_say_what_they_need(model, absent):
    absent("scipy", "scipy.sparse")
    with pytest.raises(ImportError, match="need SciPy"):
        gxrod.Simulation(model).tangent()


def test_results_are_complete_where_a_run_ends(tmp_path, model):
    """Without `close`."""
    for name, drive in {"run": lambda sim: sim.run(), "advance": lambda sim: sim.advance(until=0.5), "step": lambda sim: [sim.step() for _ in range(25)],
                        "stopped": lambda sim: sim.run(on_step=lambda sim: sim.time < 0.3)}.items():
        sim = gxrod.Simulation(model, results=tmp_path / f"{name}.vtkhdf")
        drive(sim)
        assert gxrod.open_results(tmp_path / f"{name}.vtkhdf").status == ("interrupted" if name == "stopped" else "complete")
        assert sim["tip"].position.shape == (3,) and sim.summary.steps > 10
