"""What gxrod says on a terminal: sentences are broken between words; what goes elsewhere stays as it is."""

import fcntl
import os
import pty
import struct
import subprocess
import termios
import unittest

from program import GXROD, ProgramTest

DECK = """[section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 20, EIy = 20, EIz = 40 }
[rod.arm]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 2
an_unknown_key_of_a_long_name = 1
[analysis]
kind = "static"
steps = 1
"""


class Terminal(ProgramTest):
    def say(self, columns, *words):
        """What a terminal of so many columns gets on standard error."""
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        done = subprocess.Popen([GXROD, *words], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        text = b""
        while True:
            try:
                piece = os.read(ours, 4096)
            except OSError:  # its other end is closed
                break
            if not piece:
                break
            text += piece
        done.wait()
        os.close(ours)
        return text.decode().replace("\r\n", "\n")

    def test_sentences_are_broken_between_words(self):
        self.write("deck.toml", DECK)
        plain = subprocess.run([GXROD, "check", "deck.toml"], cwd=self.folder, capture_output=True, text=True, check=False).stderr
        self.assertGreater(max(map(len, plain.splitlines())), 60)
        for columns in (60, 80):
            said = self.say(columns, "check", "deck.toml")
            self.assertLess(max(map(len, said.splitlines())), columns)
            self.assertEqual(said.split(), plain.split())
            self.assertTrue(any(line.startswith("  ") for line in said.splitlines()))

    def test_a_wide_terminal_and_a_very_narrow_one_change_nothing(self):
        self.write("deck.toml", DECK)
        plain = subprocess.run([GXROD, "check", "deck.toml"], cwd=self.folder, capture_output=True, text=True, check=False).stderr
        for columns in (1000, 15, 0):
            self.assertEqual(self.say(columns, "check", "deck.toml"), plain)


if __name__ == "__main__":
    unittest.main()
