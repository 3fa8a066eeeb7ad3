#!/usr/bin/env python3
"""Checks that what a scheme or a kind of joint is, is asked of its card (src/model): no other room compares schemes or kinds. Shapes of
obstacles are visited: outside of contact/ no code asks whether a shape is a certain one, so that a new shape is not forgotten.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import re
import tempfile
import unittest

# Where kinds have names. Of schemes: the cards, the choice of one, what makes integrators, and the study of Rubin's body. Of joints:
# the cards, the equations of each kind, and what decks give.
NAMED = {
    "Scheme": ("model/settings/", "integrators/integrator.cpp", "verification/rubin2007"),
    "JointKind": ("model/ties/joint_card.hpp", "constraints/joints/", "deck/joints/"),
}
COMPARED = re.compile(r"(?:case\s+|[!=]=\s*)(\w+)::\w+")
SHAPE = re.compile(r"\b(?:holds_alternative|get_if|get)<\w+Shape>")
SHAPES_NAMED = ("model/contact.hpp", "contact/")


def find_faults(source):
    """Where a scheme, a kind or a shape is compared outside of these."""
    faults = []
    for path in sorted(source.rglob("*.[ch]pp")):
        name = path.relative_to(source).as_posix()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            kinds = COMPARED.findall(line)
            asks_shape = SHAPE.search(line) and not name.startswith(SHAPES_NAMED)
            if asks_shape or any(kind in NAMED and not name.startswith(NAMED[kind]) for kind in kinds):
                faults.append(f"{name}:{number}: {line.strip()}")
    return faults


class Cards(unittest.TestCase):
    def test_of_the_sources(self):
        root = os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2])
        self.assertEqual(find_faults(pathlib.Path(root) / "src"), [])

    def test_a_comparison_is_found(self):
        for line in ("if (scheme == Scheme::radau_5) return;", "case JointKind::weld:", "if (std::get_if<TubeShape>(&shape)) return;"):
            with tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "check.cpp").write_text(f"    {line}\n")
                self.assertEqual(find_faults(pathlib.Path(folder)), [f"check.cpp:1: {line}"])


if __name__ == "__main__":
    unittest.main()
