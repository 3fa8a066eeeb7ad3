"""gxrod import is the program gxrod-import, which stands beside gxrod."""

import unittest

from program import ProgramTest


class Import(ProgramTest):
    def test_a_verb_can_be_a_program_beside(self):
        self.assertIn("usage: gxrod-import", self.gxrod("import", "--help").stdout)
        self.assertIn("gxrod import", self.gxrod("--help").stdout)

    def test_its_exit_code_is_that_of_gxrod(self):
        self.assertIn("gxrod-import: absent.dat: cannot be read", self.gxrod("import", "absent.dat", code=4).stderr)

    def test_other_verbs_are_refused(self):
        self.assertIn("gxrod has no verb 'chek'", self.gxrod("chek", code=2).stderr)
        self.assertIn("gxrod has no verb '../gxrod'", self.gxrod("../gxrod", code=2).stderr)


if __name__ == "__main__":
    unittest.main()
