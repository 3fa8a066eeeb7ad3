#!/usr/bin/env python3
"""Comments in headers of src are sentences, or name a thing: hardly any begins with "Of", "What" or "Those of".

GXROD_SOURCE names the root of the source tree; the default is the tree that this file is in.
"""

import os
import pathlib
import re
import tempfile
import unittest

COMMENT = re.compile(r'^((?:[^"/]|"(?:[^"\\]|\\.)*"|/(?!/))*)//(.*)$')
FRAGMENT = re.compile(r"(of|what|those of|that of)\b", re.IGNORECASE)
MOST_FRAGMENTS = 0.03


def list_comments(text):
    """The comments of a header as (line, text): consecutive lines that are only comment are one."""
    comments, last = [], None
    for number, line in enumerate(text.splitlines(), 1):
        found = COMMENT.match(line)
        if found is None:
            last = None
            continue
        code, words = found[1], found[2].strip()
        place = len(code)
        if not code.strip() and last == place:
            comments[-1][1] += " " + words
        elif not words.startswith(("namespace", "NOLINT")):
            comments.append([number, words])
            last = place
    return comments


def count_fragments(root):
    """How many comments the headers have, and the fragments among them, each as "file:line: text"."""
    count, fragments = 0, []
    for path in sorted((root / "src").rglob("*.hpp")):
        comments = list_comments(path.read_text(encoding="utf-8"))
        count += len(comments)
        fragments += [f"{path.relative_to(root)}:{line}: {text[:70]}" for line, text in comments
                      if FRAGMENT.match(text)]
    return count, fragments


class HeaderWords(unittest.TestCase):
    def test_hardly_any_comment_is_a_fragment(self):
        root = pathlib.Path(os.environ.get("GXROD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
        count, fragments = count_fragments(root)
        self.assertGreater(count, 3000)
        self.assertLess(len(fragments), MOST_FRAGMENTS * count, "\n".join(["", *fragments]))

    def test_fragments_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "src").mkdir()
            (root / "src" / "a.hpp").write_text(
                '// Of the trial motions,\n// what they are.\ndouble energy();\n\n'
                'double length;  // of the rod\nchar slashes[] = "//";\n'
                '    // Computes the energy of a state.\n    // What follows is the same comment.\n'
                'double size;  // in metres\n              // of a body\n'
                '}  // namespace gxrod\n', encoding="utf-8")
            count, fragments = count_fragments(root)
            self.assertEqual(count, 4)
            self.assertEqual([fragment.split(":")[1] for fragment in fragments], ["1", "5"])


if __name__ == "__main__":
    unittest.main()
