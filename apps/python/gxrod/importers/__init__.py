"""Blades, turbines and mooring lines from the files of other programs, as decks: BeamDyn, windIO, HAWC2, ElastoDyn, OpenFAST, MoorDyn, MoorPy; and sections from VABS, BECAS and
sectionproperties.

    blade = gxrod.importers.read_blade("NREL5MW_BeamDyn.dat")
    gxrod.importers.write_deck(blade, "blade.toml")
    gxrod.importers.write_turbine(gxrod.importers.read_turbine("turbine.fst"), "turbine.toml")
    gxrod.importers.write_mooring(gxrod.importers.read_moordyn("lines.txt"), "lines.toml")
    gxrod.importers.write_section_mesh(gxrod.importers.read_section_mesh("box.sg"), "box.toml")
    stiffness, mass = gxrod.importers.from_sectionproperties(section)
"""

from .blade import Blade
from .formats import FORMATS, find_format, read_blade, read_section_mesh
from .moordyn import read_moordyn
from .mooring import Body, Line, LineType, Mooring, Place
from .mooring_deck import write_mooring
from .moorprops import read_moorprops, write_section
from .openfast import read_turbine
from .section_mesh import SectionLayer, SectionMaterial, SectionMesh
from .section_writing import write_section_mesh
from .sections import from_sectionproperties
from .text import ImportFault
from .turbine import Turbine
from .turbine_deck import write_turbine
from .windio_layup import read_windio_layup
from .writing import write_deck

__all__ = ["FORMATS", "Blade", "Body", "ImportFault", "Line", "LineType", "Mooring", "Place", "SectionLayer", "SectionMaterial", "SectionMesh", "Turbine", "find_format",
           "from_sectionproperties", "read_blade", "read_moordyn", "read_moorprops", "read_section_mesh", "read_turbine", "read_windio_layup", "write_deck", "write_mooring", "write_section", "write_section_mesh", "write_turbine"]
