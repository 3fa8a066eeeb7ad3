#!/usr/bin/env python3
"""Writes the deck of a pile of rods that fall into a box: make_pile.py [RODS [ELEMENTS [ABOVE]]] > pile.toml

Ten rods side by side in each layer, layers turned against each other, ABOVE (in m) over the one below."""

import math
import random
import sys

RADIUS, LENGTH, HALF_BOX = 5e-3, 0.5, 0.3
PER_LAYER, BESIDE = 10, 0.03

HEAD = """# Rods of rubber fall into a box and come to rest in a pile. Written by make_pile.py.
gravity = [0, 0, -9.81]

[section.rubber]
shape    = { circle = { radius = 5e-3 } }
material = { E = 1e7, nu = 0.5, density = 1100 }
damping  = { mass_proportional = 1 }

[contact]
friction = 0.3

[obstacle]
floor = { plane = { point = [0, 0, 0], normal = [0, 0, 1] } }
left  = { plane = { point = [-0.3, 0, 0], normal = [1, 0, 0] } }
right = { plane = { point = [0.3, 0, 0], normal = [-1, 0, 0] } }
front = { plane = { point = [0, -0.3, 0], normal = [0, 1, 0] } }
back  = { plane = { point = [0, 0.3, 0], normal = [0, -1, 0] } }

[analysis]
kind      = "dynamic"
end_time  = 3
time_step = 1e-3

[output]
every = 10

[[history]]
name       = "floor"
at         = "floor"
quantities = ["contact_force", "least_gap"]

[rod]"""


def make_rods(count, above):
    play = above - 2 * RADIUS
    draw = random.Random(7)
    for layer in range((count + PER_LAYER - 1) // PER_LAYER):
        turned = draw.uniform(0, math.pi)
        for i in range(min(PER_LAYER, count - layer * PER_LAYER)):
            angle = turned + draw.uniform(-0.02, 0.02)
            along = (math.cos(angle), math.sin(angle), draw.uniform(-play / 2, play / 2))
            aside = BESIDE * (i - 0.5 * (PER_LAYER - 1))
            middle = (-aside * math.sin(angle), aside * math.cos(angle), 0.02 + above * (layer + 1) + draw.uniform(-play / 4, play / 4))
            yield tuple([m + sign * 0.5 * LENGTH * a for m, a in zip(middle, along)] for sign in (-1, 1))


def main():
    count, elements, above = [float(word) for word in sys.argv[1:]] + [30, 10, 0.03][len(sys.argv) - 1 :]
    print(HEAD)
    for number, ends in enumerate(make_rods(int(count), above), 1):
        start, end = ("[" + ", ".join(f"{x:.5f}" for x in end) + "]" for end in ends)
        print(f'r{number} = {{ section = "rubber", line = {{ from = {start}, to = {end} }}, elements = {int(elements)} }}')


main()
