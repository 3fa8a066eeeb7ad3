"""What the tests of report pages share: decks, their pages, and a browser."""

import io
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import h5py
import numpy as np
from browser import LAPTOP, PHONE, Browser
from PIL import Image
from program import GXROD, SPINNING_BODY

ROD = """title = "A swinging rod"
units = "m kg s"
[section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 20, EIy = 20, EIz = 40 }
inertia = { rhoA = 1, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.arm]
section = "s"
line = { from = [0, 0, 0], to = [4, 0, 1] }
elements = 6
order = 2
[[support]]
at = "arm.start"
fix = "position"
[[load]]
at = "arm.end"
force = [0, "4*sin(2*t)", "-3"]
[analysis]
kind = "dynamic"
end_time = 2.0
time_step = 0.02
[output]
every = 5
[[history]]
name = "tip"
at = "arm.end"
quantities = ["position", "velocity"]
"""
STATIC = ROD.replace('"dynamic"\nend_time = 2.0\ntime_step = 0.02', '"static"\nsteps = 8').replace(
    'fix = "position"', 'fix = "all"').replace("every = 5", "every = 1").replace('"4*sin(2*t)"', "2").replace(
    ', "velocity"', "")
# Two rods that meet in a corner; a matrix over several lines; a point relative to another; forces in N, lengths in mm.
FRAME = """title = "A frame"
units = "mm t s"
[section.s]
stiffness_matrix = [
  [4e5, 0, 0, 0, 0, 0],
  [0, 4e5, 0, 0, 0, 0],
  [0, 0, 4e5, 0, 0, 0],
  [0, 0, 0, 4e8, 0, 0],
  [0, 0, 0, 0, 4e8, 0],
  [0, 0, 0, 0, 0, 4e8],
]
[rod.leg]
section = "s"
line = { from = [0, 0, 0], to = [0, 2000, 0] }
elements = 4
[rod.beam]
section = "s"
line = { from = [0, 2000, 0], to = [900, 2000, 0] }
elements = 4
[[connect]]
points = ["leg.end", "beam.start"]
[[support]]
at = "leg.start"
fix = "all"
[[load]]
at = "beam.end"
force = [1e2, 0, 2e-9]
[analysis]
kind = "static"
steps = 4
[[history]]
name = "tip"
at = "beam.end"
quantities = ["position", "displacement"]
relative_to = "leg.end"
[[history]]
name = "foot"
at = "leg.start"
quantities = ["reaction_moment", "reaction_force"]
"""
# Tapers, with the centres of its sections off the line.
BLADE = ROD.replace("A swinging rod", "A blade").replace('section = "s"', 'sections = [[0, "root"], [1, "tip"]]').replace(
    "[rod.arm]", """[section.root]
shape = { rectangle = { width_y = 0.1, height_z = 0.4 } }
material = { E = 1e6, nu = 0.3, density = 20 }
at = [0, 0.1]
[section.tip]
shape = { rectangle = { width_y = 0.05, height_z = 0.1 } }
material = { E = 1e6, nu = 0.3, density = 20 }
turn = 0.3
[rod.arm]""")
# From t = 0.5 the force is a billion times too large.
FAILING = ROD.replace('"4*sin(2*t)"', '"t < 0.5 ? 1 : 1e10"')
MARK = "document.documentElement.dataset.evil = 1"
EVIL_TEXT = f"</script><script>{MARK}</script><img src=x onerror='{MARK}'>"
EVIL = ROD.replace("A swinging rod", EVIL_TEXT).replace("m kg s", EVIL_TEXT) + f"# {EVIL_TEXT} <!-- <script>\n"
EVIL_NAME = f"<img src=x onerror={MARK.replace(' ', '')}>"
DECKS = {"rod": ROD, "static": STATIC, "failing": FAILING, "body": SPINNING_BODY, "frame": FRAME, "blade": BLADE, EVIL_NAME: EVIL}


class PageTest(unittest.TestCase):
    """Has pages of all decks, and a browser to open them in."""

    folder = None
    browser = None

    def open(self, name, size=LAPTOP, scheme="light"):
        self.browser.resize(size, mobile=size == PHONE)
        self.browser.prefer(scheme)
        self.browser.open(self.folder / f"{name}.html")
        self.browser.settle()

    def text(self, selector):
        return self.browser.run("return document.querySelector(arguments[0]).textContent", selector)

    def picture(self):
        """Pixels of the 3D view, without what lies over it."""
        png = self.browser.driver.find_element("css selector", "#canvas").screenshot_as_png
        pixels = np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)
        height, width, _ = pixels.shape
        return pixels[int(0.3 * height):int(0.85 * height), int(0.12 * width):int(0.95 * width)]

    def hide_all_but_parts(self):
        """Leaves only rods and bodies in the picture."""
        for name in ("grid", "reference", "shapes", "supports", "loads"):
            self.browser.run("document.getElementById(arguments[0]).click()", f"show-{name}")
        self.browser.settle()

    def slide(self, frame):
        self.browser.run("const s = document.getElementById('time-slider'); s.value = arguments[0];"
                         "s.dispatchEvent(new Event('input'))", frame)
        self.browser.settle()

    def make_changed_page(self, name, change):
        """A page of the rod's results after `change` of the HDF5 file."""
        shutil.copy(self.folder / "rod.vtkhdf", self.folder / f"{name}.vtkhdf")
        with h5py.File(self.folder / f"{name}.vtkhdf", "r+") as file:
            change(file)
        subprocess.run([GXROD, "report", f"{name}.vtkhdf"], cwd=self.folder, check=True, capture_output=True)

    def assert_drawn(self, pixels, part=0.001):
        background = np.median(pixels.reshape(-1, 3), axis=0)
        drawn = (np.abs(pixels - background).max(axis=2) > 40).mean()
        self.assertGreater(drawn, part, "the picture is blank")

    def cursor(self, chart=0):
        """Where the line of the present time is in a chart, as a part of its width."""
        return self.browser.run("""
            const over = document.querySelectorAll(".chart:not(.along) .u-over")[arguments[0]];
            return new DOMMatrix(getComputedStyle(over.querySelector('.now')).transform).m41 / over.clientWidth;""", chart)


def set_up_pages():
    """Runs the decks and makes their pages, once for a module; starts the browser."""
    temporary = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(temporary.cleanup)
    PageTest.folder = pathlib.Path(temporary.name)
    for name, deck in DECKS.items():
        (PageTest.folder / f"{name}.toml").write_text(deck)
        run = subprocess.run([GXROD, "run", f"{name}.toml", "--quiet"], cwd=PageTest.folder, capture_output=True, text=True)
        assert run.returncode == (3 if name == "failing" else 0), run.stderr
        if name == EVIL_NAME:
            with h5py.File(PageTest.folder / f"{name}.vtkhdf", "r+") as file:
                file.move("histories/tip", f"histories/{EVIL_NAME}")
        subprocess.run([GXROD, "report", f"{name}.vtkhdf"], cwd=PageTest.folder, check=True, capture_output=True)
    PageTest.browser = Browser()
    unittest.addModuleCleanup(PageTest.browser.close)
