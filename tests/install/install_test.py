#!/usr/bin/env python3
"""What is installed works by itself: the program, the library in a program outside the tree, the pages.

GXROD_BUILD is a build folder, GXROD_SOURCE the source tree.
"""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import h5py

BUILD = pathlib.Path(os.environ["GXROD_BUILD"])
SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])
DECK = SOURCE / "docs" / "examples" / "rubber_pendulum" / "rubber_pendulum.toml"


def run(*command, **options):
    done = subprocess.run([str(part) for part in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.prefix = cls.folder / "prefix"
        run("cmake", "--install", BUILD, "--prefix", cls.prefix)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_the_program_runs(self):
        self.assertRegex(run(self.prefix / "bin" / "gxrod", "--version"), r"^gxrod \d+\.\d+\.\d+")
        results = self.folder / "results.vtkhdf"
        run(self.prefix / "bin" / "gxrod", "run", DECK, "-o", results, "--set", "analysis.end_time=0.05")
        run(self.prefix / "bin" / "gxrod-plot", results, "-o", self.folder / "picture.png")
        self.assertGreater((self.folder / "picture.png").stat().st_size, 5000)

    def test_pages_find_their_pictures_and_each_other(self):
        share = self.prefix / "share" / "gxrod"
        pages = sorted(share.rglob("*.md"))
        self.assertGreater(len(pages), 150)
        for page in pages:
            text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
            for target in re.findall(r"\]\(([^)\s#:]+)(?:#[^)\s]*)?\)", text):
                path = pathlib.Path(os.path.normpath(page.parent / target))
                if path.is_relative_to(share) and path.suffix in (".md", ".png", ".toml"):
                    self.assertTrue(path.is_file(), f"{page.relative_to(share)} links to {target}")

    def test_other_programs_use_the_library(self):
        build = self.folder / "library"
        run("cmake", "-S", SOURCE / "docs" / "howto" / "library", "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
            f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run("cmake", "--build", build)
        lowest = float(re.match(r"lowest point (\S+) at", run(build / "swing", DECK, "tip"))[1])
        results = self.folder / "whole.vtkhdf"
        run(self.prefix / "bin" / "gxrod", "run", DECK, "-o", results)
        with h5py.File(results) as file:
            self.assertAlmostEqual(lowest, file["histories/tip/position"][:, 1].min(), delta=1e-6)
        failed = subprocess.run([build / "swing", DECK, "top"], text=True, capture_output=True)
        self.assertEqual((failed.returncode, failed.stderr),
                         (2, 'there is no history "top"; did you mean "tip"? there are tip, pin\n'))
        springs = re.findall(r"stiffness (\S+), of handbooks (\S+)", run(build / "conical_spring"))
        self.assertEqual(len(springs), 3)
        for found, expected in springs:
            self.assertAlmostEqual(float(found) / float(expected), 1.0, delta=0.003)
        laws = re.findall(r"(\w+) (\S+), exact (\S+)", run(build / "own_laws"))
        self.assertEqual([name for name, *_ in laws], ["cord", "strut"])
        for _, found, exact in laws:
            self.assertAlmostEqual(float(found), float(exact), delta=1e-8)

    def test_no_header_needs_the_source_tree(self):
        headers = sorted((self.prefix / "include" / "gxrod").rglob("*.hpp"))
        self.assertGreater(len(headers), 100)
        for header in headers:
            for name in re.findall(r'^#include "([^"]+)"', header.read_text(encoding="utf-8"), re.M):
                self.assertTrue((self.prefix / "include" / "gxrod" / name).exists(), f"{header} includes {name}")


if __name__ == "__main__":
    unittest.main()
