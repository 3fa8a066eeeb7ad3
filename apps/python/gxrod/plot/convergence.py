"""Errors over a mesh or a step: of a batch that refines it, or of a study by `gxrod verify DECK --json`."""

import json
from pathlib import Path

import numpy as np

from .batch_errors import BatchErrors
from .error_lines import Line, Panel
from .errors import FileFault, UsageError

PARTS = (("steps", "steps", ("half the step", "twice the load steps", "1/16 of the tolerance")), ("mesh", "elements", ("twice the elements",)))


def read_convergence(path, request):
    """Panels of a batch's folder, or of a study's JSON."""
    path = Path(path)
    if path.is_dir() or path.name == "index.csv":
        return BatchErrors(path if path.is_dir() else path.parent, request).panels()
    if path.suffix == ".json":
        return read_study(path)
    raise UsageError(f"{path}: --error takes the folder of a batch, or what `gxrod verify DECK --json` printed, as a file .json")


def read_study(path):
    """Of `gxrod verify DECK --json`: how much each series still changes when step or mesh are halved."""
    try:
        study = json.loads(path.read_text(encoding="utf-8"))
        runs, series = study["runs"], study["series"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise FileFault(f"{path}: is not what `gxrod verify DECK --json` prints") from error
    panels = []
    for part, across, finer in PARTS:
        counts = [next((run[across] for run in runs if run["run"] in names), None) for names in (("as it is",), finer)]
        if None in counts:
            continue
        x = np.array(counts, dtype=float)
        lines = []
        for one in series:
            differences = np.array((one[part] or {}).get("differences", []), dtype=float)
            least = max(10.0 * (one.get("round_off") or 0.0), 1e-10 * one["scale"])
            if len(differences) == 2 and one["scale"] > 0 and (differences > 0).all() and differences[0] > least:
                lines.append(Line(f"{one['point']} {one['quantity'].replace('_', ' ')}", x, differences, differences / one["scale"], 1.0))
        if lines:
            panels.append(Panel(f"{study.get('title') or study.get('deck', '')}: {across}", across, "change by halving, relative",
                                "the run with half the step" if part == "steps" else "the run with twice the elements", lines))
    if not panels:
        raise UsageError(f"{path}: has no differences of two refinements; run gxrod verify with --levels 2")
    return panels
