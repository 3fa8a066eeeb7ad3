"""Too little memory: less than a run needs, or allocations that fail one by one."""

import resource
import subprocess

from bench import Trial, describe_end
from decks import LARGE

# Below this the system cannot load the program.
LOADING = ("error while loading shared libraries", "cannot allocate")
REFUSED = "GB of memory, where"


def judge_memory_error(done):
    """A run without memory ends with a code and a sentence that says so, or was not hindered."""
    if done.returncode == 0:
        return ""
    if done.returncode == 127 and any(words in done.stderr for words in LOADING):
        return ""
    if done.returncode == 2 and REFUSED in done.stderr:
        return ""
    if done.returncode == 2 and "memory" in done.stderr and "libgmsh" in done.stderr:
        return ""
    if done.returncode in (1, 4) and ("memory" in done.stderr or "threads can be had" in done.stderr):
        return ""
    return f"exit code {done.returncode}, told as: {done.stderr}"


def find_need(bench, deck):
    """Bytes of address space with which the deck just runs."""
    if deck.name not in bench.needs:
        low, high = 0, 1 << 29
        while high - low > 1 << 20:
            middle = (low + high) // 2
            enough = run_limited(bench, deck, middle).returncode == 0
            low, high = (low, middle) if enough else (middle, high)
        bench.needs[deck.name] = high
    return bench.needs[deck.name]


def find_loading(bench):
    """Bytes of address space with which the program is just loaded."""
    low, high = 0, 1 << 30
    while high - low > 1 << 18:
        middle = (low + high) // 2
        loaded = subprocess.run([bench.program, "--version"], capture_output=True, check=False,
                                preexec_fn=lambda limit=middle: set_limit(limit)).returncode == 0
        low, high = (low, middle) if loaded else (middle, high)
    return high


def set_limit(limit):
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))


def run_limited(bench, deck, limit):
    bench.path(deck).unlink(missing_ok=True)
    return subprocess.run([bench.program, *map(str, bench.arguments(deck)), "--quiet"], cwd=bench.folder, text=True,
                          capture_output=True, check=False, preexec_fn=lambda: set_limit(limit),
                          env=bench.environment(CLOCK_TICK=deck.tick))


def limit_memory(bench, deck, random):
    """A limit on the address space, from what loading the program takes to what the run needs; one tenth below."""
    deck = deck if random.random() < 0.3 else LARGE
    need = find_need(bench, deck)
    low = bench.needs.setdefault("", find_loading(bench))
    limit = round(random.uniform(low, need) if random.random() < 0.9 else random.uniform(0, low))
    done = run_limited(bench, deck, limit)
    trial = Trial(describe_end(done.returncode), "", message=done.stderr.strip())
    # Below, it is the system that ends, by a signal even, before the program begins.
    if limit >= low:
        trial.lost = judge_memory_error(done)
    return bench.recover(deck, trial)


def let_allocations_fail(bench, deck, at):
    """An allocation fails, and as many after it as chance, or rather their number, has it: 1, 10, 100 or all."""
    bench.path(deck).unlink(missing_ok=True)
    in_a_row = (1, 10, 100, 10**9)[at % 4]
    done = bench.run(*bench.arguments(deck), "--quiet",
                     environment=bench.environment(MEMORY_AT=at, MEMORY_FOR=in_a_row, CLOCK_TICK=deck.tick))
    trial = Trial(describe_end(done.returncode), "", message=done.stderr.strip())
    if done.returncode < 0 or done.returncode not in (0, 1, 2, 4, 127):
        trial.lost = f"{trial.end}: {done.stderr} (allocation {at}, {in_a_row} in a row)"
    elif done.returncode not in (0, 127) and not done.stderr:
        trial.lost = f"{trial.end} without a word (allocation {at}, {in_a_row} in a row)"
    return bench.recover(deck, trial)
