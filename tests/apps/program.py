"""What the end-to-end tests share: calling gxrod as a user would, in a folder of its own."""

import os
import pathlib
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import unittest

GXROD = os.environ["GXROD"]
GXROD_PLOT = os.environ["GXROD_PLOT"]
SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])

SPINNING_BODY = """title = "A body that spins"
[parameters]
torque = 0.5
[body.top]
mass = 2.0
inertia = [1.0, 1.0, 0.75]
at = [0, 0, 0]
angular_velocity = [0, 0, 3]
[[load]]
at = "top"
moment = ["torque*sin(t)", 0, 0]
[analysis]
kind = "dynamic"
end_time = 1.0
steps = 100
[output]
every = 10
[[history]]
name = "spin"
at = "top"
quantities = ["angular_velocity", "position"]
"""


COMMANDS = ("gxrod ", "gxrod-plot ", "python3 docs/guide/scripts/")


def commands_of(page):
    """The commands in a page's code blocks without a language, with their comments."""
    fenced = re.findall(r"^```(\w*)\n(.*?)^```$", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    blocks = [block for language, block in fenced if not language]
    lines = [line for block in blocks for line in block.splitlines()]
    return [line for line in lines if line.startswith(COMMANDS)]


def limit_file_size(size):
    """What a program is to do before it starts, so that its files end after so many bytes: a full disk, as far as it can
    tell, since writes fail with no signal."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        os.environ["GCOV_PREFIX"] = "/dev/null"  # lest it cuts off what tests/coverage counts

    return limit


class ProgramTest(unittest.TestCase):
    """Gives each test an empty folder, in which gxrod runs."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def gxrod(self, *arguments, code=0, program=GXROD, timeout=300, **options):
        """Runs the program; the exit code must be `code`."""
        done = subprocess.run([program, *map(str, arguments)], cwd=self.folder, text=True, timeout=timeout,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        self.assertEqual(done.returncode, code, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def run_command(self, command, timeout=300):
        """Runs a command as a page states it, from the project's folder; "# exit code 3" can follow it."""
        program, *arguments = shlex.split(command, comments=True)
        paths = {"gxrod": GXROD, "gxrod-plot": GXROD_PLOT, "python3": sys.executable}
        arguments = [str(SOURCE / word) if word.startswith("docs/") else word for word in arguments]
        code = re.search(r"# exit code (\d+)", command)
        environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1")
        return self.gxrod(*arguments, program=paths[program], code=int(code.group(1)) if code else 0,
                          timeout=timeout, env=environment)
