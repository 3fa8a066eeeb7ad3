"""Random springs and bushings between the nodes of a deck, or to the ground. They come from a stream of their own, so that
decks are otherwise what they would be without."""

import numpy as np

from draw import Draw, floats

STREAM = 10**6  # added to the seed
COMPONENTS = ("x", "y", "z", "rx", "ry", "rz")


def add_springs(seed, index, plan):
    draw = Draw(seed + STREAM, index)
    nodes = [node for node in plan.nodes if node.position is not None]
    if not nodes or not draw.chance(0.15):
        return
    for number in range(draw.integer(1, 3)):
        if draw.chance(0.6):
            add_spring(draw, plan, nodes, f"k{number}")
        else:
            add_bushing(draw, plan, nodes, f"m{number}")


def pick_ends(draw, nodes):
    """Two nodes, or one and None for the ground."""
    if len(nodes) < 2 or draw.chance(0.4):
        ends = [draw.pick(nodes), None]
        return ends if draw.chance(0.5) else ends[::-1]
    return [nodes[i] for i in draw.random.permutation(len(nodes))[:2]]


def names_of(draw, ends):
    return ["ground" if node is None else draw.pick(node.names) for node in ends]


def stiffness_of(draw, plan):
    return float(plan.softest() / plan.scales.length**3 * draw.log_uniform(1e-3, 10.0))


def law_of(draw, stiffness, length, span):
    """A force by length and rate that asks for little at t = 0."""
    forms = ["{k!r}*(length - {l!r})", "{k!r}*max(length - {l!r}, 0)", "{k!r}*(length - {l!r})*(length/{l!r})^2",
             "{c!r}*rate", "length < {l!r} ? {k!r}*(length - {l!r}) + {c!r}*rate : 0"]
    return draw.pick(forms).format(k=stiffness, l=length, c=0.01 * stiffness * span)


def add_spring(draw, plan, nodes, name):
    size = plan.scales.length
    ends = pick_ends(draw, nodes)
    places = [draw.vector(size) if node is None else node.position for node in ends]
    keys = {"between": names_of(draw, ends)}
    for i, key in enumerate(("at_a", "at_b")):
        if ends[i] is None or draw.chance(0.3):
            places[i] = places[i] if ends[i] is None else places[i] + draw.vector(0.1 * size)
            keys[key] = floats(places[i])
    length = float(np.linalg.norm(places[1] - places[0]))
    if length < 0.05 * size:
        return
    stiffness = stiffness_of(draw, plan)
    if draw.chance(0.7):
        keys["stiffness"] = stiffness
        if draw.chance(0.3):
            keys["length"] = length * draw.uniform(0.8, 1.1)
    if draw.chance(0.4):
        keys["damping"] = 0.01 * stiffness * plan.span
    if draw.chance(0.3) or not keys.keys() & {"stiffness", "damping"}:
        keys["force"] = law_of(draw, stiffness, length, plan.span)
    plan.deck.setdefault("spring", {})[name] = keys
    add_history(draw, plan, name, ["elongation", "axial_force"])


def matrix_of(draw, diagonal):
    """A matrix whose entries are of the size of the components, positive definite."""
    factor = np.diag(np.sqrt(diagonal)) @ (np.eye(6) + 0.2 * draw.random.normal(size=(6, 6)))
    return [floats(row) for row in factor @ factor.T]


def add_resistance(draw, keys, key, diagonal):
    if draw.chance(0.3):
        keys[f"{key}_matrix"] = matrix_of(draw, diagonal)
        return
    some = draw.some(range(6), 6)
    keys[key] = {COMPONENTS[i]: float(diagonal[i]) for i in sorted(some)}


def add_bushing(draw, plan, nodes, name):
    size = plan.scales.length
    ends = pick_ends(draw, nodes)
    keys = {"between": names_of(draw, ends)}
    if None not in ends or draw.chance(0.3):
        middle = np.mean([node.position for node in ends if node is not None], axis=0)
        keys["at"] = floats(middle + draw.vector(0.1 * size))
    if draw.chance(0.3):
        keys["axes"] = [floats(row) for row in draw.rotation()]
    stiffness = stiffness_of(draw, plan)
    diagonal = np.array([stiffness * (size**2 if i > 2 else 1.0) * draw.log_uniform(0.1, 10.0) for i in range(6)])
    has_stiffness = draw.chance(0.8)
    if has_stiffness:
        add_resistance(draw, keys, "stiffness", diagonal)
    if draw.chance(0.4) or not has_stiffness:
        add_resistance(draw, keys, "damping", 0.01 * plan.span * diagonal)
    plan.deck.setdefault("bushing", {})[name] = keys
    add_history(draw, plan, name, ["displacement", "rotation_vector", "force", "moment", "force_spatial", "moment_spatial"])


def add_history(draw, plan, name, known):
    if draw.chance(0.5):
        plan.deck.setdefault("history", []).append({"name": f"of_{name}", "at": name, "quantities": draw.some(known, 6)})
