"""From space to the paper: a coordinate plane where a problem lies in one, else a view from the side."""

import numpy as np

# Rows: right and up on the paper. Seen from the direction of their cross product.
PLANES = {2: np.array([[1.0, 0, 0], [0, 1, 0]]), 1: np.array([[1.0, 0, 0], [0, 0, 1]]),
          0: np.array([[0, 1.0, 0], [0, 0, 1]])}


def side_view(azimuth=-62.0, elevation=24.0):
    a, e = np.radians([azimuth, elevation])
    right = [-np.sin(a), np.cos(a), 0.0]
    up = [-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a), np.cos(e)]
    return np.array([right, up])


def find_normal(points, in_plane, across):
    """The axis across which nothing lies: forces and shapes in the plane, moments normal to it; None in space."""
    size = max(np.ptp(points, axis=0).max(), 1e-12)
    for axis in (2, 1, 0):
        others = [other for other in range(3) if other != axis]
        flat = np.ptp(points[:, axis]) < 1e-9 * size
        forces = all(abs(vector[axis]) < 1e-9 * np.linalg.norm(vector) for vector in in_plane)
        moments = all(np.linalg.norm(vector[others]) < 1e-9 * np.linalg.norm(vector) for vector in across)
        if flat and forces and moments and (np.ptp(points[:, others], axis=0) > 1e-9 * size).any():
            return axis
    return None


class Projection:
    """Right and up of the paper, and the direction towards the reader."""

    def __init__(self, normal=None):
        self.is_planar = normal is not None
        self.rows = PLANES[normal] if self.is_planar else side_view()
        self.towards = np.cross(*self.rows)

    def __call__(self, points):
        return np.asarray(points) @ self.rows.T

    def direction(self, vector):
        """Unit vector on the paper, or zero of one that points at the reader."""
        flat = self(np.asarray(vector, float))
        size = np.linalg.norm(flat)
        return flat / size if size > 1e-9 * max(np.linalg.norm(vector), 1e-300) else np.zeros(2)
