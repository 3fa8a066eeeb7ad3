"""Random sections: constants, matrices, shapes; all about one bending stiffness, with contrasts where drawn."""

import dataclasses

import numpy as np

from draw import floats


@dataclasses.dataclass
class SectionPlan:
    """What the rest of a deck needs to know of a section to choose loads and steps that fit."""

    name: str
    bending: float  # the smaller EI
    axial: float
    shear: float
    mass: float  # per length
    rotary: float  # the smallest rotary inertia per length


def constants(draw, wanted):
    bending = wanted["bending"]
    ratio = draw.pick([1.0, draw.log_uniform(1e-2, 1.0)])
    return {"EA": wanted["axial"], "GAy": wanted["axial"] * draw.uniform(0.1, 1.0),
            "GAz": wanted["axial"] * draw.uniform(0.1, 1.0), "GJ": bending * draw.log_uniform(0.1, 3.0),
            "EIy": bending, "EIz": bending / ratio}


def inertia(draw, wanted):
    entries = {"rhoA": wanted["mass"], "rhoIy": wanted["rotary"], "rhoIz": wanted["rotary"] * draw.uniform(1.0, 3.0)}
    if draw.chance(0.3):
        entries["rhoJ"] = wanted["rotary"] * draw.uniform(1.0, 4.0)
    return {key: float(value) for key, value in entries.items()}


def coupled(draw, diagonal):
    """A positive definite matrix with this diagonal."""
    factor = draw.random.normal(size=(6, 6))
    matrix = factor @ factor.T
    scale = np.sqrt(np.diag(matrix))
    share = draw.uniform(0.0, 0.5)
    matrix = (1.0 - share) * np.eye(6) + share * matrix / np.outer(scale, scale)
    root = np.sqrt(diagonal)
    return (matrix + matrix.T) / 2 * np.outer(root, root)


def mass_matrix(draw, wanted):
    """That of a rigid slice whose centre of mass can be off the line."""
    mass, radius = wanted["mass"], np.sqrt(wanted["rotary"] / wanted["mass"])
    offset = draw.vector(0.3 * radius) if draw.chance(0.6) else np.zeros(3)
    skew = np.array([[0, -offset[2], offset[1]], [offset[2], 0, -offset[0]], [-offset[1], offset[0], 0]])
    about_centre = np.diag(wanted["rotary"] * np.array([2.0, 1.0, 1.0]))
    matrix = np.zeros((6, 6))
    matrix[:3, :3] = mass * np.eye(3)
    matrix[:3, 3:] = -mass * skew
    matrix[3:, :3] = mass * skew
    matrix[3:, 3:] = about_centre - mass * skew @ skew
    return [floats(row) for row in matrix]


def shape(draw, wanted):
    """A shape whose radius of gyration is the one wanted; its area and second moment."""
    radius = np.sqrt(wanted["bending"] / wanted["axial"])
    kind = draw.pick(["circle", "tube", "rectangle"])
    if kind == "circle":
        outer = 2.0 * radius
        return {"circle": {"radius": float(outer)}}, np.pi * outer**2, np.pi * outer**4 / 4
    if kind == "tube":
        share = draw.uniform(0.05, 0.98)
        outer = 2.0 * radius / np.sqrt(1 + share**2)
        inner = share * outer
        return ({"tube": {"outer_radius": float(outer), "inner_radius": float(inner)}},
                np.pi * (outer**2 - inner**2), np.pi * (outer**4 - inner**4) / 4)
    height = np.sqrt(12.0) * radius
    width = height * draw.log_uniform(1.0, 10.0)
    return {"rectangle": {"width_y": float(width), "height_z": float(height)}}, width * height, width * height**3 / 12


def material(draw, wanted, area, second_moment, is_massive):
    entries = {"E": float(wanted["bending"] / second_moment)}
    if draw.chance(0.7):
        entries["nu"] = draw.pick([0.0, 0.3, 0.5, draw.uniform(-0.9, 0.5)])
    else:
        entries["G"] = float(wanted["bending"] / second_moment * draw.uniform(0.335, 2.0))
    if is_massive:
        entries["density"] = float(wanted["mass"] / area)
    if draw.chance(0.3):
        entries["shear_factor"] = draw.pick([1.0, draw.uniform(0.3, 1.2)])
    return entries


def damping(draw, period):
    entries = {}
    if draw.chance(0.7):
        entries["kelvin_voigt"] = float(period * draw.log_uniform(1e-7, 1e-2))
    if draw.chance(0.5):
        entries["mass_proportional"] = float(draw.log_uniform(1e-3, 1e1) / period)
    return entries or {"kelvin_voigt": 0.0, "mass_proportional": 0.0}


def add_stiffness(draw, wanted, is_massive, section):
    kind = draw.weighted({"stiffness": 4, "stiffness_matrix": 2, "shape": 3})
    if kind == "stiffness":
        section["stiffness"] = {key: float(value) for key, value in constants(draw, wanted).items()}
    elif kind == "stiffness_matrix":
        section["stiffness_matrix"] = [floats(row) for row in
                                       coupled(draw, list(constants(draw, wanted).values()))]
    else:
        section["shape"], area, second_moment = shape(draw, wanted)
        section["material"] = material(draw, wanted, area, second_moment, is_massive)


def add_section(draw, name, scales, deck):
    """Writes a section into the deck and returns its plan."""
    contrast = draw.log_uniform(1e-6, 1e6) if draw.chance(0.25) else draw.log_uniform(0.3, 3.0)
    bending = scales.bending * contrast
    slenderness = draw.log_uniform(5.0, 1e5) if draw.chance(0.7) else draw.uniform(3.0, 30.0)
    radius = scales.length / slenderness
    mass = scales.mass_per_length * draw.log_uniform(0.3, 3.0)
    wanted = {"bending": bending, "axial": bending / radius**2, "mass": mass, "rotary": mass * radius**2}
    section = {}
    is_massive = not scales.is_static or draw.chance(0.5)
    add_stiffness(draw, wanted, is_massive, section)
    if is_massive and "shape" not in section:
        if draw.chance(0.6):
            section["inertia"] = inertia(draw, wanted)
        else:
            section["mass_matrix"] = mass_matrix(draw, wanted)
    if draw.chance(0.25):
        section["damping"] = damping(draw, scales.period)
    deck.setdefault("section", {})[name] = section
    return SectionPlan(name, bending, wanted["axial"], wanted["axial"], mass, wanted["rotary"])
