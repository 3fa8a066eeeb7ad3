"""Pipes and devices in place of files: what must be a regular file is refused at once, decks may come from a pipe."""

import os
import resource
import subprocess
import time
import unittest

from program import GXROD, GXROD_PLOT, SPINNING_BODY, ProgramTest

TRUSS = """[section.wire]
shape = { circle = { radius = 5e-3 } }
material = { E = 2.1e11, nu = 0.3, density = 7850 }
[rod.truss]
section = "wire"
mesh = { file = "truss.msh", group = "truss" }
[analysis]
kind = "static"
"""
IS_SANITIZED = os.environ.get("GXROD_SANITIZED") == "1"


def limit_memory():
    """For a child process: what reads without end is to end there, not to take all memory."""
    if not IS_SANITIZED:
        resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))


class SpecialFiles(ProgramTest):
    def setUp(self):
        super().setUp()
        os.mkfifo(self.folder / "fifo")

    def refuse(self, *arguments, code, preexec_fn=limit_memory, **options):
        """What gxrod says, which must be at once and in one line."""
        start = time.monotonic()
        done = self.gxrod(*arguments, code=code, timeout=60, preexec_fn=preexec_fn, **options)
        self.assertLess(time.monotonic() - start, 30)
        self.assertEqual((done.stdout, done.stderr.count("\n")), ("", 1))
        return done.stderr

    def test_no_mesh(self):
        self.write("truss.toml", TRUSS)
        (self.folder / "link.msh").symlink_to("fifo")
        for mesh in ("fifo", "link.msh", "/dev/zero", "/dev/null"):
            self.write("truss.toml", TRUSS.replace("truss.msh", mesh))
            for verb in ("check", "run"):
                self.assertRegex(self.refuse(verb, "truss.toml", code=2), r"^truss.toml:6:17: rod.truss.mesh.file: "
                                 rf"{mesh}: is not a regular file, expected a mesh\n$")

    def test_no_results(self):
        for name in ("fifo", "/dev/zero"):
            for arguments in (("report", name, "-o", "page.html"), ("export", name, "--csv", "tables"),
                              ("export", name, "--series", "frames"), ("resume", name)):
                self.assertEqual(self.refuse(*arguments, code=4),
                                 f"gxrod: {name}: is not a regular file\n")
            told = self.refuse(name, program=GXROD_PLOT, preexec_fn=None, code=4)
            self.assertIn(f"{name}: is not a regular file\n", told)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["fifo"])

    def test_no_page(self):
        self.write("body.toml", SPINNING_BODY)
        self.gxrod("run", "body.toml")
        for arguments in (("report", "body.vtkhdf"), ("verify", "body.toml")):
            told = self.refuse(*arguments, "-o", "fifo", "--force", code=4)
            self.assertEqual(told, "gxrod: fifo: is not a regular file (give the name of one)\n")
        self.assertTrue((self.folder / "fifo").is_fifo())

    def test_no_exports(self):
        self.write("body.toml", SPINNING_BODY)
        self.gxrod("run", "body.toml")
        for form, name in (("--csv", "ledger.csv"), ("--series", "body_0000.hdf"), ("--series", "body.hdf.series")):
            folder = self.folder / name.replace(".", "_")
            folder.mkdir()
            os.mkfifo(folder / name)
            told = self.refuse("export", "body.vtkhdf", form, folder.name, "--force", code=4)
            self.assertEqual(told, f"gxrod: {folder.name}/{name}: is not a regular file (give the name of one)\n")
            self.assertEqual([path.name for path in folder.iterdir()], [name])

    def test_pipes_without_a_writer(self):
        self.write("plan.toml", 'deck = "fifo"\n[vary]\n"parameters.torque" = [1, 2]\n')
        for arguments in (("check", "fifo"), ("run", "fifo"), ("verify", "fifo"), ("batch", "fifo"), ("batch", "plan.toml")):
            self.assertEqual(self.refuse(*arguments, code=4), "gxrod: fifo: is a pipe that nobody writes to\n")
        self.write("body.toml", SPINNING_BODY)
        self.write("plan.toml", 'deck = "body.toml"\ncombine = "table"\ntable = "fifo"\n')
        self.assertEqual(self.refuse("batch", "plan.toml", code=4), "gxrod: fifo: is a pipe that nobody writes to\n")

    def test_texts_without_an_end(self):
        for verb in ("check", "run", "verify"):
            self.assertEqual(self.refuse(verb, "/dev/zero", code=4), "gxrod: /dev/zero: has more than 100 MB, expected a deck\n")
        self.assertIn("has more than 100 MB, expected a plan or a deck", self.refuse("batch", "/dev/zero", code=4))
        self.write("body.toml", SPINNING_BODY)
        self.write("plan.toml", 'deck = "body.toml"\ncombine = "table"\ntable = "/dev/zero"\n')
        self.assertIn("/dev/zero: has more than 100 MB, expected a table", self.refuse("batch", "plan.toml", code=4))
        with open(self.folder / "sparse.toml", "wb") as file:
            file.truncate(1 << 40)
        self.assertIn("sparse.toml: has more than 100 MB, expected a deck", self.refuse("check", "sparse.toml", code=4))

    def test_decks_and_plans_from_pipes(self):
        told = self.gxrod("check", "/dev/stdin", input=SPINNING_BODY, timeout=60).stdout
        self.assertIn("A body that spins\n", told)
        fault = self.gxrod("check", "/dev/stdin", input=SPINNING_BODY.replace("mass", "mess"), timeout=60, code=2).stderr
        self.assertIn("/dev/stdin:5:1: body.top.mess: ", fault)
        # One that comes slowly: as long as there is who writes, it is waited for.
        with subprocess.Popen([GXROD, "check", "fifo"], cwd=self.folder, stdout=subprocess.PIPE, text=True) as process:
            with open(self.folder / "fifo", "w", encoding="utf-8") as pipe:
                for part in (SPINNING_BODY[:40], SPINNING_BODY[40:]):
                    time.sleep(1.2)
                    pipe.write(part)
                    pipe.flush()
            self.assertIn("A body that spins\n", process.communicate(timeout=60)[0])
        self.write("body.toml", SPINNING_BODY)
        plan = f'deck = "{self.folder}/body.toml"\n[vary]\n"parameters.torque" = [1, 2]\n'
        self.assertIn("2 cases", self.gxrod("batch", "--dry-run", "/dev/stdin", input=plan, timeout=60).stdout)


if __name__ == "__main__":
    unittest.main()
