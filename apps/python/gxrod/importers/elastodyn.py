"""ElastoDyn of OpenFAST: a table of masses and bending stiffnesses. It has no torsion, shear or extension, no curve and no length."""

from __future__ import annotations

import numpy as np

from ..typed import AnyPath, Array
from .blade import Blade, check_blade
from .text import Lines, UnusedKeys, to_number

COLUMNS = ("BlFract", "StrcTwst", "BMassDen", "FlpStff", "EdgStff")
USED = ("NBlInpSt", "FlStTunr1", "FlStTunr2", "FlStTunr(1)", "FlStTunr(2)", "AdjBlMs", "AdjFlSt", "AdjEdSt")
# Modes of ElastoDyn, which a rod has by itself.
NOT_NEEDED = tuple(f"{mode}({power})" for mode in ("BldFl1Sh", "BldFl2Sh", "BldEdgSh") for power in range(2, 7))
STIFF = 1e6  # EA and GA: so many times the larger EI over the length squared
STIFF_TORSION = 10.0  # GJ: so many times EI flapwise + edgewise
SLENDER = 1e-3  # radius of gyration over the length


def is_elastodyn(text: str) -> bool:
    return "BlFract" in text and "BMassDen" in text


def read_elastodyn(path: AnyPath, length: float | None) -> Blade:
    """`length`: of the blade, which the file does not say."""
    lines = Lines(path)
    if length is None:
        raise lines.fault("an ElastoDyn blade file does not say how long the blade is", "give --length, the TipRad − HubRad of ElastoDyn's primary file", 0)
    table, first = read_table(lines)
    masses, flapwise, edgewise = scale(lines, table)
    found = Blade(title=lines.lines[1].strip(), source=f"ElastoDyn: {lines.path.name}", fractions=table["BlFract"],
                  stiffness=stiffness_of(flapwise, edgewise, length), mass=mass_of(masses, length),
                  points=np.array([[0.0, 0.0, 0.0], [0.0, 0.0, length]]), twist_fractions=table["BlFract"], twist=-np.radians(table["StrcTwst"]),
                  notes=[f"{note_of_bending()}. For a blade that twists, import a BeamDyn, HAWC2 or windIO file"])
    found.warnings += [*tuned(lines), *damped(lines), *idle_columns(lines)]
    unused = find_unused(lines)
    found.notes += unused.notes("ElastoDyn's modes")
    found.warnings += unused.warnings()
    return check_blade(found, lambda i, what, todo: lines.fault(what, todo, first + i))


def note_of_bending() -> str:
    return (f"ElastoDyn has bending and mass only. Assumed: a straight axis through all centres, no couplings; extension and shear stiff (EA = GA = {STIFF:g} EI/L²), "
            f"torsion stiff (GJ = {STIFF_TORSION:g} times the sum of both EI), hardly any rotary inertia (radius of gyration {SLENDER:g} L)")


def read_table(lines: Lines) -> tuple[dict[str, Array], int]:
    """Columns by name, and the line of their first row."""
    header = lines.find(lambda line: "BlFract" in line and "BMassDen" in line)
    names = lines[header].split()
    if missing := [name for name in COLUMNS if name not in names]:
        raise lines.fault(f"there is no column {missing[0]} among {', '.join(names)}", "give a blade file of ElastoDyn", header)
    count = int(value_of(lines, "NBlInpSt"))
    lines.at = header + 2  # a line of units
    rows = np.array([lines.numbers(len(names), f"row {i + 1} of {count}") for i in range(count)])
    return {name: rows[:, names.index(name)] for name in COLUMNS}, lines.at - count


def value_of(lines: Lines, key: str, default: float | None = None, what: str = "give a whole blade file of ElastoDyn") -> float:
    """Of `value key - …`; names of old files have brackets, BldFlDmp(1)."""
    line = lines.find(lambda text: text.split()[1:2] == [key])
    if not line and default is not None:
        return default
    if not line:
        raise lines.fault(f"there is no line with {key}", what, 0)
    lines.at = line + 1
    return lines.number(lines[line].split()[0], f"expected a number for {key}")


def scale(lines: Lines, table: dict[str, Array]) -> tuple[Array, Array, Array]:
    """Mass per length, flapwise and edgewise EI, with the factors of the file."""
    factors = [value_of(lines, key, 1.0) for key in ("AdjBlMs", "AdjFlSt", "AdjEdSt")]
    masses, flapwise, edgewise = (factor * table[name] for factor, name in zip(factors, ("BMassDen", "FlpStff", "EdgStff")))
    return masses, flapwise, edgewise


def tuned(lines: Lines) -> list[str]:
    """A warning of factors by mode, which a beam does not have."""
    factors = [value_of(lines, f"FlStTunr{end}", 1.0) for end in ("1", "2", "(1)", "(2)")]
    return ["the factors FlStTunr on the stiffness by mode were left out"] if set(factors) != {1.0} else []


def damped(lines: Lines) -> list[str]:
    """A warning of damping by mode."""
    values = [value_of(lines, f"{key}{end}", 0.0) for key in ("BldFlDmp", "BldEdDmp") for end in ("1", "2", "(1)", "(2)")]
    return ["damping by mode (BldFlDmp, BldEdDmp) was left out: gxrod damps by strains"] if any(values) else []


def idle_columns(lines: Lines) -> list[str]:
    """A warning of columns that no deck gets, where they have numbers other than 0."""
    header = lines.find(lambda line: "BlFract" in line and "BMassDen" in line)
    names = lines[header].split()
    rows = [line.split() for line in lines.lines[header + 1:header + 1 + int(value_of(lines, "NBlInpSt"))]]
    idle = [name for i, name in enumerate(names) if name not in (*COLUMNS, "PitchAxis", "AeroCent") and any(to_number(row[i]) for row in rows if len(row) > i)]
    return [f"columns that were not used: {', '.join(idle)}"] if idle else []


def find_unused(lines: Lines) -> UnusedKeys:
    unused = UnusedKeys("key", USED, NOT_NEEDED)
    for line in lines.lines:
        words = line.split()
        if len(words) > 2 and words[2] == "-" and to_number(words[0]) is not None and words[1] not in USED and not words[1].startswith(("BldFlDmp", "BldEdDmp")):
            unused.add(words[1])
    return unused


def stiffness_of(flapwise: Array, edgewise: Array, length: float) -> Array:
    """[n,6,6]."""
    large = STIFF * np.maximum(flapwise, edgewise) / length**2
    return diagonals(large, large, large, STIFF_TORSION * (flapwise + edgewise), edgewise, flapwise)


def mass_of(masses: Array, length: float) -> Array:
    """[n,6,6]."""
    inertia = masses * (SLENDER * length) ** 2
    return diagonals(masses, masses, masses, 2.0 * inertia, inertia, inertia)


def diagonals(*entries: Array) -> Array:
    return np.array([np.diag(row) for row in zip(*entries)])


