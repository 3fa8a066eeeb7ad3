"""Derivatives by numbers of a deck."""

import math
import pickle

import numpy as np
import pytest
from conftest import SWING

import gxrod

if not gxrod._has_core():
    pytest.skip("gxrod has no compiled part here: it is built with -DGXROD_PYTHON_MODULE=ON", allow_module_level=True)

from gxrod.variations import change, find_number  # noqa: E402 — after it is known to be there

BEND = """gravity = [0, 0, -9.81]
[parameters]
F = 3.0
L = 2.0
EI = 6.0
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
inertia = { rhoA = 0.1, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = ["L", 0, 0] }
elements = 4
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, 1, "F*t"]
moment = [0.5, 0, "F/4"]
frame = "follower"
[analysis]
kind = "static"
steps = 4
newton = { tolerance = 1e-12 }
[[history]]
name = "tip"
at = "r.end"
quantities = ["displacement", "rotation_vector"]
[[history]]
name = "middle"
at = "r@0.4"
quantities = ["moment", "force"]
[[history]]
name = "root"
at = "r.start"
quantities = ["reaction_force", "reaction_moment"]
"""


@pytest.fixture
def deck():
    return gxrod.Deck.from_text(SWING)


@pytest.fixture
def model(deck):
    return deck.build()


@pytest.fixture
def sim(model):
    with gxrod.Simulation(model) as simulation:
        yield simulation


@pytest.mark.parametrize("kind", ["static", "dynamic"])
def test_derivatives_are_those_of_whole_runs(kind):
    text = SWING if kind == "dynamic" else SWING.replace('kind = "dynamic"\nend_time = 0.5\ntime_step = 0.02', 'kind = "static"')
    text = text.replace("[[history]]", "newton = { tolerance = 1e-12 }\n[[history]]", 1).replace("value = 0", "value = 1.5")
    deck = gxrod.Deck.from_text(text)
    for row in gxrod.check_gradient(deck, ["EI", "section.s.inertia.rhoA"], "tip.position"):
        assert row["distance"] < 1e-7, row
    [row] = gxrod.check_gradient(deck, ["EI"], "root.moment")
    assert row["distance"] < 1e-7


def test_runs_with_other_steps_are_not_compared(deck):
    """A step that is a number of the deck changes how many there are."""
    with pytest.warns(UserWarning, match="other steps"):
        gxrod.check_gradient(deck, "analysis.time_step", "tip.position", step=0.1)


def test_derivatives_need_a_name_that_is_there(sim, deck, model):
    with pytest.raises(gxrod.UnknownNameError):
        sim["tip"].derivative("EI")
    with pytest.raises(gxrod.UnknownNameError, match="EI"):
        gxrod.Simulation(model, sensitivities=["EJ"])
    with pytest.raises(gxrod.Error, match="not a number"):
        gxrod.Simulation(model, sensitivities=["section.s.stiffness.EIy"])
    carried = gxrod.Simulation(model, sensitivities=["EI"])
    carried.step()
    assert carried["tip"].derivative("EI").position.shape == (3,)
    carried.restore(pickle.loads(pickle.dumps(carried.save())))
    with pytest.raises(gxrod.Error, match="as pickles are"):
        carried["tip"].derivative("EI").position


def test_derivatives_come_back_with_a_checkpoint(model):
    sim = gxrod.Simulation(model, sensitivities=["EI"])
    sim.advance(steps=3)
    point = sim.save()
    sim.advance(steps=3)
    last = sim["tip"].derivative("EI").position
    sim.restore(point)
    sim.advance(steps=3)
    assert np.array_equal(sim["tip"].derivative("EI").position, last)


@pytest.mark.parametrize("overrides, value", [({}, 0.0), ({"load[0].moment": [0, "tendon", 4]}, 4.0), ({"load[0].moment[2]": np.int64(3)}, 3.0),
                                              ({"load[0].moment[2]": 3, "load[0].moment": np.array([0, 1, 2])}, 2.0)])
def test_derivatives_are_about_the_value_that_counts(deck, overrides, value):
    model = deck.build(overrides)
    assert find_number(model, "load[0].moment[2]", "moment") == value
    assert find_number(change(model, "load[0].moment[2]", value + 0.5), "load[0].moment[2]", "moment") == value + 0.5
    [row] = gxrod.check_gradient(model, "load[0].moment[2]", "tip.position")
    assert row["parameter"] == "load[0].moment[2]" and np.abs(row["derivative"]).max() > 1e-3 and row["distance"] < 1e-6


# Of stresses.


STRESSED = BEND.replace('stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }', 'SHAPE').replace(
    "inertia = { rhoA = 0.1, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }\n", "").replace("EI = 6.0", "R = 0.05").replace(
    'quantities = ["reaction_force", "reaction_moment"]', 'quantities = ["von_mises"]\n[[history]]\nname = "side"\nat = "r@0.3"\n'
    'point = [0.02, 0.03]\nquantities = ["stress", "principal_stress"]')


@pytest.mark.parametrize("shape", ['circle = { radius = "R" }', 'rectangle = { width_y = 0.08, height_z = "2*R" }'])
def test_stresses_have_derivatives(shape):
    material = "material = { E = 1e6, nu = 0.3, density = 10 }"
    deck = gxrod.Deck.from_text(STRESSED.replace("SHAPE", f"shape = {{ {shape} }}\n{material}"))
    for quantity in ("root.von_mises", "side.stress", "side.principal_stress"):
        for row in gxrod.check_gradient(deck, ["F", "R", "L"], quantity):
            assert np.abs(row["derivative"]).max() > 1 and row["distance"] < 2e-6, row


# Of reactions, and of motions.


def test_reactions_have_derivatives():
    """A dead force at the end changes the reaction by its opposite."""
    deck = gxrod.Deck.from_text(BEND.replace('frame = "follower"', "").replace('moment = [0.5, 0, "F/4"]', "").replace("gravity", "# gravity"))
    sim = gxrod.Simulation(deck, sensitivities=["F"])
    sim.run()
    by_force = sim["root"].derivative("F")
    assert by_force.reaction_force == pytest.approx([0, 0, -1], abs=1e-9)
    arm, moved = np.array([2, 0, 0]) + sim["tip"].displacement, sim["tip"].derivative("F").displacement
    force = np.array([0, 1, 3.0])
    assert by_force.reaction_moment == pytest.approx(-np.cross(arm, [0, 0, 1]) - np.cross(moved, force), abs=1e-8)


@pytest.mark.parametrize("integrator", ["newmark-simplified", "generalized-alpha", "sdirk-4"])
def test_reactions_of_motions_have_derivatives(deck, integrator):
    changes = {"analysis.integrator": integrator, "analysis.newton": {"tolerance": 1e-12}, "history[1].quantities": ["reaction_force", "reaction_moment"]}
    for quantity in ("root.reaction_force", "root.reaction_moment", "tip.position"):
        (row,) = gxrod.check_gradient(deck.build(changes), ["EI"], quantity, step=1e-2)
        assert row["distance"] < 1e-6, (quantity, row)


# Of what has a history.

TWISTED = """[parameters]
GJ = 4.0
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = "GJ", EIy = 6, EIz = 7 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
element = "simo"
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, 1, 2]
moment = [0.5, 0, 1]
[analysis]
kind = "static"
steps = 1
newton = { tolerance = 1e-12 }
[[history]]
name = "quarter"
at = "r@0.25"
quantities = ["force", "moment", "strain", "curvature"]
[[history]]
name = "root"
at = "r.start"
quantities = ["reaction_force", "reaction_moment"]
"""


@pytest.mark.parametrize("steps", [1, 4])
def test_simo_elements_have_derivatives_away_from_their_middles(steps):
    """They were off by 4 % in one load step and by 1 % in four."""
    deck = gxrod.Deck.from_text(TWISTED.replace("steps = 1", f"steps = {steps}"))
    for quantity in ("quarter.moment", "quarter.curvature", "root.reaction_moment"):
        [row] = gxrod.check_gradient(deck, ["GJ"], quantity, step=2e-3)
        assert row["distance"] < 1e-6, (quantity, row)


def test_derivatives_of_sections_come_back_with_a_checkpoint():
    sim = gxrod.Simulation(gxrod.Deck.from_text(TWISTED.replace("steps = 1", "steps = 4")), sensitivities=["GJ"])
    sim.advance(steps=2)
    point, then = sim.save(), sim["quarter"].derivative("GJ").moment
    sim.advance(steps=2)
    assert not np.array_equal(sim["quarter"].derivative("GJ").moment, then)
    sim.restore(point)
    assert np.array_equal(sim["quarter"].derivative("GJ").moment, then)


def test_where_something_opens_there_is_no_derivative():
    """A load that begins at the end of the last step has a derivative by when it does on one side only."""
    text = TWISTED.replace("GJ = 4.0", "GJ = 4.0\nbegin = 0.75").replace("force = [0, 1, 2]", 'force = [0, 1, "2*max(t - begin, 0)"]')
    sim = gxrod.Simulation(gxrod.Deck.from_text(text.replace("steps = 1", "steps = 4")), sensitivities=["begin"])
    sim.advance(steps=2)
    assert np.array_equal(sim["quarter"].derivative("begin").moment, [0, 0, 0])
    sim.run()
    with pytest.raises(gxrod.Error, match="the derivative of history quarter by begin: it does not exist from t = 0.75 on"):
        sim["quarter"].derivative("begin").moment


# By multipliers.


def test_the_adjoint_is_what_is_carried_along():
    names = ["F", "L", "EI"]
    deck = gxrod.Deck.from_text(BEND)
    sim = gxrod.Simulation(deck, sensitivities=names)
    sim.run()
    weights = {"tip.displacement": [0.3, -1, 2], "tip.rotation_vector": [1, 0, -1], "middle.moment": [0, 2, 1]}
    expected = [sum(np.dot(weight, sim[key.split(".")[0]].derivative(name)[key.split(".")[1]]) for key, weight in weights.items()) for name in names]
    assert gxrod.Simulation.adjoint(sim, weights, names) == pytest.approx(expected, rel=1e-9)
    assert sim.adjoint({"tip.displacement": [0, 0, 1]}, "F").shape == (1,)


@pytest.mark.parametrize("old, new", [("[rod.r]", "law = { plastic = { yield = { My = 0.5 }, kinematic = 0.4 } }\n[rod.r]"),
                                      ("elements = 4", 'elements = 4\nelement = "simo"')])
def test_the_adjoint_of_an_equilibrium_goes_back_through_what_remembers(old, new):
    deck, weights = gxrod.Deck.from_text(BEND.replace(old, new)), [0.3, -1, 2]

    def difference(name, value, part):
        """Of whole runs, to the fourth order."""
        def run(amount):
            sim = gxrod.Simulation(deck.build({f"parameters.{name}": value * (1 + amount * part)}))
            sim.run()
            return np.dot(weights, sim["tip"].displacement)
        return (8 * (run(1) - run(-1)) - (run(2) - run(-2))) / (12 * part * value)

    sim = gxrod.Simulation(deck)
    sim.run()
    expected = [difference("F", 3.0, 5e-4), difference("EI", 6.0, 5e-4)]
    assert sim.adjoint({"tip.displacement": weights}, ["F", "EI"]) == pytest.approx(expected, rel=1e-9)


def test_the_adjoint_says_what_it_needs():
    bend = gxrod.Simulation(gxrod.Deck.from_text(BEND))
    bend.run()
    with pytest.raises(gxrod.Error, match="3 numbers, and 2 weights"):
        bend.adjoint({"tip.displacement": [0, 1]}, ["EI"])
    with pytest.raises(gxrod.Error, match="reactions"):
        bend.adjoint({"root.reaction_force": [0, 0, 1]}, ["EI"])
    with pytest.raises(gxrod.UnknownNameError):
        bend.adjoint({"tip.displacement": [0, 0, 1]}, ["EJ"])
    with pytest.raises(gxrod.UnknownNameError):
        bend.adjoint({"tip.place": [0, 0, 1]}, ["EI"])
    with pytest.raises(gxrod.UnknownNameError):
        bend.adjoint({"tip.displacement": [0, 0, 1]}, inputs=["tendon"])


def swing(record=None, **changes):
    """A run in which an input is set in each step, as a controller does."""
    sim = gxrod.Simulation(gxrod.Deck.from_text(SWING).build(changes), sensitivities=record or ())
    while not sim.finished:
        sim.inputs["tendon"] = 1 + math.sin(9 * sim.time)
        sim.step()
    return sim


def test_the_adjoint_of_a_motion_is_what_is_carried_along():
    names = ["EI", "section.s.inertia.rhoA"]
    sim = swing(names)
    weights = {"tip.position": [0.3, -1, 2], "root.moment": [0, 0.2, 0.1]}
    expected = [sum(np.dot(weight, sim[key.split(".")[0]].derivative(name)[key.split(".")[1]]) for key, weight in weights.items()) for name in names]
    assert sim.adjoint(weights, names) == pytest.approx(expected, rel=1e-9)
    before = sim.records["tip"].position, sim.time
    sim.adjoint(weights, names)
    assert np.array_equal(before[0], sim.records["tip"].position) and before[1] == sim.time


def test_the_adjoint_of_a_sum_over_a_motion_is_that_of_differences():
    sim = swing()
    weights = np.sin(np.arange(3 * len(sim.records.time))).reshape(-1, 3)

    def find_sum(value):
        return np.sum(weights * swing(**{"parameters.EI": value}).records["tip"].position)

    h = 1e-2
    near, far = ((find_sum(6 + step) - find_sum(6 - step)) / (2 * step) for step in (h, 2 * h))
    assert sim.adjoint({"tip.position": weights}, "EI") == pytest.approx([(4 * near - far) / 3], rel=1e-7)


@pytest.mark.parametrize("hold", ["step", "linear"])
def test_the_adjoint_by_all_values_of_an_input_is_that_of_differences(hold):
    deck = gxrod.Deck.from_text(SWING.replace("value = 0", f'value = 0\nhold = "{hold}"'))

    def run(values):
        sim = gxrod.Simulation(deck)
        for value in values:
            sim.inputs["tendon"] = value
            sim.step()
        return sim

    values = 1 + np.sin(np.arange(25))
    sim = run(values)
    none, by_inputs = sim.adjoint({"tip.position": [0.3, -1, 2]}, inputs="tendon")
    assert none.shape == (0,) and by_inputs.shape == (26, 1)
    for step in (0, 11, 24):
        change = 1e-3 * (np.arange(25) == step)
        difference = (run(values + change)["tip"].position - run(values - change)["tip"].position) / 2e-3
        assert by_inputs[step + 1, 0] == pytest.approx(np.dot([0.3, -1, 2], difference), rel=1e-6)


def test_the_adjoint_knows_a_return_to_another_run():
    one, other = swing(), gxrod.Simulation(gxrod.Deck.from_text(SWING))
    other.advance(steps=4)
    other.restore(one.save())
    with pytest.raises(gxrod.Error, match="cannot be repeated"):
        other.adjoint({"tip.position": [0, 0, 1]}, ["EI"])


# Of all stages.

STAGES = """gravity = [0, 0, -9.81]
[parameters]
EI = 6.0
F = 3.0
hang = 0.4
rho = 1.0
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
inertia = { rhoA = "rho", rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
damping = { kelvin_voigt = 0.02 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
element = "ELEMENT"
[body.b]
mass = "hang"
inertia = [0.1, 0.2, 0.2]
at = [2, 0, 0]
[joint.pin]
type = "hinge"
between = ["r.end", "b"]
axis = [0, 1, 0]
spring = { stiffness = 3 }
[[support]]
at = "r.start"
fix = "all"
[[stage]]
name = "bend"
kind = "static"
steps = 3
newton = { tolerance = 1e-12 }
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 0.2
time_step = 0.02
integrator = "INTEGRATOR"
newton = { tolerance = 1e-12 }
[[stage]]
name = "on"
kind = "dynamic"
end_time = 0.1
time_step = 0.02
newton = { tolerance = 1e-12 }
[[load]]
at = "r.end"
force = [0, "F", 0]
[[load]]
at = "r.end"
force = [0, 0, "F"]
factor = { on = "sin(9*t)" }
[[support]]
at = "r@0.5"
fix = "z"
stages = ["bend"]
[[history]]
name = "tip"
at = "r.end"
quantities = ["position", "velocity", "moment"]
"""


@pytest.mark.parametrize("element", ["objective", "simo"])
@pytest.mark.parametrize("integrator", ["newmark-simplified", "generalized-alpha", "sdirk-4", "radau-5"])
def test_derivatives_go_through_all_stages(element, integrator):
    deck = gxrod.Deck.from_text(STAGES.replace("ELEMENT", element).replace("INTEGRATOR", integrator))
    for quantity in ("tip.position", "tip.velocity"):
        for row in gxrod.check_gradient(deck, ["EI", "F", "hang", "rho"], quantity, step=2e-3):
            assert row["distance"] < 1e-7, (quantity, row)


# Of contact.

BALL = """gravity = [0, 0, -9.81]
[parameters]
v = 0.7
obstacle = 0.3
[body.ball]
mass = 0.5
inertia = [5e-4, 5e-4, 5e-4]
at = [0.05, 0, 0.4]
sphere = { radius = 0.05, force = 40 }
[obstacle.o]
sphere = { centre = [0, 0, 0], radius = "obstacle" }
[spring.s]
between = ["ground", "ball"]
at_a = [0, 0, 0.9]
stiffness = 30
damping = 2
[contact]
[[initial]]
on = "ball"
velocity = ["v", 0.1, -1]
[analysis]
kind = "dynamic"
end_time = 0.12
time_step = 0.002
newton = { tolerance = 1e-13 }
[[history]]
name = "tip"
at = "ball"
quantities = ["position", "velocity"]
"""


@pytest.mark.parametrize("integrator, damping, by_speed, by_obstacle", [
    ("newmark-simplified", 0, 3e-4, 1e-5), ("newmark-ibrahimbegovic", 0, 3e-4, 1e-5), ("generalized-alpha", 1.4, 1e-4, None), ("sdirk-4", 0, 3e-4, 1e-5),
    ("radau-5", 0, 1e-4, 1e-5)])
def test_impacts_have_derivatives(integrator, damping, by_speed, by_obstacle):
    deck = gxrod.Deck.from_text(BALL).build({"analysis.integrator": integrator, "contact.damping": damping})
    for name, step in ("v", by_speed), ("obstacle", by_obstacle):
        if step is not None:
            [row] = gxrod.check_gradient(deck, [name], "tip.velocity", step=step)
            assert row["distance"] < 1e-6, row


def test_impacts_from_which_energy_is_taken_have_no_derivatives():
    sim = gxrod.Simulation(gxrod.Deck.from_text(BALL).build({"analysis.integrator": "generalized-alpha"}), sensitivities=["v"])
    sim.run()
    with pytest.raises(gxrod.Error, match="the derivative of history tip by v: it does not exist from t = 0.058 on, where energy was taken from velocities"):
        sim["tip"].derivative("v").position


CROSSING = """[parameters]
E = 1e6
x = 0.5
[section.rubber]
shape = { circle = { radius = 0.02 } }
material = { E = "E", nu = 0.3, density = 1000 }
damping = { kelvin_voigt = 0.001 }
[rod.lower]
section = "rubber"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 6
[rod.upper]
section = "rubber"
line = { from = ["x", -0.5, 0.06], to = ["x", 0.5, 0.06] }
elements = 6
[[support]]
at = "lower.start"
fix = "all"
[[support]]
at = "lower.end"
fix = "position"
[[initial]]
on = "upper"
velocity = [0, 0, -2]
[contact]
[analysis]
kind = "dynamic"
end_time = 0.06
time_step = 0.001
newton = { tolerance = 1e-12 }
[[history]]
name = "middle"
at = "upper@0.5"
quantities = ["position"]
[[history]]
name = "root"
at = "lower.start"
quantities = ["reaction_force"]
"""


def test_rods_that_hit_each_other_have_derivatives():
    deck = gxrod.Deck.from_text(CROSSING)
    for name, step in ("E", 1e-4), ("x", 3e-5):
        [row] = gxrod.check_gradient(deck, [name], "middle.position", step=step)
        assert row["distance"] < 1e-6, row


def test_what_contact_has_no_derivatives_of_is_said():
    with pytest.raises(gxrod.Error, match="friction between rods and bodies"):
        gxrod.Simulation(gxrod.Deck.from_text(CROSSING).build({"contact.friction": 0.2}), sensitivities=["E"])
    sim = gxrod.Simulation(gxrod.Deck.from_text(CROSSING), sensitivities=["E"])
    sim.step()
    with pytest.raises(gxrod.Error, match="reactions where contact is an impulse"):
        sim["root"].derivative("E").reaction_force


LYING = """gravity = [0, 0, -9.81]
[parameters]
EI = 6
floor = -0.3
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
inertia = { rhoA = 1.2, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
radius = 0.1
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[support]]
at = "r.start"
fix = "all"
[obstacle.floor]
plane = { point = [0, 0, "floor"], normal = [0, 0, 1] }
[contact]
[analysis]
kind = "static"
steps = 20
newton = { tolerance = 1e-12 }
[[history]]
name = "floor"
at = "floor"
quantities = ["contact_force", "least_gap"]
[[history]]
name = "root"
at = "r.start"
quantities = ["reaction_force"]
"""


def test_forces_of_contact_have_derivatives():
    deck = gxrod.Deck.from_text(LYING)
    [row] = gxrod.check_gradient(deck, ["EI"], "floor.contact_force", step=3e-4)
    assert row["distance"] < 1e-8, row
    [row] = gxrod.check_gradient(deck, ["EI"], "floor.least_gap", step=3e-4)
    assert row["distance"] < 1e-6, row
    sim = gxrod.Simulation(deck, sensitivities=["EI", "floor"])
    sim.run()
    for name in ("EI", "floor"):  # what the floor no longer carries, the support does
        by = sim["root"].derivative(name).reaction_force, sim["floor"].derivative(name).contact_force
        assert by[0] == pytest.approx(by[1], abs=1e-5 * np.abs(by[1]).max())
