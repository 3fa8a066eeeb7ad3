#!/usr/bin/env python3
"""Checks that no room forgets a kind of load: each list of loads in struct Actions (src/model/model.hpp) is named where a question is
asked of all loads, or has an entry of IRRELEVANT here.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import re
import tempfile
import unittest

QUESTIONS = {
    "model/time/jumps.cpp": "at which times do its functions jump?",
    "study/turned_problem.cpp": "how does it turn with the model?",
    "check/findings/function_examination.cpp": "are the values of its functions numbers?",
    "check/findings/plane_findings.cpp": "does it push out of the plane of a model?",
    "check/findings/buckling_findings.cpp": "does a factor multiply it?",
    "check/model_examination.cpp": "does it load a part of the model?",
    "check/motions/stability.cpp": "has it a potential?",
    "check/motions/turning_loads.cpp": "is it steady in a frame that turns?",
    "check/shape_report.cpp": "what is its name, where it is left out?",
    "check/summaries/condition_summary.cpp": "what does a summary say of it?",
    "report/model/load_arrows.cpp": "what arrows does a page draw?",
    "analyses/shapes/buckling_loads.cpp": "is it left out with the other loads?",
    "check/mesh_frequencies.cpp": "is it left out with the other loads?",
}


def list_loads(text):
    """The names of the lists of loads in struct Actions."""
    body = re.search(r"^struct Actions \{\n(.*?)^\};", text, re.MULTILINE | re.DOTALL).group(1)
    return re.findall(r"std::vector<\w+Load> (\w+);", body)


def find_faults(source):
    """What is asked of all loads, where a list of loads is not named."""
    faults = []
    for name in list_loads((source / "model/model.hpp").read_text(encoding="utf-8")):
        for place, question in QUESTIONS.items():
            if not re.search(rf"\.{name}\b", (source / place).read_text(encoding="utf-8")):
                faults.append(f"{place} does not know {name}: {question}")
    return faults


class Loads(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        self.source = pathlib.Path(os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2])) / "src"

    def test_each_list_is_known_everywhere(self):
        self.assertEqual(find_faults(self.source), [])
        self.assertGreaterEqual(len(list_loads((self.source / "model/model.hpp").read_text(encoding="utf-8"))), 2)

    def test_a_forgotten_list_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder)
            for place in (*QUESTIONS, "model/model.hpp"):
                (copy / place).parent.mkdir(parents=True, exist_ok=True)
                (copy / place).write_text((self.source / place).read_text(encoding="utf-8"), encoding="utf-8")
            model = copy / "model/model.hpp"
            text = model.read_text(encoding="utf-8")
            model.write_text(text.replace("struct Actions {\n", "struct Actions {\n    std::vector<WindLoad> winds;\n"), encoding="utf-8")
            self.assertEqual(len(find_faults(copy)), len(QUESTIONS))


if __name__ == "__main__":
    unittest.main()
