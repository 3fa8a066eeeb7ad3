# A controller brings the tip of a soft arm to a height by a tendon: see README.md beside this file.

# %%
import gxrod
import matplotlib.pyplot as plt
import numpy as np

STEP = 0.02  # s, in which the tendon goes from one pull to the next on a straight line


def target(time):
    """The height wanted of the tip, in m."""
    return 0.04 if time < 3 else -0.1


# %% A run in which the tendon is set every 20 ms, from the height of the tip, its sum over time and its speed
sim = gxrod.Simulation(gxrod.Deck("docs/examples/python/controller/arm.toml").build())
arm = sim.model.rods["arm"].nodes
error_sum, times, pulls, shapes = 0.0, [0.0], [0.0], []
while not sim.finished:
    tip = sim["tip"]
    error = target(sim.time) - tip.position[2]
    error_sum += error * STEP
    pull = max(0.0, 7 + 30 * error + 100 * error_sum - 5 * tip.velocity[2])  # N; a tendon cannot push
    sim.inputs["tendon"] = pull
    sim.advance(until=sim.time + STEP)
    times.append(sim.time)
    pulls.append(pull)
    shapes.append(sim.state.position[arm])

# %% How good it is
time, height = sim.records.time, sim.records["tip"].position[:, 2]
for begin, end in ((0, 3), (3, 6)):
    part = (time > begin + 1e-9) & (time <= end + 1e-9)
    distance = 1e3 * np.abs(height[part] - target(begin))
    print(f"{target(begin):5.2f} m: within 2 mm after {time[part][distance > 2][-1] - begin:.2f} s, "
          f"{distance[-1]:.2f} mm off after 3 s with {np.interp(end, times, pulls):.2f} N")

# %% The picture
figure, axes = plt.subplot_mosaic([["height", "arm"], ["pull", "arm"]], figsize=(10, 4.5), width_ratios=(3, 2), layout="constrained")
axes["height"].step(time, [target(t) for t in time], "--", color="0.6", where="post", label="target")
axes["height"].plot(time, height, label="tip")
axes["height"].set_ylabel("height of the tip (m)")
axes["height"].legend()
axes["pull"].plot(times, pulls, color="C1")
axes["pull"].set(xlabel="time (s)", ylabel="pull of the tendon (N)")
for moment in (0.2, 3, 6):
    shape = shapes[round(moment / STEP) - 1]
    axes["arm"].plot(shape[:, 0], shape[:, 2], lw=4, solid_capstyle="round", label=f"{moment} s")
axes["arm"].set(xlabel="x (m)", ylabel="z (m)", aspect="equal")
axes["arm"].legend()
figure.savefig("controller.png", dpi=120)
