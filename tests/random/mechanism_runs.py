"""Runs of one mechanism by gxrod: as it is, turned, in other units, with sides exchanged, with other steps."""

import dataclasses
import subprocess

import h5py
import numpy as np

import mechanism_deck
from toml_text import toml_text


@dataclasses.dataclass
class Results:
    times: np.ndarray   # of steps
    frames: np.ndarray  # times of these
    points: np.ndarray  # frames × nodes × 3
    axes: np.ndarray    # frames × nodes × 3 × 3, an axis a row
    ledger: dict
    histories: dict     # of joints and gears, {name: {quantity: rows}}
    iterations: np.ndarray

    def energy(self):
        """The largest."""
        energy = self.ledger["kinetic_energy"] + self.ledger["strain_energy"]
        return max(energy.max(), np.abs(self.ledger["external_work"]).max())


class RunFailed(Exception):
    pass


def read(path):
    with h5py.File(path) as file:
        grid = file["VTKHDF"]
        frames = grid["Steps/Values"][:]
        shape = (len(frames), -1, 3)
        axes = np.stack([grid[f"PointData/axis_{x}"][:].reshape(shape) for x in "xyz"], axis=2)
        ledger = {name: data[:] for name, data in file["ledger"].items()}
        histories = {name: {key: data[:] for key, data in group.items()} for name, group in file["histories"].items()
                     if isinstance(group, h5py.Group)}
        return Results(file["histories/time"][:], frames, grid["Points"][:].reshape(shape), axes, ledger, histories,
                       file["solver/newton_iterations"][:])


class Runner:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def call(self, *arguments):
        return subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=300, check=False)

    def write(self, mechanism):
        (self.folder / "deck.toml").write_text(toml_text(mechanism_deck.deck_of(mechanism)), encoding="utf-8")

    def run(self, mechanism, **analysis):
        self.write({**mechanism, "analysis": {**mechanism["analysis"], **analysis}})
        return self.results(self.call("run", "deck.toml", "--force", "--quiet"))

    def results(self, done):
        if done.returncode != 0:
            raise RunFailed(f"exit code {done.returncode}: {done.stderr.strip()}")
        return read(self.folder / "deck.vtkhdf")
