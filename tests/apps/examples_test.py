"""Every example deck and batch runs, by the commands that its page states, and leaves what the page says."""

import csv
import math
import os
import unittest

import h5py
import numpy as np

from program import SOURCE, ProgramTest, commands_of

EXAMPLES = SOURCE / "docs" / "examples"
SOME = ("arch", "beck", "bricard", "fast_top", "roll_up")


class Pages(ProgramTest):
    """Pages of examples, by the commands that they state."""

    def run_page(self, name):
        page = EXAMPLES / name / "README.md"
        commands = commands_of(page)
        self.assertTrue(commands, f"{page} states no command")
        for command in commands:
            self.run_command(command, timeout=900)

    def open(self, name):
        return h5py.File(self.folder / f"{name}.vtkhdf")

    def check_pages(self, names):
        for name in names:
            with self.subTest(name):
                self.run_page(name)
                with self.open(name) as file:
                    self.assertEqual(file.attrs["status"], "complete")
                    for group in ("ledger", "histories"):
                        file[group].visititems(
                            lambda path, item: self.assertTrue(
                                not isinstance(item, h5py.Dataset) or np.isfinite(item[:]).all(), path))
                    self.check_statements(name, file)
                self.assertGreater((self.folder / f"{name}.png").stat().st_size, 20000)

    def check_statements(self, name, file):
        """What a page says in numbers, beyond what `gxrod verify` compares."""
        check = {"arch": self.check_arch, "lee_frame": self.check_lee_frame, "fast_top": self.check_fast_top,
                 "symmetric_top": self.check_symmetric_top}.get(name)
        if check:
            check(file)

    def check_arch(self, file):
        crown, load = (file[f"histories/crown/{name}"][:] for name in ("displacement", "reaction_force"))
        self.assertAlmostEqual(crown[-1, 0], -61.14, delta=0.005)
        self.assertAlmostEqual(load[-1, 1], -897.29, delta=0.005)
        deck = "docs/examples/arch/arch.toml"
        self.run_command(f"gxrod run {deck} --quiet --set parameters.down=118 -o beyond.vtkhdf")
        with self.open("beyond") as beyond:
            self.assertGreater(beyond["histories/crown/reaction_force"][-1, 1], -890.0)

    def check_lee_frame(self, file):
        load = -file["histories/loaded/reaction_force"][:, 1]
        self.assertAlmostEqual(load[-1], 1.8557, delta=5e-5)
        grown = np.diff(load)
        self.assertLess(grown[-1], 0.03 * grown[0])

    def check_fast_top(self, file):
        axis = file["histories/top/centre_of_mass"][:]
        round_about = np.unwrap(np.arctan2(axis[:, 1], axis[:, 0]))
        self.assertAlmostEqual(round_about[-1] - round_about[0], 4.20, delta=0.005)
        height = axis[:, 2]
        low = (height[1:-1] < height[:-2]) & (height[1:-1] <= height[2:])
        self.assertEqual(low.sum(), 15)
        np.testing.assert_allclose([height.min(), height.max()], [0.9471, 0.9553], atol=5e-5)
        self.assertLess(np.abs(file["ledger/energy_error"][:]).max(), 3e-8)

    def check_symmetric_top(self, file):
        self.assertLess(np.abs(file["ledger/energy_error"][:]).max(), 1e-11)
        momentum = np.linalg.norm(file["ledger/angular_momentum"][:] - 0.5, axis=1)
        self.assertAlmostEqual(momentum.max(), 1e-5, delta=5e-7)


class Examples(Pages):
    def read_batch(self, name):
        """The rows of a batch, numbers as numbers."""
        with open(self.folder / name / "index.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))

        def read(text):
            try:
                return float(text)
            except ValueError:
                return text

        return [{key: read(text) for key, text in row.items()} for row in rows]

    def test_each_example_has_deck_page_and_picture(self):
        folders = [path for path in EXAMPLES.iterdir() if path.is_dir() and path.name != "python"]  # tests/python has those
        self.assertGreaterEqual(len(folders), 30)
        for folder in folders:
            for file in (f"{folder.name}.toml", "README.md", f"{folder.name}.png"):
                self.assertTrue((folder / file).exists(), folder / file)
            # What an example gives is checked here, or by `gxrod verify` against its reference.
            self.assertTrue(
                hasattr(self, f"test_{folder.name}") or (folder / "reference.toml").exists(), folder)

    def test_the_front_page(self):
        commands = commands_of(SOURCE / "README.md")
        self.assertEqual(len(commands), 1)
        for command in commands:
            self.assertIn("10 of 10 cases done", self.run_command(command).stdout)
    @unittest.skipIf(os.environ.get("GXROD_SANITIZED") == "1", "takes minutes under sanitizers; Release runs it")
    def test_some_pages(self):
        """Of each kind of analysis one; example_pages_test.py has all."""
        self.check_pages(SOME)

    def test_free_flight(self):
        self.run_page("free_flight")
        with self.open("free_flight") as file:
            times = file["histories/time"][:]
            at = np.searchsorted(times, 5.0 - 1e-9)
            tip = file["histories/loaded_end/position"][at]
            # 20 elements: the mesh's own error, which verify free_flight shows to fall at order 2.
            np.testing.assert_allclose(tip, [19.21360, 1.62556, -2.12724], atol=0.03)
            np.testing.assert_allclose(file["ledger/linear_momentum"][-1], [50, 0, 0], atol=1e-6)
            error = np.abs(file["ledger/energy_error"][:]).max()
            self.assertLess(error, 0.1)
        self.assertGreater((self.folder / "free_flight.png").stat().st_size, 20000)

    def test_blade(self):
        self.run_page("blade")
        with self.open("blade") as file:
            # The same blade, from the matrices of a HAWC2 file.
            np.testing.assert_allclose(file["stages/tones/frequency"][:2], [0.5054, 0.6939], rtol=3e-3)
            # All of its weight, 66997 kg, at the root; it moves flapwise under it.
            self.assertAlmostEqual(abs(file["histories/root/force_spatial"][-1, 0]), 66996.9 * 9.81, delta=50.0)
            self.assertGreater(file["histories/tip/displacement"][-1, 0], 2.0)

    def test_rubin2007(self):
        self.run_page("rubin2007")
        with self.open("rubin2007") as file:
            momentum = file["ledger/angular_momentum"][:]
            exact = np.outer(6.0 * (1.0 - np.cos(file["histories/time"][:])), [0, 0, 1])
            error = np.linalg.norm(momentum - exact, axis=1).max() / 12.0
            self.assertAlmostEqual(error, 0.000550161, delta=5e-9)

    def test_heavy_top(self):
        self.run_page("heavy_top")
        with self.open("heavy_top") as file:
            at = np.searchsorted(file["histories/time"][:], 0.2 - 1e-9)
            x = file["histories/top/centre_of_mass"][at]
        error = np.linalg.norm(x - [0.605550561377, 0.598957681795, -0.523983027430])
        self.assertAlmostEqual(error, 2.40e-4, delta=0.01 * 2.40e-4)

    def test_dzhanibekov(self):
        self.run_page("dzhanibekov")
        with self.open("dzhanibekov") as file:
            at = np.searchsorted(file["histories/time"][:], 10.0 - 1e-9)
            spin = file["histories/nut/angular_velocity_material"][at]
        np.testing.assert_allclose(spin, [10.94623977013, 4.42844730509, 9.47985357634], atol=5e-6)

    def test_chain_under_raos(self):
        """Against its motion and catenary by hand: chain_under_raos_test.py."""
        self.run_page("chain_under_raos")

    def test_hall(self):
        """Against a stiffness matrix: hall_test.py."""
        self.run_page("hall")
        with self.open("hall") as file:
            np.testing.assert_allclose(file["histories/ridge/displacement"][-1], [0.02058, 0.00021, -0.02616], atol=5e-6)

    def test_stick_slip(self):
        """Against the exact motion, by DOP853: it sticks until 0.5 m g, slides, and sticks again."""
        self.run_page("stick_slip")
        exact = {0.25: 0.0235046373, 0.5: 0.0485046373, 0.75: 0.0334346100, 1.0: 0.0084406820, 1.25: 0.0334406820, 1.5: 0.0565453576,
                 1.75: 0.0090652738, 2.0: 0.0183767267, 2.25: 0.0433767267, 2.5: 0.0461215279, 2.75: 0.0033243481, 3.0: 0.0283127714}
        with self.open("stick_slip") as file:
            time, place = file["histories/time"][:], file["histories/block/displacement"][:, 0]
            np.testing.assert_allclose(np.interp(list(exact), time, place), list(exact.values()), atol=2e-5)
            friction = -file["histories/belt/contact_friction"][:, 0]
            self.assertAlmostEqual(friction[time > 0.1].max(), 4.905, delta=0.01)
            self.assertAlmostEqual(np.median(friction[(time > 0.7) & (time < 0.85)]), 2.943, delta=0.003)

    def test_snake(self):
        """Against planar_snake.py: head and tail after each wave."""
        self.run_page("snake")
        with self.open("snake") as file:
            time = file["histories/time"][:]
            for name, exact in (("head", [[0.93913, -0.16609], [1.17053, -0.17554], [1.42653, -0.18144], [1.68401, -0.18712]]),
                                ("tail", [[0.21661, -0.15552], [0.45768, -0.16263], [0.71371, -0.16741], [0.97119, -0.17283]])):
                place = file[f"histories/{name}/position"][:]
                found = [[np.interp(t, time, place[:, k]) for k in (0, 1)] for t in (1, 2, 3, 4)]
                np.testing.assert_allclose(found, exact, atol=6e-3)

    def test_guidewire(self):
        """Its first 20 mm."""
        deck = "docs/examples/guidewire/guidewire.toml"
        self.run_command(f"gxrod run {deck} --quiet --set analysis.steps=20 --set support[0].move.x=0.02*t "
                         "-o guidewire.vtkhdf")
        with self.open("guidewire") as file:
            hand, vessel = (file[f"histories/{name}"][:] for name in ("hand/reaction_force", "vessel/contact_force"))
            self.assertGreater(hand[-1, 0], 0.1)
            np.testing.assert_allclose(hand, vessel, atol=1e-5 * hand[-1, 0])
            touching = file["solver/contacts"][:] > 0
            self.assertGreater(touching.sum(), 3)
            self.assertGreater(file["solver/least_gap"][:][touching].min(), 0.0)
            tip = 1e3 * file["histories/tip/position"][-1]
            # Of its first bend, from (0, 0) about (0, 30); the bore is 4, the wire 0.9.
            self.assertLess(abs(np.hypot(tip[0], tip[1] - 30.0) - 30.0), 2.0 - 0.45)

    def test_pile(self):
        """Its first 0.13 s, in which the two lowest layers land; tests/scenes/pile runs all of it."""
        self.run_command("gxrod run docs/examples/pile/pile.toml --quiet --set analysis.end_time=0.13 -o pile.vtkhdf")
        with self.open("pile") as file:
            solver = file["solver"]
            self.assertGreater(solver["contacts"][:].max(), 50)
            self.assertGreater(solver["least_gap"][:][solver["contacts"][:] > 0].min(), 0.0)
            self.assertLess(solver["rejected_steps"][:].sum(), 10)
            self.assertGreater(file["VTKHDF/Points"][:, 2].min(), 5e-3)
            loss, work = (file[f"ledger/{name}"][:] for name in ("contact_loss", "external_work"))
            self.assertGreater(np.diff(loss).min(), -1e-3 * work[-1])
            self.assertGreater(loss[-1], 0.0)

    def test_knot(self):
        """Its first 0.2 s, in which the loop springs open and touches itself."""
        self.run_command("gxrod run docs/examples/knot/knot.toml --quiet --set analysis.end_time=0.2 -o knot.vtkhdf")
        with self.open("knot") as file:
            solver = file["solver"]
            touching = solver["contacts"][:] > 0
            self.assertGreater(touching[-1], 0)
            self.assertGreater(solver["least_gap"][:][touching].min(), 0.0)
            self.assertLess(solver["rejected_steps"][:].sum(), 25)
            strain = file["ledger/strain_energy"][:]
            self.assertLess(strain[-1], strain[0])
            self.assertLess(np.abs(file["ledger/energy_error"][-1]), 0.05 * strain[0])

    def test_rubin_convergence(self):
        self.run_page("rubin_convergence")
        rows = self.read_batch("rubin_convergence")
        self.assertEqual(len(rows), 10)
        for integrator in ("newmark-simplified", "newmark-ibrahimbegovic"):
            for column in ("momentum", "energy", "orientation"):
                with self.subTest(integrator=integrator, column=column):
                    errors = [row[column] for row in rows if row["analysis.integrator"] == integrator]
                    self.assertEqual(len(errors), 5)
                    self.assertAlmostEqual(errors[3] / errors[4], 4.0, delta=0.07)
        # What `gxrod verify rubin2007` has from an independent program: E_T, which is largest near t = pi.
        self.assertAlmostEqual(rows[7]["energy"] / 78.0, 2.25e-4, delta=1e-6)
        # The references are where a scheme of order 4 goes.
        deck = "docs/examples/rubin2007/rubin2007.toml"
        self.run_command(f"gxrod run {deck} --quiet --set analysis.integrator=sdirk-4")
        with self.open("rubin2007") as file:
            middle = np.searchsorted(file["ledger/time"][:], np.pi - 1e-9)
            self.assertAlmostEqual(file["ledger/angular_momentum"][middle, 2], 12.0, delta=1e-5)
            self.assertAlmostEqual(file["ledger/kinetic_energy"][middle], 78.0, delta=1e-4)
            turned = file["histories/top/rotation_vector"][-1]
        np.testing.assert_allclose(turned, [0.0, np.pi / 3, 0.0], atol=1e-5)

    @unittest.skipIf(os.environ.get("GXROD_SANITIZED") == "1", "takes most of a minute under sanitizers; Release runs it")
    def test_free_flight_grid(self):
        self.run_page("free_flight_grid")
        rows = self.read_batch("free_flight_grid")
        peaks = [50.0, 100.0, 150.0, 200.0, 250.0]
        self.assertEqual([(row["parameters.EI"], row["parameters.peak"]) for row in rows],
                         [(stiffness, peak) for stiffness in (125.0, 500.0, 2000.0) for peak in peaks])
        for row in rows:
            self.assertEqual(row["status"], "done")
            self.assertAlmostEqual(row["momentum"], row["parameters.peak"] / 4, delta=1e-9)
            self.assertLess(row["energy_error"], 2e-3 * row["work"])
        soft, middle, stiff = rows[:5], rows[5:10], rows[10:]
        for peak, *grades in zip(peaks, soft, middle, stiff):
            work = [row["work"] for row in grades]
            self.assertEqual(work, sorted(work, reverse=True))
            rigid = self.work_on_rigid_rod(peak)
            self.assertAlmostEqual(work[2] / rigid, 1.0, delta=0.021)
            self.assertTrue(2.35 < work[0] / rigid < 3.15, work[0] / rigid)
        # One case is the deck as it is, and its results are those of a run.
        self.run_command("gxrod run docs/examples/free_flight/free_flight.toml --quiet")
        with self.open("free_flight") as run, self.open("free_flight_grid/cases/0009") as kept:
            np.testing.assert_array_equal(run["ledger/external_work"][:], kept["ledger/external_work"][:])
            self.assertEqual(run["ledger/external_work"][-1], middle[3]["work"])
            self.assertEqual(run["ledger/strain_energy"][:].max(), middle[3]["bending"])

    @staticmethod
    def work_on_rigid_rod(peak):
        """Kinetic energy of a rigid rod after the load of free_flight, by the classical Runge-Kutta method."""
        mass, about_axis, across = 10.0, 200.0, 100.0 + 1000.0 / 12.0
        axis = np.array([-0.6, 0.8, 0.0])  # from the loaded end to the other

        def rates(time, state):
            axis, momentum = state
            pulse = peak * max(0.0, 1.0 - abs(time - 2.5) / 2.5)
            torque = np.cross(-5.0 * axis, [pulse / 10, 0, 0]) + [0, -pulse / 2, -pulse]
            return np.array([np.cross(momentum, axis) / across, torque])

        state, step = np.array([axis, np.zeros(3)]), 0.02
        for time in np.arange(0.0, 5.0 - 1e-9, step):
            first = rates(time, state)
            second = rates(time + step / 2, state + step / 2 * first)
            third = rates(time + step / 2, state + step / 2 * second)
            state = state + step / 6 * (first + 2 * second + 2 * third + rates(time + step, state + step * third))
        axis, momentum = state
        along = momentum @ axis
        return (peak / 4)**2 / (2 * mass) + along**2 / (2 * about_axis) + (momentum @ momentum - along**2) / (2 * across)

    def test_random_cantilever(self):
        self.run_page("random_cantilever")
        rows = self.read_batch("random_cantilever")
        self.assertEqual([row["case"] for row in rows if row["status"] != "done"], [20])
        failed = rows[19]
        self.assertEqual(failed["status"], "failed")
        self.assertIn("one element's nodes turn against each other by half a turn", failed["reason"])
        self.assertGreater(failed["parameters.couple"], 2 * np.pi * failed["parameters.EI"])
        self.assertEqual([path.name for path in (self.folder / "random_cantilever/cases").iterdir()], ["0020.vtkhdf"])
        # Of each key one sample in each of 200 equally likely parts.
        variance = math.log(1 + 0.25**2)
        levels = {"EI": [(math.log(row["parameters.EI"]) + variance / 2) / math.sqrt(variance) for row in rows],
                  "couple": [(row["parameters.couple"] - math.pi) / 0.2 for row in rows]}
        for key, level in levels.items():
            parts = sorted(int(200 * 0.5 * math.erfc(-x / math.sqrt(2))) for x in level)
            self.assertEqual(parts, list(range(200)), key)

        def deflection(turned):
            return (1 - np.cos(turned)) / turned

        done = [row for row in rows if row["status"] == "done"]
        found = np.array([row["deflection"] for row in done])
        turned = np.array([row["parameters.couple"] / row["parameters.EI"] for row in done])
        np.testing.assert_allclose(found, deflection(turned), atol=2e-4)
        # Plain samples of the formula; scatter of the hypercube's mean and deviation: 0.0026, 0.0048.
        random = np.random.default_rng(1)
        stiffness = np.exp(random.normal(-variance / 2, math.sqrt(variance), 1_000_000))
        turned = random.normal(math.pi, 0.2, 1_000_000) / stiffness
        plain = deflection(turned[turned < 2 * math.pi])
        self.assertAlmostEqual(found.mean(), plain.mean(), delta=3 * 0.0026)
        self.assertAlmostEqual(found.std(ddof=1), plain.std(), delta=3 * 0.0048)
        # With what the message advises, the sample runs.
        with self.open("sample20") as file:
            turned = failed["parameters.couple"] / failed["parameters.EI"]
            self.assertAlmostEqual(file["histories/end/displacement"][-1, 1], deflection(turned), delta=1e-5)


if __name__ == "__main__":
    unittest.main()
