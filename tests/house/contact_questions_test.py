#!/usr/bin/env python3
"""Checks that rooms above assembly ask for contact by Contacts and StepLimiter, which answer where nothing can touch.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import re
import tempfile
import unittest

ASKED = re.compile(r"\bContactAssembly\b|contact_assembly\.hpp|(\.|->)contact\(\)")


def find_faults(root):
    """Where anything but the assembly names ContactAssembly or asks System::contact."""
    faults = []
    for path in sorted(path for top in ("src", "apps") for path in (root / top).rglob("*.[ch]pp")):
        name = path.relative_to(root).as_posix()
        if name.startswith("src/assembly/"):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if ASKED.search(line):
                faults.append(f"{name}:{number}: {line.strip()}")
    return faults


class ContactQuestions(unittest.TestCase):
    def test_the_rooms_above_assembly_do_not_name_it(self):
        root = os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2])
        self.assertEqual(find_faults(pathlib.Path(root)), [])

    def test_each_name_is_found_and_the_assembly_may_use_it(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, line in (
                ("src/solvers/newton.cpp", "    const ContactAssembly* contact_;"),
                ("src/check/stability.cpp", '#include "assembly/contact/contact_assembly.hpp"'),
                ("src/analyses/static.cpp", "    return !system_.contact() && is_first;"),
                ("apps/gxrod/run.cpp", "    if (system->contact()) return;"),
                ("src/assembly/system.cpp", "    const ContactAssembly* contact_;"),
            ):
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(line + "\n", encoding="utf-8")
            found = [fault.split(":")[0] for fault in find_faults(root)]
        self.assertEqual(found, ["apps/gxrod/run.cpp", "src/analyses/static.cpp", "src/check/stability.cpp",
                                 "src/solvers/newton.cpp"])


if __name__ == "__main__":
    unittest.main()
