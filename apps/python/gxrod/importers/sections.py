"""Stiffness and mass of a cross-section that the package sectionproperties has meshed and analysed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..typed import Array
from .axes import move, slice_mass

# Axes of gxrod from those of sectionproperties: x and y in the section are y and z of gxrod.
FROM_SECTION = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])


def from_sectionproperties(section: Any, at: Sequence[float] | None = None) -> tuple[Array, Array]:
    """Stiffness and mass, 6×6, of a `Section` of sectionproperties whose geometry has materials: a deck's `stiffness_matrix` and `mass_matrix`.

    section: its x and y become y and z of the rod's section, looking against the rod's direction. What it has not computed yet is computed: geometric and warping
    properties. at: the point (x, y) that lies on the rod; by default the centroid, weighted by E.

    The stiffness has EA and the bending stiffnesses about the centroid, torsion and the shear stiffnesses, with their coupling, about the shear centre; the distances of both from
    the rod couple them. G is the mean that sectionproperties has, exact where all materials have one Poisson's ratio. The mass is that of the materials' densities.

    Raises ValueError without materials.
    """
    if not section.is_composite():
        raise ValueError("the section has no materials; give them to its geometry: rectangular_section(…, material=Material(…))")
    if section.section_props.cx is None:
        section.calculate_geometric_properties()
    if section.section_props.j is None:
        section.calculate_warping_properties()
    centroid = on_section(section.get_c())
    origin = centroid if at is None else on_section(at)
    stiffness = (move(bending_stiffness(section), centroid - origin) + move(shear_stiffness(section), on_section(section.get_sc()) - origin))
    return stiffness, mass_of(section, origin)


def on_section(point: Sequence[float]) -> Array:
    """(x, y) of sectionproperties as a point of gxrod's section."""
    return np.asarray(FROM_SECTION @ np.array([*map(float, point), 0.0]))


def bending_stiffness(section: Any) -> Array:
    """Extension and bending about the centroid, 6×6."""
    about_x, about_y, product = section.get_eic()
    stiffness = np.zeros((6, 6))
    stiffness[0, 0] = section.get_ea()
    stiffness[4:, 4:] = [[about_x, -product], [-product, about_y]]
    return stiffness


def shear_stiffness(section: Any) -> Array:
    """Shear and torsion about the shear centre, 6×6."""
    found = section.section_props  # shear areas and torsion constant times E
    shear_modulus = section.get_g_eff() / section.get_e_eff()
    stiffness = np.zeros((6, 6))
    stiffness[1:3, 1:3] = np.linalg.inv([[1.0 / found.a_sx, 1.0 / found.a_sxy], [1.0 / found.a_sxy, 1.0 / found.a_sy]]) * shear_modulus
    stiffness[3, 3] = section.get_ej() * shear_modulus
    return stiffness


def mass_of(section: Any, origin: Array) -> Array:
    """6×6, from the densities of the triangles, whose sides are straight."""
    mass, first, second = 0.0, np.zeros(2), np.zeros((2, 2))
    for element in section.elements:
        corners = np.asarray(element.coords, dtype=float)[:, :3].T
        (a, b), middle = (corners[1:] - corners[0]), corners.mean(axis=0)
        weight = element.material.density * abs(a[0] * b[1] - a[1] * b[0]) / 2.0
        mass += weight
        first += weight * middle
        second += weight / 12.0 * (corners.T @ corners + 9.0 * np.outer(middle, middle))
    centre = first / mass
    about_centre = second - mass * np.outer(centre, centre)
    in_plane = np.zeros((3, 3))
    in_plane[1:, 1:] = about_centre
    return slice_mass(mass, on_section(tuple(centre)) - origin, np.trace(in_plane) * np.eye(3) - in_plane)
