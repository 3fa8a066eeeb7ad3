"""What the 3D view of a report page makes of the page's data, in node: outlines of bodies, where the first view is from, and colours."""

import base64
import itertools
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import numpy as np

REPORT = pathlib.Path(os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[3])) / "apps" / "report"
BEGIN = """globalThis.self = globalThis;
const blocks = %s;
globalThis.document = { getElementById: (id) => (id in blocks ? { textContent: blocks[id], remove() {} } : null) };
const three = await import("three");
const { Vector3 } = three;
"""
# Of what people see who lack a kind of cones, after Machado, Oliveira and Fernandes (2009), severity 1; linear red, green, blue.
SIGHTS = {"all cones": np.eye(3),
          "protan": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
          "deutan": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
          "tritan": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]}


def linear_rgb(colour):
    part = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    return np.where(part <= 0.04045, part / 12.92, ((part + 0.055) / 1.055) ** 2.4)


def oklab(linear):
    """Björn Ottosson's coordinates, in which distances are those that the eye sees."""
    cones = np.cbrt(np.array([[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566],
                              [0.0883024619, 0.2817188376, 0.6299787005]]) @ np.clip(linear, 0, 1))
    return np.array([[0.2104542553, 0.7936177850, -0.0040720468], [1.9779984951, -2.4285922050, 0.4505937099],
                     [0.0259040371, 0.7827717662, -0.8086757660]]) @ cones


def block(numbers, kind):
    return base64.b64encode(np.asarray(numbers, dtype=kind).tobytes()).decode()


@unittest.skipUnless(shutil.which("node"), "needs node")
class SceneTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        root = pathlib.Path(cls.folder.name)
        shutil.copytree(REPORT / "src", root / "src")
        library = (REPORT / "libraries" / "three.js").read_text(encoding="utf-8")
        names = library[2 : library.index("\n")]
        (root / "package.json").write_text('{"type": "module"}', encoding="utf-8")
        package = root / "node_modules" / "three"
        package.mkdir(parents=True)
        (package / "index.mjs").write_text(f"{library}\nexport const {{ {names} }} = three;\n", encoding="utf-8")
        (package / "package.json").write_text('{"name": "three", "exports": "./index.mjs"}', encoding="utf-8")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_script(self, script, blocks=None):
        """What a script hands to `answer`."""
        text = BEGIN % json.dumps({f"data-{name}": data for name, data in (blocks or {}).items()})
        script = text + "const answer = (value) => console.log(JSON.stringify(value));\n" + script
        (pathlib.Path(self.folder.name) / "test.mjs").write_text(script, encoding="utf-8")
        done = subprocess.run(["node", "test.mjs"], cwd=self.folder.name, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    # Outlines.

    def test_a_body_with_looks_is_its_triangles_and_moves_with_its_node(self):
        corners = [[9, 9, 9], [0, 0, 0], [2, 0, 0], [0, 3, 0], [0, 0, 1]]
        blocks = {"outline-points": block(corners, "f4"), "outline-triangles": block([0, 0, 0, 0, 1, 2, 0, 1, 3], "i4"),
                  "outline-lines": block([0, 0, 2, 3], "i4")}
        # The second of two bodies: it has four corners, two triangles and a line. Half a turn about z on the way from its attitude, a quarter about x.
        found = self.run_script("""
const { Bodies } = await import("./src/scene/bodies.js");
const plain = { name: "a", node: 0, centre: [0, 0, 0], attitude: [1, 0, 0, 0], axes: [1, 0, 0, 0], half_sizes: [1, 1, 1], shape: null };
const looks = { ...plain, name: "b", node: 1, centre: [1, 0, 0], attitude: [Math.SQRT1_2, Math.SQRT1_2, 0, 0], reach: 3, outline: [[1, 5], [1, 3], [1, 2]] };
const data = { info: { bodies: [plain, looks], joints: [{ ends: [{ node: 1 }, { node: -1 }] }], bushings: [] }, times: [0] };
const motion = { positions: new Float32Array([0, 0, 0, 5, 6, 7]), rotations: new Float32Array([1, 0, 0, 0, 0, 0, 0, 1]), frames: 1 };
const bodies = new Bodies(data, motion, 1);
bodies.move();
const { group, sides, hasLooks, isClear, around } = bodies.bodies[1];
group.updateMatrixWorld(true);
const [surface, edges] = group.children;
const places = surface.geometry.attributes.position;
const corners = [...Array(places.count).keys()].map((i) => surface.localToWorld(new Vector3().fromBufferAttribute(places, i)).toArray());
answer({ corners, sides, hasLooks, isClear, farness: around.farness, lines: Array.from(edges.geometry.index.array), reached: bodies.hasLooks(0),
  reaches: bodies.reachFrom({ node: 1, arm: new Vector3(1, 0, 0) }, new Vector3(1, 0, 0)) });
""", blocks)
        # (x, y, z) of the body is (x, -z, y) at t = 0, and (-x, z, y) after half a turn about z.
        turned = [[5 - x, 6 + z, 7 + y] for x, y, z in np.array(corners[1:])[[0, 1, 2, 0, 1, 3]]]
        np.testing.assert_allclose(found["corners"], turned, atol=1e-6)
        np.testing.assert_allclose(found["sides"], [2, 3, 1])
        self.assertEqual((found["hasLooks"], found["isClear"], found["reached"]), (True, False, False))
        self.assertEqual(found["lines"], [2, 3])
        self.assertAlmostEqual(found["farness"], np.sqrt(10), places=6)
        # From (1, 0, 0) of the box from (0, 0, 0) to (2, 3, 1) a line along x leaves it at both sides of it.
        np.testing.assert_allclose(found["reaches"], [1, 1], atol=1e-6)

    # The first view.

    def find_view(self, obstacles, box):
        """Where the camera is for the first view of a box among obstacles, and the box that it shows."""
        return self.run_script("""
const { Picture } = await import("./src/scene/picture.js");
const { Stage } = await import("./src/scene/stage.js");
const { Obstacles } = await import("./src/scene/obstacles.js");
const [obstacles, box] = %s;
const size = new Vector3(...box[1]).distanceTo(new Vector3(...box[0]));
const list = obstacles.map((one) => ({ about: [0, 0, 0], moved: -1, ...one }));
const parts = { obstacles: new Obstacles({ info: { obstacles: list }, obstacles: new Float32Array(0) }, { frame: 0, part: 0, frames: 1 }, size),
  contacts: { areAlong: () => false } };
const stage = Object.assign(Object.create(Stage.prototype), { camera: new three.PerspectiveCamera(32, 1.5, 0.01, 100), draw() {}, makeRoom() {},
  renderer: { domElement: { parentElement: { clientWidth: 600, clientHeight: 400 } } }, hides: (point) => parts.obstacles.contain(point) });
stage.controls = { target: new Vector3(), update() {} };
const picture = Object.assign(Object.create(Picture.prototype), { stage, parts, size, boundsOfPoints: () => box });
const shown = parts.obstacles.lay(box);
stage.setBox(shown);
picture.resetView();
answer({ place: stage.camera.position.toArray(), shown, inside: parts.obstacles.contain(stage.camera.position), centre: stage.centre.toArray() });
""" % json.dumps([obstacles, box]))

    def test_it_is_above_a_plane_and_not_fitted_to_it(self):
        floor = {"shape": "plane", "line": [[0, 0, -1]], "normal": [0, 0, 1]}
        found = self.find_view([floor], [[0, 0, -0.5], [1, 1, 0.5]])
        self.assertGreater(found["place"][2], 0)
        np.testing.assert_allclose(found["shown"], [[0, 0, -1], [1, 1, 0.5]], atol=1e-6)
        ceiling = {"shape": "plane", "line": [[0, 0, 1]], "normal": [0, 0, -1]}
        found = self.find_view([ceiling], [[0, 0, -0.5], [1, 1, 0.5]])
        self.assertFalse(found["inside"])
        self.assertLess(found["place"][2], 1)

    def test_it_is_outside_of_round_obstacles(self):
        box = [[0, 0, 0], [1, 0.5, 0.5]]
        drum = {"shape": "cylinder", "line": [[-9, -5, 1], [9, -5, 1]], "radius": 4.9, "hollow": False}
        tunnel = {"shape": "cylinder", "line": [[0, 0, 0], [1, 0, 0]], "radius": 3, "hollow": True}
        cave = {"shape": "sphere", "line": [[0, 0, 0]], "radius": 8, "hollow": True}
        tube = {"shape": "tube", "line": [[-9, 0, 0], [0, 0, 0.1], [9, 0, 0]], "radius": 2.5, "hollow": True}
        for obstacle in (drum, tunnel, cave, tube):
            found = self.find_view([obstacle], box)
            with self.subTest(obstacle):
                self.assertFalse(found["inside"])
                # Of what is around the model nothing far away widens the view.
                if obstacle["hollow"]:
                    self.assertLess(np.ptp(found["shown"], axis=0).max(), 2)

    def test_it_is_outside_of_a_vessel_that_is_open_at_its_ends(self):
        turns = np.linspace(0, 2 * np.pi, 13)[:-1]
        rings = [[x, 4 * np.cos(turn), 4 * np.sin(turn)] for x in (-20, 20) for turn in turns]
        triangles = [[i, (i + 1) % 12, 12 + i] for i in range(12)] + [[(i + 1) % 12, 12 + (i + 1) % 12, 12 + i] for i in range(12)]
        found = self.run_script("""
const { isWithin } = await import("./src/scene/within.js");
const vessel = { shape: "mesh", corners: new Float32Array(%s), triangles: new Int32Array(%s) };
answer([[0, 0, 0], [0, 1, -3], [0, 5, 0], [21, 0, 0], [0, 0, -4.5]].map((point) => isWithin(vessel, new Vector3(...point))));
""" % (np.ravel(rings).tolist(), np.ravel(triangles).tolist()))
        self.assertEqual(found, [True, True, False, False, False])

    # Colours.

    def test_rods_bodies_and_obstacles_differ_for_every_eye_in_light_and_dark(self):
        style = (REPORT / "src" / "style.css").read_text(encoding="utf-8")
        colours = {name: re.findall(rf"--{name}: (#[0-9a-f]{{6}})", style) for name in ("rod", "body", "obstacle", "paper")}
        self.assertEqual({name: len(found) for name, found in colours.items()}, dict.fromkeys(colours, 3))  # light, and dark twice
        for theme in range(3):
            for sight, matrix in SIGHTS.items():
                seen = {name: oklab(np.array(matrix) @ linear_rgb(found[theme])) for name, found in colours.items()}
                for one, other in itertools.combinations(seen, 2):
                    with self.subTest(theme=theme, sight=sight, between=(one, other)):
                        self.assertGreater(np.linalg.norm(seen[one] - seen[other]), 0.1)


if __name__ == "__main__":
    unittest.main()
