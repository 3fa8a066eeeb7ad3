"""Where free places come to rest, about: lines as chains of springs, without bending, whose energy is least."""

from __future__ import annotations

import numpy as np

from ..typed import Array
from .mooring import Mooring

PIECES = 10  # of a line
SOFT = 1e-3  # stretch of a line by the weight of all, or more: the search is better conditioned
SEARCHES, CALM = 300, 1e-4  # steps at most; the force left over, of the weight of all


def find_rest(mooring: Mooring, loose: set[str]) -> dict[str, Array]:
    """The places of what is loose: names of free places and of bodies."""
    chains = Chains(mooring, loose)
    chains.settle()
    return {name: chains.at[index] for name, index in chains.index.items() if name in loose}


class Chains:
    """Points with weights and springs between them."""

    def __init__(self, mooring: Mooring, loose: set[str]) -> None:
        self.index: dict[str, int] = {}
        points: list[Array] = []
        weights: list[float] = []
        springs: list[tuple[int, int, float, float]] = []

        def add(at: Array, weight: float = 0.0) -> int:
            points.append(at)
            weights.append(weight)
            return len(points) - 1

        lift = mooring.gravity * mooring.density
        for body in mooring.bodies:
            self.index[body.name] = add(np.array(body.at), mooring.gravity * body.mass - lift * body.volume)
        for line in mooring.lines:
            ends = []
            for place in line.ends:
                name = place.body or place.name
                if name not in self.index:
                    self.index[name] = add(np.array(place.at), mooring.gravity * place.mass - lift * place.volume if name in loose else 0.0)
                ends.append(self.index[name])
            share = line.type.submerged_weight(mooring.density, mooring.gravity) * line.length / PIECES
            first, last = (np.array(place.at) for place in line.ends)
            inner = [add(first + (last - first) * i / PIECES, share) for i in range(1, PIECES)]
            rest = line.length / PIECES
            for a, b in zip([ends[0], *inner], [*inner, ends[1]]):
                springs.append((a, b, rest, line.type.EA / rest))
            for end in ends:
                weights[end] += share / 2
        held = {self.index[place.body or place.name] for line in mooring.lines for place in line.ends if (place.body or place.name) not in loose}
        self.at, self.weights = np.array(points), np.array(weights)
        self.first, self.second = (np.array([spring[i] for spring in springs]) for i in (0, 1))
        self.free = np.array([i for i in range(len(points)) if i not in held])
        self.bottom = -mooring.depth if mooring.depth > 0.0 else -np.inf
        self.ground = float(np.abs(self.weights).sum())  # force per depth: that of all at 1
        self.rest, stiffness = (np.array([spring[i] for spring in springs]) for i in (2, 3))
        self.stiffness = np.minimum(stiffness, self.ground / SOFT / self.rest)

    def stretched(self, at: Array) -> tuple[Array, Array, Array]:
        """Directions, lengths and elongations of springs; what is slack has none."""
        apart = at[self.second] - at[self.first]
        length = np.maximum(np.linalg.norm(apart, axis=1), 1e-12)
        return apart / length[:, None], length, np.maximum(length - self.rest, 0.0)

    def energy(self, at: Array) -> float:
        _, _, longer = self.stretched(at)
        sunk = np.maximum(self.bottom - at[:, 2], 0.0)
        return float(0.5 * self.stiffness @ longer**2 + self.weights @ at[:, 2] + 0.5 * self.ground * sunk @ sunk)

    def slope_and_stiffness(self) -> tuple[Array, Array]:
        count = len(self.at)
        along, length, longer = self.stretched(self.at)
        tension = self.stiffness * longer
        slope = np.zeros((count, 3))
        np.add.at(slope, self.second, tension[:, None] * along)
        np.add.at(slope, self.first, -tension[:, None] * along)
        sunk = np.maximum(self.bottom - self.at[:, 2], 0.0)
        slope[:, 2] += self.weights - self.ground * sunk
        whole = np.zeros((count, count, 3, 3))
        outer = along[:, :, None] * along[:, None, :]
        blocks = (self.stiffness * (longer > 0.0))[:, None, None] * outer + (tension / length)[:, None, None] * (np.eye(3) - outer)
        for a, b, sign in ((self.first, self.first, 1), (self.second, self.second, 1), (self.first, self.second, -1), (self.second, self.first, -1)):
            np.add.at(whole, (a, b), sign * blocks)
        whole[np.arange(count), np.arange(count), 2, 2] += self.ground * (sunk > 0.0)
        return slope, whole

    def settle(self) -> None:
        """Newton's method with as much damping as makes the energy fall."""
        damping = self.ground / 10.0
        for _ in range(SEARCHES):
            slope, whole = self.slope_and_stiffness()
            free = self.free
            left = slope[free].ravel()
            if np.abs(left).max() < CALM * self.ground:
                return
            matrix = whole[np.ix_(free, free)].transpose(0, 2, 1, 3).reshape(left.size, left.size)
            before = self.energy(self.at)
            while damping < 1e12 * self.ground:
                trial = self.at.copy()
                trial[free] -= np.linalg.solve(matrix + damping * np.eye(left.size), left).reshape(-1, 3)
                if self.energy(trial) < before:
                    break
                damping *= 4.0
            else:
                return
            self.at = trial
            damping = max(damping / 3.0, 1e-9 * self.ground)
