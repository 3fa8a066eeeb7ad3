"""Faults that stop or hinder what writes: kills, signals, full disks, failing devices."""

import re
import resource
import signal
import subprocess
import time

from bench import NOTHING_TO_RESUME, Trial, describe_end


def at_calls(fault):
    """A fault at chosen calls that change files; a run's clock makes it write at the same places each time."""

    def disturb(bench, deck, at):
        bench.path(deck).unlink(missing_ok=True)
        done = bench.run(*bench.arguments(deck), "--quiet",
                         environment=bench.environment(FAULT=fault, FAULT_AT=at, CLOCK_TICK=deck.tick))
        trial = Trial(describe_end(done.returncode), "", message=done.stderr.strip())
        if fault in ("kill", "torn"):
            # The process that reads a mesh may be the one that is killed, where it answers.
            is_reader = done.returncode == 2 and "Gmsh cannot read it" in done.stderr
            trial.lost = "" if done.returncode == -signal.SIGKILL or is_reader else f"was not killed: {done.stderr}"
        else:
            trial.lost = judge_write_error(done, bench.path(deck).name)
        return bench.recover(deck, trial)

    return disturb


def judge_write_error(done, name):
    """A write that failed is reported with the file's name and cause, or was recovered."""
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


# A disk of its own, in memory, that something else fills up after so many seconds; what the run left there is copied out.
SMALL_DISK = """mount -t tmpfs -o size="$1" tmpfs disk || exit 99
path=$2 seconds=$3
shift 3
"$@" &
sleep "$seconds"
cat /dev/zero > disk/other 2>/dev/null
wait $!
code=$?
rm disk/other
[ ! -e "disk/$path" ] || cp "disk/$path" "$path"
exit $code"""
UNSHARE = ["unshare", "--user", "--map-root-user", "--mount"]


def may_mount():
    """Whether this machine lets anybody have a disk of their own."""
    done = subprocess.run([*UNSHARE, "mount", "-t", "tmpfs", "tmpfs", "/mnt"], capture_output=True, check=False)
    return done.returncode == 0


def fill_disk(bench, deck, random):
    """A disk that something else fills up, at a random moment of a run."""
    bench.path(deck).unlink(missing_ok=True)
    (bench.folder / "disk").mkdir(exist_ok=True)
    seconds = bench.seconds(deck)
    room = 2 * bench.whole(deck, is_long=True)[0].stat().st_size + (1 << 20)
    name = bench.path(deck).name
    arguments = bench.arguments(deck, is_long=True, name=f"disk/{name}")
    done = subprocess.run([*UNSHARE, "sh", "-c", SMALL_DISK, "sh", str(room), name, str(random.uniform(0.0, seconds)), bench.program,
                           *map(str, arguments), "--quiet"],
                          cwd=bench.folder, text=True, capture_output=True, timeout=300, check=False,
                          env=bench.environment(CLOCK_TICK=deck.tick))
    lost = judge_write_error(done, name)
    # A run that begins when the disk is full already is refused with the size that it would need.
    if done.returncode == 4 and re.search(rf"{name}: would take more than \S+ GB, .* are free", done.stderr):
        lost = ""
    trial = Trial(describe_end(done.returncode), "", message=done.stderr.strip(), lost=lost)
    return bench.recover(deck, trial, is_long=True)


def kill_resumed(bench, deck, random):
    """A kill at a random moment of a run, and another of the resumed run."""
    bench.path(deck).unlink(missing_ok=True)
    seconds = bench.seconds(deck)
    code, errors = 0, ""
    for arguments in ([*bench.arguments(deck, is_long=True), "--quiet"],
                      ["resume", bench.path(deck).name, "--threads", deck.threads]):
        process = bench.start(*arguments, environment=bench.environment(CLOCK_TICK=deck.tick))
        time.sleep(random.uniform(0.0, seconds))
        process.kill()
        errors = process.communicate(timeout=300)[1]
        code = process.returncode
    trial = Trial(describe_end(code), "", message=errors.strip())
    if code not in (-signal.SIGKILL, 0) and not re.search(NOTHING_TO_RESUME + "|no such file", errors):
        trial.lost = f"{trial.end}: {errors}"
    return bench.recover(deck, trial, is_long=True)


# Signals before the program listens end it as any other.
SIGNALLED = (-signal.SIGINT, -signal.SIGTERM, 130, 0)
RANDOM_FAULTS = {
    "kill": at_moment(kill, (-signal.SIGKILL, 0)),
    "sigterm": at_moment(terminate, SIGNALLED),
    "ctrl_c_twice": at_moment(interrupt_twice, SIGNALLED),
    "file_size_limit": limit_file_size,
    "small_disk": fill_disk,
    "kill_resumed": kill_resumed,
}
CALL_FAULTS = {
    "kill_in_write": at_calls("kill"),
    "torn_write": at_calls("torn"),
    "disk_full": at_calls("full"),
    "disk_full_once": at_calls("once"),
    "io_error": at_calls("io"),
}
