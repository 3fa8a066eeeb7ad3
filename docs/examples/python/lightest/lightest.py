# The lightest cantilever of 20 radii whose end sinks by 5 cm: see README.md beside this file.

# %%
import time
from functools import lru_cache

import gxrod
import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import minimize

N, SAG, DENSITY = 20, 0.05, 2700.0
NAMES = [f"r{i}" for i in range(N)]
THICKEST = 0.02

# %% The deck: one rod a piece, each begins where the one before ends
deck = gxrod.Deck.from_dict({
    "title": "A cantilever of 20 radii",
    "units": "m kg s",
    "plane": "xz",
    "parameters": {name: 0.007 for name in NAMES},
    "section": {f"s{i}": {"shape": {"circle": {"radius": NAMES[i]}}, "material": {"E": 70e9, "G": 26e9, "density": DENSITY}} for i in range(N)},
    "rod": {f"p{i}": {"section": f"s{i}", "line": {"from": [i / N, 0, 0], "to": [(i + 1) / N, 0, 0]}, "elements": 1, "order": 2} for i in range(N)},
    "support": [{"at": "p0.start", "fix": "all"}],
    "connect": [{"points": [f"p{i}.end", f"p{i + 1}.start"]} for i in range(N - 1)],
    "load": [{"at": f"p{N - 1}.end", "force": [0, 0, -20]}],
    "analysis": {"kind": "static", "steps": 1},
    "history": [{"name": "tip", "at": f"p{N - 1}.end", "quantities": ["displacement"]}],
})


@lru_cache(maxsize=4)
def solve(radii):
    sim = gxrod.Simulation(deck.build({f"parameters.{name}": radius for name, radius in zip(NAMES, radii)}))
    sim.run()
    return sim


def mass(x):
    return DENSITY * np.pi / N * (x**2).sum()


def room(x):
    """What the end may still sink, in parts of 5 cm."""
    return 1 + solve(tuple(x))["tip"].displacement[2] / SAG


def room_gradient(x):
    return solve(tuple(x)).adjoint({"tip.displacement": [0, 0, 1 / SAG]}, NAMES)


# %% The same radius everywhere, and the lightest ones. Radii count in parts of the first ones.
uniform = 0.007 * np.ones(N)
for _ in range(20):
    uniform *= (1 - room(uniform)) ** 0.25  # its end sinks as 1/r⁴
best = minimize(lambda y: mass(y * uniform) / mass(uniform), np.ones(N), jac=lambda y: 2 * y * uniform**2 / (uniform**2).sum(), method="SLSQP",
                constraints={"type": "ineq", "fun": lambda y: room(y * uniform), "jac": lambda y: room_gradient(y * uniform) * uniform},
                bounds=[(0.1, THICKEST / uniform[0])] * N, options={"ftol": 1e-10, "maxiter": 200})
radii = best.x * uniform
print(f"uniform: r = {1e3 * uniform[0]:.3f} mm, {mass(uniform):.4f} kg; lightest: {mass(radii):.4f} kg, {mass(radii) / mass(uniform):.4f} of it")

# %% Linear theory: r ∝ (L − x)^(1/3), in pieces
middles = (np.arange(N) + 0.5) / N
left = (np.arange(N, 0, -1) ** 3 - np.arange(N - 1, -1, -1) ** 3) / N**3  # 3 ∫ (1 − x)² dx of each piece
linear = left ** (1 / 6)
linear *= ((left / linear**4).sum()) ** 0.25 * uniform[0]
print(f"linear theory: {(linear**2).mean() / uniform[0] ** 2:.4f} of it; radii differ by at most {100 * np.abs(radii / linear - 1).max():.1f} %")

# %% What a gradient costs: by one adjoint solution, carried along, by differences
sim = solve(tuple(radii))
start = time.perf_counter()
by_adjoint = sim.adjoint({"tip.displacement": [0, 0, 1]}, NAMES)
middle = time.perf_counter()
carried = gxrod.Simulation(sim.model, sensitivities=NAMES)
carried.run()
by_steps = np.array([carried["tip"].derivative(name).displacement[2] for name in NAMES])
end = time.perf_counter()
distance = np.abs(by_adjoint / by_steps - 1).max()
seconds = middle - start, end - middle

# %% The picture
figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
x = np.linspace(0, 1, 400)
axes.stairs(1e3 * radii, np.linspace(0, 1, N + 1), fill=True, alpha=0.35, label="lightest, of 20 radii")
axes.stairs(-1e3 * radii, np.linspace(0, 1, N + 1), fill=True, alpha=0.35, color="C0")
shape = 1e3 * np.sqrt(np.sqrt(9 / 5)) * uniform[0] * (1 - x) ** (1 / 3)
axes.plot(np.r_[x, x[::-1]], np.r_[shape, -shape[::-1]], color="C1", label="linear theory, $(L - x)^{1/3}$")
axes.plot([0, 1, np.nan, 0, 1], 1e3 * uniform[0] * np.array([1, 1, np.nan, -1, -1]), "k--", lw=1, label="uniform")
axes.set(xlabel="x [m]", ylabel="radius [mm]", ylim=(-13, 13))
axes.legend(ncols=3, loc="upper center")
figure.savefig("lightest.png", dpi=120)
