"""Pages of campaigns, which run for hours, show what was counted last."""

import importlib
import json
import os
import pathlib
import subprocess
import sys
import unittest
from unittest import mock

SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])
BOOK = SOURCE / "docs" / "verification"
sys.path.insert(0, str(BOOK))
long_runs = importlib.import_module("make_long_runs")


class RandomModels(unittest.TestCase):
    def test_is_current(self):
        page = subprocess.run([SOURCE / "tests" / "random" / "page", "random_models.json", "random_studies.json"],
                              cwd=SOURCE / "tests" / "data",
                              stdout=subprocess.PIPE, check=True).stdout.decode()
        self.assertEqual(page, (BOOK / "random_models.md").read_text(encoding="utf-8"))


class LongRuns(unittest.TestCase):
    def setUp(self):
        self.rows = json.loads(long_runs.RECORD.read_text(encoding="utf-8"))

    def test_is_current(self):
        self.assertEqual(long_runs.find_faults(self.rows), [])

    def test_other_numbers_are_found(self):
        self.rows[0]["energy"] *= 2.0
        self.assertEqual(long_runs.find_faults(self.rows),
                         ["long_runs.md has a table that is not that of long_runs.json",
                          "long_runs.png is missing or not drawn from long_runs.json"])

    def test_a_missing_picture_is_found(self):
        with mock.patch.object(long_runs, "PICTURE", BOOK / "figures" / "none.png"):
            self.assertEqual(long_runs.find_faults(self.rows), ["none.png is missing or not drawn from long_runs.json"])


if __name__ == "__main__":
    unittest.main()
