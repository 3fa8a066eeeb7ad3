"""The guide to batches: its decks, plans, tables, commands and Python, run as they stand and in their order."""

import os
import re
import subprocess
import sys
import unittest

from program import SOURCE, ProgramTest, commands_of

GUIDE = SOURCE / "docs" / "guide" / "batch.md"


class BatchGuide(ProgramTest):
    def setUp(self):
        super().setUp()
        self.page = GUIDE.read_text(encoding="utf-8")
        # "`sweep.toml`, next to the deck:" and what follows it.
        for name, text in re.findall(r"`(\w+\.(?:toml|csv))`[^`.]*:\n\n```(?:toml)?\n(.*?)```", self.page, re.DOTALL):
            self.write(name, text)

    def python(self, number):
        example = re.findall(r"```python\n(.*?)```", self.page, re.DOTALL)[number]
        return subprocess.run([sys.executable, "-c", example], cwd=self.folder, check=True, capture_output=True,
                              text=True, timeout=120).stdout

    @unittest.skipIf(os.environ.get("GXROD_SANITIZED") == "1", "takes a minute under sanitizers; Release runs it")
    def test_commands(self):
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         ["people.csv", "people.toml", "plank.toml", "random.toml", "refined.toml", "sweep.toml"])
        deck = (self.folder / "plank.toml").read_text()
        self.write("thin.toml", deck.replace("height = 0.05", "height = 0.03"))
        commands = commands_of(GUIDE)
        self.assertEqual(len(commands), 10)
        for command in commands:
            done = self.run_command(command)
            if "--dry-run" in command:
                self.assertIn("12: parameters.height = 0.06, parameters.rise = 0.8", done.stdout)
                self.assertFalse((self.folder / "sweep").exists())
        for folder, cases in {"sweep": 12, "random": 40, "people": 3, "refined": 12, "both": 2}.items():
            lines = (self.folder / folder / "index.csv").read_text().splitlines()
            self.assertEqual(len(lines), cases + 1, folder)
            self.assertTrue(all(",done," in line for line in lines[1:]), folder)
        self.assertFalse((self.folder / "random" / "cases").exists())
        for file in ("0001.png", "sweep/report.html", "sweep.png", "refined.png", "refined.tex"):
            self.assertTrue((self.folder / file).exists(), file)

        printed = re.search(r"It prints\n\n```\n(.*?)```", self.page, re.DOTALL).group(1)
        self.assertEqual(self.python(0), printed)
        # What the page's table shows.
        rows = [line.split(",") for line in (self.folder / "sweep/index.csv").read_text().splitlines()]
        shown = re.findall(r"^\| (\d+) \| (\S+) \| (\S+) \| done \| (\S+) \| (\S+) \|", self.page, re.MULTILINE)
        self.assertEqual(len(shown), 3)
        for number, *parameters, lowest, moment in shown:
            row = rows[int(number)]
            self.assertEqual(row[1:3], parameters)
            self.assertEqual((f"{float(row[5]):.3f}", f"{float(row[6]):.0f}"), (lowest, moment))

        # A changed plan is refused as the page says.
        plan = (self.folder / "sweep.toml").read_text()
        self.write("sweep.toml", plan.replace("0.06]", "0.07]"))
        refused = self.gxrod("batch", "sweep.toml", code=2)
        self.assertIn(refused.stderr, self.page)
        self.write("sweep.toml", "time_limit = 60\n# a comment\n" + plan + '[keep]\nresults = "none"\n')
        self.assertIn("0 run now", self.gxrod("batch", "sweep.toml").stdout)

    def test_every_plan_is_right(self):
        plans = [block for block in re.findall(r"```toml\n(.*?)```", self.page, re.DOTALL) if block.startswith("deck")]
        self.assertEqual(len(plans), 5)
        for number, plan in enumerate(plans):
            with self.subTest(plan=plan):
                done = self.gxrod("batch", self.write(f"plan_{number}.toml", plan), "--dry-run")
                self.assertIn("read and checked", done.stdout)


if __name__ == "__main__":
    unittest.main()
