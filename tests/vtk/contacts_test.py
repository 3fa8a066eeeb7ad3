"""gxrod export --series DIR --contacts: VTK sees the rows of /contacts, frame by frame."""

import unittest

import h5py
import numpy as np
from program import ProgramTest
from reading import arrays_of, open_file, points_of, times_of
from vtkmodules.util.numpy_support import vtk_to_numpy

# A stick falls on a floor, bounces and lies: frames without and with contact.
DROP = """gravity = [0, 0, -9.81]
[section.s]
shape = { circle = { radius = 0.05 } }
material = { E = 1e9, nu = 0.3, density = 1000 }
[rod.low]
section = "s"
line = { from = [0, 0, 0.06], to = [1, 0, 0.06] }
elements = 4
[rod.high]
section = "s"
line = { from = [0.5, -0.5, 0.2], to = [0.5, 0.5, 0.2] }
elements = 4
[obstacle.floor]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
friction = 0.3
[contact]
self = false
[analysis]
kind = "dynamic"
end_time = 0.25
time_step = 2e-3
[output]
every = 5
"""


class Contacts(ProgramTest):
    def setUp(self):
        super().setUp()
        self.gxrod("run", self.write("drop.toml", DROP), "--quiet", "--force")

    def test_every_frame(self):
        done = self.gxrod("export", "drop.vtkhdf", "--series", "frames", "--contacts")
        self.assertEqual(done.stdout, "frames/drop.hdf.series\nframes/contacts.vtkhdf\n")
        reader = open_file(self.folder / "frames" / "contacts.vtkhdf")
        with h5py.File(self.folder / "drop.vtkhdf") as file:
            contacts = {name: values[()] for name, values in file["contacts"].items()}
            times = file["VTKHDF/Steps/Values"][()]
        np.testing.assert_array_equal(times_of(reader), times)
        offsets = contacts["offsets"]
        counts = np.diff(offsets)
        self.assertEqual(counts.min(), 0)
        self.assertGreater(counts.max(), 1)
        self.assertTrue((contacts["rods"][:, 1] >= 0).any() and (contacts["rods"][:, 1] < 0).any())
        for frame, time in enumerate(times):
            with self.subTest(frame=frame):
                reader.UpdateTimeStep(time)
                points = reader.GetOutput()
                rows = slice(offsets[frame], offsets[frame + 1])
                self.assertEqual(points.GetClassName(), "vtkPolyData")
                self.assertEqual(points.GetNumberOfPoints(), counts[frame])
                if counts[frame] == 0:
                    continue
                np.testing.assert_array_equal(points_of(points), contacts["point"][rows])
                cells = points.GetVerts()
                np.testing.assert_array_equal(vtk_to_numpy(cells.GetConnectivityArray()), np.arange(counts[frame]))
                np.testing.assert_array_equal(vtk_to_numpy(cells.GetOffsetsArray()), np.arange(counts[frame] + 1))
                arrays = arrays_of(points.GetPointData())
                self.assertEqual(
                    sorted(arrays), ["friction_force", "gap", "normal_force", "places", "rods", "slides"])
                for name, values in arrays.items():
                    np.testing.assert_array_equal(values, contacts[name][rows], err_msg=name)

    def test_the_least_gap_of_nodes(self):
        with h5py.File(self.folder / "drop.vtkhdf") as file:
            gaps = file["VTKHDF/PointData/contact_gap"][()].reshape(len(file["VTKHDF/Steps/Values"]), -1)
            heights = file["VTKHDF/Points"][()].reshape(len(gaps), -1, 3)[:, :, 2]
            rods = file["contacts/rods"][()]
            least = file["contacts/gap"][()]
            offsets = file["contacts/offsets"][()]
        skin = 0.02 * 0.05
        # Nodes of the first rod touch the floor themselves.
        expected = np.minimum(heights[:, :5] - 0.05, skin)
        for frame, own in enumerate(gaps):
            rows = slice(offsets[frame], offsets[frame + 1])
            self.assertAlmostEqual(own.min(), min([skin, *least[rows]]), delta=1e-12)
            if (rods[rows, 1] < 0).all():
                np.testing.assert_allclose(own[:5], expected[frame], atol=1e-12)
                np.testing.assert_allclose(own[5:], skin)

    def test_results_without_contact_have_none(self):
        deck = DROP[:DROP.index("[obstacle")] + DROP[DROP.index("[analysis]"):]
        self.gxrod("run", self.write("free.toml", deck), "--quiet")
        done = self.gxrod("export", "free.vtkhdf", "--series", "free", "--contacts", code=4)
        self.assertIn("free.vtkhdf has no contacts", done.stderr)
        self.gxrod("export", "drop.vtkhdf", "--contacts", code=2)


if __name__ == "__main__":
    unittest.main()
