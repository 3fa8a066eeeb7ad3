# The soft arm as an FMU, and its controller in another program, FMPy: see README.md beside this file.

# %%
import shutil
import subprocess

import fmpy
import gxrod
import matplotlib.pyplot as plt
import numpy as np
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu
from gxrod.program import find_program

DECK, STEP, END, TARGET = "docs/examples/python/controller/arm.toml", 0.02, 3.0, 0.04
subprocess.run([find_program(), "fmu", DECK, "-o", "arm.fmu", "--force"], check=True, stdout=subprocess.DEVNULL)
problems = validate_fmu("arm.fmu")
print(f"{len(problems)} problems found by FMPy")

# %% The FMU, by the names of its variables
description = fmpy.read_model_description("arm.fmu")
references = {variable.name: variable.valueReference for variable in description.modelVariables}
folder = fmpy.extract("arm.fmu")
arm = FMU3Slave(guid=description.guid, unzipDirectory=folder, modelIdentifier=description.coSimulation.modelIdentifier, instanceName="arm")
arm.instantiate()
arm.enterInitializationMode(startTime=0.0)
arm.exitInitializationMode()


def read(*names):
    return arm.getFloat64([references[name] for name in names])


# %% The controller: proportional, integral and derivative
heights, pulls, total = [0.0], [0.0], 0.0
for step in range(round(END / STEP)):
    height, speed = read("tip.position.z", "tip.velocity.z")
    total += (TARGET - height) * STEP
    pull = max(0.0, 7 + 30 * (TARGET - height) + 100 * total - 5 * speed)
    arm.setFloat64([references["tendon"]], [pull])
    arm.doStep(currentCommunicationPoint=step * STEP, communicationStepSize=STEP)
    heights += read("tip.position.z")
    pulls.append(pull)
arm.terminate()
arm.freeInstance()
shutil.rmtree(folder)
late = np.abs(np.array(heights) - TARGET) > 0.002
print(f"within 2 mm after {STEP * (np.flatnonzero(late)[-1] + 1):.2f} s, with {pulls[-1]:.2f} N at the end")

# %% The same loop in gxrod itself
sim = gxrod.Simulation(DECK)
for step, pull in enumerate(pulls[1:]):
    sim.inputs["tendon"] = pull
    sim.advance(until=step * STEP + STEP)
difference = abs(sim["tip"].position[2] - heights[-1])

# %% The picture
figure, (above, below) = plt.subplots(2, sharex=True, figsize=(7, 5), layout="constrained")
times = STEP * np.arange(len(heights))
above.axhline(1e3 * TARGET, ls="--", color="0.6")
above.plot(times, 1e3 * np.array(heights))
above.set_ylabel("height of the tip (mm)")
below.step(times, pulls, "C1", where="pre")
below.set(xlabel="time (s)", ylabel="pull of the tendon (N)")
figure.savefig("fmu_control.png", dpi=120)
