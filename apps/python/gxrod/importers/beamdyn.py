"""BeamDyn of OpenFAST: a primary file with the key points of the reference curve, and the blade file that it names.

Its axes: x flapwise (downwind), y edgewise (to the trailing edge), z along; 6×6 in the order x y z | rx ry rz. The twist is about −z.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from ..typed import AnyPath, Array
from .axes import FROM_BEAMDYN, turn
from .blade import Blade, check_blade
from .curve import Curve
from .text import Lines, UnusedKeys, find_beside

USED = ("member_total", "kp_total", "BldFile", "station_total", "damp_type", "damp_flag", "UsePitchAct", "n_modes", "zeta")
# Keys of BeamDyn's mesh, scheme and output.
NOT_NEEDED = ("Echo", "QuasiStaticInit", "rhoinf", "quadrature", "refine", "n_fact", "DTBeam", "load_retries", "NRMax", "stop_tol", "tngt_stf_fd", "tngt_stf_comp", "tngt_stf_pert", "tngt_stf_difftol",
              "RotStates", "order_elem", "SumPrint", "OutFmt", "NNodeOuts", "OutNd", "OutList", "BldNd_BlOutNd", "BldNd_BlOutNd_Str", "BldNd_BladesOut", "PitchJ", "PitchK", "PitchC", "analysis_type")


def is_beamdyn(text: str) -> bool:
    """Whether it is a primary or a blade file."""
    words = text.lower()
    return "kp_total" in words and "bldfile" in words or "station_total" in words and "distributed properties" in words


def read_beamdyn(path: AnyPath, blade_file: AnyPath | None = None) -> Blade:
    """From the primary file; `blade_file` in place of the one that it names."""
    primary = Lines(path)
    if not find_key(primary, "kp_total"):
        raise primary.fault("this is a BeamDyn blade file, which has no length and no curve; expected the primary file",
                            "import the primary file, which names this one as BldFile", 0)
    points, twist = read_key_points(primary)
    blade = Lines(blade_file or find_blade_file(primary))
    fractions, stiffness, mass, lines = read_stations(blade)
    damping, warnings = read_damping(blade)
    unused = find_unused(primary, blade)
    notes = unused.notes("BeamDyn's mesh, scheme and output")
    warnings += [*unused.warnings(), *read_pitch_actuator(primary)]
    if read_count(primary, "member_total") > 1:
        notes.append("BeamDyn has an element for each member, and lays the curve through each by itself")
    found = Blade(title=primary.lines[1].strip() if len(primary.lines) > 1 else "", source=f"BeamDyn: {primary.path.name}, {blade.path.name}",
                  fractions=fractions, stiffness=stiffness, mass=mass, points=points, twist_fractions=Curve(points).fractions,
                  twist=-np.radians(twist), damping=damping, notes=notes, warnings=warnings)
    return check_blade(found, lambda i, what, todo: blade.fault(what, todo, lines[i]))


def find_key(lines: Lines, key: str) -> int:
    """The line that says `value key - …`, from 1; 0 without it."""
    return lines.find(lambda line: key.lower() in line.lower().split("- ")[0].split()[1:])


def require_key(lines: Lines, key: str) -> int:
    if not (line := find_key(lines, key)):
        raise lines.fault(f"there is no line with {key}", "give a whole file of BeamDyn", 0)
    return line


def read_count(lines: Lines, key: str) -> int:
    """The whole number of `number key - …`; the next line to read is the one after it."""
    lines.at = require_key(lines, key) + 1
    word = lines[lines.at - 1].split()[0]
    if not word.isdigit():
        raise lines.fault(f'expected a whole number for {key}, found "{word}"', "correct it")
    return int(word)


def read_key_points(primary: Lines) -> tuple[Array, Array]:
    """Points [k,3], and twist [k] in degrees about −z."""
    members = read_count(primary, "member_total")
    count = read_count(primary, "kp_total")
    if count < 2:
        raise primary.fault(f"{count} key points; expected three or more", "give the curve's")
    for _ in range(members + 2):  # two lines with names and units
        primary.next("members, names and units of key points")
    rows = []
    for i in range(count):
        rows.append(primary.numbers(4, f"x, y, z and twist of key point {i + 1} of {count}"))
        if i and np.linalg.norm(np.subtract(rows[-1][:3], rows[-2][:3])) == 0.0:
            raise primary.fault("the same key point as the one before", "remove one of them")
    table = np.array(rows)
    return table[:, :3], table[:, 3]


def find_blade_file(primary: Lines) -> Path:
    line = require_key(primary, "BldFile")
    words = primary[line].strip()
    named = words.split(words[0])[1] if words[0] in "\"'" else words.split()[0]
    found, tried = find_beside(named, [primary.path.parent])
    if found is None:
        raise primary.fault(f"the blade file {named} is not there (tried {', '.join(map(str, tried))})", "put it there, or name it with --blade", line)
    return found


def read_stations(blade: Lines) -> tuple[Array, Array, Array, list[int]]:
    """Fractions [n], stiffness and mass [n,6,6] in gxrod's axes, and the lines of the fractions."""
    count = read_count(blade, "station_total")
    start = blade.find(lambda line: "distributed properties" in line.lower())
    if not start:
        raise blade.fault("there is no line DISTRIBUTED PROPERTIES, after which the stations stand", "give a whole blade file of BeamDyn", 0)
    blade.at = start + 1
    fractions, lines = [], []
    stiffness: list[Array] = []
    mass: list[Array] = []
    for i in range(count):
        fractions.append(blade.numbers(1, f"the fraction of station {i + 1} of {count}", exact=True)[0])
        lines.append(blade.at - 1)
        for name, matrices in (("stiffness", stiffness), ("mass", mass)):
            rows = [blade.numbers(6, f"a row of the {name} of station {i + 1}") for _ in range(6)]
            matrices.append(turn(np.array(rows), FROM_BEAMDYN))
    return np.array(fractions), np.array(stiffness), np.array(mass), lines


def find_unused(*files: Lines) -> UnusedKeys:
    """Keys of lines `value key - …` that no deck has."""
    unused = UnusedKeys("key", USED, NOT_NEEDED)
    for lines in files:
        for line in lines.lines:
            found = re.match(r"""\s*("[^"]*"|'[^']*'|[^\s,]+)\s+([A-Za-z]\w*)\s+-""", line)
            if found and not line.lstrip().startswith("-") and found[2].lower() not in map(str.lower, USED):
                unused.add(found[2])
    return unused


def read_pitch_actuator(primary: Lines) -> list[str]:
    line = find_key(primary, "UsePitchAct")
    is_used = line and primary[line].split()[0].strip("\"'").lower() in ("true", "t")
    return ["the pitch actuator (UsePitchAct) was left out: the root is clamped"] if is_used else []


def read_damping(blade: Lines) -> tuple[Array | None, list[str]]:
    """Seconds by strain, in gxrod's order, or None; and warnings. Older files say damp_flag."""
    header = blade.find(lambda line: line.split()[:2] == ["mu1", "mu2"])
    key = next((key for key in ("damp_type", "damp_flag") if find_key(blade, key)), "")
    if not key:
        return None, ["the blade file has no damp_type: the blade is not damped" + (", though it has mu1 … mu6" if header else "")]
    kind = read_count(blade, key)
    if kind == 0:
        return None, []
    if kind != 1:
        return None, ["modal damping (damp_type 2) was left out: gxrod damps by strains"]
    if not header:
        raise blade.fault("there is no line mu1 mu2 …, which the damping follows", "give a whole blade file of BeamDyn", 0)
    blade.at = header + 2
    return in_gxrod_order(blade.numbers(6, "mu1 … mu6")), []


def in_gxrod_order(mu: Array | list[float]) -> Array:
    """Six numbers by BeamDyn's axes, by gxrod's."""
    return np.asarray(np.kron(np.eye(2), FROM_BEAMDYN) @ np.asarray(mu, dtype=float))


