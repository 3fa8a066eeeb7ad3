"""One small blade, written as the files of four programs.

Its sections are described by centres, stiffnesses and an angle; matrices follow from energies, by E(a + b) − E(a) − E(b), so that nothing
of the importers is used here. Axes are those of BeamDyn: x flapwise, y edgewise, z along.
"""

from dataclasses import dataclass, replace
from itertools import product
from math import cos, degrees, radians, sin, sqrt

import numpy as np


@dataclass
class Section:
    """Elastic centre, shear centre, centre of mass; principal axes 1 and 2, turned by `angle` (rad) about z from x and y."""

    fraction: float
    elastic: tuple = (0.0, 0.0)
    shear: tuple = (0.0, 0.0)
    masses: tuple = (0.0, 0.0)
    angle: float = 0.0
    EA: float = 8e9
    GA: tuple = (3e8, 5e8)  # along 1 and 2
    EI: tuple = (4e9, 1e9)  # about 1 and 2
    GJ: float = 2e8
    m: float = 300.0
    J: tuple = (80.0, 20.0)  # about 1 and 2 through the centre of mass

    def stiffness(self):
        return polarize(self.strain_energy)

    def mass(self):
        return polarize(self.kinetic_energy)

    def strain_energy(self, s):
        axial = s[2] + s[3] * self.elastic[1] - s[4] * self.elastic[0]
        shear = self.along(s[0] - s[5] * self.shear[1], s[1] + s[5] * self.shear[0])
        bending = self.along(s[3], s[4])
        return (self.EA * axial**2 + self.GJ * s[5] ** 2 + sum(k * e**2 for k, e in zip(self.GA + self.EI, shear + bending))) / 2

    def kinetic_energy(self, v):
        x, y = self.masses
        speed = (v[0] - v[5] * y, v[1] + v[5] * x, v[2] + v[3] * y - v[4] * x)
        turning = (*self.along(v[3], v[4]), v[5])
        return (self.m * sum(each**2 for each in speed) + sum(j * w**2 for j, w in zip((*self.J, sum(self.J)), turning))) / 2

    def along(self, x, y):
        """Components along 1 and 2."""
        c, s = cos(self.angle), sin(self.angle)
        return c * x + s * y, c * y - s * x

    def about_elastic_centre(self):
        """The same section with all points seen from the elastic centre in the principal axes."""
        seen = lambda p: self.along(p[0] - self.elastic[0], p[1] - self.elastic[1])
        return replace(self, elastic=(0.0, 0.0), shear=seen(self.shear), angle=0.0)


def polarize(energy):
    unit = np.eye(6)
    return np.array([[energy(unit[i] + unit[j]) - energy(unit[i]) - energy(unit[j]) for j in range(6)] for i in range(6)])


SECTIONS = (Section(0.0),
            Section(0.25, elastic=(0.02, 0.3), shear=(-0.05, 0.4), masses=(0.03, 0.5), angle=radians(12.0), EA=6e9, EI=(3e9, 8e8), m=250.0),
            Section(1.0, elastic=(-0.01, 0.1), shear=(0.04, -0.1), masses=(0.0, 0.2), angle=radians(-7.0), EA=2e8, GA=(1e7, 3e7), EI=(5e7, 2e7), GJ=5e6, m=20.0, J=(2.0, 0.5)))
# Key points x, y, z (m) and twist (degrees about −z): bent flapwise and swept.
KEYS = ((0.0, 0.0, 0.0, 13.0), (0.0, 0.1, 10.0, 9.0), (-0.4, 0.3, 25.0, 3.0), (-2.0, 1.0, 40.0, -1.0))
MU = (1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3)


def text_of(row):
    return " ".join(f"{each:.17g}" for each in row)


def write_beamdyn(folder, sections=SECTIONS, keys=KEYS, mu=MU):
    """The primary file; the blade file is beside it."""
    rows = "\n".join(map(text_of, keys))
    (folder / "primary.dat").write_text(f"""--------- BEAMDYN with OpenFAST INPUT FILE ---
A small blade
---------------------- GEOMETRY PARAMETER ---
1   member_total    - Total number of members (-)
{len(keys)}   kp_total        - Total number of key points (-)
1   {len(keys)}             - Member number; Number of key points in this member
kp_xr kp_yr kp_zr initial_twist
(m) (m) (m) (deg)
{rows}
---------------------- MATERIAL PARAMETER ---
"blade.dat"    BldFile - Name of file containing properties for blade (quoted string)
""")
    stations = "".join(f"  {each.fraction!r}\n" + "".join("\n".join(map(text_of, matrix)) + "\n\n" for matrix in (each.stiffness(), each.mass())) for each in sections)
    (folder / "blade.dat").write_text(f""" ------- BEAMDYN V1.00.* INDIVIDUAL BLADE INPUT FILE ---
 A small blade
 ---------------------- BLADE PARAMETERS ---
{len(sections)}   station_total    - Number of blade input stations (-)
 {int(bool(mu))}   damp_type        - Damping type: 0: no damping; 1: damped
  ---------------------- DAMPING COEFFICIENT---
   mu1        mu2        mu3        mu4        mu5        mu6
   (-)        (-)        (-)        (-)        (-)        (-)
{text_of(mu or [0] * 6)}
 ---------------------- DISTRIBUTED PROPERTIES---
{stations}""")
    return folder / "primary.dat"


def write_windio(folder, version, sections=SECTIONS, keys=KEYS, fractions=None):
    """`fractions`: of the key points along the curve."""
    table = lambda values, grid=fractions: f"{{grid: {list(map(float, grid))}, values: {list(map(float, values))}}}"
    grid = [each.fraction for each in sections]
    x, y, z, twist = zip(*keys)
    axis = f"{{x: {table(x)}, y: {table(y)}, z: {table(z)}}}"
    upper = lambda matrix: [float(matrix[i, j]) for i, j in product(range(6), range(6)) if i <= j]
    if version == 1:
        text = f"""name: A small blade
components:
    blade:
        elastic_properties_mb:
            six_x_six:
                reference_axis: {axis}
                twist: {table(map(radians, twist))}
                stiff_matrix:
                    grid: {grid}
                    values: {[upper(each.stiffness()) for each in sections]}
                inertia_matrix:
                    grid: {grid}
                    values: {[upper(each.mass()) for each in sections]}
"""
    else:
        names = [f"K{i}{j}" for i in range(1, 7) for j in range(i, 7)]
        columns = "\n".join(f"                {name}: {list(column)}" for name, column in zip(names, zip(*(upper(each.stiffness()) for each in sections))))
        entry = lambda i, j, sign=1.0: [float(sign * each.mass()[i, j]) for each in sections]
        text = f"""windIO_version: 2.0
name: A small blade
components:
    blade:
        reference_axis: {axis}
        outer_shape:
            twist: {table(twist)}
        structure:
            elastic_properties:
                structural_damping: {{mu: {list(MU)}}}
                stiffness_matrix:
                    grid: {grid}
{columns.replace("                K", "                    K")}
                inertia_matrix:
                    grid: {grid}
                    mass: {[each.m for each in sections]}
                    cm_x: {[each.masses[0] for each in sections]}
                    cm_y: {[each.masses[1] for each in sections]}
                    i_edge: {entry(3, 3)}
                    i_flap: {entry(4, 4)}
                    i_plr: {entry(5, 5)}
                    i_cp: {entry(3, 4, -1.0)}
"""
    (folder / "blade.yaml").write_text(text)
    return folder / "blade.yaml"


def write_hawc2(folder, length, full, sections=SECTIONS, keys=KEYS):
    """The htc file; the st file is beside it. HAWC2's x and y are BeamDyn's −y and x, so that its axes x and y, turned by the pitch, are 2 and 1."""
    rows = "\n".join(text_of(st_row(each, length, full)) for each in sections)
    (folder / "blade.st").write_text(f"1 ; number of sets\n---\n#1 ; the blade\nr m x_cg …\n$1 {len(sections)}\n{rows}\n")
    curve = "\n".join(f"      sec {i} {text_of((-y, x, z, -twist))} ; x y z twist" for i, (x, y, z, twist) in enumerate(keys, 1))
    (folder / "blade.htc").write_text(f"""; a part of a model
  begin main_body;  shaft
    name shaft ;
    begin c2_def;
      sec 1 0 0 0 0;
      sec 2 0 0 1 0;
    end c2_def;
  end main_body;
  begin main_body;
    name blade1 ;
    damping_posdef 0 0 0 1e-3 1e-3 1e-3 ;
    begin timoschenko_input;
      filename ./data/blade.st ;
      set 1 1 ; set and subset
    end timoschenko_input;
    begin c2_def;
      nsec {len(keys)} ;
{curve}
    end c2_def ;
  end main_body;
""")
    return folder / "blade.htc"


def st_row(each, length, full):
    hawc2 = lambda p: (-p[1], p[0])
    start = [each.fraction * length, each.m, *hawc2(each.masses), sqrt(each.J[1] / each.m), sqrt(each.J[0] / each.m)]
    end = [degrees(each.angle), *hawc2(each.elastic)]
    if full:
        swap = np.kron(np.eye(2), [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
        matrix = swap @ each.about_elastic_centre().stiffness() @ swap.T
        return [*start, *end, *matrix[np.triu_indices(6)]]
    E, G = 1e10, 4e9
    A = each.EA / E
    return [*start, *hawc2(each.shear), E, G, each.EI[1] / E, each.EI[0] / E, each.GJ / G, each.GA[1] / (G * A), each.GA[0] / (G * A), A, *end]


def write_elastodyn(folder, sections, twist=0.0, factors=(1.0, 1.0, 1.0), tuner=1.0):
    rows = "\n".join(text_of((each.fraction, 0.25, twist, each.m, each.EI[1], each.EI[0])) for each in sections)
    (folder / "elastodyn.dat").write_text(f"""------- ELASTODYN V1.00.* INDIVIDUAL BLADE INPUT FILE ---
A small blade
---------------------- BLADE PARAMETERS ---
{len(sections)}   NBlInpSt    - Number of blade input stations (-)
{tuner}   FlStTunr1   - Blade flapwise modal stiffness tuner, 1st mode (-)
{factors[0]}   AdjBlMs     - Factor to adjust blade mass density (-)
{factors[1]}   AdjFlSt     - Factor to adjust blade flap stiffness (-)
{factors[2]}   AdjEdSt     - Factor to adjust blade edge stiffness (-)
---------------------- DISTRIBUTED BLADE PROPERTIES ---
BlFract PitchAxis StrcTwst BMassDen FlpStff EdgStff
(-) (-) (deg) (kg/m) (Nm^2) (Nm^2)
{rows}
---------------------- BLADE MODE SHAPES ---
""")
    return folder / "elastodyn.dat"
