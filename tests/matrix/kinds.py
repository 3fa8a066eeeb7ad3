"""Kinds of analyses, schemes and services, each with the tables of [analysis] or [[stage]] that ask for it."""

import re

SCHEMES = ("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "radau-5", "gauss-4",
           "energy-momentum", "runge-kutta-4")
END = 0.25  # of motions
STEPS = 25
EXPLICIT_STEPS = 400  # what stays stable
NEWTON = {"tolerance": 1e-10}


def static(steps=10, **entries):
    return {"kind": "static", "steps": steps, "newton": NEWTON, **entries}


def quasi_static(steps=20, **entries):
    return {"kind": "quasi-static", "end_time": 1.0, "steps": steps, "newton": NEWTON, **entries}


def path():
    return {"kind": "path", "until": {"t": 1, "steps": 300}, "newton": NEWTON}


def motion(scheme, steps=STEPS, **entries):
    table = {"kind": "dynamic", "end_time": END, "steps": steps, "integrator": scheme, **entries}
    return table if scheme == "runge-kutta-4" else table | {"newton": NEWTON}


def modes(kind="modes", count=6):
    return {"kind": kind, "count": count}


def response(omega=0.0):
    return {"kind": "response", "omega": {"values": [omega]}, "excite": [{"at": "beam.end", "force": [0, 0, 1]}]}


def named(*tables):
    """Tables of [[stage]], with names."""
    return [{"name": f"stage{number}", **table} for number, table in enumerate(tables)]


def with_analysis(deck, *tables):
    """A deck with the analysis asked for: one table, or stages."""
    deck = {key: value for key, value in deck.items() if value != []}
    if len(tables) == 1:
        return deck | {"analysis": tables[0]}
    return deck | {"stage": named(*tables)}


def scaled(deck, factor):
    return deck | {"parameters": deck["parameters"] | {"P": factor}}


def smooth(deck):
    """With everything that P multiplies growing smoothly from 0, so that steps resolve what it excites."""
    def ramped(value):
        if isinstance(value, str):
            return re.sub(r"\bP\b", "(P*rise(t))", value)
        if isinstance(value, dict):
            return {key: ramped(entry) for key, entry in value.items()}
        return [ramped(entry) for entry in value] if isinstance(value, list) else value
    rise = {"expression": f"t < {END} ? sin(pi*t/{2 * END})^2 : 1"}
    return ramped(deck) | {"parameters": deck["parameters"], "function": deck.get("function", {}) | {"rise": rise}}


def with_steady_frame(deck):
    return deck | {"gravity": ["0.3*P", 0, 0], "load": [], "rotation": {"axis": [1, 0, 0], "speed": 1.5}}


def turning_support():
    """The clamp, at rest in the frame of a steady stage, turned on by the motion after it."""
    return [{"at": "beam.start", "fix": "all", "stages": "stage0"},
            {"at": "beam.start", "fix": ["position", "ry", "rz"], "move": {"rx": "1.5*t"}, "stages": "stage1"}]
