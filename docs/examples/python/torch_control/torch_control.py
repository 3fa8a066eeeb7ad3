# A small network of PyTorch that plans the pull of a tendon for any height of the tip: see README.md beside this file.

# %%
import gxrod
import gxrod.torch
import matplotlib.pyplot as plt
import numpy as np
import torch

END, CONTROL_STEP, COUNT = 0.6, 0.025, 24
torch.manual_seed(1)
model = gxrod.Deck("docs/examples/python/controller/arm.toml").build({"analysis.end_time": END})

# %% The arm: 24 pulls to the position and the velocity of the tip after each of them [25,6]
swing = gxrod.torch.torch_run(model, ["tip.position", "tip.velocity"], inputs=["tendon"], control_step=CONTROL_STEP, records="control")
times = np.arange(COUNT + 1) * CONTROL_STEP
late = torch.tensor(times > 0.35)


def plan(network, height):
    """The pulls [24,1] for a height in m: a tendon cannot push."""
    scaled = torch.tensor([[height / 0.05]], dtype=torch.float64)
    return 10 * torch.nn.functional.softplus(network(scaled)).reshape(COUNT, 1)


def miss(seen, height):
    """How far off in cm and how fast in dm/s the tip is after 0.35 s, in the mean of squares."""
    off, speed = (seen[late, 2] - height) / 0.01, seen[late, 3:] / 0.1
    return (off**2).mean() + 0.1 * (speed**2).sum(dim=1).mean()


# %% Gradients through the arm and the network are those of differences
network = torch.nn.Sequential(torch.nn.Linear(1, 24), torch.nn.Tanh(), torch.nn.Linear(24, COUNT)).double()
weight = network[2].bias
miss(swing(plan(network, 0.02)), 0.02).backward()
exact = weight.grad[3].item()
with torch.no_grad():
    costs = []
    for change in (1e-5, -2e-5):
        weight[3] += change
        costs.append(miss(swing(plan(network, 0.02)), 0.02).item())
    weight[3] += 1e-5
difference = (costs[0] - costs[1]) / 2e-5

# %% Learning: three heights in each iteration
optimizer = torch.optim.Adam(network.parameters(), lr=0.02)
misses = []
for iteration in range(120):
    optimizer.zero_grad()
    heights = np.random.default_rng(iteration).uniform(-0.02, 0.06, 3)
    total = sum(miss(swing(plan(network, height)), height) for height in heights) / len(heights)
    total.backward()
    optimizer.step()
    misses.append(total.item())
print(f"miss {np.mean(misses[:5]):.1f} at first, {np.mean(misses[-10:]):.2f} after {len(misses)} iterations")

# %% Heights that it has not seen
figure, axes = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
worst = 0.0
for i, height in enumerate((-0.01, 0.01, 0.03, 0.05)):
    with torch.no_grad():
        pulls = plan(network, height)
        seen = swing(pulls).numpy()
    worst = max(worst, np.abs(seen[times > 0.35, 2] - height).max())
    axes[0].plot(times, 1e3 * seen[:, 2], f"C{i}", label=f"{1e3 * height:.0f} mm")
    axes[0].axhline(1e3 * height, color=f"C{i}", ls=":", lw=1)
    axes[1].plot(np.arange(COUNT + 1) * CONTROL_STEP, np.append(0, pulls.numpy()), f"C{i}.-")
print(f"at most {1e3 * worst:.0f} mm off after 0.35 s")
axes[0].set(xlabel="time (s)", ylabel="height of the tip (mm)")
axes[0].legend(title="wanted")
axes[1].set(xlabel="time (s)", ylabel="pull of the tendon (N)")
figure.savefig("torch_control.png", dpi=120)
