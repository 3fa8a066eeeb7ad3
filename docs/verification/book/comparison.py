"""Whether what a run of a case gives is what results.json keeps of it, but for round-off."""

from .cases import refinements_of

SAME = 0.02  # of errors and iterations: round-off differs from machine to machine
LEAST = 1e-9  # what round-off may make of an error
SAME_ORDER = 0.06  # two errors that are 2 % off
UNSTEADY_ORDER = 0.5
ORDER = "order of the error; "
EXACT = ("refinement", "set", "case", "scheme", "unknowns", "steps", "converged", "diverged")
COUNTS = ("newton_iterations", "iterations_per_step", "max_theta_deg")


def floor_of(name, what):
    """Below which errors of a refinement are the reference's own; `what` is its name, or ends with it."""
    for refinement, each in refinements_of(name).items():
        if what == refinement or what.endswith("; " + refinement):
            return each.get("floor", 0.0)
    return 0.0


def differs(found, kept, slack):
    """Of two numbers, one of which may be missing."""
    if found is None or kept is None:
        return found is not kept
    return not abs(found - kept) <= slack


def slack_of(key, kept, floor):
    """How far a number of a row may be from that kept."""
    if kept is None:
        return 0.0
    if key == "order":
        return SAME_ORDER
    if key in COUNTS:
        return max(SAME * kept, 2.0 if key == "newton_iterations" else 0.0)
    return max(SAME * kept, floor, LEAST)


def is_near_floor(row, floor):
    """The order of an error that floor or round-off shares in is not steady."""
    return row.get("error") is not None and row["error"] < 100.0 * max(floor, LEAST)


def compare_rows(name, found, kept):
    """Sentences on each run that is not as it was."""
    for now, then in zip(found, kept):
        floor = floor_of(name, then.get("refinement", ""))
        for key, value in then.items():
            if key == "order" and is_near_floor(then, floor):
                continue
            if key in EXACT and now.get(key) == value:
                continue
            if key in EXACT or differs(now.get(key), value, slack_of(key, value, floor)):
                run = then.get("set") or f"{then.get('case', '')} {then['scheme']}, {then['steps']} steps".strip()
                yield f"{run}: {key} is {now.get(key)}, results.json has {value}"


def slack_of_check(name, check, rows):
    """How far the error of a check may be from that kept; the error of an order is what it falls short by."""
    floor = floor_of(name, check["what"])
    if not check["what"].startswith(ORDER):
        return max(SAME * check["error"], floor, LEAST)
    measured = [row for row in rows if row.get("refinement") == check["what"].removeprefix(ORDER) and row["order"]]
    return UNSTEADY_ORDER if measured and is_near_floor(measured[-1], floor) else SAME_ORDER


def compare_checks(name, found, kept, rows):
    for now, then in zip(found, kept):
        for key in ("what", "reference", "uncertainty", "tolerance"):
            if now[key] != then[key]:
                yield f"{then['what']}: {key} is {now[key]}, results.json has {then[key]}"
        if differs(now["error"], then["error"], slack_of_check(name, then, rows)):
            yield f"{then['what']}: error is {now['error']}, results.json has {then['error']}"


def compare(name, found, kept):
    """Sentences, of a case as gathered from a run and as kept; none if they agree."""
    faults = [f"{key} is {found[key]!r}, results.json has {kept[key]!r}"
              for key in ("kind", "source") if found[key] != kept[key]]
    for key in ("rows", "checks"):
        if len(found[key]) != len(kept[key]):
            faults.append(f"there are {len(found[key])} {key}, results.json has {len(kept[key])}")
    faults += compare_rows(name, found["rows"], kept["rows"])
    faults += compare_checks(name, found["checks"], kept["checks"], kept["rows"])
    return faults
