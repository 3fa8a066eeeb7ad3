#!/usr/bin/env python3
"""Checks that code on ties that are elements visits their lists (src/model/ties/ties.hpp) and does not name the list of one kind, so that
a new kind is not forgotten. ALONE lists the questions that concern one kind.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import re
import tempfile
import unittest

HOMES = ("model/ties/", "deck/ties/")
ALONE = {
    "analyses/shapes/response.cpp": "which bushings are supports, whose forces are reactions?",
    "analyses/stepped_analysis.cpp": "has a spring shrunk to nothing?",
    "check/findings/buckling_findings.cpp": "is a spring taut at t = 0, which a factor leaves out?",
    "check/findings/bushing_findings.cpp": "does a bushing leave a turn free?",
    "check/findings/plane_findings.cpp": "can a bushing push out of the plane?",
    "check/motions/spinning_parts.cpp": "is a bushing alike to all sides of what spins?",
    "check/motions/turning_ties.cpp": "is a spring or a bushing alike to all sides of an axis?",
    "deck/supports/support_table.cpp": "which bushings are supports that yield?",
    "face/own_laws.cpp": "which spring gets a law of the program?",
    "model/displaced_start.cpp": "which springs keep their elongation where the start is displaced?",
    "study/turned_problem.cpp": "how do the axes of a bushing turn?",
}


def list_elements(source):
    """The names of the model's lists of ties that are elements."""
    text = (source / "model/ties/ties.hpp").read_text(encoding="utf-8")
    lists = re.search(r"return std::tie\((.*?)\);", text, re.DOTALL).group(1)
    return re.findall(r"model\.(\w+)", lists.split("model.joints")[0])


def find_faults(source):
    """The places that name the list of one kind, and those of ALONE that do not."""
    named = re.compile(rf"\.({'|'.join(list_elements(source))})\b")
    paths = {path.relative_to(source).as_posix(): path for path in sorted(source.rglob("*.[ch]pp"))}
    naming = {name for name, path in paths.items() if not name.startswith(HOMES) and named.search(path.read_text(encoding="utf-8"))}
    return sorted(naming ^ set(ALONE))


class Ties(unittest.TestCase):
    def test_lists_of_one_kind_are_named_where_one_kind_is_asked(self):
        source = pathlib.Path(os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2])) / "src"
        self.assertGreaterEqual(set(list_elements(source)), {"springs", "bushings"})
        self.assertEqual(find_faults(source), [])

    def test_a_list_that_is_named_elsewhere_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder)
            files = {name: "model.springs" for name in ALONE}
            files["model/ties/ties.hpp"] = "return std::tie(model.springs, model.joints);"
            files["assembly/system.cpp"] = "for (const Spring& spring : model.springs)"
            for name, text in files.items():
                (source / name).parent.mkdir(parents=True, exist_ok=True)
                (source / name).write_text(text, encoding="utf-8")
            self.assertEqual(find_faults(source), ["assembly/system.cpp"])


if __name__ == "__main__":
    unittest.main()
