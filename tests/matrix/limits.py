"""The list of what does not go together, in docs/guide/limits.md: made from verdicts of the campaign, and read again."""

import itertools
import pathlib
import re

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "guide" / "limits.md"
BEGIN = "<!-- made by tests/matrix/campaign -->\n"
END = "<!-- end of what the campaign makes -->\n"
PLACE = re.compile(r"^(?:gxrod(?: \w+)?: |error: |[\w./]+\.(?:toml|vtkhdf)(?::\d+:\d+)?: )+")


def reason(words):
    """The message of a refusal in one line, without the place in a deck."""
    lines = [line for line in words.splitlines() if line.strip() and "warning" not in line and not line.startswith(("  ", "\t", "note"))]
    line = next((line for line in lines if "error" in line), lines[0] if lines else "")
    line = PLACE.sub("", line.strip())
    return line.replace("|", "or").strip()


def refused(rows):
    """Each feature refused by itself: {(kind, reason): [feature, …]}, in the order of the campaign."""
    found = {}
    for row in rows:
        if row["verdict"] == "refused" and "+" not in row["features"]:
            found.setdefault((row["kind"], reason(row["words"])), []).append(row["features"])
    return found


def text_of(rows):
    """The section of the page."""
    singles = [row for row in rows if "+" not in row["features"]]
    cells = refused(singles)
    merged = {}
    for (kind, why), features in cells.items():
        merged.setdefault((tuple(features), why), []).append(kind)
    count = sum(len(features) for features in cells.values())
    lines = [f"A cantilever with each of {len({row['features'] for row in singles})} features has been put into each of "
             f"{len({row['kind'] for row in singles})} kinds of analyses, schemes, derivatives and services. Of these {len(singles)} "
             f"cells {count} are refused:", "", "| kind | feature | why |", "|---|---|---|"]
    gradients = {row["kind"] for row in singles if row["kind"].startswith("gradient")}
    for (features, why), names in sorted(merged.items(), key=lambda entry: entry[1]):
        if len(gradients) > 1 and gradients <= set(names):
            names = [name for name in names if name not in gradients] + ["every gradient"]
        lines.append(f"| {', '.join(names)} | {', '.join(features)} | {why} |")
    return "\n".join(lines) + "\n"


def rewrite(rows):
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(BEGIN)
    after = rest.split(END)[1]
    PAGE.write_text(f"{before}{BEGIN}\n{text_of(rows)}\n{END}{after}", encoding="utf-8")


def cells_of_page():
    """(kind, feature, reason) of each cell that the page says is refused."""
    section = PAGE.read_text(encoding="utf-8").split(BEGIN)[1].split(END)[0]
    for line in section.splitlines():
        parts = [part.strip() for part in line.strip("|").split(" | ")]
        if not line.startswith("| ") or len(parts) != 3 or parts[0] == "kind":
            continue
        for kind, feature in itertools.product(parts[0].split(", "), parts[1].split(", ")):
            yield kind, feature, parts[2]
