"""The command line of gxrod-import."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from ..errors import FileError
from .formats import FORMATS, SECTIONS, find_format, read_blade, read_section_mesh
from .moordyn import read_moordyn
from .mooring_deck import write_mooring
from .moorprops import read_moorprops, write_section
from .openfast import read_blade_length, read_turbine
from .section_mesh import SectionMesh
from .section_writing import write_section_mesh
from .text import ImportFault
from .turbine_deck import write_turbine
from .windio_layup import read_windio_layup
from .writing import write_deck

EPILOG = """\
examples:
  gxrod-import NREL5MW_BeamDyn.dat -o blade.toml             the primary file of BeamDyn, which names the blade file
  gxrod-import IEA-15-240-RWT.yaml -o blade.toml             windIO
  gxrod-import IEA-15-240-RWT.yaml --layup 0.5 -o half.toml  windIO: a section by its layers and webs, with its mesh
  gxrod-import IEA_15MW.htc --body blade1 -o blade.toml      HAWC2
  gxrod-import ElastoDyn_blade.dat --length 117 -o blade.toml
  gxrod-import turbine.fst -o turbine.toml                   OpenFAST: tower, nacelle, hub and blades
  gxrod-import lines.txt -o lines.toml                       MoorDyn
  gxrod-import MoorProps_default.yaml --line chain --diameter 0.1 -o section.toml
  gxrod-import box.sg -o box.toml                            VABS, PreVABS, SONATA: a section with its mesh, box.msh
  gxrod-import station_12/ -o station_12.toml                BECAS: the folder with N2D.in

exit codes: 0 done, 2 usage or a fault in a file, 4 a file could not be read or written"""


def main(arguments: Sequence[str] | None = None) -> int:
    request = parse(sys.argv[1:] if arguments is None else arguments)
    request.output = request.output or (Path(request.file).stem or "section") + ".toml"
    try:
        kind = request.format or find_format(request.file)
        if request.layup is not None and kind != "windio":
            raise ImportFault(f"{request.file}: --layup is for windIO files, this is of the format {kind}; leave it out")
        written = import_layup(request) if request.layup is not None else {"openfast": import_turbine, "moordyn": import_lines, "moorpy": import_section, **dict.fromkeys(SECTIONS, import_section_mesh)}.get(kind, import_blade)(request)
    except FileError as error:
        print(f"gxrod-import: {error}", file=sys.stderr)
        return 2 if isinstance(error, ImportFault) else 4
    for path in written:
        print(path)
    return 0


def import_blade(request: argparse.Namespace) -> list[Path]:
    blade = read_blade(request.file, request.format, blade_file=request.blade, st_file=request.st, body=request.body, chosen=request.set and tuple(request.set), length=request.length)
    written = write_deck(blade, request.output, inline=request.inline)
    print(f"{len(blade.fractions)} stations, {blade.length:.6g} m, {blade.total_mass:.6g} kg ({blade.source})")
    say(blade.notes, blade.warnings)
    return written


def import_turbine(request: argparse.Namespace) -> list[Path]:
    if request.inline:
        raise ImportFault(f"{request.file}: --inline is for blades, this is a turbine; leave it out")
    blade = None
    if request.blade:
        blade = read_blade(request.blade, body=request.body, st_file=request.st, chosen=request.set and tuple(request.set), length=request.length or read_blade_length(request.file))
    turbine = read_turbine(request.file, blade)
    written = write_turbine(turbine, request.output)
    print(f"tower {turbine.tower.length:.6g} m, {turbine.blades} blades of {turbine.blade.length:.6g} m, {turbine.total_mass:.6g} kg, the rotor {turbine.rotor_mass:.6g} kg ({turbine.source})")
    say([*turbine.notes, *turbine.blade.notes], [*turbine.warnings, *(f"{name}: {each}" for name, kind in (("tower", turbine.tower), ("blade", turbine.blade)) for each in kind.warnings)])
    return written


def import_lines(request: argparse.Namespace) -> list[Path]:
    mooring = read_moordyn(request.file)
    written = write_mooring(mooring, request.output)
    print(f"{len(mooring.lines)} lines of {len(mooring.types)} types, {sum(line.length for line in mooring.lines):.6g} m ({mooring.source})")
    say(mooring.notes, mooring.warnings)
    return written


def say(notes: list[str], warnings: list[str]) -> None:
    """What was left out or assumed; warnings change the results."""
    for kind, texts in (("note", notes), ("warning", warnings)):
        for text in texts:
            print(f"{kind}: {text}", file=sys.stderr)


def import_section(request: argparse.Namespace) -> list[Path]:
    if request.line is None or request.diameter is None:
        raise ImportFault(f"{request.file}: MoorPy's library has many materials, of any diameter; give --line NAME --diameter D")
    kind = read_moorprops(request.file, request.line, request.diameter)
    written = write_section(kind, request.output, source=f"MoorPy: {Path(request.file).name}, nominal diameter {request.diameter:g} m")
    say(kind.notes, [])
    print(f"{kind.name}, {kind.mass:.6g} kg/m, EA {kind.EA:.6g} N, volume-equivalent diameter {kind.diameter:.6g} m")
    return written


def import_section_mesh(request: argparse.Namespace) -> list[Path]:
    return put_section_mesh(read_section_mesh(request.file, request.format), request)


def import_layup(request: argparse.Namespace) -> list[Path]:
    return put_section_mesh(read_windio_layup(request.file, request.layup), request)


def put_section_mesh(section: SectionMesh, request: argparse.Namespace) -> list[Path]:
    written = write_section_mesh(section, request.output)
    print(f"{len(section.elements)} elements of {len(section.layers)} layers, {section.extent:.6g} across ({section.source})")
    say(section.notes, section.warnings)
    return written


def parse(arguments: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="gxrod-import", description="Writes a blade, a turbine, mooring lines or a section of another program as a deck of gxrod.", epilog=EPILOG,
                                     allow_abbrev=False, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", metavar="FILE", help="BeamDyn primary file, windIO yaml, htc or st file of HAWC2, ElastoDyn blade or primary file, .fst of OpenFAST, MoorDyn file, MoorPy's MoorProps, VABS input, folder of BECAS")
    parser.add_argument("-o", "--output", metavar="DECK", help="deck to write, with a CSV file of its sections or a mesh next to it (FILE's name with .toml)")
    parser.add_argument("--format", choices=FORMATS, help="by default what the contents of FILE show")
    parser.add_argument("--inline", action="store_true", help="sections in the deck itself, a [section.NAME] for each station")
    parser.add_argument("--blade", metavar="FILE", help="BeamDyn: blade file, in place of the one that the primary file names; OpenFAST: a blade of any format, in place of its own")
    parser.add_argument("--st", metavar="FILE", help="HAWC2: st file, in place of the one that the htc file names")
    parser.add_argument("--body", metavar="NAME", help="HAWC2: body of the htc file (the first one with a blade's name)")
    parser.add_argument("--set", nargs=2, type=int, metavar=("NUMBER", "SUBSET"), help="HAWC2: table of the st file (that of the htc file, or 1 1)")
    parser.add_argument("--length", type=length, metavar="L", help="ElastoDyn: length of the blade in m, TipRad - HubRad (with a turbine, that of its file)")
    parser.add_argument("--layup", type=float, metavar="F", help="windIO: the section at this fraction of the span, meshed from its layers and webs, in place of the blade")
    parser.add_argument("--line", metavar="NAME", help="MoorPy: the material of its library")
    parser.add_argument("--diameter", type=length, metavar="D", help="MoorPy: nominal diameter of the line in m")
    return parser.parse_args(arguments)


def length(text: str) -> float:
    number = float(text)
    if not 0.0 < number < float("inf"):
        raise argparse.ArgumentTypeError("must be a number above 0")
    return number
