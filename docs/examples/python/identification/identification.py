# E and G of the 45-degree bend from where its end was seen, and how sure they are: see README.md beside this file.

# %%
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache

import gxrod
import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import least_squares

NAMES, TRUE, LOADS, NOISE = ("E", "G"), np.array([1e7, 5e6]), (300, 450, 600), 0.05
deck = gxrod.Deck("docs/examples/bend_45/bend_45.toml")
runs = 0


@lru_cache(maxsize=8)  # positions and their derivatives are asked for one after the other
def solve(E, G, sensitivities=()):
    """The end of the bend under each load; 4 elements and 4 steps are exact to 5e-5."""
    global runs
    ends = []
    for load in LOADS:
        model = deck.build({"parameters.E": E, "parameters.G": G, "load[0].force[2]": load, "rod.bend.elements": 4, "analysis.steps": 4})
        sim = gxrod.Simulation(model, sensitivities=sensitivities)
        sim.run()
        ends.append(sim["end"])
        runs += 1
    return ends


def positions(x, sensitivities=()):
    """Of the end, under all loads [9]."""
    return np.concatenate([end.position for end in solve(*x, sensitivities)])


def jacobian(x):
    """Of the same, by E and G [9,2]."""
    return np.concatenate([np.stack([end.derivative(name).position for name in NAMES], axis=1) for end in solve(*x, NAMES)])


def fit(seen, start=(2e7, 2e6)):
    """The least squares between positions and what was seen."""
    return least_squares(lambda x: positions(x, NAMES) - seen, start, jacobian, x_scale="jac", xtol=1e-10)


# %% What was seen: positions with a noise of 0.05; the radius of the bend is 100
random = np.random.default_rng(45)
exact = positions(TRUE)
seen = exact + NOISE * random.standard_normal(exact.size)

# %% The fit, and the same with differences of whole runs
before = runs
found = fit(seen)
runs_exact, before = runs - before, runs
other = least_squares(lambda x: positions(x) - seen, (2e7, 2e6), "2-point", x_scale="jac", xtol=1e-10)
runs_differences = runs - before
print(f"{runs_exact} runs with exact derivatives, {runs_differences} with differences")

# %% How sure E and G are: their covariance from the Jacobian
covariance = np.linalg.inv(found.jac.T @ found.jac) * 2 * found.cost / (seen.size - len(NAMES))
deviations = np.sqrt(np.diag(covariance))
for name, value, deviation in zip(NAMES, found.x, deviations):
    print(f"{name} = {value:.4g} ± {deviation:.2g}")

# %% Against fits of 40 other noises, to the truth: the covariance there, with the noise's own deviation
with ThreadPoolExecutor(2) as threads:
    noises = exact + NOISE * random.standard_normal((40, exact.size))
    fits = np.array(list(threads.map(lambda noise: fit(noise, TRUE).x, noises)))
at_truth = jacobian(TRUE)
expected = np.linalg.inv(at_truth.T @ at_truth) * NOISE**2
scatter = np.cov(fits.T)
for i, name in enumerate(NAMES):
    print(f"deviation of {name}: {np.sqrt(expected[i, i]):.3g} from the Jacobian, {np.sqrt(scatter[i, i]):.3g} of the fits")
correlations = [each[0, 1] / np.sqrt(each[0, 0] * each[1, 1]) for each in (expected, scatter)]
print(f"correlation: {correlations[0]:.3f} from the Jacobian, {correlations[1]:.3f} of the fits")

# %% The picture: the fits, and the ellipse that should hold 95 % of them
angle = np.linspace(0, 2 * np.pi, 200)
ellipse = TRUE + np.sqrt(5.991) * (np.linalg.cholesky(expected) @ [np.cos(angle), np.sin(angle)]).T
figure, axes = plt.subplots(figsize=(6, 4.5), layout="constrained")
axes.plot(*fits.T / 1e6, ".", color="C0", label="fits of 40 noises")
axes.plot(*ellipse.T / 1e6, color="C1", label="95 %, from the Jacobian")
axes.plot(*TRUE / 1e6, "k+", ms=12, label="truth")
axes.set(xlabel="E / 10⁶", ylabel="G / 10⁶")
axes.legend()
figure.savefig("identification.png", dpi=120)
