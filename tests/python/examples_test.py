"""The scripts of docs/examples/python run as they stand, and their pages state what they print."""

import re
import sys
from types import SimpleNamespace

import gxrod
import numpy as np
import pytest
from conftest import EXAMPLES, SOURCE

pyplot = pytest.importorskip("matplotlib.pyplot")
if not gxrod._has_core():
    pytest.skip("the compiled part is missing", allow_module_level=True)

FOLDER = EXAMPLES / "python"


@pytest.fixture
def run(tmp_path, monkeypatch, capsys):
    """A function of an example's name: what its script leaves, as attributes, and `printed`."""
    (tmp_path / "docs").symlink_to(SOURCE / "docs")
    monkeypatch.chdir(tmp_path)

    def run_script(name):
        script = FOLDER / name / f"{name}.py"
        space = {"__name__": "__main__"}
        exec(compile(script.read_text(encoding="utf-8"), script, "exec"), space)
        assert (tmp_path / f"{name}.png").stat().st_size > 20000
        return SimpleNamespace(**{key: value for key, value in space.items() if key != "__name__"}, printed=capsys.readouterr().out)

    yield run_script
    pyplot.close("all")


def page_of(name):
    return (FOLDER / name / "README.md").read_text(encoding="utf-8")


def is_stated(name, printed):
    """Whether the second block of the page is what the script prints, its numbers to 2 %."""
    stated = re.findall(r"^```\n(.*?)^```", page_of(name), re.MULTILINE | re.DOTALL)[1]
    number = r"\d+(?:\.\d+)?(?:e[+-]?\d+)?"
    assert re.sub(r" +", " ", re.sub(number, "#", stated)) == re.sub(r" +", " ", re.sub(number, "#", printed)), printed
    np.testing.assert_allclose(*([float(each) for each in re.findall(number, text)] for text in (printed, stated)), rtol=0.02, atol=0.011)
    return True


def test_each_has_page_picture_and_command():
    folders = [path for path in FOLDER.iterdir() if path.is_dir()]
    assert len(folders) == 10
    guide = (SOURCE / "docs" / "guide" / "python.md").read_text(encoding="utf-8")
    for folder in folders:
        name = folder.name
        assert (folder / f"{name}.png").exists()
        assert f"python3 docs/examples/python/{name}/{name}.py\n" in page_of(name)
        assert f"](../examples/python/{name}/README.md)" in guide
        assert f"test_{name}" in globals()


def test_controller(run):
    done = run("controller")
    assert is_stated("controller", done.printed)
    assert len(done.pulls) == 301 and done.sim.time == 6.0
    # The pulls at which the tip rests are those of equilibria.
    text = done.sim.model.deck.text
    text = text[: text.index("[analysis]")] + '[analysis]\nkind = "static"\nsteps = 20\n[[history]]\nname = "tip"\nat = "arm.end"\nquantities = ["position"]\n'
    for end, height in ((3, 0.04), (6, -0.1)):
        pull = np.interp(end, done.times, done.pulls)
        rest = gxrod.Simulation(gxrod.Deck.from_text(text).build({"input.tendon.value": pull}))
        rest.run()
        assert rest["tip"].position[2] == pytest.approx(height, abs=5e-4)


def test_planned(run):
    done = run("planned")
    assert is_stated("planned", done.printed)
    assert done.best.x.min() >= 0 and done.settled < 0.5
    # The gradient there is that of differences.
    value, gradient = done.cost(done.best.x)
    for step in (10, 70):
        change = 1e-2 * (np.arange(100) == step)
        difference = (done.cost(done.best.x + change)[0] - done.cost(done.best.x - change)[0]) / 2e-2
        assert gradient[step] == pytest.approx(difference, rel=1e-3, abs=1e-5)


def test_environment(run):
    pytest.importorskip("gymnasium")
    done = run("environment")
    assert is_stated("environment", done.printed)
    rewards = {name: total for name, (_, total) in done.episodes.items()}
    assert rewards["controlled"] > rewards["constant"] > rewards["random"] > rewards["strongest"]
    assert len(done.episodes["controlled"][0]) == 301


def test_sobol(run):
    pytest.importorskip("SALib")
    done = run("sobol")
    assert is_stated("sobol", done.printed)
    # In first order a share is the square of the slope times the range of what varies; here by differences of whole runs.
    names = done.problem["names"]
    middle = {name: (low + high) / 2 for name, (low, high) in zip(names, done.problem["bounds"])}

    def lowest(changed):
        sim = gxrod.Simulation(done.deck.build({**middle, **changed}))
        sim.run()
        return sim.records["tip"].displacement[:, 2].min()

    shares = np.array([(lowest({name: high}) - lowest({name: low})) ** 2 for name, (low, high) in zip(names, done.problem["bounds"])])
    for found in (done.found["ST"], done.shares):
        np.testing.assert_allclose(shares / shares.sum(), found, atol=0.02)


def test_identification(run):
    pytest.importorskip("scipy")
    done = run("identification")
    assert is_stated("identification", done.printed)
    assert done.runs_exact < done.runs_differences
    np.testing.assert_allclose(done.other.x, done.found.x, rtol=1e-6)
    # The derivatives, against differences of whole runs, extrapolated.
    x, steps = done.TRUE, 1e-3 * done.TRUE

    def difference(i, h):
        h = h * np.eye(2)[i] * steps
        return (done.positions(x + h) - done.positions(x - h)) / (2 * h[i])

    for i in range(2):
        expected = (4 * difference(i, 0.5) - difference(i, 1)) / 3
        np.testing.assert_allclose(done.at_truth[:, i], expected, atol=1e-7 * np.abs(expected).max())
    # 40 fits find deviations to 11 %.
    np.testing.assert_allclose(np.sqrt(np.diag(done.scatter) / np.diag(done.expected)), 1, atol=3 / np.sqrt(2 * len(done.fits)))
    away = done.fits - done.TRUE
    by_ellipse = np.einsum("ni,ij,nj->n", away, np.linalg.inv(done.expected), away)
    far = done.fits[by_ellipse > 5.991]
    by_squares = np.array([np.sum((done.positions(x) - done.exact) ** 2) for x in far]) / done.NOISE**2
    assert len(far) == 4 and np.sum(by_squares > 5.991) == 2


def test_lightest(run):
    pytest.importorskip("scipy")
    done = run("lightest")
    assert is_stated("lightest", done.printed)
    assert done.best.success and abs(done.room(done.radii)) < 1e-6
    # Each piece of a lightest one takes as much off the deflection for its mass as any other.
    worth = done.room_gradient(done.radii) / done.radii
    np.testing.assert_allclose(worth, worth.mean(), rtol=1e-3)
    assert done.distance < 1e-9


def test_gradients(run):
    done = run("gradients")
    [[count, most, half]] = re.findall(r"^(\d+) derivatives, at most (\S+) from .* less than (\S+)$", page_of("gradients"), re.MULTILINE)
    assert done.distances.size == int(count)
    # Round-off, so within a factor of 3.
    assert done.distances.max() < 3 * float(most) and np.median(done.distances) < 3 * float(half)
    damping = done.distances[done.NAMES.index("damping")]
    assert [title.split()[0] for title, distance in zip(done.variants, damping) if distance == 0] == ["static", "static"]


if __name__ == "__main__":
    sys.exit(pytest.main([__file__]))


def test_jax_identify(run):
    pytest.importorskip("jax")
    done = run("jax_identify")
    assert is_stated("jax_identify", done.printed)
    assert done.distance < 1e-5  # the gradient from that of differences
    assert (np.abs(done.numbers - done.TRUE) < 3 * done.deviations).all()


def test_torch_control(run):
    pytest.importorskip("torch")
    done = run("torch_control")
    assert is_stated("torch_control", done.printed)
    assert done.exact == pytest.approx(done.difference, rel=1e-5)
    assert done.worst < 0.012 and done.misses[-1] < 0.05 * done.misses[0]


def test_fmu_control(run):
    pytest.importorskip("fmpy")
    done = run("fmu_control")
    assert is_stated("fmu_control", done.printed)
    assert done.problems == [] and done.difference == 0.0
