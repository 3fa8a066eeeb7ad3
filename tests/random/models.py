"""Random rods, how they hang together, and bodies on them or alone."""

import numpy as np

import centrelines
import meshes
from draw import floats
from plan import Node, RodPlan
from sections import add_section


def rod_keys(draw, line, fractions):
    """Keys of a rod other than its section and centreline."""
    pieces = line.pieces + len(fractions)
    keys = {"elements": pieces + draw.integer(0, 2)}
    if draw.chance(0.8):
        keys["order"] = draw.integer(1, 4)
    add_axes(draw, keys)
    return keys


def add_axes(draw, keys):
    if draw.chance(0.5):
        keys["element"] = draw.pick(["objective", "simo"])
    if draw.chance(0.4):
        keys["y_axis"] = floats(draw.direction() * draw.log_uniform(1e-3, 1e3))
    if draw.chance(0.2):
        keys["twist"] = float(draw.uniform(-0.9 * np.pi, 0.9 * np.pi))


def choose_section(draw, plan):
    """A section there is, or a new one."""
    if plan.sections and draw.chance(0.5):
        return draw.pick(plan.sections)
    section = add_section(draw, f"s{len(plan.sections)}", plan.scales, plan.deck)
    plan.sections.append(section)
    return section


def add_rod(draw, plan, line, fractions=None):
    """Writes a rod; returns its nodes that have names: start, end, and those at fractions."""
    if fractions is None:
        fractions = sorted({round(draw.uniform(0.05, 0.95), 2) for _ in range(draw.pick([0, 0, 0, 1, 2]))})
    name = f"r{len(plan.rods)}"
    section = choose_section(draw, plan)
    keys = {"section": section.name, **line.keys, **rod_keys(draw, line, fractions)}
    plan.deck.setdefault("rod", {})[name] = keys
    part = len(plan.rods)
    plan.rods.append(RodPlan(name, section, line.length, keys["elements"], keys.get("order", 1),
                             (f"{name}.start", f"{name}.end"), is_straight=line.is_straight))
    at = {f"{name}.start": line.start, f"{name}.end": line.end}
    for fraction in fractions:
        at[f"{name}@{fraction}"] = line.start + fraction * (line.end - line.start) if line.is_straight else None
    nodes = [Node([text], position, part) for text, position in at.items()]
    plan.nodes += nodes
    return nodes


def connect(plan, kept, other):
    plan.deck.setdefault("connect", []).append({"points": [kept.names[0], other.names[0]]})
    plan.joined(kept, other)


def add_meshed_rod(draw, plan):
    name = f"r{len(plan.rods)}"
    file = f"{name}.msh"
    mesh = meshes.make_mesh(draw, file, draw.vector(plan.scales.length), plan.scales.length)
    plan.files[file] = mesh.text
    section = choose_section(draw, plan)
    keys = {"section": section.name, "mesh": {"file": file, "group": mesh.group}}
    add_axes(draw, keys)
    if not mesh.has_ends:
        keys.pop("y_axis", None)  # it may be parallel to one of the lines
    plan.deck.setdefault("rod", {})[name] = keys
    part = len(plan.rods)
    ends = tuple(f"{name}.{point}" for point in mesh.points)
    plan.rods.append(RodPlan(name, section, mesh.length, mesh.elements, mesh.order, ends, is_meshed=True))
    plan.nodes += [Node([end], None, part) for end in ends]


def add_tree(draw, plan, count):
    """Rods that each begin where an earlier one has a node; some close loops."""
    add_rod(draw, plan, centrelines.centreline(draw, draw.vector(plan.scales.length), plan.scales.length))
    for _ in range(count - 1):
        known = [node for node in plan.nodes if node.position is not None]
        root = draw.pick(known)
        far = [node for node in known if node.part == root.part and
               np.linalg.norm(node.position - root.position) > 0.1 * plan.scales.length]
        if far and draw.chance(0.3):
            goal = draw.pick(far)
            start, end, *_ = add_rod(draw, plan, centrelines.straight(draw, root.position, goal.position))
            connect(plan, root, start)
            connect(plan, goal, end)
            continue
        length = plan.scales.length * draw.log_uniform(0.2, 2.0)
        start, *_ = add_rod(draw, plan, centrelines.centreline(draw, root.position, length))
        if draw.chance(0.9):
            connect(plan, root, start)


def add_ring(draw, plan):
    """A rod that comes back to its start."""
    axis, start = draw.direction(), draw.vector(plan.scales.length)
    radius = plan.scales.length / 2 / np.pi
    centre = start - radius * centrelines.across(draw, axis)
    line = centrelines.Centreline(
        {"arc": {"centre": floats(centre), "axis": floats(axis), "from": floats(start),
                 "angle": "2*pi"}}, start, start, plan.scales.length, pieces=3)
    first, last, *_ = add_rod(draw, plan, line)
    connect(plan, first, last)


def add_grid(draw, plan):
    """Rods along x and rods along y, joined where they cross."""
    rows, columns, size = draw.integer(1, 3), draw.integer(2, 3), plan.scales.length
    origin = draw.vector(size)
    across = [(i + 1) / (columns + 1) for i in range(columns)]
    along = [(i + 1) / (rows + 1) for i in range(rows)]
    lines = []
    for y in along:
        start = origin + np.array([0.0, y * size, 0.0])
        lines.append(add_rod(draw, plan, centrelines.straight(draw, start, start + np.array([size, 0, 0])), across))
    for i, x in enumerate(across):
        start = origin + np.array([x * size, 0.0, 0.0])
        column = add_rod(draw, plan, centrelines.straight(draw, start, start + np.array([0, size, 0])), along)
        for row, node in zip(lines, column[2:]):
            connect(plan, row[2 + i], node)


def inertia_of(draw, mass, radius):
    """Principal moments of a body, or the matrix in other axes."""
    a, b, c = (mass * radius**2 * draw.log_uniform(0.1, 1.0) for _ in range(3))
    principal = np.array([b + c, c + a, a + b])
    if draw.chance(0.6):
        return floats(principal)
    axes = draw.rotation()
    matrix = axes @ np.diag(principal) @ axes.T
    return [floats(row) for row in (matrix + matrix.T) / 2]


def add_body(draw, plan, node=None):
    """A body on a node, or with one of its own."""
    name = f"b{len(plan.deck.get('body', {}))}"
    size = plan.scales.length * draw.log_uniform(0.01, 0.3)
    mass = plan.scales.mass * (draw.log_uniform(1e-6, 1e6) if draw.chance(0.2) else draw.log_uniform(0.01, 10.0))
    keys = {"mass": float(mass)}
    if node is None or draw.chance(0.7):
        keys["inertia"] = inertia_of(draw, mass, size)
    if draw.chance(0.5):
        keys["centre_of_mass"] = floats(draw.vector(size))
    if draw.chance(0.5):
        angle = draw.pick([draw.uniform(0, np.pi), np.pi, 2 * np.pi, draw.uniform(0, 20.0)])
        keys["rotation_vector"] = floats(angle * draw.direction())
    if node is None:
        position = draw.vector(plan.scales.length)
        if draw.chance(0.8):
            keys["at"] = floats(position)
        else:
            position = np.zeros(3)
        node = Node([], position, 1000 + len(plan.nodes))
        plan.nodes.append(node)
    else:
        keys["at"] = draw.pick([text for text in node.names if text not in node.bodies])
    node.names.append(name)
    node.bodies.append(name)
    plan.deck.setdefault("body", {})[name] = keys


KINDS = {"rod": 5, "tree": 5, "ring": 1, "grid": 1, "mesh": 0.6, "bodies": 3}


def add_model(draw, plan):
    kind = draw.weighted(KINDS)
    if kind == "bodies" and plan.scales.is_static:
        kind = "rod"
    if kind == "bodies":
        for _ in range(draw.integer(1, 3)):
            add_body(draw, plan)
        return
    if kind in ("rod", "tree"):
        add_tree(draw, plan, 1 if kind == "rod" else draw.integer(2, 4))
    else:
        {"ring": add_ring, "grid": add_grid, "mesh": add_meshed_rod}[kind](draw, plan)
    if draw.chance(0.3):
        for _ in range(draw.integer(1, 2)):
            add_body(draw, plan, draw.pick([node for node in plan.nodes if node.is_of_rod]))
    if draw.chance(0.05):
        add_body(draw, plan)
