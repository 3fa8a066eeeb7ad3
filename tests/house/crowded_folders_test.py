#!/usr/bin/env python3
"""Checks that no folder of src has more than thirty files, and that none is called build, which tools take for output.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import tempfile
import unittest

MOST_FILES = 30


def find_faults(source):
    """What is wrong with the folders below a path."""
    faults = []
    for folder in sorted(path for path in [source, *source.rglob("*")] if path.is_dir()):
        files = sum(path.is_file() for path in folder.iterdir())
        if files > MOST_FILES:
            faults.append(f"{folder.relative_to(source.parent)} has {files} files")
        if folder.name == "build":
            faults.append(f"{folder.relative_to(source.parent)} is called build")
    return faults


class CrowdedFolders(unittest.TestCase):
    def test_of_the_sources(self):
        root = os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2])
        self.assertEqual(find_faults(pathlib.Path(root) / "src"), [])

    def test_a_crowded_folder_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "src"
            (source / "room" / "build").mkdir(parents=True)
            for number in range(MOST_FILES + 1):
                (source / "room" / f"{number}.cpp").touch()
            self.assertEqual(find_faults(source), ["src/room has 31 files", "src/room/build is called build"])


if __name__ == "__main__":
    unittest.main()
