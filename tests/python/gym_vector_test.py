"""gxrod.gym.RodVectorEnv: many environments at once, each with the numbers that it has alone."""

import warnings

import numpy as np
import pytest
from conftest import SWING

import gxrod

pytest.importorskip("gymnasium")
pytest.importorskip("gxrod._core")

SEEN = ["tip.position", "time", "root.moment", "ledger.kinetic_energy"]
ACTIONS = {"tendon": (-2.0, 2.0)}


def make(count=3, **options):
    given = {"reward": lambda seen, actions: -seen[:, 2] + actions[:, 0], "threads": 2, **options}
    return gxrod.gym.RodVectorEnv(gxrod.Deck.from_text(SWING), count, ACTIONS, SEEN, 0.1, **given)


def mode(name):
    from gymnasium.vector import AutoresetMode

    return AutoresetMode[name]


def test_gymnasium_accepts_it():
    envs = make()
    seen, infos = envs.reset(seed=3)
    assert envs.observation_space.contains(seen) and envs.action_space.contains(envs.action_space.sample())
    assert envs.single_observation_space.shape == (len(envs.observation_names),) and envs.single_action_space.shape == (1,)
    assert infos["time"].tolist() == [0.0] * 3 and infos["_time"].all()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from gymnasium.wrappers.vector import RecordEpisodeStatistics

        wrapped = RecordEpisodeStatistics(envs)
        wrapped.reset(seed=1)
        for _ in range(6):
            infos = wrapped.step(wrapped.action_space.sample())[4]
    assert envs.metadata["autoreset_mode"] == mode("NEXT_STEP")


def test_each_has_the_numbers_that_it_has_alone():
    envs = make()
    alone = [gxrod.gym.RodEnv(gxrod.Deck.from_text(SWING), ACTIONS, SEEN, 0.1, lambda sim, action: -sim["tip"].position[2] + action[0]) for _ in range(3)]
    assert envs.observation_names == alone[0].observation_names
    pulls = np.random.default_rng(1).uniform(-3.0, 3.0, (5, 3, 1))  # some are cut to their limits
    for episode in range(2):
        np.testing.assert_array_equal(envs.reset()[0], [env.reset()[0] for env in alone])
        for pull in pulls:
            seen, rewards, terminated, truncated, infos = envs.step(pull)
            single = [env.step(one) for env, one in zip(alone, pull)]
            np.testing.assert_array_equal(seen, [one[0] for one in single])
            np.testing.assert_array_equal(rewards, [one[1] for one in single])
            assert truncated.tolist() == [one[3] for one in single] and not terminated.any()
            assert infos["time"].tolist() == [one[4]["time"] for one in single]
        assert truncated.all()


def test_next_step_mode_begins_again_without_an_action():
    envs = make(terminated=lambda seen: np.array([False, True, False]) & (seen[:, 3] > 0.15))
    first = envs.reset()[0]
    envs.step(np.ones((3, 1)))
    seen, _, terminated, _, _ = envs.step(np.ones((3, 1)))
    assert terminated.tolist() == [False, True, False]
    seen, rewards, terminated, truncated, infos = envs.step(np.ones((3, 1)))
    np.testing.assert_array_equal(seen[1], first[1])
    assert rewards[1] == 0.0 and not terminated.any() and not truncated.any() and infos["time"].tolist() == pytest.approx([0.3, 0.0, 0.3])


def test_same_step_mode_hands_out_the_last_observation():
    envs = make(autoreset_mode=mode("SAME_STEP"))
    first = envs.reset()[0]
    for _ in range(5):
        seen, rewards, _, truncated, infos = envs.step(np.ones((3, 1)))
    assert truncated.all() and infos["time"].tolist() == [0.0] * 3
    np.testing.assert_array_equal(seen, first)
    last = np.stack(list(infos["final_obs"]))
    assert last[:, 3].tolist() == pytest.approx([0.5] * 3)
    np.testing.assert_array_equal(rewards, -last[:, 2] + 1.0)


def test_disabled_mode_resets_by_a_mask():
    envs = make(autoreset_mode=mode("DISABLED"), terminated=lambda seen: np.array([True, False, False]))
    envs.reset()
    envs.step(np.ones((3, 1)))
    with pytest.raises(gxrod.Error, match="reset_mask"):
        envs.step(np.ones((3, 1)))
    seen, infos = envs.reset(options={"reset_mask": np.array([True, False, False])})
    assert seen[:, 3].tolist() == pytest.approx([0.0, 0.1, 0.1]) and infos["_time"].tolist() == [True, False, False]
    envs.step(np.ones((3, 1)))


def test_starts_differ_by_seeds():
    def start(sim, random, options):
        sim.inputs["tendon"] = options.get("pull", random.uniform())

    envs = make(on_reset=start)
    envs.reset(seed=5)
    pulls = [sim.inputs["tendon"] for sim in envs.sims]
    assert pulls == [np.random.default_rng(5 + i).uniform() for i in range(3)]
    envs.reset(options={"pull": 0.7})
    assert [sim.inputs["tendon"] for sim in envs.sims] == [0.7] * 3


def test_a_step_that_fails_terminates_its_environment_alone():
    deck = gxrod.Deck.from_text(SWING.replace('"tendon", 0]', '"tendon < 1.5 ? tendon : 1/0", 0]'))
    envs = gxrod.gym.RodVectorEnv(deck, 2, ACTIONS, ["tip.position"], 0.1, lambda seen, actions: np.ones(2), failure_reward=-9.0)
    envs.reset()
    _, rewards, terminated, truncated, infos = envs.step([[1.0], [1.9]])
    assert rewards.tolist() == [1.0, -9.0] and terminated.tolist() == [False, True] and not truncated.any()
    assert "is inf" in infos["error"][1] and infos["_error"].tolist() == [False, True]
    assert envs.step([[1.0], [1.0]])[1].tolist() == [1.0, 0.0]


def test_what_cannot_be_is_refused():
    with pytest.raises(gxrod.Error, match="at least 1"):
        make(0)
    envs = make(reward=lambda seen, actions: 1.0)
    envs.reset()
    with pytest.raises(gxrod.Error, match=r"answer an array \(3,\)"):
        envs.step(np.zeros((3, 1)))
    with pytest.raises(gxrod.Error, match="reset_mask has the shape"):
        envs.reset(options={"reset_mask": [True]})
    with pytest.raises(KeyError):
        gxrod.gym.RodVectorEnv(gxrod.Deck.from_text(SWING), 2, {"pull": (0, 1)}, SEEN, 0.1, lambda seen, actions: np.zeros(2))
