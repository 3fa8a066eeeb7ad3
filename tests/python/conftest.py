"""Runs that the tests of the Python package read. GXROD is the program, GXROD_SOURCE the source tree."""

import csv
import os
import pathlib
import subprocess
import sys

import pytest

SOURCE = pathlib.Path(os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
PROGRAM = os.environ.get("GXROD", str(SOURCE / "build" / "checked" / "gxrod"))
# The package in a build tree has the compiled part, that in the source tree has not.
sys.path.insert(0, os.environ.get("GXROD_PACKAGE", str(SOURCE / "apps" / "python")))
sys.path.insert(1, str(pathlib.Path(__file__).parent))
sys.dont_write_bytecode = True
os.environ.setdefault("GXROD_PROGRAM", PROGRAM)
os.environ.setdefault("MPLBACKEND", "Agg")

EXAMPLES = SOURCE / "docs" / "examples"

PLANK = """title = "A plank that is stepped on"
units = "m kg s"
[parameters]
E = 11e9
height = 0.05
[section.plank]
shape = { rectangle = { width_y = 0.3, height_z = "height" } }
material = { E = "E", G = 6e8, density = 500, shear_factor = "5/6" }
[rod.plank]
section = "plank"
line = { from = [0, 0, 0], to = [3, 0, 0] }
elements = 2
order = 3
y_axis = [0, 1, 0]
[[support]]
at = "plank.start"
fix = "all"
[[load]]
at = "plank.end"
force = [0, 0, "-800*t"]
[analysis]
kind = "dynamic"
end_time = 0.5
time_step = 0.01
[[history]]
name = "tip"
at = "plank.end"
quantities = ["displacement", "orientation"]
[[history]]
name = "tip-seen"
at = "plank.end"
relative_to = "plank@0.5"
quantities = ["position"]
"""

TONES = PLANK[: PLANK.index("[analysis]")].replace("-800*t", "-80") + """[[stage]]
name = "bend"
kind = "static"
[[stage]]
name = "tones"
kind = "modes"
count = 3
"""

SWING = """title = "A rod that swings, with a tendon"
gravity = [0, 0, -9.81]
[parameters]
EI = 6.0
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.arm]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[support]]
at = "arm.start"
fix = "all"
[input.tendon]
value = 0
[[load]]
at = "arm.end"
moment = [0, "tendon", 0]
[analysis]
kind = "dynamic"
end_time = 0.5
time_step = 0.02
[[history]]
name = "tip"
at = "arm.end"
quantities = ["position", "velocity", "orientation"]
[[history]]
name = "root"
at = "arm.start"
quantities = ["moment"]
"""


def gxrod(*arguments, folder, code=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, text=True, capture_output=True, check=False)
    assert done.returncode == code, f"{arguments}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def read_csv(path):
    """{name: texts} of a table that `gxrod export` writes."""
    with open(path, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    return {name: [row[i] for row in rows] for i, name in enumerate(names)}


class Runs:
    """Runs decks when a test first asks for them: examples by their names, and those above."""

    def __init__(self, folder):
        self.folder = folder
        for name, text in (("plank", PLANK), ("modes", TONES)):
            (folder / f"{name}.toml").write_text(text)

    def __call__(self, name):
        path = self.folder / f"{name}.vtkhdf"
        if not path.exists():
            deck = self.folder / f"{name}.toml"
            gxrod("run", deck if deck.exists() else EXAMPLES / name / f"{name}.toml", "--quiet", folder=self.folder)
        return path

    def tables(self, name):
        """The folder of what `gxrod export --csv` writes."""
        folder = self.folder / f"tables_{name}"
        if not folder.exists():
            gxrod("export", self(name), "--csv", folder, folder=self.folder)
        return folder


@pytest.fixture(scope="session")
def runs(tmp_path_factory):
    return Runs(tmp_path_factory.mktemp("runs"))


@pytest.fixture
def absent(monkeypatch):
    """Takes modules away, as if they were not installed."""
    def take(*names):
        for name in names:
            monkeypatch.setitem(sys.modules, name, None)

    return take
