"""A blade as a deck that runs at once, with its sections in a CSV file beside it."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from ..errors import FileError
from ..typed import AnyPath, Array
from .axes import UPPER
from .blade import Blade, flapwise
from .curve import Curve

SAME = 1e-6  # fractions nearer than that are one
COLUMNS = ["fraction", "twist", *(f"{matrix}{i}{j}" for matrix in "KM" for i in range(1, 7) for j in range(i, 7))]


def write_deck(blade: Blade, path: AnyPath, *, inline: bool = False, rod: str = "blade") -> list[Path]:
    """Writes the deck, and beside it a CSV file with the sections; returns the paths.

    inline: sections in the deck itself, a [section.NAME] for each station. rod: the name of the rod.

    Raises FileError if they cannot be written.
    """
    deck = Path(path)
    csv = deck.with_suffix(".csv")
    if inline:
        texts = {deck: deck_text(blade, rod, inline_sections(blade), inline_keys(blade))}
    else:
        texts = {csv: csv_text(blade), deck: deck_text(blade, rod, [], [f'sections = {{ file = "{csv.name}"{", " if damping_table(blade) else ""}{damping_table(blade)} }}'], csv.name)}
    for file, text in texts.items():
        try:
            file.write_text(text, encoding="utf-8")
        except OSError as error:
            raise FileError(f"{file}: cannot be written: {error.strerror or error}") from error
    return list(texts)


def deck_text(blade: Blade, rod: str, sections: list[str], section_keys: list[str], csv: str = "") -> str:
    curve = Curve(blade.points)
    rod_keys = [f"[rod.{rod}]", *section_keys, *curve_keys(curve), "elements = 50", "order    = 2"]
    parts = [header(blade, curve, csv), *sections, "\n".join(rod_keys), SUPPORT, *(MASSIVE if blade.has_mass else MASSLESS), *HISTORIES]
    return "\n\n".join(parts).replace("ROD", rod) + "\n"


SUPPORT = '[[support]]\nat  = "ROD.start"\nfix = "all"'
MASSIVE = ('# Frequencies at rest, without weight; then the weight grows, flapwise, as of a blade that lies.\n'
           '[[stage]]\nname  = "tones"\nkind  = "modes"\ncount = 6',
           '[[stage]]\nname  = "weight"\nkind  = "static"\nsteps = 4')
MASSLESS = ('# The file has no mass: a load in place of weight.\n[[load]]\nat    = "ROD.end"\nforce = [1, 0, 0]',
            '[analysis]\nkind  = "static"\nsteps = 4')
HISTORIES = ('[[history]]\nname = "tip"\nat   = "ROD.end"\nquantities = ["displacement", "rotation_vector"]',
             '[[history]]\nname = "root"\nat   = "ROD.start"\nquantities = ["force_spatial", "moment_spatial"]')


def header(blade: Blade, curve: Curve, csv: str) -> str:
    title = blade.title or "A blade"
    lines = [f"{title}; imported by gxrod-import from {blade.source}.",
             f"{len(blade.fractions)} stations, {curve.length:.6g} m along the reference curve, {blade.total_mass:.6g} kg.",
             "Global axes, those of the root: x downwind (flapwise), y to the trailing edge (edgewise), z to the tip.",
             "Section axes: x along the curve, y flapwise, z edgewise, turned by the twist, which is right-handed about x. SI units, angles in rad."]
    if csv:
        lines.append(f"{csv}: fraction of the length, twist, the upper triangles of stiffness (K11 … K66) and mass (M11 … M66), x y z rx ry rz.")
    lines += [*blade.notes, *(f"warning: {each}" for each in blade.warnings)]
    comment = "\n".join(textwrap.fill(line, 150, initial_indent="# ", subsequent_indent="#   ") for line in lines)
    gravity = "\ngravity = [9.81, 0, 0]" if blade.has_mass else ""
    return f'{comment}\n\ntitle = {quoted(title)}\nunits = "m kg s"{gravity}'


def quoted(text: str) -> str:
    """As a basic string of TOML."""
    kept = "".join(each for each in text if each.isprintable())
    return '"' + kept.replace("\\", "\\\\").replace('"', '\\"') + '"'


def curve_keys(curve: Curve) -> list[str]:
    """The curve, and the axis from which the twist turns."""
    line = ([f"line     = {{ from = {row(curve.points[0])}, to = {row(curve.points[-1])} }}"] if curve.is_straight
            else ["spline   = [", *wrapped(map(row, curve.points)), "]"])
    return [*line, f"y_axis   = {row(flapwise(curve.tangents(np.zeros(1))[0]))}"]


def inline_keys(blade: Blade) -> list[str]:
    sections = [f'[{number(fraction)}, "s{i:02}"]' for i, fraction in enumerate(blade.fractions)]
    twist = [row(pair) for pair in zip(snap_ends(blade.twist_fractions), blade.rod_twist())]
    return ["sections = [", *wrapped(sections), "]", "twist    = [", *wrapped(twist), "]"]


def inline_sections(blade: Blade) -> list[str]:
    return [f"[section.s{i:02}]\nstiffness_matrix = {matrix_text(stiffness)}" + (f"\nmass_matrix = {matrix_text(mass)}" if blade.has_mass else "") +
            (f"\n{damping}" if (damping := damping_table(blade)) else "")
            for i, (stiffness, mass) in enumerate(zip(blade.stiffness, blade.mass))]


def matrix_text(matrix: Array) -> str:
    return "[\n" + ",\n".join(f"  {row(each, 17)}" for each in matrix) + "]"


def csv_text(blade: Blade) -> str:
    """A row for each station, and for each fraction where the twist is given between them: both are linear between rows."""
    fractions, stiffness, mass = at_all_fractions(blade)
    twist = np.interp(fractions, blade.twist_fractions, blade.rod_twist())
    count = len(COLUMNS) if blade.has_mass else 2 + 21
    rows = [",".join(number(each, 15) for each in (f, t, *k[UPPER], *m[UPPER])[:count]) for f, t, k, m in zip(fractions, twist, stiffness, mass)]
    return "\n".join([",".join(COLUMNS[:count]), *rows]) + "\n"


def at_all_fractions(blade: Blade) -> tuple[Array, Array, Array]:
    """Fractions, stiffness and mass at all stations and between them where the twist is given."""
    between = [f for f in blade.twist_fractions if np.min(np.abs(blade.fractions - f)) > SAME]
    together = np.concatenate((blade.fractions, between))
    order = np.argsort(together, kind="stable")
    flat = np.concatenate((blade.stiffness, blade.mass), axis=1).reshape(len(blade.fractions), 72)
    made = np.stack([np.interp(between, blade.fractions, entry) for entry in flat.T], axis=1).reshape(-1, 12, 6)
    return together[order], np.concatenate((blade.stiffness, made[:, :6]))[order], np.concatenate((blade.mass, made[:, 6:]))[order]


def snap_ends(fractions: Array) -> Array:
    """With exact ends."""
    return np.where(fractions < SAME, 0.0, np.where(fractions > 1.0 - SAME, 1.0, fractions))


def damping_table(blade: Blade) -> str:
    """Kelvin-Voigt damping, a time for all strains or one for each, "" without damping."""
    if blade.damping is None or not np.any(blade.damping):
        return ""
    times = blade.damping
    return f"damping = {{ kelvin_voigt = {number(times[0]) if len(set(times)) == 1 else row(times)} }}"


def wrapped(items: Iterable[str], width: int = 150) -> list[str]:
    """Items with commas, in lines."""
    lines = [""]
    for item in items:
        if len(lines[-1]) + len(item) > width:
            lines.append("")
        lines[-1] += f"{' ' if lines[-1] else '  '}{item},"
    return lines


def row(values: Iterable[float], digits: int = 12) -> str:
    return "[" + ", ".join(number(each, digits) for each in values) + "]"


def number(value: float, digits: int = 12) -> str:
    """As short as the digits allow; a number of TOML."""
    text = f"{value:.{digits}g}"
    return "0" if text == "-0" else text
