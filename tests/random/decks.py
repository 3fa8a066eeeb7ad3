"""Random decks: make_deck(seed, index) is a deck that a user might have written, and the meshes next to it."""

import causes
from analyses import add_analysis, add_output
from draw import Draw
from models import add_model
from plan import Plan, Scales
from springs import add_springs
from toml_text import toml_text


def draw_scales(draw):
    """Any units; usual ones are a model of metres, kilograms and seconds."""
    widest = draw.pick([1.0, 10.0, 1e3, 1e3, 1e6])

    def of_units():
        return draw.log_uniform(1.0 / widest, widest)

    length, mass_per_length = of_units(), of_units()
    return Scales(is_static=draw.chance(0.4), length=length, bending=of_units(), mass_per_length=mass_per_length)


def use_parameter(draw, deck):
    """Writes a number of the deck as a parameter, which another one may use."""
    name, key = draw.pick(list(deck["section"].items())) if "section" in deck else (None, None)
    if name is None or "stiffness" not in key:
        deck["parameters"] = {"unused": 1.0}
        return
    component = draw.pick(list(key["stiffness"]))
    deck["parameters"] = {"base": key["stiffness"][component], "other": "2*base"}
    key["stiffness"][component] = draw.pick(["base", "other/2", "max(base, 0)"])


def add_labels(draw, deck):
    if draw.chance(0.3):
        deck["title"] = draw.pick(["Random", "A \"quoted\" title", "Stäbe, drehend"])
    if draw.chance(0.2):
        deck["units"] = "m kg s"


def ordered(deck):
    """Values before tables, tables in an order that a deck may have."""
    keys = ["title", "units", "gravity", "parameters", "function", "section", "rod", "body", "spring", "bushing", "connect", "load",
            "support", "initial", "analysis", "output", "history"]
    return {key: deck[key] for key in keys if key in deck}


def make_plan(seed, index):
    draw = Draw(seed, index)
    scales = draw_scales(draw)
    plan = Plan({}, scales)
    add_labels(draw, plan.deck)
    add_model(draw, plan)
    if not scales.is_static:
        plan.span = scales.period * draw.log_uniform(1e-3, 3.0)
    add_analysis(draw, plan)
    plan.move_size = 0.1 * scales.length * draw.log_uniform(1e-3, 1.0)
    plan.functions = causes.time_functions(draw, plan)
    causes.add_supports(draw, plan)
    causes.add_gravity(draw, plan)
    causes.add_loads(draw, plan)
    causes.add_velocities(draw, plan)
    add_output(draw, plan)
    add_springs(seed, index, plan)
    if draw.chance(0.3):
        use_parameter(draw, plan.deck)
    plan.deck = draw.with_expressions(ordered(plan.deck))
    return plan


def make_deck(seed, index):
    """The deck as a dict, and the texts of files next to it by name."""
    plan = make_plan(seed, index)
    return plan.deck, plan.files


def write_deck(seed, index, folder):
    """Writes deck.toml and its meshes into a folder; returns the deck's path."""
    deck, files = make_deck(seed, index)
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    path = folder / "deck.toml"
    path.write_text(toml_text(deck), encoding="utf-8")
    return path
