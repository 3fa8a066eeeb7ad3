"""The Python examples of docs/guide/results.md run as they stand."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

GUIDE = Path(os.environ["GXROD_SOURCE"]) / "docs" / "guide" / "results.md"


class Examples(unittest.TestCase):
    def test_examples(self):
        guide = GUIDE.read_text(encoding="utf-8")
        examples = re.findall(r"^```python\n(.*?)^```", guide, re.MULTILINE | re.DOTALL)
        self.assertEqual(len(examples), 5)
        with tempfile.TemporaryDirectory() as folder:
            environment = dict(os.environ, GXROD_PLOT_SAMPLE=f"{folder}/flyer.vtkhdf", MPLBACKEND="Agg", PYTHONDONTWRITEBYTECODE="1",
                               PYTHONPATH=str(GUIDE.parents[2] / "apps" / "python"))
            subprocess.run([os.environ["GXROD_TESTS"], "[.plot-sample]"], env=environment, check=True,
                           capture_output=True)
            outputs = [subprocess.run([sys.executable, "-c", example], cwd=folder, env=environment,
                                      check=True, capture_output=True, text=True).stdout
                       for example in examples]
            self.assertTrue(outputs[0].startswith("Swaying spring and spinning top: flyer.vtkhdf, complete, 400 steps to time 10\n"))
            self.assertIn("] (62, 3) ", outputs[0])
            self.assertEqual(outputs[1], "Swaying spring and spinning top complete end_time reached\n")
            self.assertIn("at t = 10.0 the first rod's start is at [1. 0. 0.]", outputs[2])
            lines = outputs[3].splitlines()
            self.assertEqual(lines[0], "along spring")
            self.assertEqual(len(lines), 1 + 60)
            self.assertTrue((Path(folder) / "tip.png").exists())
            self.assertEqual(outputs[4], "")  # it has no stresses


if __name__ == "__main__":
    unittest.main()
