"""gxrod.gym.RodEnv as gymnasium wants environments."""

import sys
import warnings

import gxrod
import numpy as np
import pytest
from fakes import Deck, Simulation


def make(**options):
    defaults = {"actions": {"tendon": (-0.5, 1.0)}, "observations": ["tip.position", "tip.velocity", "time"], "control_step": 0.1,
                "reward": lambda sim, action: -abs(sim["tip"].position[0]), "simulation": Simulation}
    return gxrod.gym.RodEnv(Deck(end_time=1.0), **{**defaults, **options})


@pytest.fixture(autouse=True)
def needs_gymnasium():
    pytest.importorskip("gymnasium")


def test_gymnasium_accepts_it():
    from gymnasium.utils.env_checker import check_env

    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message=".*(infinity|symmetric|spec|render).*")
        warnings.simplefilter("error", category=DeprecationWarning)
        check_env(make(), skip_render_check=True)


def test_observations_are_the_quantities_one_after_the_other():
    env = make()
    observation, info = env.reset(seed=1)
    np.testing.assert_array_equal(observation, [1, 0, 0, 0, 0, 0, 0])
    assert info == {"time": 0.0}
    assert env.observation_names == ["tip.position[0]", "tip.position[1]", "tip.position[2]", "tip.velocity[0]", "tip.velocity[1]",
                                     "tip.velocity[2]", "time"]
    assert env.observation_space.shape == (7,) and env.action_space.shape == (1,)


def test_steps_hold_the_action_for_the_control_step():
    env = make()
    env.reset()
    observation, reward, terminated, truncated, info = env.step(np.array([0.25]))
    x = 0.25 + 0.75 * np.cos(0.1)  # x'' = 0.25 - x
    np.testing.assert_allclose(observation[[0, 3, 6]], [x, -0.75 * np.sin(0.1), 0.1], rtol=1e-14)
    assert reward == pytest.approx(-x) and (terminated, truncated) == (False, False) and info == {"time": 0.1}
    assert env.sim.inputs["tendon"] == 0.25


def test_actions_are_cut_to_their_limits():
    env = make()
    env.reset()
    env.step(np.array([7.0]))
    assert env.sim.inputs["tendon"] == 1.0


def test_reset_is_the_same_to_the_last_bit_and_sets_inputs_back():
    env = make()
    first = env.reset(seed=3)[0]
    moved = [env.step(np.array([0.3]))[0] for _ in range(4)]
    np.testing.assert_array_equal(env.reset(seed=3)[0], first)
    assert env.sim.inputs["tendon"] == 0.0
    np.testing.assert_array_equal([env.step(np.array([0.3]))[0] for _ in range(4)], moved)


def test_the_end_of_the_deck_truncates():
    env = make()
    env.reset()
    ends = [env.step(np.array([0.0]))[2:4] for _ in range(10)]
    assert ends == [(False, False)] * 9 + [(False, True)]
    assert env.sim.time == 1.0
    with pytest.raises(gxrod.Error, match=r"reset\(\) begins the next one"):
        env.step(np.array([0.0]))


def test_a_task_can_be_over_and_starts_can_differ():
    def start(sim, random, options):
        sim.inputs["tendon"] = options.get("pull", random.uniform())

    env = make(terminated=lambda sim: sim["tip"].position[0] < 0.9, on_reset=start)
    env.reset(seed=5)
    assert env.sim.inputs["tendon"] == np.random.default_rng(5).uniform()
    env.reset(options={"pull": 0.7})
    assert env.sim.inputs["tendon"] == 0.7
    assert [env.step(np.array([0.0]))[2] for _ in range(5)] == [False] * 4 + [True]


def test_a_step_that_fails_terminates():
    env = make(failure_reward=-100.0)
    env.sim.model.k = -1.0
    env.reset()
    observation, reward, terminated, truncated, info = env.step(np.array([0.0]))
    assert (reward, terminated, truncated) == (-100.0, True, False)
    assert info["error"] == "the step from t = 0 failed" and observation.shape == (7,)


def test_what_cannot_be_an_environment_is_refused():
    for wrong, says in (({"control_step": 0.0}, "control_step is 0.0"), ({"actions": {}}, "needs actions"),
                        ({"actions": {"tendon": (1.0, 1.0)}}, "a lower and a higher limit")):
        with pytest.raises(gxrod.Error, match=says):
            make(**wrong)
    with pytest.raises(KeyError):
        make(actions={"pull": (0.0, 1.0)})


def test_close_ends_the_simulation():
    env = make()
    env.close()
    assert not env.sim.is_open


def test_without_gymnasium(absent, monkeypatch):
    monkeypatch.delitem(sys.modules, "gxrod.gym", raising=False)
    absent("gymnasium")
    with pytest.raises(ImportError, match="gxrod.gym needs gymnasium: python3 -m pip install gymnasium"):
        gxrod.__getattr__("gym")
