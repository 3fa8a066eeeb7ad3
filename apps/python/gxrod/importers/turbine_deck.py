"""A turbine as a deck that runs at once, with the sections of its tower and its blades in CSV files."""

from __future__ import annotations

import textwrap
from pathlib import Path

import numpy as np

from ..errors import FileError
from ..typed import AnyPath, Array
from .blade import Blade, flapwise
from .curve import Curve
from .turbine import Turbine
from .writing import csv_text, damping_table, number, quoted, row, wrapped

TURNS_TO_SPEED = 2  # revolutions in which the rotor reaches its speed, and then makes as many


def write_turbine(turbine: Turbine, path: AnyPath) -> list[Path]:
    """Writes the deck, and next to it the sections of tower and blade, NAME_tower.csv and NAME_blade.csv; returns the paths.

    Raises FileError if they cannot be written.
    """
    deck = Path(path)
    files = {name: deck.with_name(f"{deck.stem}_{name}.csv") for name in ("tower", "blade")}
    texts = {files["tower"]: csv_text(turbine.tower), files["blade"]: csv_text(turbine.blade),
             deck: deck_text(turbine, {name: file.name for name, file in files.items()})}
    for file, text in texts.items():
        try:
            file.write_text(text, encoding="utf-8")
        except OSError as error:
            raise FileError(f"{file}: cannot be written: {error.strerror or error}") from error
    return list(texts)


def deck_text(turbine: Turbine, csv: dict[str, str]) -> str:
    copies = f"copies   = {{ count = {turbine.blades}, about = {row(turbine.shaft)}, through = {row(turbine.apex)} }}"
    base = np.array([0.0, 0.0, turbine.base])
    parts = [header(turbine), rod(turbine.tower, "tower", csv["tower"], base, np.eye(3), 10), '[[support]]\nat  = "tower.start"\nfix = "all"',
             *bodies(turbine), f"# blade_1, blade_2 …, {turbine.blades} in a turn.\n" + rod(turbine.blade, "blade", csv["blade"], turbine.blade_root, turbine.blade_axes, 20) + f"\n{copies}",
             f'[joint.root]\ntype    = "weld"\nbetween = ["hub", "blade.start"]\nat      = {row(turbine.blade_root)}\ncopies  = "blade"',
             *tip_masses(turbine), *shaft(turbine), *stages(turbine), *histories(turbine)]
    return "\n\n".join(parts) + "\n"


def header(turbine: Turbine) -> str:
    title = turbine.title or "A turbine"
    lines = [f"{title}; imported by gxrod-import from {turbine.source}.",
             f"Tower {turbine.tower.total_mass:.6g} kg, nacelle {turbine.nacelle_mass:.6g} kg, rotor {turbine.rotor_mass:.6g} kg ({turbine.blades} blades of {turbine.blade.total_mass:.6g} kg), "
             f"in all {turbine.total_mass:.6g} kg. The rotor's apex is at {row(turbine.apex, 6)}.",
             "Global axes: x downwind, z up. Section axes of the tower: x up, y downwind; of a blade: x along the curve, y flapwise, z edgewise, turned by the twist. SI units, angles in rad.",
             *turbine.notes, *(f"blade: {each}" for each in turbine.blade.notes),
             *(f"warning: {each}" for each in (*turbine.warnings, *(f"tower: {each}" for each in turbine.tower.warnings), *(f"blade: {each}" for each in turbine.blade.warnings)))]
    comment = "\n".join(textwrap.fill(line, 150, initial_indent="# ", subsequent_indent="#   ") for line in lines)
    return f'{comment}\n\ntitle = {quoted(title)}\nunits = "m kg s"\ngravity = [0, 0, -9.80665]'


def rod(kind: Blade, name: str, csv: str, root: Array, axes: Array, elements: int) -> str:
    """A rod's table, its curve placed in global axes: `root` [3], `axes` 3×3 of its root."""
    points = root + kind.points @ axes.T
    damping = damping_table(kind)
    line = [f"line     = {{ from = {row(points[0])}, to = {row(points[-1])} }}"] if Curve(kind.points).is_straight else ["spline   = [", *wrapped(map(row, points)), "]"]
    y_axis = axes @ flapwise(Curve(kind.points).tangents(np.zeros(1))[0])
    return "\n".join([f"[rod.{name}]", f'sections = {{ file = "{csv}"{", " if damping else ""}{damping} }}', *line, f"y_axis   = {row(y_axis)}", f"elements = {elements}", "order    = 2"])


def bodies(turbine: Turbine) -> list[str]:
    """Nacelle and hub as rigid bodies; about axes that the file leaves out they have half the inertia it gives, the least that a body can have."""
    centre = turbine.nacelle_centre
    inertia = turbine.nacelle_inertia - turbine.nacelle_mass * float(centre[0] ** 2 + centre[1] ** 2)
    turned = f"\nrotation_vector = [0, 0, {number(turbine.yaw)}]" if turbine.yaw else ""
    found = [f'[body.nacelle]\nat             = "tower.end"\nmass           = {number(turbine.nacelle_mass)}\ninertia        = {row((inertia / 2, inertia / 2, inertia))}\n'
             f"centre_of_mass = {row(centre)}{turned}",
             f"[body.hub]                               # its x axis is the shaft's\nat             = {row(turbine.apex)}\nmass           = {number(turbine.hub_mass)}\n"
             f"inertia        = {row((turbine.hub_inertia, turbine.hub_inertia / 2, turbine.hub_inertia / 2))}\ncentre_of_mass = {row((turbine.hub_centre, 0.0, 0.0))}\nrotation_vector = {row(rotation_vector(turbine.shaft_axes))}"]
    if turbine.yaw_bearing_mass:
        found.append(f'[body.yaw_bearing]\nat   = "tower.end"\nmass = {number(turbine.yaw_bearing_mass)}')
    return found


def tip_masses(turbine: Turbine) -> list[str]:
    return [f'[body.tip_mass]\nat     = "blade.end"\nmass   = {number(turbine.tip_mass)}\ncopies = "blade"'] if turbine.tip_mass else []


def shaft(turbine: Turbine) -> list[str]:
    """The turn between nacelle and hub: parked, by the shaft's spring if there is one; then by a motor, if the rotor has a speed."""
    common = f'between = ["nacelle", "hub"]\nat      = {row(turbine.apex)}'
    hinge = f'type    = "hinge"\n{common}\naxis    = {row(turbine.shaft)}\n'
    spring = f"spring  = {{ stiffness = {number(turbine.shaft_stiffness)}, damping = {number(turbine.shaft_damping)} }}"
    parked = hinge + spring if turbine.shaft_stiffness else f'type    = "weld"\n{common}'
    if not turbine.speed:
        return [f"[joint.shaft]\n{parked}"]
    return [f'[joint.parked]                           # the generator is held\n{parked}\nstages  = "weight"',
            "# The rotor's speed grows smoothly until t = run_up, then it stays.\n[joint.shaft]\n" + hinge +
            'move    = "speed*(t < run_up ? t/2 - run_up/(2*pi)*sin(pi*t/run_up) : t - run_up/2)"\nstages  = "turning"']


def stages(turbine: Turbine) -> list[str]:
    found = ['[[stage]]\nname  = "weight"\nkind  = "static"\nsteps = 4',
             '# Of the turbine at rest under its weight.\n[[stage]]\nname  = "tones"\nkind  = "modes"\ncount = 12']
    if not turbine.speed:
        return found
    revolution = 2.0 * np.pi / abs(turbine.speed)
    parameters = f"[parameters]\nspeed  = {number(turbine.speed)}   # of the rotor, rad/s\nrun_up = {number(2 * TURNS_TO_SPEED * revolution, 4)}   # s"
    return [parameters, *found, "# gxrod run --until tones leaves this out.\n"
            f'[[stage]]\nname      = "turning"\nkind      = "dynamic"\nintegrator = "generalized-alpha"\nspectral_radius = 0.6\nend_time  = {number(3 * TURNS_TO_SPEED * revolution, 4)}\ntime_step = {number(revolution / 200, 2)}']


def histories(turbine: Turbine) -> list[str]:
    return ['[[history]]\nname = "tower_top"\nat   = "tower.end"\nquantities = ["displacement", "rotation_vector"]',
            '[[history]]\nname = "tower_base"\nat   = "tower.start"\nquantities = ["force_spatial", "moment_spatial"]',
            '[[history]]                              # tip_1, tip_2 …, in axes of the blade\'s root\nname = "tip"\nat   = "blade.end"\nrelative_to = "blade.start"\naxes = "untwisted"\ncopies = "blade"\nquantities = ["displacement"]',
            '[[history]]\nname = "root"\nat   = "blade.start"\ncopies = "blade"\nquantities = ["force", "moment"]']


def rotation_vector(turn: Array) -> Array:
    """Of a rotation matrix whose angle is less than half a turn, [3]."""
    axis = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2.0
    sine = float(np.linalg.norm(axis))
    return axis * (np.arctan2(sine, (np.trace(turn) - 1.0) / 2.0) / sine) if sine else axis
