"""Mooring lines as a deck: they hang, then they move."""

from __future__ import annotations

import re
import textwrap
from dataclasses import dataclass, replace
from math import dist, hypot
from pathlib import Path
from typing import TypeAlias

import numpy as np

from ..errors import FileError
from ..typed import AnyPath, Array
from .mooring import Line, LineType, Mooring, Place
from .text import ImportFault
from .writing import number, quoted, row

End: TypeAlias = tuple[Line, int]  # start 0, end 1
Ends: TypeAlias = dict[str, list[End]]  # by the names of places

POISSON = 0.3  # of a solid rod: GA and GJ, which no file has
SHARE = 0.1  # of an element's length, within which a line without EI bends
SLACK = 0.999  # of a line's length: the distance of its ends at most
SWEEPS = 10000
TIME_STEP, END_TIME = 0.05, 60.0


def write_mooring(mooring: Mooring, path: AnyPath) -> list[Path]:
    """Writes the deck and returns its path: a static stage in which the lines hang, and a dynamic one.

    Raises FileError if it cannot be written, or if lines between free points cannot but be taut.
    """
    deck = Path(path)
    mooring = slacken(mooring)
    try:
        deck.write_text(mooring_text(mooring), encoding="utf-8")
    except OSError as error:
        raise FileError(f"{deck}: cannot be written: {error.strerror or error}") from error
    return [deck]


def mooring_text(mooring: Mooring) -> str:
    junctions = join(mooring)
    parts = [header(mooring, junctions), fluid(mooring), *ground(mooring), *(section(kind, name_of(kind), bending(mooring, kind)) for kind in mooring.types),
             *(rod(line, ends_at(mooring)) for line in mooring.lines), *joins(mooring, junctions), *supports(mooring, junctions), *stages(mooring), *histories(mooring)]
    return "\n\n".join(parts) + "\n"


def stages(mooring: Mooring) -> list[str]:
    """From hanging lines one step leads to equilibrium, from straight ones several."""
    steps = 10 if any(map(is_taut, mooring.lines)) else 1
    return [f'[[stage]]\nname  = "hang"\nkind  = "static"\nsteps = {steps}',
            f'[[stage]]\nname       = "move"\nkind       = "dynamic"\nintegrator = "generalized-alpha"\ntime_step  = {TIME_STEP:g}\nend_time   = {END_TIME:g}']


def header(mooring: Mooring, junctions: Junctions) -> str:
    lines = [f"{mooring.title}; imported by gxrod-import from {mooring.source}.",
             f"{len(mooring.lines)} line{'s' * (len(mooring.lines) > 1)}, {sum(line.length for line in mooring.lines):.6g} m, {sum(line.length * line.type.mass for line in mooring.lines):.6g} kg. SI units, z up, still water at z = 0."]
    if any(end.kind == "coupled" for line in mooring.lines for end in line.ends):
        lines.append("Points on the vessel stand still; give their [[support]] a `move`.")
    if any(first.ends[i].kind == "free" for (first, i), _ in junctions.corners):
        lines.append("Lines under [[connect]] are rigid corners, so that they do not spin about themselves, where MoorDyn has hinges: of lines that bend easily the same.")
    comment = "\n".join(textwrap.fill(line, 150, initial_indent="# ", subsequent_indent="#   ") for line in [*lines, *mooring.notes])
    return f'{comment}\n\ntitle = {quoted(mooring.title)}\nunits = "m kg s"\ngravity = [0, 0, {number(-mooring.gravity)}]'


def fluid(mooring: Mooring) -> str:
    return f"[fluid]\ndensity = {number(mooring.density)}\nsurface = 0"


def ground(mooring: Mooring) -> list[str]:
    """Of the height at which the thickest line has its axis where MoorDyn's ground is."""
    if mooring.depth <= 0.0:
        return []
    lower = max(kind.diameter for kind in mooring.types) / 2
    friction = [f"friction  = {number(mooring.friction)}"] if mooring.friction > 0.0 else []
    return ["\n".join([f"# {number(mooring.depth)} m deep, and half a diameter: lines lie on it with their surface, where the file means their axis.", "[seabed]",
                       f"z         = {number(-mooring.depth - lower)}", f"stiffness = {number(mooring.ground_stiffness)}", f"damping   = {number(mooring.ground_damping)}", *friction])]


def name_of(kind: LineType) -> str:
    """A name that decks can have."""
    return re.sub(r"[^A-Za-z0-9_-]", "_", kind.name)


def bending(mooring: Mooring, kind: LineType) -> tuple[float, str]:
    """EI, and a comment where the file has none."""
    if kind.EI > 0.0:
        return kind.EI, ""
    lines = [line for line in mooring.lines if line.type.name == kind.name]
    tension = max(abs(kind.submerged_weight(mooring.density, mooring.gravity)) * max(line.length for line in lines) / 2, 1e-5 * kind.EA)
    size = min(line.length / line.segments for line in lines)
    solid = kind.EA * kind.diameter**2 / 16
    return min(tension * (SHARE * size) ** 2, solid), (
        f"# EI is 0 in the file, which leaves a line without stiffness where it is slack. Taken: as little as bends within {SHARE:g} elements, sqrt(EI/T) = {SHARE:g} x {size:.4g} m at\n"
        f"# half a line's weight in water, T = {tension:.4g} N, and at most that of a solid rod.")


def section(kind: LineType, name: str, bends: tuple[float, str]) -> str:
    """A [section.NAME]."""
    EI, comment = bends
    across, rotary = kind.EA / (2.0 * (1.0 + POISSON)), kind.mass * kind.diameter**2 / 16
    lines = [f"# GA and GJ are those of a solid rod of nu = {POISSON:g} with this EA and EI; rotary inertia is that of a cylinder.", *([comment] if comment else []), f"[section.{name}]",
             f"stiffness = {{ EA = {short(kind.EA)}, GAy = {short(across)}, GAz = {short(across)}, GJ = {short(EI / (1.0 + POISSON))}, EIy = {short(EI)}, EIz = {short(EI)} }}",
             f"inertia   = {{ rhoA = {number(kind.mass)}, rhoIy = {short(rotary)}, rhoIz = {short(rotary)} }}"]
    if kind.damping > 0.0:
        lines.append(f"damping   = {{ kelvin_voigt = [{short(kind.damping / kind.EA)}, 0, 0, 0, 0, 0] }}")
    drag, mass = ("{ normal = %s, tangential = %s }" % tuple(map(number, pair)) for pair in (kind.drag, kind.added_mass))
    return "\n".join([*lines, f"fluid     = {{ outer_diameter = {number(kind.diameter)}, drag = {drag}, added_mass = {mass} }}"])


def short(value: float) -> str:
    return number(value, 6)


# Lines


def is_free(place: Place) -> bool:
    return place.kind in ("free", "corner")


def is_taut(line: Line) -> bool:
    return line.length <= dist(line.ends[0].at, line.ends[1].at)


def rod(line: Line, ends: Ends) -> str:
    start, end = (np.array(place.at) for place in line.ends)
    if is_taut(line):
        at_end = pulled_end(line, ends) == 1
        along = (end - start) * line.length / dist(start, end)
        start, end = (start, start + along) if at_end else (end - along, end)
        shape = f"line     = {{ from = {row(start)}, to = {row(end)} }}"
    else:
        shape = f"catenary = {{ from = {row(start)}, to = {row(end)}, length = {number(line.length)}, bed = true }}"
    comment = ["# Not longer than the distance of its ends: straight and without tension at first."] if is_taut(line) else []
    return "\n".join([*comment, f"[rod.{line.name}]", f'section  = "{name_of(line.type)}"', shape, f"elements = {line.segments}"])


def pulled_end(line: Line, ends: Ends) -> int:
    """Of a taut line, the end that is not at its place at first: its support pulls it there, or it is free."""
    free = [i for i in (1, 0) if is_free(line.ends[i]) and len(ends[line.ends[i].name]) == 1]
    return next(iter(free + [i for i in (1, 0) if line.ends[i].kind in ("fixed", "coupled")]), 1)


def slacken(mooring: Mooring) -> Mooring:
    """With free points at which several lines meet moved, by no more than need be, so that none of their lines is taut."""
    ends = ends_at(mooring)
    places = {place.name: np.array(place.at) for line in mooring.lines for place in line.ends}
    loose = {name for name, meeting in ends.items() if len(meeting) > 1 and is_free(meeting[0][0].ends[meeting[0][1]])}
    lines = [(line, first.name, second.name) for line in mooring.lines for first, second in [line.ends] if {first.name, second.name} & loose]
    for _ in range(SWEEPS):
        moved = False
        for line, first, second in lines:
            apart = places[second] - places[first]
            excess = float(np.linalg.norm(apart)) - SLACK * line.length
            free = [name for name in (first, second) if name in loose]
            if excess > 1e-9 * line.length:
                moved = True
                step = apart * excess / (float(np.linalg.norm(apart)) * len(free))
                for name in free:
                    places[name] = places[name] + (step if name == first else -step)
        if not moved:
            break
    else:
        raise ImportFault(f"{mooring.source}: the lines that meet in free points are too short to reach all of their other ends without tension; give these points other places, or longer lines")
    return moved_to(mooring, {name: places[name] for name in loose})


def moved_to(mooring: Mooring, places: dict[str, Array]) -> Mooring:
    changed = []
    away = []

    def move(place: Place) -> Place:
        if place.name not in places or dist(place.at, places[place.name]) == 0.0:
            return place
        away.append(place.name)
        x, y, z = places[place.name].tolist()
        return replace(place, at=(x, y, z))

    for line in mooring.lines:
        changed.append(replace(line, ends=(move(line.ends[0]), move(line.ends[1]))))
    notes = [f"free points start nearer to their lines' other ends, so that no line is taut before it hangs: {', '.join(dict.fromkeys(away))}"] if away else []
    return replace(mooring, lines=changed, notes=[*mooring.notes, *notes])


def ends_at(mooring: Mooring) -> Ends:
    """The ends of lines, by the names of places."""
    ends: Ends = {}
    for line in mooring.lines:
        for i, place in enumerate(line.ends):
            ends.setdefault(place.name, []).append((line, i))
    return ends


def point(line: Line, i: int) -> str:
    return f'"{line.name}.{("start", "end")[i]}"'


@dataclass
class Junctions:
    """How lines are joined in free places: pairs of ends that are rigid corners or hinges, and an end of each set of lines in corners that would spin about itself."""

    corners: list[tuple[End, End]]
    hinges: list[tuple[End, End]]
    spinning: list[tuple[str, int]]


def join(mooring: Mooring) -> Junctions:
    """Hinges between lines that are held elsewhere, as in MoorDyn; corners where a line could spin about itself otherwise, and where the file has them."""
    sets = {line.name: {line.name} for line in mooring.lines}
    held = {line.name for line in mooring.lines if any(not is_free(place) for place in line.ends)}
    found = Junctions([], [], [])
    for ends in ends_at(mooring).values():
        (first, i), *others = ends
        for line, j in others if is_free(first.ends[i]) else []:
            apart = sets[line.name] is not sets[first.name] and sets[line.name] & held and sets[first.name] & held
            if apart and first.ends[i].kind != "corner":
                found.hinges.append(((first, i), (line, j)))
                continue
            found.corners.append(((first, i), (line, j)))
            together = sets[first.name] | sets[line.name]
            sets.update(dict.fromkeys(together, together))
    for names in {min(names): names for names in sets.values()}.values():
        ends = [(line, i) for line in mooring.lines if line.name in names for i in (0, 1) if not is_free(line.ends[i])]
        if ends and all(line.ends[i].kind != "clamped" for line, i in ends):
            found.spinning.append((ends[0][0].name, ends[0][1]))
    return found


def joins(mooring: Mooring, junctions: Junctions) -> list[str]:
    """[[connect]] and [joint.NAME] in free places, and the bodies there."""
    connects = [f"[[connect]]\npoints = [{point(*first)}, {point(*second)}]" for first, second in junctions.corners]
    joints = [f'[joint.{line.name}_{"AB"[i]}]\ntype    = "ball"\nbetween = [{point(*first)}, {point(line, i)}]' for first, (line, i) in junctions.hinges]
    bodies = []
    for ends in ends_at(mooring).values():
        line, i = ends[0]
        place = line.ends[i]
        if is_free(place) and (place.mass or place.volume or place.drag_area):
            bodies.append(body(place, point(line, i), mooring.density))
    return [*connects, *joints, *bodies]


def body(place: Place, at: str, density: float) -> str:
    displaced = density * place.volume
    mass = place.mass if place.mass > 0.0 else max(1e-3 * displaced, 1e-3)
    added, area = short(displaced * place.added_mass), number(place.drag_area)
    return "\n".join([*(["# Without mass in the file: a thousandth of the water that it displaces."] if place.mass <= 0.0 else []), f"[body.{place.name}]", f"at    = {at}", f"mass  = {number(mass)}",
                      f"fluid = {{ volume = {number(place.volume)}, drag_area = [{area}, {area}, {area}], added_mass = [{added}, {added}, {added}] }}"])


# Supports


def supports(mooring: Mooring, junctions: Junctions) -> list[str]:
    ends = ends_at(mooring)
    return [support(line, i, ends, (line.name, i) in junctions.spinning) for line in mooring.lines for i, place in enumerate(line.ends) if not is_free(place)]


def support(line: Line, i: int, ends: Ends, is_hinge: bool) -> str:
    """Of an end of a line, as a hinge across the line's plane where it would spin about itself otherwise."""
    place = line.ends[i]
    axes = hinge_axes(line) if is_hinge else np.eye(3)
    fix = ["all"] if place.kind == "clamped" else ["position"]
    lines = [f"# {place.name}, {place.kind}{', a hinge so that the line does not spin about itself' if is_hinge else ''}", "[[support]]", f"at   = {point(line, i)}"]
    if is_taut(line) and pulled_end(line, ends) == i:
        start, end = np.array(line.ends[1 - i].at), np.array(place.at)
        move = axes @ (end - start) * (1.0 - line.length / dist(start, end))
        lines.append("move = { " + ", ".join(f"{axis} = {number(value)}" for axis, value in zip("xyz", move)) + " }")
        fix = []
    fix += ["rx", "rz"] if is_hinge else []
    lines += [f"fix  = {quoted(fix[0]) if len(fix) == 1 else '[' + ', '.join(map(quoted, fix)) + ']'}"] if fix else []
    return "\n".join([*lines, *([f"axes = [{', '.join(map(row, axes))}]"] if is_hinge else [])])


def hinge_axes(line: Line) -> Array:
    """Rows x, y, z: along the line in the horizontal, across its plane, up."""
    (x1, y1, _), (x2, y2, _) = (place.at for place in line.ends)
    along = hypot(x2 - x1, y2 - y1)
    c, s = ((x2 - x1) / along, (y2 - y1) / along) if along > 1e-9 * line.length else (1.0, 0.0)
    return np.array([(c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0)])


def histories(mooring: Mooring) -> list[str]:
    return [f'[[history]]\nname = "{line.name}_{name}"\nat   = {point(line, i)}\nquantities = ["position", "effective_tension"]' for line in mooring.lines for i, name in enumerate("AB")]
