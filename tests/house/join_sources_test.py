#!/usr/bin/env python3
"""Checks which sources cmake/join-sources lets be compiled as one.

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))


def group(**texts):
    """The names of the sources of each group, of sources with these texts."""
    with tempfile.TemporaryDirectory() as folder:
        paths = {pathlib.Path(folder, f"{name}.cpp"): name for name in texts}
        for path, name in paths.items():
            path.write_text(texts[name], encoding="utf-8")
        run = subprocess.run([ROOT / "cmake" / "join-sources", *paths], capture_output=True, text=True, check=True)
    groups = {}
    for line in run.stdout.splitlines():
        number, path = line.split(" ", 1)
        groups.setdefault(number, []).append(paths[pathlib.Path(path)])
    return list(groups.values())


def hide(text):
    return "namespace gxrod {\nnamespace {\n" + text + "\n}\n}\n"


class Groups(unittest.TestCase):
    def assert_apart(self, one, other):
        self.assertEqual(group(a=one, b=other), [["a"], ["b"]])
        self.assertEqual(group(a=other, b=one), [["a"], ["b"]])

    def assert_together(self, one, other):
        self.assertEqual(group(a=one, b=other), [["a", "b"]])

    def test_sources_with_nothing_of_their_own_are_together(self):
        self.assert_together("int f() { int local = 1; return local; }", "int g() { int local = 2; return local; }")

    def test_a_name_of_an_unnamed_namespace_occurs_in_no_other_source(self):
        uses = "namespace gxrod { void use(int own) {} }"
        for declaration in ("int own(double x) { return 1; }",
                            "std::vector<int> own(const std::array<int, 3>& x = {1, 2}) { return {}; }",
                            "template <int Nodes>\nstruct own { int x; };",
                            "class own final : public Base {};",
                            "enum class own : int { one };",
                            "constexpr double own = 1e-3;",
                            "constexpr double first = 1e-3, own = 2.0, last = first;",
                            "const Section own = make({1, 2}, [](int x) { return x; });",
                            "const Vec3 own(1, 2, 3);",
                            "int own[3];",
                            "using own = int;",
                            "namespace own = std::filesystem;",
                            "const char* text = R\"({{{)\"; const char brace = '{'; int own();"):
            with self.subTest(declaration):
                self.assert_apart(hide(declaration), uses)
                self.assert_apart("namespace {\n" + declaration + "\n}\n", uses)

    def test_what_only_a_function_declares_is_not_a_name_of_its_source(self):
        self.assert_together(hide("int f() { int own = 1; if (own) { own = 2; } return own; }"),
                             "int g(int own) { return own; }")

    def test_aliases_statics_and_macros_are_names_of_their_source(self):
        uses = "int use(own x);"
        for declaration in ("using own = int;", "namespace own = std::filesystem;", "namespace gxrod { using other::own; }",
                            "static int own() { return 1; }", "#define own 1"):
            with self.subTest(declaration):
                self.assert_apart(declaration, uses)

    def test_a_name_that_both_import_is_the_same(self):
        self.assert_together("using other::own;\nint f(own x);", "using other::own;\nint g(own x);")
        self.assert_apart("using other::own;\nint f(own x);", "using another::own;\nint g(own x);")
        self.assert_apart("using other::own;", "int g(own x);")

    def test_members_and_names_of_libraries_are_not_hidden(self):
        for use in ("x.own()", "x->own()", "std::own()"):
            with self.subTest(use):
                self.assert_together(hide("int own() { return 1; }"), "int g(X x) { return " + use + "; }")
                self.assert_apart("#define own 1", "int g(X x) { return " + use + "; }")
        self.assert_apart(hide("int own() { return 1; }"), "int g() { return gxrod::own(); }")

    def test_words_of_comments_and_literals_do_not_count(self):
        self.assert_together(hide("int own() { return 1; }"), '// own\n/* own */ const char* text = "own";')

    def test_using_directives_are_alike_in_a_group(self):
        self.assert_apart("using namespace std::literals;\nint f();", "int g();")
        self.assert_together("using namespace gxrod;\nint f();", "using namespace gxrod;\nint g();")

    def test_kept_groups_change_only_where_they_must(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)

            def sort_into_groups(**texts):
                for stem, text in texts.items():
                    (folder / f"{stem}.cpp").write_text(text, encoding="utf-8")
                paths = [folder / f"{stem}.cpp" for stem in texts]
                run = subprocess.run([ROOT / "cmake" / "join-sources", "--keep", folder / "groups", *paths],
                                     capture_output=True, text=True, check=True)
                groups = {}
                for line in run.stdout.splitlines():
                    number, path = line.split(" ", 1)
                    groups.setdefault(number, []).append(pathlib.Path(path).stem)
                return list(groups.values())

            many = {f"s{i:02}": "" for i in range(30)}
            first = sort_into_groups(**many)
            # A source that sorts first comes last, into a group with room.
            self.assertEqual(sort_into_groups(a="", **many), [first[0], [*first[1], "a"]])
            # One that goes leaves the others where they are; one that no longer can stay goes elsewhere.
            del many["s03"]
            many["s05"] = hide("int own() { return 1; }")
            many["s06"] = "int g() { return own(); }"
            self.assertEqual(sort_into_groups(**many),
                             [[stem for stem in first[0] if stem not in ("s03", "s06")], [*first[1], "s06"]])

    def test_groups_have_an_end(self):
        sizes = [len(names) for names in group(**{f"s{i}": "" for i in range(30)})]
        self.assertEqual(sizes, [16, 14])


if __name__ == "__main__":
    unittest.main()
