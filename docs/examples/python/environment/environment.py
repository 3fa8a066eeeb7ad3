# The soft arm of the controller as an environment of gymnasium: see README.md beside this file.

# %%
import gxrod
import matplotlib.pyplot as plt
import numpy as np

TARGET = 0.04  # m, the height wanted of the tip

env = gxrod.gym.RodEnv("docs/examples/python/controller/arm.toml",
                       actions={"tendon": (0, 15)},
                       observations=["tip.position", "tip.velocity"],
                       control_step=0.02,
                       reward=lambda sim, action: max(0.0, 1 - abs(sim["tip"].position[2] - TARGET) / 0.1),
                       terminated=lambda sim: sim["tip"].position[0] < 0.05)  # it has rolled up


# %% Policies: functions of the observation, x y z of the tip and its velocity
def controlled(seen):
    return [9.84 + 30 * (TARGET - seen[2]) - 5 * seen[5]]


def constant(seen):
    return [9.84]


def random(seen):
    return env.action_space.sample()


def strongest(seen):
    return env.action_space.high


# %% An episode: all that was seen [steps + 1, 6], and the sum of the rewards
def play(policy):
    seen, _ = env.reset(seed=1)
    env.action_space.seed(1)
    every, total, ended = [seen], 0.0, False
    while not ended:
        seen, reward, terminated, truncated, info = env.step(policy(seen))
        every.append(seen)
        total += reward
        ended = terminated or truncated
    print(f"{policy.__name__:12} {total:6.1f}  {'rolled up' if terminated else 'to the end'} at {info['time']:.2f} s")
    return np.array(every), total


episodes = {policy.__name__: play(policy) for policy in (controlled, constant, random, strongest)}

# %% An episode comes again to the last bit
again, total = play(controlled)
assert (again == episodes["controlled"][0]).all() and total == episodes["controlled"][1]

# %% The picture
figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
for name, (seen, total) in episodes.items():
    axes.plot(env.control_step * np.arange(len(seen)), seen[:, 2], label=f"{name}: {total:.1f}")
axes.axhline(TARGET, ls="--", color="0.6", zorder=0)
axes.set(xlabel="time (s)", ylabel="height of the tip (m)")
axes.legend(title="policy: reward of the episode")
figure.savefig("environment.png", dpi=120)
