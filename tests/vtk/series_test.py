"""gxrod export --series: each frame as a file of its own equals the frame of the results."""

import json
import unittest

import h5py
import numpy as np
from decks import loaded_frame, moving_frame
from program import ProgramTest
from reading import arrays_of, cells_of, frame_at, open_file, points_of, times_of


class Series(ProgramTest):
    def export(self, deck):
        """Runs a deck and exports it; gives the reader of the results and (name, time) of the series' files."""
        self.gxrod("run", self.write("frame.toml", deck), "--quiet", "--force")
        done = self.gxrod("export", "frame.vtkhdf", "--series", "series", "--force")
        self.assertEqual(done.stdout, "series/frame.hdf.series\n")
        series = json.loads((self.folder / "series" / "frame.hdf.series").read_text())
        self.assertEqual(series["file-series-version"], "1.0")
        return open_file(self.folder / "frame.vtkhdf"), [(file["name"], file["time"]) for file in series["files"]]

    def assert_equal(self, single, frame):
        self.assertEqual(cells_of(single), cells_of(frame))
        np.testing.assert_array_equal(points_of(single), points_of(frame))
        self.assertEqual(points_of(single).dtype, np.float64)
        for ours, theirs in ((single.GetPointData(), frame.GetPointData()),
                             (single.GetCellData(), frame.GetCellData())):
            ours, theirs = arrays_of(ours), arrays_of(theirs)
            self.assertEqual(sorted(ours), sorted(theirs))
            for name, values in ours.items():
                np.testing.assert_array_equal(values, theirs[name], err_msg=name)
                self.assertEqual(values.dtype, theirs[name].dtype)

    def test_every_frame(self):
        for make in (moving_frame, loaded_frame):
            for order in (1, 2, 3, 4):
                with self.subTest(deck=make.__name__, order=order):
                    reader, files = self.export(make(order))
                    self.assertEqual([name for name, _ in files], [f"frame_{i:04}.hdf" for i in range(len(files))])
                    np.testing.assert_array_equal([time for _, time in files], times_of(reader))
                    for name, time in files:
                        single = open_file(self.folder / "series" / name)
                        self.assertEqual(len(times_of(single)), 0)
                        single.Update()
                        self.assert_equal(single.GetOutput(), frame_at(reader, time))

    def test_files_say_that_they_are_version_1_and_what_they_hold(self):
        self.export(moving_frame(2))
        with h5py.File(self.folder / "series" / "frame_0003.hdf") as single, \
                h5py.File(self.folder / "frame.vtkhdf") as results:
            np.testing.assert_array_equal(single["VTKHDF"].attrs["Version"], [1, 0])
            self.assertNotIn("Steps", single["VTKHDF"])
            for name in ("Points", "PointData/velocity", "CellData/moment"):
                self.assertEqual(dict(single["VTKHDF"][name].attrs), dict(results["VTKHDF"][name].attrs))


if __name__ == "__main__":
    unittest.main()
