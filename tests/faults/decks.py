"""Decks whose runs are disturbed: small, and of every kind that a results file knows."""

import dataclasses
import pathlib

ROD = """title = "A hose that swings"
gravity = [0, 0, -9.81]
[section.s]
shape = {{ circle = {{ radius = 0.02 }} }}
material = {{ E = 1e7, nu = 0.5, density = 1000 }}
damping = {{ kelvin_voigt = 1e-3 }}
[rod.hose]
section = "s"
line = {{ from = [0, 0, 0], to = [3, 0, 0] }}
elements = {elements}
[[support]]
at = "hose.start"
fix = "all"
[analysis]
{analysis}
[output]
{output}
[[history]]
name = "tip"
at = "hose.end"
quantities = ["position", "moment", "acceleration"]
[[history]]
name = "middle"
at = "hose@0.43"
quantities = ["quaternion", "strain"]
"""

BODY = """title = "A body that spins"
[body.top]
mass = 2.0
inertia = [1.0, 1.0, 0.75]
at = [0, 0, 0]
angular_velocity = [0, 0, 3]
[[load]]
at = "top"
moment = ["0.5*sin(t)", 0, 0]
[analysis]
kind = "dynamic"
end_time = 6.0
steps = 600
[output]
every = 10
[[history]]
name = "spin"
at = "top"
quantities = ["angular_velocity", "position"]
"""


# Elements that remember, an integrator that remembers, and supports that move.
FRAME = """title = "A frame whose foot is shaken"
gravity = [0, 0, -9.81]
[section.s]
shape = { circle = { radius = 0.02 } }
material = { E = 1e8, nu = 0.5, density = 1000 }
damping = { kelvin_voigt = 1e-3, mass_proportional = 0.1 }
[rod.leg]
section = "s"
line = { from = [0, 0, 0], to = [0, 0, 1] }
elements = 4
order = 2
element = "simo"
[rod.beam]
section = "s"
line = { from = [0, 0, 1], to = [1, 0, 1] }
elements = 3
order = 3
element = "simo"
[[connect]]
points = ["leg.end", "beam.start"]
[body.weight]
mass = 0.2
inertia = [1e-3, 2e-3, 3e-3]
at = "beam.end"
centre_of_mass = [0.02, 0, 0]
[[support]]
at = "leg.start"
fix = ["y", "z", "rx", "ry"]
move = { x = "0.05*sin(20*t)", rz = "0.8*t" }
[[load]]
on = "beam"
force_per_length = [0, "sin(9*t)", 0]
frame = "follower"
[analysis]
kind = "dynamic"
integrator = "generalized-alpha"
spectral_radius = 0.8
end_time = 0.6
time_step = 0.01
[output]
every = 4
[[history]]
name = "weight"
at = "weight"
quantities = ["position", "quaternion", "velocity"]
[[history]]
name = "foot"
at = "leg.start"
quantities = ["reaction_force", "reaction_moment"]
"""

# From a mesh that branches.
NET = """gravity = [0, 0, -9.81]
[section.wire]
shape = { circle = { radius = 5e-3 } }
material = { E = 2.1e9, nu = 0.3, density = 7850 }
[rod.truss]
section = "wire"
mesh = { file = "truss.msh", group = "truss" }
[[support]]
at = "truss.left_foot"
fix = "all"
[analysis]
kind = "dynamic"
end_time = 0.06
time_step = 1e-3
[output]
every = 4
[[history]]
name = "foot"
at = "truss.right_foot"
quantities = ["position", "rotation_vector"]
"""
MESHES = pathlib.Path(__file__).resolve().parents[2] / "meshes"


def rod(elements, analysis, output="every = 4"):
    return ROD.format(elements=elements, analysis=analysis, output=output)


@dataclasses.dataclass(frozen=True)
class Deck:
    """What is run, and how: `tick` microseconds pass each time a run looks at its clock, so that it writes several
    times; `long` is a change of the deck that lets it take a second or so by a true clock."""
    name: str
    text: str
    tick: int
    long: tuple = ()
    threads: int = 1
    files: tuple = ()  # that it names: name and text
    later: tuple = ()  # changes with which a run that has ended is resumed


DYNAMIC = 'kind = "dynamic"\nend_time = 0.6\ntime_step = 0.01'

# Of so many elements that memory is what it lacks first.
LARGE = Deck("large", rod(20000, 'kind = "dynamic"\nend_time = 0.002\ntime_step = 0.001', "every = 1"), 20000)

DECKS = {deck.name: deck for deck in (
    Deck("body", BODY, 200, ("analysis.steps=80000",),
         later=("analysis.end_time=6.2", "analysis.steps=620")),
    Deck("rod", rod(12, DYNAMIC), 3000, ("analysis.time_step=0.0002",), later=("analysis.end_time=0.64",)),
    Deck("deflated", rod(12, DYNAMIC, 'every = 3\ncompression = "deflate"'), 3000, ("analysis.time_step=0.0004",),
         later=("analysis.end_time=0.66",)),
    Deck("adaptive", rod(6, 'kind = "dynamic"\nintegrator = "sdirk-4"\nend_time = 0.4\ntime_step = 0.005\n'
                            'adaptive = { tolerance = 1e-4, min_step = 1e-6, max_step = 0.1 }'), 2000,
         ("analysis.adaptive.tolerance=3e-11",), later=("analysis.end_time=0.5",)),
    Deck("static", rod(12, 'kind = "static"\nsteps = 60'), 3000, ("analysis.steps=3000",)),
    Deck("threads", rod(260, 'kind = "dynamic"\nend_time = 0.2\ntime_step = 0.01'), 1500, ("analysis.time_step=0.001",),
         threads=2, later=("analysis.end_time=0.24",)),
    Deck("frame", FRAME, 3000, ("analysis.time_step=0.0002",), later=("analysis.end_time=0.68",)),
    Deck("net", NET, 3000, ("analysis.time_step=1e-5",), files=(("truss.msh", (MESHES / "truss_2.2.msh").read_text()),),
         later=("analysis.end_time=0.07",)),
)}
