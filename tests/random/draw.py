"""Random choices of one deck, all from one stream: the same seed and index give the same deck."""

import numpy as np

LITERAL = ("group",)  # keys whose numbers are not expressions


def floats(values):
    """Of an array, for a deck."""
    return [float(value) for value in values]


class Draw:
    def __init__(self, seed, index):
        self.random = np.random.Generator(np.random.PCG64([seed, index]))

    def chance(self, probability):
        return bool(self.random.random() < probability)

    def uniform(self, low, high):
        return float(self.random.uniform(low, high))

    def log_uniform(self, low, high):
        return float(np.exp(self.random.uniform(np.log(low), np.log(high))))

    def integer(self, low, high):
        """From low to high, both included."""
        return int(self.random.integers(low, high + 1))

    def pick(self, choices):
        return choices[self.integer(0, len(choices) - 1)]

    def weighted(self, weights):
        """A key of {key: weight}."""
        numbers = np.array(list(weights.values()), float)
        return list(weights)[int(self.random.choice(len(numbers), p=numbers / numbers.sum()))]

    def some(self, choices, most):
        """One to `most` different ones, in random order."""
        count = self.integer(1, min(most, len(choices)))
        return [choices[i] for i in self.random.permutation(len(choices))[:count]]

    def vector(self, size=1.0):
        """In any direction, its components as different as they come."""
        return size * self.random.normal(size=3)

    def direction(self):
        vector = self.vector()
        return vector / np.linalg.norm(vector)

    def rotation(self):
        """A rotation matrix, any being as likely."""
        matrix, upper = np.linalg.qr(self.random.normal(size=(3, 3)))
        matrix *= np.sign(np.diag(upper))
        if np.linalg.det(matrix) < 0:
            matrix[:, 0] = -matrix[:, 0]
        return matrix

    def with_expressions(self, value, key=""):
        """The part of a deck, now and then a number replaced by an expression of the same value."""
        if isinstance(value, dict):
            return {name: self.with_expressions(entry, name) for name, entry in value.items()}
        if isinstance(value, list):
            return [self.with_expressions(entry, key) for entry in value]
        if key in LITERAL or not isinstance(value, (int, float)) or not self.chance(0.08):
            return value
        form = self.pick(["{}", "2*({})/2", "0 + ({})", "-(-({}))"])
        return form.format(repr(value))
