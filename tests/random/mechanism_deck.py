"""A mechanism as a deck, and what it is when it is turned and moved, written in other units, or a joint's sides are exchanged."""

import copy

import numpy as np

from draw import floats
from mechanisms import COORDINATES, Times

JOINT_QUANTITIES = {"turn": ["angle", "angle_rate"], "slide": ["slide", "slide_rate"]}
BOTH = ("cylinder", "free")  # types whose coordinates are named


def plain(value):
    if isinstance(value, Times):
        return f"{float(value.size)!r}*{value.shape}"
    if isinstance(value, np.ndarray):
        return floats(value) if value.ndim == 1 else [floats(row) for row in value]
    if isinstance(value, dict):
        return {key: plain(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [plain(entry) for entry in value]
    return value


def keys_of_coordinate(which, keys):
    keys = copy.deepcopy(keys)
    if "friction" in keys and which == "turn":
        keys["friction"]["moment"] = keys["friction"].pop("force")
    return keys


def joint_keys(joint):
    keys = {key: value for key, value in joint.items() if key != "coordinates"}
    for which, coordinate in joint.get("coordinates", {}).items():
        for key, value in keys_of_coordinate(which, coordinate).items():
            if joint["type"] in BOTH:
                keys.setdefault(key, {})[which] = value
            else:
                keys[key] = value
    return keys


def coordinates_of(joint):
    """Those that a history has."""
    return ["turn", "slide"] if joint["type"] == "screw" else COORDINATES.get(joint["type"], [])


def histories(mechanism):
    found = []
    for name, joint in mechanism["joint"].items():
        quantities = [] if joint["type"] == "free" else ["gap", "force"]
        if joint["type"] not in ("free", "sleeve", "distance"):
            quantities.append("moment")
        for which in coordinates_of(joint):
            quantities += JOINT_QUANTITIES[which]
        found.append({"name": name, "at": name, "quantities": quantities})
    return found + [{"name": name, "at": name, "quantities": ["drive", "gap"]} for name in mechanism["gear"]]


def initial(spin, mechanism):
    """The velocities of a rigid motion, of rods by their places."""
    v, w, c = spin["velocity"], spin["angular_velocity"], spin["about"]
    u = floats(v - np.cross(w, c))
    w = floats(w)
    field = [f"{u[0]!r} + {w[1]!r}*z - {w[2]!r}*y", f"{u[1]!r} + {w[2]!r}*x - {w[0]!r}*z", f"{u[2]!r} + {w[0]!r}*y - {w[1]!r}*x"]
    return [{"on": name, "velocity": field, "angular_velocity": w} for kind in ("rod", "body") for name in mechanism[kind]]


def gear_keys(mechanism, gear):
    words = [f"{name}.{which}" if mechanism["joint"][name]["type"] in BOTH else name for name, which in gear["joints"]]
    return {"joints": words, "ratio": gear["ratio"]}


def deck_of(mechanism):
    """As deck.toml has it, with histories of all joints and gears."""
    deck = {key: mechanism[key] for key in ("gravity", "section", "rod", "body", "spring", "bushing") if mechanism.get(key)}
    deck["joint"] = {name: joint_keys(joint) for name, joint in mechanism["joint"].items()}
    deck["gear"] = {name: gear_keys(mechanism, gear) for name, gear in mechanism["gear"].items()}
    deck["load"] = mechanism["load"]
    if "spin" in mechanism:
        deck["initial"] = initial(mechanism["spin"], mechanism)
    deck["analysis"] = dict(mechanism["analysis"])
    if deck["analysis"]["integrator"] != "runge-kutta-4":
        deck["analysis"].setdefault("newton", {"tolerance": 1e-10})
    deck["history"] = histories(mechanism)
    deck["analysis"] = {key: value for key, value in deck["analysis"].items() if value is not None}
    return plain({key: value for key, value in deck.items() if value})


# Turned and moved

PLACES = ("at", "at_a", "at_b", "from", "to", "about")
DIRECTIONS = ("axis", "axis_b", "y_axis", "velocity", "angular_velocity", "force", "moment")


def moved(value, rotation, shift, key=""):
    """The mechanism, or a part of it, turned and then shifted."""
    if isinstance(value, dict):
        return {name: moved(entry, rotation, shift, name) for name, entry in value.items()}
    if key == "load":
        return [moved(entry, rotation, shift) for entry in value]
    if key in PLACES and isinstance(value, np.ndarray):
        return rotation @ value + shift
    if key in DIRECTIONS and isinstance(value, np.ndarray):
        return rotation @ value
    if key == "axes":
        return value @ rotation.T
    if key == "rotation_vector":
        return rotation_vector(rotation @ rotation_matrix(value))
    if key == "gravity":
        sizes = rotation @ np.array([entry.size for entry in value])
        return [Times(float(size), entry.shape) for size, entry in zip(sizes, value)]
    return value


def rotation_matrix(vector):
    angle = np.linalg.norm(vector)
    if angle == 0.0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def rotation_vector(matrix):
    """By the quaternion with its largest component found first."""
    w = np.array([1 + matrix[0, 0] + matrix[1, 1] + matrix[2, 2], 1 + matrix[0, 0] - matrix[1, 1] - matrix[2, 2],
                  1 - matrix[0, 0] + matrix[1, 1] - matrix[2, 2], 1 - matrix[0, 0] - matrix[1, 1] + matrix[2, 2]])
    skew = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]])
    sums = matrix + matrix.T
    largest = int(np.argmax(w))
    if largest == 0:
        quaternion = np.array([w[0], *skew])
    else:
        i = largest - 1
        vector = sums[i].copy()
        vector[i] = w[largest]
        quaternion = np.array([skew[i], *vector])
    quaternion /= np.linalg.norm(quaternion) * (1.0 if quaternion[0] >= 0 else -1.0)
    length = np.linalg.norm(quaternion[1:])
    return np.zeros(3) if length == 0 else 2 * np.arctan2(length, quaternion[0]) * quaternion[1:] / length


# Other units of length. Powers of the length in each number; forces have one, moments two.

POWERS = {"at": 1, "at_a": 1, "at_b": 1, "from": 1, "to": 1, "about": 1, "velocity": 1, "force": 1, "moment": 2, "gravity": 1,
          "lead": 1, "centre_of_mass": 1, "EA": 1, "GAy": 1, "GAz": 1, "GJ": 3, "EIy": 3, "EIz": 3, "rhoA": -1, "rhoIy": 1,
          "rhoIz": 1, "rx": 2, "ry": 2, "rz": 2}
OF_TURN = {"drive": 2, "stiffness": 2, "damping": 2, "force": 2}
OF_SLIDE = {"drive": 1, "rest": 1, "move": 1, "lower": 1, "upper": 1, "force": 1, "stick": 1}


def times(value, factor):
    if isinstance(value, Times):
        return value.scaled(factor)
    if isinstance(value, list):
        return [times(entry, factor) for entry in value]
    return value * factor


def rescaled(value, factor, powers, key=""):
    """With lengths `factor` times as large numbers."""
    if isinstance(value, dict):
        if key == "body":
            powers = {**powers, "inertia": 2}
        return {name: rescaled(entry, factor, {"turn": OF_TURN, "slide": OF_SLIDE}.get(name, powers), name)
                for name, entry in value.items()}
    if key == "load":
        return [rescaled(entry, factor, powers) for entry in value]
    power = powers.get(key, 0)
    return times(value, factor**power) if power and not isinstance(value, str) else value


def in_other_units(mechanism, factor):
    result = rescaled(mechanism, factor, POWERS)
    for gear in result["gear"].values():
        slides = [which == "slide" for _, which in gear["joints"]]
        gear["ratio"] *= factor ** (int(slides[1]) - int(slides[0]))
    return result


# Sides exchanged


def can_be_exchanged(joint):
    """A sleeve's rod comes first; the turn of a universal or free joint is about A's axis."""
    if joint["type"] in ("sleeve", "free"):
        return False
    return joint["type"] != "universal" or not joint["coordinates"]


def turned_back(keys):
    """The same of the coordinate with its sign changed."""
    keys = copy.deepcopy(keys)
    for key in ("drive", "move"):
        if key in keys:
            keys[key] = times(keys[key], -1.0)
    if "rest" in keys.get("spring", {}):
        keys["spring"]["rest"] = keys["spring"]["rest"].scaled(-1.0)
    if "limits" in keys:
        keys["limits"]["lower"], keys["limits"]["upper"] = -keys["limits"]["upper"], -keys["limits"]["lower"]
    return keys


def exchanged(mechanism):
    """With A and B of all joints exchanged where that is possible; and the names of these."""
    result = copy.deepcopy(mechanism)
    geared = {name for gear in mechanism["gear"].values() for name, _ in gear["joints"]}
    names = []
    for name, joint in result["joint"].items():
        if not can_be_exchanged(joint) or joint["type"] == "universal" and name in geared:
            continue
        names.append(name)
        joint["between"] = joint["between"][::-1]
        for one, other in (("at_a", "at_b"), ("axis", "axis_b")):
            if one in joint and other in joint:
                joint[one], joint[other] = joint[other], joint[one]
        joint["coordinates"] = {which: turned_back(keys) for which, keys in joint["coordinates"].items()}
    for gear in result["gear"].values():
        gear["ratio"] *= (-1) ** sum(name in names for name, _ in gear["joints"])
    return result, names
