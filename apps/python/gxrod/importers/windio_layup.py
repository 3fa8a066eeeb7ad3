"""windIO 1: the layup of a blade at one place of its span, as a mesh: outline of the airfoil, layers of the wall from outside in, webs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from ..typed import AnyPath, Array
from .airfoil_mesh import AirfoilMesher, Outline, WallLayer, Web
from .section_mesh import SectionLayer, SectionMaterial, SectionMesh
from .text import ImportFault
from .windio import Node, load_yaml

POINTS = 200  # of an outline, on each side


def read_windio_layup(path: AnyPath, fraction: float) -> SectionMesh:
    """The section of a windIO file (version 1) at a fraction of the span, meshed from its airfoils and layers.

    Axes are those of the matrices in such a file: x along the blade, y flapwise, to the suction side, z to the trailing edge, from the reference axis. Layers
    without thickness there are left out; joints, adhesive and gaps at the trailing edge are not modelled: the walls of both sides meet there.

    Raises FileError, with file, key, what was expected and what to do.
    """
    return Reader(Path(path), fraction).read()


class Reader:
    def __init__(self, file: Path, fraction: float) -> None:
        if not 0.0 <= fraction <= 1.0:
            raise ImportFault(f"{file}: there is no section at {fraction:g} of the span; give a fraction from 0 to 1")
        self.fraction = fraction
        self.root = Node(load_yaml(file), file)
        blade = self.root["components"]["blade"]
        if not blade.has("internal_structure_2d_fem"):
            raise blade.fault("expected a key internal_structure_2d_fem", "give a windIO file of version 1 with a layup")
        self.shape, self.structure = blade["outer_shape_bem"], blade["internal_structure_2d_fem"]
        self.layers: list[SectionLayer] = []
        self.materials: dict[str, SectionMaterial] = {}
        self.notes: list[str] = []

    def read(self) -> SectionMesh:
        chord, axis = (self.value(self.shape[key]) for key in ("chord", "pitch_axis"))
        profile = self.read_profile()
        outline = Outline(np.stack([profile[:, 1], profile[:, 0] - axis], axis=1) * chord)
        walls, webs = self.read_layers(outline)
        title = f"{self.root.values.get('name', 'Blade')}, section at {self.fraction:g} of the span"
        section = AirfoilMesher(outline, walls, webs).make(title, f"windIO 1: {self.root.file.name}", self.layers)
        section.notes += self.notes
        section.units = "m kg s"
        return section

    def value(self, node: Node) -> float:
        """At the fraction of the span, linear between; 0 outside of the grid."""
        grid, values = node.table()
        return float(np.interp(self.fraction, grid, values, left=0.0, right=0.0))

    # The outline

    def read_profile(self) -> Array:
        """Points x, y of the airfoil for a chord of 1, from the trailing edge over the suction side: between two airfoils by their relative thickness."""
        position = self.shape["airfoil_position"]
        grid = position["grid"].numbers((-1,))
        labels = [str(label) for label in position["labels"].values]
        airfoils = {str(each.get("name")): each for each in self.root["airfoils"].values}
        absent = [label for label in labels if label not in airfoils]
        if absent:
            raise position.fault(f"there is no airfoil {absent[0]}", "add it to airfoils")
        thickness = np.array([float(airfoils[label]["relative_thickness"]) for label in labels])
        wanted = monotone(self.fraction, grid, thickness)
        i = int(np.clip(np.searchsorted(grid, self.fraction, side="right") - 1, 0, len(grid) - 2))
        a, b = (side_by_side(airfoils[label]["coordinates"]) for label in labels[i: i + 2])
        part = 0.0 if thickness[i] == thickness[i + 1] else (wanted - thickness[i]) / (thickness[i + 1] - thickness[i])
        points = (1.0 - part) * a + part * b
        return points

    # Layers

    def read_layers(self, outline: Outline) -> tuple[list[WallLayer], list[Web]]:
        webs = {str(web["name"]): Web(*(self.value(Node(web, self.root.file, "components/blade/internal_structure_2d_fem/webs")[key]) for key in ("start_nd_arc", "end_nd_arc")))
                for web in self.structure["webs"].values} if self.structure.has("webs") else {}
        walls = []
        for values in self.structure["layers"].values:
            layer = Node(values, self.root.file, "components/blade/internal_structure_2d_fem/layers")
            thickness = self.value(layer["thickness"])
            if thickness < 1e-6 * outline.chord / 100.0:
                continue
            index = self.layer_of(layer)
            if layer.has("web"):
                webs[str(values["web"])].layers.append(WallLayer(index, thickness))
            else:
                walls.append(WallLayer(index, thickness, *self.reach_of(layer, outline)))
        return walls, [web for web in webs.values() if web.layers and web.end > web.start]

    def reach_of(self, layer: Node, outline: Outline) -> tuple[float, float]:
        """Start and end along the outline; one that the file does not have follows from the width."""
        has = [layer.has(key) and layer[key].has("values") for key in ("start_nd_arc", "end_nd_arc")]
        if not any(has):
            raise layer.fault(f"the layer {layer.values.get('name')} has neither start_nd_arc nor end_nd_arc with values", "add them")
        start, end = (self.value(layer[key]) if there else 0.0 for key, there in zip(("start_nd_arc", "end_nd_arc"), has))
        width = 0.0 if all(has) else self.value(layer["width"]) / outline.length
        return (start, end if has[1] else start + width) if has[0] else (end - width, end)

    def layer_of(self, layer: Node) -> int:
        angle = self.value(layer["fiber_orientation"]) if layer.has("fiber_orientation") else 0.0
        if angle and "fibres" not in "".join(self.notes):
            self.notes.append("angles of fibres are taken from x towards a walk round the section anticlockwise, seen against x; windIO does not say which way")
        name = str(layer["material"].values)
        if name not in self.materials:
            self.materials[name] = self.read_material(name)
        made = SectionLayer(self.materials[name], float(np.radians(angle)))
        if made not in self.layers:
            self.layers.append(made)
        return self.layers.index(made)

    def read_material(self, name: str) -> SectionMaterial:
        found: dict[str, Any] | None = next((each for each in self.root["materials"].values if str(each.get("name")) == name), None)
        if found is None:
            raise self.root["materials"].fault(f"there is no material {name}", "add it")
        node = Node(found, self.root.file, f"materials/{name}")
        if not found.get("orth"):
            E = float(node["E"].numbers(()))
            return SectionMaterial(name, E, E / (2.0 * float(node["G"].numbers(()))) - 1.0 if node.has("G") else float(node["nu"].numbers(())), density=float(node["rho"].numbers(())))
        E, G, nu = (node[key].numbers((3,)).tolist() for key in ("E", "G", "nu"))
        return SectionMaterial(name, E, nu, G, float(node["rho"].numbers(())))


def side_by_side(coordinates: dict[str, Any]) -> Array:
    """Points of both sides at the same places along the chord, dense at both edges."""
    x, y = (np.array(coordinates[key], float) for key in "xy")
    nose = int(np.argmin(x))
    places = 0.5 * (1.0 + np.cos(np.linspace(0.0, np.pi, POINTS + 1)))
    upper = np.interp(places[::-1], x[nose::-1], y[nose::-1])[::-1]
    lower = np.interp(places[::-1], x[nose:], y[nose:])[::-1]
    if np.mean(upper) < np.mean(lower):
        upper, lower = lower, upper
    return np.concatenate((np.stack([places, upper], axis=1), np.stack([places, lower], axis=1)[-2::-1]))


def monotone(at: float, x: Array, y: Array) -> float:
    """A cubic between points that does not overshoot (Fritsch and Carlson 1980), as windIO's tools interpolate thickness."""
    slopes = np.diff(y) / np.diff(x)
    h = np.diff(x)
    d = np.zeros(len(x))
    for i in range(1, len(x) - 1):
        if slopes[i - 1] * slopes[i] > 0.0:
            w1, w2 = 2.0 * h[i] + h[i - 1], h[i] + 2.0 * h[i - 1]
            d[i] = (w1 + w2) / (w1 / slopes[i - 1] + w2 / slopes[i])
    d[0], d[-1] = slopes[0], slopes[-1]
    i = int(np.clip(np.searchsorted(x, at, side="right") - 1, 0, len(h) - 1))
    u = (at - x[i]) / h[i]
    return float((1 + 2 * u) * (1 - u) ** 2 * y[i] + u * (1 - u) ** 2 * h[i] * d[i] + u**2 * (3 - 2 * u) * y[i + 1] + u**2 * (u - 1) * h[i] * d[i + 1])
