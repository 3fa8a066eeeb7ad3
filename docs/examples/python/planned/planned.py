# The pull of a tendon that brings the tip of a soft arm to rest at a height: see README.md beside this file.

# %%
import time
from functools import lru_cache

import gxrod
import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import minimize

HEIGHT, END, STEP = 0.04, 1.0, 0.01
STEPS = round(END / STEP)
model = gxrod.Deck("docs/examples/python/controller/arm.toml").build({"analysis.end_time": END})
arm = model.rods["arm"].nodes
REST = np.arange(STEPS + 1) * STEP > 0.5  # the states that count


# %% A run in which the tendon has these pulls at the ends of steps, on straight lines in between
@lru_cache(maxsize=2)
def swing(pulls):
    sim = gxrod.Simulation(model)
    for pull in pulls:
        sim.inputs["tendon"] = pull
        sim.step()
    return sim


def cost(pulls):
    """How far from its height and how fast the tip is from 0.5 s on, in cm and 10 cm/s, and how much the pull changes; and its gradient."""
    sim = swing(tuple(pulls))
    off = np.where(REST, sim.records["tip"].position[:, 2] - HEIGHT, 0) / 0.01
    speed = sim.records["tip"].velocity * REST[:, None] / 0.1
    changes = np.diff(pulls, prepend=0)
    weights = {"tip.position": np.outer(2 * off / 0.01, [0, 0, 1]), "tip.velocity": 2 * speed / 0.1}
    _, by_pulls = sim.adjoint(weights, inputs="tendon")
    gradient = by_pulls[1:, 0] + 2e-2 * (changes - np.append(changes[1:], 0))
    return (off**2).sum() + (speed**2).sum() + 1e-2 * (changes**2).sum(), gradient


# %% The best pulls, not negative: a tendon cannot push
start = time.perf_counter()
best = minimize(cost, np.full(STEPS, 5.0), jac=True, method="L-BFGS-B", bounds=[(0, 60)] * STEPS, options={"maxfun": 100})
seconds = time.perf_counter() - start
sim = swing(tuple(best.x))
times = sim.records.time
height = sim.records["tip"].position[:, 2]
off = np.abs(height - HEIGHT)
settled = times[off > 0.002][-1]
print(f"within 2 mm after {settled:.2f} s, {1e3 * off[-1]:.2f} mm off after 1 s with {best.x[-10:].mean():.2f} N")

# %% What one gradient by 100 values costs, in runs
begin = time.perf_counter()
run = swing(tuple(best.x + 1e-9))
middle = time.perf_counter()
run.adjoint({"tip.position": [0, 0, 1]}, inputs="tendon")
ratio = (time.perf_counter() - middle) / (middle - begin)

# %% The picture
figure, axes = plt.subplot_mosaic([["height", "arm"], ["pull", "arm"]], figsize=(10, 4.5), width_ratios=(3, 2), layout="constrained")
axes["height"].axhline(HEIGHT, ls="--", color="0.6", label="target")
axes["height"].plot(times, height, label="tip")
axes["height"].set_ylabel("height of the tip (m)")
axes["height"].legend()
axes["pull"].plot(times, np.append(0, best.x), color="C1")
axes["pull"].set(xlabel="time (s)", ylabel="pull of the tendon (N)")
shapes = gxrod.Simulation(model)
for step, pull in enumerate(best.x):
    shapes.inputs["tendon"] = pull
    shapes.step()
    if step + 1 in (8, 23, 38, 60):
        x, _, z = shapes.state.position[arm].T
        axes["arm"].plot(x, z, lw=4, solid_capstyle="round", label=f"{(step + 1) * STEP:.2f} s")
axes["arm"].set(xlabel="x (m)", ylabel="z (m)", aspect="equal")
axes["arm"].legend(ncols=2, loc="lower center", bbox_to_anchor=(0.5, 1.05))
figure.savefig("planned.png", dpi=120)
