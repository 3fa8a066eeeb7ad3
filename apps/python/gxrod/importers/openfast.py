"""OpenFAST: the input file of ElastoDyn, or the .fst file that names it, as a turbine: tower, nacelle, shaft, hub and blades, of ElastoDyn or BeamDyn."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ..typed import AnyPath
from .blade import Blade, check_blade
from .elastodyn import mass_of, note_of_bending, read_elastodyn, stiffness_of, value_of
from .text import Lines, find_beside
from .turbine import Turbine

# Keys of ElastoDyn that are read. Of blades, those of blade 1 count.
USED = ("NumBl", "TipRad", "HubRad", "PreCone(1)", "HubCM", "OverHang", "ShftTilt", "NacCMxn", "NacCMyn", "NacCMzn", "Twr2Shft", "TowerHt", "TowerBsHt", "TipMass(1)", "HubMass", "HubIner", "NacMass", "NacYIner",
        "YawBrMass", "BldFile(1)", "TwrFile", "DTTorSpr", "DTTorDmp", "BlPitch(1)", "Azimuth", "AzimB1Up", "RotSpeed", "NacYaw")
# Numbers that change the results if they are not 0.
LEFT_OUT = ("PtfmMass", "PtfmRIner", "PtfmPIner", "PtfmYIner", "PtfmXYIner", "PtfmYZIner", "PtfmXZIner", "PtfmSurge", "PtfmSway", "PtfmHeave", "PtfmRoll", "PtfmPitch", "PtfmYaw", "UndSling", "Delta3", "TeetDefl",
            "TeetMod", "OoPDefl", "IPDefl", "TTDspFA", "TTDspSS", "HubIner_Teeter", "PBrIner(1)", "BlPIner(1)")


def is_openfast(text: str) -> bool:
    """Whether it is a .fst file or ElastoDyn's primary file."""
    return is_fst(text) or "TowerBsHt" in text and "TwrFile" in text and "OverHang" in text


def is_fst(text: str) -> bool:
    return "CompElast" in text and "EDFile" in text


def read_turbine(path: AnyPath, blade: Blade | None = None) -> Turbine:
    """A turbine from a .fst file of OpenFAST or ElastoDyn's primary file. `blade`: in place of the blades that it names.

    Raises FileError, with file, line, what was expected and what to do.
    """
    from .formats import read_blade  # which knows this file
    main, named = read_primary(path)
    number = lambda key, default=None: value_of(main, key, default, what=WHOLE)
    length = length_of(main)
    if blade is None:
        blade = read_blade(named) if named else read_elastodyn(file_of(main, "BldFile(1)", "BldFile1"), length)
    elif abs(blade.length / length - 1.0) > 0.01:
        blade.warnings.append(f"the blade is {blade.length:g} m long, and TipRad − HubRad of {main.path.name} is {length:g} m")
    tower = read_tower(file_of(main, "TwrFile"), number("TowerBsHt"), number("TowerHt"))
    return place(main, tower, blade)


def read_blade_length(path: AnyPath) -> float:
    """Of the blades of a .fst file of OpenFAST or ElastoDyn's primary file, in m."""
    return length_of(read_primary(path)[0])


def read_primary(path: AnyPath) -> tuple[Lines, Path | None]:
    """ElastoDyn's primary file, and BeamDyn's file if that has the blades."""
    main = Lines(path)
    if not is_fst("\n".join(main.lines)):
        return main, None
    named = file_of(main, "BDBldFile(1)") if value_of(main, "CompElast", what=WHOLE) == 2 else None
    return Lines(file_of(main, "EDFile")), named


def length_of(main: Lines) -> float:
    length = value_of(main, "TipRad", what=WHOLE) - value_of(main, "HubRad", what=WHOLE)
    if length <= 0.0:
        raise main.fault(f"TipRad − HubRad is {length:g}; expected more than 0", "correct them", line_of(main, "TipRad"))
    return length


WHOLE = "give a whole primary file of ElastoDyn"


def place(main: Lines, tower: Blade, blade: Blade) -> Turbine:
    """The turbine with its bodies and angles."""
    number = lambda key, default=None: value_of(main, key, default, what=WHOLE)
    angle = lambda key, default=None: float(np.radians(number(key, default)))
    for key in ("NacMass", "NacYIner", "HubMass", "HubIner"):
        if number(key) <= 0.0:
            raise main.fault(f"{key} is {number(key):g}; expected more than 0", "give the body's", line_of(main, key))
    centre = np.array([number("NacCMxn"), number("NacCMyn"), number("NacCMzn")])
    inertia = number("NacYIner") - number("NacMass") * float(centre[0] ** 2 + centre[1] ** 2)
    if inertia <= 0.0:
        raise main.fault(f"NacYIner is that of a nacelle with {inertia:g} about its own centre of mass; expected NacYIner above NacMass (NacCMxn² + NacCMyn²)", "correct it", line_of(main, "NacYIner"))
    count = int(number("NumBl"))
    return Turbine(title=main.lines[1].strip(), source=f"OpenFAST: {main.path.name}; {tower.source}; {blade.source}", tower=tower, blade=blade, blades=count, base=number("TowerBsHt"),
                   twr2shft=number("Twr2Shft"), overhang=number("OverHang"), tilt=angle("ShftTilt"), cone=angle("PreCone(1)"), hub_radius=number("HubRad"),
                   nacelle_mass=number("NacMass"), nacelle_centre=centre, nacelle_inertia=number("NacYIner"), hub_mass=number("HubMass"), hub_centre=number("HubCM"),
                   hub_inertia=number("HubIner"), yaw=angle("NacYaw", 0.0), azimuth=angle("Azimuth", 0.0) - angle("AzimB1Up", 0.0), pitch=angle("BlPitch(1)", 0.0),
                   speed=number("RotSpeed", 0.0) * np.pi / 30.0, yaw_bearing_mass=number("YawBrMass", 0.0), tip_mass=number("TipMass(1)", 0.0),
                   shaft_stiffness=number("DTTorSpr", 0.0), shaft_damping=number("DTTorDmp", 0.0), notes=assumed(), warnings=[*unlike(main, count), *left_out(main)])


def assumed() -> list[str]:
    return ["of nacelle and hub ElastoDyn has the inertia about one axis; the other two are half of it", "the tower is clamped at its base, TowerBsHt",
            "not used: GenIner and GBRatio, as the generator is held, or turns at a constant speed; ElastoDyn's degrees of freedom, scheme and output",
            "not imported: aerodynamics, hydrodynamics, moorings and controllers (AeroDyn, InflowWind, HydroDyn, SubDyn, MoorDyn, ServoDyn)"]


def unlike(main: Lines, count: int) -> list[str]:
    """Warnings of blades that differ from blade 1."""
    found = []
    for key, kind in (("PreCone", "cone angles"), ("BlPitch", "pitch angles"), ("TipMass", "tip masses")):
        values = [value_of(main, f"{key}({i})", 0.0, what=WHOLE) for i in range(1, count + 1)]
        if len(set(values)) > 1:
            found.append(f"the {kind} {', '.join(f'{each:g}' for each in values)} differ; all blades have that of blade 1")
    if len({text_after(main, f"BldFile({i})", f"BldFile{i}") for i in range(1, count + 1)}) > 1:
        found.append("the blades have different files; all have that of blade 1")
    return found


def left_out(main: Lines) -> list[str]:
    """A warning of what a deck does not get, where it is not 0."""
    idle = [key for key in LEFT_OUT if value_of(main, key, 0.0, what=WHOLE)]
    return [f"not used: {', '.join(idle)}"] if idle else []


def read_tower(path: Path, base: float, top: float) -> Blade:
    """ElastoDyn's tower file: y of its sections is fore-aft (downwind), z side to side."""
    lines = Lines(path)
    length = top - base
    if length <= 0.0:
        raise lines.fault(f"the tower is {length:g} m long, TowerHt − TowerBsHt; expected more than 0", "correct ElastoDyn's primary file", 0)
    header = lines.find(lambda line: "HtFract" in line and "TMassDen" in line)
    names = lines[header].split() if header else []
    if missing := [name for name in ("HtFract", "TMassDen", "TwFAStif", "TwSSStif") if name not in names]:
        raise lines.fault(f"there is no column {missing[0]}", "give a tower file of ElastoDyn", header)
    count = int(value_of(lines, "NTwInpSt", what="give a whole tower file of ElastoDyn"))
    lines.at = header + 2  # a line of units
    table = np.array([lines.numbers(len(names), f"row {i + 1} of {count}") for i in range(count)])
    first = lines.at - count
    factor = lambda key: value_of(lines, key, 1.0)
    column = lambda name, scale: table[:, names.index(name)] * factor(scale)
    mass, fore_aft, side = column("TMassDen", "AdjTwMa"), column("TwFAStif", "AdjFASt"), column("TwSSStif", "AdjSSSt")
    fractions = table[:, names.index("HtFract")]
    damped = any(value_of(lines, f"Twr{way}Dmp({i})", 0.0) for way in ("FA", "SS") for i in (1, 2))
    tuned = any(value_of(lines, f"{way}StTunr({i})", 1.0) != 1.0 for way in ("FA", "SS") for i in (1, 2))
    return check_blade(Blade(title="", source=lines.path.name, fractions=fractions, stiffness=stiffness_of(fore_aft, side, length), mass=mass_of(mass, length),
                             points=np.array([[0.0, 0.0, 0.0], [0.0, 0.0, length]]), twist_fractions=np.array([0.0, 1.0]), twist=np.zeros(2),
                             notes=[note_of_bending()], warnings=(["damping by mode (TwrFADmp, TwrSSDmp) was left out"] if damped else []) + (["the factors FAStTunr, SSStTunr were left out"] if tuned else [])),
                       lambda i, what, todo: lines.fault(what, todo, first + i))


def line_of(lines: Lines, *keys: str) -> int:
    """The line of `value key - …`, where the value may be several words; 0 without it."""
    return lines.find(lambda text: any(key in text.split(" - ")[0].split()[1:] for key in keys))


def text_after(lines: Lines, *keys: str) -> str:
    """The quoted, or first, word of a key's line; "" without it."""
    text = lines[line_of(lines, *keys)].strip() if line_of(lines, *keys) else ""
    return text.split(text[0])[1] if text[:1] in ("'", '"') else text.split()[0] if text else ""


def file_of(lines: Lines, *keys: str) -> Path:
    line = line_of(lines, *keys)
    if not line:
        raise lines.fault(f"there is no line with {keys[0]}", "give a whole input file of OpenFAST", 0)
    found, tried = find_beside(text_after(lines, *keys), [lines.path.parent])
    if found is None:
        raise lines.fault(f"the file {text_after(lines, *keys)} of {keys[0]} is not there (tried {', '.join(map(str, tried))})", "put it there, or correct the name", line)
    return found
