"""The faults that are tried, and how many trials of one are shared among decks and calls."""

from batch_faults import BATCH_FAULTS
from bench import Trial, find_steps_back
from folder_faults import FOLDER_FAULTS
from memory_faults import limit_memory, let_allocations_fail
from reading_faults import READING_FAULTS
from writing_faults import CALL_FAULTS, RANDOM_FAULTS

FAULTS = {**RANDOM_FAULTS, **CALL_FAULTS, **FOLDER_FAULTS, **READING_FAULTS, "memory_limit": limit_memory,
          "allocation": let_allocations_fail, **BATCH_FAULTS}
# Faults in the n-th call of a kind: which environment variable has the calls counted.
COUNTED = {**{name: "FAULT_LOG" for name in CALL_FAULTS}, "allocation": "MEMORY_LOG"}


def choose_calls(calls, count, random):
    """So many numbers of calls, evenly spread and each anywhere in its part; all of them if count is 0."""
    if count == 0 or count >= calls:
        return list(range(1, calls + 1))
    return [1 + random.randrange(calls * part // count, calls * (part + 1) // count) for part in range(count)]


def run_fault(name, bench, decks, count, random):
    """Trials of one fault, over the decks by turns."""
    disturb = FAULTS[name]
    trials = []
    if name not in COUNTED:
        return [disturb(bench, decks[number % len(decks)], random) for number in range(count)]
    for deck in decks:
        calls = bench.count_calls(deck, COUNTED[name], CLOCK_TICK=deck.tick)
        share = -(-count // len(decks))
        of_deck = [disturb(bench, deck, at) for at in choose_calls(calls, share, random)]
        # With one thread each run is the same up to the fault, and a later fault can but leave more.
        step_back = find_steps_back(of_deck) if deck.threads == 1 and name != "allocation" else ""
        if step_back:
            of_deck.append(Trial("", "", lost=f"{deck.name}: {step_back}"))
        trials += of_deck
    return trials
