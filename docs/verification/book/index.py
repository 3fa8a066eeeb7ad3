"""The tables of the whole book: one for each kind of case."""

from .cases import KINDS
from .tables import error_text, order_text, orders_of, table, values_of


def worst(case):
    """Error and tolerance of the value that comes nearest to its tolerance."""
    values = values_of(case)
    if not values:
        return ["", ""]
    check = max(values, key=lambda each: each["error"] / each["tolerance"])
    return [error_text(check["error"]), f"{check['tolerance']:g}"]


def make_index(kept):
    """Lines for all cases, grouped by kind."""
    lines = []
    for kind, title in KINDS.items():
        chosen = {name: case for name, case in kept["cases"].items() if case["kind"] == kind}
        if not chosen:
            continue
        rows = [[f"[{name}]({name}.md)", case["sentence"], case["source"], str(len(case["checks"])), *worst(case),
                 ", ".join(order_text(check["value"][0]) for check in orders_of(case)), f"{kept['seconds'][name]:g}"]
                for name, case in sorted(chosen.items())]
        head = ("case", "what it asks", "source", "checks", "error", "tolerance", "orders", "s")
        lines += ["", f"### {title}", "", *table(head, rows)]
    cases = kept["cases"].values()
    total = sum(len(case["checks"]) for case in cases)
    return [f"{len(cases)} cases, {total} checks, all within their tolerances.", *lines]
