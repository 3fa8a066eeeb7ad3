"""How to install a missing package without breaking those that are there."""

from importlib import metadata, util
from pathlib import Path


def pip_install(package):
    """The command that installs a package, and keeps NumPy 1 where Debian's h5py was compiled for that."""
    return f'python3 -m pip install "{package}" "numpy<2"' if needs_numpy_1() else f"python3 -m pip install {package}"


def needs_numpy_1():
    """Whether h5py is from a release of Debian with NumPy 1: next to NumPy 2 it cannot be imported."""
    found = util.find_spec("h5py")
    if not found or not found.origin:
        return False
    folder = Path(found.origin).parents[1]
    return folder.parts[-2:] == ("python3", "dist-packages") and any(
        numpy.version.startswith("1.") for numpy in metadata.distributions(name="numpy", path=[str(folder)]))
