"""HAWC2: an htc file with the curve of a body (c2_def) and the st file that it names, or an st file alone.

Its axes: x to the leading edge, y flapwise (downwind), z along; the twist is about z. An st file has isotropic sections (19 columns) or
full matrices (30, "FPM"). Centres are in the section's axes, from the c2_def curve; stiffness is about the elastic centre, and
inertia about the centre of mass, in axes turned by the pitch about z.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ..typed import AnyPath, Array
from .axes import FROM_HAWC2, ROOT_FROM_HAWC2, from_upper, move, rotation_about_z, slice_mass, turn
from .blade import Blade, check_blade
from .curve import Curve
from .hawc2_htc import Body, is_htc, read_body
from .text import Lines, find_beside
from .windio import interpolate

ISOTROPIC = ("r", "m", "x_cg", "y_cg", "ri_x", "ri_y", "x_sh", "y_sh", "E", "G", "I_x", "I_y", "I_p", "k_x", "k_y", "A", "pitch", "x_e", "y_e")
FULL = ("r", "m", "x_cg", "y_cg", "ri_x", "ri_y", "pitch", "x_e", "y_e", *(f"K{i}{j}" for i in range(1, 7) for j in range(i, 7)))


def is_hawc2(text: str) -> bool:
    """Whether it is an htc or an st file."""
    return is_htc(text) or any(line.startswith("#") for line in text.splitlines()) and any(line.startswith("$") for line in text.splitlines())


def read_hawc2(path: AnyPath, st_file: AnyPath | None = None, body: str | None = None, chosen: tuple[int, int] | None = None) -> Blade:
    """From an htc or an st file. `st_file` in place of the one that the htc names; `body` of the htc; `chosen` set and subset."""
    lines = Lines(path)
    if not is_htc("\n".join(lines.lines)):
        return blade_of(lines, None, chosen or (1, 1))
    found = read_body(lines, body)
    st = Lines(st_file or find_st(found))
    return blade_of(st, found, chosen or found.chosen)


def find_st(body: Body) -> Path:
    """Of the htc, whose paths count from the folder that HAWC2 runs in, often the one above."""
    folder = body.lines.path.resolve().parent
    found, tried = find_beside(body.st_name, [folder, folder.parent])
    if found is None:
        raise body.lines.fault(f"the st file {body.st_name} is not there (tried {', '.join(map(str, tried))})", "put it there, or name it with --st", body.st_line)
    return found


def blade_of(st: Lines, body: Body | None, chosen: tuple[int, int]) -> Blade:
    columns, lines = read_set(st, *chosen)
    r = columns["r"]
    points = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, r[-1] - r[0]]]) if body is None else body.points @ ROOT_FROM_HAWC2.T
    twist = np.zeros(2) if body is None else body.twist
    notes = [] if body else ["an st file has no curve and no twist: a straight, untwisted axis; import the htc file to have them"]
    curve = Curve(points)
    fractions, stiffness, mass = fit((r - r[0]) / curve.length, stiffness_of(columns), mass_of(columns), notes)
    found = Blade(title=body.name if body else st.path.stem, source=f"HAWC2: {f'{body.lines.path.name}, ' if body else ''}{st.path.name}, set {chosen[0]} {chosen[1]}",
                  fractions=fractions, stiffness=stiffness, mass=mass, points=points, twist_fractions=curve.fractions, twist=twist, notes=notes)
    if body and body.damping:
        found.warnings.append(f"HAWC2's damping by mass and stiffness was left out ({body.damping})")
    if body:
        found.warnings += [f"the concentrated mass {each} was left out; add a [body.NAME] there" for each in body.masses]
        notes += body.unused.notes("HAWC2's mesh and output")
        found.warnings += body.unused.warnings()
        notes.append(f"of the htc file the body {body.name} alone was read")
    return check_blade(found, lambda i, what, todo: st.fault(what, todo, lines[min(i, len(lines) - 1)]))


def fit(fractions: Array, stiffness: Array, mass: Array, notes: list[str]) -> tuple[Array, Array, Array]:
    """Stations from 0 to 1: lengths that differ by less than 1 % are made to agree; else the table is cut, or held at its end."""
    end = fractions[-1]
    if abs(end - 1.0) < 0.01:
        return fractions / end, stiffness, mass
    notes.append(f"the st file ends at {end:.3f} of the length of the curve: " + ("cut there" if end > 1.0 else "its last section goes on to the tip"))
    kept = np.append(fractions[fractions < 1.0], 1.0)
    return kept, interpolate(kept, fractions, stiffness), interpolate(kept, fractions, mass)


def read_set(st: Lines, number: int, subset: int) -> tuple[dict[str, Array], list[int]]:
    """Columns by name of a subset of a set, and the line of each row."""
    start = st.find(lambda line: line.split(";")[0].strip().startswith(f"#{number}") and line.strip()[1:].split()[0].rstrip(";") == str(number))
    if not start:
        raise st.fault(f"there is no set #{number}", "name another with --set NUMBER SUBSET", 0)
    st.at = start + 1
    while not (words := st.next(f"the subset ${subset} of set #{number}").split(";")[0].split()) or words[0] != f"${subset}":
        if words and words[0].startswith("#"):
            raise st.fault(f"set #{number} has no subset ${subset}", "name another with --set NUMBER SUBSET", start)
    count = int(st.number(words[1] if len(words) > 1 else "", "expected the number of rows after $"))
    width = len(st.lines[min(st.at, len(st.lines)) - 1].split(";")[0].split())
    names = {len(ISOTROPIC): ISOTROPIC, len(FULL): FULL}.get(width)
    if names is None:
        raise st.fault(f"expected {len(ISOTROPIC)} columns (isotropic sections) or {len(FULL)} (full matrices, FPM), found {width}", "correct the table", st.at)
    rows, lines = [], []
    for i in range(count):
        rows.append(st.numbers(width, f"row {i + 1} of {count} of subset ${subset}"))
        lines.append(st.at - 1)
    return dict(zip(names, np.array(rows).T)), lines


def stiffness_of(columns: dict[str, Array]) -> Array:
    """[n,6,6] in gxrod's axes, about the c2_def curve."""
    make = full_stiffness if "K11" in columns else isotropic_stiffness
    return np.array([turn(make(row), FROM_HAWC2) for row in rows_of(columns)])


def rows_of(columns: dict[str, Array]) -> list[dict[str, float]]:
    return [dict(zip(columns, map(float, row))) for row in zip(*columns.values())]


def full_stiffness(row: dict[str, float]) -> Array:
    """Moved from the elastic centre and turned from the principal axes there."""
    matrix = from_upper(np.array([row[name] for name in FULL[9:]]))
    return move(turn(matrix, pitch(row)), np.array([row["x_e"], row["y_e"], 0.0]))


def isotropic_stiffness(row: dict[str, float]) -> Array:
    """Extension and bending about the elastic centre, shear and torsion about the shear centre."""
    bending = np.diag([0.0, 0.0, row["E"] * row["A"], row["E"] * row["I_x"], row["E"] * row["I_y"], 0.0])
    shear = np.diag([row["k_x"] * row["G"] * row["A"], row["k_y"] * row["G"] * row["A"], 0.0, 0.0, 0.0, row["G"] * row["I_p"]])
    return (move(turn(bending, pitch(row)), np.array([row["x_e"], row["y_e"], 0.0])) +
            move(turn(shear, pitch(row)), np.array([row["x_sh"], row["y_sh"], 0.0])))


def pitch(row: dict[str, float]) -> Array:
    return rotation_about_z(np.radians(row["pitch"]))


def mass_of(columns: dict[str, Array]) -> Array:
    """[n,6,6] in gxrod's axes, about the c2_def curve."""
    return np.array([turn(mass_of_row(row), FROM_HAWC2) for row in rows_of(columns)])


def mass_of_row(row: dict[str, float]) -> Array:
    x, y = row["m"] * row["ri_x"] ** 2, row["m"] * row["ri_y"] ** 2
    turned = pitch(row) @ np.diag([x, y, x + y]) @ pitch(row).T
    return slice_mass(row["m"], np.array([row["x_cg"], row["y_cg"], 0.0]), turned)


