"""Which signs and coefficients tests/mutation makes wrong, and how."""

import os
import pathlib
import sys
import unittest

SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])
sys.path.insert(0, str(SOURCE / "tests" / "mutation"))
from sites import apply, change_digit, find_sites  # noqa: E402 — after the path to it

CODE = """#include <a-b>
// a + b in words, 0.5 of them
template <int N = 1 - 2>
double f(double a, double b) {
    static_assert(1 + 1 == 2);
    const char* text = "a + 0.5";
    double sum = -a + 0.25 * b;
    sum -= b;
    g(-sum, {-1e-3, a -
                        b});
    return -sum;
}
"""


class MutationSites(unittest.TestCase):
    def setUp(self):
        self.sites = find_sites("f.cpp", CODE)

    def changed(self, index):
        return apply(CODE, [self.sites[index]], lambda site: site.replaced)

    def test_each_sign_and_coefficient_of_the_code_is_found_once(self):
        self.assertEqual([(site.line, site.kind, CODE[site.start:site.end]) for site in self.sites],
                         [(7, "sign", "-"), (7, "sign", "+"), (7, "coefficient", "0.25"), (8, "sign", "-="), (9, "sign", "-"),
                          (9, "sign", "-"), (9, "coefficient", "1e-3"), (9, "sign", "-"), (11, "sign", "-")])

    def test_what_stands_there_instead(self):
        self.assertIn("double sum = a + 0.25 * b;", self.changed(0))
        self.assertIn("double sum = -a - 0.25 * b;", self.changed(1))
        self.assertIn("double sum = -a + 0.26 * b;", self.changed(2))
        self.assertIn("sum += b;", self.changed(3))
        self.assertIn("{-2e-3, a", self.changed(6))
        self.assertIn("a +\n                        b});", self.changed(7))
        self.assertIn("return sum;", self.changed(8))

    def test_switches_keep_the_code_as_it_is(self):
        switched = apply(CODE, self.sites, lambda site: site.switched.replace("MUTANT", "7"))
        self.assertIn("double sum = -gxrod_sign(7) * a + gxrod_sign(7) * gxrod_coefficient(7, 0.25, 0.26) * b;", switched)
        self.assertIn("sum -= gxrod_sign(7) * b;", switched)
        self.assertIn("// a + b in words, 0.5 of them\n", switched)

    def test_coefficients_are_changed_where_it_matters(self):
        self.assertEqual([change_digit(number) for number in ("0.5", "2.0", "1.", "1e-3", "9.0", "39.4784176043574344753",
                                                              "5.6373702828768453026e-7", "0.00010564110705334699024")],
                         ["0.6", "2.1", "1.1", "2e-3", "9.1", "39.4794176043574344753", "5.6374702828768453026e-7",
                          "0.00010565110705334699024"])


if __name__ == "__main__":
    unittest.main()
