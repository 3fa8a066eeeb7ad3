"""Range graphs: the least, largest and mean value of quantities along rods over a window of time."""

from ..errors import Error
from .errors import UsageError
from .stresses import choose_rods
from .style import BLUE, ORANGE, legend_above

HEIGHT = 2.4  # of a panel
DEFAULT = ("effective_tension", "wall_tension", "bending_moment", "bending_curvature")
MOST_RODS = 4  # that are drawn if nobody chooses


def read_ranges(results, request):
    """[rod][quantity] of the request's rods and quantities."""
    opened = results.results
    rods = choose_rods(results, request.rod)
    if not rods:
        raise UsageError("the file has no rods")
    if not request.rod and len(rods) > MOST_RODS:
        raise UsageError(f"the file has {len(rods)} rods; choose with --rod: {', '.join(rods[:20])}{' …' if len(rods) > 20 else ''}")
    rows = []
    for name in rods:
        rod = opened.rod(name)
        wanted = request.quantity or [each for each in DEFAULT if each in rod.names]
        try:
            rows.append([rod.range(each, *request.window) for each in wanted])
        except (Error, ValueError) as error:
            raise UsageError(str(error)) from error
    return rows


def draw_ranges(figure, results, rows):
    """A row of panels for each quantity, a column for each rod."""
    grid = figure.subplots(len(rows[0]), len(rows), squeeze=False, sharex="col")
    length = results.unit_of("length")
    for column, ranges in enumerate(rows):
        for line, one in enumerate(ranges):
            draw_range(grid[line, column], one, results)
        grid[-1, column].set_xlabel(f"arc length of {ranges[0].rod}" + (f", {length}" if length != "length" else ""))


def draw_range(axes, one, results):
    axes.fill_between(one.arc_length, one.least, one.largest, color=BLUE, alpha=0.18, linewidth=0.0)
    for values in (one.least, one.largest):
        axes.plot(one.arc_length, values, color=BLUE, linewidth=0.9, label="least and largest" if values is one.largest else None)
    axes.plot(one.arc_length, one.mean, color=ORANGE, linewidth=1.4, linestyle=(0, (5, 3)), label="mean")
    axes.margins(x=0.01)
    words = one.quantity.replace("_", " ").replace("/", " ")
    clock = results.time_label if results.is_static else "t"
    axes.set_title(f"{words}, {clock} = {one.window[0]:.4g} to {one.window[1]:.4g}")
    axes.set_ylabel(one.unit)
    legend_above(axes, 2)
