"""Which pictures there are, and of what data each was drawn: a digest in the PNG tells, whatever drew it."""

import hashlib
import json

from .cases import deck_of, figure_of, points_compared, refinements_of

KEYWORD = "Comment"
SKETCH, CONVERGENCE = "sketch", "convergence"
# A study of several decks: {title: deck}.
SEVERAL_DECKS = {"rod_schemes": {"free flight": "free_flight_smooth", "right angle": "right_angle",
                                 "rubber pendulum": "rubber_pendulum"}}


def decks_of(name):
    """{title: (path of the deck, histories to mark)} of a sketch."""
    decks = SEVERAL_DECKS.get(name, {name: name})
    return {title: (deck_of(deck), points_compared(deck)) for title, deck in decks.items()}


def digest_of_sketch(name):
    parts = [path.read_text(encoding="utf-8") + repr(sorted(points)) for path, points in decks_of(name).values()]
    return hashlib.sha256("".join(parts).encode()).hexdigest()


def digest_of_convergence(name, case):
    floors = {key: each.get("floor", 0.0) for key, each in refinements_of(name).items()}
    return hashlib.sha256(json.dumps([case["rows"], floors], sort_keys=True).encode()).hexdigest()


def wanted_figures(kept):
    """(case, kind, path, digest) of each picture of the book."""
    for name, case in kept["cases"].items():
        yield name, SKETCH, figure_of(name, SKETCH), digest_of_sketch(name)
        yield name, CONVERGENCE, figure_of(name, CONVERGENCE), digest_of_convergence(name, case)


def read_digest(path):
    """What a PNG says it was drawn of."""
    data, at = path.read_bytes(), 8
    while at < len(data):
        length, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        keyword, _, text = data[at + 8:at + 8 + length].partition(b"\0")
        if kind == b"tEXt" and keyword.decode() == KEYWORD:
            return text.decode()
        at += length + 12
    return None


def is_current(path, digest):
    return path.exists() and read_digest(path) == digest


def draw_figures(kept, all_of_them):
    """Draws the pictures whose data changed, or all."""
    from .convergence import save_convergence  # here, so that a check needs no matplotlib
    from .sketch import save_sketch

    for name, kind, path, digest in wanted_figures(kept):
        if is_current(path, digest) and not all_of_them:
            continue
        metadata = {KEYWORD: digest}
        if kind == SKETCH:
            save_sketch(path, decks_of(name), metadata)
        else:
            save_convergence(path, name, kept["cases"][name], metadata)
