"""Mooring lines as a deck: they hang, then they move."""

from __future__ import annotations

import re
import textwrap
from dataclasses import dataclass, replace
from math import dist, hypot, pi, sqrt
from pathlib import Path
from typing import TypeAlias

import numpy as np

from ..errors import FileError
from ..typed import AnyPath, Array
from .mooring import Body, Line, LineType, Mooring, Place, Vector
from .mooring_rest import find_rest
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
    """Writes the deck and returns its path: static stages in which the lines hang, and a dynamic one; and the path of a CSV file of the ground, if that is a grid.

    Raises FileError if it cannot be written, or if lines between free points cannot but be taut.
    """
    deck = Path(path)
    mooring = slacken(mooring)
    refuse_shapeless(mooring)
    texts = {deck: mooring_text(mooring, f"{deck.stem}_seabed.csv")}
    if mooring.has_ground and mooring.ground is not None:
        texts[deck.with_name(f"{deck.stem}_seabed.csv")] = ground_text(mooring)
    for file, text in texts.items():
        try:
            file.write_text(text, encoding="utf-8")
        except OSError as error:
            raise FileError(f"{file}: cannot be written: {error.strerror or error}") from error
    return list(texts)


def mooring_text(mooring: Mooring, ground_file: str) -> str:
    junctions = join(mooring)
    names = section_names(mooring)
    is_wet = mooring.has_water or mooring.has_ground
    parts = [header(mooring, junctions), *fluid(mooring), *ground(mooring, ground_file), *(section(kind, names[kind.name], bending(mooring, kind), is_wet) for kind in mooring.types),
             *(rod(line, ends_at(mooring), names[line.type.name], can_lie(line, mooring)) for line in mooring.lines), *joins(mooring, junctions), *supports(mooring, junctions), *holds(mooring), *stages(mooring),
             *histories(mooring)]
    return "\n\n".join(parts) + "\n"


def stages(mooring: Mooring) -> list[str]:
    """From hanging lines one step leads to equilibrium, from straight ones several, and so from where free places are held at first."""
    steps = 10 if any(is_taut(line) or mooring.has_ground and not can_lie(line, mooring) for line in mooring.lines) else 1
    free = [f'[[stage]]\nname  = "free"\nkind  = "static"\nsteps = 1'] if is_held_first(mooring) else []
    return [f'[[stage]]\nname  = "hang"\nkind  = "static"\nsteps = {steps}', *free,
            f'[[stage]]\nname       = "move"\nkind       = "dynamic"\nintegrator = "generalized-alpha"\ntime_step  = {TIME_STEP:g}\nend_time   = {END_TIME:g}']


def header(mooring: Mooring, junctions: Junctions) -> str:
    lines = [f"{mooring.title}; imported by gxrod-import from {mooring.source}.",
             f"{len(mooring.lines)} line{'s' * (len(mooring.lines) > 1)}, {sum(line.length for line in mooring.lines):.6g} m, {sum(line.length * line.type.mass for line in mooring.lines):.6g} kg. SI units, z up, still water at z = 0."]
    if any(end.kind == "coupled" for line in mooring.lines for end in line.ends):
        lines.append("Points on the vessel stand still; give their [[support]] a `move`.")
    if any(first.ends[i].kind == "free" for (first, i), _ in junctions.corners):
        lines.append("Lines under [[connect]] are rigid corners, so that they do not spin about themselves, where MoorDyn has hinges: of lines that bend easily the same.")
    comment = "\n".join(textwrap.fill(line, 150, initial_indent="# ", subsequent_indent="#   ") for line in [*lines, *mooring.notes, *(f"warning: {each}" for each in mooring.warnings)])
    return f'{comment}\n\ntitle = {quoted(mooring.title)}\nunits = "m kg s"\ngravity = [0, 0, {number(-mooring.gravity)}]'


def fluid(mooring: Mooring) -> list[str]:
    """Nothing where the file has no water."""
    surface = "\nsurface = 0" if mooring.gravity > 0.0 else ""  # up is where gravity comes from
    return [f"[fluid]\ndensity = {number(mooring.density)}{surface}"] if mooring.has_water else []


def half_a_diameter(mooring: Mooring) -> float:
    """Half a diameter of the thickest line."""
    return max(kind.diameter for kind in mooring.types) / 2


def can_lie(line: Line, mooring: Mooring) -> bool:
    """Whether a line can start as a catenary that lies on the ground in part: on one that is level, not below its ends, and not so long that it would lie there loosely."""
    if not mooring.has_ground or mooring.ground is not None:
        return False
    kind = line.type
    sinks = max(kind.submerged_weight(mooring.density, mooring.gravity), 0.0) / (mooring.ground_stiffness * kind.diameter)
    bed = -mooring.depth - half_a_diameter(mooring) + kind.diameter / 2 - sinks
    (x1, y1, z1), (x2, y2, z2) = (place.at for place in line.ends)
    lowest = min(z1, z2)
    if bed - 2.0 * kind.diameter < lowest < bed:
        bed = lowest
    return lowest >= bed and line.length - hypot(x2 - x1, y2 - y1) < (z1 - bed + z2 - bed) * (1.0 - 1e-9)


def ground(mooring: Mooring, file: str) -> list[str]:
    """The ground, so low that the thickest line has its axis where MoorDyn's ground is."""
    if not mooring.has_ground:
        return []
    friction = [f"friction  = {friction_of(mooring)}"] if mooring.friction > 0.0 else []
    place = f"z         = {number(-mooring.depth - half_a_diameter(mooring))}" if mooring.ground is None else f'grid      = {{ file = "{file}" }}'
    depth = f"{number(mooring.depth)} m deep, and half a diameter" if mooring.ground is None else f"{file}: half a diameter below the ground of the file"
    return ["\n".join([f"# {depth}: lines lie on it with their surface, where the file means their axis.", "[seabed]",
                       place, f"stiffness = {number(mooring.ground_stiffness)}", f"damping   = {number(mooring.ground_damping)}", *friction])]


def friction_of(mooring: Mooring) -> str:
    """A number, which acts in stages after the first one; or a table if several stages find where lines rest."""
    coefficient = number(mooring.friction)
    return f'{{ axial = {coefficient}, lateral = {coefficient}, stages = "move" }}' if is_held_first(mooring) else coefficient


def ground_text(mooring: Mooring) -> str:
    """The CSV file of a grid."""
    assert mooring.ground is not None
    lower = np.array([0.0, 0.0, half_a_diameter(mooring)])
    return "".join(",".join(number(each) for each in point - lower) + "\n" for point in mooring.ground)


def section_names(mooring: Mooring) -> dict[str, str]:
    """Names that decks can have, one for each type."""
    names: dict[str, str] = {}
    for kind in mooring.types:
        name = re.sub(r"[^A-Za-z0-9_-]", "_", kind.name)
        while name in names.values():
            name += "_"
        names[kind.name] = name
    return names


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


def section(kind: LineType, name: str, bends: tuple[float, str], is_wet: bool = True) -> str:
    """A [section.NAME]; with `fluid` if water or ground is around."""
    EI, comment = bends
    across, rotary = kind.EA / (2.0 * (1.0 + POISSON)), kind.mass * kind.diameter**2 / 16
    lines = [f"# GA and GJ are those of a solid rod of nu = {POISSON:g} with this EA and EI; rotary inertia is that of a cylinder.", *([comment] if comment else []), f"[section.{name}]",
             f"stiffness = {{ EA = {short(kind.EA)}, GAy = {short(across)}, GAz = {short(across)}, GJ = {short(EI / (1.0 + POISSON))}, EIy = {short(EI)}, EIz = {short(EI)} }}",
             f"inertia   = {{ rhoA = {number(kind.mass)}, rhoIy = {short(rotary)}, rhoIz = {short(rotary)} }}"]
    if kind.stretch:
        rows = ", ".join(f"[{number(strain)}, {number(tension)}]" for strain, tension in kind.stretch)
        lines.append(f"law       = {{ tension_strain = {{ table = [{rows}] }} }}")
    if kind.damping > 0.0:
        lines.append(f"damping   = {{ kelvin_voigt = [{short(kind.damping / kind.EA)}, 0, 0, 0, 0, 0] }}")
    if not is_wet:
        return "\n".join(lines)
    drag, mass = ("{ normal = %s, tangential = %s }" % tuple(map(number, pair)) for pair in (kind.drag, kind.added_mass))
    return "\n".join([*lines, f"fluid     = {{ outer_diameter = {number(kind.diameter)}, drag = {drag}, added_mass = {mass} }}"])


def short(value: float) -> str:
    return number(value, 6)


# Lines


def refuse_shapeless(mooring: Mooring) -> None:
    """Lines with slack whose ends are above each other hang double, a shape that no catenary has."""
    for line in mooring.lines:
        (x1, y1, _), (x2, y2, _) = (place.at for place in line.ends)
        if x1 == x2 and y1 == y2 and not is_taut(line) and not is_straight(line) and line.length > dist(*(place.at for place in line.ends)) * (1.0 + 4e-15):
            raise ImportFault(f"{mooring.source}:{line.line}: the ends of {line.name} are above each other, and its length, {line.length:g}, is more than their distance, "
                              f"{dist(*(place.at for place in line.ends)):g}: it would hang double, from which no deck starts; move one of the ends aside")


def is_free(place: Place) -> bool:
    return place.kind in ("free", "corner")


def is_taut(line: Line) -> bool:
    return line.length <= dist(line.ends[0].at, line.ends[1].at) and not is_straight(line)


def is_straight(line: Line) -> bool:
    """As slacken() leaves floating lines and upright ones."""
    return abs(dist(line.ends[0].at, line.ends[1].at) - line.length) < 1e-6 * line.length and any(is_free(place) for place in line.ends)


def floats(line: Line, mooring: Mooring) -> bool:
    return line.type.submerged_weight(mooring.density, mooring.gravity) < 0.0


def is_held_first(mooring: Mooring) -> bool:
    """Whether free places are far from equilibrium at first: with bodies, and at lines that float."""
    return bool(mooring.bodies) or any(floats(line, mooring) and any(map(is_free, line.ends)) for line in mooring.lines)


def rod(line: Line, ends: Ends, section_name: str, lies: bool) -> str:
    start, end = (np.array(place.at) for place in line.ends)
    if is_straight(line):
        shape = f"line     = {{ from = {row(start)}, to = {row(end)} }}"
    elif is_taut(line):
        at_end = pulled_end(line, ends) == 1
        along = (end - start) * line.length / dist(start, end)
        start, end = (start, start + along) if at_end else (end - along, end)
        shape = f"line     = {{ from = {row(start)}, to = {row(end)} }}"
    else:
        shape = f"catenary = {{ from = {row(start)}, to = {row(end)}, length = {number(line.length)}{', bed = true' * lies} }}"
    comment = ["# Not longer than the distance of its ends: straight and without tension at first."] if is_taut(line) else []
    # One element would be a bar that turns about the end that is held.
    segments = max(line.segments, 2) if any(map(is_free, line.ends)) else line.segments
    return "\n".join([*comment, f"[rod.{line.name}]", f'section  = "{section_name}"', shape, f"elements = {segments}"])


def pulled_end(line: Line, ends: Ends) -> int:
    """Of a taut line, the end that is not at its place at first: its support pulls it there, or it is free."""
    free = [i for i in (1, 0) if is_free(line.ends[i]) and len(ends[line.ends[i].name]) == 1]
    return next(iter(free + [i for i in (1, 0) if line.ends[i].kind in ("fixed", "coupled")]), 1)


def carrier(place: Place) -> str:
    """What moves with a place: its body, or itself alone."""
    return place.body or place.name


def slacken(mooring: Mooring) -> Mooring:
    """With free places moved, to where they about come to rest or by no more than need be, so that none of their lines is taut. Straight are those that float between two of them, and upright ones: catenaries hang down."""
    ends = ends_at(mooring)
    at = {carrier(place): np.array(place.at) for line in mooring.lines for place in line.ends} | {body.name: np.array(body.at) for body in mooring.bodies}
    arms = {place.name: np.array(place.at) - at[carrier(place)] for line in mooring.lines for place in line.ends}
    places = {place.name: place for line in mooring.lines for place in line.ends}
    loose = {name for name, meeting in ends.items() if len(meeting) > 1 and is_free(places[name]) and not places[name].body} | {body.name for body in mooring.bodies}
    at |= find_rest(mooring, loose) if is_held_first(mooring) else {}
    lines = [(line, *line.ends, floats(line, mooring)) for line in mooring.lines if {carrier(place) for place in line.ends} & loose]
    for _ in range(SWEEPS):
        moved = False
        for line, first, second, buoyant in lines:
            apart = at[carrier(second)] + arms[second.name] - at[carrier(first)] - arms[first.name]
            free = [name for name in {carrier(first), carrier(second)} if name in loose]
            straight = buoyant and len(free) == 2
            is_upright = hypot(apart[0], apart[1]) < 1e-6 * line.length
            excess = float(np.linalg.norm(apart)) - (1.0 if straight or is_upright else SLACK) * line.length
            if excess > 1e-9 * line.length or straight and excess < -1e-9 * line.length:
                moved = True
                step = apart * excess / (float(np.linalg.norm(apart)) * len(free))
                for name in free:
                    at[name] = at[name] + (step if name == carrier(first) else -step)
        if not moved:
            break
    else:
        raise ImportFault(f"{mooring.source}: the lines that meet in free points are too short to reach all of their other ends without tension; give these points other places, or longer lines")
    return moved_to(mooring, {name: at[name] for name in loose}, arms)


def moved_to(mooring: Mooring, places: dict[str, Array], arms: dict[str, Array]) -> Mooring:
    changed = []
    away = []

    def moved(name: str, at: Vector, new: Array) -> Vector:
        if dist(at, new) == 0.0:
            return at
        away.append(name)
        x, y, z = new.tolist()
        return x, y, z

    def move(place: Place) -> Place:
        name = carrier(place)
        return replace(place, at=moved(name, place.at, places[name] + arms[place.name])) if name in places else place

    for line in mooring.lines:
        changed.append(replace(line, ends=(move(line.ends[0]), move(line.ends[1]))))
    bodies = [replace(body, at=moved(body.name, body.at, places[body.name])) for body in mooring.bodies]
    notes = [f"free points and bodies start where no line is taut before it hangs: {', '.join(dict.fromkeys(away))}"] if away else []
    return replace(mooring, lines=changed, bodies=bodies, notes=[*mooring.notes, *notes])


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
    """How lines are joined in free places: pairs of ends that are rigid corners or hinges, ends that are fixed to bodies or turn on them, and an end of each set of lines in corners that would spin
    about itself."""

    corners: list[tuple[End, End]]
    hinges: list[tuple[End, End]]
    welds: list[End]
    balls: list[End]
    spinning: list[tuple[str, int]]


def join(mooring: Mooring) -> Junctions:
    """Hinges between lines that are held elsewhere, as in MoorDyn; corners where a line could spin about itself otherwise, and where the file has them."""
    sets = {line.name: {line.name} for line in mooring.lines} | {f"body {body.name}": {f"body {body.name}"} for body in mooring.bodies}
    held = {line.name for line in mooring.lines if any(not is_free(place) for place in line.ends)}
    found = Junctions([], [], [], [], [])

    def unite(first: str, second: str) -> None:
        together = sets[first] | sets[second]
        sets.update(dict.fromkeys(together, together))

    at_bodies = [(line, i) for line in mooring.lines for i in (0, 1) if line.ends[i].body]
    for line, i in at_bodies:
        if line.ends[i].kind == "corner":
            found.welds.append((line, i))
            unite(line.name, f"body {line.ends[i].body}")
    for ends in ends_at(mooring).values():
        (first, i), *others = ends
        for line, j in others if is_free(first.ends[i]) and not first.ends[i].body else []:
            apart = sets[line.name] is not sets[first.name] and sets[line.name] & held and sets[first.name] & held
            if apart and first.ends[i].kind != "corner":
                found.hinges.append(((first, i), (line, j)))
                continue
            found.corners.append(((first, i), (line, j)))
            unite(first.name, line.name)
    for line, i in at_bodies:
        if line.ends[i].kind == "corner":
            continue
        if sets[line.name] & held:
            found.balls.append((line, i))
        else:
            found.welds.append((line, i))
            unite(line.name, f"body {line.ends[i].body}")
    for names in {min(names): names for names in sets.values()}.values():
        ends = [(line, i) for line in mooring.lines if line.name in names for i in (0, 1) if not is_free(line.ends[i])]
        if ends and all(line.ends[i].kind != "clamped" for line, i in ends):
            found.spinning.append((ends[0][0].name, ends[0][1]))
    return found


def joins(mooring: Mooring, junctions: Junctions) -> list[str]:
    """[[connect]] and [joint.NAME] in free places, and the bodies there."""
    connects = [f"[[connect]]\npoints = [{point(*first)}, {point(*second)}]" for first, second in junctions.corners]
    joints = [f'[joint.{line.name}_{"AB"[i]}]\ntype    = "ball"\nbetween = [{point(*first)}, {point(line, i)}]' for first, (line, i) in junctions.hinges]
    joints += [on_body(line, i, kind) for kind, ends in (("weld", junctions.welds), ("ball", junctions.balls)) for line, i in ends]
    bodies = [free_body(each, mooring) for each in mooring.bodies]
    for ends in ends_at(mooring).values():
        line, i = ends[0]
        place = line.ends[i]
        if is_free(place) and not place.body and (place.mass or place.volume or place.drag_area):
            bodies.append(body(place, point(line, i), mooring))
    return [*connects, *joints, *bodies]


def wet_body(mooring: Mooring, volume: str, drag_area: Vector, added_mass: Vector) -> list[str]:
    """The line `fluid`; none where water does nothing. What displaces nothing sinks in over the diameter of a disc of its largest drag area."""
    def vector(values: Vector) -> str:
        return "[" + ", ".join(map(short, values)) + "]"

    floats = float(volume) > 0.0
    if not mooring.has_water or not floats and not any((*drag_area, *added_mass)):
        return []
    height = "" if floats else f", height = {short(2.0 * sqrt(max(*drag_area, 1e-4) / pi))}"
    return [f"fluid   = {{ volume = {volume}{height}, drag_area = {vector(drag_area)}, added_mass = {vector(added_mass)} }}"]


def body(place: Place, at: str, mooring: Mooring) -> str:
    displaced = mooring.density * place.volume
    mass = place.mass if place.mass > 0.0 else max(1e-3 * displaced, 1e-3)
    wet = wet_body(mooring, number(place.volume), (place.drag_area,) * 3, (displaced * place.added_mass,) * 3)
    return "\n".join([*(["# Without mass in the file: a thousandth of the water that it displaces."] if place.mass <= 0.0 else []), f"[body.{place.name}]", f"at      = {at}", f"mass    = {number(mass)}", *wet])


def on_body(line: Line, i: int, kind: str) -> str:
    place = line.ends[i]
    return f'[joint.{line.name}_{"AB"[i]}]\ntype    = "{kind}"\nbetween = [{quoted(place.body)}, {point(line, i)}]\nat      = {row(place.at)}'


def free_body(each: Body, mooring: Mooring) -> str:
    def vector(values: Vector) -> str:
        return "[" + ", ".join(map(short, values)) + "]"

    lines = [f"[body.{each.name}]", f"at      = {row(each.at)}", f"mass    = {short(each.mass)}", f"inertia = {vector(each.inertia)}"]
    lines += [f"centre_of_mass = {vector(each.centre_of_mass)}"] if any(each.centre_of_mass) else []
    lines += [f"rotation_vector = {row(each.rotation_vector)}"] if any(each.rotation_vector) else []
    return "\n".join([*lines, *wet_body(mooring, short(each.volume), each.drag_area, each.added_mass)])


# Supports


def holds(mooring: Mooring) -> list[str]:
    """Of free places, while lines take their shapes; and of the turns of bodies that hang on one point, which nothing else resists."""
    if not is_held_first(mooring):
        return []
    junctions = join(mooring)
    turning = [body.name for body in mooring.bodies if not any(line.ends[i].body == body.name for line, i in junctions.welds)
               and len({line.ends[i].name for line, i in junctions.balls if line.ends[i].body == body.name}) < 2]
    first = [point(line, i) for (line, i), *_ in ends_at(mooring).values() if is_free(line.ends[i]) and not line.ends[i].body]
    held = [f'[[support]]\nat     = {at}\nfix    = "position"\nstages = "hang"' for at in [*first, *(quoted(body.name) for body in mooring.bodies)]]
    comment = "# Free places are held while lines take their shapes, and let go in the next stage.\n"
    return [comment + held[0], *held[1:], *(f'# Nothing resists its turns.\n[[support]]\nat  = {quoted(name)}\nfix = ["rx", "ry", "rz"]' for name in turning)]


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
    return [*(f'[[history]]\nname = "{line.name}_{name}"\nat   = {point(line, i)}\nquantities = ["position", "effective_tension"]' for line in mooring.lines for i, name in enumerate("AB")),
            *(f'[[history]]\nname = "{body.name}"\nat   = {quoted(body.name)}\nquantities = ["position", "rotation_vector"]' for body in mooring.bodies)]
