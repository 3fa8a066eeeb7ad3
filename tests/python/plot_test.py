"""Pictures from Python are those of gxrod-plot; pages are those of gxrod report."""

import os
import subprocess
import sys

import gxrod
import h5py
import numpy as np
import pytest
from conftest import PROGRAM, SOURCE

matplotlib = pytest.importorskip("matplotlib")
from gxrod.plot import style  # noqa: E402 — after it is known to be there


@pytest.mark.parametrize("deck, what", [("robot_arm", "shapes"), ("lateral_buckling", "found")])
def test_pictures_are_those_of_the_program(runs, tmp_path, deck, what):
    path = runs(deck)
    program = [sys.executable, "-B", SOURCE / "apps" / "gxrod-plot", path, "--what", what, "-o", tmp_path / "program.png"]
    subprocess.run(program, check=True, capture_output=True, env={**os.environ, "GXROD_PLOT_PYTHON": "none"})
    figure = gxrod.open_results(path).plot(what)
    with matplotlib.rc_context(style.SETTINGS):
        figure.savefig(tmp_path / "here.png")
    assert (tmp_path / "here.png").read_bytes() == (tmp_path / "program.png").read_bytes()
    matplotlib.pyplot.close("all")


def test_shapes_are_drawn_by_their_real_parts(runs):
    from gxrod.plot.found import read_found

    [found] = read_found(gxrod.open_results(runs("beck")))
    with h5py.File(runs("beck").with_name("beck.flutter.vtkhdf")) as file:
        moves = file["VTKHDF/PointData/displacement"][()]
    np.testing.assert_array_equal(found.shapes, moves.reshape(found.shapes.shape))
    assert [label.split()[0] for label in found.labels] == ["1", "2", "3", "4"]


def test_settings_of_the_user_stay(runs):
    import matplotlib.pyplot as plt

    before, backend = dict(plt.rcParams), matplotlib.get_backend()
    results = gxrod.open_results(runs("plank"))
    figure = results.plot("histories", history="tip/displacement", size=(4, 3), title="The tip")
    assert dict(plt.rcParams) == before and matplotlib.get_backend() == backend
    assert tuple(figure.get_size_inches()) == (4, 3)
    assert plt.fignum_exists(figure.number)
    plt.close("all")


def test_notebooks_get_a_figure_once(runs, monkeypatch):
    import matplotlib.pyplot as plt

    results = gxrod.open_results(runs("plank"))
    monkeypatch.setattr(matplotlib, "get_backend", lambda *_, **__: "module://matplotlib_inline.backend_inline")
    figure = results.plot("ledger")
    assert not plt.get_fignums() and figure.axes


def test_wrong_pictures_are_told(runs):
    results = gxrod.open_results(runs("plank"))
    with pytest.raises(gxrod.Error, match="there is no picture 'shape'; there are shapes, histories, ledger, found, stress, section, range, all"):
        results.plot("shape")
    with pytest.raises(gxrod.Error, match="there is no history 'tpi'"):
        results.plot("histories", history="tpi")


def test_without_matplotlib(runs, absent):
    results = gxrod.open_results(runs("plank"))
    absent("matplotlib")
    with pytest.raises(ImportError, match='pictures of gxrod need matplotlib: python3 -m pip install "?matplotlib'):
        results.plot()


def test_pages_are_those_of_the_program(runs, tmp_path, monkeypatch):
    path = runs("robot_arm")
    subprocess.run([PROGRAM, "report", path, "-o", tmp_path / "program.html"], check=True, capture_output=True)
    page = gxrod.open_results(path).show(height=500)
    assert page.html == (tmp_path / "program.html").read_text(encoding="utf-8")
    shown = page._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and 'height="500"' in shown and "<script" not in shown
    page.save(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == page.html
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    page.open()
    assert opened[0].startswith("file:///") and opened[0].endswith("report.html")
    assert "open() shows it in the browser" in repr(page)
