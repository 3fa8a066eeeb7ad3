"""What a sketch needs of a deck: its numbers, curves, supports and loads, with expressions evaluated."""

import math
import re
import tomllib

import numpy as np

NAMES = {"pi": math.pi, **{name: getattr(math, name) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp")},
         "min": min, "max": max, "abs": abs,
         **dict.fromkeys(("x", "y", "z", "vx", "vy", "vz"), 0.0)}  # of loads by place, which a sketch has no place for
ARC_POINTS = 121
SAMPLES = 6001  # of the time, to find the largest of a load
TURNED = ("from", "to", "through", "centre", "at", "at_a", "at_b", "axis", "axis_b", "force", "moment")  # first the places
FREE_AXES = ("rx", "ry", "rz")


def to_python(expression):
    """A deck's expression as Python's: powers, and `a ? b : c`."""
    condition, mark, rest = expression.replace("^", "**").partition("?")
    if not mark:
        return condition.strip()
    then, _, otherwise = rest.partition(":")
    return f"(({to_python(then)}) if ({condition.strip()}) else ({to_python(otherwise)}))"


class Deck:
    """A deck of lines, arcs, helices and bodies, as read from its file."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.tree = tomllib.load(file)
        self.names = dict(NAMES)
        for name, value in self.tree.get("parameters", {}).items():
            self.names[name] = self.number(value)
        for name, signal in self.tree.get("signal", {}).items():
            self.names[name] = signal.get("start", 0.0)
        for name, value in self.tree.get("function", {}).items():
            self.names[name] = self._function(value)
        self._expand_copies()
        self.stages = self.tree.get("stage") or [self.tree["analysis"]]
        self.is_static = all(stage["kind"] != "dynamic" for stage in self.stages)
        self.rods = {name: self._curve(rod) for name, rod in self.tree.get("rod", {}).items()}

    def _expand_copies(self):
        """Tables with `copies` as many times, turned, with numbers after their names."""
        tables = [self.tree.get(kind, {}) for kind in ("rod", "body", "joint", "spring", "bushing")]
        copies = {name: table["copies"] for kind in tables for name, table in kind.items() if isinstance(table.get("copies"), dict)}

        def turned(value, key, number, by):
            if isinstance(value, dict):
                return {inner: turned(entry, inner, number, by) for inner, entry in value.items() if inner != "copies"}
            if key in TURNED and isinstance(value, list) and len(value) == 3:
                angle = 2.0 * math.pi * number / by["count"]
                axis, through = (self.vector(by.get(word, otherwise)) for word, otherwise in (("about", (0, 0, 1)), ("through", (0, 0, 0))))
                axis, vector = axis / np.linalg.norm(axis), self.vector(value) - (through if key in TURNED[:7] else 0.0)
                along = axis * (axis @ vector)
                vector = along + np.cos(angle) * (vector - along) + np.sin(angle) * np.cross(axis, vector)
                return list(vector + (through if key in TURNED[:7] else 0.0))
            if isinstance(value, list):
                return [turned(entry, key, number, by) for entry in value]
            name = re.split(r"[.@]", value)[0] if isinstance(value, str) else None
            is_named = key == "name" or (name in copies and key in ("at", "on", "between", "points"))
            return f"{name}_{number + 1}{value[len(name):]}" if is_named else value

        def expanded(table):
            by = table.get("copies")
            by = copies[by] if isinstance(by, str) else by
            return [turned(table, "", number, by) for number in range(by["count"])] if by else [table]

        for kind, entries in self.tree.items():
            if isinstance(entries, list) and kind != "stage":
                self.tree[kind] = [one for table in entries for one in (expanded(table) if isinstance(table, dict) else [table])]
            elif kind in ("rod", "body", "joint", "spring", "bushing"):
                self.tree[kind] = {f"{name}_{i + 1}" if "copies" in table else name: one
                                   for name, table in entries.items() for i, one in enumerate(expanded(table))}

    def _function(self, value):
        if "table" in value:
            times, values = np.array([[self.number(entry) for entry in row] for row in value["table"]]).T
            return lambda t: float(np.interp(t, times, values))
        return lambda t: self.number(value["expression"], t=t)

    def number(self, value, **variables):
        """A number, or the value of an expression."""
        if not isinstance(value, str):
            return float(value)
        return float(eval(to_python(value), {"__builtins__": {}}, self.names | variables))  # pylint: disable=eval-used

    def vector(self, values, **variables):
        return np.array([self.number(value, **variables) for value in values])

    def _curve(self, rod):
        """Points [n,3] along a rod."""
        if "line" in rod:
            return np.array([self.vector(rod["line"]["from"]), self.vector(rod["line"]["to"])])
        if "arc" in rod:
            return self._arc(rod["arc"])
        if "catenary" in rod:
            return self._wave(rod) if "sections" in rod else self._catenary(rod["catenary"])
        if "helix" in rod:
            return self._helix(rod["helix"])
        if "spline" in rod:
            return self._spline(rod["spline"])
        raise ValueError("sketches know rods by line, arc, helix, catenary or spline; teach Deck in docs/verification/book/deck.py the others")

    def _helix(self, helix):
        centre, along = self.vector(helix["centre"]), self.vector(helix["axis"])
        along = along / np.linalg.norm(along)
        start = self.vector(helix["from"]) - centre
        rise, turns = along * (along @ start), np.linspace(0.0, self.number(helix["turns"]), 20 * ARC_POINTS)
        start, pitch = start - rise, self.number(helix["pitch"])
        angles = 2.0 * np.pi * turns[:, None]
        return centre + rise + np.cos(angles) * start + np.sin(angles) * np.cross(along, start) + pitch * turns[:, None] * along

    def _spline(self, corners):
        """The natural cubic spline: second derivatives m by the length of the chords, then points of each piece."""
        corners = np.array([self.vector(corner) for corner in corners])
        chords = np.linalg.norm(np.diff(corners, axis=0), axis=1)
        slopes = np.diff(corners, axis=0) / chords[:, None]
        matrix, right = np.eye(len(corners)), np.zeros_like(corners)
        for i in range(1, len(corners) - 1):
            matrix[i, i - 1:i + 2] = chords[i - 1], 2.0 * (chords[i - 1] + chords[i]), chords[i]
            right[i] = 6.0 * (slopes[i] - slopes[i - 1])
        m = np.linalg.solve(matrix, right)
        points = [corners[:1]]
        for i, h in enumerate(chords):
            b = np.linspace(0.0, 1.0, 21)[1:, None]
            a = 1.0 - b
            points.append(a * corners[i] + b * corners[i + 1] + ((a**3 - a) * m[i] + (b**3 - b) * m[i + 1]) * h**2 / 6.0)
        return np.concatenate(points)

    def _catenary(self, line):
        """Of a line on the bed, from its lower end to the touch-down; else from end to end."""
        start, end = self.vector(line["from"]), self.vector(line["to"])
        length, way = self.number(line["length"]), end - start
        span, rise = np.hypot(way[0], way[1]), way[2]
        s = np.linspace(0.0, length, ARC_POINTS)

        def hang(a):  # from the touch-down up: horizontal and vertical way after the arc length u
            on_bed = length - np.sqrt(rise**2 + 2.0 * a * rise)
            u = np.maximum(s - on_bed, 0.0)
            return np.minimum(s, on_bed) + a * np.arcsinh(u / a), np.sqrt(a**2 + u**2) - a

        def swing(a):  # freely; u from the lowest point, which can lie beyond an end
            middle = a * np.arcsinh(rise / (2.0 * a * np.sinh(0.5 * span / a)))
            first = a * np.sinh((middle - 0.5 * span) / a)
            u = s + first
            return a * np.arcsinh(u / a) - (middle - 0.5 * span), np.hypot(a, u) - np.hypot(a, first)

        if line.get("bed"):
            far = lambda a: hang(a)[0][-1] - span
        else:
            far = lambda a: 2.0 * a * np.sinh(0.5 * span / a) - np.sqrt(length**2 - rise**2)
        low, high = 1e-2 * length, 1e3 * length
        for _ in range(200):
            middle = np.sqrt(low * high)
            if (far(middle) > 0.0) == (far(high) > 0.0):
                high = middle
            else:
                low = middle
        x, z = (hang if line.get("bed") else swing)(high)
        along = np.append(way[:2] / span, 0.0)
        return start + x[:, None] * along + z[:, None] * np.array([0.0, 0.0, 1.0])

    def _wave(self, rod):
        """Of a line of several sections that lies on the bed from its start to its touch-down, V = 0 there."""
        line = rod["catenary"]
        start, way = self.vector(line["from"]), self.vector(line["to"]) - self.vector(line["from"])
        span, s = np.hypot(way[0], way[1]), np.linspace(0.0, self.number(line["length"]), 2000)
        stations = [(self.number(at), self.weight(name)) for at, name in rod["sections"]]
        weight = np.interp(s / s[-1], [at + 1e-9 * i for i, (at, _) in enumerate(stations)], [w for _, w in stations])
        load, step = np.cumsum(weight) * s[1], s[1]

        def hang(level, lying):
            upright = np.where(s > lying, load - np.interp(lying, s, load), 0.0)
            tension = np.hypot(level, upright)
            return np.cumsum(level / tension) * step, np.cumsum(upright / tension) * step

        def bisect(is_high, low, high):
            for _ in range(60):
                middle = 0.5 * (low + high)
                low, high = (low, middle) if is_high(middle) else (middle, high)
            return low

        lift = lambda level: bisect(lambda lying: hang(level, lying)[1][-1] < way[2], 0.0, s[-1])
        level = np.exp(bisect(lambda log: hang(np.exp(log), lift(np.exp(log)))[0][-1] > span, -5.0, np.log(1e3 * np.abs(load).max())))
        x, z = hang(level, lift(level))
        return start + x[::40, None] * np.append(way[:2] / span, 0.0) + z[::40, None] * np.array([0.0, 0.0, 1.0])

    def weight(self, name):
        """Of a section per length, in water if there is some."""
        section, gravity = self.tree["section"][name], -self.vector(self.tree["gravity"])[2]
        displaced = 0.25 * np.pi * self.number(section["fluid"]["outer_diameter"]) ** 2 if "fluid" in section else 0.0
        return gravity * (self.number(section["inertia"]["rhoA"]) - self.number(self.tree.get("fluid", {}).get("density", 0.0)) * displaced)

    def _arc(self, arc):
        if "through" in arc:
            return self._arc_through(*(self.vector(arc[key]) for key in ("from", "through", "to")))
        centre, axis, start = (self.vector(arc[key]) for key in ("centre", "axis", "from"))
        angles = np.linspace(0.0, self.number(arc["angle"]), ARC_POINTS)[:, None]
        axis = axis / np.linalg.norm(axis)
        radius = start - centre
        return centre + np.cos(angles) * radius + np.sin(angles) * np.cross(axis, radius)

    @staticmethod
    def _arc_through(start, middle, end):
        """From `start` to `end` on the circle through three points."""
        to_middle, to_end = middle - start, end - start
        axis = np.cross(to_middle, to_end)
        to_centre = np.cross(axis, to_middle * (to_end @ to_end) - to_end * (to_middle @ to_middle)) / (2 * axis @ axis)
        radius = -to_centre
        axis = axis / np.linalg.norm(axis)
        sideways = np.cross(axis, radius)
        turn = np.arctan2((to_end + radius) @ sideways, (to_end + radius) @ radius) % (2 * np.pi)
        angles = np.linspace(0.0, turn, ARC_POINTS)[:, None]
        return start + to_centre + np.cos(angles) * radius + np.sin(angles) * sideways

    def springs(self):
        """Both ends of each, at the start."""
        for spring in self.tree.get("spring", {}).values():
            yield [self.vector(spring[key]) if key in spring else self.place(at)[0]
                   for at, key in zip(spring["between"], ("at_a", "at_b"))]

    def grounds(self):
        """Where springs are fixed to the ground."""
        for spring in self.tree.get("spring", {}).values():
            yield from (self.vector(spring[key]) for at, key in zip(spring["between"], ("at_a", "at_b")) if at == "ground")

    def place(self, at):
        """Position and tangent of `rod.start`, `rod.end`, `rod@0.5` or a body."""
        if at in self.tree.get("body", {}):
            node = self.tree["body"][at].get("at", [0, 0, 0])
            return (self.place(node)[0] if isinstance(node, str) else self.vector(node)), np.zeros(3)
        if at in self.tree.get("joint", {}):
            return self.joint_place(self.tree["joint"][at]), np.zeros(3)
        rod, where = re.fullmatch(r"(\w+)(\.start|\.end|@.*)", at).groups()
        curve = self.rods[rod]
        share = {".start": 0.0, ".end": 1.0}.get(where)
        share = self.number(where[1:]) if share is None else share
        lengths = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1)))
        point = np.array([np.interp(share * lengths[-1], lengths, column) for column in curve.T])
        index = min(int(share * (len(curve) - 1)), len(curve) - 2)
        tangent = curve[index + 1] - curve[index]
        return point, tangent / np.linalg.norm(tangent)

    def largest(self, values, factor=1.0):
        """The largest vector that functions of time take in any stage, signed, and whether it changes."""
        found = []
        for stage in self.stages:
            if isinstance(factor, dict) and stage["name"] not in factor:
                continue  # as in the stage before
            times = factor[stage["name"]] if isinstance(factor, dict) else factor
            end = self.number(stage.get("end_time", 1.0))
            found += [self.number(times, t=t) * self.vector(values, t=t) for t in np.linspace(0.0, end, SAMPLES)]
        found = np.array(found)
        sizes = np.linalg.norm(found, axis=1)
        return found[sizes.argmax()], bool(np.ptp(found, axis=0).max() > 1e-12 * max(sizes.max(), 1e-300))

    def supports(self):
        """(place, tangent into the rod, components held, {component: largest prescribed}, rows of own axes) of each support."""
        for support in self.tree.get("support", []):
            move = {key: self.largest([value])[0][0] for key, value in support.get("move", {}).items()}
            place, tangent = self.place(support["at"])
            into = -tangent if support["at"].endswith(".end") else tangent
            axes = np.array([self.vector(row) for row in support.get("axes", np.eye(3))])
            yield place, into, held_components(support.get("fix", [])), move, axes

    def loads(self):
        """(place, "force" or "moment", the largest in global components, whether it changes)."""
        for load in self.tree.get("load", []):
            if "at" not in load:
                continue  # along a rod
            place, tangent = self.place(load["at"])
            for kind in ("force", "moment"):
                if kind in load:
                    vector, changes = self.largest(load[kind], load.get("factor", 1.0))
                    if not vector.any():
                        continue  # by place
                    if load.get("frame") == "body":
                        vector = self._section_axes(load["at"].partition(".")[0], tangent) @ vector
                    yield place, kind, vector, changes

    def _section_axes(self, rod, tangent):
        """Columns x, y, z of a section of a straight rod."""
        y_axis = self.vector(self.tree["rod"][rod]["y_axis"])
        y_axis = y_axis - (y_axis @ tangent) * tangent
        y_axis /= np.linalg.norm(y_axis)
        return np.column_stack([tangent, y_axis, np.cross(tangent, y_axis)])

    def velocities(self, count=11):
        """(place, velocity) of points of rods that begin in motion."""
        for initial in self.tree.get("initial", []):
            curve = self.rods[initial["on"]]
            for share in np.linspace(0.0, 1.0, count):
                place = (1.0 - share) * curve[0] + share * curve[-1]
                yield place, self.vector(initial["velocity"], **dict(zip("xyz", place)))

    def joint_place(self, joint):
        """Where it is at the start: `at`, else the point that is not the ground, of a rod rather than of a body."""
        if joint["type"] == "distance":  # at its other end, where that is on the ground
            for end, key in zip(joint["between"], ("at_a", "at_b")):
                if end == "ground" and key in joint:
                    return self.vector(joint[key])
        if "at" in joint:
            return self.vector(joint["at"])
        points = [point for point in joint["between"] if point != "ground" and point not in self.rods]
        return self.place(min(points, key=lambda point: point in self.tree.get("body", {})))[0]

    def joints(self):
        """(its table, place) of each."""
        for joint in self.tree.get("joint", {}).values():
            yield joint, self.joint_place(joint)

    def points_of_body(self, name):
        """Where joints and springs hold a body, each place once."""
        found = [place for joint, place in self.joints() if name in joint["between"]]
        found += [ends[spring["between"].index(name)] for spring, ends in zip(self.tree.get("spring", {}).values(), self.springs())
                  if name in spring["between"]]
        return [place for index, place in enumerate(found)
                if not any(np.allclose(place, other, atol=1e-9) for other in found[:index])]

    def places(self, names):
        """Where the histories of these names are, without those of a tendon, an obstacle or a whole rod."""
        points = {history["name"]: history["at"] for history in self.tree.get("history", [])}
        nowhere = {*self.tree.get("tendon", {}), *self.tree.get("obstacle", {}), *self.rods}
        return [self.place(points[name])[0] for name in sorted(names) if points[name] not in nowhere]

    def gravity(self):
        return self.largest(self.tree.get("gravity", [0, 0, 0]))[0]


def held_components(fix):
    words = [fix] if isinstance(fix, str) else fix
    meaning = {"all": ("x", "y", "z", *FREE_AXES), "position": ("x", "y", "z"), "rotation": FREE_AXES}
    return {component for word in words for component in meaning.get(word, (word,))}
