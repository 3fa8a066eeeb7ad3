# Derivatives that are carried along against differences of whole runs: see README.md beside this file.

# %%
import gxrod
import matplotlib.pyplot as plt
import numpy as np

deck = gxrod.Deck("docs/examples/python/gradients/swing.toml")
NAMES = list(deck.tree()["parameters"])
SCHEMES = ["newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "radau-5", "gauss-4"]
STATIC = {"kind": "static", "steps": 5, "newton": {"tolerance": 1e-12}}

# %% What is varied besides the parameters: {title: overrides}
variants = {}
for element in ("objective", "simo"):
    variants[f"static\n{element}"] = {"rod.r.element": element, "analysis": STATIC}
    for scheme in SCHEMES:
        variants[f"{scheme}\n{element}"] = {"rod.r.element": element, "analysis.integrator": scheme}

# %% Relative distances [parameters, variants] of the derivatives of the tip's position at the end
distances = np.array([[row["distance"] for row in gxrod.check_gradient(deck.build(changes), NAMES, "tip.position", step=2e-3)]
                      for changes in variants.values()]).T
print(f"{distances.size} derivatives, at most {distances.max():.1e} from those of whole runs, half of them less than {np.median(distances):.1e}")

# %% The picture
figure, axes = plt.subplots(figsize=(11, 4.5), layout="constrained")
shown = axes.imshow(np.log10(np.maximum(distances, 1e-16)), aspect="auto", cmap="viridis_r", vmin=-13, vmax=-5)
axes.set_xticks(range(len(variants)), variants, rotation=30, ha="right", fontsize=8)
axes.set_yticks(range(len(NAMES)), NAMES)
for (i, j), distance in np.ndenumerate(distances):
    axes.text(j, i, f"{distance:.0e}", ha="center", va="center", fontsize=8, color="white" if distance > 1e-10 else "black")
figure.colorbar(shown, label="log₁₀ of the relative distance")
figure.savefig("gradients.png", dpi=120)
