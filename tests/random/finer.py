"""Whether a deck whose results gxrod verify calls right agrees with a much finer run of it."""

import re

import h5py
import numpy as np

# Times the tolerance: what is called right is an estimate.
SLACK = 3.0
MOST_SECONDS = 30.0  # of the finer run
COST = 64.0  # of it, by the deck as it is: four times the elements, sixteen times the steps
ROTATIONS = ("rotation", "quaternion", "orientation")


def settings_of(study):
    """Four times the elements, and a quarter of the steps that the finest run of the study took."""
    settings = []
    for run in study["runs"]:
        if run["run"] in ("a quarter of the step", "four times the load steps", "four times the elements"):
            settings += [re.sub(r"^analysis\.steps=(\d+)$", lambda match: f"analysis.steps={4 * int(match[1])}", change)
                         for change in run["set"]]
    return settings


def read_series(path, study):
    """Times, and of each series its rows."""
    with h5py.File(path) as file:
        times = file["histories/time"][:]
        rows = {}
        for series in study["series"]:
            name = f"histories/{series['point']}/{series['quantity']}"
            if series["quantity"] not in ROTATIONS and not series["still"] and name in file:
                rows[name] = (file[name][:].reshape(len(times), -1), series["scale"])
    return times, rows


def find_false_claim(judge, study):
    """The series that is off by more than it is said to be, or "" if there is none, or finding out takes too long. Steps by
    their error end at other times in each run, so these are left out."""
    if any(run["run"] == "1/16 of the tolerance" for run in study["runs"]):
        return ""
    if judge.run_deck().returncode != 0 or judge.seconds * COST > MOST_SECONDS:
        return ""
    times, rows = read_series(judge.folder / "deck.vtkhdf", study)
    if judge.run_deck(*settings_of(study)).returncode != 0:
        return ""
    finer_times, finer = read_series(judge.folder / "deck.vtkhdf", study)
    for name, (values, scale) in rows.items():
        there = np.stack([np.interp(times, finer_times, column) for column in finer[name][0].T], axis=1)
        error = np.linalg.norm(values - there, axis=1).max() / scale
        if error > SLACK * study["tolerance"]:
            return f"{name} is called right, and is off by {error:.3g} of its change"
    return ""
