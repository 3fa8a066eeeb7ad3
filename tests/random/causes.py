"""Random supports, loads, gravity and initial velocities."""

import numpy as np

from draw import floats

DISPLACEMENTS = ("x", "y", "z")
ROTATIONS = ("rx", "ry", "rz")


def time_functions(draw, plan):
    """Names of functions of the deck, whose values are from -1 to 1 or so."""
    if not draw.chance(0.4):
        return []
    span = plan.span
    first = {"table": [[0.0, 0.0], [0.3 * span, draw.uniform(-1, 1)], [0.6 * span, draw.uniform(-1, 1)],
                       [span, 0.0]]} if draw.chance(0.5) else {
                           "expression": draw.pick([f"sin({draw.uniform(1, 10) / span!r}*t)", 0.5])}
    if "table" in first:
        choose_interpolation(first, plan)
    plan.deck["function"] = {"pulse": first}
    if draw.chance(0.3):
        plan.deck["function"]["twice"] = {"expression": "pulse(t)*pulse(0.5*t)"}
    return list(plan.deck["function"])


def choose_interpolation(function, plan):
    """How a table is interpolated, and whether a file holds it: by its values, so that nothing else is drawn otherwise."""
    rows = function["table"]
    number = int(1e6 * abs(rows[1][1]))
    if number % 4 != 0:
        function["interpolation"] = ["cubic", "linear", "monotone"][number % 4 - 1]
    if number // 4 % 3 == 0:
        plan.files["pulse.csv"] = "t,v\n" + "".join(f"{t!r},{value!r}\n" for t, value in function.pop("table"))
        function |= {"file": "pulse.csv", "columns": ["t", "v"]}


def functions_are_constant(plan):
    """Whether those of the deck have one value, so that a load by them is there at once."""
    return plan.deck["function"]["pulse"].get("expression") == 0.5


def of_time(draw, plan, size):
    """A number, or f(t) as large as it."""
    span = plan.span
    forms = ["{a!r}*t/{T!r}", "{a!r}*sin({w!r}*t)", "{a!r}*(1 - cos({w!r}*t))/2", "{a!r}*exp(-t/{T!r})",
             "t < {h!r} ? {a!r}*t/{h!r} : {a!r}", "{a!r}*min(t/{h!r}, 1)", "t > {h!r} ? {a!r} : 0"]
    forms += [f"{{a!r}}*{name}(t)" for name in plan.functions]
    if draw.chance(0.45):
        return float(size)
    form = draw.pick(forms)
    is_by_function = any(f"{name}(t)" in form for name in plan.functions)
    plan.jumps |= "exp" in form or ">" in form or (is_by_function and functions_are_constant(plan))
    return form.format(a=float(size), T=span, w=draw.uniform(0.5, 10.0) / span, h=draw.uniform(0.1, 0.9) * span)


def from_zero(draw, plan, size):
    """f(t) that is 0 at t = 0."""
    forms = ["{a!r}*t/{T!r}", "{a!r}*sin({w!r}*t)", "{a!r}*(1 - cos({w!r}*t))/2", "{a!r}*(t/{T!r})^2",
             "{a!r}*(3 - 2*t/{T!r})*(t/{T!r})^2"]
    if plan.scales.is_static and draw.chance(0.4):
        return float(size)
    return draw.pick(forms).format(a=float(size), T=plan.span, w=draw.uniform(0.5, 6.0) / plan.span)


def sparse(draw, size, make):
    """Three components, some of them 0."""
    components = [make(draw.uniform(-1, 1) * size) if draw.chance(0.6) else 0 for _ in range(3)]
    return components if any(component != 0 for component in components) else [0, 0, make(-size)]


def choose_held(draw):
    """Components that a support can hold: of the rotations none, two or all."""
    rotations = draw.weighted({"none": 3, "hinge": 1, "all": 4})
    displacements = draw.some(DISPLACEMENTS, 3) if draw.chance(0.3) else list(DISPLACEMENTS)
    if draw.chance(0.1):
        return set(ROTATIONS)
    held = set(displacements)
    if rotations == "all":
        held |= set(ROTATIONS)
    elif rotations == "hinge":
        held |= set(ROTATIONS) - {draw.pick(ROTATIONS)}
    return held


def words_of(draw, held):
    """As `fix` may list them."""
    words = set(held)
    for word, parts in (("all", DISPLACEMENTS + ROTATIONS), ("position", DISPLACEMENTS), ("rotation", ROTATIONS)):
        if words >= set(parts) and draw.chance(0.7):
            words = words - set(parts) | {word}
    words = sorted(words)
    return words[0] if len(words) == 1 and draw.chance(0.7) else words


def moves_of(draw, plan, held):
    moves = {}
    for component in sorted(held):
        if not draw.chance(0.5):
            continue
        # In dynamics a span may be shorter than waves take to pass on a turn.
        turns = [0.3, 1.0, np.pi, 2 * np.pi, 12 * np.pi] if plan.scales.is_static or draw.chance(0.2) else [0.01, 0.1]
        turn = draw.pick(turns) * draw.pick([1.0, draw.uniform(-1, 1)])
        size = turn if component in ROTATIONS else draw.uniform(-1, 1) * plan.move_size
        moves[component] = from_zero(draw, plan, size)
    has_turn = any(component in ROTATIONS for component in moves)
    if has_turn and not held >= set(ROTATIONS):
        moves = {key: value for key, value in moves.items() if key not in ROTATIONS}
    return moves


def add_support(draw, plan, node, held):
    support = {"at": draw.pick(node.names)}
    moves = moves_of(draw, plan, held) if draw.chance(0.25) else {}
    fixed = held - set(moves)
    if fixed:
        support["fix"] = words_of(draw, fixed)
    if moves:
        support["move"] = moves
        node.is_moved = True
    if draw.chance(0.2):
        support["axes"] = [floats(row) for row in draw.rotation()]
    plan.deck.setdefault("support", []).append(support)
    node.held |= held


def add_supports(draw, plan):
    """Statics want a node of each part that is held whole, or several that do so together, which is left to chance."""
    is_static = plan.scales.is_static
    for part in plan.parts():
        free = plan.nodes_of(part)
        count = draw.integer(1, 3) if is_static else draw.weighted({0: 3, 1: 4, 2: 2, 3: 1})
        for i in range(min(count, len(free))):
            node = free.pop(draw.integer(0, len(free) - 1))
            is_whole = is_static and i == 0 and draw.chance(0.95)
            add_support(draw, plan, node, set(DISPLACEMENTS + ROTATIONS) if is_whole else choose_held(draw))


def add_loads(draw, plan):
    force = plan.weakest_force() * draw.log_uniform(1e-3, 10.0)
    for _ in range(draw.weighted({0: 1, 1: 4, 2: 2, 3: 1})):
        if plan.rods and draw.chance(0.35):
            plan.deck.setdefault("load", []).append(line_load(draw, plan, force))
        else:
            plan.deck.setdefault("load", []).append(point_load(draw, plan, force))


def choose_frame(draw, load):
    if draw.chance(0.6):
        load["frame"] = draw.pick(["spatial", "follower", "body"])
    return load


def point_load(draw, plan, force):
    load = {"at": draw.pick(draw.pick(plan.nodes).names)}
    keys = draw.some(["force", "moment"], 2)
    for key in keys:
        size = force if key == "force" else force * plan.scales.length
        load[key] = sparse(draw, size, lambda value: of_time(draw, plan, value))
    return choose_frame(draw, load)


def line_load(draw, plan, force):
    rod = draw.pick(plan.rods)
    per_length = force / rod.length

    def of_place(size):
        if draw.chance(0.5):
            return of_time(draw, plan, size)
        forms = ["{a!r}*s/{L!r}", "{a!r}*sin(3*s/{L!r})", "{a!r}*s/{L!r}*sin({w!r}*t)", "s < {h!r} ? {a!r} : 0"]
        return draw.pick(forms).format(a=size, L=rod.length, w=draw.uniform(0.5, 10.0) / plan.span, h=0.5 * rod.length)

    load = {"on": rod.name}
    keys = draw.some(["force_per_length", "moment_per_length"], 2)
    for key in keys:
        size = per_length if key == "force_per_length" else 0.1 * per_length * plan.scales.length
        load[key] = sparse(draw, size, of_place)
    return choose_frame(draw, load)


def add_gravity(draw, plan):
    if draw.chance(0.4):
        mass = plan.scales.mass_per_length * plan.extent()
        size = plan.weakest_force() / mass * draw.log_uniform(1e-3, 10.0)
        plan.deck["gravity"] = sparse(draw, size, lambda value: of_time(draw, plan, value))


def add_body_velocities(draw, plan):
    """Of bodies with a free node of their own."""
    for node in plan.nodes:
        if node.is_of_rod or node.held or not draw.chance(0.6):
            continue
        keys = plan.deck["body"][node.bodies[0]]
        spin = floats(draw.direction() * draw.log_uniform(1e-2, 30.0) / plan.span)
        if draw.chance(0.3):
            entry = {"on": node.bodies[0], "velocity": floats(draw.vector(plan.scales.length / plan.span))}
            if draw.chance(0.5):
                entry["angular_velocity"] = spin
            plan.deck.setdefault("initial", []).append(entry)
            continue
        keys["velocity"] = floats(draw.vector(plan.scales.length / plan.span))
        keys[draw.pick(["angular_velocity", "angular_velocity_material"])] = spin


def add_rigid_motion(draw, plan, part):
    """Turns an unsupported part as a rigid body."""
    names = {text for node in plan.nodes_of(part) for text in node.names}
    spin = draw.vector(draw.log_uniform(1e-2, 3.0) / plan.span)
    a, b, c = map(float, spin)
    for rod in plan.rods:
        if any(end in names for end in rod.ends):
            plan.deck.setdefault("initial", []).append(
                {"on": rod.name, "velocity": [f"{b!r}*z - {c!r}*y", f"{c!r}*x - {a!r}*z", f"{a!r}*y - {b!r}*x"],
                 "angular_velocity": [a, b, c]})


def add_bending_motion(draw, plan, rod):
    """Starts a rod that is free but for its start, where its velocity is 0, with one that grows along it."""
    size = float(draw.log_uniform(1e-3, 1.0) * plan.scales.length / plan.span)
    plan.deck.setdefault("initial", []).append(
        {"on": rod.name, "velocity": [0, f"{size!r}*(s/{rod.length!r})^2", 0]})


def add_velocities(draw, plan):
    if plan.scales.is_static:
        return
    add_body_velocities(draw, plan)
    for part in plan.parts():
        nodes = plan.nodes_of(part)
        if not draw.chance(0.4) or any(node.bodies for node in nodes):
            continue
        held = [node for node in nodes if node.held]
        if not held:
            add_rigid_motion(draw, plan, part)
        elif len(plan.rods) == 1 and held == [nodes[0]] and not nodes[0].is_moved and plan.rods[0].is_straight:
            add_bending_motion(draw, plan, plan.rods[0])
