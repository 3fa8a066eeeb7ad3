"""Results files that are not whole, given to everything that reads them."""

import shutil
import subprocess
import sys

from bench import NOTHING_TO_RESUME, Trial, describe_end


def readers(bench, name):
    """Every program that reads results, and how it is called."""
    return {"resume": [bench.program, "resume", name],
            "export": [bench.program, "export", name, "--csv", "csv", "--series", "series", "--force"],
            "report": [bench.program, "report", name, "-o", "page.html", "--force"],
            "gxrod-plot": [sys.executable, bench.plot, name, "-o", "plot.png"]}


def judge_reading(reader, done, name):
    """A file that cannot be read is told by name, with an exit code and without a traceback."""
    if done.returncode == 0:
        return ""
    codes = (1, 2, 4) if reader == "gxrod-plot" else (4,)
    if done.returncode in codes and name in done.stderr and "Traceback" not in done.stderr:
        return ""
    return f"{reader}: exit code {done.returncode}, told as: {done.stderr[-500:]}"


def truncated(bench, deck, random):
    """A file cut anywhere. No reader crashes, and none changes what is left."""
    whole = bench.whole(deck)[0]
    path = bench.path(deck)
    shutil.copyfile(whole, path)
    size = random.randrange(whole.stat().st_size)
    with open(path, "r+b") as file:
        file.truncate(size)
    before = path.read_bytes()
    trial = Trial("", "")
    for reader, command in readers(bench, path.name).items():
        if reader == "gxrod-plot" and random.random() > bench.plotted:
            continue
        done = subprocess.run(command, cwd=bench.folder, text=True, capture_output=True, check=False, timeout=300)
        trial.end = describe_end(done.returncode) if reader == "resume" else trial.end
        trial.lost = trial.lost or judge_reading(reader, done, path.name)
        if done.returncode == 0:
            trial.lost = trial.lost or f"{reader} takes {size} bytes of {whole.stat().st_size} for a whole file"
    if path.read_bytes() != before:
        trial.lost = trial.lost or "the file was changed"
    return bench.recover(deck, trial, refusal=NOTHING_TO_RESUME + "|truncated file")


READING_FAULTS = {"truncated": truncated}
