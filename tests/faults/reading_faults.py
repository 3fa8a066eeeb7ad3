"""Results files that are not whole, given to everything that reads them."""

import shutil
import subprocess
import sys

from bench import NOTHING_TO_RESUME, Trial, describe_end
from own_bits import count_sealed_bytes, find_own_bytes, flip_bit


def readers(bench, name):
    """Every program that reads results, and how it is called."""
    return {"resume": [bench.program, "resume", name],
            "export": [bench.program, "export", name, "--csv", "csv", "--series", "series", "--force"],
            "report": [bench.program, "report", name, "-o", "page.html", "--force"],
            "gxrod-plot": [sys.executable, bench.plot, name, "-o", "plot.png"]}


def judge_reading(reader, done, name):
    """A file that cannot be read is reported by name, with an exit code and without a traceback."""
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
    return bench.recover(deck, trial, refusal=NOTHING_TO_RESUME + "|not all of its bytes")


def describe_forms(bench, name):
    """What export and report make of a file: exit code, what they say on stderr, and all that they write."""
    commands = {"export": ["export", name, "--csv", "csv"], "report": ["report", name, "-o", "page.html"]}
    tables, page = bench.folder / "csv", bench.folder / "page.html"
    forms = {}
    for reader, command in commands.items():
        shutil.rmtree(tables, ignore_errors=True)
        page.unlink(missing_ok=True)
        done = bench.run(*command)
        written = {file.name: file.read_bytes() for file in [page, *tables.glob("*")] if file.is_file()}
        forms[reader] = (done, written)
    return forms


def choose_bit(path, sealed, random):
    """Anywhere in so many bytes, or, every other time, in what HDF5 keeps of its own there."""
    own_bytes = [at for at in find_own_bytes(path) if at < sealed] if random.random() < 0.5 else []
    return 8 * (random.choice(own_bytes) if own_bytes else random.randrange(sealed)) + random.randrange(8)


def flipped(bench, deck, random):
    """One bit is another one in a file that a run left, sealed, at a random moment or at its end. Whatever is made of the
    file afterwards is said to be in doubt."""
    path = bench.path(deck)
    path.unlink(missing_ok=True)
    process = bench.start(*bench.arguments(deck, is_long=True), "--quiet")
    try:
        process.wait(bench.seconds(deck) * random.uniform(0.3, 1.5))
    except subprocess.TimeoutExpired:
        process.kill()
    process.communicate(timeout=300)
    sealed = count_sealed_bytes(path) if path.exists() else 0
    if sealed == 0:
        return bench.recover(deck, Trial(describe_end(process.returncode), ""), is_long=True)
    before = describe_forms(bench, path.name)
    bit = choose_bit(path, sealed, random)
    path.write_bytes(flip_bit(path.read_bytes(), bit))
    trial = Trial("", "")
    for reader, (done, written) in describe_forms(bench, path.name).items():
        was_well = before[reader][0].returncode == 0
        if was_well and done.returncode == 0 and "warning: " not in done.stderr:
            trial.lost = trial.lost or f"{reader} says nothing of bit {bit}"
        trial.lost = trial.lost or judge_reading(reader, done, path.name)
        trial.end = describe_end(done.returncode)
    trial = bench.go_on(deck, trial, is_long=True, refusal="cannot be resumed")
    if trial.recovery != "started again":
        trial.lost = trial.lost or f"a run resumes with bit {bit} changed"
    return trial


READING_FAULTS = {"truncated": truncated, "flipped": flipped}
