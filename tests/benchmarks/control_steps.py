#!/usr/bin/env python3
"""Measures control steps of the soft arm as environments of gymnasium: how many in a second, and their instructions.

    control_steps.py                             steps a second of 16 environments on all cores, by integrator and newton.tangent
    control_steps.py --threads 2 --seconds 10    on two
    control_steps.py --instructions              instructions of a control step, by valgrind's callgrind

Python needs the package gxrod and gymnasium: `PYTHONPATH=build/release/python`. The steps a second mean something on a quiet
machine only; instructions hardly depend on it. They are the difference of two runs, free of what it takes to start, with the
instruction set `GXROD_INSTRUCTION_SET`, by default avx2: valgrind knows no wider one.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

DECK = pathlib.Path(__file__).resolve().parents[2] / "docs" / "examples" / "python" / "controller" / "arm.toml"
WAYS = ("newmark-simplified consistent", "generalized-alpha consistent", "generalized-alpha kept")  # integrator, newton.tangent
COUNTED = (20, 60)  # control steps


def make_environments(count, threads, way):
    """The arm of docs/examples/python/environment, so many times."""
    import gxrod
    import numpy as np

    integrator, tangent = way.split()
    model = gxrod.Deck(DECK).build({"analysis.integrator": integrator, "analysis.newton.tangent": tangent})
    return gxrod.gym.RodVectorEnv(model, count, actions={"tendon": (0, 15)}, observations=["tip.position", "tip.velocity"],
                                  control_step=0.02, threads=threads,
                                  reward=lambda seen, actions: np.maximum(0.0, 1.0 - np.abs(seen[:, 2] - 0.04) / 0.1))


def count_steps(environments, seconds):
    """Control steps of all environments in a second, under random pulls."""
    environments.reset(seed=1)
    environments.action_space.seed(1)
    steps, start = 0, time.perf_counter()
    while time.perf_counter() - start < seconds:
        environments.step(environments.action_space.sample())
        steps += environments.num_envs
    return steps / (time.perf_counter() - start)


def take_steps(way, steps):
    """What callgrind counts: one environment on one thread."""
    environments = make_environments(1, 1, way)
    environments.reset(seed=1)
    environments.action_space.seed(1)
    for _ in range(steps):
        environments.step(environments.action_space.sample())


def count_run(way, steps, folder):
    """Instructions of a whole run."""
    profile = pathlib.Path(folder) / f"profile_{steps}"
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", sys.executable, __file__,
               "--take", str(steps), "--way", way]
    environment = {"GXROD_INSTRUCTION_SET": "avx2", **os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1",
                   "PYTHONHASHSEED": "0"}
    done = subprocess.run(command, env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"The run under valgrind failed:\n{done.stdout}")
    for line in profile.read_text(encoding="utf-8").splitlines():
        if line.startswith(("summary:", "totals:")):
            return int(line.split()[1])
    raise LookupError(f"no sum in {profile}")


def main():
    """Measures, and prints a line for each way."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--environments", type=int, default=16)
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--seconds", type=float, default=5.0)
    parser.add_argument("--instructions", action="store_true", help="count instructions instead of steps")
    parser.add_argument("--take", type=int, help=argparse.SUPPRESS)
    parser.add_argument("--way", choices=WAYS, default=WAYS[0], help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.take:
        return take_steps(arguments.way, arguments.take)
    for way in WAYS:
        if arguments.instructions:
            with tempfile.TemporaryDirectory() as folder:
                short, long = (count_run(way, steps, folder) for steps in COUNTED)
            print(f"{way:<30} {(long - short) / (COUNTED[1] - COUNTED[0]) / 1e6:.2f} million instructions a control step")
        else:
            environments = make_environments(arguments.environments, arguments.threads, way)
            rate = count_steps(environments, arguments.seconds)
            print(f"{way:<30} {rate:.0f} control steps a second, {arguments.environments} environments on {arguments.threads} threads")
    return None


if __name__ == "__main__":
    main()
