"""gxrod export: tables that equal the results file, and a series of its frames."""

import csv
import json
import subprocess
import time
import unittest

import h5py
import numpy as np
from gxrod_stress import FRAME
from program import GXROD, SOURCE, SPINNING_BODY, ProgramTest, limit_file_size


def read_table(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    return rows[0], np.array([[float(number) for number in row] for row in rows[1:]])


def read_columns(path):
    headings, values = read_table(path)
    return dict(zip(headings, values.T))


TWO_RODS = """
[section.s]
stiffness = { EA = 1000, GAy = 500, GAz = 500, GJ = 1, EIy = 1, EIz = 1 }
inertia = { rhoA = 1, rhoIy = 0.1, rhoIz = 0.1 }
[rod.arc]
section = "s"
arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1, 0, 0], angle = "pi/2" }
elements = 2
order = 3
[rod.stick]
section = "s"
line = { from = [0, 1, 0], to = [-1, 1, 0] }
elements = 2
[[connect]]
points = ["arc.end", "stick.start"]
[[support]]
at = "arc.start"
fix = "all"
[[load]]
at = "stick.end"
force = [0, 0, 5]
[analysis]
kind = "dynamic"
end_time = 0.2
time_step = 0.01
[output]
every = 5
"""


STRESS_HISTORY = """[[history]]
name = "foot"
at = "left.start"
quantities = ["stress", "von_mises", "principal_stress", "exposure", "stress_place"]
"""


class Export(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("body.toml", SPINNING_BODY.replace('"position"]', '"position", "quaternion"]'))
        self.gxrod("run", "body.toml", "--quiet")

    def test_tables_hold_every_number_to_its_last_bit(self):
        done = self.gxrod("export", "body.vtkhdf", "--csv", "tables")
        self.assertEqual(done.stdout.split(), ["tables/ledger.csv", "tables/solver.csv", "tables/history_spin.csv"])
        with h5py.File(self.folder / "body.vtkhdf") as file:
            for name, group in (("ledger", file["ledger"]), ("solver", file["solver"]),
                                ("history_spin", file["histories/spin"])):
                headings, values = read_table(self.folder / "tables" / f"{name}.csv")
                self.assertEqual(headings[0], "time")
                np.testing.assert_array_equal(values[:, 0], file["histories/time"][:])
                column = 1
                for key in group:
                    if key == "time":
                        continue
                    expected = group[key][:].reshape(len(values), -1)
                    width = expected.shape[1]
                    letters = {1: [""], 3: ["_x", "_y", "_z"], 4: ["_w", "_x", "_y", "_z"]}[width]
                    self.assertEqual(headings[column:column + width], [key + letter for letter in letters])
                    np.testing.assert_array_equal(values[:, column:column + width], expected)
                    column += width
                self.assertEqual(column, len(headings))

    def test_a_static_run_has_load_factors(self):
        self.write("bar.toml", """
[section.s]
stiffness = { EA = 100, GAy = 50, GAz = 50, GJ = 1, EIy = 1, EIz = 1 }
[rod.bar]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 2
[[support]]
at = "bar.start"
fix = "all"
[[load]]
at = "bar.end"
force = [1, 0, 0]
[analysis]
kind = "static"
steps = 2
""")
        self.gxrod("run", "bar.toml", "--quiet")
        self.gxrod("export", "bar.vtkhdf", "--csv", ".")
        headings, values = read_table(self.folder / "ledger.csv")
        self.assertEqual(headings[0], "load_factor")
        np.testing.assert_array_equal(values[:, 0], [0.0, 0.5, 1.0])

    def test_files_are_kept_by_default(self):
        self.gxrod("export", "body.vtkhdf", "--csv", "tables")
        done = self.gxrod("export", "body.vtkhdf", "--csv", "tables", code=4)
        self.assertIn("tables/ledger.csv: exists already (--force overwrites it)", done.stderr)
        self.gxrod("export", "body.vtkhdf", "--csv", "tables", "--force")

    def test_a_series_is_kept_by_default(self):
        done = self.gxrod("export", "body.vtkhdf", "--series", "a/series", "--csv", "tables")
        self.assertEqual(done.stdout.split()[-1], "a/series/body.hdf.series")
        names = [f"body_{i:04}.hdf" for i in range(11)]
        self.assertEqual(sorted(path.name for path in (self.folder / "a/series").iterdir()),
                         ["body.hdf.series", *names])
        (self.folder / "a/series/body_0000.hdf").unlink()
        done = self.gxrod("export", "body.vtkhdf", "--series", "a/series", code=4)
        self.assertIn("a/series/body_0001.hdf: exists already (--force overwrites it)", done.stderr)
        self.assertFalse((self.folder / "a/series/body_0000.hdf").exists())
        self.gxrod("export", "body.vtkhdf", "--series", "a/series", "--force")

    def test_a_shorter_series_leaves_no_frames_of_the_longer_one(self):
        self.gxrod("export", "body.vtkhdf", "--series", "series")
        folder = self.folder / "series"
        listed = json.loads((folder / "body.hdf.series").read_text())
        listed["files"] += [{"name": "../body_0099.hdf"}, {"name": "notes.txt"}, {"name": "other_0001.hdf"}, {"name": 1}, 2]
        (folder / "body.hdf.series").write_text(json.dumps(listed))
        kept = [self.folder / "body_0099.hdf", folder / "notes.txt", folder / "other_0001.hdf", folder / "body_0100.hdf"]
        for path in kept:
            path.write_text("not of this series")
        self.gxrod("run", "body.toml", "--quiet", "--force", "--set", "output.every=50")
        self.gxrod("export", "body.vtkhdf", "--series", "series", "--force")
        self.assertEqual(sorted(path.name for path in folder.glob("body*")),
                         ["body.hdf.series", "body_0000.hdf", "body_0001.hdf", "body_0002.hdf", "body_0100.hdf"])
        self.assertTrue(all(path.exists() for path in kept))
        (folder / "body.hdf.series").write_text("no JSON")
        self.gxrod("export", "body.vtkhdf", "--series", "series", "--force")

    def test_a_series_lists_each_frame_with_its_time(self):
        self.gxrod("export", "body.vtkhdf", "--series", "series")
        series = json.loads((self.folder / "series/body.hdf.series").read_text())
        with h5py.File(self.folder / "body.vtkhdf") as file:
            self.assertEqual([entry["time"] for entry in series["files"]], list(file["VTKHDF/Steps/Values"][()]))
            for number, entry in enumerate(series["files"]):
                with h5py.File(self.folder / "series" / entry["name"]) as frame:
                    turned = file["VTKHDF/PointData/rotation_vector"][number:number + 1]
                    np.testing.assert_array_equal(frame["VTKHDF/PointData/rotation_vector"][()], turned)

    def test_a_running_job_has_the_steps_so_far(self):
        deck = SOURCE / "docs/examples/free_flight/free_flight.toml"
        run = subprocess.Popen([GXROD, "run", deck, "--quiet", "--set", "analysis.end_time=3000"], cwd=self.folder)
        try:
            time.sleep(2.0)
            self.gxrod("export", "free_flight.vtkhdf", "--series", "series")
            series = json.loads((self.folder / "series/free_flight.hdf.series").read_text())
            self.assertGreater(len(series["files"]), 1)
            counts = []
            for _ in range(6):
                self.gxrod("export", "free_flight.vtkhdf", "--csv", "tables", "--force")
                lengths = {len(read_table(path)[1]) for path in (self.folder / "tables").glob("history_*.csv")}
                counts.append(max(lengths))
            self.assertIsNone(run.poll())
            self.assertGreater(counts[0], 1)
            self.assertGreater(counts[-1], counts[0])
        finally:
            run.kill()
            run.wait()

    def run_two_rods(self):
        """A clamped quarter of a circle of order 3 and, from its end on, a straight rod of order 1, in motion."""
        self.write("two.toml", TWO_RODS)
        self.gxrod("run", "two.toml", "--quiet")

    def test_what_is_along_a_rod(self):
        self.run_two_rods()
        done = self.gxrod("export", "two.vtkhdf", "--along", "arc", "--all", "-o", "along")
        self.assertEqual(done.stdout.split(), ["along/along_arc_nodes.csv", "along/along_arc_elements.csv"])
        nodes = read_columns(self.folder / "along/along_arc_nodes.csv")
        elements = read_columns(self.folder / "along/along_arc_elements.csv")
        with h5py.File(self.folder / "two.vtkhdf") as file:
            grid = file["VTKHDF"]
            times = grid["Steps/Values"][()]
            points = grid["Points"][()].reshape(len(times), -1, 3)
            moment = grid["CellData/moment"][()].reshape(len(times), -1, 3)
        self.assertEqual(len(nodes["time"]), len(times) * 7)
        self.assertEqual(len(elements["time"]), len(times) * 2)
        np.testing.assert_array_equal(nodes["time"][::7], times)
        # At t = 0 positions are those of the circle.
        start = nodes["time"] == 0.0
        s = nodes["arc_length"][start]
        np.testing.assert_allclose(s[[0, 3, 6]], [0.0, np.pi / 4, np.pi / 2], rtol=1e-14)
        np.testing.assert_array_equal(nodes["element"][start], [0, 0, 0, 0, 1, 1, 1])
        np.testing.assert_allclose(nodes["position_x"][start], np.cos(s), atol=1e-12)
        np.testing.assert_allclose(nodes["position_y"][start], np.sin(s), atol=1e-12)
        middles = elements["arc_length"][:2]
        np.testing.assert_allclose(middles, [np.pi / 8, 3 * np.pi / 8], rtol=1e-14)
        # The remainder of cubic interpolation at ξ = 0: (ξ² − 1)(ξ² − 1/5) (L/2)⁴/4! of a fourth derivative up to 1.
        remainder = 0.2 * (np.pi / 8)**4 / 24
        np.testing.assert_allclose(elements["position_x"][:2], np.cos(middles), atol=remainder)
        np.testing.assert_allclose(elements["position_y"][:2], np.sin(middles), atol=remainder)
        for i, axis in enumerate("xyz"):
            np.testing.assert_array_equal(nodes[f"position_{axis}"],
                                          points[:, nodes["point"][:7].astype(int), i].ravel())
            np.testing.assert_array_equal(elements[f"moment_{axis}"], moment[:, :2, i].ravel())
        np.testing.assert_allclose(nodes["position_z"], nodes["displacement_z"], atol=1e-14)
        self.assertGreater(np.abs(elements["moment_y"]).max(), 0.005)

    def test_one_frame_along_a_rod(self):
        self.run_two_rods()
        self.gxrod("export", "two.vtkhdf", "--along", "stick")
        nodes = read_columns(self.folder / "along_stick_nodes.csv")
        np.testing.assert_array_equal(nodes["time"], [0.2] * 3)
        # The first node is the arc's last, whose arc length there is another.
        np.testing.assert_array_equal(nodes["arc_length"], [0.0, 0.5, 1.0])
        done = self.gxrod("export", "two.vtkhdf", "--along", "stick", "--time", "0.11", "--force")
        self.assertEqual(done.stderr, "the frame nearest to 0.11 is that at 0.1\n")
        nodes = read_columns(self.folder / "along_stick_nodes.csv")
        np.testing.assert_allclose(nodes["time"], [0.1] * 3, rtol=1e-14)

    def test_what_cannot_be_exported_along_a_rod(self):
        self.run_two_rods()
        for arguments, code, said in (
                (("--along", "stock"), 4, "two.vtkhdf: has no rod stock (it has arc, stick)"),
                (("--along", "arc", "--time", "0.3"), 4,
                 "two.vtkhdf: has no frame near t = 0.3 (its frames are from t = 0 to 0.2)"),
                (("--along", "arc", "--time", "nan"), 4, "has no frame near t = nan"),
                (("--along", "arc", "--time", "0", "--all"), 2, "--time excludes --all"),
                (("--csv", "tables", "--all"), 2, "--all requires --along")):
            self.assertIn(said, self.gxrod("export", "two.vtkhdf", *arguments, code=code).stderr)
        self.assertIn("body.vtkhdf: has no rods", self.gxrod("export", "body.vtkhdf", "--along", "arc", code=4).stderr)
        self.gxrod("export", "two.vtkhdf", "--along", "arc")
        done = self.gxrod("export", "two.vtkhdf", "--along", "arc", code=4)
        self.assertIn("along_arc_nodes.csv: exists already (--force overwrites it)", done.stderr)
        done = self.gxrod("export", "two.vtkhdf", "--along", "arc", "-o", "full", code=4, preexec_fn=limit_file_size(500))
        self.assertIn("full/along_arc_nodes.csv: cannot be written (File too large)", done.stderr)

    def test_results_of_earlier_versions_have_no_rods_and_are_exported_all_the_same(self):
        self.run_two_rods()
        with h5py.File(self.folder / "two.vtkhdf", "r+") as file:
            del file["rods"]
            for data in ("PointData", "CellData"):
                for name in ("rod", "element", "arc_length"):
                    del file[f"VTKHDF/{data}/{name}"], file[f"VTKHDF/Steps/{data}Offsets/{name}"]
        self.gxrod("export", "two.vtkhdf", "--csv", "tables", "--series", "series")
        self.gxrod("report", "two.vtkhdf")
        self.assertIn("two.vtkhdf: does not say where its rods are: an earlier version of gxrod wrote it",
                      self.gxrod("export", "two.vtkhdf", "--along", "arc", code=4).stderr)

    def run_with_stresses(self):
        self.write("frame.toml", FRAME + STRESS_HISTORY)
        self.gxrod("run", "frame.toml", "--quiet")

    def test_envelopes_are_those_of_the_file(self):
        self.run_with_stresses()
        self.assertEqual(self.gxrod("export", "frame.vtkhdf", "--envelopes", "tables").stdout, "tables/envelopes.csv\n")
        with open(self.folder / "tables/envelopes.csv", newline="") as file:
            names, *rows = csv.reader(file)
        table = dict(zip(names, zip(*rows)))
        with h5py.File(self.folder / "frame.vtkhdf") as file:
            envelopes = file["envelopes"]
            rods, sections = file["rods/name"].asstr()[()], file["sections/name"].asstr()[()]
            self.assertEqual(list(table["rod"]), list(rods[envelopes["rod"][()]]))
            self.assertEqual(list(table["section"]), ["" if number < 0 else sections[number] for number in envelopes["section"][()]])
            expected = {"element": envelopes["element"], "arc_length": envelopes["arc_length"]}
            for measure in ("von_mises", "exposure"):
                group = envelopes[measure]
                expected |= {measure: group["value"], f"{measure}_time": group["time"], f"{measure}_layer": group["layer"],
                             f"{measure}_y": group["point"][:, 0], f"{measure}_z": group["point"][:, 1]}
                expected |= {f"{measure}_{name}": group["resultants"][:, i] for i, name in enumerate(("N", "Vy", "Vz", "T", "My", "Mz"))}
            self.assertEqual(set(expected) | {"rod", "section"}, set(names))
            for name, values in expected.items():
                np.testing.assert_array_equal(np.array(table[name], dtype=float), values[()], name)
        done = self.gxrod("export", "frame.vtkhdf", "--envelopes", "tables", code=4)
        self.assertIn("envelopes.csv: exists already (--force overwrites it)", done.stderr)
        done = self.gxrod("export", "body.vtkhdf", "--envelopes", "tables", "--force", code=4)
        self.assertIn('body.vtkhdf: has no stresses (run it with stresses = "von-mises" in [output])', done.stderr)

    def test_stresses_along_a_rod_and_of_histories_have_columns(self):
        self.run_with_stresses()
        self.gxrod("export", "frame.vtkhdf", "--along", "beam", "--csv", "tables")
        table = read_columns(self.folder / "along_beam_elements.csv")
        history = read_columns(self.folder / "tables/history_foot.csv")
        with h5py.File(self.folder / "frame.vtkhdf") as file:
            cells = file["VTKHDF/CellData"]
            last = slice(-len(cells["rod"]), None)
            for name in ("von_mises", "exposure"):
                np.testing.assert_array_equal(table[name], cells[name][last][table["cell"].astype(int)])
            for name, labels in (("stress", ("xx", "yy", "zz", "yz", "xz", "xy")), ("principal_stress", "123"), ("stress_place", "yz")):
                columns = np.array([history[f"{name}_{label}"] for label in labels]).T
                np.testing.assert_array_equal(columns, file[f"histories/foot/{name}"][()])

    def test_a_full_disk_is_reported(self):
        for form, file in (("--csv", "ledger.csv"), ("--series", "body_0000.hdf")):
            done = self.gxrod("export", "body.vtkhdf", form, "full", code=4, preexec_fn=limit_file_size(5000))
            self.assertIn(f"full/{file}: cannot be written (File too large)", done.stderr)

    def test_what_cannot_be_exported(self):
        for name, said in (("none.vtkhdf", "there is no such file"), (".", "is a folder, not a results file"),
                           ("body.toml", "cannot be read as results of gxrod")):
            done = self.gxrod("export", name, "--csv", "tables", code=4)
            self.assertIn(said, done.stderr)
        with h5py.File(self.folder / "other.h5", "w") as file:
            file["x"] = 1.0
        done = self.gxrod("export", "other.h5", "--csv", "tables", code=4)
        self.assertIn("other.h5: is not a results file of gxrod", done.stderr)
        done = self.gxrod("export", "body.vtkhdf", "--csv", "body.toml", code=4)
        self.assertIn("body.toml: cannot be created", done.stderr)
        done = self.gxrod("export", "body.vtkhdf", "--series", "body.toml", code=4)
        self.assertIn("body.toml: cannot be created", done.stderr)
        (self.folder / "series/body_0000.hdf").mkdir(parents=True)
        done = self.gxrod("export", "body.vtkhdf", "--series", "series", "--force", code=4)
        self.assertIn("series/body_0000.hdf: is a folder (give the name of a file)", done.stderr)
        for option, name in (("--series", "body_0000.hdf"), ("--series", "body.hdf.series"), ("--csv", "ledger.csv")):
            folder = self.folder / name.replace(".", "_")
            folder.mkdir()
            (folder / name).symlink_to("none/none")
            done = self.gxrod("export", "body.vtkhdf", option, folder.name, code=4)
            self.assertIn(f"{folder.name}/{name}: cannot be written (No such file or directory)", done.stderr)
        done = self.gxrod("export", "body.vtkhdf", code=2)
        self.assertIn("give --csv DIR, --series DIR, --along ROD, --envelopes DIR, --ranges DIR, or several of them", done.stderr)


if __name__ == "__main__":
    unittest.main()
