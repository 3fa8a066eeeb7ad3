#!/usr/bin/env python3
"""Checks that what pushes a system is one list: only assembly names a contribution, and System stays small.

Rooms above assembly ask for contact by Contacts and StepLimiter, which answer where nothing can touch, and for what a
system is measured by SystemMeasures and SystemValues.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import re
import tempfile
import unittest

NAMED = re.compile(r"\b(ContactAssembly|SurroundingsAssembly|LoadAssembly|contact_assembly_of)\b|"
                   r"\bpublic Contribution\b|assembly/contribution\.hpp|\w_assembly\.hpp|(\.|->)contact\(\)")
ALLOWED = re.compile(r"\bjoint_assembly\.hpp")
MOST_FUNCTIONS = 18


def find_faults(root):
    """Where anything but the assembly names a contribution."""
    faults = []
    for path in sorted(path for top in ("src", "apps") for path in (root / top).rglob("*.[ch]pp")):
        name = path.relative_to(root).as_posix()
        if name.startswith("src/assembly/"):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if NAMED.search(line) and not ALLOWED.search(line):
                faults.append(f"{name}:{number}: {line.strip()}")
    return faults


def list_functions(text):
    """The names of the public functions of class System, without those that make and end it."""
    body = re.search(r"^class System \{\n  public:\n(.*?)^  private:", text, re.MULTILINE | re.DOTALL).group(1)
    body = re.sub(r"//.*", "", body)
    heads = re.findall(r"^    (?!explicit|System|~)[\w:<>&*, ]+?[ &*](\w+)\(", body, re.MULTILINE)
    return [name for name in heads if name != "operator"]


class Contributions(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))

    def test_the_rooms_above_assembly_name_none(self):
        self.assertEqual(find_faults(self.root), [])

    def test_system_has_few_functions(self):
        functions = list_functions((self.root / "src/assembly/system.hpp").read_text(encoding="utf-8"))
        self.assertIn("compute_residual", functions)
        self.assertLessEqual(len(functions), MOST_FUNCTIONS, functions)

    def test_functions_are_counted_over_several_lines(self):
        text = ("class System {\n  public:\n    explicit System(const Model& model);\n    ~System();\n"
                "    System& operator=(const System&) = delete;\n"
                "    const Model& model() const { return *model_; }\n    // commit(State) is next.\n"
                "    void commit(State& state,\n                double time) const;\n  private:\n    void build();\n};\n")
        self.assertEqual(list_functions(text), ["model", "commit"])

    def test_each_name_is_found_and_the_assembly_may_use_it(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, line in (
                ("src/solvers/newton.cpp", "    const ContactAssembly* contact_;"),
                ("src/check/stability.cpp", '#include "assembly/contact/contact_assembly.hpp"'),
                ("src/analyses/static.cpp", "    return !system_.contact() && is_first;"),
                ("src/run/summary.cpp", "    if (contact_assembly_of(system)) return;"),
                ("src/run/water.cpp", '#include "assembly/surroundings_assembly.hpp"'),
                ("apps/gxrod/run.cpp", "class Magnets : public Contribution {"),
                ("src/run/joints.cpp", '#include "assembly/joints/joint_assembly.hpp"'),
                ("src/assembly/system.cpp", "    const ContactAssembly* contact_;"),
            ):
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(line + "\n", encoding="utf-8")
            found = [fault.split(":")[0] for fault in find_faults(root)]
        self.assertEqual(found, ["apps/gxrod/run.cpp", "src/analyses/static.cpp", "src/check/stability.cpp",
                                 "src/run/summary.cpp", "src/run/water.cpp", "src/solvers/newton.cpp"])


if __name__ == "__main__":
    unittest.main()
