"""The pages of all examples that have a reference; examples_test.py runs some of them."""

import unittest

import examples_test


class EveryPage(examples_test.Pages):
    def test_pages(self):
        self.check_pages(sorted(reference.parent.name for reference in examples_test.EXAMPLES.glob("*/reference.toml")))


if __name__ == "__main__":
    unittest.main()
