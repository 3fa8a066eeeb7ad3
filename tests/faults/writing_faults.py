"""Faults that stop or hinder what writes: kills, signals, full disks, failing devices."""

import re
import resource
import signal
import time

from bench import Trial, describe_end


def at_calls(fault):
    """A fault at chosen calls that change files; a run's clock makes it write at the same places each time."""

    def disturb(bench, deck, at):
        bench.path(deck).unlink(missing_ok=True)
        done = bench.run(*bench.arguments(deck), "--quiet",
                         environment=bench.environment(FAULT=fault, FAULT_AT=at, CLOCK_TICK=deck.tick))
        trial = Trial(describe_end(done.returncode), "", message=done.stderr.strip())
        if fault in ("kill", "torn"):
            trial.lost = "" if done.returncode == -signal.SIGKILL else f"was not killed: {done.stderr}"
        else:
            trial.lost = judge_write_error(done, bench.path(deck).name)
        return bench.recover(deck, trial)

    return disturb


def judge_write_error(done, name):
    """A write that failed is told with the file's name and cause, or was made good."""
    if done.returncode == 0 and not done.stderr:
        return ""
    told = re.search(r"No space left on device|Input/output error|File too large", done.stderr)
    if done.returncode == 4 and told and name in done.stderr:
        return ""
    return f"exit code {done.returncode}, told as: {done.stderr}"


def at_moment(disturb_process, allowed_ends):
    """A fault at a random moment of a run that takes a second or so, its start and its end included."""

    def disturb(bench, deck, random):
        bench.path(deck).unlink(missing_ok=True)
        seconds = bench.seconds(deck)
        process = bench.start(*bench.arguments(deck, is_long=True), "--quiet")
        time.sleep(random.uniform(0.0, seconds))
        disturb_process(process, random)
        errors = process.communicate(timeout=300)[1]
        trial = Trial(describe_end(process.returncode), "", message=errors.strip())
        if process.returncode not in allowed_ends:
            trial.lost = f"{trial.end}: {errors}"
        return bench.recover(deck, trial, is_long=True)

    return disturb


def kill(process, _):
    process.kill()


def terminate(process, _):
    process.send_signal(signal.SIGTERM)


def interrupt_twice(process, random):
    process.send_signal(signal.SIGINT)
    time.sleep(random.choice([0.0, 0.0005, 0.002, 0.01]))
    process.send_signal(signal.SIGINT)


def limit_file_size(bench, deck, random):
    """A limit on the size of files, anywhere below that of the whole results."""
    bench.path(deck).unlink(missing_ok=True)
    size = bench.whole(deck)[0].stat().st_size
    limit = 1 + int(size * random.random() ** 0.3)

    def set_limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    done = bench.run(*bench.arguments(deck), "--quiet", preexec_fn=set_limit,
                     environment=bench.environment(CLOCK_TICK=deck.tick))
    lost = judge_write_error(done, bench.path(deck).name)
    return bench.recover(deck, Trial(describe_end(done.returncode), "", message=done.stderr.strip(), lost=lost))


# Signals before the program listens end it as any other.
SIGNALLED = (-signal.SIGINT, -signal.SIGTERM, 130, 0)
RANDOM_FAULTS = {
    "kill": at_moment(kill, (-signal.SIGKILL, 0)),
    "sigterm": at_moment(terminate, SIGNALLED),
    "ctrl_c_twice": at_moment(interrupt_twice, SIGNALLED),
    "file_size_limit": limit_file_size,
}
CALL_FAULTS = {
    "kill_in_write": at_calls("kill"),
    "torn_write": at_calls("torn"),
    "disk_full": at_calls("full"),
    "disk_full_once": at_calls("once"),
    "io_error": at_calls("io"),
}
