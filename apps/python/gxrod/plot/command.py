"""The command line of gxrod-plot."""

import argparse
import sys
from pathlib import Path

import numpy  # noqa: F401 — before h5py, which takes itself for missing without it
import h5py  # noqa: F401 — gxrod-plot says that it is missing before anything else
import matplotlib

from ..seal import doubt_of
from .compare import draw_runs, read_run, short_names
from .convergence import read_convergence
from .error_figure import describe_errors, draw_errors, write_latex
from .errors import FileFault, PlotError, UsageError
from .page import draw_page
from .results import read_results
from .rubin2007 import draw_figures

FORMATS = (".png", ".svg", ".pdf")
EPILOG = """\
examples:
  gxrod-plot flyer.vtkhdf                          shapes, ledger and histories in flyer.png
  gxrod-plot flyer.vtkhdf --what shapes --times 0 2.5 5 -o shapes.svg
  gxrod-plot frame.vtkhdf --what stress --measure exposure
  gxrod-plot frame.vtkhdf --what section --rod beam --at 1.5 --times 2 -o section.svg
  gxrod-plot riser.vtkhdf --what range --rod riser --stage storm -o range.svg
  gxrod-plot flyer.vtkhdf --what histories --history tip root/moment
  gxrod-plot coarse.vtkhdf fine.vtkhdf --history tip/displacement
  gxrod-plot column.vtkhdf --x top/displacement/y --y load-factor --size 6 4 --no-title
  gxrod-plot sweep --error                         errors of a batch over its mesh or step, with their orders
  gxrod-plot --figures figures                     Figs. 2-4 from `gxrod verify rubin2007 --figures figures`

exit codes: 0 done, 2 usage, 4 a file could not be read or written"""


def main(arguments):
    request = parse(arguments)
    matplotlib.use("Agg")
    try:
        if request.figures:
            written = draw_figures(Path(request.figures), request.format, save)
        elif request.error:
            written = draw_convergence(request)
        else:
            written = [draw(request)]
    except PlotError as error:
        print(f"gxrod-plot: {error}", file=sys.stderr)
        return error.exit_code
    for path in written:
        print(path)
    return 0


def draw(request):
    """Draws the requested results; returns the picture's path."""
    output = output_path(request)
    warn_of_doubt(request.results)
    if is_comparison(request):
        if request.what in ("stress", "section", "range"):
            raise UsageError(f"{request.what} needs one file, without --x and --y")
        if request.what == "shapes" or request.times or request.frames or request.view:
            raise UsageError("shapes need one file, without --x and --y")
        names = short_names(request.results)
        runs = [read_results(path, lambda results, name=name: read_run(results, request, name))
                for path, name in zip(request.results, names)]
        save(draw_runs(runs, request), output)
    else:
        read_results(request.results[0], lambda results: save(draw_page(results, request), output))
    return output


def draw_convergence(request):
    """Draws errors of a batch or a study, prints their tables; returns the paths of picture and table."""
    if len(request.results) != 1:
        raise UsageError("--error needs one folder of a batch, or one study")
    output = output_path(request)
    panels = read_convergence(request.results[0], request)
    save(draw_errors(panels, request), output)
    print(describe_errors(panels))
    if not request.latex:
        return [output]
    table = output.with_suffix(".tex")
    try:
        table.write_text(write_latex(panels), encoding="utf-8")
    except OSError as error:
        raise FileFault(f"{table}: cannot be written: {error.strerror or error}") from error
    return [output, table]


def warn_of_doubt(paths):
    for path in paths:
        if Path(path).is_file() and (doubt := doubt_of(path)):
            print(f"warning: {path}: {doubt}", file=sys.stderr)


def is_comparison(request):
    return len(request.results) > 1 or bool(request.x or request.y)


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="gxrod-plot", description="Draws the results of gxrod.", epilog=EPILOG, allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="*", metavar="RESULTS.vtkhdf",
                        help="results file, also of a running or killed job; histories or energies of several files "
                             "are drawn in one figure, a colour for each file")
    parser.add_argument("-o", "--output", metavar="FILE", help="picture, .png, .svg or .pdf (RESULTS.png)")
    parser.add_argument("--what", choices=("shapes", "histories", "ledger", "found", "stress", "section", "range", "all"), default="all",
                        help="found: what stages of modes, buckling, eigenvalues and response found; stress: the largest of all steps "
                             "along rods; section: the stresses in a section; range: least, largest and mean values along rods (these three not in all)")
    parser.add_argument("--history", nargs="+", action="extend", metavar="NAME", default=[],
                        help="histories to draw, NAME or NAME/QUANTITY (all)")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--times", nargs="+", type=float, metavar="T", help="times of the shapes to draw")
    which.add_argument("--frames", type=positive_integer, metavar="N", help="how many shapes to draw (12)")
    parser.add_argument("--view", choices=("xy", "xz", "yz", "3d"),
                        help="plane or space (by default space, or the plane that holds everything)")
    parser.add_argument("--rod", nargs="+", action="extend", metavar="NAME", default=[], help="rods of stress, section and range (all)")
    parser.add_argument("--at", type=float, metavar="S",
                        help="arc length of the section on its --rod, at the last frame or that of --times (by default where and when the "
                             "largest stress is)")
    parser.add_argument("--measure", choices=("von-mises", "exposure"), default="von-mises", help="of stress, and of the largest one (von-mises)")
    parser.add_argument("--quantity", nargs="+", action="extend", metavar="NAME", default=[],
                        help="quantities of range, as bending_moment, wall_tension, moment/y (tensions, bending moment and curvature)")
    parser.add_argument("--from", dest="start", type=float, metavar="T", help="first time of range (of stages with time)")
    parser.add_argument("--to", dest="end", type=float, metavar="T", help="last time of range")
    parser.add_argument("--stage", metavar="NAME", help="stage of range, instead of times")
    parser.add_argument("--x", metavar="NAME", help="what to draw over instead of time: time, ledger/ENERGY, or "
                                                    "NAME/QUANTITY/COMPONENT of a history; COMPONENT is w, x, y, z or magnitude")
    parser.add_argument("--y", nargs="+", action="extend", metavar="NAME", default=[],
                        help="what to draw, named as for --x; without a component, all of them")
    parser.add_argument("--error", action="store_true",
                        help="of the folder of a batch: errors of what it collects over the key that it refines (--x KEY), against the finest "
                             "run, with their orders; or of the file that `gxrod verify DECK --json` printed")
    parser.add_argument("--reference", type=float, metavar="VALUE", help="exact value of the column --y, for --error")
    parser.add_argument("--latex", action="store_true", help="with --error: also writes its tables, next to the picture, as .tex")
    parser.add_argument("--size", nargs=2, type=positive_number, metavar=("WIDTH", "HEIGHT"),
                        help="size of the picture in inches (by default what its contents need)")
    titles = parser.add_mutually_exclusive_group()
    titles.add_argument("--title", metavar="TEXT", help="heading (by default the deck's title; none for several files)")
    titles.add_argument("--no-title", action="store_true", help="no heading")
    parser.add_argument("--figures", metavar="DIR",
                        help="draw the figures of the rubin2007 study from DIR/fig*.csv")
    parser.add_argument("--format", choices=("png", "svg", "pdf"), default="png", help="format of --figures (png)")
    request = parser.parse_args(arguments)
    request.window = (request.start, request.end, request.stage)
    if request.what != "range" and (request.quantity or request.window != (None, None, None)):
        parser.error("--quantity, --from, --to and --stage go with --what range")
    if not request.error and (request.latex or request.reference is not None):
        parser.error("--reference and --latex go with --error")
    if bool(request.results) == bool(request.figures):
        parser.error("give a results file, or --figures DIR")
    return request


def positive_number(text):
    number = float(text)
    if not 0.5 <= number <= 100.0:
        raise argparse.ArgumentTypeError("must be from 0.5 to 100 inches")
    return number


def positive_integer(text):
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError("must be at least 1")
    return number


def output_path(request):
    path = Path(request.output) if request.output else Path(Path(request.results[0]).resolve().stem + ".png")
    if path.suffix.lower() not in FORMATS:
        raise UsageError(f"{path}: pictures end in {', '.join(FORMATS)}")
    return path


def save(figure, path):
    """Writes the figure; the same figure gives the same file."""
    dates = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
    try:
        figure.savefig(path, metadata=dates.get(path.suffix.lower(), {}))
    except OSError as error:
        raise FileFault(f"{path}: cannot be written: {error.strerror or error}") from error
