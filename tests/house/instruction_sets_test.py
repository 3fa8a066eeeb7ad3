#!/usr/bin/env python3
"""What a source that is compiled for one instruction set gives the linker must be named after that set.

Anything else, say a function of the standard library that was not inlined, could be taken for the whole program, which
then would not run on machines without the set. GXROD_LIBRARY names the static library; of a Release build, since others
inline little.
"""

import os
import re
import subprocess
import unittest

LIBRARY = os.environ.get("GXROD_LIBRARY")
OWN = {"avx2": "avx2", "avx512": "avx512"}  # what the names of a set's symbols hold


@unittest.skipIf(os.environ.get("GXROD_SANITIZED") == "1", "without inlining there are too many such functions")
class InstructionSets(unittest.TestCase):
    def test_symbols_carry_their_set(self):
        listing = subprocess.run(["nm", "--demangle", LIBRARY], text=True, capture_output=True, check=True).stdout
        objects = re.findall(r"^\S*_lanes_(\w+)\.cpp\.o:\n((?:.+\n)*)", listing, re.MULTILINE)
        self.assertEqual({name for name, _ in objects}, {"baseline", *OWN})
        for name, symbols in objects:
            if name not in OWN:
                continue
            shared = re.findall(r"^\w+ [TW] (.*)$", symbols, re.MULTILINE)
            self.assertGreater(len(shared), 2)
            for symbol in shared:
                self.assertIn(OWN[name], symbol)


if __name__ == "__main__":
    unittest.main()
