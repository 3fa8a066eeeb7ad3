"""Random mechanisms: make_mechanism(seed, index) joins rods and bodies by joints of every type in trees and loops, with gears,
springs, bushings, motors, friction and limits.

A mechanism is a dict like a deck's. What differs, so that it can be turned, moved and written in other units:
joints keep their motors, drives, springs, friction and limits in `coordinates`, {"turn": {...}, "slide": {...}};
functions of time are Times; `spin` is the velocity (at `about`) and angular velocity with which all of it starts; vectors are
arrays. All joints are closed at t = 0, because both sides are placed there."""

import dataclasses

import numpy as np

from draw import Draw
from mobility import Mobility

STREAM = 2 * 10**6  # added to the seed
COORDINATES = {"hinge": ["turn"], "cylinder": ["turn", "slide"], "slider": ["slide"], "screw": ["turn"], "plane": ["turn"],
               "universal": ["turn"], "free": ["turn", "slide"], "sleeve": ["slide"]}
TYPES = {"ball": 3, "hinge": 5, "cylinder": 3, "slider": 3, "universal": 3, "screw": 3, "plane": 2, "weld": 1, "distance": 2,
         "free": 1}
SINE, RAMP, PARABOLA = "sin({w!r}*t)", "(1 - cos({w!r}*t))", "({w!r}*t)^2"


@dataclasses.dataclass
class Times:
    """A number of some dimension times a function of t."""

    size: float
    shape: str

    def scaled(self, factor):
        return Times(self.size * factor, self.shape)


@dataclasses.dataclass
class Part:
    """A rod or body to which joints can be made."""

    name: str
    place: np.ndarray
    is_rod: bool = False
    line: tuple = ()

    def point(self, draw):
        """What a joint calls it, and where its node is."""
        if not self.is_rod:
            return self.name, self.place
        word, fraction = draw.pick([("start", 0.0), ("end", 1.0), ("end", 1.0)])
        return f"{self.name}.{word}", self.line[0] + fraction * (self.line[1] - self.line[0])


GROUND = Part("ground", np.zeros(3))


class Maker:
    """Draws a mechanism: sizes are about `size`, `mass` and `time` of the deck's units."""

    def __init__(self, seed, index):
        self.draw = Draw(seed + STREAM, index)
        draw = self.draw
        self.size, self.mass, self.time = (draw.log_uniform(0.1, 10.0) for _ in range(3))
        self.is_floating = draw.chance(0.3)
        self.of_bodies = draw.chance(0.35)  # no rods
        self.is_ideal = draw.chance(0.4)  # no friction, dampers or limits: energy is kept
        self.parts = []
        self.mechanism = {"rod": {}, "body": {}, "joint": {}, "section": {}, "spring": {}, "bushing": {}, "gear": {}, "load": []}

    def make(self):
        draw = self.draw
        for number in range(draw.integer(1, 5) + (1 if self.is_floating else 0)):
            self.add_part(number)
        self.add_loops()
        self.add_coordinates()
        self.add_gear()
        self.add_sleeve()
        self.add_motors()
        self.add_springs()
        self.add_causes()
        self.mechanism["analysis"] = self.analysis()
        return self.mechanism

    # Parts and joints

    def vector(self, size=1.0):
        return self.draw.vector(size * self.size)

    def add_part(self, number):
        draw = self.draw
        parent = draw.pick(self.parts) if self.parts and draw.chance(0.9) else GROUND
        if self.is_floating and self.parts:
            parent = draw.pick(self.parts)
        word, place = parent.point(draw) if parent is not GROUND else ("ground", self.vector(0.3))
        at = place + (self.vector(0.3) if draw.chance(0.5) and parent is not GROUND else 0.0)
        node = at + (self.vector(0.3) if draw.chance(0.5) else 0.0)
        part = self.add_rod(number, node) if draw.chance(0.0 if self.of_bodies else 0.5) else self.add_body(number, node)
        if not self.is_floating or self.parts:
            self.add_joint(draw.weighted(TYPES), (word, place), (part.point(draw)[0] if not part.is_rod else
                                                                f"{part.name}.start", node), at)
        self.parts.append(part)

    def add_rod(self, number, start):
        draw, name = self.draw, f"r{number}"
        length = self.size * draw.uniform(0.5, 1.5)
        end = start + length * draw.direction()
        per_length = self.mass / self.size * draw.log_uniform(0.1, 1.0)
        bending = per_length * length**4 / self.time**2 * draw.log_uniform(0.3, 30.0)
        axial = bending / length**2 * draw.log_uniform(30.0, 300.0)
        rotary = per_length * bending / axial
        self.mechanism["section"][f"s{number}"] = {
            "stiffness": {"EA": axial, "GAy": 0.4 * axial, "GAz": 0.3 * axial, "GJ": 0.8 * bending, "EIy": bending,
                          "EIz": bending * draw.log_uniform(0.5, 2.0)},
            "inertia": {"rhoA": per_length, "rhoIy": rotary, "rhoIz": 1.2 * rotary}}
        self.mechanism["rod"][name] = {
            "section": f"s{number}", "line": {"from": start, "to": end}, "elements": draw.integer(2, 4),
            "order": draw.integer(1, 3), "y_axis": draw.direction(), "element": draw.pick(["objective", "objective", "simo"])}
        return Part(name, start, True, (start, end))

    def add_body(self, number, place):
        draw, name = self.draw, f"b{number}"
        mass = self.mass * draw.log_uniform(0.1, 10.0)
        principal = mass * (0.3 * self.size)**2 * np.array([draw.log_uniform(0.3, 1.0) for _ in range(3)])
        self.mechanism["body"][name] = {
            "mass": mass, "inertia": np.array([principal[1] + principal[2], principal[2] + principal[0],
                                               principal[0] + principal[1]]), "at": place,
            "centre_of_mass": self.vector(0.2) * (1.0 if draw.chance(0.5) else 0.0),
            "rotation_vector": draw.direction() * draw.uniform(0.0, 3.0)}
        return Part(name, place)

    def add_joint(self, kind, first, second, at):
        """Between two (point, place); B comes first now and then."""
        draw = self.draw
        ends = [first, second] if draw.chance(0.6) else [second, first]
        joint = {"type": kind, "between": [ends[0][0], ends[1][0]]}
        axis = draw.direction()
        if kind == "distance":
            places = [end[1] + self.vector(0.3) for end in ends]
            joint["at_a"], joint["at_b"] = places
        else:
            joint["at"] = at
        if kind not in ("ball", "weld", "distance"):
            joint["axis"] = axis * draw.log_uniform(0.1, 10.0)
        if kind == "universal":
            across = np.cross(axis, draw.direction())
            joint["axis_b"] = across
        if kind == "screw":
            joint["lead"] = self.size * draw.uniform(0.1, 1.0) * draw.pick([-1, 1])
        name = f"j{len(self.mechanism['joint'])}"
        self.mechanism["joint"][name] = joint
        return name

    def add_loops(self):
        """Joints that close loops: between parts that there are, or one and the ground."""
        draw = self.draw
        if len(self.parts) < 2 or not draw.chance(0.5):
            return
        for _ in range(draw.integer(1, 2)):
            first, second = (self.parts[i] for i in draw.random.permutation(len(self.parts))[:2])
            ends = [first.point(draw), second.point(draw)]
            if not self.is_floating and draw.chance(0.4):
                ends[0] = ("ground", self.vector(0.3))
            kind = draw.weighted({"distance": 4, "ball": 2, "plane": 2, "universal": 1, "cylinder": 1, "hinge": 0.7, "screw": 0.3})
            self.add_joint(kind, *ends, (ends[0][1] + ends[1][1]) / 2 + self.vector(0.2))

    def add_sleeve(self):
        draw, rods = self.draw, list(self.mechanism["rod"].items())
        if not rods or not draw.chance(0.4):
            return
        name, rod = draw.pick(rods)
        rod["elements"], rod["order"] = 4, draw.integer(2, 3)
        line = rod["line"]
        place = line["from"] + draw.uniform(0.4, 0.6) * (line["to"] - line["from"])
        others = [part for part in self.parts if part.name != name]
        holds_turn = False
        if others and draw.chance(0.5):
            other = draw.pick(others).point(draw)[0]
        elif self.is_floating:
            return
        elif draw.chance(0.3):
            other = "ground"
        else:
            other = self.add_body(90, place).name
            self.parts.append(Part(other, place))
            holds_turn = draw.chance(0.5)
        stiffness = 30.0 * self.mass / self.time**2
        self.mechanism["joint"]["sleeve"] = {
            "type": "sleeve", "between": [name, other], "at": place,
            "coordinates": {"slide": {"spring": {"stiffness": stiffness}}}}
        if holds_turn:
            self.mechanism["joint"]["sleeve"]["turn"] = False

    # What acts

    def units_of(self, which):
        """Of the coordinate, and of its force."""
        force = self.mass * self.size / self.time**2
        return (1.0, force * self.size) if which == "turn" else (self.size, force)

    def time_function(self, shapes=(SINE, RAMP, PARABOLA)):
        return self.draw.pick(shapes).format(w=self.draw.uniform(0.5, 3.0) / self.time)

    def add_coordinates(self):
        draw = self.draw
        for joint in self.mechanism["joint"].values():
            joint["coordinates"] = {}
            for which in COORDINATES.get(joint["type"], []):
                if draw.chance(0.6) or joint["type"] == "free" and which == "turn":
                    joint["coordinates"][which] = self.coordinate(*self.units_of(which))

    def coordinate(self, size, force):
        draw = self.draw
        keys = {}
        if draw.chance(0.4):
            keys["drive"] = Times(force * draw.uniform(-1.0, 1.0), self.time_function())
        if draw.chance(0.5) or not keys:
            keys["spring"] = {"stiffness": force / size * draw.log_uniform(0.3, 10.0)}
            if draw.chance(0.3):
                keys["spring"]["rest"] = Times(0.3 * size, self.time_function())
            if not self.is_ideal and draw.chance(0.5):
                keys["spring"]["damping"] = 0.1 * force / size * self.time
        if not self.is_ideal and draw.chance(0.3):
            keys["friction"] = {"force": 0.3 * force, "stick": 0.02 * size}
        if not self.is_ideal and draw.chance(0.3):
            keys["limits"] = {"lower": -0.1 * size, "upper": 0.2 * size, "stiffness": 30.0 * force / size,
                              "damping": force / size * self.time}
        return keys

    def add_gear(self):
        draw = self.draw
        choices = [(name, which) for name, joint in self.mechanism["joint"].items()
                   for which in COORDINATES.get(joint["type"], []) if joint["type"] not in ("free", "sleeve")]
        pairs = [(a, b) for a in choices for b in choices if a[0] != b[0]]
        if not pairs or not draw.chance(0.4):
            return
        pair = draw.pick(pairs)
        sizes = [self.units_of(which)[0] for _, which in pair]
        self.mechanism["gear"]["g0"] = {"joints": list(pair), "ratio": sizes[1] / sizes[0] * draw.log_uniform(0.3, 3.0)
                                        * draw.pick([-1, 1])}

    def add_motors(self):
        """On coordinates that nothing else prescribes."""
        draw = self.draw
        mobility = Mobility(self.mechanism, self.size)
        choices = [(name, which) for name, joint in self.mechanism["joint"].items() if joint["type"] != "sleeve"
                   for which in COORDINATES.get(joint["type"], [])]
        if not choices or not draw.chance(0.5):
            return
        for name, which in draw.some(choices, 2):
            if not mobility.can_move(name, which):
                continue
            mobility.add_motor(name, which)
            keys = self.mechanism["joint"][name]["coordinates"].setdefault(which, {})
            keys.pop("drive", None)
            keys["move"] = Times(0.15 * self.units_of(which)[0] * draw.uniform(-1.0, 1.0), self.time_function((RAMP, PARABOLA)))

    def add_springs(self):
        draw = self.draw
        for number in range(draw.pick([0, 0, 1, 2])):
            if len(self.parts) < 2:
                return
            first, second = (self.parts[i] for i in draw.random.permutation(len(self.parts))[:2])
            ends = [first.point(draw), second.point(draw)]
            if not self.is_floating and draw.chance(0.4):
                ends[0] = ("ground", self.vector(0.5))
            stiffness = self.mass / self.time**2 * draw.log_uniform(0.3, 10.0)
            between = [end[0] for end in ends]
            if draw.chance(0.6):
                places = [end[1] + self.vector(0.3) for end in ends]
                spring = {"between": between, "at_a": places[0], "at_b": places[1], "stiffness": stiffness}
                if not self.is_ideal:
                    spring["damping"] = 0.03 * stiffness * self.time
                self.mechanism["spring"][f"k{number}"] = spring
            else:
                turning = stiffness * self.size**2
                self.mechanism["bushing"][f"m{number}"] = {
                    "between": between, "at": ends[1][1] + self.vector(0.1), "axes": draw.rotation(),
                    "stiffness": {"x": stiffness, "z": 0.5 * stiffness, "rx": 0.3 * turning, "ry": turning}}

    def add_causes(self):
        draw = self.draw
        if not self.is_floating and draw.chance(0.7):
            self.mechanism["gravity"] = [Times(value, RAMP.format(w=2.0 / self.time))
                                         for value in draw.vector(2.0 * self.size / self.time**2)]
        part = draw.pick(self.parts)
        if not self.is_floating and draw.chance(0.5):
            force = self.mass * self.size / self.time**2
            self.mechanism["load"].append({
                "at": part.point(draw)[0], "force": draw.vector(force), "moment": draw.vector(0.3 * force * self.size),
                "frame": draw.pick(["spatial", "follower"]), "factor": Times(1.0, RAMP.format(w=1.5 / self.time))})
        if self.is_floating:
            self.mechanism["spin"] = {"velocity": self.vector() / self.time, "angular_velocity": draw.vector(1.0 / self.time),
                                      "about": self.vector()}

    def analysis(self):
        draw = self.draw
        schemes = ["newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "sdirk-4"]
        if not self.mechanism["rod"] and self.is_ideal and "sleeve" not in self.mechanism["joint"]:
            schemes.append("runge-kutta-4")
        steps = draw.integer(10, 30)
        step = short(self.time * draw.uniform(0.3, 1.0) / steps)
        return {"kind": "dynamic", "end_time": steps * step, "steps": steps, "integrator": draw.pick(schemes)}


def short(number):
    """About the number, of six bits, so that its multiples are exact."""
    mantissa, exponent = np.frexp(number)
    return float(np.ldexp(np.round(mantissa * 64) / 64, exponent))


def make_mechanism(seed, index):
    return Maker(seed, index).make()
