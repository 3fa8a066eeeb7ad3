"""The program gxrod, in a process of its own."""

import os
import re
import shutil
import signal
import subprocess
import sys
import threading
from pathlib import Path

from .errors import ConvergenceError, DeckError, Error, Fault, FileError

FAULT = re.compile(r"^(?P<file>.+?):(?P<line>\d+):(?P<column>\d+): (?:(?P<key>[^\s:]+): )?(?P<message>.*)$")
BAD_INPUT, NOT_CONVERGED, FILE, INTERRUPTED = 2, 3, 4, 130


def find_program():
    """Path of the program: what the environment variable GXROD_PROGRAM names, else that which this package is built or
    installed with, else the `gxrod` of the PATH. Raises FileError if there is none."""
    if named := os.environ.get("GXROD_PROGRAM"):
        return named
    package = Path(__file__).resolve().parent
    # This package is python/gxrod beside it in a build tree; share/gxrod/python/gxrod or lib/python3/site-packages/gxrod if installed.
    beside = [package.parents[1] / "gxrod", *(folder / "bin" / "gxrod" for folder in list(package.parents)[3:4]),
              Path(sys.prefix) / "bin" / "gxrod"]
    for path in beside:
        if path.is_file() and os.access(path, os.X_OK):
            return str(path)
    if found := shutil.which("gxrod"):
        return found
    raise FileError("gxrod: the program is not found, which runs batches and makes pages; `pip install .` in the source tree and Debian's package "
                    "gxrod install it. If it is there, put its folder into PATH, or name it in the environment variable GXROD_PROGRAM")


def run_program(arguments, quiet=True, accept=(0,)):
    """Runs the program and returns what it prints. Its errors become exceptions with its message.

    quiet: else what it says meanwhile goes to sys.stderr. accept: exit codes that are no errors. Ctrl-C reaches the
    program once, as at a prompt: it ends what it is at, and KeyboardInterrupt follows; a second one ends it at once.
    """
    command = [find_program(), *map(str, arguments)]
    try:
        # In a session of its own, so that Ctrl-C does not reach it twice.
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True, encoding="utf-8", errors="replace", start_new_session=True)
    except OSError as error:
        raise FileError(f"{command[0]}: cannot be run: {error.strerror}") from error
    output, said = [], []
    readers = [threading.Thread(target=read_lines, args=(process.stdout, output, None)),
               threading.Thread(target=read_lines, args=(process.stderr, said, None if quiet else sys.stderr))]
    for reader in readers:
        reader.start()
    interrupts = 0
    try:
        while True:
            try:
                process.wait()
                break
            except KeyboardInterrupt:
                interrupts += 1
                process.send_signal(signal.SIGINT)
    finally:
        if process.poll() is None:
            process.kill()
        for reader in readers:
            reader.join()
        process.stdout.close()
        process.stderr.close()
    if interrupts or process.returncode == INTERRUPTED:
        raise KeyboardInterrupt
    if process.returncode not in accept:
        raise error_of(process.returncode, "".join(said), arguments[0])
    return "".join(output)


def read_lines(stream, lines, echo):
    for line in stream:
        lines.append(line)
        if echo:
            echo.write(line)
            echo.flush()


def error_of(code, text, verb):
    """The exception for an exit code other than 0 and what the program wrote to stderr."""
    lines = [line for line in text.strip().splitlines() if not line.startswith(("warning:", "note:"))]
    message = "\n".join(line.removeprefix("gxrod: ") for line in lines) or f"gxrod {verb} ended with {code}"
    if code == BAD_INPUT:
        faults = read_faults(lines)
        return DeckError(faults) if faults else Error(message)
    if code == NOT_CONVERGED:
        return ConvergenceError(message)
    if code == FILE:
        return FileError(message)
    return Error(message if code >= 0 else f"gxrod {verb} was ended by signal {-code}" + (f": {message}" if lines else ""))


def read_faults(lines):
    """Faults of lines "file:line:column: key: message"; none if there is no such line, as in errors of usage."""
    found = [FAULT.match(line) for line in lines]
    if not any(found):
        return []
    return [Fault(match["file"], int(match["line"]), int(match["column"]), match["key"] or "", match["message"]) if match
            else Fault(message=line) for match, line in zip(found, lines)]
