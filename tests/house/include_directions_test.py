#!/usr/bin/env python3
"""Checks which rooms of src include which, as docs/architecture.md draws them.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import re
import tempfile
import unittest

# Each room and the rooms that it may include directly; it may also include whatever those may.
DIRECT = {
    "numerics": [],
    "parallel": [],
    "machine": [],
    "rotation": [],
    "model": ["rotation", "numerics", "cross_section"],
    "cross_section": ["rotation", "numerics"],
    "laws": ["model"],
    "environment": ["model", "machine"],
    "state": ["model"],
    "elements": ["state", "numerics", "machine"],
    "loads": ["state", "numerics", "environment"],
    "constraints": ["state", "numerics"],
    "contact": ["model", "numerics"],
    "linear": ["model", "parallel", "machine"],
    "integrators": ["state", "parallel"],
    "assembly": ["elements", "loads", "constraints", "contact", "linear"],
    "solvers": ["assembly", "integrators"],
    "check": ["solvers", "cross_section"],
    "geometry": ["rotation", "numerics"],
    "mesh": ["model", "geometry", "machine", "cross_section"],
    "watch": ["state", "cross_section", "environment"],
    "deck": ["watch", "mesh", "laws", "environment"],
    "results": ["watch", "machine"],
    "analyses": ["check"],
    "sensitivity": ["analyses"],
    "run": ["analyses", "results"],
    "face": ["run", "deck", "sensitivity"],
    "batch": ["run", "deck"],
    "report": ["loads", "results", "deck"],
    "study": ["run", "deck"],
    "verification": ["study"],
    "apps": ["verification", "report", "face"],
}
# Rooms that a room may include without what those include.
ALONE = {"report": ["batch"]}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([a-z_0-9]+)/[^"]*"')
SOURCES = (".cpp", ".hpp", ".h", ".in")


def rooms_allowed(room):
    """The room itself and every room below it."""
    allowed = {room}
    for below in DIRECT[room]:
        allowed |= rooms_allowed(below)
    return allowed | set(ALONE.get(room, []))


def room_of(path, root):
    parts = path.relative_to(root).parts
    return "apps" if parts[0] == "apps" else parts[1]


def find_breaches(root):
    """One line "file:line: …" for each include against the plan, and for each room that the plan does not know."""
    breaches = []
    files = [path for top in ("src", "apps") for path in sorted((root / top).rglob("*")) if path.suffix in SOURCES]
    for path in files:
        name = path.relative_to(root)
        room = room_of(path, root)
        if room not in DIRECT:
            breaches.append(f"{name}:1: room {room} is not in the plan")
            continue
        allowed = rooms_allowed(room)
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            match = INCLUDE.match(line)
            if match and match.group(1) not in allowed:
                breaches.append(f"{name}:{number}: {room} may not include {match.group(1)}")
    return breaches


def source_root():
    return pathlib.Path(os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))


class IncludeDirections(unittest.TestCase):
    def test_rooms_include_only_what_lies_below_them(self):
        self.assertEqual(find_breaches(source_root()), [])

    def test_tests_include_catch_by_the_header_that_knows_its_versions(self):
        tests = source_root() / "tests"
        own = {tests / "tools" / "catch.hpp", tests / "main.cpp"}
        direct = [path.relative_to(tests) for path in tests.rglob("*.[ch]pp")
                  if path not in own and "<catch2/" in path.read_text(encoding="utf-8")]
        self.assertEqual(direct, [])

    def test_every_room_is_seen(self):
        rooms = {path.name for path in (source_root() / "src").iterdir() if path.is_dir()}
        self.assertGreaterEqual(rooms, {"rotation", "model", "state", "elements", "linear", "assembly", "solvers", "analyses"})
        self.assertLessEqual(rooms, set(DIRECT))


class PlantedBreaches(unittest.TestCase):
    """The check itself, on small trees."""

    def breaches_of(self, **files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                path = root / name.replace("__", "/").replace("_hpp", ".hpp").replace("_cpp", ".cpp")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return find_breaches(root)

    def test_a_breach_is_named_by_file_and_line(self):
        breaches = self.breaches_of(
            src__rotation__spin_hpp='#pragma once\n\n#include <vector>\n#include "state/motion.hpp"\n')
        self.assertEqual(breaches, ["src/rotation/spin.hpp:4: rotation may not include state"])

    def test_elements_and_integrators_do_not_see_each_other(self):
        breaches = self.breaches_of(
            src__integrators__scheme_cpp='#include "elements/element.hpp"\n',
            src__elements__rod__beam_cpp='#include "integrators/integrator.hpp"\n')
        self.assertEqual(len(breaches), 2)

    def test_rooms_at_the_end_of_a_chain_are_allowed(self):
        breaches = self.breaches_of(
            src__run__run_cpp='#include "rotation/types.hpp"\n#include "results/file.hpp"\n',
            src__solvers__newton_cpp='#  include "integrators/integrator.hpp"\n',
            apps__gxrod__run_cpp='#include "verification/study.hpp"\n#include "deck/reader.hpp"\n')
        self.assertEqual(breaches, [])

    def test_nothing_includes_the_programs_and_analyses_and_results_do_not_see_each_other(self):
        breaches = self.breaches_of(
            src__verification__study_cpp='#include "apps/gxrod/verbs.hpp"\n',
            src__results__file_cpp='#include "analyses/dynamic.hpp"\n',
            src__analyses__dynamic_cpp='#include "results/file.hpp"\n')
        self.assertEqual(len(breaches), 3)

    def test_reports_see_results_but_no_analysis(self):
        breaches = self.breaches_of(
            src__report__page_cpp='#include "run/run.hpp"\n#include "results/file.hpp"\n#include "batch/table.hpp"\n',
            src__analyses__run_cpp='#include "report/report.hpp"\n')
        self.assertEqual(len(breaches), 2)

    def test_an_unknown_room_is_named(self):
        breaches = self.breaches_of(src__utils__misc_hpp="#pragma once\n")
        self.assertEqual(breaches, ["src/utils/misc.hpp:1: room utils is not in the plan"])

    def test_comments_and_own_headers_do_not_count(self):
        breaches = self.breaches_of(
            src__rotation__spin_cpp='// #include "state/motion.hpp"\n#include "spin.hpp"\n#include "rotation/spin.hpp"\n')
        self.assertEqual(breaches, [])


if __name__ == "__main__":
    unittest.main()
