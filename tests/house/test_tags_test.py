#!/usr/bin/env python3
"""Each test case carries the name of its folder as its first tag, and of no other room: so `gxrod_tests "[deck]"` runs the
tests of src/deck, and ctest, which runs a room at a time, runs each once.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import re
import tempfile
import unittest

CASE = re.compile(r'TEST_CASE(?:_METHOD)?\(\s*(?:\w+,\s*)?((?:"(?:[^"\\]|\\.)*"\s*)+)(?:,\s*"((?:\[[^\]"]+\])+)")?')


def find_faults(root):
    """One line "file: case: …" for each case whose tags are not those of its folder."""
    rooms = {path.name for parent in ("src", "tests") for path in (root / parent).iterdir() if path.is_dir()}
    faults = []
    for path in sorted((root / "tests").rglob("*_test.cpp")):
        room = path.relative_to(root).parts[1]
        for name, tags in CASE.findall(path.read_text(encoding="utf-8")):
            tags = re.findall(r"\[([^\]]+)\]", tags)
            if tags and tags[0].startswith("."):
                continue
            if not tags or tags[0] != room or rooms & set(tags[1:]):
                faults.append(f"{path.relative_to(root)}: {name.strip()}: {tags or 'no tags'}, expected [{room}] first")
    return faults


class Tags(unittest.TestCase):
    def test_every_case_has_its_room(self):
        root = pathlib.Path(os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
        self.assertEqual(find_faults(root), [])

    def test_a_fault_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "src" / "deck").mkdir(parents=True)
            (root / "tests" / "deck").mkdir(parents=True)
            (root / "tests" / "deck" / "a_test.cpp").write_text(
                'TEST_CASE("right", "[deck][x]") {}\nTEST_CASE("none") {}\nTEST_CASE("other", "[rods]") {}\n'
                'TEST_CASE("hidden", "[.sample]") {}\n')
            self.assertEqual(len(find_faults(root)), 2)


if __name__ == "__main__":
    unittest.main()
