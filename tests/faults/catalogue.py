"""The faults that are tried, and how many trials of one are shared among decks and places."""

from batch_faults import BATCH_FAULTS
from bench import Trial, find_steps_back
from folder_faults import FOLDER_FAULTS
from memory_faults import limit_memory, let_allocations_fail
from reading_faults import READING_FAULTS
from writing_faults import CALL_FAULTS, RANDOM_FAULTS

FAULTS = {**RANDOM_FAULTS, **CALL_FAULTS, **FOLDER_FAULTS, **READING_FAULTS,
          "memory_limit": limit_memory, "allocation": let_allocations_fail, **BATCH_FAULTS}


def count_calls_in(log):
    """Calls of a run, which an environment variable has counted."""
    return lambda bench, deck: bench.count_calls(deck, log, CLOCK_TICK=deck.tick)


# Faults in the n-th place of a run or a file: how the places are counted.
COUNTED = {**{name: count_calls_in("FAULT_LOG") for name in CALL_FAULTS}, "allocation": count_calls_in("MEMORY_LOG")}


def choose_places(places, count, random):
    """So many numbers of places, evenly spread and each anywhere in its part; all of them if count is 0."""
    if count == 0 or count >= places:
        return list(range(1, places + 1))
    return [1 + random.randrange(places * part // count, places * (part + 1) // count) for part in range(count)]


def run_fault(name, bench, decks, count, random):
    """Trials of one fault, over the decks by turns."""
    disturb = FAULTS[name]
    trials = []
    if name not in COUNTED:
        return [disturb(bench, decks[number % len(decks)], random) for number in range(count)]
    for deck in decks:
        places = COUNTED[name](bench, deck)
        share = -(-count // len(decks))
        of_deck = [disturb(bench, deck, at) for at in choose_places(places, share, random)]
        # With one thread each run is the same up to the fault, and a later fault can but leave more.
        step_back = find_steps_back(of_deck) if deck.threads == 1 and name in CALL_FAULTS else ""
        if step_back:
            of_deck.append(Trial("", "", lost=f"{deck.name}: {step_back}"))
        trials += of_deck
    return trials
