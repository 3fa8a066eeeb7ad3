#!/usr/bin/python3
"""Renews the validation book: runs every case of `gxrod verify`, keeps the numbers in results.json, and makes
the tables and pictures of the pages anew. What is written by hand around the tables stays.
"""

import argparse
import sys

from book import cases

sys.path.insert(0, str(cases.SOURCE / "apps" / "python"))

from book.check import find_faults  # noqa: E402 — after the path to gxrod.plot
from book.figures import draw_figures  # noqa: E402
from book.pages import write_pages  # noqa: E402
from book.results import read_kept, run_book, write_kept  # noqa: E402


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", nargs="?", help="gxrod [build/release/gxrod]")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--pages", action="store_true", help="renew pages and pictures from results.json, without a run")
    what.add_argument("--check", action="store_true", help="change nothing; report what is not current")
    what.add_argument("--only", nargs="+", metavar="NAME", help="run these cases; keep the others as they are")
    parser.add_argument("--figures", action="store_true", help="draw all pictures, not only those whose data changed")
    return parser.parse_args()


def end(faults):
    """Exit code 1 and the faults, if there are any."""
    for fault in faults:
        print(f"make_book.py: {fault}", file=sys.stderr)
    sys.exit(1 if faults else 0)


def main():
    arguments = read_arguments()
    program = cases.find_program(arguments.program)
    if arguments.check:
        end(find_faults(read_kept(), program))
    if not arguments.pages:
        names = arguments.only or []
        write_kept(run_book(program, names, read_kept() if names else None))
    kept = read_kept()
    draw_figures(kept, arguments.figures)
    end(write_pages(kept))


if __name__ == "__main__":
    main()
