"""Every example deck runs, by the commands that its page states, and leaves what the page says."""

import os
import re
import shlex
import unittest

import h5py
import numpy as np

from program import GXROD, GXROD_PLOT, SOURCE, ProgramTest

EXAMPLES = SOURCE / "docs" / "examples"


def commands_of(page):
    """The gxrod commands in a page's code blocks."""
    blocks = re.findall(r"```\n(.*?)```", page.read_text(), flags=re.DOTALL)
    lines = [line for block in blocks for line in block.splitlines()]
    return [line for line in lines if line.startswith(("gxrod ", "gxrod-plot "))]


class Examples(ProgramTest):
    def run_page(self, name):
        page = EXAMPLES / name / "README.md"
        commands = commands_of(page)
        self.assertTrue(commands, f"{page} states no command")
        for command in commands:
            program, *arguments = shlex.split(command)
            program = {"gxrod": GXROD, "gxrod-plot": GXROD_PLOT}[program]
            arguments = [str(SOURCE / word) if word.startswith("docs/") else word for word in arguments]
            self.gxrod(*arguments, program=program, timeout=900)

    def open(self, name):
        return h5py.File(self.folder / f"{name}.vtkhdf")

    def test_each_example_has_deck_page_and_picture(self):
        folders = [path for path in EXAMPLES.iterdir() if path.is_dir()]
        self.assertGreaterEqual(len(folders), 26)
        for folder in folders:
            for file in (f"{folder.name}.toml", "README.md", f"{folder.name}.png"):
                self.assertTrue((folder / file).exists(), folder / file)
            # What an example gives is checked here, or by `gxrod verify` against its reference.
            self.assertTrue(
                hasattr(self, f"test_{folder.name}") or (folder / "reference.toml").exists(), folder)

    @unittest.skipIf(os.environ.get("GXROD_SANITIZED") == "1", "takes minutes under sanitizers; Release runs it")
    def test_benchmark_pages(self):
        for reference in sorted(EXAMPLES.glob("*/reference.toml")):
            name = reference.parent.name
            with self.subTest(name):
                self.run_page(name)
                with self.open(name) as file:
                    self.assertEqual(file.attrs["status"], "complete")
                    for group in ("ledger", "histories"):
                        file[group].visititems(
                            lambda path, item: self.assertTrue(
                                not isinstance(item, h5py.Dataset) or np.isfinite(item[:]).all(), path))
                self.assertGreater((self.folder / f"{name}.png").stat().st_size, 20000)

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


if __name__ == "__main__":
    unittest.main()
