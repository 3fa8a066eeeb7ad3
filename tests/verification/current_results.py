#!/usr/bin/python3
"""current_results.py NAME: runs `gxrod verify NAME` and compares it with results.json of the validation book."""

import os
import pathlib
import sys

SOURCE = pathlib.Path(os.environ["GXROD_SOURCE"])
sys.path.insert(0, str(SOURCE / "docs" / "verification"))

from book.comparison import compare  # noqa: E402 — after the path to it
from book.results import gather, read_kept, run_cases  # noqa: E402


def main():
    name = sys.argv[1]
    found, code = run_cases(os.environ["GXROD"], [name])
    if code:
        sys.exit(f"`gxrod verify {name}` ends with exit code {code}")
    kept = read_kept()["cases"].get(name)
    if kept is None:
        sys.exit(f"results.json has no {name}: renew the book with docs/verification/make_book.py")
    faults = compare(name, gather(found, {name: kept["sentence"]})[name], kept)
    if faults:
        sys.exit("\n".join([f"{name} is not what tests/data/results.json has:", *faults,
                            "If this is meant, renew the book with docs/verification/make_book.py"]))
    print(f"{name}: {len(kept['rows'])} runs and {len(kept['checks'])} checks as in results.json")


if __name__ == "__main__":
    main()
