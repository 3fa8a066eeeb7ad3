"""MoorDyn's input file of version 2: line types, points, lines and options. Columns are known by their order, as in MoorDyn."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from ..typed import AnyPath, Array
from .mooring import Body, Line, LineType, Mooring, Place, Vector
from .moordyn_bodies import completed, cylinder, euler_rotation, joined, point_mass, rotation_vector_of
from .moordyn_ground import read_ground
from .text import Lines, UnusedKeys, find_beside, read_text, to_number

SECTIONS = {"types": ("LINE TYPES", "LINE DICTIONARY"), "rod types": ("ROD TYPES", "ROD DICTIONARY"), "bodies": ("BODIES", "BODY LIST", "BODY PROPERTIES"),
            "rods": ("RODS", "ROD LIST", "ROD PROPERTIES"), "points": ("POINTS", "POINT LIST", "POINT PROPERTIES", "CONNECTION PROPERTIES", "NODE PROPERTIES"),
            "lines": ("LINES", "LINE LIST", "LINE PROPERTIES"), "options": ("OPTIONS", "SOLVER OPTIONS"), "outputs": ("OUTPUT", "OUTPUTS")}
KINDS = {"fixed": ("fixed", "fix", "anchor"), "coupled": ("coupled", "cpld", "vessel", "ves", "fairlead"), "free": ("free", "connect", "con", "point")}
# Names in MoorDyn's spelling; capitals do not count.
OPTIONS = {"gravity": ("g", "gravity"), "density": ("WtrDnsty", "rho", "rhoW"), "depth": ("WtrDpth",), "ground_stiffness": ("kBot", "kb"), "ground_damping": ("cBot", "cb"),
           "friction": ("FrictionCoefficient",), "ground": ("SeafloorFile",)}
# Options of MoorDyn's time steps, of its way to the start and of its output.
NOT_NEEDED = ("dtM", "CFL", "tScheme", "writeLog", "WriteUnits", "dtOut", "dtIC", "ICdt", "TmaxIC", "ICTmax", "CdScaleIC", "ICDfac", "threshIC", "ICthresh", "ICgenDynamic", "GenDynamicIC", "fileIC", "ICfile",
              "dtWave", "WaveKin_rampT", "UnifyCurrentGrid", "disableOutput", "disableOutTime", "inertialF", "inertialF_rampT", "Echo", "FricDamp", "CV")
# Options that change the results unless they have the value that stands here, and what to do.
LACKING = {"WaveKin": ("0", "waves were left out; add them as [[wave]]"), "Currents": ("0", "currents were left out; add them to [fluid]"),
           "WaterKin": ("0", "waves and currents were left out; add them as [[wave]] and to [fluid]"),
           "StatDynFricScale": ("1", "friction has one coefficient here, at rest and sliding"), "MC": ("1", "friction has one coefficient here, at rest and sliding"),
           "mu_kT": ("0", "friction was left out; give [seabed] friction = { axial = …, lateral = … }"), "mu_kA": ("0", "friction was left out; give [seabed] friction = { axial = …, lateral = … }")}
DEFAULTS = {"gravity": 9.80665, "density": 1025.0, "depth": 0.0, "ground_stiffness": 3.0e6, "ground_damping": 3.0e5, "friction": 0.0}
OLD_ORDER = ["can", "cat", "cdn", "cdt"]  # names of version 1, also found over files of version 2


@dataclass
class Row:
    """Words of a line of a table, and where it stands."""

    words: list[str]
    line: int


def is_moordyn(text: str) -> bool:
    return bool(re.search(r"^-{3,}\s*LINE (TYPES|DICTIONARY)", text, re.MULTILINE | re.IGNORECASE))


def read_moordyn(path: AnyPath) -> Mooring:
    """The lines of a MoorDyn file (version 2), with water and ground.

    Bodies and rods that are free are rigid bodies. Not read: waves and currents, failures. Lines on other bodies and rods are held where these are. `notes` and `warnings`
    say what was left out; `warnings` what changes the results.

    Raises FileError, with file, line, what was expected and what to do.
    """
    return Reader(Lines(path)).read()


class Reader:
    def __init__(self, lines: Lines) -> None:
        self.lines = lines
        self.notes: list[str] = []
        self.warnings: list[str] = []
        self.bodies: dict[str, Body] = {}  # free ones, by their numbers, and free rods
        self.ground_row: Row | None = None
        self.ground: Array | None = None
        self.tables = self.find_tables()

    def read(self) -> Mooring:
        options = self.read_options()
        self.ground = self.read_ground_file()
        types = {row.words[0]: self.read_type(row) for row in self.need("types")}
        for name in ("points", "lines", "bodies", "rods"):
            self.refuse_twins(self.rows(name))
        places = self.read_places(options["density"])
        found = [self.read_line(row, types, places) for row in self.need("lines")]
        options["depth"] = max(options["depth"], *(-place.at[2] for line in found for place in line.ends)) if self.ground is None else float(-self.ground[:, 2].min())
        self.warn_of_idle(found, places)
        self.warn_of_no_ground(options)
        title = next((text.strip() for text in self.lines.lines if text.strip() and not text.startswith("---")), "Mooring lines")
        bodies = [self.complete(body, options["density"]) for body in self.bodies.values() if any(place.body == body.name for line in found for place in line.ends)]
        return Mooring(title=title, source=f"MoorDyn: {self.lines.path.name}", lines=found, notes=list(dict.fromkeys(self.notes)), bodies=bodies, warnings=list(dict.fromkeys(self.warnings)),
                       ground=self.ground, **options)

    def refuse_twins(self, rows: list[Row]) -> None:
        found: dict[str, int] = {}
        for row in rows:
            if row.words[0] in found:
                raise self.fault(row, f"the ID {row.words[0]} stands in line {found[row.words[0]]}, too", "give each row of a table its own ID")
            found[row.words[0]] = row.line

    def warn_of_idle(self, lines: list[Line], places: dict[str, Place]) -> None:
        """Points and bodies that no line ends on, and weights that no line feels."""
        used = {place.name for line in lines for place in line.ends}
        carriers = {place.body for line in lines for place in line.ends}
        idle = [place.name for place in places.values() if place.name not in used and not place.body and place.kind == "free"]
        idle += [name for name in (body.name for body in self.bodies.values()) if name not in carriers]
        if idle:
            self.warnings.append(f"free points and bodies without lines were left out: {', '.join(idle)}")
        held = [place.name for place in places.values() if place.kind in ("fixed", "coupled") and (place.mass or place.volume or place.drag_area)]
        if held:
            self.notes.append(f"mass, volume and drag of points that are held were left out; no line feels them: {', '.join(held)}")

    def warn_of_no_ground(self, options: dict[str, float]) -> None:
        if options["depth"] > 0.0 and options["ground_stiffness"] == 0.0:
            self.warnings.append("kBot is 0: the ground holds nothing, and was left out")
        if options["density"] == 0.0:
            self.notes.append("the density of water is 0: the lines hang in air, without drag")

    # Tables

    def find_tables(self) -> dict[str, list[Row]]:
        tables: dict[str, list[Row]] = {}
        rows: list[Row] = []
        for i, text in enumerate(self.lines.lines, 1):
            if "---" in text:
                rows = self.open_table(text.strip("- \t"), tables)
            elif words := re.split(r"[!#%]", text)[0].split() if not is_units(text) else []:
                rows.append(Row(words, i))
        return tables

    def open_table(self, heading: str, tables: dict[str, list[Row]]) -> list[Row]:
        name = next((name for name, headings in SECTIONS.items() if heading.upper() in headings), "")
        if not name and heading and "moordyn" not in heading.lower() and "need this line" not in heading.lower():
            self.warnings.append(f"the section {heading} was left out")
        return tables.setdefault(name, []) if name else []

    def need(self, name: str) -> list[Row]:
        """The rows of a table without its head."""
        if not (rows := self.tables.get(name, [])[1:]):
            raise self.lines.fault(f"there is no section {SECTIONS[name][0]} with rows", "give a whole input file of MoorDyn, version 2", 0)
        return rows

    def rows(self, name: str) -> list[Row]:
        return self.tables.get(name, [])[1:]

    def fault(self, row: Row, message: str, todo: str) -> Exception:
        return self.lines.fault(message, todo, row.line)

    def number(self, row: Row, column: int, what: str) -> float:
        if len(row.words) <= column:
            raise self.fault(row, f"expected {column + 1} columns or more ({what}), found {len(row.words)}", "correct this line; files of MoorDyn's version 1 have others")
        value = to_number(row.words[column])
        if value is None:
            raise self.fault(row, f'expected a number for {what}, found "{row.words[column][:40]}"', "give a number in SI units")
        return value

    def read_options(self) -> dict[str, float]:
        """Those that a deck uses. Others are named, each once."""
        options = dict(DEFAULTS)
        unused = UnusedKeys("option", [*(name for names in OPTIONS.values() for name in names), *LACKING], NOT_NEEDED)
        for row in self.tables.get("options", []):
            name = row.words[1] if len(row.words) > 1 else ""
            key = next((key for key, names in OPTIONS.items() if name.lower() in map(str.lower, names)), "")
            lacking = next((each for each in LACKING if each.lower() == name.lower()), "")
            if not name:
                self.warnings.append(f'line {row.line} of the options, "{row.words[0][:40]}", names no option and was not used')
            elif key == "ground" or key == "depth" and to_number(row.words[0]) is None:
                self.ground_row = row
            elif key:
                options[key] = self.number(row, 0, name)
                if options[key] < 0.0:
                    raise self.fault(row, f"{name} is below 0", "give a number of 0 or more")
            elif lacking:
                without, words = LACKING[lacking]
                if row.words[0].lower() not in (without, without + ".0", "none", "false"):
                    self.warnings.append(f"{words} (option {name} is {row.words[0]})")
            else:
                unused.add(name)
        self.notes += unused.notes("MoorDyn's time steps, its way to the start and its output")
        self.warnings += unused.warnings()
        return options

    def read_ground_file(self) -> Array | None:
        """Heights of a file of the ground, x, y, z [n,3]; None without one."""
        if self.ground_row is None:
            return None
        named = self.ground_row.words[0]
        folder = self.lines.path.resolve().parent
        found, tried = find_beside(named, [folder, *folder.parents[:2]])
        if found is None:
            self.warnings.append(f"the ground by the file {named} was left out, as the file is not there (tried {', '.join(map(str, tried))}); the ground is level, at the deepest point")
            return None
        return read_ground(found)

    # Line types

    def read_type(self, row: Row) -> LineType:
        head = [word.lower() for word in self.tables["types"][0].words]
        columns = ("Diam", "Mass/m", "EA", "BA/-zeta", "EI", "Cd", "Ca", "CdAx", "CaAx")
        EA, stretch = self.stiffness(row)
        damping = self.number(Row([*row.words[:4], row.words[4].split("|")[0], *row.words[5:]], row.line), 4, "BA/-zeta") if len(row.words) > 4 else 0.0
        diameter, mass, _, _, EI, *coefficients = (EA if i == 3 else damping if i == 4 else self.number(row, i, name) for i, name in enumerate(columns, 1))
        Cd, Ca, CdAx, CaAx = coefficients
        if head[-4:] == OLD_ORDER:
            Ca, CaAx, Cd, CdAx = coefficients
            self.notes.append("columns of line types were read as the file names them, Can Cat Cdn Cdt; MoorDyn 2 reads Cd Ca CdAx CaAx in that place")
        if min(diameter, mass, EA) <= 0.0 or EI < 0.0:
            raise self.fault(row, "diameter, mass and EA must be above 0, EI not below", "correct this line")
        if damping < 0.0:
            self.notes.append("damping by a ratio (BA/-zeta below 0) was left out: it damps the segments of MoorDyn's mesh")
        if len(row.words) > 10 and to_number(row.words[10]):
            self.warnings.append("the lift by vortices (Cl) was left out")
        return LineType(row.words[0], diameter, mass, EA, EI, max(damping, 0.0), (Cd, CdAx), (Ca, CaAx), stretch=stretch)

    def stiffness(self, row: Row) -> tuple[float, list[tuple[float, float]]]:
        """EA; of a file of strains and tensions its first slope, and its rows."""
        if len(row.words) > 3 and "|" in row.words[3]:
            self.warnings.append(f'of the stiffnesses "{row.words[3]}" of {row.words[0]} the first one was taken, the static one; see `law` for ropes that relax')
            row = Row([*row.words[:3], row.words[3].split("|")[0]], row.line)
        if len(row.words) > 3 and to_number(row.words[3]) is None:
            rows = self.read_stretch(row)
            return rows[1][1] / rows[1][0], rows
        return self.number(row, 3, "EA"), []

    def read_stretch(self, row: Row) -> list[tuple[float, float]]:
        """Rows (strain, tension) from (0, 0) on, of a file whose first two lines are a head."""
        folder = self.lines.path.resolve().parent
        found, tried = find_beside(row.words[3], [folder, *folder.parents[:2]])
        if found is None:
            raise self.fault(row, f'EA is neither a number nor a file of strains and tensions: "{row.words[3][:40]}" is not there (tried {", ".join(map(str, tried))})', "give one of them")
        words = [line.split() for line in read_text(found).splitlines()[2:] if line.strip()]
        numbers = [[to_number(word) for word in each[:2]] for each in words]
        rows = [(each[0], each[1]) for each in numbers if len(each) == 2 and each[0] is not None and each[1] is not None]
        rises = all(a[0] < b[0] and a[1] <= b[1] for a, b in zip(rows, rows[1:]))
        if len(rows) != len(words) or len(rows) < 2 or rows[0] != (0.0, 0.0) or rows[1][1] <= 0.0 or not rises:
            raise self.fault(row, f"{row.words[3]}: expected two lines of a head, then rows of a strain and a tension that rise from 0 0", "correct the file")
        return rows

    # Points, and what else lines end on

    def read_places(self, density: float) -> dict[str, Place]:
        rows = {row.words[0]: row for row in self.rows("bodies")}
        self.bodies = {number: self.read_body(row, density) for number, row in rows.items() if self.word_kind(row, row.words[1]) == "free"}
        places = {row.words[0]: self.read_point(row, rows, density) for row in self.rows("points")}
        for row in self.rows("rods"):
            places.update(self.read_rod(row, rows, density))
        return places

    def read_body(self, row: Row, density: float) -> Body:
        """A free one; of the coefficients only translation's."""
        centre, inertia, area, added = (self.several(row, column, what) for column, what in ((9, "CG"), (10, "I"), (12, "CdA"), (13, "Ca")))
        if len(area) in (2, 6) and any(area[len(area) // 2:]) or len(area) in (1, 3) and any(area):
            self.warnings.append(f"drag that resists turns was left out, of body {row.words[0]} (the numbers of CdA for rotations)")
        volume = self.number(row, 11, "Volume")
        along = three(area[:1] if len(area) == 2 else area)
        water = three(added[:1] if len(added) == 2 else added)
        return Body(f"body{row.words[0]}", self.place_of(row, 2), self.number(row, 8, "Mass"), three(inertia), (0.0, 0.0, centre[0]) if len(centre) == 1 else three(centre), volume, along,
                    scaled(water, density * volume), rotation_vector=rotation_vector_of(self.axes_of(row)), line=row.line)

    def axes_of(self, row: Row) -> Array:
        """Columns: the axes of a body, by its angles in degrees."""
        roll, pitch, yaw = (self.number(row, i, "an angle of the body") for i in (5, 6, 7))
        return euler_rotation(*np.radians((roll, pitch, yaw)).tolist())

    def on_body(self, row: Row, at: Vector) -> Vector:
        """The global place of a point in the axes of a body."""
        x, y, z = (np.array(self.place_of(row, 2)) + self.axes_of(row) @ np.array(at)).tolist()
        return x, y, z

    def several(self, row: Row, column: int, what: str) -> list[float]:
        """One number, or several of the form a|b|c."""
        words = row.words[column].split("|") if len(row.words) > column else [""]
        return [self.number(Row([*row.words[:column], word], row.line), column, what) for word in words]

    def complete(self, body: Body, density: float) -> Body:
        body, note = completed(body, density)
        self.notes += [note] if note else []
        return body

    def read_point(self, row: Row, bodies: dict[str, Row], density: float) -> Place:
        if len(row.words) >= 12 and any(to_number(word) for word in row.words[7:10]):
            self.warnings.append(f"the force on point {row.words[0]} was left out; add a [[load]]")
        last = 10 if len(row.words) >= 12 else 7
        at = self.place_of(row, 2)
        mass, volume, drag_area, added_mass = (self.number(row, i, name) for i, name in ((5, "Mass"), (6, "Volume"), (last, "CdA"), (last + 1, "Ca")))
        kind, on = self.kind_of(row, row.words[1], bodies)
        if on and (body := self.bodies.get(on.words[0])):
            at = self.on_body(on, at)
            self.bodies[on.words[0]] = joined(body, point_mass(at, mass, volume, drag_area, added_mass, density))
            return Place(f"point{row.words[0]}", "free", at, body=body.name)
        if on:
            return Place(f"point{row.words[0]}", kind, self.on_body(on, at))
        return Place(f"point{row.words[0]}", kind, at, mass, volume, drag_area, added_mass)

    def read_rod(self, row: Row, bodies: dict[str, Row], density: float) -> dict[str, Place]:
        """Its ends: a free one without length is a rigid corner of lines, others that are free are bodies, the rest are held."""
        number = row.words[0]
        ends = (self.place_of(row, 3), self.place_of(row, 6))
        kind, on = self.kind_of(row, row.words[2], bodies)
        if kind == "free" and not on and ends[0] == ends[1]:
            end = Place(f"rod{number}", "corner", ends[0])
            return {f"R{number}A": end, f"R{number}B": end}
        ends = (self.on_body(on, ends[0]), self.on_body(on, ends[1])) if on else ends
        carrier = on.words[0] if on and on.words[0] in self.bodies else f"rod {number}" if kind == "free" else ""
        if carrier:
            self.carry(row, carrier, ends, density)
            return {f"R{number}{name}": Place(f"rod{number}{name}", "corner", end, body=self.bodies[carrier].name) for name, end in zip("AB", ends)}
        moves = "" if kind == "fixed" else ", though it moves in MoorDyn"
        (self.warnings if moves else self.notes).append(f"rod {number} of MoorDyn was left out; lines on it are clamped where its ends are, as they leave these at first{moves}")
        return {f"R{number}{name}": Place(f"rod{number}{name}", "clamped", end) for name, end in zip("AB", ends)}

    def carry(self, row: Row, carrier: str, ends: tuple[Vector, Vector], density: float) -> None:
        """A rod as a part of a free body, or as a body of its own."""
        if "pin" in row.words[2].lower():
            self.warnings.append(f"rod {row.words[0]} is fixed to its body, though it turns on it in MoorDyn")
        type_row = next((each for each in self.rows("rod types") if each.words[0] == row.words[1]), None)
        if type_row is None:
            raise self.fault(row, f'there is no rod type "{row.words[1]}"', f"give one of {', '.join(each.words[0] for each in self.rows('rod types'))}")
        diameter, mass, Cd, Ca, CdEnd, CaEnd = (self.number(type_row, i, name) for i, name in enumerate(("Diam", "Mass/m", "Cd", "Ca", "CdEnd", "CaEnd"), 1))
        if ends[0] == ends[1]:
            return
        part = cylinder(f"rod{row.words[0]}", ends, diameter, mass, (Cd, CdEnd), (Ca, CaEnd), density)
        self.bodies[carrier] = joined(self.bodies[carrier], part) if carrier in self.bodies else part

    def word_kind(self, row: Row, word: str) -> str:
        kind = next((kind for kind, names in KINDS.items() if re.sub(r"pin(ned)?$", "", word.lower()) in names), "")
        if not kind and not word.lower().startswith("pin"):
            raise self.fault(row, f'expected Fixed, Coupled, Free or a body, found "{word[:40]}"', "correct this line")
        return kind or "fixed"

    def kind_of(self, row: Row, word: str, bodies: dict[str, Row]) -> tuple[str, Row | None]:
        """Of an attachment, and the body that it names."""
        if match := re.fullmatch(r"body(\d+)(pin(ned)?)?", word.lower()):
            if match[1] not in bodies:
                raise self.fault(row, f"there is no body {match[1]}", "add it to the section BODIES")
            body = bodies[match[1]]
            if match[1] not in self.bodies:
                self.notes.append(f"body {match[1]} of MoorDyn was left out; lines on it are held where it is")
            return self.word_kind(body, body.words[1]), body
        return self.word_kind(row, word), None

    def place_of(self, row: Row, column: int) -> tuple[float, float, float]:
        x, y, z = (self.number(row, column + i, f"the place {name}") for i, name in enumerate("XYZ"))
        return x, y, z

    # Lines

    def read_line(self, row: Row, types: dict[str, LineType], places: dict[str, Place]) -> Line:
        length, segments = self.number(row, 4, "UnstrLen"), self.number(row, 5, "NumSegs")
        if row.words[1] not in types:
            raise self.fault(row, f'there is no line type "{row.words[1]}"', f"give one of {', '.join(types)}")
        if length <= 0.0 or segments < 1 or segments != int(segments):
            raise self.fault(row, "UnstrLen must be above 0 and NumSegs a whole number from 1", "correct this line; files of MoorDyn's version 1 have other columns")
        ends = [places.get(re.sub(r"^(CON|C|P|POINT)(?=\d)", "", word.upper())) for word in row.words[2:4]]
        if None in ends:
            raise self.fault(row, f'there is no point "{row.words[2 + ends.index(None)]}"', f"give one of {', '.join(places)}")
        return Line(f"line{row.words[0]}", types[row.words[1]], (ends[0], ends[1]), length, int(segments), row.line)


def is_units(text: str) -> bool:
    """Whether a line has units in brackets alone, as the second one of tables."""
    return bool(re.fullmatch(r"(\s*\([^)]*\))+\s*", text))


def three(values: list[float]) -> Vector:
    """Along x, y and z: one number is that of all."""
    x, y, z = (values * 3)[:3] if len(values) < 3 else values[:3]
    return x, y, z


def scaled(values: Vector, factor: float) -> Vector:
    x, y, z = values
    return x * factor, y * factor, z * factor
