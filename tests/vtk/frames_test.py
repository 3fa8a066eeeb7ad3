"""VTK's reader shows every frame of a results file as it was computed."""

import unittest

import h5py
import numpy as np
from decks import GRAVITY, RADIUS, SPIN, THICK, THIN, loaded_frame, moving_frame
from program import ProgramTest
from reading import arrays_of, cells_of, curve_of, frame_at, frame_of_step, open_file, points_of, times_of

TYPES = {1: 3, 2: 21, 3: 68, 4: 68}  # VTK's line, quadratic edge, Lagrange curve
VERTEX = 1
ELEMENTS = 6  # arc 3, leg 2, strut 1
CASES = [(kind, order, element) for kind in ("moving", "loaded") for order in (1, 2, 3, 4)
         for element in ("objective", "simo")]


def rotation_matrices(vectors):
    """Rodrigues' formula, [N, 3] → [N, 3, 3]."""
    matrices = []
    for vector in vectors:
        x, y, z = vector
        cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        angle = np.linalg.norm(vector)
        # sinc(x) is sin(πx)/(πx)
        matrices.append(np.eye(3) + np.sinc(angle / np.pi) * cross
                        + 0.5 * np.sinc(angle / (2 * np.pi)) ** 2 * cross @ cross)
    return np.array(matrices)


def axes_of(grid):
    """The axes of each point as columns, [N, 3, 3]."""
    points = arrays_of(grid.GetPointData())
    return np.stack([points[name] for name in ("axis_x", "axis_y", "axis_z")], axis=2)


class Frames(ProgramTest):
    def run_deck(self, kind, order, element):
        """Runs a deck; gives VTK's reader and its frames at all of its times."""
        name = f"{kind}_{order}_{element}"
        self.results = self.folder / f"{name}.vtkhdf"
        if not self.results.exists():
            make = moving_frame if kind == "moving" else loaded_frame
            self.gxrod("run", self.write(f"{name}.toml", make(order, element)), "--quiet")
        reader = open_file(self.results)
        return reader, [frame_at(reader, time) for time in times_of(reader)]

    def test_frames_are_what_the_file_has(self):
        for case in CASES:
            reader, frames = self.run_deck(*case)
            with self.subTest(case), h5py.File(self.results) as file:
                grid = file["VTKHDF"]
                self.assertEqual(reader.GetNumberOfSteps(), grid["Steps"].attrs["NSteps"])
                np.testing.assert_array_equal(times_of(reader), grid["Steps/Values"][()])
                by_step = [frame_of_step(open_file(self.results), step) for step in range(len(frames))]
                for shown in (frames, by_step):
                    for step, frame in enumerate(shown):
                        self.assert_is_frame(grid, step, frame)

    def assert_is_frame(self, grid, step, frame):
        def rows(dataset, count):
            return dataset[step * count:(step + 1) * count] if dataset.maxshape[0] is None else dataset[()]

        points, cells = grid["NumberOfPoints"][0], grid["NumberOfCells"][0]
        self.assertEqual((frame.GetNumberOfPoints(), frame.GetNumberOfCells()), (points, cells))
        np.testing.assert_array_equal(points_of(frame), rows(grid["Points"], points))
        for data, group, count in ((frame.GetPointData(), grid["PointData"], points),
                                   (frame.GetCellData(), grid["CellData"], cells)):
            arrays = arrays_of(data)
            self.assertEqual(sorted(arrays), sorted(group))
            for name, values in arrays.items():
                np.testing.assert_array_equal(values, rows(group[name], count), err_msg=name)

    def test_times_are_those_of_the_deck(self):
        for kind, times in (("moving", np.arange(6) * 0.04), ("loaded", np.arange(5) * 0.25)):
            reader, _ = self.run_deck(kind, 1, "objective")
            np.testing.assert_allclose(times_of(reader), times, rtol=1e-12)

    def test_points_move_by_their_displacement_and_axes_turn_by_their_rotation_vector(self):
        for case in CASES:
            _, frames = self.run_deck(*case)
            with self.subTest(case):
                self.assertGreater(np.abs(arrays_of(frames[-1].GetPointData())["rotation_vector"]).max(), 0.05)
                for frame in frames:
                    moved = arrays_of(frame.GetPointData())
                    np.testing.assert_allclose(
                        points_of(frame), points_of(frames[0]) + moved["displacement"], atol=1e-14)
                    axes = axes_of(frame)
                    np.testing.assert_allclose(
                        axes.transpose(0, 2, 1) @ axes, np.broadcast_to(np.eye(3), axes.shape), atol=1e-13)
                    np.testing.assert_allclose(np.linalg.det(axes), 1.0, atol=1e-13)
                    turned = rotation_matrices(moved["rotation_vector"]) @ axes_of(frames[0])
                    np.testing.assert_allclose(axes, turned, atol=1e-12)

    def test_the_reference_is_the_deck_s(self):
        for _, order, element in CASES:
            _, frames = self.run_deck("moving", order, element)
            cells, points, axes = cells_of(frames[0]), points_of(frames[0]), axes_of(frames[0])
            arc = sorted({i for _, ids in cells[:3] for i in ids})
            angle = np.arctan2(points[arc, 1], points[arc, 0])
            np.testing.assert_allclose(np.linalg.norm(points[arc], axis=1), RADIUS, atol=1e-13)
            np.testing.assert_allclose([angle.min(), angle.max()], [0, np.pi / 2], atol=1e-13)
            along = np.stack([-np.sin(angle), np.cos(angle), 0 * angle], axis=1)
            # At the joint the arc, first in the deck, lends its axes and its radius.
            np.testing.assert_allclose(axes[arc][:, :, 0], along, atol=1e-12)
            radii = arrays_of(frames[0].GetCellData())["radius"]
            np.testing.assert_allclose(radii, [THIN] * 3 + [THICK] * 2 + [THIN, 0, 0], rtol=1e-12)
            point_radii = arrays_of(frames[0].GetPointData())["radius"]
            np.testing.assert_allclose(point_radii[arc], THIN, rtol=1e-12)
            np.testing.assert_allclose(points[point_radii == 0.0], [[5, 5, 5]])

    def test_cells_draw_the_curve(self):
        # Distance from an arc of 30°, over its radius. VTK takes nodes for equally spaced: so between those of
        # order 3 and 4 it draws a little off the rod.
        distances = {1: 0.0341, 2: 0.000143, 3: 0.0055, 4: 0.00046}
        parameters = np.linspace(0, 1, 25)
        for _, order, element in CASES:
            with self.subTest(order=order, element=element):
                _, frames = self.run_deck("moving", order, element)
                self.assertEqual([kind for kind, _ in cells_of(frames[0])], [TYPES[order]] * ELEMENTS + [VERTEX] * 2)
                for cell in range(3):
                    curve = curve_of(frames[0], cell, parameters)
                    angle = np.arctan2(curve[:, 1], curve[:, 0]) - cell * np.pi / 6
                    np.testing.assert_allclose(angle[[0, -1]], [0, np.pi / 6], atol=1e-13)
                    self.assertGreater(np.diff(angle).min(), 0.0, "it folds back")
                    off = np.abs(np.linalg.norm(curve, axis=1) - RADIUS).max() / RADIUS
                    self.assertAlmostEqual(off / distances[order], 1.0, delta=0.01)
                    nodes = curve_of(frames[0], cell, np.linspace(0, 1, order + 1))
                    np.testing.assert_allclose(np.linalg.norm(nodes, axis=1), RADIUS, atol=1e-13)

    def test_cells_and_points_know_their_place_along_the_rods(self):
        for _, order, element in CASES:
            _, frames = self.run_deck("moving", order, element)
            for frame in frames:  # the same at all times
                cells, points = arrays_of(frame.GetCellData()), arrays_of(frame.GetPointData())
                np.testing.assert_array_equal(cells["rod"], [0, 0, 0, 1, 1, 2, -1, -1])
                np.testing.assert_array_equal(cells["element"], [0, 1, 2, 0, 1, 0, -1, -1])
                third = RADIUS * np.pi / 6
                np.testing.assert_allclose(cells["arc_length"][:3], third * np.array([0.5, 1.5, 2.5]), rtol=1e-12)
                arc = points["rod"] == 0
                self.assertEqual(arc.sum(), 3 * order + 1)
                positions = points_of(frames[0])[arc]
                angle = np.arctan2(positions[:, 1], positions[:, 0])
                along = points["arc_length"][arc] / RADIUS
                np.testing.assert_allclose(np.minimum(np.abs(along - angle), np.abs(along - np.pi / 2 + angle)), 0, atol=1e-12)
                self.assertEqual(points["arc_length"][-1], 0.0)

    def test_a_ball_falls_and_spins(self):
        reader, frames = self.run_deck("moving", 2, "objective")
        for time, frame in zip(times_of(reader), frames):
            ball = {name: values[-1] for name, values in arrays_of(frame.GetPointData()).items()}
            np.testing.assert_allclose(points_of(frame)[-1], [5, 5, 5 + GRAVITY * time**2 / 2], atol=1e-12)
            np.testing.assert_allclose(ball["velocity"], [0, 0, GRAVITY * time], atol=1e-11)
            np.testing.assert_allclose(ball["angular_velocity"], [0, 0, SPIN], atol=1e-11)
            np.testing.assert_allclose(ball["rotation_vector"], [0, 0, SPIN * time], atol=1e-11)

    def test_the_leg_carries_the_load(self):
        for order in (1, 2, 3, 4):
            reader, frames = self.run_deck("loaded", order, "objective")
            for factor, frame in zip(times_of(reader), frames):
                force = arrays_of(frame.GetCellData())["force"][3:5]
                np.testing.assert_allclose(np.linalg.norm(force, axis=1), factor * np.sqrt(14), rtol=1e-6, atol=1e-9)


if __name__ == "__main__":
    unittest.main()
