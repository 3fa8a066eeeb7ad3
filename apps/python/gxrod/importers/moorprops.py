"""MoorPy's library of line materials, MoorProps.yaml: properties of a line as polynomials of its nominal diameter."""

from __future__ import annotations

from math import pi, sqrt
from pathlib import Path
from typing import Any

from ..errors import FileError
from ..typed import AnyPath
from .mooring import LineType
from .mooring_deck import section
from .text import ImportFault, read_text
from .writing import quoted

USED = ("mass_d2", "dvol_dnom", "density", "EA_0", "EA_d", "EA_d2", "EA_d3", "EA_MBL", "MBL_0", "MBL_d", "MBL_d2", "MBL_d3", "Cd", "Cd_ax", "Ca", "Ca_ax")
SLENDER = 1e-3  # EI over that of a solid rod of the same EA


def is_moorprops(text: str) -> bool:
    return any(line.startswith("lineProps:") for line in text.splitlines())


def read_moorprops(path: AnyPath, name: str, diameter: float) -> LineType:
    """The material `name` of MoorPy's library for lines of a nominal diameter in m.

    Needs PyYAML. EA is the quasi-static one; where the library gives it by the breaking load, that times the factor.

    Raises FileError if the file, or the material in it, cannot be used.
    """
    materials = read_materials(Path(path))
    if name not in materials:
        raise ImportFault(f'{path}: lineProps: there is no "{name}"; give --line {" | ".join(map(str, materials))}')
    found = Material(f"{path}: lineProps: {name}", materials[name])
    mass = found.value("mass_d2") * diameter**2
    volume_diameter = diameter * found.value("dvol_dnom") if found.has("dvol_dnom") else sqrt(4.0 * mass / (pi * found.need("density", "dvol_dnom or density")))
    EA = found.polynomial("EA", diameter) + found.value("EA_MBL") * found.polynomial("MBL", diameter)
    if min(mass, EA, diameter) <= 0.0:
        raise ImportFault(f"{found.where}: mass and EA come out as {mass:g} and {EA:g}, not above 0; give another diameter than {diameter:g} m")
    idle = [str(key) for key in found.values if key not in USED]
    notes = [f"not used: {', '.join(idle)}"] if idle else []
    return LineType(name, volume_diameter, mass, EA, SLENDER * EA * volume_diameter**2 / 16, 0.0, (found.value("Cd"), found.value("Cd_ax")), (found.value("Ca"), found.value("Ca_ax")), notes)


def read_materials(path: Path) -> dict[str, Any]:
    text = read_text(path)
    try:
        import yaml
    except ImportError as error:
        raise ImportFault(f"{path}: MoorPy's library needs PyYAML; install python3-yaml, or pip install pyyaml") from error
    try:
        materials = yaml.safe_load(text)["lineProps"]
    except (yaml.YAMLError, KeyError, TypeError) as error:
        raise ImportFault(f"{path}: expected a YAML file with lineProps ({' '.join(str(error).split())}); give MoorPy's MoorProps file") from error
    if not isinstance(materials, dict):
        raise ImportFault(f"{path}: lineProps has no materials; give MoorPy's MoorProps file")
    return materials


class Material:
    """Coefficients of one material; those that are missing are 0, as in MoorPy."""

    def __init__(self, where: str, values: Any) -> None:
        self.where = where
        self.values = values if isinstance(values, dict) else {}

    def has(self, key: str) -> bool:
        return key in self.values

    def value(self, key: str) -> float:
        value = self.values.get(key, 0.0)
        try:
            return float(value)
        except (TypeError, ValueError):
            raise ImportFault(f'{self.where}: expected a number for {key}, found "{value}"; correct it') from None

    def need(self, key: str, what: str) -> float:
        if not self.value(key) > 0.0:
            raise ImportFault(f"{self.where}: there is no {what}; give one of them")
        return self.value(key)

    def polynomial(self, name: str, diameter: float) -> float:
        """Of the diameter, to its third power."""
        return sum(self.value(f"{name}_{power}") * diameter**i for i, power in enumerate(("0", "d", "d2", "d3")))


def write_section(kind: LineType, path: AnyPath, *, source: str = "", name: str | None = None) -> list[Path]:
    """Writes a [section.NAME], to be put into a deck, and returns its path.

    source: of the comment. name: of the section, by default that of the type.

    Raises FileError if it cannot be written.
    """
    comment = f"EI: {SLENDER:g} of that of a solid rod of the same EA; the library has none."
    text = (f"# {quoted(kind.name)[1:-1]}{source and f', imported by gxrod-import from {source}'}. SI units.\n# {comment}\n" + "".join(f"# {each}\n" for each in kind.notes) + section(kind, name or kind.name, (kind.EI, "")) + "\n")
    deck = Path(path)
    try:
        deck.write_text(text, encoding="utf-8")
    except OSError as error:
        raise FileError(f"{deck}: cannot be written: {error.strerror or error}") from error
    return [deck]
