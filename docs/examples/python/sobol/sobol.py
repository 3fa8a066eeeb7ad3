# Which of its uncertain numbers decides how low a plank swings: see README.md beside this file.

# %%
import gxrod
import matplotlib.pyplot as plt
import numpy as np
from SALib.analyze import sobol as indices
from SALib.sample import sobol as sampling

problem = {"num_vars": 3,
           "names": ["parameters.E", "parameters.density", "parameters.height"],
           "bounds": [[9e9, 13e9], [400, 600], [0.049, 0.051]]}

# %% All runs, by threads: 128 samples of 3 numbers make 128 (3 + 2) cases
deck = gxrod.Deck("docs/examples/python/sobol/plank.toml")
cases = sampling.sample(problem, 128, calc_second_order=False, seed=1)
table = gxrod.map(deck, [dict(zip(problem["names"], case)) for case in cases],
                  collect={"lowest": lambda sim: sim.records["tip"].displacement[:, 2].min()},
                  as_arrays=True)
assert not any(table["error"])
lowest = table["lowest"]
print(f"{len(cases)} runs: lowest point {lowest.mean():.4f} m, deviation {lowest.std():.4f} m")

# %% Sobol's indices: alone, and with all that a number does together with others; 95 % confidence
found = indices.analyze(problem, lowest, calc_second_order=False, seed=1)
for i, name in enumerate(problem["names"]):
    print(f"{name:20} alone {found['S1'][i]:5.2f} ± {found['S1_conf'][i]:.2f}, in total {found['ST'][i]:5.2f} ± {found['ST_conf'][i]:.2f}")

# %% In first order: one run with its derivatives, up to the lowest point
sim = gxrod.Simulation(deck, sensitivities=problem["names"])
sim.run(on_step=lambda sim: sim["tip"].velocity[2] < 0)
changes = [sim["tip"].derivative(name).displacement[2] * (high - low) for name, (low, high) in zip(problem["names"], problem["bounds"])]
shares = np.square(changes) / np.sum(np.square(changes))
print("in first order", ", ".join(f"{share:.2f}" for share in shares))

# %% The picture
figure, axes = plt.subplots(1, 4, figsize=(11, 3.2), layout="constrained")
places = np.arange(3)
axes[0].bar(places - 0.2, found["S1"], 0.4, yerr=found["S1_conf"], capsize=3, label="alone")
axes[0].bar(places + 0.2, found["ST"], 0.4, yerr=found["ST_conf"], capsize=3, label="in total")
axes[0].set_xticks(places, [name.split(".")[1] for name in problem["names"]])
axes[0].set_ylabel("share of the variance")
axes[0].legend()
for panel, name, values in zip(axes[1:], problem["names"], cases.T):
    panel.plot(values, lowest, ".", ms=3)
    panel.set_xlabel(name.split(".")[1])
axes[1].set_ylabel("lowest point (m)")
figure.savefig("sobol.png", dpi=120)
