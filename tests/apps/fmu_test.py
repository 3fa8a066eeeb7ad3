"""gxrod fmu: the archive and its description. FMPy runs one in tests/python/examples_test.py."""

import os
import pathlib
import unittest
import xml.etree.ElementTree as ET
import zipfile

from program import GXROD, ProgramTest

DECK = (pathlib.Path(os.environ["GXROD_SOURCE"]) / "docs" / "examples" / "python" / "controller" / "arm.toml").read_text()


@unittest.skipUnless(pathlib.Path(GXROD).with_name("gxrod_fmu.so").exists(), "the library of FMUs is not built")
class Fmu(ProgramTest):
    def test_an_archive_has_description_deck_and_library(self):
        self.write("arm.toml", DECK)
        said = self.gxrod("fmu", "arm.toml", "--set", "parameters.length=0.25").stdout
        self.assertEqual(said.splitlines()[0], "parameter radius")
        self.assertIn("input tendon\noutput tip.position.x\n", said)
        self.assertTrue(said.endswith("FMU: arm.fmu\n"))
        with zipfile.ZipFile(self.folder / "arm.fmu") as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual(sorted(archive.namelist()), ["binaries/x86_64-linux/gxrod_fmu.so", "modelDescription.xml", "resources/deck.toml"])
            root = ET.fromstring(archive.read("modelDescription.xml"))
            self.assertIn("length = 0.25", archive.read("resources/deck.toml").decode())
        self.assertEqual((root.attrib["fmiVersion"], root.find("CoSimulation").attrib["modelIdentifier"]), ("3.0", "gxrod_fmu"))
        names = [variable.attrib["name"] for variable in root.find("ModelVariables")]
        self.assertEqual(names[:5], ["time", "radius", "length", "tendon", "tip.position.x"])

    def test_what_cannot_be_packed_is_refused(self):
        self.write("arm.toml", DECK)
        self.gxrod("fmu", "arm.toml")
        self.assertIn("exists; --force replaces it", self.gxrod("fmu", "arm.toml", code=4).stderr)
        self.gxrod("fmu", "arm.toml", "--force")
        self.write("rest.toml", DECK[: DECK.index("[analysis]")] + '[analysis]\nkind = "static"\n')
        self.assertIn("an FMU moves in time", self.gxrod("fmu", "rest.toml", code=2).stderr)
        self.write("time.toml", DECK + '\n[input.time]\n')
        self.assertIn('called "time"', self.gxrod("fmu", "time.toml", code=2).stderr)


if __name__ == "__main__":
    unittest.main()
