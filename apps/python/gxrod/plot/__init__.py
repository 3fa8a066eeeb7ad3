"""Pictures of gxrod's results: shapes, histories, the energy ledger, what stages find. The program gxrod-plot draws by this."""

from types import SimpleNamespace

from ..installing import pip_install


def draw(results, what="shapes", history=(), times=None, frames=None, view=None, size=None, title=None, rod=(), at=None, measure="von-mises",
         quantity=(), window=(None, None, None)):
    """A matplotlib Figure of opened results, as gxrod-plot draws it.

    what: "shapes", "histories", "ledger", "found" (modes, buckling, answers), "stress" (the largest along rods), "section" (where that is,
    or at the arc length `at` of a `rod` and the first of `times`), "range" (least, largest and mean values of `quantity` along rods over a `window`: start,
    end and stage) or "all". rod: a name or several. measure: "von-mises" or "exposure". history: names, "tip" or
    "tip/position"; all if left out. times: of the shapes, in statics load factors; or frames: how many of them. view:
    "xy", "xz", "yz" or "3d"; by default the plane that holds everything, or space. size: width and height in inches.
    title: a heading; False: none.
    """
    try:
        import matplotlib
        import matplotlib.pyplot
    except ImportError as missing:
        raise ImportError(f"pictures of gxrod need matplotlib: {pip_install('matplotlib')}") from missing
    from .errors import UsageError
    from .page import draw_page
    from .results import Results

    kinds = ("shapes", "histories", "ledger", "found", "stress", "section", "range", "all")
    if what not in kinds:
        raise UsageError(f"there is no picture {what!r}; there are {', '.join(kinds)}")
    history = [history] if isinstance(history, str) else list(history)
    request = SimpleNamespace(results=[str(results.path)], what=what, history=history, rod=[rod] if isinstance(rod, str) else list(rod), at=at, measure=measure, quantity=[quantity] if isinstance(quantity, str) else list(quantity), window=window, times=times, frames=frames, view=view,
                              size=size, title=title or "", no_title=title is False)
    # Settings of the caller are as before afterwards.
    with matplotlib.rc_context():
        figure = draw_page(Results(results), request)
    if "inline" in matplotlib.get_backend().lower():
        matplotlib.pyplot.close(figure)  # a notebook shows what a cell returns; it would show open figures once more
    return figure


def main():
    """The program gxrod-plot."""
    import sys

    from .command import main as run

    sys.exit(run(sys.argv[1:]))
