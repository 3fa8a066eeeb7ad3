"""gxrod run: results, summary, messages and exit codes."""

import hashlib
import json
import os
import signal
import subprocess
import time
import unittest

import h5py
import numpy as np

from program import GXROD, SPINNING_BODY, ProgramTest, limit_file_size


FALLING_TAPE = """gravity = [0, 0, -9.81]
[section.s]
stiffness = { EA = 300.0, GAy = 100.0, GAz = 100.0, GJ = 8e-3, EIy = 4e-3, EIz = 4e4 }
inertia = { rhoA = 0.08, rhoIy = 5e-7, rhoIz = 5e-7 }
[rod.tape]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
y_axis = [0, 1, 0]
elements = 10
order = 2
[[support]]
at = "tape.start"
fix = "all"
[[load]]
at = "tape.end"
force = [0, 0.02, 0]
[analysis]
kind = "dynamic"
end_time = 0.6
time_step = 4e-3
integrator = "generalized-alpha"
"""

LONG_ROD = """gravity = [0, 0, -9.81]
[section.s]
shape = { circle = { radius = 0.02 } }
material = { E = 1e7, nu = 0.5, density = 1000 }
[rod.hose]
section = "s"
line = { from = [0, 0, 0], to = [3, 0, 0] }
elements = 900
[[support]]
at = "hose.start"
fix = "all"
[analysis]
kind = "dynamic"
end_time = 0.05
time_step = 0.01
[[history]]
name = "tip"
at = "hose.end"
quantities = ["position", "moment", "acceleration"]
"""


class Run(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("body.toml", SPINNING_BODY)

    def test_an_instruction_set_that_there_is_not_is_a_usage_error(self):
        done = subprocess.run([GXROD, "run", "body.toml"], cwd=self.folder, text=True, capture_output=True, check=False,
                              env={**os.environ, "GXROD_INSTRUCTION_SET": "avx9"})
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.splitlines()[0],
                         'gxrod: GXROD_INSTRUCTION_SET: expected "baseline", "avx2" or "avx512"')

    def test_threads_change_no_bit_of_the_results(self):
        # Long enough for every loop to be shared.
        self.write("hose.toml", LONG_ROD)
        files = []
        for threads in ("1", "2", "3"):
            done = self.gxrod("run", "hose.toml", "--threads", threads, "-o", f"{threads}.vtkhdf", "--summary", "-")
            self.assertEqual(json.loads(done.stdout)["threads"], int(threads))
            files.append(h5py.File(self.folder / f"{threads}.vtkhdf"))
        names = []
        files[0].visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
        # The state to resume from depends on when it was written last.
        names = [name for name in names if not name.startswith("restart/")]
        self.assertGreater(len(names), 20)
        for name in names:
            for other in files[1:]:
                np.testing.assert_array_equal(files[0][name][()], other[name][()], err_msg=name)
        for file in files:
            file.close()

    def test_a_number_of_threads_that_there_cannot_be_is_a_usage_error(self):
        for threads in ("0", "-1", "two", "5000"):
            done = self.gxrod("run", "body.toml", "--threads", threads, code=2)
            self.assertIn("--threads", done.stderr)
            self.assertFalse((self.folder / "body.vtkhdf").exists())

    def test_warns_of_more_threads_than_cores(self):
        core = min(os.sched_getaffinity(0))
        one_core = {"preexec_fn": lambda: os.sched_setaffinity(0, [core])}
        self.assertEqual(self.gxrod("run", "body.toml", "--threads", "1", "-o", "one.vtkhdf", **one_core).stderr, "")
        done = self.gxrod("run", "body.toml", "--threads", "3", **one_core)
        self.assertEqual(done.stderr, "note: --threads 3: with 1 core they slow each other down\n")

    def test_leaves_results_under_the_name_of_the_deck(self):
        done = self.gxrod("run", "body.toml")
        self.assertIn("100 steps to t = 1", done.stdout)
        with h5py.File(self.folder / "body.vtkhdf") as file:
            self.assertEqual(file.attrs["status"], b"complete" if isinstance(file.attrs["status"], bytes) else "complete")
            self.assertEqual(len(file["histories/time"]), 101)
            self.assertEqual(file["histories/spin/angular_velocity"].shape, (101, 3))
            self.assertEqual(len(file["VTKHDF/Steps/Values"]), 11)
            self.assertAlmostEqual(file["histories/time"][-1], 1.0)
            # The angular momentum is the impulse of the torque.
            momentum = file["ledger/angular_momentum"][:]
            np.testing.assert_allclose(momentum[-1], [0.5 * (1 - np.cos(1.0)), 0.0, 2.25], atol=1e-4)

    def test_summary_has_every_key(self):
        done = self.gxrod("run", "body.toml", "--summary", "-")
        summary = json.loads(done.stdout)
        self.assertEqual(
            sorted(summary),
            sorted("status reason warnings deck results nodes elements unknowns integrator steps rejected_steps cuts newton_limit "
                   "findings found newton_iterations time wall_seconds threads version".split()))
        self.assertEqual(sorted(summary["wall_seconds"]),
                         sorted("total setup assembly solve update output".split()))
        self.assertEqual((summary["status"], summary["steps"], summary["time"]), ("complete", 100, 1.0))
        self.assertEqual((summary["nodes"], summary["elements"], summary["unknowns"]), (1, 1, 6))
        self.gxrod("run", "body.toml", "--force", "--summary", "summary.json", "--quiet")
        self.assertEqual(json.loads((self.folder / "summary.json").read_text())["status"], "complete")

    def test_an_integrator_that_is_left_open_is_printed_and_kept(self):
        done = self.gxrod("run", "body.toml", "--set", "analysis.integrator=auto")
        self.assertTrue(done.stdout.startswith("integrator auto takes radau-5: for bodies\n"), done.stdout)
        with h5py.File(self.folder / "body.vtkhdf") as file:
            self.assertEqual(file.attrs["integrator"], "radau-5")
        chosen = self.gxrod("run", "body.toml", "--set", "analysis.integrator=auto", "--force", "--summary", "-")
        self.assertEqual(json.loads(chosen.stdout)["integrator"], "radau-5")
        self.assertNotIn("integrator", self.gxrod("run", "body.toml", "--force").stdout)
        self.assertIn("dynamic analysis: radau-5 (auto: for bodies), 100 steps of 0.01",
                      self.gxrod("check", "body.toml", "--set", "analysis.integrator=auto").stdout)

    def test_cut_steps_are_summed_up_at_the_end(self):
        self.write("tape.toml", FALLING_TAPE)
        consistent = ("--set", "analysis.newton.tangent=\"consistent\"", "--force", "--summary", "summary.json")
        done = self.gxrod("run", "tape.toml", *consistent)
        cuts = json.loads((self.folder / "summary.json").read_text())["cuts"]
        self.assertRegex(cuts, "^[0-9]+ of 150 steps were cut, [0-9]+ times in all: one element's nodes turned against "
                               "each other by half a turn \\([0-9]+ times, mostly at tape")
        self.assertIn("; rod tape is 1e+07 times as stiff in bending about z as in bending about y. Try newton.tangent "
                      '= "mixed", which converges in longer steps, or a smaller time_step.', cuts)
        self.assertIn(f"warning: {cuts}\n", done.stderr)
        with h5py.File(self.folder / "tape.vtkhdf") as file:
            self.assertIn(f", {file['solver/rejected_steps'][:].sum()} times in all:", cuts)
        listed = json.loads((self.folder / "summary.json").read_text())["warnings"]
        self.assertIn(cuts, listed)
        self.assertEqual(self.gxrod("run", "tape.toml", *consistent, "--quiet").stderr,
                         "".join(f"warning: {one}\n" for one in listed))
        page = self.report_text("tape.vtkhdf")
        self.assertIn(cuts[:cuts.index(": one element's")], page)
        done = self.gxrod("run", "tape.toml", "--force", "--summary", "summary.json")
        self.assertEqual(json.loads((self.folder / "summary.json").read_text())["cuts"], "")
        self.assertNotIn("cut", done.stderr)
        self.assertIn("note: rod tape is 1e+07 times as stiff in bending about z as in bending about y; newton.tangent "
                      'is "mixed"', self.gxrod("check", "tape.toml").stdout)

    def report_text(self, results):
        self.gxrod("report", results, "-o", "page.html")
        return (self.folder / "page.html").read_text()

    def test_an_unwritable_summary_is_a_file_error(self):
        self.gxrod("run", "body.toml", "--summary", "missing/summary.json", code=4)

    def test_quiet_says_nothing(self):
        done = self.gxrod("run", "body.toml", "--quiet")
        self.assertEqual(done.stdout + done.stderr, "")

    def test_overrides_change_the_deck_that_is_kept(self):
        self.gxrod("run", "body.toml", "--set", "analysis.steps=50", "--set", "parameters.torque=1.5")
        with h5py.File(self.folder / "body.vtkhdf") as file:
            self.assertEqual(len(file["histories/time"]), 51)
            kept = file["deck/text"][()].decode()
        self.write("kept.toml", kept)
        self.gxrod("run", "kept.toml")
        with h5py.File(self.folder / "kept.vtkhdf") as again, h5py.File(self.folder / "body.vtkhdf") as first:
            self.assertTrue(np.array_equal(first["ledger/angular_momentum"], again["ledger/angular_momentum"]))

    def test_the_deck_is_kept_word_by_word(self):
        self.gxrod("run", "body.toml")
        with h5py.File(self.folder / "body.vtkhdf") as file:
            self.assertEqual(file["deck/text"][()].decode(), SPINNING_BODY)
            digest = file.attrs["deck_sha256"]
        digest = digest.decode() if isinstance(digest, bytes) else digest
        self.assertEqual(digest, hashlib.sha256(SPINNING_BODY.encode()).hexdigest())

    def test_the_same_deck_gives_the_same_bits(self):
        for name in ("one", "two"):
            self.gxrod("run", "body.toml", "-o", f"{name}.vtkhdf")
        with h5py.File(self.folder / "one.vtkhdf") as one, h5py.File(self.folder / "two.vtkhdf") as two:
            self.assertTrue(np.array_equal(one["VTKHDF/PointData/rotation_vector"], two["VTKHDF/PointData/rotation_vector"]))

    def test_an_existing_file_is_kept_without_force(self):
        self.gxrod("run", "body.toml")
        before = (self.folder / "body.vtkhdf").read_bytes()
        done = self.gxrod("run", "body.toml", code=4)
        self.assertIn("--force", done.stderr)
        self.assertEqual(before, (self.folder / "body.vtkhdf").read_bytes())
        self.gxrod("run", "body.toml", "--force")

    def test_files_that_cannot_be(self):
        self.assertIn("missing.toml", self.gxrod("run", "missing.toml", code=4).stderr)
        (self.folder / "folder").mkdir()
        self.assertIn("folder", self.gxrod("run", "body.toml", "-o", "folder", code=4).stderr)
        self.assertIn("nowhere", self.gxrod("run", "body.toml", "-o", "nowhere/out.vtkhdf", code=4).stderr)

    def test_a_full_disk_ends_the_run_and_keeps_a_readable_file(self):
        done = self.gxrod("run", "body.toml", "--set", "analysis.steps=200000", "--set", "output.every=20000", code=4,
                          preexec_fn=limit_file_size(60000))
        self.assertIn("body.vtkhdf", done.stderr)
        with h5py.File(self.folder / "body.vtkhdf") as file:
            self.assertGreaterEqual(len(file["histories/time"]), 0)

    def test_usage(self):
        self.assertIn("--help", self.gxrod("run", code=2).stderr)
        self.assertIn("--help", self.gxrod("run", "body.toml", "--speed", "9", code=2).stderr)
        self.gxrod(code=2)
        self.assertIn("gxrod 0", self.gxrod("--version").stdout)
        for verb in ("run", "check", "verify", "schema"):
            self.assertIn("Usage", self.gxrod(verb, "--help").stdout)

    def test_a_faulty_deck_is_reported_by_line_and_column(self):
        self.write("faulty.toml", SPINNING_BODY.replace("mass = 2.0", "mas = 2.0"))
        done = self.gxrod("run", "faulty.toml", code=2)
        self.assertIn("faulty.toml:5:1:", done.stderr)
        self.assertIn("mass", done.stderr)
        self.assertFalse((self.folder / "faulty.vtkhdf").exists())

    def test_a_run_that_does_not_converge_keeps_its_results(self):
        # From t = 0.5 a torque a billion times larger turns the body by more than half a turn in the shortest step.
        self.write("wild.toml", SPINNING_BODY.replace('"torque*sin(t)"', '"t < 0.5 ? torque : 1e12"'))
        done = self.gxrod("run", "wild.toml", "--summary", "summary.json", code=3)
        self.assertIn("top", done.stderr)
        summary = json.loads((self.folder / "summary.json").read_text())
        self.assertEqual(summary["status"], "failed")
        self.assertGreater(summary["rejected_steps"], 0)
        with h5py.File(self.folder / "wild.vtkhdf") as file:
            status = file.attrs["status"]
            self.assertEqual(status.decode() if isinstance(status, bytes) else status, "failed")
            np.testing.assert_array_equal(file.attrs["reason_nodes"], [0])
            self.assertAlmostEqual(file["histories/time"][-1], summary["time"])
            self.assertGreaterEqual(summary["time"], 0.49)

    def test_a_jump_is_warned_of(self):
        # Pushed down by a load of 300 at its crown, a shallow arch snaps through.
        arch = (self.folder / "arch.toml")
        arch.write_text("""
[section.s]
stiffness = { EA = 1e5, GAy = 1e5, GAz = 1e5, GJ = 10, EIy = 10, EIz = 10 }
[rod.arch]
section = "s"
arc = { from = [0, 0, 0], through = [5, 0, 0.5], to = [10, 0, 0] }
elements = 20
[[support]]
at = "arch.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "arch.end"
fix = ["position", "rx", "rz"]
[[load]]
at = "arch@0.5"
force = [0, 0, -300]
[analysis]
kind = "static"
steps = 10
""")
        done = self.gxrod("run", "arch.toml", "--quiet")
        self.assertIn("warning: the structure jumps between t = ", done.stderr)
        done = self.gxrod("run", "arch.toml", "--quiet", "--force", "--set", "load[0].force=[0, 0, -0.1]")
        self.assertEqual(done.stderr, "")

    def test_a_load_that_is_nan_ends_the_run_and_keeps_its_results(self):
        # Finite on the whole step grid; sdirk-4 asks for it at t = 0.6025, within a step.
        self.write("poles.toml", SPINNING_BODY.replace('"torque*sin(t)"', '"abs(t - 0.6025) < 1e-9 ? 1/0 : 1"'))
        done = self.gxrod("run", "poles.toml", "--set", "analysis.integrator=sdirk-4", code=2)
        self.assertIn("load[0].moment[0]", done.stderr)
        with h5py.File(self.folder / "poles.vtkhdf") as file:
            self.assertAlmostEqual(file["histories/time"][-1], 0.6)

    def test_interrupting_ends_after_the_step_at_hand(self):
        for sent in (signal.SIGINT, signal.SIGTERM):
            run = subprocess.Popen([GXROD, "run", "body.toml", "--set", "analysis.steps=50000000", "--force"],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            time.sleep(1.0)
            run.send_signal(sent)
            _, messages = run.communicate(timeout=60)
            self.assertEqual(run.returncode, 130, messages)
            self.assertIn("interrupted at t =", messages)
            with h5py.File(self.folder / "body.vtkhdf") as file:
                status = file.attrs["status"]
                self.assertEqual(status.decode() if isinstance(status, bytes) else status, "interrupted")
                self.assertGreater(len(file["histories/time"]), 100)
                self.assertEqual(len(file["histories/time"]), len(file["ledger/time"]))

    def wait_for_steps(self, path):
        """Until a run has written its first ones."""
        for _ in range(1200):
            try:
                with h5py.File(path, locking=False) as file:
                    if len(file["histories/time"]) > 0:
                        return
            except (OSError, KeyError):
                pass
            time.sleep(0.05)
        self.fail("waited for steps")

    def test_a_killed_run_leaves_a_readable_file(self):
        for delay in (0.1, 0.3, 0.6):
            (self.folder / "body.vtkhdf").unlink(missing_ok=True)
            run = subprocess.Popen([GXROD, "run", "body.toml", "--set", "analysis.steps=50000000", "--force", "--quiet"],
                                   cwd=self.folder)
            self.wait_for_steps(self.folder / "body.vtkhdf")
            time.sleep(delay)
            os.kill(run.pid, signal.SIGKILL)
            run.wait()
            with h5py.File(self.folder / "body.vtkhdf") as file:
                status = file.attrs["status"]
                self.assertEqual(status.decode() if isinstance(status, bytes) else status, "running")
                times = file["histories/time"][:]
                self.assertGreater(len(times), 100)
                self.assertTrue(np.all(np.diff(times) > 0))

    def test_a_pipe_gets_no_control_characters(self):
        done = self.gxrod("run", "body.toml")
        self.assertNotIn("\r", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
