"""What is decided of a deck so far: its scales, its points, and which of them hang together."""

import dataclasses

import numpy as np


@dataclasses.dataclass
class Scales:
    """Sizes in the deck's units; whatever else is drawn is of the order of these, times what is drawn."""

    is_static: bool
    length: float
    bending: float
    mass_per_length: float

    @property
    def period(self):
        """About that of a cantilever."""
        return self.length**2 * float(np.sqrt(self.mass_per_length / self.bending))

    @property
    def force(self):
        return self.bending / self.length**2

    @property
    def mass(self):
        return self.mass_per_length * self.length


@dataclasses.dataclass
class RodPlan:
    name: str
    section: object
    length: float
    elements: int
    order: int
    ends: tuple  # names of its points, the first one where it starts
    is_meshed: bool = False
    is_straight: bool = False


@dataclasses.dataclass
class Node:
    """A node that the deck can name: by any of `names`, the texts of points."""

    names: list
    position: object  # None where nobody needs to know
    part: int  # equal for all that hang together
    bodies: list = dataclasses.field(default_factory=list)
    held: set = dataclasses.field(default_factory=set)
    is_moved: bool = False
    has_velocity: bool = False

    @property
    def is_of_rod(self):
        return any(name not in self.bodies for name in self.names)


@dataclasses.dataclass
class Plan:
    deck: dict
    scales: Scales
    files: dict = dataclasses.field(default_factory=dict)  # texts next to the deck, by name
    sections: list = dataclasses.field(default_factory=list)
    rods: list = dataclasses.field(default_factory=list)
    nodes: list = dataclasses.field(default_factory=list)
    span: float = 1.0  # of t
    functions: list = dataclasses.field(default_factory=list)  # names of the deck's functions
    move_size: float = 0.0
    jumps: bool = False  # some load jumps, at t = 0 or later

    def parts(self):
        return sorted({node.part for node in self.nodes})

    def nodes_of(self, part):
        return [node for node in self.nodes if node.part == part]

    def joined(self, kept, other):
        """Makes one node of two."""
        for node in self.nodes:
            if node.part == other.part and node is not other:
                node.part = kept.part
        kept.names += other.names
        kept.bodies += other.bodies
        self.nodes.remove(other)

    def softest(self):
        """The smallest bending stiffness of the rods, or the scale if there are none."""
        return min([rod.section.bending for rod in self.rods], default=self.scales.bending)

    def extent(self):
        return sum(rod.length for rod in self.rods) or self.scales.length

    def weakest_force(self):
        return self.softest() / self.extent() ** 2
