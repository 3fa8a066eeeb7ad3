"""Random scenes of contact: rods that fly at obstacles and each other, as decks made from a seed."""

import math
import random

STEP = 1e-3
STEPS = 40


def _direction(draw):
    z, turn = draw.uniform(-1, 1), draw.uniform(0, 2 * math.pi)
    across = math.sqrt(1 - z * z)
    return [across * math.cos(turn), across * math.sin(turn), z]


def _closest(p, q, a, b):
    """The distance of the segments pq and ab, by trying ends and the middle of the lines' nearest points."""
    def sub(u, v):
        return [x - y for x, y in zip(u, v)]

    def dot(u, v):
        return sum(x * y for x, y in zip(u, v))

    d1, d2, r = sub(q, p), sub(b, a), sub(p, a)
    aa, bb, ab, ar, br = dot(d1, d1), dot(d2, d2), dot(d1, d2), dot(d1, r), dot(d2, r)
    best = math.inf
    determinant = aa * bb - ab * ab
    tries = []
    if determinant > 1e-12 * aa * bb:
        tries.append(((ab * br - bb * ar) / determinant, (aa * br - ab * ar) / determinant))
    for s in (0.0, 1.0):
        tries.append((s, (br + s * ab) / bb))
    for t in (0.0, 1.0):
        tries.append(((t * ab - ar) / aa, t))
    for s, t in tries:
        s, t = min(max(s, 0.0), 1.0), min(max(t, 0.0), 1.0)
        best = min(best, math.dist([x + s * d for x, d in zip(p, d1)], [x + t * d for x, d in zip(a, d2)]))
    return best


def _vector(v):
    return "[" + ", ".join(f"{x:.9g}" for x in v) + "]"


class Scene:
    """rods: (start, end, velocity, elements); obstacles: ("plane", height), ("sphere", centre, radius) or ("cylinder", from, to, radius)."""

    def __init__(self, seed, scheme="newmark-simplified", time_step=STEP):
        draw = random.Random(seed)
        self.seed, self.scheme, self.time_step = seed, scheme, time_step
        self.radius = math.exp(draw.uniform(math.log(2e-3), math.log(1e-2)))
        self.modulus = math.exp(draw.uniform(math.log(1e6), math.log(1e10)))
        self.friction = draw.choice([0.0, 0.0, 0.3, 0.6])
        self.gravity = draw.choice([0.0, 9.81])
        # Radii a step.
        self.speed = math.exp(draw.uniform(math.log(0.1), math.log(100.0)))
        self.rods = []
        # So small a box that most meet before the end.
        self.room = min(max(20 * self.speed * self.radius, 0.1), 0.4)
        self.obstacles = self._draw_obstacles(draw)
        count = draw.choice([1, 2, 2, 2, 3, 3, 4, 4, 5, 6, 8, 10, 15, 30])
        for _ in range(40 * count):
            if len(self.rods) < count:
                self._try_rod(draw)

    def _draw_obstacles(self, draw):
        obstacles = []
        if draw.random() < 0.7:
            obstacles.append(("plane", -0.6 * self.room))
        for _ in range(draw.choice([0, 0, 1, 2])):
            centre = [draw.uniform(-0.5, 0.5) * self.room for _ in range(3)]
            if draw.random() < 0.5:
                obstacles.append(("sphere", centre, draw.uniform(0.02, 0.1)))
            else:
                axis = _direction(draw)
                ends = [[c + sign * 0.3 * a for c, a in zip(centre, axis)] for sign in (-1, 1)]
                obstacles.append(("cylinder", *ends, draw.uniform(0.01, 0.06)))
        return obstacles

    def _try_rod(self, draw):
        length = draw.uniform(0.1, 0.5)
        middle, along = [draw.uniform(-self.room, self.room) for _ in range(3)], _direction(draw)
        start, end = ([m + sign * 0.5 * length * a for m, a in zip(middle, along)] for sign in (-1, 1))
        clear = 2.1 * self.radius
        if any(_closest(start, end, other[0], other[1]) < clear for other in self.rods):
            return
        for obstacle in self.obstacles:
            if obstacle[0] == "plane" and min(start[2], end[2]) < obstacle[1] + clear:
                return
            if obstacle[0] == "sphere":
                centre, radius = obstacle[1], obstacle[2]
                if _closest(start, end, centre, [c + 1e-9 for c in centre]) < radius + clear:
                    return
            if obstacle[0] == "cylinder" and _closest(start, end, obstacle[1], obstacle[2]) < obstacle[3] + clear:
                return
        # Towards somewhere near the middle.
        aim = [draw.uniform(-0.25, 0.25) * self.room - m for m in middle]
        size = math.sqrt(sum(a * a for a in aim)) or 1.0
        speed = self.speed * self.radius / STEP * draw.uniform(0.2, 1.0)
        self.rods.append((start, end, [speed * a / size for a in aim], draw.randint(4, 12)))

    def deck(self):
        lines = [f'title = "Scene {self.seed}"', f"gravity = [0, 0, {-self.gravity}]", "[section.s]",
                 f"shape = {{ circle = {{ radius = {self.radius:.9g} }} }}",
                 f"material = {{ E = {self.modulus:.9g}, nu = 0.4, density = 1100 }}"]
        for number, (start, end, velocity, elements) in enumerate(self.rods):
            lines += [f"[rod.r{number}]", 'section = "s"', f"line = {{ from = {_vector(start)}, to = {_vector(end)} }}",
                      f"elements = {elements}", "order = 2", "[[initial]]", f'on = "r{number}"', f"velocity = {_vector(velocity)}"]
        for number, obstacle in enumerate(self.obstacles):
            lines.append(f"[obstacle.o{number}]")
            if obstacle[0] == "plane":
                lines.append(f"plane = {{ point = [0, 0, {obstacle[1]}], normal = [0, 0, 1] }}")
            elif obstacle[0] == "sphere":
                lines.append(f"sphere = {{ centre = {_vector(obstacle[1])}, radius = {obstacle[2]:.9g} }}")
            else:
                lines.append(f"cylinder = {{ from = {_vector(obstacle[1])}, to = {_vector(obstacle[2])}, radius = {obstacle[3]:.9g} }}")
        lines += ["[contact]", f"friction = {self.friction}", "[analysis]", 'kind = "dynamic"', f"end_time = {STEP * STEPS}",
                  f"time_step = {self.time_step}", f'integrator = "{self.scheme}"']
        return "\n".join(lines) + "\n"
