"""Tables of a page, in Markdown, from what results.json keeps of a case."""

from .comparison import ORDER


def number(value):
    """As a reader writes it: 1e-10 and not 1e-10.000."""
    return "–" if value is None else f"{value:.15g}".replace("e-0", "e-").replace("-0", "0" if value == 0 else "-0")


def error_text(value):
    return f"{value:.2e}" if value else "0"


def vector(values):
    texts = [number(value) for value in values]
    return texts[0] if len(texts) == 1 else f"({', '.join(texts)})"


def order_text(value):
    return "" if value is None else f"{value:.2f}"


def table(head, rows):
    """Lines of a Markdown table."""
    def line(cells):
        return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"

    return [line(head), "|" + "---|" * len(head), *map(line, rows)]


def is_order(check):
    return check["what"].startswith(ORDER)


def values_of(case):
    return [check for check in case["checks"] if not is_order(check)]


def orders_of(case):
    return [check for check in case["checks"] if is_order(check)]


def name_of_order(check):
    return check["what"].removeprefix(ORDER)


def make_values(case):
    """What was compared with what."""
    head = ("value", "reference", "±", "gxrod", "error", "tolerance", "order")
    return table(head, [[check["what"], vector(check["reference"]),
                         f"{check['uncertainty']:g}" if check["uncertainty"] else "exact", vector(check["value"]),
                         error_text(check["error"]), f"{check['tolerance']:g}", order_text(check["order"])]
                        for check in values_of(case)])


def make_orders(case):
    """With which order the errors fall, and what is asked."""
    return table(("order of the error", "expected", "measured", "least accepted"),
                 [[name_of_order(check), number(check["reference"][0]), order_text(check["value"][0]),
                   f"{check['reference'][0] - check['tolerance']:g}"] for check in orders_of(case)])


def make_results(case):
    values = make_values(case) if values_of(case) else []
    orders = make_orders(case) if orders_of(case) else []
    return values + ([""] if values and orders else []) + orders


def make_refinements(case):
    """Each run of a case that has a reference.toml."""
    rows, before = [], None
    for row in case["rows"]:
        name = "" if row["refinement"] == before else row["refinement"]
        before = row["refinement"]
        rows.append([name, f"`{row['set']}`", str(row["unknowns"]), str(row["steps"]), str(row["newton_iterations"]),
                     error_text(row["error"]), order_text(row["order"])])
    return table(("refinement", "run with", "unknowns", "steps", "Newton iterations", "error", "order"), rows)


def significant(value):
    """Four digits, of a number that may be missing."""
    return "" if value is None else f"{value:.4g}"


def make_rubin2007(case):
    """The maxima of each scheme over the cycle."""
    rows = []
    for row in case["rows"]:
        measured = ["diverges", "", ""] if row["diverged"] else [
            significant(row[key]) for key in ("error_orientation", "error_momentum", "error_energy")]
        rows.append([row["scheme"], str(row["steps"]), significant(row["max_theta_deg"]), *measured,
                     significant(row["iterations_per_step"])])
    return table(("scheme", "N", "largest θ, degrees", "E_Λ", "E_H", "E_T", "linear solves a step"), rows)


def make_rod_schemes(case):
    rows, before = [], (None, None)
    for row in case["rows"]:
        names = [name if name != old else "" for name, old in zip((row["case"], row["scheme"]), before)]
        if names[0]:
            names[1] = row["scheme"]
        before = (row["case"], row["scheme"])
        errors = [error_text(row[f"{key}_error"]) for key in ("position", "rotation", "energy", "momentum")]
        measured = [*errors, str(row["newton_iterations"])] if row["converged"] else ["does not converge"] + [""] * 4
        rows.append([*names, str(row["steps"]), *measured])
    return table(("motion", "scheme", "steps", "position", "rotation", "energy", "momentum", "Newton iterations"), rows)


# Studies whose rows are their own.
RUNS = {"rubin2007": make_rubin2007, "rod_schemes": make_rod_schemes}


def make_runs(name, case):
    return RUNS.get(name, make_refinements)(case)
