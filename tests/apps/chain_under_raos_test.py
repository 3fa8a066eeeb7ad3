"""The chain of the examples under a vessel with response amplitude operators, against what its page writes out by hand."""

import csv
import unittest

import h5py
import numpy as np

from program import SOURCE, ProgramTest

EXAMPLE = SOURCE / "docs" / "examples" / "chain_under_raos"
GRAVITY, DEPTH, LENGTH, EA = 9.80665, 200.126, 760.0, 1.674e9
WEIGHT = (390 - 1025 * np.pi / 4 * 0.252**2) * GRAVITY


def wave_number(omega):
    number = omega**2 / GRAVITY
    for _ in range(100):
        number = omega**2 / (GRAVITY * np.tanh(number * DEPTH))
    return number


def fairlead(time):
    """Its place [.,2], x and z: the wave of 6 m and 12 s goes along -x, and the file has its period."""
    with (EXAMPLE / "vessel_raos.csv").open() as file:
        row = next({key: float(value) for key, value in row.items()} for row in csv.DictReader(file) if float(row["period"]) == 12)
    omega = 2 * np.pi / 12
    phase = omega * time - 80 * wave_number(omega)
    surge, heave, pitch = (3 * row[name] * np.cos(phase - np.radians(row[name + "_phase"])) for name in ("surge", "heave", "pitch"))
    pitch = np.radians(pitch)
    return np.stack((-80 + surge + 80 * np.cos(pitch) - 10 * np.sin(pitch), heave - 80 * np.sin(pitch) - 10 * np.cos(pitch)), axis=1)


def tension_at_rest():
    """At the top of an elastic catenary on a rigid bed, by Newton's method with differences."""
    def misses(u):
        H, hung = u[0] * 1e6, u[1] * 100
        return np.array([(LENGTH - hung) * (1 + H / EA) + H / WEIGHT * np.arcsinh(WEIGHT * hung / H) + H * hung / EA - 700,
                         H / WEIGHT * (np.hypot(1, WEIGHT * hung / H) - 1) + WEIGHT * hung**2 / (2 * EA) - 190])
    u = np.array([1.2, 4.0])
    for _ in range(30):
        slopes = np.column_stack([(misses(u + h) - misses(u - h)) / 2e-6 for h in 1e-6 * np.eye(2)])
        u -= np.linalg.solve(slopes, misses(u))
    return np.hypot(u[0] * 1e6, WEIGHT * u[1] * 100)


class ChainUnderRaos(ProgramTest):
    def test_it_is_what_its_page_says(self):
        self.gxrod("run", EXAMPLE / "chain_under_raos.toml", "--quiet", "-o", "chain.vtkhdf")
        with h5py.File(self.folder / "chain.vtkhdf") as file:
            time, stage = file["histories/time"][()], file["histories/stage"][()]
            position, tension = file["histories/fairlead/position"][()], file["histories/fairlead/effective_tension"][()].ravel()
        moving = (stage == stage[-1]) & (time > 12.1)
        np.testing.assert_allclose(position[moving][:, [0, 2]], fairlead(time[moving]), rtol=0, atol=1e-8)
        self.assertLess(abs(tension[stage == stage[0]][-1] / tension_at_rest() - 1), 1e-4)
        late = tension[time > 40]
        np.testing.assert_allclose((late.min(), late.max()), (1.64e6, 1.99e6), rtol=3e-3)


if __name__ == "__main__":
    unittest.main()
