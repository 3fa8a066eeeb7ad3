"""The hall of the examples against a stiffness matrix of its members, as a frame program has it."""

import json
import unittest

import h5py
import numpy as np

from program import SOURCE, ProgramTest

WIDTH, HEIGHT, RISE, BAY = 12.0, 4.0, 1.2, 5.0
SNOW, WIND, GRAVITY = 4e3, (4e3, 1e3), 9.81
SCALE = 1e-4  # at which what the theory of second order adds is of that size, too


def list_points():
    """By number: feet and eaves on the left, ridge, eaves and feet on the right of each frame."""
    profile = [(0, 0), (0, HEIGHT), (WIDTH / 2, HEIGHT + RISE), (WIDTH, HEIGHT), (WIDTH, 0)]
    return {10 * i + k + 1: np.array([x, BAY * i, z]) for i in range(3) for k, (x, z) in enumerate(profile)}


def list_members():
    """(section, from, to, section y; None as check chooses it)."""
    for i in range(0, 30, 10):
        yield from (("column", i + 1, i + 2, 1), ("column", i + 5, i + 4, 1), ("rafter", i + 2, i + 3, 1), ("rafter", i + 4, i + 3, 1))
    for i in range(0, 20, 10):
        yield from (("purlin", i + k, i + k + 10, 0) for k in (2, 3, 4))
    for a, b in ((1, 12), (11, 2), (5, 14), (15, 4), (2, 13), (12, 3), (4, 13), (14, 3)):
        yield "brace", a, b, None


def stiffness_of(length, section):
    """[12,12] of a Timoshenko member in its axes."""
    EA, GAy, GAz, GJ, EIy, EIz = np.diag(section["stiffness"])
    matrix = np.zeros((12, 12))
    for at, value in ((0, EA), (3, GJ)):
        matrix[np.ix_([at, at + 6], [at, at + 6])] = value / length * np.array([[1, -1], [-1, 1]])
    for EI, GA, across, turn, sign in ((EIz, GAy, 1, 5, 1), (EIy, GAz, 2, 4, -1)):
        phi, L = 12 * EI / (GA * length**2), length
        bending = np.array([[12, 6 * L, -12, 6 * L], [6 * L, (4 + phi) * L**2, -6 * L, (2 - phi) * L**2],
                            [-12, -6 * L, 12, -6 * L], [6 * L, (2 - phi) * L**2, -6 * L, (4 + phi) * L**2]])
        signs = np.diag([1, sign, 1, sign])
        at = [across, turn, across + 6, turn + 6]
        matrix[np.ix_(at, at)] += EI / (length**3 * (1 + phi)) * signs @ bending @ signs
    return matrix


def forces_of(length, q):
    """[12] of an even load, in axes of the member."""
    forces = np.zeros(12)
    forces[0:3] = forces[6:9] = q * length / 2
    forces[5], forces[4] = q[1] * length**2 / 12, -q[2] * length**2 / 12
    forces[10:12] = -forces[4:6]
    return forces


def release(matrix, forces):
    """Condenses out the rotations of bending at both ends."""
    free, kept = [4, 5, 10, 11], [0, 1, 2, 3, 6, 7, 8, 9]
    solved = np.linalg.solve(matrix[np.ix_(free, free)], np.column_stack([matrix[np.ix_(free, kept)], forces[free]]))
    condensed, rest = np.zeros((12, 12)), np.zeros(12)
    condensed[np.ix_(kept, kept)] = matrix[np.ix_(kept, kept)] - matrix[np.ix_(kept, free)] @ solved[:, :-1]
    rest[kept] = forces[kept] - matrix[np.ix_(kept, free)] @ solved[:, -1]
    return condensed, rest


def solve_frame(sections):
    """Displacements [3] of each point, by number, under the whole load."""
    points = list_points()
    first = {number: 6 * i for i, number in enumerate(points)}
    matrix, forces = np.zeros((6 * len(points),) * 2), np.zeros(6 * len(points))
    for kind, a, b, y_axis in list_members():
        along = points[b] - points[a]
        length = np.linalg.norm(along)
        x = along / length
        y = np.eye(3)[np.argmin(np.abs(x)) if y_axis is None else y_axis]
        y = y - x * (x @ y)
        axes = np.array([x, y / np.linalg.norm(y), np.cross(x, y / np.linalg.norm(y))])
        q = np.array([0, 0, -GRAVITY * sections[kind]["mass"][0][0]])
        q = q + {"rafter": [0, 0, -SNOW], "column": [*WIND, 0] if points[a][0] == 0 else [0, 0, 0]}.get(kind, [0, 0, 0])
        own = stiffness_of(length, sections[kind]), forces_of(length, axes @ q)
        own = release(*own) if kind in ("purlin", "brace") else own
        turn = np.kron(np.eye(4), axes)
        at = [first[end] + i for end in (a, b) for i in range(6)]
        matrix[np.ix_(at, at)] += turn.T @ own[0] @ turn
        forces[at] += turn.T @ own[1]
    held = [first[number] + i for number, point in points.items() if point[2] == 0 for i in range(3)]
    free = np.setdiff1d(np.arange(len(forces)), held)
    found = np.zeros(len(forces))
    found[free] = np.linalg.solve(matrix[np.ix_(free, free)], forces[free])
    return {number: found[at : at + 3] for number, at in first.items()}


class Hall(ProgramTest):
    def test_it_is_the_frame_of_a_stiffness_matrix(self):
        deck = SOURCE / "docs" / "examples" / "hall" / "hall.toml"
        sections = {section["name"]: section for section in json.loads(self.gxrod("section", deck, "--json").stdout)}
        self.gxrod("run", deck, "--set", f"parameters.scale={SCALE}", "-o", "hall.vtkhdf", "--quiet")
        with h5py.File(self.folder / "hall.vtkhdf") as file:
            ridge = file["histories/ridge/displacement"][-1] / SCALE
        np.testing.assert_allclose(ridge, solve_frame(sections)[3], rtol=0, atol=1e-5 * np.linalg.norm(ridge))


if __name__ == "__main__":
    unittest.main()
