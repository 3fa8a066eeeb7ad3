"""Which format a file has, and its reader."""

from __future__ import annotations

from pathlib import Path

from ..typed import AnyPath
from .beamdyn import is_beamdyn, read_beamdyn
from .becas import is_becas, read_becas
from .blade import Blade
from .elastodyn import is_elastodyn, read_elastodyn
from .hawc2 import is_hawc2, read_hawc2
from .moordyn import is_moordyn
from .moorprops import is_moorprops
from .openfast import is_openfast
from .section_mesh import SectionMesh
from .text import ImportFault, read_text
from .vabs import is_vabs, read_vabs
from .windio import is_windio, read_windio

BLADES = {"beamdyn": is_beamdyn, "windio": is_windio, "hawc2": is_hawc2, "elastodyn": is_elastodyn}
KNOWN_BY = {"openfast": is_openfast, "moordyn": is_moordyn, "moorpy": is_moorprops, "vabs": is_vabs, **BLADES}
SECTIONS = {"vabs": read_vabs, "becas": read_becas}
FORMATS = (*KNOWN_BY, "becas")


def find_format(path: AnyPath) -> str:
    """The format of a file, by what is in it, not by its name; BECAS has a folder."""
    if is_becas(path):
        return "becas"
    if Path(path).is_dir():
        raise ImportFault(f"{path}: is a folder without N2D.in; give a folder of BECAS, or a file")
    text = read_text(Path(path))
    for name, is_this in KNOWN_BY.items():
        if is_this(text):
            return name
    raise ImportFault(f"{path}: neither a BeamDyn primary file, a windIO yaml, an htc or st file of HAWC2, an ElastoDyn blade file, a .fst file of OpenFAST, ElastoDyn's primary file, an input file of MoorDyn, MoorPy's MoorProps nor an input of VABS; "
                      f"give one of these, or name its format: --format {' | '.join(FORMATS)}")


def read_blade(path: AnyPath, format: str | None = None, *, blade_file: AnyPath | None = None, st_file: AnyPath | None = None,
               body: str | None = None, chosen: tuple[int, int] | None = None, length: float | None = None) -> Blade:
    """A blade from a BeamDyn primary file, a windIO yaml, an htc or st file of HAWC2, or an ElastoDyn blade file.

    format: "beamdyn", "windio", "hawc2" or "elastodyn"; by default what the file's contents show. blade_file: BeamDyn's, in place of the one that
    the primary file names. st_file: HAWC2's, in place of the one that the htc file names. body: its name in the htc file; by default the first with a blade's
    name. chosen: set and subset of the st file. length: of a blade of ElastoDyn, in m.

    Raises FileError, with file, line, what was expected and what to do.
    """
    kind = format or find_format(path)
    if kind == "beamdyn":
        return read_beamdyn(path, blade_file)
    if kind == "windio":
        return read_windio(path)
    if kind == "hawc2":
        return read_hawc2(path, st_file, body, chosen)
    if kind == "elastodyn":
        return read_elastodyn(path, length)
    if kind in SECTIONS:
        raise ImportFault(f"{path}: has a section, not a blade; read it with read_section_mesh")
    if kind == "openfast":
        raise ImportFault(f"{path}: has a turbine, not a blade; read it with read_turbine, or read a blade file that it names")
    if kind in KNOWN_BY:
        raise ImportFault(f"{path}: has lines, not a blade; read it with read_moordyn or read_moorprops")
    raise ImportFault(f'{path}: there is no format "{kind}"; give one of {", ".join(BLADES)}')


def read_section_mesh(path: AnyPath, format: str | None = None) -> SectionMesh:
    """A section of plies from an input file of VABS, which PreVABS and SONATA write, or a folder of BECAS.

    format: "vabs" or "becas"; by default what the file's contents show.

    Raises FileError, with file, line, what was expected and what to do.
    """
    kind = format or find_format(path)
    if kind not in SECTIONS:
        raise ImportFault(f"{path}: is of the format {kind}, which has no mesh of a section; give one of {', '.join(SECTIONS)}")
    return SECTIONS[kind](path)
