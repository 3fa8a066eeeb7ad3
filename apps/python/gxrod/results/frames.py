"""The motion: values of all nodes and elements at the times for which the deck asked for frames; rods."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, overload

import numpy as np

from ..errors import UnknownNameError, unknown_name
from ..typed import Array, WholeArray
from .display import Shown, shape_text
from .records import Quantity
from .source import Source, plain, read_column

if TYPE_CHECKING:
    from .ranges import Range

NODES, ELEMENTS = "VTKHDF/PointData", "VTKHDF/CellData"
# Of rods, by what the file has of their elements: name, description, dimension, value.
DERIVED = {
    "effective_tension": ("force", "axial section force, in water the effective tension", "force", lambda values: values[..., 0]),
    "shear_force": ("force", "size of the shear force", "force", lambda values: np.linalg.norm(values[..., 1:], axis=-1)),
    "bending_moment": ("moment", "size of the bending moment", "force·length", lambda values: np.linalg.norm(values[..., 1:], axis=-1)),
    "bending_curvature": ("curvature", "size of the bending curvature", "angle/length", lambda values: np.linalg.norm(values[..., 1:], axis=-1)),
}
STILL = ("rod", "element", "arc_length", "section")  # have one row a node or element for all frames


class Fields(Shown):
    """Quantities of all nodes, or all elements, in one frame or several, as attributes and by name.

    Of one frame an array is [N,3] (numbers: [N]), of several ones [F,N,3]; `rod`, `element` and `arc_length` are the
    same in all frames, [N].
    """

    def __init__(self, source: Source, chosen: int | range, group: str) -> None:
        self._source, self._chosen, self._group = source, chosen, group

    @property
    def names(self) -> list[str]:
        """Names of the quantities."""
        return list(self._quantities)

    def describe(self, name: str) -> Quantity:
        """What a quantity is: a `Quantity` with description, frame, dimension, unit and shape."""
        if name not in self._quantities:
            raise unknown_name(f"quantity of {self._what}", name, self._quantities)
        return self._quantities[name]

    @property
    def _what(self):
        return "nodes" if self._group == NODES else "elements"

    @property
    def _rows_a_frame(self):
        return self._source.points if self._group == NODES else self._source.cells

    @property
    def _quantities(self):
        def read(file):
            datasets = {"position": file["VTKHDF/Points"]} if self._group == NODES else {}
            datasets.update(file[self._group])
            return {name: self._quantity(name, dataset) for name, dataset in datasets.items()}

        return self._source.once(("fields", self._group), read)

    def _quantity(self, name, dataset):
        text = lambda key: plain(dataset.attrs.get(key, ""))
        shape = (self._rows_a_frame, *dataset.shape[1:])
        return Quantity(name, text("description"), text("frame"), text("dimension"), self._source.unit(text("dimension")), shape)

    def _path(self, name):
        return "VTKHDF/Points" if name == "position" else f"{self._group}/{name}"

    def __getitem__(self, name: str) -> Array:
        self.describe(name)
        rows = self._rows_a_frame
        if name in STILL:
            return self._source.read(lambda file: file[self._path(name)][:rows])
        return self._source.read(lambda file: read_frames(file[self._path(name)], self._chosen, rows))

    def __contains__(self, name: object) -> bool:
        return name in self._quantities

    def __getattr__(self, name: str) -> Array:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._quantities]

    def _ipython_key_completions_(self):
        return self.names

    def _rows(self):
        return [(each.name, shape_text(each.shape), each.unit or each.dimension, each.frame, each.description)
                for each in self._quantities.values()]

    def _headline(self):
        return f"{self._rows_a_frame} {self._what}"


def read_frames(dataset, chosen, rows):
    """Of one frame [rows,…], of a range of them [F,rows,…]."""
    if isinstance(chosen, int):
        return dataset[chosen * rows : (chosen + 1) * rows]
    if len(chosen) == 0:
        return np.empty((0, rows, *dataset.shape[1:]))
    first, last = min(chosen[0], chosen[-1]), max(chosen[0], chosen[-1])
    block = dataset[first * rows : (last + 1) * rows]
    return block.reshape(last - first + 1, rows, *dataset.shape[1:])[np.array(chosen) - first]


class Frame(Fields):
    """All nodes at one time: `position`, `displacement`, `velocity`, `rotation_vector`, `axis_x` … [N,3], spatial."""

    def __init__(self, source: Source, number: int) -> None:
        super().__init__(source, number, NODES)
        self.number = number

    @property
    def time(self) -> float:
        """Its time; in statics its load factor."""
        return float(self._source.frame_times[self.number])

    @property
    def elements(self) -> Fields:
        """All elements: `force`, `moment`, `strain`, `curvature` [E,3], material, at their middles; zero for bodies, the last rows."""
        return Fields(self._source, self.number, ELEMENTS)

    def _headline(self):
        return f"frame {self.number}, {self._source.time_name} {self.time:g}: {self._source.points} nodes"


class Frames(Fields):
    """All frames, or a part of them: `r.frames[-1].position` [N,3], `r.frames[::10].position` [F,N,3], `len(r.frames)`."""

    _chosen: range

    def __init__(self, source: Source, chosen: range | None = None) -> None:
        super().__init__(source, range(len(source.frame_times)) if chosen is None else chosen, NODES)

    @property
    def time(self) -> Array:
        """Their times [F]; in statics load factors."""
        return self._source.frame_times[np.array(self._chosen, dtype=int)]

    @property
    def elements(self) -> Fields:
        """All elements: `force`, `moment`, `strain`, `curvature` [F,E,3], material, at their middles; zero for bodies, the last rows."""
        return Fields(self._source, self._chosen, ELEMENTS)

    def nearest(self, time: float) -> Frame:
        """The Frame that is nearest to a time, in statics to a load factor."""
        return self[self.index(time)]

    def index(self, time: float) -> int:
        """Number of the frame that is nearest to a time, in statics to a load factor; IndexError before the first frame."""
        if not len(self):
            raise IndexError("there is no frame yet")
        return int(np.abs(self.time - time).argmin())

    def of_node(self, node: int, name: str = "position") -> Array:
        """One quantity of one node, from 0, in all of these frames: [F,3]. IndexError if there is no such node."""
        shape = self.describe(name).shape
        if not -shape[0] <= node < shape[0]:
            raise IndexError(f"there is no node {node}; they go from 0 to {shape[0] - 1}")
        if not len(self):
            return np.empty((0, *shape[1:]))
        node %= shape[0]
        ends = sorted((self._chosen[0], self._chosen[-1]))
        rows = slice(ends[0] * shape[0] + node, ends[1] * shape[0] + node + 1, abs(self._chosen.step) * shape[0])
        values = self._source.read(lambda file: file[self._path(name)][rows])
        return values[::-1] if self._chosen.step < 0 else values

    def __len__(self) -> int:
        return len(self._chosen)

    def __iter__(self) -> Iterator[Frame]:
        return (self[i] for i in range(len(self)))

    if TYPE_CHECKING:  # what a key leads to

        @overload  # type: ignore[override]
        def __getitem__(self, key: str) -> Array: ...
        @overload
        def __getitem__(self, key: int) -> Frame: ...
        @overload
        def __getitem__(self, key: slice) -> Frames: ...

    def __getitem__(self, key):
        if isinstance(key, str):
            return super().__getitem__(key)
        if isinstance(key, slice):
            return Frames(self._source, self._chosen[key])
        try:
            return Frame(self._source, self._chosen[key])
        except IndexError:
            raise IndexError(f"there is no frame {key}; there are {len(self)}") from None

    def _headline(self):
        times = self.time
        span = f", {self._source.time_name} {times[0]:g} to {times[-1]:g}" if len(self) else ""
        return f"{len(self)} frames{span}: {self._source.points} nodes, {self._source.cells} elements and bodies"


class Cells:
    """Which nodes each cell has: elements in the order of the rods, then a vertex for each body."""

    VERTEX = 1
    CURVES = {3, 21, 35, 68}  # VTK cell types of rod elements: the two ends first, then the nodes between

    def __init__(self, file):
        grid = file["VTKHDF"]
        self.connectivity, self.offsets, self.types = (grid[name][()] for name in ("Connectivity", "Offsets", "Types"))
        offsets, points = self.offsets, int(grid["NumberOfPoints"][0])
        if len(offsets) != len(self.types) + 1 or offsets[-1] != len(self.connectivity) or (np.diff(offsets, prepend=0)[1:] < 1).any() or (
                not ((self.connectivity >= 0) & (self.connectivity < points)).all()):
            raise ValueError("its cells do not fit its points")

    def entries(self, cell):
        """Rows of the connectivity, from the start of the element to its end."""
        first, end = int(self.offsets[cell]), int(self.offsets[cell + 1])
        return [first, *range(first + 2, end), first + 1] if end > first + 1 else [first]

    def nodes(self, cell):
        return [int(node) for node in self.connectivity[self.entries(cell)]]

    def body_nodes(self):
        return [self.nodes(cell)[0] for cell in np.flatnonzero(self.types == self.VERTEX)]

    def polylines(self):
        """Nodes from end to end, of elements that follow one another: an array for each line."""
        lines = []
        for cell in np.flatnonzero(np.isin(self.types, list(self.CURVES))):
            nodes = self.nodes(cell)
            if lines and lines[-1][-1] == nodes[0]:
                lines[-1].extend(nodes[1:])
            else:
                lines.append(nodes)
        return [np.array(line) for line in lines]


def read_cells(source):
    return source.once("cells", Cells)


class Rod(Shown):
    """A rod from its start to its end. Its quantities are functions of the frame: `r.rod("arm").moment(frame=-1)`.

    Those of nodes, as `position`, are [n,3] in global axes; `force`, `moment`, `strain` and `curvature` are [e,3], at the
    middles of the elements in section axes. Arguments are those of `read`.

    `name`, `section`: texts. `length`: at t = 0. `order`: of its elements. `nodes` [n]: its nodes, as rows of frames. `arc_length` [n]:
    where they are along it at t = 0. `cells` [e]: its elements, as rows of `elements` of frames. `cell_arc_length` [e]: where their middles are.
    """

    def __init__(self, source: Source, name: str) -> None:
        self._source, self.name = source, name
        rods = read_rod_table(source)
        row = list(rods["name"]).index(name)
        self.section, self.length, self.order = rods["section"][row], float(rods["length"][row]), int(rods["order"][row])
        first, count = int(rods["first_cell"][row]), int(rods["elements"][row])
        self.cells = np.arange(first, first + count)
        self._place(read_cells(source))

    def _place(self, cells):
        lengths, middles = self._source.once("arc lengths", lambda file: (
            file["rods/arc_length"][()], file["VTKHDF/CellData/arc_length"][: self._source.cells]))
        nodes, places = [], []
        for cell in self.cells:
            entries = cells.entries(cell)
            if nodes and nodes[-1] == cells.connectivity[entries[0]]:
                entries = entries[1:]
            nodes += [int(node) for node in cells.connectivity[entries]]
            places += list(lengths[entries])
        self.nodes, self.arc_length, self.cell_arc_length = np.array(nodes), np.array(places), middles[self.cells]

    @property
    def names(self) -> list[str]:
        """Names of the quantities."""
        frames = Frames(self._source)
        return [name for name in dict.fromkeys([*frames.names, *frames.elements.names, *DERIVED]) if name not in STILL]

    def describe(self, name: str) -> Quantity:
        """What a quantity is: a `Quantity` with description, frame, dimension, unit and shape."""
        if name not in self.names:
            raise unknown_name(f"quantity of rod {self.name}", name, self.names)
        frames = Frames(self._source)
        if name not in DERIVED:
            return (frames if name in frames else frames.elements).describe(name)
        _, description, dimension, _ = DERIVED[name]
        return Quantity(name, f"{description}, at the element's middle", "none", dimension, self._source.unit(dimension), (self._source.cells,))

    def range(self, quantity: str, start: float | None = None, end: float | None = None, stage: str | None = None) -> Range:
        """The least, largest and mean value along the rod: `r.rod("riser").range("effective_tension").largest` [e].

        quantity: a name, of vectors with a component, "moment/y"; without one their size. start, end: times, in statics load factors; stage: the
        name of one instead. Without any: all frames of stages with time, in statics all.
        """
        from .ranges import find_range

        return find_range(self, quantity, start, end, stage)

    def read(self, name: str, frame: int | slice = -1, time: float | None = None) -> Array:
        """A quantity by its name, [n,3] or [e,3]: what `rod.moment(frame)` reads.

        frame: its number, -1 the last one; a slice reads several ones, [F,n,3]. time: takes the nearest frame instead, in
        statics that of the nearest load factor.
        """
        if name not in self.names:
            raise unknown_name(f"quantity of rod {self.name}", name, self.names)
        if name in DERIVED:
            source, *_, value = DERIVED[name]
            return value(self.read(source, frame, time))
        frames = Frames(self._source)
        chosen = frames.nearest(time) if time is not None else frames[frame]
        if name in frames:
            return chosen[name][..., self.nodes, :] if len(frames.describe(name).shape) > 1 else chosen[name][..., self.nodes]
        return chosen.elements[name][..., self.cells, :] if len(frames.elements.describe(name).shape) > 1 else chosen.elements[name][..., self.cells]

    def __getattr__(self, name: str) -> Callable[..., Array]:
        if name.startswith("_"):
            raise AttributeError(name)
        what = self.describe(name)
        is_of_nodes = name in Frames(self._source)

        def quantity(frame=-1, time=None):
            return self.read(name, frame, time)

        rows = "n" if is_of_nodes else "e"
        places = "its nodes, from start to end" if is_of_nodes else "the middles of its elements, from start to end"
        quantity.__name__ = name
        quantity.__doc__ = (f"{what.description} [{', '.join([rows, *map(str, what.shape[1:])])}] at {places}; {what.unit or what.dimension}, "
                            f"{what.frame}.\n\nframe: its number, or a slice for several ones [F,{rows},3]; time: takes the nearest frame instead.")
        return quantity

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.names]

    def _headline(self):
        return f"rod {self.name}: length {self.length:g}, {len(self.cells)} elements of order {self.order}, section {self.section}"

    def _rows(self):
        frames = Frames(self._source)
        of_nodes = [name for name in frames.names if name not in STILL]
        of_elements = [name for name in frames.elements.names if name in self.names and name not in of_nodes]
        return [(f"{len(self.nodes)} nodes", ", ".join(of_nodes)), (f"{len(self.cells)} elements", ", ".join(of_elements))]


def read_rod_table(source):
    def read(file):
        if "rods" not in file:
            return {"name": []}
        return {name: read_column(file["rods"][name]) for name in ("name", "section", "length", "order", "elements", "first_cell")}

    return source.once("rods", read)


def find_rod(source, name):
    names = list(read_rod_table(source)["name"])
    if name in names:
        return Rod(source, name)
    if not names:
        raise UnknownNameError(f"there is no rod {name!r}: the file names no rods; it has none, or more than 65,536")
    raise unknown_name("rod", name, names)
