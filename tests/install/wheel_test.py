#!/usr/bin/env python3
"""A wheel, as `cmake/make-packages wheel` makes it: at work in empty environments of Python, with nothing of Debian and no compiler.

GXROD_WHEELS is its folder, GXROD_SOURCE the source tree. GXROD_PYTHONS, if set, lists Pythons to try it with next to Debian's. NumPy, h5py
and Matplotlib come from PyPI.
"""

import os
import pathlib
import re
import time
import unittest
import zipfile

from newcomer import SOURCE, VERSION, Scratch, run

FOLDER = os.environ.get("GXROD_WHEELS")
PYTHONS = ["/usr/bin/python3", *os.environ.get("GXROD_PYTHONS", "").split()]
DECK = SOURCE / "docs" / "examples" / "rubber_pendulum" / "rubber_pendulum.toml"
# What any Linux has (PEP 600).
SYSTEM = {"linux-vdso.so.1", "libc.so.6", "libm.so.6", "libgcc_s.so.1", "libstdc++.so.6", "libpthread.so.0", "libdl.so.2", "librt.so.1",
          "libresolv.so.2", "libz.so.1"}
NOTHING = {"PATH": "/nonexistent", "HOME": "/nonexistent"}
SAY = "import gxrod; print(gxrod.__version__, gxrod.program.find_program())"


@unittest.skipUnless(FOLDER, "needs GXROD_WHEELS")
class Wheel(Scratch):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        [cls.wheel] = pathlib.Path(FOLDER).resolve().glob("gxrod-*.whl")

    def test_its_name_says_what_it_needs(self):
        [minor] = re.findall(rf"^gxrod-{re.escape(VERSION)}-cp311-abi3-manylinux_2_(\d+)_\w+\.whl$", self.wheel.name)
        self.assertLessEqual(int(minor), int(os.confstr("CS_GNU_LIBC_VERSION").split(".")[1]))

    def test_it_has_the_licences_of_its_libraries(self):
        with zipfile.ZipFile(self.wheel) as archive:
            names = archive.namelist()
            [licence] = [name for name in names if re.search(r"licenses/libraries/libhdf5-.*\.txt$", name)]
            self.assertIn("The HDF Group", archive.read(licence).decode())
        self.assertTrue([name for name in names if re.search(r"\.libs/libumfpack", name)])

    def test_it_works_in_empty_environments(self):
        for number, python in enumerate(PYTHONS):
            with self.subTest(python=python):
                self.install_and_work(python, self.folder / f"environment{number}")

    def install_and_work(self, python, folder):
        run(python, "-m", "venv", folder, env=NOTHING)
        begin = time.monotonic()
        run(folder / "bin" / "pip", "install", "--quiet", "--disable-pip-version-check", "--only-binary", ":all:", f"{self.wheel}[plot]")
        print(f"installed for {python} in {time.monotonic() - begin:.0f} s")
        python = folder / "bin" / "python"
        self.assertEqual(run(python, "-B", "-c", SAY, env=NOTHING, cwd=self.folder).split(), [VERSION, str(folder / "bin" / "gxrod")])
        self.work(folder / "bin", DECK, python, True, NOTHING)
        [packages] = folder.glob("lib/python3*/site-packages")
        for binary in (packages / "gxrod.scripts" / "gxrod", *packages.glob("gxrod/_core*.so")):
            self.assertEqual(self.libraries_from_elsewhere(binary, folder), [])

    def libraries_from_elsewhere(self, binary, folder):
        """Libraries that a program or module takes neither from its environment nor from what any Linux has."""
        lines = [line.split() for line in run("/usr/bin/ldd", binary).splitlines() if "ld-linux" not in line]
        self.assertGreater(len(lines), 20)
        return [line[0] for line in lines if line[0] not in SYSTEM and not (len(line) > 2 and line[2].startswith(f"{folder}/"))]


if __name__ == "__main__":
    unittest.main()
