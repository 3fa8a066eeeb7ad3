# Stiffness and damping of a soft arm from how its tip was seen to swing, by JAX: see README.md beside this file.

# %%
import gxrod
import gxrod.jax
import jax
import jax.numpy as jnp
import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import minimize

jax.config.update("jax_enable_x64", True)
NAMES, TRUE = ["section.silicone.material.E", "section.silicone.damping.kelvin_voigt"], np.array([1e6, 0.02])
model = gxrod.Deck("docs/examples/python/controller/arm.toml").build({"analysis.end_time": 1.5})

# %% The arm falls from the horizontal: two numbers to the position of the tip at all states [151,3]
fall = gxrod.jax.jax_run(model, ["tip.position"], parameters=NAMES, records=True)
noise = 2e-3 * np.random.default_rng(7).standard_normal((151, 3))
seen = fall(jnp.array(TRUE)) + noise


def miss(logarithms):
    """Half of the sum of squares between the run and what was seen, over the variance of the noise."""
    return 0.5 * jnp.sum(((fall(jnp.exp(logarithms)) - seen)[:, ::2] / 2e-3) ** 2)


# %% Compiled, and compared with differences
gradient = jax.jit(jax.grad(miss))
start = jnp.log(jnp.array([6e5, 0.06]))
exact = np.array(gradient(start))
steps = 1e-5 * np.eye(2)
differences = np.array([(miss(start + step) - miss(start - step)) / 2e-5 for step in steps])
distance = np.abs(exact - differences).max() / np.abs(differences).max()

# %% The fit
found = minimize(jax.value_and_grad(miss), start, jac=True, method="BFGS")
numbers = np.exp(found.x)
# The covariance: the inverse of the Hessian, by differences of gradients.
hessian = np.array([(gradient(found.x + 10 * step) - gradient(found.x - 10 * step)) / 2e-4 for step in steps])
deviations = numbers * np.sqrt(np.diag(np.linalg.inv(0.5 * (hessian + hessian.T))))
print(f"E = {numbers[0]:.4g} ± {deviations[0]:.1g} Pa, {1e3 * numbers[1]:.2f} ± {1e3 * deviations[1]:.1g} ms of damping, by {found.nfev} runs")

# %% The picture
figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
times = 0.01 * np.arange(151)
axes.plot(times, 1e3 * np.array(seen)[:, 2], ".", ms=3, color="0.5", label="seen")
axes.plot(times, 1e3 * np.array(fall(jnp.exp(start)))[:, 2], "--", label="at the start of the fit")
axes.plot(times, 1e3 * np.array(fall(jnp.exp(found.x)))[:, 2], label="fitted")
axes.set(xlabel="time (s)", ylabel="height of the tip (mm)")
axes.legend()
figure.savefig("jax_identify.png", dpi=120)
