"""gxrod init writes decks that run; gxrod check --watch checks them on each save."""

import subprocess
import time
import unittest

from program import GXROD, ProgramTest

KINDS = ("arm", "blade", "frame", "guidewire", "mechanism", "riser")


class Init(ProgramTest):
    def test_each_deck_is_sound_and_runs(self):
        for kind in KINDS:
            said = self.gxrod("init", kind).stdout
            self.assertEqual(said, f"{kind}.toml: a deck to begin with. Run it: gxrod run {kind}.toml\n")
            self.assertNotIn("error", self.gxrod("check", f"{kind}.toml").stderr)
            self.gxrod("run", f"{kind}.toml")
            self.assertTrue((self.folder / f"{kind}.vtkhdf").exists())

    def test_a_file_is_replaced_only_if_asked(self):
        self.write("frame.toml", "mine")
        self.assertIn("frame.toml: exists already (--force replaces it)", self.gxrod("init", "frame", code=4).stderr)
        self.assertEqual((self.folder / "frame.toml").read_text(), "mine")
        self.gxrod("init", "frame", "-o", "other.toml")
        self.gxrod("init", "frame", "--force")
        self.assertEqual((self.folder / "frame.toml").read_text(), (self.folder / "other.toml").read_text())

    def test_an_unknown_kind_names_those_there_are(self):
        said = self.gxrod("init", "bridge", code=2).stderr
        for kind in KINDS:
            self.assertIn(kind, said)


class Watch(ProgramTest):
    def test_check_watches_the_deck(self):
        self.gxrod("init", "mechanism")
        deck = self.folder / "mechanism.toml"
        text = deck.read_text()
        with open(self.folder / "said", "w") as said:
            watch = subprocess.Popen([GXROD, "check", "--watch", "mechanism.toml"], cwd=self.folder, stdout=said, stderr=said)
            try:
                self.await_text("no errors", 1)
                deck.write_text(text.replace("axis ", "axs "))
                self.await_text("unknown key", 1)
                deck.write_text(text)
                self.await_text("no errors", 2)
            finally:
                watch.kill()
                watch.wait()

    def await_text(self, text, count):
        """Waits until the program has said the text so many times at least."""
        for _ in range(300):
            if (self.folder / "said").read_text().count(text) >= count:
                return
            time.sleep(0.1)
        self.fail((self.folder / "said").read_text())


if __name__ == "__main__":
    unittest.main()
