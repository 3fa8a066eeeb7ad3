#!/usr/bin/env python3
"""Checks that what a scheme is, is asked of its card (src/model/settings/scheme_card.hpp): no other room compares schemes.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import re
import tempfile
import unittest

# Where schemes have names: the cards, the choice of one, what makes integrators, and the study of Rubin's body.
NAMED = ("model/settings/", "integrators/integrator.cpp", "verification/rubin2007")
COMPARED = re.compile(r"(case\s+|[!=]=\s*)Scheme::\w+")


def find_faults(source):
    """Where a scheme is compared outside of these."""
    faults = []
    for path in sorted(source.rglob("*.[ch]pp")):
        name = path.relative_to(source).as_posix()
        if name.startswith(NAMED):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if COMPARED.search(line):
                faults.append(f"{name}:{number}: {line.strip()}")
    return faults


class Cards(unittest.TestCase):
    def test_of_the_sources(self):
        root = os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2])
        self.assertEqual(find_faults(pathlib.Path(root) / "src"), [])

    def test_a_comparison_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "check.cpp").write_text("    if (scheme == Scheme::radau_5) return;\n")
            self.assertEqual(find_faults(pathlib.Path(folder)), ["check.cpp:1: if (scheme == Scheme::radau_5) return;"])


if __name__ == "__main__":
    unittest.main()
