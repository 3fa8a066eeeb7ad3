"""Folders of batches as gxrod batch leaves them, written by hand for the tests of their report."""

import csv
import io
import json
import subprocess

from program import GXROD

STATUSES = ("done", "failed", "time limit", "out of memory", "crashed", "deck fault")
LAST = ["steps", "newton_iterations", "rejected_steps", "time", "seconds", "results", "warning"]


class BatchFolder:
    """A batch in a folder: `columns` are the names of what was collected."""

    def __init__(self, folder, parameters, columns, combine="grid", **record):
        self.folder = folder
        self.folder.mkdir(parents=True, exist_ok=True)
        self.parameters, self.columns = parameters, columns
        self.rows = []
        self.record = {
            "gxrod_version": "0.1.0", "plan": "sweep.toml", "plan_text": 'deck = "rod.toml"\ncombine = "grid"\n',
            "title": "A rod of many kinds", "combine": combine, "seed": 7, "cases": 0, "cases_sha256": "",
            "decks": [{"name": "rod.toml", "sha256": "", "text": "title = 'A rod'\n", "meshes_sha256": {}}],
            "parameters": parameters, "columns": [{"name": name, "description": f"all of {name}"} for name in columns],
        } | record

    def add(self, values, collected, status="done", reason="", results="", warning="", seconds=0.5, steps=100):
        assert status in STATUSES
        number = len(self.rows) + 1
        self.rows.append([number, *values, status, reason, *collected, steps, 3 * steps, 0, 2.0, seconds, results, warning])

    def run(self, deck, *overrides, values, collected, **row):
        """Runs a deck for the next case, so that its results are there."""
        results = f"cases/{len(self.rows) + 1:04}.vtkhdf"
        (self.folder / "cases").mkdir(exist_ok=True)
        options = [word for override in overrides for word in ("--set", override)]
        subprocess.run([GXROD, "run", deck, "--quiet", "-o", self.folder / results, *options], check=True)
        self.add(values, collected, results=results, **row)

    def write(self, cases=0):
        """batch.json and index.csv; `cases` of them if not all have ended."""
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        table.writerow(["case", *self.parameters, "status", "reason", *self.columns, *LAST])
        table.writerows(self.rows)
        (self.folder / "index.csv").write_text(text.getvalue())
        (self.folder / "batch.json").write_text(json.dumps(self.record | {"cases": cases or len(self.rows)}))
        return self.folder
