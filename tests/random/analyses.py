"""Random analyses, parameters and output."""

import numpy as np

IMPLICIT = ("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4")
KINEMATIC = ["position", "displacement", "rotation_vector", "quaternion", "orientation", "velocity",
             "angular_velocity", "acceleration"]
OF_RODS = ["force", "moment", "force_spatial", "moment_spatial", "strain", "curvature"]
REACTIONS = ["reaction_force", "reaction_moment"]
FREE = ["angular_velocity_material"]


def newton(draw, plan, scheme):
    settings = {}
    if draw.chance(0.5):
        settings["tolerance"] = float(draw.log_uniform(1e-12, 1e-5))
    if draw.chance(0.5):
        settings["max_iterations"] = draw.integer(5, 60)
    if draw.chance(0.5) or not settings:
        tangents = ["mixed", "consistent", "automatic"]
        if sum(rod.elements * rod.order for rod in plan.rods) < 12:
            tangents.append("difference")  # slow
        if scheme == "newmark-simplified" and not plan.rods:
            tangents += ["paper"] * 3
        settings["tangent"] = draw.pick(tangents)
    return settings


def stable_step(plan):
    """About what runge-kutta-4 bears: of rods by their fastest waves between neighbouring nodes."""
    fastest = [30.0 / plan.span]
    for rod in plan.rods:
        spacing = rod.length / rod.elements / (2.0 * rod.order**2)
        section = rod.section
        fastest.append(2.0 * np.sqrt(section.axial / section.mass) / spacing + np.sqrt(section.shear / section.rotary))
    return 2.8 / max(fastest)


def choose_scheme(draw, plan, analysis):
    scheme = draw.pick([*IMPLICIT, "runge-kutta-4"])
    if scheme != "newmark-simplified" or draw.chance(0.8):
        analysis["integrator"] = scheme
    if scheme.startswith("newmark") and draw.chance(0.3):
        analysis["beta"] = float(draw.pick([0.25, 0.3025, draw.uniform(0.15, 0.5)]))
        analysis["gamma"] = float(draw.pick([0.5, 0.6, draw.uniform(0.5, 1.0)]))
    if scheme == "generalized-alpha" and draw.chance(0.7):
        analysis["spectral_radius"] = float(draw.pick([0.0, 1.0, draw.uniform(0, 1)]))
    if scheme in IMPLICIT and draw.chance(0.4):
        analysis["newton"] = newton(draw, plan, scheme)
    return scheme


def adaptive(draw, plan, step):
    settings = {}
    if draw.chance(0.6):
        settings["tolerance"] = float(draw.log_uniform(1e-5, 1e-2))
    if draw.chance(0.4):
        settings["min_step"] = float(step * draw.log_uniform(1e-6, 1e-2))
    if draw.chance(0.4) or not settings:
        settings["max_step"] = float(step * draw.uniform(1.0, 10.0))
    return settings


def add_dynamic(draw, plan):
    """`span` of the plan is the end time."""
    steps = draw.integer(1, 20)
    analysis = {"kind": "dynamic"}
    scheme = choose_scheme(draw, plan, analysis)
    step = plan.span / steps
    if scheme == "runge-kutta-4" and plan.rods:
        step = stable_step(plan) * (draw.uniform(0.05, 0.5) if draw.chance(0.9) else draw.uniform(0.5, 10.0))
        plan.span = steps * step
    is_adaptive = scheme == "sdirk-4" and draw.chance(0.4)
    if is_adaptive:
        step, plan.span = 0.1 * step, 0.1 * plan.span  # stiff rods take very many steps
    analysis["end_time"] = float(plan.span)
    if draw.chance(0.5):
        analysis["steps"] = steps
    else:
        analysis["time_step"] = float(step * draw.pick([1.0, 1.0, draw.uniform(0.8, 1.2)]))
    if is_adaptive:
        analysis["adaptive"] = adaptive(draw, plan, step)
    return analysis


def add_static(draw, plan):
    analysis = {"kind": "static"}
    if draw.chance(0.8):
        analysis["steps"] = draw.integer(1, 12)
    if draw.chance(0.4):
        analysis["newton"] = newton(draw, plan, "static")
    return analysis


def add_analysis(draw, plan):
    analysis = add_static(draw, plan) if plan.scales.is_static else add_dynamic(draw, plan)
    if draw.chance(0.5):
        analysis["linear_solver"] = draw.pick(["auto", "chains", "klu", "umfpack"])
    plan.deck["analysis"] = analysis


def quantities(draw, node, name, is_relative):
    is_body = name in node.bodies
    known = list(KINEMATIC)
    known += ["centre_of_mass"] if is_body else []
    if not is_relative:
        known += FREE + ([] if is_body else OF_RODS) + (REACTIONS if node.held else [])
    return draw.pick(known) if draw.chance(0.4) else draw.some(known, 6)


def add_history(draw, plan, number):
    node = draw.pick(plan.nodes)
    at = draw.pick(node.names)
    history = {"name": f"h{number}", "at": at}
    named_rods = [rod for rod in plan.rods if not rod.is_meshed]
    if named_rods and draw.chance(0.25):
        # Between nodes, mostly.
        history["at"] = f"{draw.pick(named_rods).name}@{draw.uniform(0.0, 1.0):.3f}"
        history["quantities"] = draw.some(KINEMATIC + FREE + OF_RODS, 6)
        plan.deck.setdefault("history", []).append(history)
        return
    if draw.chance(0.3):
        history["relative_to"] = draw.pick(draw.pick(plan.nodes).names)
    history["quantities"] = quantities(draw, node, at, "relative_to" in history)
    plan.deck.setdefault("history", []).append(history)


def add_output(draw, plan):
    if draw.chance(0.5):
        plan.deck["output"] = {}
        if draw.chance(0.7):
            plan.deck["output"]["every"] = draw.integer(1, 8)
        if draw.chance(0.4) or not plan.deck["output"]:
            plan.deck["output"]["compression"] = draw.pick(["none", "deflate"])
    for number in range(draw.integer(0, 3)):
        add_history(draw, plan, number)
