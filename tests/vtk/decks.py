"""Small decks whose results VTK is to show, with every kind of cell."""

RADIUS = 2.0  # of the arc
THIN, THICK = 0.05, 0.12  # of the sections
GRAVITY = -9.81
SPIN = 3.0  # of the free body about z

# An arc, a leg and a strut meet in one node; the leg is on a support.
FRAME = """title = "A frame with an arc"
[section.thin]
shape    = {{ circle = {{ radius = 0.05 }} }}
material = {{ E = 1e7, nu = 0.3, density = 1000 }}
[section.thick]
shape    = {{ circle = {{ radius = 0.12 }} }}
material = {{ E = 1e7, nu = 0.3, density = 1000 }}
[rod.arc]
section  = "thin"
arc      = {{ centre = [0, 0, 0], axis = [0, 0, 1], from = [2, 0, 0], angle = "pi/2" }}
elements = 3
order    = {order}
element  = "{element}"
[rod.leg]
section  = "thick"
line     = {{ from = [2, 0, -1], to = [2, 0, 0] }}
elements = 2
order    = {order}
element  = "{element}"
[rod.strut]
section  = "thin"
line     = {{ from = [2, 0, 0], to = [3, 0, 0] }}
elements = 1
order    = {order}
element  = "{element}"
[[connect]]
points = ["arc.start", "leg.end", "strut.start"]
[[support]]
at  = "leg.start"
fix = "all"
"""

MOVING = """[body.weight]
mass    = 2.0
inertia = [0.1, 0.2, 0.3]
at      = "strut.end"
[body.ball]
mass             = 1.0
inertia          = [0.4, 0.4, 0.4]
at               = [5, 5, 5]
angular_velocity = [0, 0, 3]
[analysis]
kind     = "dynamic"
end_time = 0.2
steps    = 20
[output]
every = 4
"""

STATIC = """[[load]]
at    = "arc.end"
force = [2, -1, 3]
[analysis]
kind  = "static"
steps = 4
"""


def moving_frame(order, element="objective"):
    """6 frames, at t = 0, 0.04 … 0.2; bodies at the strut's end and in free fall."""
    return f"gravity = [0, 0, {GRAVITY}]\n" + FRAME.format(order=order, element=element) + MOVING


def loaded_frame(order, element="objective"):
    """5 frames, at load factors 0, 0.25 … 1; no bodies."""
    return FRAME.format(order=order, element=element) + STATIC
