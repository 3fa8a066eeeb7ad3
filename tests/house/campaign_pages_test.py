"""Pages of campaigns, which run for hours, show what was counted last."""

import importlib
import json
import os
import pathlib
import subprocess
import sys
import unittest
from unittest import mock

import numpy as np

SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])
BOOK = SOURCE / "docs" / "verification"
sys.path.insert(0, str(BOOK))
long_runs = importlib.import_module("make_long_runs")
work_precision = importlib.import_module("make_work_precision")


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


class WorkPrecision(unittest.TestCase):
    def setUp(self):
        self.motions = json.loads(work_precision.RECORD.read_text(encoding="utf-8"))

    def test_is_current(self):
        self.assertEqual(list(self.motions), list(work_precision.MOTIONS))
        self.assertEqual(work_precision.find_faults(self.motions), [])

    def test_other_numbers_are_found(self):
        for row in self.motions["free flight"]["rows"]:
            row["seconds"] *= 2.0
        self.assertEqual(work_precision.find_faults(self.motions),
                         ["work_precision.md has tables that are not those of work_precision.json",
                          "work_precision.png is missing or not drawn from work_precision.json"])

    def test_seconds_of_an_error_lie_between_those_of_two_runs(self):
        seconds, errors = np.array([4.0, 1.0, 4.0, 16.0]), np.array([1e-1, 2e-1, 1e-2, 1e-4])
        self.assertAlmostEqual(work_precision.find_seconds(seconds, errors, 1e-3), 8.0)
        self.assertEqual(work_precision.find_seconds(seconds, errors, 0.3), 1.0)
        self.assertIsNone(work_precision.find_seconds(seconds, errors, 1e-5))


if __name__ == "__main__":
    unittest.main()
