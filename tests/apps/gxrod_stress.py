"""A deck with stresses that the tests of programs share."""

# A portal of boxes and a pipe, which has no strength; the last rod has a section of numbers, without stresses.
FRAME = """title = "A portal"
units = "m kg s"
[material.steel]
E = 2.1e11
nu = 0.3
density = 7850
yield_stress = 235e6
[layup.plate]
plies = [["steel", 0.01, 0]]
[section.post]
shape = { walls = { corners = [[-0.05, -0.1], [0.05, -0.1], [0.05, 0.1], [-0.05, 0.1]], closed = true, line = "right", layup = "plate" } }
[section.pipe]
shape = { tube = { outer_radius = 0.05, inner_radius = 0.04 } }
material = { E = 2.1e11, nu = 0.3, density = 7850 }
[section.given]
stiffness = { EA = 1e7, GAy = 4e6, GAz = 4e6, GJ = 1e4, EIy = 1e4, EIz = 1e4 }
inertia = { rhoA = 10, rhoIy = 0.1, rhoIz = 0.1 }
[rod.left]
section = "post"
line = { from = [0, 0, 0], to = [0, 0, 3] }
elements = 4
order = 2
[rod.right]
section = "pipe"
line = { from = [4, 0, 0], to = [4, 0, 3] }
elements = 4
order = 2
[rod.beam]
section = "post"
line = { from = [0, 0, 3], to = [4, 0, 3] }
elements = 6
order = 2
[rod.tie]
section = "given"
line = { from = [0, 0, 0], to = [4, 0, 3] }
elements = 2
[[connect]]
points = ["left.end", "beam.start"]
[[connect]]
points = ["right.end", "beam.end", "tie.end"]
[[connect]]
points = ["left.start", "tie.start"]
[[support]]
at = "left.start"
fix = "all"
[[support]]
at = "right.start"
fix = "all"
[[load]]
at = "beam@0.5"
force = ["2e4*sin(6*t)", "1.5e4*sin(4*t)", "-1.2e5*min(t, 1)"]
[analysis]
kind = "dynamic"
end_time = 1.0
time_step = 0.02
integrator = "generalized-alpha"
[output]
every = 5
stresses = "von-mises"
[[history]]
name = "corner"
at = "beam.start"
quantities = ["position"]
"""
