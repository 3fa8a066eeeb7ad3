"""gxrod where what it says cannot be printed, or threads cannot be had."""

import os
import resource
import subprocess
import unittest

from program import GXROD, SPINNING_BODY, ProgramTest


class Unprintable(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("body.toml", SPINNING_BODY)

    def full(self):
        device = open("/dev/full", "w", encoding="utf-8")
        self.addCleanup(device.close)
        return device

    def run_full(self, *arguments, code, stdout=False, stderr=False):
        """Runs with one of the streams to a full disk; returns what the other one got."""
        done = subprocess.run([GXROD, *arguments], cwd=self.folder, text=True, check=False, timeout=300,
                              stdout=self.full() if stdout else subprocess.PIPE,
                              stderr=self.full() if stderr else subprocess.PIPE)
        self.assertEqual(done.returncode, code, (done.stdout, done.stderr))
        return done.stdout if stderr else done.stderr

    def test_output_that_is_lost_is_a_file_error(self):
        lost = "gxrod: standard output cannot be written: No space left on device\n"
        self.assertEqual(self.run_full("schema", stdout=True, code=4), lost)
        self.assertEqual(self.run_full("--help", stdout=True, code=4), lost)
        self.assertEqual(self.run_full("run", "body.toml", "--summary", "-", stdout=True, code=4), lost)
        self.assertTrue((self.folder / "body.vtkhdf").exists())

    def test_a_message_that_is_lost_changes_no_exit_code(self):
        self.run_full("run", "missing.toml", stderr=True, code=4)
        self.write("faulty.toml", SPINNING_BODY.replace("mass = 2.0", "mas = 2.0"))
        self.run_full("run", "faulty.toml", stderr=True, code=2)
        self.run_full("run", "body.toml", stderr=True, code=0)

    def test_threads_that_cannot_be_started_are_reported(self):
        if os.environ.get("GXROD_SANITIZED") == "1":
            self.skipTest("the sanitizers need memory themselves")

        def limit_memory():
            # Each thread takes 8 MB for its stack.
            resource.setrlimit(resource.RLIMIT_STACK, (8 << 20, 8 << 20))
            resource.setrlimit(resource.RLIMIT_AS, (300 << 20, 300 << 20))

        done = self.gxrod("run", "body.toml", "--threads", "200", "--quiet", code=1, preexec_fn=limit_memory)
        self.assertRegex(done.stderr, r"^gxrod: only \d+ of 200 threads can be had: Resource temporarily unavailable\n$")


if __name__ == "__main__":
    unittest.main()
