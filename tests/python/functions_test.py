"""Runs as functions with derivatives: their gradients against differences, and as functions of PyTorch and JAX."""

import numpy as np
import pytest
from conftest import SWING

import gxrod

if not gxrod._has_core():
    pytest.skip("gxrod has no compiled part here: it is built with -DGXROD_PYTHON_MODULE=ON", allow_module_level=True)

from gxrod.functions import RunFunction

SEEN = ["tip.position", "root.moment", "tip.orientation"]
DECK = gxrod.Deck.from_text(SWING)
PULLS = np.array([[0.4], [-0.7], [0.9], [0.2], [-0.3]])


def differ(function, x, weights, step=1e-5):
    gradient = np.zeros_like(x)
    for place in np.ndindex(x.shape):
        change = np.zeros_like(x)
        change[place] = step
        gradient[place] = np.sum(weights * (function(x + change) - function(x - change))) / (2 * step)
    return gradient


@pytest.mark.parametrize("records", [False, True, "control"])
@pytest.mark.parametrize("control_step", [None, 0.05])
@pytest.mark.parametrize("hold", ["step", "linear"])
def test_gradients_are_those_of_differences(hold, control_step, records):
    deck = gxrod.Deck.from_text(SWING.replace("value = 0\n", f'value = 0.3\nhold = "{hold}"\n'))
    run = RunFunction(deck, SEEN, ["EI"], ["tendon"], control_step, records)
    numbers = np.array([6.0])
    values = run(numbers, PULLS)
    states = len(PULLS) + 1 if control_step is None else 16  # steps of 0.02 that end at multiples of 0.05 too
    assert values.shape == {False: (10,), True: (states, 10), "control": (6, 10)}[records]
    weights = np.random.default_rng(1).normal(size=values.shape)
    by_numbers, by_pulls = run.pull_back(numbers, PULLS, weights)
    np.testing.assert_allclose(by_numbers, differ(lambda x: run(x, PULLS), numbers, weights), rtol=1e-6)
    np.testing.assert_allclose(by_pulls, differ(lambda x: run(numbers, x), PULLS, weights), rtol=1e-5, atol=1e-9)


def test_derivatives_can_be_carried_along():
    run, carried = RunFunction(DECK, SEEN, ["EI"]), RunFunction(DECK, SEEN, ["EI"], carried=True)
    weights = np.arange(10.0)
    np.testing.assert_allclose(carried.pull_back([6.0], weights=weights)[0], run.pull_back([6.0], weights=weights)[0], rtol=1e-9)


def test_the_start_is_the_deck():
    run = RunFunction(DECK, ["tip.position"], ["EI"])
    assert run.start.tolist() == [6.0]
    sim = gxrod.Simulation(DECK)
    sim.run()
    np.testing.assert_array_equal(run(run.start), sim["tip"].position)


@pytest.mark.parametrize(("arguments", "says"), [
    (dict(observations=[], parameters=["EI"]), "needs observations"), (dict(observations=["tip.position"]), "needs observations"),
    (dict(observations=["tip.position"], inputs=["tendom"]), "tendom"), (dict(observations=["tip.position"], parameters=["EJ"]), "EJ"),
    (dict(observations=["tip.position"], parameters=["EI"], records=True, carried=True), "neither inputs nor records"),
    (dict(observations=["tip.position"], inputs=["tendon"], control_step=0.0), "greater than 0")])
def test_what_cannot_be_a_function_is_refused(arguments, says):
    with pytest.raises(gxrod.Error, match=says):
        RunFunction(DECK, **arguments)


def test_wrong_values_are_refused():
    run = RunFunction(DECK, ["tip.position"], ["EI"], ["tendon"])
    for values, says in ((([6.0, 1.0], PULLS), "2 values were given for the 1 parameters"), (([6.0], [1.0]), r"expected \[T, 1\]"),
                         (([6.0], np.zeros((26, 1))), "the deck ends at t = 0.5 after 25 of 26")):
        with pytest.raises(gxrod.Error, match=says):
            run(*values)
    with pytest.raises(gxrod.Error, match="weights have the shape"):
        run.pull_back([6.0], PULLS, [1.0])


def test_torch():
    torch = pytest.importorskip("torch")
    import gxrod.torch

    run = gxrod.torch.torch_run(DECK, ["tip.position"], ["EI"], ["tendon"], records=True)
    numbers = torch.tensor([6.0], dtype=torch.float64, requires_grad=True)
    pulls = torch.tensor(PULLS, requires_grad=True)
    assert torch.autograd.gradcheck(run, (numbers, pulls), eps=1e-5, atol=1e-6, rtol=1e-4)
    # In single precision around it, and with a network before it.
    network = torch.nn.Linear(1, 5)
    seen = gxrod.torch.torch_run(DECK, ["tip.position"], inputs="tendon")(network(torch.ones(1)).reshape(5, 1))
    assert seen.dtype == torch.float32 and seen.shape == (3,)
    seen.sum().backward()
    assert network.weight.grad.abs().min() > 0
    with pytest.raises(TypeError, match="the parameters and the inputs"):
        run(numbers)


def test_jax():
    jax = pytest.importorskip("jax")
    import gxrod.jax

    jax.config.update("jax_enable_x64", True)
    jnp = jax.numpy
    run = gxrod.jax.jax_run(DECK, ["tip.position"], ["EI"], ["tendon"], records=True)
    numbers, pulls = jnp.array([6.0]), jnp.array(PULLS)

    def total(*arguments):
        return jnp.sum(run(*arguments) * jnp.arange(18.0).reshape(6, 3))

    gradients = jax.grad(total, (0, 1))(numbers, pulls)
    for compiled, plain in zip(jax.jit(jax.grad(total, (0, 1)))(numbers, pulls), gradients):
        np.testing.assert_array_equal(compiled, plain)
    np.testing.assert_allclose(gradients[0], differ(lambda x: np.array(total(x, pulls)), np.array([6.0]), 1.0), rtol=1e-6)
    np.testing.assert_allclose(gradients[1], differ(lambda x: np.array(total(numbers, x)), PULLS, 1.0), rtol=1e-5)
    end = gxrod.jax.jax_run(DECK, ["tip.position"], ["EI"])
    many = jax.vmap(end)(jnp.array([[5.0], [6.0]]))
    np.testing.assert_array_equal(many[1], end(numbers))
    assert jax.jacrev(end)(numbers).shape == (3, 1)


@pytest.mark.parametrize("name", ["torch", "jax"])
def test_without_the_package(absent, monkeypatch, name):
    import sys

    monkeypatch.delitem(sys.modules, f"gxrod.{name}", raising=False)
    absent(name)
    with pytest.raises(ImportError, match=f"gxrod.{name} needs .*: python3 -m pip install {name}"):
        gxrod.__getattr__(name)
