"""What a mechanism can do in its first instant, by the twists that its joints leave free; rods count as rigid."""

import numpy as np


def cross_matrix(v):
    x, y, z = v
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def unit(v):
    return np.asarray(v) / np.linalg.norm(v)


def twist_at(place, part, count, size):
    """The 6 × 6n matrix from the parts' twists (ω, v at the origin over `size`) to one at a place; zero for the ground."""
    matrix = np.zeros((6, 6 * count))
    if part is not None:
        matrix[:3, 6 * part:6 * part + 3] = np.eye(3)
        matrix[3:, 6 * part:6 * part + 3] = -cross_matrix(np.asarray(place) / size)
        matrix[3:, 6 * part + 3:6 * part + 6] = np.eye(3)
    return matrix


def allowed(joint, size):
    """Columns: relative twists (ω, v/size) at its place that a joint allows."""
    kind = joint["type"]
    eye, none = np.eye(3), np.zeros(3)
    axis = unit(joint["axis"]) if "axis" in joint else none
    turn, slide = np.concatenate([axis, none]), np.concatenate([none, axis])
    turns = [np.concatenate([e, none]) for e in eye]
    slides = [np.concatenate([none, e]) for e in eye]
    return {"ball": lambda: turns, "hinge": lambda: [turn], "cylinder": lambda: [turn, slide], "slider": lambda: [slide],
            "universal": lambda: [turn, np.concatenate([unit(joint["axis_b"]), none])],
            "screw": lambda: [turn + joint["lead"] / (2 * np.pi * size) * slide],
            "plane": lambda: [turn, *(np.concatenate([none, e]) for e in np.linalg.svd(axis[None])[2][1:])],
            "weld": lambda: [], "free": lambda: turns + slides}[kind]()


class Mobility:
    def __init__(self, mechanism, size):
        self.mechanism, self.size = mechanism, size
        self.numbers = {name: i for i, name in enumerate([*mechanism["rod"], *mechanism["body"]])}
        self.rows = np.zeros((0, 6 * len(self.numbers)))
        for joint in mechanism["joint"].values():
            self.rows = np.vstack([self.rows, self.rows_of(joint)])
        for gear in mechanism["gear"].values():
            first, second = (self.rate_of(*pair) for pair in gear["joints"])
            self.rows = np.vstack([self.rows, unit(gear["ratio"] * first + second)])

    def part(self, point):
        return self.numbers.get(point.split(".")[0])

    def relative(self, joint, at_a, at_b):
        a, b = (self.part(point) for point in joint["between"])
        count = len(self.numbers)
        return twist_at(at_b, b, count, self.size) - twist_at(at_a, a, count, self.size)

    def rows_of(self, joint):
        if joint["type"] == "distance":
            along = unit(joint["at_b"] - joint["at_a"])
            return along[None] @ self.relative(joint, joint["at_a"], joint["at_b"])[3:]
        relative = self.relative(joint, joint["at"], joint["at"])
        if joint["type"] == "sleeve":
            line = self.mechanism["rod"][joint["between"][0]]["line"]
            across = np.linalg.svd(unit(line["to"] - line["from"])[None])[2][1:] @ relative[3:]
            return across if joint.get("turn", True) else np.vstack([across, relative[:3]])
        free = np.array(allowed(joint, self.size)).reshape(-1, 6)
        forbidden = np.linalg.svd(free, full_matrices=True)[2][np.linalg.matrix_rank(free):] if len(free) else np.eye(6)
        return forbidden @ relative

    def rate_of(self, name, which):
        """The row of a turn or a slide."""
        joint = self.mechanism["joint"][name]
        relative = self.relative(joint, joint["at"], joint["at"])
        axis = unit(joint["axis"])
        return axis @ relative[:3] if which == "turn" else self.size * axis @ relative[3:]

    def rank(self, rows=None):
        rows = self.rows if rows is None else rows
        return int(np.linalg.matrix_rank(rows, tol=1e-9)) if len(rows) else 0

    def free_motions(self):
        return 6 * len(self.numbers) - self.rank()

    def redundant(self):
        return len(self.rows) - self.rank()

    def can_move(self, name, which):
        """Whether a motor can drive a coordinate: it is not held already."""
        return self.rank(np.vstack([self.rows, unit(self.rate_of(name, which))])) > self.rank()

    def add_motor(self, name, which):
        self.rows = np.vstack([self.rows, unit(self.rate_of(name, which))])
