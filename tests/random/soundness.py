"""What is wrong with a results file, whatever its deck: find_faults(path, summary) is a list of sentences."""

import h5py
import numpy as np

ROUND_OFF = 1e-9


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def datasets(file):
    found = {}
    file.visititems(lambda name, item: found.update({name: item}) if isinstance(item, h5py.Dataset) else None)
    return found


def find_numbers_that_are_none(found):
    for name, data in found.items():
        if data.dtype.kind == "f" and not np.all(np.isfinite(data[()])):
            yield f"{name} has a value that is not finite"


def check_steps(file, found, summary):
    times = file["histories/time"][:]
    if times.size == 0:
        return
    if times[0] != 0.0 or np.any(np.diff(times) <= 0):
        yield "times do not rise from 0"
    if times[-1] != summary["time"] or times.size != summary["steps"] + 1:
        yield "the last time or the number of steps is not that of the summary"
    for name, data in found.items():
        if name.split("/")[0] in ("histories", "ledger", "solver") and len(data) != times.size:
            yield f"{name} has {len(data)} rows for {times.size} times"
    steps = file["solver/time_step"][:]
    if not np.allclose(np.cumsum(steps), times, rtol=1e-9):
        yield "time steps do not add up to times"
    if summary["status"] == "complete":
        for key in ("newton_iterations", "rejected_steps"):
            if file[f"solver/{key}"][:].sum() != summary[key]:
                yield f"{key} is not the sum over the steps"


def read_ledger(file):
    return {name: data[:] for name, data in file["ledger"].items()}


def largest_energy(ledger):
    """As gxrod judges the balance."""
    energy = ledger["kinetic_energy"] + ledger["strain_energy"]
    return max(energy.max(initial=0.0), np.abs(ledger["external_work"]).max(initial=0.0))


def imbalance(ledger):
    """The largest error of the energy relative to the largest energy; 0 without energy."""
    error = np.abs(ledger["energy_error"]).max(initial=0.0)
    return 0.0 if error == 0.0 else float(error / largest_energy(ledger))


def find_jumps(path):
    """Whether strain energy and work part in a load step as gxrod calls a jump; None in dynamics."""
    with h5py.File(path) as file:
        if text(file.attrs["analysis"]) != "static":
            return None
        ledger = read_ledger(file)
    energy, work = ledger["strain_energy"], ledger["external_work"]
    unexplained = np.abs(np.diff(energy) - np.diff(work)) - ledger["work_uncertainty"][1:]
    largest = np.maximum.accumulate(np.maximum(energy, np.abs(work)))[1:]
    return bool(np.any(unexplained > 0.01 * largest))


def has_no_energy(path, plan):
    """Whether all energy is what round-off of positions makes of no strain, or the work of supports that is that, by a
    generous estimate."""
    with h5py.File(path) as file:
        largest = largest_energy(read_ledger(file))
        size = np.abs(file["VTKHDF/Points"][:]).max(initial=0.0)
    estimate = 0.0
    for rod in plan.rods:
        stiffness = rod.section.axial * size**2 + 100 * rod.section.bending
        estimate += rod.elements**2 / rod.length * stiffness * 1e-28
        if any(node.is_moved for node in plan.nodes):
            estimate += 1e-14 * rod.section.axial * size
    return 0.0 < largest < estimate


def hardly_moves(path):
    """Whether displacements, or the accelerations that steps make of them, have few digits compared with positions; or
    displacements and rotations hardly any."""
    with h5py.File(path) as file:
        points = file["VTKHDF/PointData"]
        size = np.abs(file["VTKHDF/Points"][:]).max(initial=0.0)
        moved = np.abs(points["displacement"][:]).max(initial=0.0) / (size or 1.0)
        turned = np.abs(points["rotation_vector"][:]).max(initial=0.0)
        steps = len(file["histories/time"]) if text(file.attrs["analysis"]) == "dynamic" else 1
    return 0.0 < moved < max(1e-13, 2e-12 * steps**2) or max(moved, turned) < 1e-10


def loses_energy_at_once(path):
    """Whether nine tenths of the error of the energy come from three steps."""
    with h5py.File(path) as file:
        changes = np.sort(np.abs(np.diff(file["ledger/energy_error"][:])))
    return changes.size > 30 and changes[-3:].sum() > 0.9 * changes.sum()


def has_gone_on(path):
    """Whether a run that was killed left many steps, all of them finite."""
    with h5py.File(path) as file:
        return len(file["histories/time"]) > 100 and not any(find_numbers_that_are_none(datasets(file)))


def check_ledger(ledger):
    energy = ledger["kinetic_energy"] + ledger["strain_energy"]
    if energy.size == 0:
        return
    if np.any(ledger["kinetic_energy"] < 0) or np.any(ledger["strain_energy"] < 0):
        yield "an energy is negative"
    for name in ("dissipated_energy", "numerical_dissipation"):
        if np.any(np.diff(ledger[name]) < 0):
            yield f"{name} falls"
    dissipated = ledger["dissipated_energy"] + ledger["numerical_dissipation"]
    balance = energy - energy[0] - ledger["external_work"] + dissipated
    size = max(np.abs(column).max() for column in (energy, ledger["external_work"], dissipated))
    if np.abs(balance - ledger["energy_error"]).max() > ROUND_OFF * size:
        yield "energy_error is not what the other columns make it"


def check_frames(file):
    frames = file["VTKHDF"]
    times = frames["Steps/Values"][:]
    count = len(times)
    if count == 0:
        return
    if frames["Steps"].attrs["NSteps"] != count or np.any(np.diff(times) <= 0):
        yield "frames are not counted or not in order"
    if not set(times) <= set(file["histories/time"][:]) or times[-1] != file["histories/time"][-1]:
        yield "a frame is at no step, or the last step has none"
    points = frames["Points"][:].reshape(count, -1, 3)
    moved = frames["PointData/displacement"][:].reshape(count, -1, 3)
    if np.abs(points - moved - (points[0] - moved[0])).max() > ROUND_OFF * np.abs(points).max():
        yield "positions without displacements are not where the model was"
    axes = np.stack([frames[f"PointData/axis_{x}"][:] for x in "xyz"], axis=-1)
    if np.abs(np.swapaxes(axes, -1, -2) @ axes - np.eye(3)).max() > ROUND_OFF:
        yield "section axes are not orthonormal"
    if np.linalg.norm(frames["PointData/rotation_vector"][:], axis=-1).max() > np.pi * (1 + ROUND_OFF):
        yield "a rotation vector of a frame is longer than pi"


def check_history(group):
    for name in ("quaternion", "orientation"):
        if name in group:
            quaternions = group[name][:]
            if np.abs(np.linalg.norm(quaternions, axis=-1) - 1).max() > ROUND_OFF:
                yield f"{group.name}/{name} is not a unit quaternion"
            if np.any(np.sum(quaternions[1:] * quaternions[:-1], axis=-1) < -ROUND_OFF):
                yield f"{group.name}/{name} jumps to its negative"
    if "rotation_vector" in group:
        vectors = group["rotation_vector"][:]
        if np.linalg.norm(vectors, axis=-1).max() > np.pi * (1 + ROUND_OFF):
            yield f"{group.name}/rotation_vector is longer than pi"
        if "quaternion" in group:
            angles = np.linalg.norm(vectors, axis=-1, keepdims=True)
            cosines = np.abs(group["quaternion"][:, :1])
            if np.abs(np.abs(np.cos(angles / 2)) - cosines).max() > 1e-7:
                yield f"{group.name}: rotation_vector and quaternion differ"
    if "position" in group and "displacement" in group:
        position, displacement = group["position"][:], group["displacement"][:]
        difference = position - displacement
        if np.abs(difference - difference[0]).max() > ROUND_OFF * np.abs(position).max():
            yield f"{group.name}: displacement is not that of position"


def find_faults(path, summary):
    with h5py.File(path) as file:
        found = datasets(file)
        faults = list(find_numbers_that_are_none(found))
        if text(file.attrs["status"]) != summary["status"] or text(file.attrs["reason"]) != summary["reason"]:
            faults.append("status or reason is not that of the summary")
        if len(file["histories/time"]) == 0:
            return faults
        faults += check_steps(file, found, summary)
        faults += check_ledger(read_ledger(file))
        faults += check_frames(file)
        for group in file["histories"].values():
            if isinstance(group, h5py.Group):
                faults += check_history(group)
    return faults


def read_imbalance(path):
    with h5py.File(path) as file:
        return imbalance(read_ledger(file))
