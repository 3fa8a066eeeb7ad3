"""gxrod.batch runs the program, and gxrod.read_batch reads its table."""

import os
import signal
import threading
import time

import gxrod
import numpy as np
import pytest
from conftest import PLANK, read_csv
from conftest import gxrod as run_gxrod

PLAN = """deck = "plank.toml"
[vary]
"rod.plank.elements" = [2, 4]
"parameters.height" = [0.04, 0.05, 0.06]
"analysis.integrator" = ["newmark-simplified"]
[collect]
lowest = { history = "tip", quantity = "displacement", component = "z", take = "min" }
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "plank.toml").write_text(PLANK)
    (tmp_path / "sweep.toml").write_text(PLAN)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_batch_is_run_and_its_table_read(folder):
    assert str(gxrod.batch("sweep.toml", jobs=2, quiet=True)) == "sweep"
    table = gxrod.read_batch("sweep", as_arrays=True)
    written = read_csv(folder / "sweep" / "index.csv")
    assert list(table) == list(written)
    assert {name: column.dtype.kind for name, column in table.items()} == {
        "case": "i", "rod.plank.elements": "i", "parameters.height": "f", "analysis.integrator": "O", "status": "O", "reason": "O",
        "lowest": "f", "steps": "i", "newton_iterations": "i", "rejected_steps": "i", "time": "f", "seconds": "f", "results": "O", "warning": "O"}
    for name, texts in written.items():
        assert [type(value)(text) for value, text in zip(table[name].tolist(), texts)] == table[name].tolist()
    least = gxrod.open_results(folder / "sweep" / table["results"][0])["tip"].displacement[:, 2].min()
    assert table["lowest"][0] == least
    assert gxrod.read_batch(folder / "sweep" / "index.csv", as_arrays=True)["case"].tolist() == [1, 2, 3, 4, 5, 6]


def test_data_frames(folder):
    pandas = pytest.importorskip("pandas")
    table = gxrod.read_batch(gxrod.batch("sweep.toml", folder="here", only=(2, 3), quiet=True))
    assert isinstance(table, pandas.DataFrame) and table.case.tolist() == [2, 3]
    assert table.groupby("parameters.height").lowest.min().shape == (2,)


def test_without_pandas(folder, absent):
    absent("pandas")
    (folder / "index.csv").write_text("case,status\n1,done\n")
    assert gxrod.read_batch(folder, as_arrays=True)["case"].tolist() == [1]
    with pytest.raises(ImportError, match='python3 -m pip install "?pandas'):
        gxrod.read_batch(folder)


def test_cases_that_fail_are_rows(folder, capfd):
    (folder / "sweep.toml").write_text(PLAN.replace("[0.04, 0.05, 0.06]", "[0.05]").replace("[collect]", '"parameters.E" = [1e-9, 11e9]\n[collect]'))
    gxrod.batch("sweep.toml")
    table = gxrod.read_batch("sweep", as_arrays=True)
    assert table["status"].tolist() == ["failed", "done", "failed", "done"]
    assert table["reason"][0].startswith("the step from t = ") and table["reason"][1] == ""
    assert "failed: the step from t = " in capfd.readouterr().err  # said meanwhile


def test_cells_are_what_they_look_like(folder):
    (folder / "index.csv").write_text("case,flag,some,expression,status,lowest,steps,time,none\n1,true,true,2*EI,done,-1,10,1,\n"
                                      "2,false,,3,failed,,,2,\n3,true,false,0.5,done,nan,12,3,\n4,tr")
    table = gxrod.read_batch(folder, as_arrays=True)
    assert table["case"].tolist() == [1, 2, 3]  # the last row is being written
    assert table["flag"].tolist() == [True, False, True]
    assert table["some"].tolist() == ["true", "", "false"]
    assert table["expression"].tolist() == ["2*EI", "3", "0.5"]
    np.testing.assert_array_equal(table["lowest"], [-1.0, np.nan, np.nan])
    np.testing.assert_array_equal(table["steps"], [10.0, np.nan, 12.0])
    assert table["time"].dtype == float and table["case"].dtype == int
    assert np.isnan(table["none"]).all()


def test_faults_have_their_places(folder):
    (folder / "sweep.toml").write_text(PLAN.replace("parameters.height", "parameters.heigth"))
    with pytest.raises(gxrod.DeckError) as error:
        gxrod.batch("sweep.toml", quiet=True)
    fault = error.value.faults[0]
    assert (fault.file, fault.line, fault.column, fault.key) == ("sweep.toml", 4, 1, 'vary."parameters.heigth"')
    assert fault.message == 'the deck has no parameter "heigth"; did you mean "height"?'


def test_errors_have_the_programs_words(folder, monkeypatch):
    with pytest.raises(gxrod.FileError, match=r"^nope.toml: cannot be read \(No such file or directory\)$"):
        gxrod.batch("nope.toml", quiet=True)
    with pytest.raises(gxrod.Error, match="--jobs: Value 0 not in range"):
        gxrod.batch("sweep.toml", jobs=0, quiet=True)
    with pytest.raises(gxrod.FileError, match="cannot be read: No such file or directory; gxrod.batch writes it"):
        gxrod.read_batch("none")
    (folder / "other.csv").write_text("a,b\n1,2\n")
    with pytest.raises(gxrod.FileError, match="is not the table of a batch"):
        gxrod.read_batch("other.csv")
    monkeypatch.setenv("GXROD_PROGRAM", str(folder / "none"))
    with pytest.raises(gxrod.FileError, match="none: cannot be run: No such file or directory"):
        gxrod.batch("sweep.toml")


def test_a_program_that_is_nowhere(monkeypatch):
    monkeypatch.delenv("GXROD_PROGRAM")
    monkeypatch.setenv("PATH", "")
    if gxrod.program.__file__.startswith(os.environ.get("GXROD_SOURCE", "?") + "/apps/"):
        with pytest.raises(gxrod.FileError, match="name it in the environment variable GXROD_PROGRAM"):
            gxrod.program.find_program()


def test_ctrl_c_ends_the_batch_after_the_cases_at_hand(folder):
    (folder / "sweep.toml").write_text(PLAN.replace("[0.04, 0.05, 0.06]", "{ from = 0.04, to = 0.06, count = 2000 }"))
    def interrupt():
        while running and not (table.exists() and table.stat().st_size > 500):
            time.sleep(0.02)
        os.kill(os.getpid(), signal.SIGINT)

    table, running = folder / "sweep" / "index.csv", [True]
    thread = threading.Thread(target=interrupt)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            gxrod.batch("sweep.toml", quiet=True)
    finally:
        running.clear()
        thread.join()
    table = gxrod.read_batch("sweep", as_arrays=True)
    assert 0 < len(table["case"]) < 4000 and set(table["status"]) == {"done"}
    assert sorted(str(path) for path in (folder / "sweep" / "cases").iterdir()) == [str(folder / "sweep" / name) for name in table["results"]]


FATIGUE_PLAN = """deck = "plank.toml"
[vary]
"parameters.height" = [0.04, 0.05]
[collect]
damage = { history = "clamp", quantity = "moment", component = "y", damage = { slope = 4, cycles = 1e6, at = 900, second_slope = 6, factor = 1.1, from = 0.1 } }
detail = { history = "clamp", quantity = "moment", component = "y", damage = { detail = 800, ultimate = 9000 } }
load = { history = "clamp", quantity = "moment", component = "y", range = { slope = 4, cycles = 20 } }
"""


def test_fatigue_is_collected_as_it_is_counted_in_python(tmp_path):
    if not gxrod._has_core():
        pytest.skip("gxrod has no compiled part here: it is built with -DGXROD_PYTHON_MODULE=ON")
    deck = PLANK.replace("-800*t", "-300*sin(40*t) - 150*sin(17*t)") + '[[history]]\nname = "clamp"\nat = "plank.start"\nquantities = ["moment"]\n'
    (tmp_path / "plank.toml").write_text(deck)
    (tmp_path / "plan.toml").write_text(FATIGUE_PLAN)
    run_gxrod("batch", "plan.toml", "-o", "out", folder=tmp_path)
    rows = read_csv(tmp_path / "out" / "index.csv")
    for i in range(2):
        history = gxrod.open_results(tmp_path / "out" / "cases" / f"000{i + 1}.vtkhdf")["clamp"]
        moment = history.moment[:, 1]
        late = moment[history.time >= 0.1]
        curve = gxrod.fatigue.SNCurve([(4, 1e6, 900), (6, 1e6, 900)], factor=1.1)
        assert float(rows["damage"][i]) == pytest.approx(gxrod.fatigue.damage(late, curve), rel=1e-12)
        assert float(rows["detail"][i]) == pytest.approx(gxrod.fatigue.damage(moment, gxrod.fatigue.SNCurve.eurocode(800), ultimate=9000), rel=1e-12)
        assert float(rows["load"][i]) == pytest.approx(gxrod.fatigue.equivalent_range(moment, 4, 20), rel=1e-12)
    assert rows["damage"][0] != rows["damage"][1]
