"""Blades as the importers read them, what they ought to be, and faults."""

from dataclasses import replace

import blades
import numpy as np
import pytest
from gxrod import FileError
from gxrod.importers import read_blade
from gxrod.importers.curve import Curve


def by_energies(kind, section):
    """The matrix in gxrod's axes."""
    energy = getattr(section, kind)

    def of_gxrod(s):
        x, y, z, rx, ry, rz = s
        return energy((y, z, x, ry, rz, rx))

    return blades.polarize(of_gxrod)


def near(found, wanted, tolerance=1e-13):
    """Entry by entry, on the scale of the diagonal."""
    scale = np.sqrt(np.einsum("...i,...j->...ij", np.diagonal(wanted, axis1=-2, axis2=-1), np.diagonal(wanted, axis1=-2, axis2=-1)))
    return np.max(np.abs(found - wanted) / scale) < tolerance


def curve_of(keys=blades.KEYS):
    return Curve(np.array(keys)[:, :3])


FORMATS = ("beamdyn", "windio 1", "windio 2", "hawc2 isotropic", "hawc2 full")


def read_as(kind, folder, **changes):
    curve = curve_of()
    if "windio" in kind:
        pytest.importorskip("yaml")
        return read_blade(blades.write_windio(folder, int(kind[-1]), fractions=curve.fractions, **changes))
    if "hawc2" in kind:
        return read_blade(blades.write_hawc2(folder, curve.length, kind == "hawc2 full", **changes))
    return read_blade(blades.write_beamdyn(folder, **changes))


def edit(path, old, new, count=1):
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, count))
    return path


def fault(path, **options):
    with pytest.raises(FileError) as caught:
        read_blade(path, **options)
    return str(caught.value)
