#!/usr/bin/env python3
"""Checks that the quantities of histories are in the tables of src/watch alone.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import re
import tempfile
import unittest

TABLES = "src/watch/*_quantities.cpp"
LINE = re.compile(r'Quantity\(\s*"(\w+)"')
TEXT = re.compile(r'"(\w+)"')
# What reads, records, compares and shows histories, whatever they are of.
READERS = ("src/deck/output", "src/results/histories", "src/run", "src/batch", "src/study", "src/sensitivity", "src/face")
# Words that a reader may name: what decks without histories are judged by, and what C++ programs can ask for by a function.
NAMED = {"src/study/motion_trace.cpp": {"position", "orientation"},
         "src/face/value.cpp": {"position", "displacement", "rotation_vector", "orientation", "quaternion", "velocity", "angular_velocity",
                                "acceleration", "force", "moment"}}


def find_words(root):
    """The words of all quantities, one for each line of a table."""
    return [word for path in sorted(root.glob(TABLES)) for word in LINE.findall(path.read_text(encoding="utf-8"))]


def find_mentions(root):
    """One line "file:line: word" for each word of a quantity in what should read it from the tables."""
    words = set(find_words(root))
    mentions = []
    for reader in READERS:
        path = root / reader
        files = [path] if path.is_file() else sorted(one for one in path.rglob("*") if one.suffix in (".cpp", ".hpp"))
        for file in files:
            name = str(file.relative_to(root))
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
                found = (set(TEXT.findall(line.split("//")[0])) & words) - NAMED.get(name, set())
                mentions += [f"{name}:{number}: {word}" for word in sorted(found)]
    return mentions


class Quantities(unittest.TestCase):
    root = pathlib.Path(os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))

    def test_no_reader_names_one(self):
        self.assertEqual(find_mentions(self.root), [])

    def test_the_tables_are_found(self):
        words = find_words(self.root)
        self.assertGreater(len(words), 50)
        self.assertGreaterEqual(set(words), {"position", "elongation", "drive", "tendon_length", "least_gap"})

    def test_a_mention_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "src/watch").mkdir(parents=True)
            (root / "src/study").mkdir()
            (root / "src/watch/point_quantities.cpp").write_text('Quantity("speed", "speed",\n', encoding="utf-8")
            (root / "src/study/series.cpp").write_text('// speed\nif (word == "speed") return;\n', encoding="utf-8")
            self.assertEqual(find_mentions(root), ["src/study/series.cpp:2: speed"])


if __name__ == "__main__":
    unittest.main()
