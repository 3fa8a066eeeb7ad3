"""Blades and mooring lines from the files of other programs, as decks: BeamDyn, windIO, HAWC2, ElastoDyn, MoorDyn, MoorPy; and sections from sectionproperties.

    blade = gxrod.importers.read_blade("NREL5MW_BeamDyn.dat")
    gxrod.importers.write_deck(blade, "blade.toml")
    gxrod.importers.write_mooring(gxrod.importers.read_moordyn("lines.txt"), "lines.toml")
    stiffness, mass = gxrod.importers.from_sectionproperties(section)
"""

from .blade import Blade
from .formats import FORMATS, find_format, read_blade
from .moordyn import read_moordyn
from .mooring import Body, Line, LineType, Mooring, Place
from .mooring_deck import write_mooring
from .moorprops import read_moorprops, write_section
from .sections import from_sectionproperties
from .text import ImportFault
from .writing import write_deck

__all__ = ["FORMATS", "Blade", "Body", "ImportFault", "Line", "LineType", "Mooring", "Place", "find_format", "from_sectionproperties", "read_blade", "read_moordyn",
           "read_moorprops", "write_deck", "write_mooring", "write_section"]
