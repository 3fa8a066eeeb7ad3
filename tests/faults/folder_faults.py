"""Folders and files that others change while gxrod needs them, and clocks that leap."""

import ctypes
import fcntl
import os
import signal
import stat
import time

import results
from bench import Trial, describe_end

CAP_DAC_OVERRIDE = 1
PR_CAPBSET_DROP = 24


def obey_permissions():
    """For a child process: even root may not write what is read-only."""
    if os.geteuid() == 0:
        ctypes.CDLL(None).prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0)


def expect_refusal(done, words):
    if done.returncode == 4 and words in done.stderr:
        return ""
    return f"exit code {done.returncode}, told as: {done.stderr}"


def kill_halfway(bench, deck, **faults):
    """Leaves a file that can be resumed, and says how the run ended."""
    calls = bench.count_calls(deck, "FAULT_LOG", CLOCK_TICK=deck.tick)
    bench.path(deck).unlink(missing_ok=True)
    return bench.run(*bench.arguments(deck), "--quiet",
                     environment=bench.environment(FAULT="kill", FAULT_AT=calls // 2, CLOCK_TICK=deck.tick, **faults))


def read_only(bench, deck, _):
    """A folder and a file that are not writable: nothing is started and nothing changed."""
    kill_halfway(bench, deck)
    path = bench.path(deck)
    before = path.read_bytes()
    path.chmod(stat.S_IRUSR)
    resumed = bench.run("resume", path.name, preexec_fn=obey_permissions)
    bench.folder.chmod(stat.S_IRUSR | stat.S_IXUSR)
    begun = bench.run(*bench.arguments(deck, name="new.vtkhdf"), preexec_fn=obey_permissions)
    bench.folder.chmod(stat.S_IRWXU)
    path.chmod(stat.S_IRUSR | stat.S_IWUSR)
    trial = Trial(describe_end(begun.returncode), "")
    trial.lost = expect_refusal(resumed, "cannot be written") or expect_refusal(begun, "is not writable")
    if path.read_bytes() != before:
        trial.lost = trial.lost or "the file was changed"
    return bench.recover(deck, trial)


def start_and_wait(bench, deck, random):
    """A long run at a random moment after its file is there and before its end."""
    seconds = bench.seconds(deck)
    for _ in range(20):
        bench.path(deck).unlink(missing_ok=True)
        begin = time.monotonic()
        process = bench.start(*bench.arguments(deck, is_long=True), "--quiet")
        while not results.count_steps(bench.path(deck)) and process.poll() is None:
            time.sleep(0.001)
        time.sleep(random.uniform(0.0, max(0.0, 0.9 * seconds - (time.monotonic() - begin))))
        if process.poll() is None:
            return process
        process.communicate()
    raise RuntimeError(f"{deck.name} always ended before it could be disturbed")


def take_away(bench, deck, random, action, told):
    """Does so with the file of a run, which must end with code 4 and such words, unless all was written before."""
    process = start_and_wait(bench, deck, random)
    with open(bench.path(deck), "rb") as file:
        action(bench.path(deck))
        was_complete = results.is_complete(f"/proc/self/fd/{file.fileno()}")
    errors = process.communicate(timeout=300)[1]
    trial = Trial(describe_end(process.returncode), "", message=errors.strip())
    if not (process.returncode == 4 and told in errors) and not (process.returncode == 0 and was_complete):
        trial.lost = f"{trial.end}: {errors}"
    return trial


def removed(bench, deck, random):
    """The results file is removed while the run writes it: it ends and says so."""
    trial = take_away(bench, deck, random, lambda path: path.unlink(), "it was removed while the run wrote it")
    return bench.recover(deck, trial, is_long=True)


def moved(bench, deck, random):
    """The results file is moved while the run writes it: it is complete under its new name, and this is reported."""
    new = bench.folder / "moved.vtkhdf"
    trial = take_away(bench, deck, random, lambda path: path.rename(new), "was moved while the run wrote it")
    new.rename(bench.path(deck))
    return bench.recover(deck, trial, is_long=True)


def locked(bench, deck, random):
    """A second writer is refused while a run writes, and gxrod while somebody else has the file locked."""
    process = start_and_wait(bench, deck, random)
    path = bench.path(deck)
    refusals = [bench.run("resume", path.name), bench.run(*bench.arguments(deck, is_long=True))]
    is_running = process.poll() is None
    errors = process.communicate(timeout=300)[1]
    trial = Trial(describe_end(process.returncode), "", message=errors.strip())
    if process.returncode != 0:
        trial.lost = f"{trial.end}: {errors}"
    kill_halfway(bench, deck)
    with open(path, "r+b") as file:
        fcntl.lockf(file, fcntl.LOCK_EX)
        others = [bench.run("resume", path.name), bench.run(*bench.arguments(deck))]
    for done in [*(refusals if is_running else []), *others]:
        trial.lost = trial.lost or expect_refusal(done, "another process is writing it")
    return bench.recover(deck, trial)


def run_to_end(bench, arguments, **faults):
    """A run that faults must not disturb."""
    done = bench.run(*arguments, "--quiet", environment=bench.environment(**faults))
    trial = Trial(describe_end(done.returncode), "", message=done.stderr.strip())
    if done.returncode != 0 or done.stderr:
        trial.lost = f"{trial.end}: {done.stderr}"
    return trial


def clock_jumps(bench, deck, _):
    """The wall clock leaps by up to years, forth and back, whenever it is asked: in a run that is killed halfway and what
    goes on with it, and in a whole run."""
    killed = kill_halfway(bench, deck, CLOCK_JUMPS=1)
    if killed.returncode != -signal.SIGKILL:
        return Trial(describe_end(killed.returncode), "", lost=f"was not killed: {killed.stderr}")
    trial = run_to_end(bench, ["resume", bench.path(deck).name, "--threads", deck.threads], CLOCK_JUMPS=1)
    trial = bench.recover(deck, trial)
    if trial.lost:
        return trial
    bench.path(deck).unlink()
    trial = run_to_end(bench, bench.arguments(deck, is_long=True), CLOCK_JUMPS=1)
    return bench.recover(deck, trial, is_long=True)


def short_writes(bench, deck, _):
    """Every call writes half of what it is to write, and every third one is interrupted."""
    bench.path(deck).unlink(missing_ok=True)
    trial = run_to_end(bench, bench.arguments(deck), FAULT="short", CLOCK_TICK=deck.tick)
    return bench.recover(deck, trial)


FOLDER_FAULTS = {"read_only": read_only, "removed": removed, "moved": moved, "locked": locked,
                 "clock_jumps": clock_jumps, "short_writes": short_writes}
