"""Where a C++ source can be made wrong by one sign or one coefficient, and how."""

import dataclasses
import pathlib
import re

SOURCE = pathlib.Path(__file__).resolve().parents[2]
GROUPS = {
    "rotation": ["src/rotation/*.cpp", "src/rotation/*.hpp"],
    "strain and tangent": ["src/elements/*.cpp", "src/elements/*.hpp", "src/elements/rod/*.cpp", "src/elements/rod/*.hpp"],
    "several elements at once": ["src/elements/lanes/*.cpp", "src/elements/lanes/*.hpp"],
    "time integration": ["src/integrators/*.cpp", "src/integrators/*.hpp"],
    "loads and supports": ["src/loads/*.cpp", "src/constraints/*.cpp"],
}

# Code that is not computed with: comments, texts, the preprocessor, what a debug build asserts, how many rows arrays have.
SKIPPED = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#[^\n]*'
                     r'|\b(?:static_assert|assert)\s*\([^;]*;|^[ \t]*template\s*<[^>]*>'
                     r'|\bconstexpr int \w+_rows = [^;]*;', re.DOTALL | re.MULTILINE)
OPERAND = r"[\w)\]]"
BINARY = re.compile(rf"(?<={OPERAND} )(?P<sign>[+-])(?=\s+[\w(\-])")
COMPOUND = re.compile(rf"(?<={OPERAND} )(?P<sign>[+-])=(?= )")
UNARY = re.compile(r"(?:(?<=[=,?:*/] )|(?<=[({\[<])|(?<=return ))(?P<sign>-)(?=[\w(])")
NUMBER = re.compile(r"(?<![\w.])(?P<number>\d+\.\d*(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)(?![\w.])")
# Real numbers that are known when compiled, and what computes them.
CONSTANT = re.compile(r"^(?P<before> *(?:inline |static )?)constexpr (?=(?:std::array<(?:long )?double|auto|double|long double|Switches)\b)",
                      re.MULTILINE)


@dataclasses.dataclass
class Site:
    """A place in a file: start and end of what is replaced, and by what, at run time or for good."""
    file: str
    line: int
    kind: str  # "sign" or "coefficient"
    start: int
    end: int
    code: str  # what is there, with its neighbours
    switched: str  # with MUTANT for the number of the site
    replaced: str
    number: int = 0

    @property
    def place(self):
        """Which it is, for a record of it."""
        return self.file, self.line, self.code


def blank(text):
    """The text with what is not computed with as spaces, at the same places."""
    return SKIPPED.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def change_digit(number):
    """A coefficient that is another in its last digit, or its fifth: 0.5 and 0.6, 2.0 and 2.1, 39.478417 and 39.479417."""
    mantissa, exponent = re.fullmatch(r"([\d.]+)((?:[eE].*)?)", number).groups()
    if mantissa.endswith("."):
        mantissa += "0"
    digits = [i for i, character in enumerate(mantissa) if character.isdigit()]
    leading = next((k for k, i in enumerate(digits) if mantissa[i] != "0"), 0)
    at = digits[min(len(digits) - 1, leading + 4)]
    changed = str(int(mantissa[at]) + 1) if mantissa[at] != "9" else "8"
    return mantissa[:at] + changed + mantissa[at + 1:] + exponent


def find_sites(file, text):
    """All sites of a source, in their order."""
    code = blank(text)
    found = []

    def add(match, group, kind, switched, replaced):
        start, end = match.start(group), match.end(group)
        line = text.count("\n", 0, start) + 1
        found.append(Site(file, line, kind, start, end, " ".join(text[max(0, start - 24):end + 24].split()), switched, replaced))

    other = {"+": "-", "-": "+"}
    for match in BINARY.finditer(code):
        sign = match["sign"]
        add(match, "sign", "sign", f"{sign} gxrod_sign(MUTANT) *", other[sign])
    for match in COMPOUND.finditer(code):
        start, end = match.start("sign"), match.end("sign") + 1
        line = text.count("\n", 0, start) + 1
        sign = match["sign"]
        found.append(Site(file, line, "sign", start, end, " ".join(text[max(0, start - 24):end + 24].split()),
                          f"{sign}= gxrod_sign(MUTANT) *", f"{other[sign]}="))
    for match in UNARY.finditer(code):
        add(match, "sign", "sign", "-gxrod_sign(MUTANT) * ", "")
    for match in NUMBER.finditer(code):
        changed = change_digit(match["number"])
        add(match, "number", "coefficient", f"gxrod_coefficient(MUTANT, {match['number']}, {changed})", changed)
    return sorted(found, key=lambda site: site.start)


def apply(text, sites, how):
    """The text with these sites changed: how(site) is the new text."""
    for site in sorted(sites, key=lambda site: -site.start):
        text = text[:site.start] + how(site) + text[site.end:]
    return text


def loosen(file, text):
    """The text with real constants computed at run time, where a switch can make them wrong."""

    def replace(match):
        before = match["before"]
        if "static" in before and file.endswith(".hpp"):
            return before + "inline const "
        return before + "const " if before else "inline const "

    return CONSTANT.sub(replace, text)


def list_files():
    """All sources that can be made wrong."""
    patterns = [pattern for group in GROUPS.values() for pattern in group]
    return {path.relative_to(SOURCE).as_posix() for pattern in patterns for path in SOURCE.glob(pattern)}


def collect_sites(groups):
    """All sites of these groups, numbered from 1 on in an order that does not depend on the choice of groups."""
    sites, number = [], 0
    for group, patterns in GROUPS.items():
        for pattern in patterns:
            for path in sorted(SOURCE.glob(pattern)):
                file = path.relative_to(SOURCE).as_posix()
                for site in find_sites(file, path.read_text()):
                    number += 1
                    site.number = number
                    if group in groups:
                        sites.append((group, site))
    return sites
