"""Runs that are driven from Python: each call once, and what it must agree with."""

import copy
import gc
import pickle
import signal
import threading
import time
import tomllib

import numpy as np
import pytest
from conftest import EXAMPLES, SWING
from conftest import gxrod as run_program

import gxrod

if not gxrod._has_core():
    pytest.skip("gxrod has no compiled part here: it is built with -DGXROD_PYTHON_MODULE=ON", allow_module_level=True)


@pytest.fixture
def deck():
    return gxrod.Deck.from_text(SWING)


@pytest.fixture
def model(deck):
    return deck.build()


@pytest.fixture
def sim(model):
    with gxrod.Simulation(model) as simulation:
        yield simulation


# Decks and models.


def test_a_deck_comes_from_a_file_a_text_or_a_dict(tmp_path, deck):
    (tmp_path / "swing.toml").write_text(SWING)
    assert gxrod.Deck(tmp_path / "swing.toml").text == deck.text == SWING
    tree = deck.tree()
    assert tree["rod"]["arm"]["elements"] == 4
    tree["gravity"] = np.array(tree["gravity"])
    tree["parameters"]["EI"] = np.float64(6.0)
    again = gxrod.Deck.from_dict(tree)
    assert again.tree() == deck.tree()
    ends = [run_to_end(each).state.position[-1] for each in (again, deck)]
    assert (ends[0] == ends[1]).all()


def run_to_end(deck, overrides=None):
    sim = gxrod.Simulation(deck.build(overrides))
    sim.run()
    return sim


def test_overrides_keep_their_types(deck):
    numbers = {"parameters.EI": np.float64(2e7), "rod.arm.elements": np.int64(6), "gravity": np.array([0, 0, -1.5]), "title": "a = \"b\""}
    model = deck.build(numbers)
    assert model.nodes == 7 and model.elements == 6
    set_to = tomllib.loads(model._core.text)
    assert set_to["parameters"]["EI"] == 2e7 and set_to["title"] == "a = \"b\"" and set_to["gravity"] == [0, 0, -1.5]
    tiny = run_to_end(deck, {"parameters.EI": 6.0 + 1e-15}).state.position[-1]
    assert not (tiny == run_to_end(deck).state.position[-1]).all()
    with pytest.raises(TypeError, match="a deck has numbers"):
        deck.build({"gravity": {1, 2}})


def test_faults_of_a_deck_are_all_there(deck):
    with pytest.raises(gxrod.DeckError) as caught:
        gxrod.Deck.from_text(SWING.replace("elements = 4", "elemnts = 4").replace('fix = "all"', 'fix = "al"')).build()
    faults = caught.value.faults
    assert {fault.key for fault in faults} >= {"rod.arm.elemnts", "support[0].fix"}
    assert any("did you mean" in fault.message for fault in faults)
    assert all(fault.line > 0 and fault.file.endswith("deck.toml") for fault in faults)
    with pytest.raises(gxrod.DeckError, match="parameter"):
        deck.build({"parameters.EJ": 3})
    with pytest.raises(gxrod.DeckError):
        gxrod.Deck.from_text("a = = 3")
    with pytest.raises(gxrod.FileError, match="nowhere.toml"):
        gxrod.Deck("nowhere.toml")


def test_a_model_says_where_its_points_are(model):
    assert model.nodes == 5 and model.elements == 4
    assert model.inputs == ["tendon"] and model.histories == ["tip", "root"]
    arm = model.rods["arm"]
    assert arm.nodes.tolist() == [0, 1, 2, 3, 4] and arm.arc_length.tolist() == [0, 0.5, 1, 1.5, 2]
    assert model.node("arm.end") == 4 and model.node("arm@0.5") == 2
    with pytest.raises(gxrod.Error, match="between nodes"):
        model.node("arm@0.3")
    with pytest.raises(gxrod.UnknownNameError, match="arm.end"):
        model.node("arn.end")
    assert model.check() == []
    assert "5 nodes" in repr(model)


def test_schema_lists_the_tables():
    assert {"rod", "input", "analysis"} <= set(gxrod.schema()["properties"])


# Steps.


def test_steps_are_those_of_the_program(tmp_path, sim):
    (tmp_path / "swing.toml").write_text(SWING)
    run_program("run", "swing.toml", "--quiet", folder=tmp_path)
    results = gxrod.open_results(tmp_path / "swing.vtkhdf")
    while not sim.finished:
        step = sim.step()
    assert step == (0.5, pytest.approx(0.02), step.newton_iterations, 0)
    assert (sim.records.time == results.time).all()
    for name, quantity in (("tip", "position"), ("tip", "velocity"), ("tip", "orientation"), ("root", "moment")):
        assert (sim.records[name][quantity] == results[name][quantity]).all(), quantity
    for name in ("kinetic_energy", "energy_error", "angular_momentum"):
        assert (getattr(sim.records.ledger, name) == results.ledger[name]).all(), name
    assert (sim.elements.moment == results.frames[-1].elements.moment).all()
    assert (sim.state.position == results.frames[-1].position).all()
    assert sim.ledger.kinetic_energy == results.ledger.kinetic_energy[-1]
    assert (sim["tip"].position == results["tip"].position[-1]).all()
    with pytest.raises(gxrod.Error, match="finished"):
        sim.step()


def test_results_files_are_those_of_the_program(tmp_path, model):
    with gxrod.Simulation(model, results=tmp_path / "swing.vtkhdf") as sim:
        sim.inputs["tendon"] = 2.5
        summary = sim.run()
    assert summary.steps == 25 and summary["unknowns"] == 24
    results = gxrod.open_results(tmp_path / "swing.vtkhdf")
    assert results.status == "complete"
    assert results.inputs["tendon"][0] == 0.0 and (results.inputs["tendon"][1:] == 2.5).all()
    assert (results["tip"].position == sim.records["tip"].position).all()


def test_a_run_that_is_left_is_interrupted(tmp_path, model):
    with gxrod.Simulation(model, results=tmp_path / "swing.vtkhdf") as sim:
        sim.advance(steps=5)
    assert gxrod.open_results(tmp_path / "swing.vtkhdf").status == "interrupted"
    run_program("resume", "swing.vtkhdf", "--quiet", folder=tmp_path)
    assert gxrod.open_results(tmp_path / "swing.vtkhdf").status == "complete"


def test_advance_lands_on_a_time(sim):
    for until in (0.013, 0.02, 0.1234567, 0.3):
        assert sim.advance(until=until).time == until == sim.time
    sim.advance(steps=2)
    assert sim.time == pytest.approx(0.34)
    with pytest.raises(gxrod.Error, match="not after"):
        sim.advance(until=0.1)
    with pytest.raises(TypeError):
        sim.advance()
    sim.advance(until=7.0)
    assert sim.time == 0.5 and sim.finished


def test_on_step_and_its_end(sim):
    times, start = [], sim.save()
    summary = sim.run(on_step=lambda each: times.append(each.time) or each.time < 0.19)
    assert times[-1] == 0.2 and summary.status == "interrupted"
    sim.restore(start)
    sim.run(on_step=lambda each: each["tip"].position[2] > -1e-3)  # NumPy's False
    assert sim.time < 0.2 and sim["tip"].position[2] < -1e-3


def test_exceptions_of_callbacks_come_through(sim):
    def fail(_):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        sim.run(on_step=fail)
    assert sim.time == 0.02
    sim.step()


def test_progress(sim, capsys):
    sim.run(progress=True)
    assert "100" in capsys.readouterr().err


def test_failed_steps_say_why(deck):
    sim = gxrod.Simulation(deck.build({"load[0].moment": [0, "t < 0.1 ? 0 : 1e9", 0]}))
    with pytest.raises(gxrod.ConvergenceError) as caught:
        sim.run()
    error = caught.value
    assert error.time == pytest.approx(sim.time) and error.time_step < 0.02
    assert error.outcome and error.places and error.advice
    assert "the step from" in str(error)
    assert sim.finished and np.isfinite(sim.state.position).all()
    again = pickle.loads(pickle.dumps(error))
    assert again.time == error.time and str(again) == str(error)
    sim = gxrod.Simulation(deck.build({"load[0].moment": [0, "1/(t - 0.031)", 0]}))
    with pytest.raises(gxrod.EvaluationError, match="load"):
        sim.advance(until=0.031)


# What it is like.


def test_views_follow_the_simulation_without_a_copy(sim):
    position = sim.state.position
    assert position.shape == (5, 3) and not position.flags.writeable
    before = position.copy()
    sim.advance(steps=5)
    assert (position != before).any() and (position == sim.state.position).all()
    assert sim.state.orientation.shape == (5, 4)
    assert np.allclose(np.linalg.norm(sim.state.orientation, axis=1), 1.0)
    for name in ("velocity", "acceleration", "angular_velocity", "angular_acceleration", "rotation_vector"):
        assert getattr(sim.state, name).shape == (5, 3)
    with pytest.raises(ValueError):
        position[0, 0] = 1.0
    with pytest.raises(gxrod.UnknownNameError, match="position"):
        sim.state.positoin


def test_views_outlive_the_simulation(model):
    sim = gxrod.Simulation(model)
    sim.advance(steps=3)
    position = sim.state.position
    expected = position.copy()
    del sim
    gc.collect()
    assert (position == expected).all()


def test_points_without_a_history_get_one(tmp_path, model):
    """Between nodes, at the middle of an element of order 1, it is what a history of the deck records; the run is the same."""
    points = {"before": "arm@0.375", "end": "arm.end"}
    with gxrod.Simulation(model, results=tmp_path / "swing.vtkhdf", points=points, record=("tip", "before")) as sim:
        sim.run()
    alone = run_to_end(model.deck)
    assert (sim.state.position == alone.state.position).all() and (sim["end"].velocity == sim["tip"].velocity).all()
    nodes, element = sim.state.position[1:3], sim.elements
    assert sim["before"].position == pytest.approx(nodes.mean(axis=0), abs=1e-15)
    assert sim["before"].moment == pytest.approx(element.moment[1], rel=1e-12) and sim["before"].strain == pytest.approx(element.strain[1], rel=1e-12)
    assert sim.records["before"].acceleration.shape == (26, 3) and sim.model.histories == ["tip", "root", "before", "end"]
    written = gxrod.open_results(tmp_path / "swing.vtkhdf")
    assert (written["before"].curvature == sim.records["before"].curvature).all() and written["before"].at == "arm@0.375"
    with pytest.raises(gxrod.DeckError, match='^points: .*no point "arn@0.3"'):
        gxrod.Simulation(model, points={"before": "arn@0.3"})
    with pytest.raises(gxrod.DeckError, match="tip"):
        gxrod.Simulation(model, points={"tip": "arm@0.3"})


def test_points_go_with_what_else_is_changed(deck):
    changes = {"history[0].quantities": ["position"], "parameters.EI": 5.0}
    sim = gxrod.Simulation(deck.build(changes), points={"before": "arm@0.3"}, sensitivities="EI")
    sim.step()
    assert list(sim["tip"]) == ["position"] and sim["before"].derivative("EI").position.shape == (3,)
    tables = {"history": [{"name": "mine", "at": "arm.end", "quantities": ["position"]}]}
    assert gxrod.Simulation(deck.build(tables), points={"before": "arm@0.3"}).model.histories == ["mine", "before"]
    bare = gxrod.Deck.from_text(SWING[: SWING.index("[[history]]")])
    table = gxrod.map(bare, [{"parameters.EI": 5.0}], {"z": lambda sim: sim["before"].position[2]}, as_arrays=True, points={"before": "arm@0.3"})
    assert table["z"][0] < -1e-3
    top = gxrod.Simulation(EXAMPLES / "heavy_top" / "heavy_top.toml", points={"seen": "top"})
    assert {"position", "centre_of_mass", "angular_velocity_material"} <= set(top["seen"]) and "moment" not in top["seen"]


def test_names_that_are_not_there(sim, model):
    with pytest.raises(gxrod.UnknownNameError, match="tip"):
        sim["tpi"]
    with pytest.raises(gxrod.UnknownNameError, match="position"):
        sim["tip"].positoin
    with pytest.raises(gxrod.UnknownNameError, match="tendon"):
        sim.inputs["tendom"] = 1
    with pytest.raises(gxrod.UnknownNameError):
        gxrod.Simulation(model, record=["tpi"])
    with pytest.raises(gxrod.UnknownNameError):
        gxrod.Simulation(model, record=["tip"]).records.ledger
    with pytest.raises(gxrod.Error, match="cannot be nan"):
        sim.inputs["tendon"] = float("nan")
    assert "tip" in repr(sim)
    assert "[2. 0. 0.]" in repr(sim["tip"]) and "tendon  0" in repr(sim.inputs)
    assert list(gxrod.Simulation(model, record="tip").records["tip"]) == list(sim["tip"])


def test_matrices_are_derivatives_of_equilibrium(model):
    sparse = pytest.importorskip("scipy.sparse.linalg")
    static = gxrod.Deck.from_text(SWING.replace('kind = "dynamic"\nend_time = 0.5\ntime_step = 0.02', 'kind = "static"')).build()
    sim = gxrod.Simulation(static)
    sim.run()
    K, M = sim.tangent(), sim.mass_matrix()
    assert K.shape == M.shape == (24, 24) and sim.unknowns.shape == (24, 2)
    assert sim.damping_matrix().shape == (24, 24)
    # Frequencies are those of the modes of the program.
    modes = gxrod.Deck.from_text(SWING[: SWING.index("[analysis]")] + '[[stage]]\nname = "hang"\nkind = "static"\n[[stage]]\nname = "tones"\nkind = "modes"\ncount = 3\n')
    found = run_to_end(modes).summary.found[0]["shapes"]
    values = np.sort(np.linalg.eigvals(np.linalg.solve(M.toarray(), K.toarray())).real)[:3]
    assert np.sqrt(values) / (2 * np.pi) == pytest.approx([mode["frequency"] for mode in found], rel=1e-8)
    assert sparse.splu(K).solve(np.ones(24)).shape == (24,)


# Inputs, and back.


def test_inputs_count_from_the_next_step(sim):
    sim.advance(steps=3)
    sim.inputs["tendon"] = 2.0
    assert sim.inputs["tendon"] == 2.0 and dict(sim.inputs) == {"tendon": 2.0} and len(sim.inputs) == 1
    before = sim["tip"].position[2]
    sim.advance(steps=5)
    free = gxrod.Simulation(sim.model)
    free.advance(steps=8)
    assert sim["tip"].position[2] != free["tip"].position[2] and before != sim["tip"].position[2]
    with pytest.raises(TypeError):
        del sim.inputs["tendon"]


def test_restored_runs_repeat_to_the_last_bit(sim):
    sim.advance(until=0.117)
    sim.inputs["tendon"] = 1.0
    sim.step()
    point = sim.save()
    assert point.time == sim.time
    ends = []
    for each in (point, pickle.loads(pickle.dumps(point)), copy.copy(point)):
        sim.restore(each)
        assert sim.inputs["tendon"] == 1.0
        sim.run()
        ends.append([sim.state.position.copy(), sim.state.velocity.copy(), sim.records["tip"].position, sim.records.time])
    for other in ends[1:]:
        for a, b in zip(ends[0], other):
            assert (a == b).all()
    other = gxrod.Simulation(gxrod.Deck.from_text(SWING.replace("elements = 4", "elements = 5")).build())
    with pytest.raises(gxrod.Error, match="another model"):
        other.restore(point)


def test_a_run_with_a_file_is_not_restored(tmp_path, model):
    with gxrod.Simulation(model, results=tmp_path / "a.vtkhdf") as sim:
        point = sim.save()
        sim.step()
        with pytest.raises(gxrod.Error, match="writes results"):
            sim.restore(point)


def test_models_and_decks_can_be_pickled(deck):
    model = pickle.loads(pickle.dumps(deck.build({"parameters.EI": 5.0})))
    assert model.overrides == {"parameters.EI": 5.0}
    assert (run_to_end(model.deck, model.overrides).state.position == run_to_end(deck, {"parameters.EI": 5.0}).state.position).all()


# Threads.


def test_simulations_in_threads_have_equal_bits(model):
    ends, errors = [None] * 4, []

    def drive(index):
        try:
            sim = gxrod.Simulation(model)
            while not sim.finished:
                sim.inputs["tendon"] = np.sin(10 * sim.time)
                sim.step()
            ends[index] = sim.state.position.copy()
        except Exception as error:
            errors.append(error)

    threads = [threading.Thread(target=drive, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not errors
    assert all((end == ends[0]).all() for end in ends)


def test_other_threads_run_while_it_advances(deck):
    sim = gxrod.Simulation(deck.build({"rod.arm.elements": 2000, "analysis.end_time": 1000}))
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(1e-3)

    thread = threading.Thread(target=count)
    thread.start()
    begin = time.perf_counter()
    sim._core.advance(None, 20)
    elapsed = time.perf_counter() - begin
    stop.set()
    thread.join()
    assert counted[0] > 20 * elapsed


def test_ctrl_c_ends_it_after_the_step_at_hand(deck):
    sim = gxrod.Simulation(deck.build({"analysis.end_time": 1e6}))
    timer = threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        sim.run()
    timer.join()
    reached = sim.time
    assert 0.0 < reached < 1e6
    sim.step()
    assert sim.time == pytest.approx(reached + 0.02)


def test_h5py_before_and_after(tmp_path, model):
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "mine.h5", "w") as mine:
        mine["a"] = 1.0
        with gxrod.Simulation(model, results=tmp_path / "swing.vtkhdf") as sim:
            sim.run()
        mine["b"] = 2.0
    with h5py.File(tmp_path / "swing.vtkhdf") as file:
        assert len(file["histories/time"]) == 26


# What rests on it.


def test_map_reads_a_deck(tmp_path):
    (tmp_path / "swing.toml").write_text(SWING)
    table = gxrod.map(tmp_path / "swing.toml", [{}], {"tip": "tip.position"}, as_arrays=True)
    assert table["error"][0] is None


def test_map_runs_cases(deck):
    table = gxrod.map(deck, [{"parameters.EI": EI} for EI in (3.0, 6.0, -1.0)], {"lowest": lambda sim: sim.records["tip"].position[:, 2].min()},
                      as_arrays=True)
    assert table["lowest"][0] < table["lowest"][1] < 0 and np.isnan(table["lowest"][2])
    assert table["error"][0] is None and "EI" in table["error"][2]


def test_forces_in_sections_are_there_after_a_return(model):
    sim = gxrod.Simulation(model, points={"quarter": "arm@0.3"})
    starts = []
    for _ in range(2):
        starts.append((sim.save(), sim["root"].moment, sim["quarter"].force))
        sim.advance(until=sim.time + 0.2)
    for start, moment, force in starts:
        sim.restore(start)
        np.testing.assert_allclose(sim["root"].moment, moment, rtol=1e-13)
        np.testing.assert_allclose(sim["quarter"].force, force, rtol=1e-10)
    assert np.abs(starts[1][1]).max() > 1


def test_an_environment_is_reset_to_the_last_bit(deck):
    pytest.importorskip("gymnasium")
    env = gxrod.gym.RodEnv(deck, {"tendon": (-2.0, 2.0)}, ["tip.position", "ledger.energy_error", "time"], 0.05, lambda sim, action: -abs(action[0]))
    runs = []
    for _ in range(2):
        seen = [env.reset(seed=1)[0]]
        truncated = False
        while not truncated:
            observation, reward, _, truncated, _ = env.step([1.5])
            seen.append(observation)
        runs.append(np.array(seen))
    assert reward == -1.5 and len(runs[0]) == 11
    assert (runs[0] == runs[1]).all()


@pytest.mark.parametrize("name", ["beck", "post_buckling", "spatial_slider_crank", "rubin2007"])
def test_examples_run(name):
    sim = gxrod.Simulation(EXAMPLES / name / f"{name}.toml")
    assert sim.run().status == "complete"
    assert sim.finished
