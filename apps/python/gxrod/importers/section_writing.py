"""A section of plies as a mesh file of Gmsh and a deck with its materials, which runs at once."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable
from math import pi
from pathlib import Path

import numpy as np

from ..errors import FileError
from ..typed import AnyPath, Array
from .section_mesh import GMSH_TYPES, SAME, SectionLayer, SectionMaterial, SectionMesh
from .writing import number, quoted, row

WALLS = "wall_angle"  # the name of the data on elements
SLENDER = 20.0  # length of the rod over the extent of the section


def write_section_mesh(section: SectionMesh, path: AnyPath, *, name: str = "section") -> list[Path]:
    """Writes a deck and beside it the mesh, a .msh file; returns the paths. name: of the section in the deck.

    Raises FileError if they cannot be written.
    """
    deck = Path(path)
    mesh = deck.with_suffix(".msh")
    for file, text in ((mesh, mesh_text(section)), (deck, deck_text(section, mesh.name, name))):
        try:
            file.write_text(text, encoding="utf-8")
        except OSError as error:
            raise FileError(f"{file}: cannot be written: {error.strerror or error}") from error
    return [mesh, deck]


# The mesh

def mesh_text(section: SectionMesh) -> str:
    groups = [f'2 {i} "{layer.name}"' for i, layer in enumerate(section.layers, 1)]
    nodes = [f"{i} {y:.17g} {z:.17g} 0" for i, (y, z) in enumerate(section.nodes, 1)]
    elements = [f"{i} {GMSH_TYPES[len(element)]} 2 {layer + 1} {layer + 1} {' '.join(str(node + 1) for node in element)}"
                for i, (element, layer) in enumerate(zip(section.elements, section.element_layers), 1)]
    parts = [block("MeshFormat", ["2.2 0 8"])]
    for heading, lines in (("PhysicalNames", groups), ("Nodes", nodes), ("Elements", elements)):
        parts.append(block(heading, [str(len(lines)), *lines]))
    return "".join(parts + wall_blocks(section))


def block(heading: str, lines: Iterable[str]) -> str:
    return "\n".join([f"${heading}", *lines, f"$End{heading}"]) + "\n"


def wall_blocks(section: SectionMesh) -> list[str]:
    """Angles of walls, of the elements in layers that have several, or of all their nodes if one has them by node."""
    several = {i for i in range(len(section.layers)) if not has_one_wall(section, i)}
    chosen = [i for i, layer in enumerate(section.element_layers) if layer in several]
    if not chosen:
        return []
    if by_node := any(len(section.wall_angles[i]) > 1 for i in chosen):
        values = [f"{i + 1} {len(section.elements[i])} " + " ".join(map(exact, np.broadcast_to(section.wall_angles[i], len(section.elements[i])))) for i in chosen]
    else:
        values = [f"{i + 1} {exact(section.wall_angles[i][0])}" for i in chosen]
    header = ["1", f'"{WALLS}"', "1", "0", "3", "0", "1", str(len(values))]
    return [block("ElementNodeData" if by_node else "ElementData", header + values)]


def exact(value: float) -> str:
    return f"{value:.17g}"


def angles_of(section: SectionMesh, layer: int) -> Array:
    return np.concatenate([angles for angles, own in zip(section.wall_angles, section.element_layers) if own == layer])


def has_one_wall(section: SectionMesh, layer: int) -> bool:
    return section.layers[layer].material.is_isotropic or float(np.ptp(angles_of(section, layer))) < SAME


# The deck

def deck_text(section: SectionMesh, mesh: str, name: str) -> str:
    materials = {layer.material.name: layer.material for layer in section.layers}
    parts = [header(section), *(material_text(each) for each in materials.values()), f"[section.{key(name)}.shape.mesh]\nfile = {quoted(mesh)}",
             *(group_text(section, i, name) for i in range(len(section.layers))), rod_text(section, name)]
    return "\n\n".join(parts) + "\n"


def header(section: SectionMesh) -> str:
    lines = [f"{section.title}; imported by gxrod-import from {section.source}.",
             f"{len(section.elements)} elements, {len(section.nodes)} nodes, {section.extent:.6g} across.",
             f"Section axes: x along the rod, y to the right and z up, seen against x. {'SI units' if section.units else 'Units are those of the file'}, angles in rad.",
             *section.notes, *(f"warning: {each}" for each in section.warnings)]
    return "\n".join(textwrap.fill(line, 150, initial_indent="# ", subsequent_indent="#   ") for line in lines) + f"\n\ntitle = {quoted(section.title)}" + (f"\nunits = {quoted(section.units)}" if section.units else "")


def material_text(material: SectionMaterial) -> str:
    lines = [f"[material.{key(material.name)}]"]
    if material.is_isotropic:
        lines += [f"E        = {number(material.E)}", f"nu       = {number(material.nu)}"]
    else:
        lines += [f"E        = {row(material.E)}", f"G        = {row(material.G)}", f"nu       = {row(material.nu)}"]
    if material.density:
        lines.append(f"density  = {number(material.density)}")
    if material.strength:
        lines.append("strength = { " + ", ".join(f"{name} = {number(value)}" for name, value in material.strength.items()) + " }")
    return "\n".join(lines)


def group_text(section: SectionMesh, index: int, name: str) -> str:
    layer = section.layers[index]
    lines = [f"[section.{key(name)}.shape.mesh.groups.{key(layer.name)}]", f"material = {quoted(layer.material.name)}", *angle_keys(layer)]
    if layer.material.is_isotropic:
        return "\n".join(lines)
    if not has_one_wall(section, index):
        lines.append(f'directions = "{WALLS}"')
    elif abs(wall := float(angles_of(section, index)[0])) > SAME:
        lines.append(f"direction = {angle(wall)}")
    return "\n".join(lines)


def angle_keys(layer: SectionLayer) -> list[str]:
    return [f"angle = {angle(layer.fibre_angle)}"] if abs(layer.fibre_angle) > SAME and not layer.material.is_isotropic else []


def angle(value: float) -> str:
    """In degrees, if that is a short number, as an expression."""
    degrees = value * 180.0 / pi
    return f'"{round(degrees, 6):.10g}*pi/180"' if abs(degrees - round(degrees, 6)) < 1e-12 else number(value, 17)


def key(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else quoted(name)


def rod_text(section: SectionMesh, name: str) -> str:
    """A cantilever under a small force, for a deck that runs; about 1/1000 of its length."""
    length, width = SLENDER * section.extent, section.extent
    modulus = min(np.min(layer.material.E) for layer in section.layers)
    force = 3e-3 * float(modulus) * section.area * (width / length) ** 2 / 12.0
    return (f'[rod.beam]\nsection  = {quoted(name)}\nline     = {{ from = [0, 0, 0], to = [{number(length, 6)}, 0, 0] }}\ny_axis   = [0, 1, 0]\nelements = 4\norder    = 2\n\n'
            f'[[support]]\nat  = "beam.start"\nfix = "all"\n\n[[load]]\nat    = "beam.end"\nforce = [0, 0, {number(force, 2)}]\n\n'
            f'[analysis]\nkind = "static"\n\n[[history]]\nname = "tip"\nat   = "beam.end"\nquantities = ["displacement", "rotation_vector"]')
