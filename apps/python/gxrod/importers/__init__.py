"""Blades from the files of other programs, as decks: BeamDyn, windIO, HAWC2, ElastoDyn; and sections from sectionproperties.

    blade = gxrod.importers.read_blade("NREL5MW_BeamDyn.dat")
    gxrod.importers.write_deck(blade, "blade.toml")
    stiffness, mass = gxrod.importers.from_sectionproperties(section)
"""

from .blade import Blade
from .formats import FORMATS, find_format, read_blade
from .sections import from_sectionproperties
from .text import ImportFault
from .writing import write_deck

__all__ = ["FORMATS", "Blade", "ImportFault", "find_format", "from_sectionproperties", "read_blade", "write_deck"]
