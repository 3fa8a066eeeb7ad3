"""Results of a run that is going on."""

import subprocess
import time

import gxrod
import numpy as np
import pytest
from conftest import PLANK, PROGRAM
from conftest import gxrod as run_gxrod


def wait_for(condition, seconds=20.0):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "it did not happen in time"
        time.sleep(0.02)


@pytest.fixture
def running(tmp_path):
    """The results of a run of minutes, which is killed in the end; and its process."""
    (tmp_path / "long.toml").write_text(PLANK.replace("end_time = 0.5", "end_time = 1000").replace("-800*t", "-80*sin(t)"))
    process = subprocess.Popen([PROGRAM, "run", "long.toml", "--quiet"], cwd=tmp_path, stderr=subprocess.DEVNULL)
    path = tmp_path / "long.vtkhdf"
    try:
        wait_for(path.exists)
        results = None

        def has_steps():
            nonlocal results
            try:
                results = gxrod.open_results(path)
            except gxrod.FileError:  # before the first steps are written
                return False
            return len(results.time) > 20

        wait_for(has_steps)
        yield results, process
    finally:
        process.kill()
        process.wait()


def test_all_arrays_end_with_the_step_that_was_last_at_opening(running):
    results, process = running
    steps, frames = len(results.time), len(results.frames)
    wait_for(lambda: len(gxrod.open_results(results.path).time) > steps + 50)
    assert process.poll() is None and results.status == "running"
    for record in (results["tip"], results.ledger, results.solver):
        for values in record.values():
            assert len(values) == steps
    assert len(results.frames) == frames == len(results.frames.position)
    assert results.doubt() == ""


def test_refresh_sees_what_has_come_since_and_changes_nothing_before(running):
    results, _ = running
    steps, before = len(results.time), results["tip"].displacement
    wait_for(lambda: len(results.refresh().time) > steps)
    after = results["tip"].displacement
    assert len(after) == len(results.time) > steps
    np.testing.assert_array_equal(after[:steps], before)


def test_readings_while_it_writes_are_whole(running):
    results, process = running
    for _ in range(25):
        results.refresh()
        tip = results["tip"].displacement
        assert np.isfinite(tip).all() and (np.diff(results.time) > 0).all()
        assert np.isfinite(results.frames[-1].position).all()
    assert process.poll() is None


def test_a_killed_run_is_read_to_its_last_step(running):
    results, process = running
    process.kill()
    process.wait()
    results.refresh()
    assert results.status == "running"
    assert len(results["tip"].displacement) == len(results.time) > 20


def test_a_file_that_another_run_has_replaced_is_not_mixed_up(tmp_path):
    (tmp_path / "plank.toml").write_text(PLANK)
    run = lambda *more: run_gxrod("run", "plank.toml", "--quiet", *more, folder=tmp_path)
    run()
    results = gxrod.open_results(tmp_path / "plank.vtkhdf")
    run("--force", "--set", "analysis.end_time=0.2")
    with pytest.raises(gxrod.FileError, match="another run has replaced it"):
        results["tip"].displacement
    assert len(results.refresh()["tip"].displacement) == 21
    run("--force", "--set", "analysis.end_time=1.0", "--set", "analysis.time_step=0.02")
    with pytest.raises(gxrod.FileError, match="refresh"):
        results.ledger.energy_error
