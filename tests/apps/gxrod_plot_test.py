"""gxrod-plot as users call it: pictures, what is in them, and its errors."""

import os
import subprocess
import sys
import tempfile
import types
import unittest
import xml.etree.ElementTree
from pathlib import Path

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import image  # noqa: E402

PLOT = os.environ["GXROD_PLOT"]
TESTS = os.environ["GXROD_TESTS"]
sys.path.insert(0, str(Path(os.environ["GXROD_SOURCE"]) / "apps" / "python"))
sys.dont_write_bytecode = True

from forked import run_forked  # noqa: E402
from gxrod.plot import command, compare, histories, mechanism, results, shapes, style  # noqa: E402
from gxrod.plot.errors import UsageError  # noqa: E402


def write_sample(path, killed_at=None):
    """The spring and top of tests/results/plot_sample_test.cpp: 400 steps to t = 10, 101 frames."""
    environment = dict(os.environ, GXROD_PLOT_SAMPLE=str(path))
    if killed_at is not None:
        environment["GXROD_PLOT_SAMPLE_KILLED"] = str(killed_at)
    ended = subprocess.run([TESTS, "[.plot-sample]"], env=environment, capture_output=True, text=True,
                           check=False)
    if (ended.returncode == 0) != (killed_at is None):
        raise RuntimeError(ended.stdout + ended.stderr)


class PlotTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        cls.sample = cls.folder / "spring.vtkhdf"
        write_sample(cls.sample)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def run_program(self, *arguments, folder=None):
        environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1")
        return subprocess.run([PLOT, *map(str, arguments)], cwd=folder or self.folder, env=environment,
                              capture_output=True, text=True, check=False)

    def run_plot(self, *arguments):
        """What the program does once it has loaded its modules, which takes it a second."""
        return run_forked(command.main, arguments, self.folder)

    def draw(self, name, *arguments):
        """Draws the sample; gives the picture as numbers."""
        ended = self.run_plot(self.sample, *arguments, "-o", name)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertEqual(ended.stdout.strip(), name)
        return self.read_picture(self.folder / name)

    def read_picture(self, path):
        picture = image.imread(path)[..., :3]
        self.assertGreater(picture.var(), 1e-3, "the picture is blank")
        return picture

    def assert_fails(self, code, *arguments, says):
        ended = self.run_plot(*arguments)
        self.assertEqual(ended.returncode, code, ended.stderr)
        for part in says:
            self.assertIn(part, ended.stderr)
        self.assertNotIn("Traceback", ended.stderr)


class Pictures(PlotTest):
    def test_everything_by_default_named_after_the_results(self):
        with tempfile.TemporaryDirectory() as elsewhere:
            ended = self.run_program(self.sample, folder=elsewhere)
            self.assertEqual(ended.returncode, 0, ended.stderr)
            self.assertEqual(ended.stdout.strip(), "spring.png")
            picture = self.read_picture(Path(elsewhere) / "spring.png")
            self.assertGreater(picture.shape[0], 1500)

    def test_parts(self):
        for what in ("shapes", "histories", "ledger"):
            with self.subTest(what):
                self.draw(f"{what}.png", "--what", what)

    def test_shapes_have_the_colours_of_all_times(self):
        picture = self.draw("colours.png", "--what", "shapes", "--view", "3d", "--size", "8.4", "8.2")
        shapes_only = picture[:, : int(0.8 * picture.shape[1])]  # the colour bar is to the right
        for time in (0.0, 0.5, 1.0):
            colour = np.array(style.TIME_COLOURS(time)[:3])
            near = np.abs(shapes_only - colour).max(axis=-1) < 0.02
            self.assertGreater(near.sum(), 200, f"no line at {time} of the time")

    def test_views_differ(self):
        views = ("xy", "xz", "yz", "3d")
        pictures = [self.draw(f"{view}.png", "--what", "shapes", "--view", view) for view in views]
        for first, second in zip(pictures, pictures[1:]):
            self.assertTrue(first.shape != second.shape or (first != second).any())

    def test_times_and_number_of_frames(self):
        few = self.draw("few.png", "--what", "shapes", "--times", "0", "5")
        many = self.draw("many.png", "--what", "shapes", "--frames", "30")
        self.assertLess((few < 0.9).sum(), (many < 0.9).sum())

    def test_chosen_histories_are_fewer(self):
        one = self.draw("one.png", "--what", "histories", "--history", "tip/moment")
        all_of_them = self.draw("all.png", "--what", "histories")
        self.assertLess(one.shape[0], all_of_them.shape[0])

    def test_vector_pictures(self):
        for name, run in (("first.svg", self.run_plot), ("second.svg", self.run_program)):
            ended = run(self.sample, "-o", name)
            self.assertEqual(ended.returncode, 0, ended.stderr)
        root = xml.etree.ElementTree.parse(self.folder / "first.svg").getroot()
        self.assertGreater(len(list(root.iter("{http://www.w3.org/2000/svg}path"))), 100)
        # Equal results give equal pictures.
        self.assertEqual((self.folder / "first.svg").read_bytes(), (self.folder / "second.svg").read_bytes())

    def test_results_of_a_killed_job(self):
        killed = self.folder / "killed.vtkhdf"
        write_sample(killed, killed_at=150)
        ended = self.run_plot(killed)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.read_picture(self.folder / "killed.png")
        found = results.read_results(killed, lambda run: (run.status, len(run.times), run.frame_times[-1]))
        self.assertEqual(found, ("running", 150, 3.7))


    def run_column(self, name, end, force):
        """A clamped rod from the origin to `end` with a force at its end: statics of ten steps."""
        deck = self.folder / f"{name}.toml"
        deck.write_text(COLUMN.replace("END", end).replace("FORCE", force))
        subprocess.run([os.environ["GXROD"], "run", deck, "--quiet", "--force"], cwd=self.folder, check=True, capture_output=True)
        return self.folder / f"{name}.vtkhdf"

    def drawn_box(self, picture):
        """The part of a picture's width and height that the lines of shapes take, without the colour bar."""
        near = np.zeros(picture.shape[:2], dtype=bool)
        for time in np.linspace(0.0, 1.0, 40):
            near |= np.abs(picture - np.array(style.TIME_COLOURS(time)[:3])).max(axis=-1) < 0.02
        columns = np.flatnonzero(near.any(axis=0))
        gaps = np.flatnonzero(np.diff(columns) > 8)
        near[:, columns[gaps[-1] + 1]:] = False  # the colour bar is the last to the right
        rows, columns = np.nonzero(near)
        return np.ptp(columns) / picture.shape[1], np.ptp(rows) / picture.shape[0]

    def test_slender_columns_fill_their_pictures(self):
        for name, end, force in (("long", "[10, 0, 0]", "[-1, 0.05, 0]"), ("tall_in_space", "[0, 0, 10]", "[0.05, 0.02, -1]")):
            with self.subTest(name):
                path = self.run_column(name, end, force)
                self.assertEqual(self.run_plot(path, "--what", "shapes", "-o", f"{name}.png").returncode, 0)
                picture = self.read_picture(self.folder / f"{name}.png")
                wide, high = self.drawn_box(picture)
                self.assertGreater(max(wide, high), 0.6)
                # Inches of picture around what is drawn.
                other = picture.shape[1] * (1 - wide) if high > wide else picture.shape[0] * (1 - high)
                self.assertLess(other / 160, 4.0, "the picture is half blank")
        ended = self.run_plot(path, "-o", "all.png")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))

    def test_size_and_title(self):
        picture = self.draw("sized.png", "--what", "all", "--size", "9", "7")
        self.assertEqual(picture.shape[:2], (7 * 160, 9 * 160))
        titled = self.draw("titled.png", "--what", "ledger", "--title", "Energies of a spring and a top")
        bare = self.draw("bare.png", "--what", "ledger", "--no-title")
        plain = self.draw("plain.png", "--what", "ledger")
        self.assertLess(bare.shape[0], titled.shape[0])
        self.assertLess(titled.shape[0], plain.shape[0])  # without the facts of the run

    def test_several_files_in_one_figure(self):
        soft, hard = self.run_column("soft", "[0, 0, 10]", "[0.05, 0, -1]"), self.run_column("hard", "[0, 0, 10]", "[0.1, 0, -1]")
        for arguments in ((), ("--history", "top/displacement"), ("--what", "ledger"), ("--y", "top/displacement/x")):
            ended = self.run_plot(soft, hard, *arguments, "-o", "both.svg")
            self.assertEqual((ended.returncode, ended.stdout, ended.stderr), (0, "both.svg\n", ""))
            svg = (self.folder / "both.svg").read_text().lower()
            for colour in (style.BLUE, style.ORANGE):
                self.assertIn(colour, svg)

    def test_several_files_have_their_own_curves(self):
        soft, hard = self.run_column("soft", "[0, 0, 10]", "[0.05, 0, -1]"), self.run_column("hard", "[0, 0, 10]", "[0.1, 0, -1]")
        request = types.SimpleNamespace(x="top/displacement/x", y=["load-factor", "ledger/strain_energy"], what="all", history=[],
                                        title=None, size=None)
        runs = [results.read_results(path, lambda file, path=path: compare.read_run(file, request, path.stem)) for path in (soft, hard)]
        figure = compare.draw_runs(runs, request)
        panels = figure.axes
        self.assertEqual([axes.get_title("left") for axes in panels], ["load factor", "strain energy"])
        self.assertEqual(panels[0].get_xlabel(), "top: displacement x (length)")
        for axes, name in zip(panels, ("histories/time", "ledger/strain_energy")):
            for path, line in zip((soft, hard), axes.get_lines()):
                with h5py.File(path) as file:
                    np.testing.assert_array_equal(line.get_xdata(), file["histories/top/displacement"][:, 0])
                    np.testing.assert_array_equal(line.get_ydata(), file[name][()])

    def test_one_quantity_against_another(self):
        path = self.run_column("soft", "[0, 0, 10]", "[0.05, 0, -1]")
        ended = self.run_plot(path, "--x", "top/displacement/magnitude", "-o", "curve.png")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        self.read_picture(self.folder / "curve.png")
        ended = self.run_plot(path, "--y", "top/displacement", "ledger/external_work", "-o", "curves.png")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))


COLUMN = """[section.s]
stiffness = { EA = 1e6, GAy = 5e5, GAz = 5e5, GJ = 100, EIy = 100, EIz = 100 }
[rod.c]
section = "s"
line = { from = [0, 0, 0], to = END }
elements = 10
[[support]]
at = "c.start"
fix = "all"
[[load]]
at = "c.end"
force = FORCE
[analysis]
kind = "static"
steps = 10
[[history]]
name = "top"
at = "c.end"
quantities = ["displacement"]
"""


class Modules(PlotTest):
    def test_what_is_missing_is_reported_in_plain_words(self):
        for module in ("h5py", "numpy", "matplotlib"):
            (self.folder / "without").mkdir(exist_ok=True)
            fake = self.folder / "without" / f"{module}.py"
            fake.write_text(f"raise ModuleNotFoundError('none', name='{module}')\n")
            environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1", PYTHONPATH=str(fake.parent),
                               GXROD_PLOT_PYTHON="/opt/python")
            ended = subprocess.run([sys.executable, PLOT, self.sample], cwd=self.folder, env=environment,
                                   capture_output=True, text=True, check=False)
            fake.unlink()
            self.assertEqual((ended.returncode, ended.stdout), (1, ""))
            self.assertTrue(ended.stderr.startswith(
                f"gxrod-plot needs the Python module {module}; it is not installed for /opt/python and {sys.executable}.\n"))
            self.assertIn("python3 -m pip install h5py numpy matplotlib", ended.stderr)

    def test_the_python_of_the_path_runs_it(self):
        with open(PLOT, encoding="utf-8") as program:
            self.assertEqual(program.readline(), "#!/usr/bin/env python3\n")


class Errors(PlotTest):
    def test_columns_that_are_not_there(self):
        for arguments, said in ((("--x", "tip"), "'tip': expected time, ledger/ENERGY or NAME/QUANTITY/COMPONENT"),
                                (("--x", "tip/moment"), "--x tip/moment: give one component, as tip/moment/x"),
                                (("--x", "tip/moment/q"), "'moment' has no component 'q'; it has x, y, z, magnitude"),
                                (("--y", "tap/moment/x"), "there is no history 'tap'"),
                                (("--y", "ledger/heat"), "the ledger has no 'heat'"),
                                (("--y", "ledger/kinetic_energy/x"), "is one number, without a component 'x'"),
                                (("--x", "tip/moment/x", "--what", "shapes"), "shapes need one file"),
                                (("--size", "0", "4"), "from 0.5 to 100 inches"),
                                (("--title", "a", "--no-title"), "not allowed with")):
            self.assert_fails(2, self.sample, *arguments, says=[said])
        self.assert_fails(2, self.sample, self.sample, "--times", "1", says=["shapes need one file"])

    def test_results_that_are_not_there(self):
        self.assert_fails(4, "none.vtkhdf", says=["none.vtkhdf", "no such file"])
        ended = self.run_program("none.vtkhdf")
        self.assertEqual((ended.returncode, ended.stdout), (4, ""))
        self.assertIn("no such file", ended.stderr)
        self.assert_fails(4, self.folder, says=["is a folder"])

    def test_files_that_are_no_results(self):
        text = self.folder / "text.vtkhdf"
        text.write_text("not HDF5")
        self.assert_fails(4, text, says=["text.vtkhdf", "cannot be read"])
        with h5py.File(self.folder / "other.h5", "w") as other:
            other["x"] = 1.0
        self.assert_fails(4, self.folder / "other.h5", says=["not a results file of gxrod"])

    def test_results_without_a_step(self):
        killed = self.folder / "early.vtkhdf"
        write_sample(killed, killed_at=0)
        self.assert_fails(4, killed, says=["no complete step"])

    def test_stresses_that_are_not_there(self):
        for what in ("stress", "section"):
            self.assert_fails(4, self.sample, "--what", what, says=["has no stresses", "[output]"])
        self.assert_fails(2, self.sample, self.sample, "--what", "stress", says=["stress needs one file"])

    def test_unknown_histories(self):
        self.assert_fails(2, self.sample, "--history", "tap", says=["'tap'", "tip, top"])
        self.assert_fails(2, self.sample, "--history", "tip/force",
                          says=["'force'", "displacement, moment, velocity"])

    def test_times_and_frames_that_are_not_there(self):
        self.assert_fails(2, self.sample, "--times", "11", says=["11", "from 0 to 10"])
        self.assert_fails(2, self.sample, "--frames", "0", says=["at least 1"])

    def test_pictures_that_cannot_be_written(self):
        self.assert_fails(4, self.sample, "--what", "ledger", "-o", "missing/a.png", says=["missing/a.png"])
        self.assert_fails(2, self.sample, "-o", "a.doc", says=["a.doc", ".png"])

    def test_usage(self):
        self.assert_fails(2, says=["usage"])
        self.assert_fails(2, self.sample, "--figures", ".", says=["usage"])
        self.assert_fails(2, self.sample, "--what", "nothing", says=["nothing"])


class Figures(PlotTest):
    SCHEMES = ("S", "I", "RK4", "SDIRK4", "RADAU5", "GAUSS4")

    def write_data(self, folder):
        tau = np.linspace(0.0, 1.0, 201)
        angle = np.pi * np.abs(np.sin(5.0 * tau)) + 0.01
        rows = [f"{t},{a},{0.1 * a},{0.2 * a},{0.97 * a}" for t, a in zip(tau, angle)]
        (folder / "fig2.csv").write_text("\n".join(["tau,angle,phi_1,phi_2,phi_3", *rows]))
        rows = [f"{scheme},400,{t},{1e-3 * t},{1e-4 * t},{1e-5 * t}" for scheme in self.SCHEMES for t in tau]
        (folder / "fig3.csv").write_text(
            "\n".join(["scheme,steps,tau,error_orientation,error_momentum,error_energy", *rows]))
        rows = [f"{scheme},{n},{4000 / n},{1 / n},{2 / n},{3 / n}" for scheme in self.SCHEMES
                for n in (50, 100, 200)]
        rows += ["RK4,400,,0.01,0.01,0.01", "RK4,25,,,,"]
        (folder / "fig4.csv").write_text(
            "\n".join(["scheme,steps,max_theta_deg,error_orientation,error_momentum,error_energy", *rows]))

    def test_all_three(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            self.write_data(folder)
            ended = self.run_plot("--figures", folder)
            self.assertEqual(ended.returncode, 0, ended.stderr)
            for figure in ("fig2", "fig3", "fig4"):
                self.read_picture(folder / f"{figure}.png")
            ended = self.run_plot("--figures", folder, "--format", "svg")
            self.assertEqual(ended.returncode, 0, ended.stderr)
            self.assertEqual(len(list(folder.glob("*.svg"))), 3)

    def test_missing_and_faulty_data(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            self.assert_fails(4, "--figures", folder, says=["fig2.csv", "gxrod verify rubin2007"])
            self.write_data(folder)
            (folder / "fig3.csv").write_text("scheme,steps\nS,400\n")
            self.assert_fails(4, "--figures", folder, says=["fig3.csv", "no column", "tau"])
            self.write_data(folder)
            (folder / "fig2.csv").write_text("tau,angle,phi_1,phi_2,phi_3\n0,x,0,0,0\n")
            self.assert_fails(4, "--figures", folder, says=["fig2.csv", "not a number"])


class Parts(PlotTest):
    """What the pictures are made of."""

    def test_shapes_are_the_points_of_their_frames(self):
        with h5py.File(self.sample) as file:
            points = file["VTKHDF/Points"][()].reshape(101, 62, 3)
            axis_z = file["VTKHDF/PointData/axis_z"][()].reshape(101, 62, 3)

        def check(file):
            frames = shapes.choose_frames(file, times=[0.0, 5.02, 10.0])
            self.assertEqual(frames, [0, 50, 100])
            scene = shapes.make_scene(file, frames)
            self.assertEqual([time for _, time in scene.shapes], [0.0, 5.0, 10.0])
            for (shape, _), frame in zip(scene.shapes, frames):
                np.testing.assert_array_equal(shape, points[frame, :61])
            # The top turns on the spot: its axes once, at the end, and the path of the z axis.
            [(origin, axes)] = scene.triads
            np.testing.assert_array_equal(origin, points[100, 61])
            size = np.linalg.norm(axes["z"] - origin)
            np.testing.assert_allclose(axes["z"], origin + size * axis_z[100, 61])
            np.testing.assert_array_equal(scene.traces[0][0], points[:, 61])
            np.testing.assert_allclose(scene.traces[1][0], origin + size * axis_z[:, 61])
            self.assertEqual(shapes.best_view(scene), "3d")
        results.read_results(self.sample, check)

    def test_the_last_frame_is_always_drawn(self):
        def check(file):
            for count in (1, 2, 7):
                frames = shapes.choose_frames(file, count=count)
                self.assertEqual(len(frames), count)
                self.assertEqual(frames[-1], 100)
        results.read_results(self.sample, check)

    def test_flat_scenes_are_seen_from_above(self):
        line = np.array([[0.0, 1.0, 0.0], [2.0, 1.0, 5.0]])
        self.assertEqual(shapes.best_view(shapes.Scene([(line, 0.0)], [], [])), "xz")

    def test_cells_of_higher_order_are_put_in_order(self):
        path = self.folder / "quadratic.vtkhdf"
        with h5py.File(self.sample) as source, h5py.File(path, "w") as copy:
            for name in source.attrs:
                copy.attrs[name] = source.attrs[name]
            for name in source:
                source.copy(name, copy)
            for name, values in (("Connectivity", [0, 2, 1, 2, 4, 3, 5, 6, 61]), ("Offsets", [0, 3, 6, 8, 9]),
                                 ("Types", [21, 21, 3, 1])):
                del copy["VTKHDF"][name]
                copy["VTKHDF"][name] = values
        rods, bodies = results.read_results(path, lambda file: (file.rods, file.bodies))
        self.assertEqual([list(rod) for rod in rods], [[0, 1, 2, 3, 4], [5, 6]])
        self.assertEqual(bodies, [61])

    def test_histories_are_chosen_by_name(self):
        def check(file):
            chosen = results.choose_histories(file, ["top", "tip/moment"])
            self.assertEqual([history.name for history in chosen], ["top", "tip"])
            self.assertEqual([series.name for series in chosen[1].quantities], ["moment"])
            with self.assertRaises(UsageError):
                results.choose_histories(file, ["bottom"])
        results.read_results(self.sample, check)

    def test_rotation_vectors_are_parted_where_they_jump(self):
        times = np.arange(4.0)
        values = np.array([[3.0, 0, 0], [3.1, 0, 0], [-3.1, 0, 0], [-3.0, 0, 0]])
        broken_times, broken = histories.break_at_jumps(times, values)
        np.testing.assert_array_equal(np.isnan(broken_times), [False, False, True, False, False])
        self.assertTrue(np.isnan(broken[2]).all())

    def test_titles_say_the_axes_unless_they_are_global(self):
        def title(name, frame):
            return histories.describe_frame(types.SimpleNamespace(name=name, frame=frame))
        self.assertEqual(title("position", "spatial"), "")
        self.assertEqual(title("moment", "material"), ", material")
        self.assertEqual(title("angular_velocity_material", "material"), "")
        self.assertEqual(title("position", "axes of arm.start"), ", axes of arm.start")

    def test_long_curves_keep_their_extremes(self):
        times = np.arange(100000.0)
        values = np.sin(times)
        values[31416] = 7.0
        values[62832] = -7.0
        thin_times, thin_values = style.thin(times, values)
        self.assertLessEqual(len(thin_values), style.MOST_POINTS + 2)
        self.assertEqual((thin_values.max(), thin_values.min()), (7.0, -7.0))
        self.assertEqual((thin_times[0], thin_times[-1]), (0.0, 99999.0))


class Mechanisms(unittest.TestCase):
    """A crank, point 0, on a hinge on the ground and with a ball that joins it to point 1; quarter turns about z."""

    def setUp(self):
        joints = mechanism.Ends(["shaft", "pin", "guide", "bar"], ["hinge", "ball", "slider", "distance"],
                                (np.array([-1, 0, 1, 0]), np.array([0, 1, -1, 1])),
                                (np.array([[0.0, 0, 0], [2, 0, 0], [0, 0, 0], [1, 0, 0]]),
                                 np.array([[0.0, 0, 0], [-3, 0, 0], [5, 0, 0], [0, 0, 0]])),
                                (np.array([[0.0, 0, 1], [1, 0, 0], [1, 0, 0], [1, 0, 0]]),) * 2)
        springs = mechanism.Ends(["cord"], [], (np.array([-1]), np.array([1])), (np.array([[5.0, 4, 0]]), np.array([[0.0, 1, 0]])))
        bushings = mechanism.Ends(["mount"], [], (np.array([0]), np.array([1])), (np.array([[1.0, 0, 0]]), np.zeros((1, 3))))
        tables = {"joints": joints, "springs": springs, "bushings": bushings}
        quarter = np.pi / 2
        frames = [(np.array([[0.0, 0, 0], [5, 0, 0]]), np.zeros((2, 3))),
                  (np.array([[0.0, 0, 0], [0, 5, 0]]), np.array([[0, 0, quarter], [0, 0, quarter]]))]
        self.results = types.SimpleNamespace(
            ends=tables.get, frame_times=np.array([0.0, 1.0]),
            frame=lambda index, field="Points": frames[index][1 if field == "rotation_vector" else 0])
        self.made = mechanism.make_mechanism(self.results, [0, 1], 0.4)

    def test_links_go_from_points_to_joints_in_every_frame(self):
        links = [(line.round(12).tolist(), time) for line, time in self.made.links]
        self.assertEqual(len(links), 6)
        for line in ([[0, 0, 0], [2, 0, 0]], [[5, 0, 0], [2, 0, 0]]):
            self.assertIn((line, 0.0), links)
        for line in ([[0, 0, 0], [0, 2, 0]], [[0, 5, 0], [0, 2, 0]]):
            self.assertIn((line, 1.0), links)

    def test_joints_are_drawn_where_they_are_in_the_last_frame(self):
        marks = [(kind, place.round(12).tolist(), colour) for kind, place, colour in self.made.marks]
        self.assertEqual(marks[0], ("hinge", [0, 0, 0], style.GREY))
        self.assertEqual(marks[1], ("ball", [0, 2, 0], mechanism.JOINT))
        self.assertEqual(marks[2], ("slider", [0, 5, 0], style.GREY))
        self.assertEqual([mark[:2] for mark in marks[3:]], [("distance", [0, 1, 0]), ("distance", [0, 5, 0])])
        np.testing.assert_allclose(self.made.bars, [[[0, 1, 0], [0, 5, 0]]], atol=1e-12)
        lines = [line.round(12).tolist() for line, _ in self.made.axes]
        # The slider's axis is carried by point 1, which has turned.
        self.assertEqual(lines, [[[0, 0, -0.2], [0, 0, 0.2]], [[0, 4.8, 0], [0, 5.2, 0]]])

    def test_springs_zigzag_between_their_points(self):
        [line] = self.made.coils
        np.testing.assert_allclose(line[[0, -1]], [[5, 4, 0], [-1, 5, 0]], atol=1e-12)
        np.testing.assert_allclose(self.made.anchors, [[5, 4, 0]])
        along = np.array([-6, 1, 0]) / np.sqrt(37)
        off = line - line[0] - np.outer((line - line[0]) @ along, along)
        self.assertAlmostEqual(np.linalg.norm(off, axis=1).max(), 0.12 * 0.4)
        self.assertEqual((np.diff(np.sign(off[2:-2] @ [along[1], -along[0], 0])) != 0).sum(), len(off) - 5)
        np.testing.assert_allclose(self.made.boxes, [[0, 3, 0]], atol=1e-12)

    def test_zigzags_are_drawn_along_any_direction_and_without_length(self):
        for end in ([0, 0, 3.0], [0, 0, 0.0]):
            line = mechanism.coil(np.zeros(3), np.array(end), 0.1)
            self.assertTrue(np.isfinite(line).all())
            np.testing.assert_allclose(line[-1], end)

    def test_signs_are_explained(self):
        self.assertEqual(mechanism.describe(self.made),
                         "○ hinge, ● ball, ■ slider, • distance, zigzag: spring, ochre ■ bushing, grey: on the ground")
        self.assertEqual(mechanism.describe(mechanism.Mechanism()), "")

    def test_joints_histories_have_a_readers_order_and_names(self):
        group = dict.fromkeys(["angle", "drive", "force", "force_a", "gap", "moment", "slide"])
        self.assertEqual(results.list_quantities(group), ["angle", "slide", "drive", "force", "moment", "force_a", "gap"])
        self.assertEqual(results.list_quantities(dict.fromkeys(["curvature", "force"])), ["curvature", "force"])
        self.assertEqual(histories.words("force_a"), "force")
        named = types.SimpleNamespace(name="force_a", frame="joint axes of A")
        self.assertEqual(histories.describe_frame(named), ", joint axes")

    def test_pictures_of_results_have_them(self):
        """From the program to the picture, in colours that nothing else has."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "a.toml").write_text(MECHANISM)
            subprocess.run([os.environ["GXROD"], "run", "a.toml", "--quiet"], cwd=folder, check=True, capture_output=True)
            made = results.read_results(folder / "a.vtkhdf", lambda file: mechanism.make_mechanism(file, [0, 5], 0.1))
            np.testing.assert_allclose([place for _, place, _ in made.marks], [[0, 0, 0]], atol=1e-12)
            [(line, _), *_] = made.links
            np.testing.assert_allclose(line, [[0.3, 0, 0], [0, 0, 0]])
            for view in ("3d", "xy"):
                subprocess.run([PLOT, "a.vtkhdf", "--what", "shapes", "--view", view, "-o", "a.png"], cwd=folder, check=True,
                               capture_output=True, env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1"))
                pixels = (255 * image.imread(folder / "a.png")[..., :3]).round().astype(int)
                ochre = [int(mechanism.SPRING[i : i + 2], 16) for i in (1, 3, 5)]
                self.assertGreater((np.abs(pixels - ochre).max(axis=2) < 12).sum(), 100)


# A pendulum on a hinge, held by a spring.
MECHANISM = """[body.bob]
mass = 1
inertia = [0.1, 0.1, 0.1]
at = [0.3, 0, 0]
[joint.pivot]
type = "hinge"
between = ["ground", "bob"]
at = [0, 0, 0]
axis = [0, 0, 1]
[spring.cord]
between = ["ground", "bob"]
at_a = [0.3, 0.4, 0]
stiffness = 3
length = 0.2
[analysis]
kind = "dynamic"
end_time = 0.5
time_step = 0.1
"""

del PlotTest  # not a test itself

if __name__ == "__main__":
    unittest.main()
