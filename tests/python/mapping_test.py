"""gxrod.map: rows of many runs."""

import math
import threading
from concurrent.futures import Executor, Future, ProcessPoolExecutor

import gxrod
import numpy as np
import pytest
from fakes import Deck, Simulation

CASES = [{"parameters.k": k, "parameters.x": x} for k in (1.0, 4.0, 9.0) for x in (1.0, -2.0)]
EXPECTED = np.array([case["parameters.x"] * math.cos(math.sqrt(case["parameters.k"])) for case in CASES])


def end(sim):
    return sim["tip"].position[0]


def run(cases=CASES, collect=None, **options):
    return gxrod.map(Deck(), cases, collect or {"end": end}, as_arrays=True, simulation=Simulation, **options)


def test_rows_are_in_the_order_of_the_cases():
    table = run()
    assert list(table) == ["parameters.k", "parameters.x", "end", "error"]
    np.testing.assert_allclose(table["end"], EXPECTED, rtol=1e-14)
    np.testing.assert_array_equal(table["parameters.k"], [case["parameters.k"] for case in CASES])
    assert list(table["error"]) == [None] * len(CASES)


class Backwards(Executor):
    """Runs what it was given, the last first, when there is enough of it."""

    def __init__(self, count):
        self.waiting, self.count = [], count

    def submit(self, function, /, *arguments):
        future = Future()
        self.waiting.append((future, function, arguments))
        if len(self.waiting) == self.count:
            for each, call, its in reversed(self.waiting):
                each.set_running_or_notify_cancel()
                each.set_result(call(*its))
        return future


def test_any_executor_will_do():
    np.testing.assert_allclose(run(executor=Backwards(len(CASES)))["end"], EXPECTED, rtol=1e-14)


def test_processes_will_do():
    with ProcessPoolExecutor(2) as processes:
        with pytest.warns(UserWarning):
            table = run([*CASES[:2], {"parameters.k": -1.0}, {"parameters.q": 1.0}], executor=processes)
    np.testing.assert_allclose(table["end"][:2], EXPECTED[:2], rtol=1e-14)
    assert list(table["error"]) == [None, None, "the step from t = 0 failed", "arm.toml:3:1: parameters.q: unknown key"]


def test_what_processes_cannot_have_is_a_row_with_its_error():
    with ProcessPoolExecutor(1) as processes, pytest.warns(UserWarning, match="1 of 1 cases failed"):
        table = run(CASES[:1], {"end": lambda sim: 0.0}, executor=processes)
    assert "<lambda>" in table["error"][0]


def test_threads_run_at_once():
    meeting = threading.Barrier(2, timeout=10)

    class Meeting(Simulation):
        def run(self):
            meeting.wait()
            super().run()

    if gxrod.mapping.count_cores() > 1:
        table = gxrod.map(Deck(), CASES[:2], {"end": end}, as_arrays=True, simulation=Meeting)
        np.testing.assert_allclose(table["end"], EXPECTED[:2])


def test_what_is_collected():
    """By a function, by the name of a quantity, or all by one function."""
    table = run(collect={"tip": "tip.position", "error of energy": "ledger.energy_error", "t": "time", "name": lambda sim: "spring",
                         "whole": lambda sim: 3})
    assert list(table)[2:] == ["tip[0]", "tip[1]", "tip[2]", "error of energy", "t", "name", "whole", "error"]
    np.testing.assert_allclose(table["tip[0]"], EXPECTED, rtol=1e-14)
    assert table["t"].tolist() == [1.0] * 6 and table["name"].tolist() == ["spring"] * 6
    assert table["whole"].dtype.kind == "i"
    table = run(collect=lambda sim: {"a": end(sim), "b": sim.time > 0.5})
    np.testing.assert_allclose(table["a"], EXPECTED, rtol=1e-14)
    assert table["b"].dtype == bool


def test_a_history_alone_is_no_quantity():
    with pytest.raises(gxrod.Error, match="'tip' is no quantity; expected .* \"tip.position\""):
        gxrod.map(Deck(), [{}], {"end": "tip"}, simulation=Simulation, as_arrays=True, on_error="raise")


def test_failures_are_rows():
    cases = [CASES[0], {"parameters.k": -1.0}, {"parameters.q": 1.0}, CASES[1]]
    with pytest.warns(UserWarning, match="2 of 4 cases failed; the column 'error' says why"):
        table = run(cases)
    np.testing.assert_allclose(table["end"], [EXPECTED[0], np.nan, np.nan, EXPECTED[1]])
    assert list(table["error"]) == [None, "the step from t = 0 failed", "arm.toml:3:1: parameters.q: unknown key", None]
    np.testing.assert_array_equal(table["parameters.q"], [np.nan, np.nan, 1.0, np.nan])
    with pytest.warns(UserWarning):
        assert run(CASES[:1], {"end": lambda sim: 1 / 0})["error"][0] == "ZeroDivisionError: division by zero"


def test_the_first_error_is_raised_if_asked_for():
    with pytest.raises(gxrod.ConvergenceError) as error:
        run([{"parameters.k": -1.0}] * 3, on_error="raise")
    assert error.value.places == ("arm.end (y)",)
    with pytest.raises(ValueError, match="on_error"):
        run(on_error="ignore")


def test_simulations_get_their_options_and_are_closed():
    seen = []

    class Seen(Simulation):
        def __init__(self, model, **options):
            super().__init__(model, **options)
            seen.append(self)

    gxrod.map(Deck(), CASES, {"end": end}, as_arrays=True, simulation=Seen, record=("tip",))
    assert len(seen) == len(CASES) and all(sim.record == ("tip",) and not sim.is_open for sim in seen)


def test_progress(capsys):
    run(progress=True)
    assert capsys.readouterr().err.endswith("\r6 of 6 cases\n")
    seen = []
    run(progress=lambda *counts: seen.append(counts))
    assert seen == [(i, 6) for i in range(1, 7)]


def test_names_must_differ_from_keys():
    deck = Deck()
    for name in ("parameters.k", "error"):
        with pytest.raises(gxrod.Error, match=f"{name}: what is collected has the name of a key"):
            gxrod.map(deck, CASES, {name: end}, as_arrays=True, simulation=Simulation)
    assert deck.builds == 0
    with pytest.warns(UserWarning, match="6 of 6"):
        assert run(collect=lambda sim: {"error": 1.0})["error"][0].startswith("error: what is collected has the name")


def test_what_fits_no_row_fails_its_case_only():
    with pytest.warns(UserWarning, match="1 of 6"):
        table = run(collect={"end": lambda sim: np.eye(2) if sim.model.k == 9.0 and sim.model.x == 1.0 else end(sim)})
    assert table["error"][4] == "end is an array [2, 2]; expected a number or an array of numbers"
    np.testing.assert_allclose(table["end"][[0, 1, 2, 3, 5]], EXPECTED[[0, 1, 2, 3, 5]])


def test_cases_can_change_arrays():
    deck = Deck(**{"load[0].force": None})
    cases = [{"load[0].force": [0, 0, i]} for i in range(3)]
    table = gxrod.map(deck, cases, {"end": end}, as_arrays=True, simulation=Simulation)
    assert table["load[0].force"].tolist() == [[0, 0, 0], [0, 0, 1], [0, 0, 2]]


def test_no_cases_are_an_empty_table():
    assert run([])["error"].shape == (0,)


def test_tables_of_pandas():
    pandas = pytest.importorskip("pandas")
    cases = pandas.DataFrame(CASES)
    table = gxrod.map(Deck(), cases, {"end": end}, simulation=Simulation)
    pandas.testing.assert_frame_equal(table[list(cases)], cases)
    np.testing.assert_allclose(table.end, EXPECTED, rtol=1e-14)
    assert table.error.isna().all()


def test_without_pandas_it_says_so_before_it_runs(absent):
    absent("pandas")
    deck = Deck()
    with pytest.raises(ImportError, match='python3 -m pip install "?pandas'):
        gxrod.map(deck, CASES, {"end": end}, simulation=Simulation)
    assert deck.builds == 0
