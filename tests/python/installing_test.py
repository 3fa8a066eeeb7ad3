"""What messages say of packages that are missing, in environments with packages of Debian and without."""

import importlib
import sys

import gxrod
import pytest
from gxrod.installing import pip_install
from gxrod.results import source, tabular

BOTH = 'python3 -m pip install "pandas" "numpy<2"'
ALONE = "python3 -m pip install pandas"
BROKEN = 'raise ValueError("numpy.dtype size changed, may indicate binary incompatibility")\n'


@pytest.fixture
def environment(tmp_path, monkeypatch):
    """Puts an h5py, with the NumPy that came with it, into a folder from where it is imported."""
    def make(folder, numpy, h5py=""):
        folder = tmp_path / folder
        for package in (f"numpy-{numpy}.dist-info", "h5py"):
            (folder / package).mkdir(parents=True)
        (folder / f"numpy-{numpy}.dist-info" / "METADATA").write_text(f"Metadata-Version: 2.1\nName: numpy\nVersion: {numpy}\n")
        (folder / "h5py" / "__init__.py").write_text(h5py)
        monkeypatch.delitem(sys.modules, "h5py", raising=False)
        monkeypatch.syspath_prepend(folder)
        importlib.invalidate_caches()

    return make


@pytest.mark.parametrize("folder, numpy, expected", [
    ("usr/lib/python3/dist-packages", "1.24.2", BOTH),  # Debian 12
    ("usr/lib/python3/dist-packages", "2.2.4", ALONE),  # Debian 13
    ("venv/lib/python3.11/site-packages", "1.26.4", ALONE),
    ("usr/local/lib/python3.11/dist-packages", "1.26.4", ALONE),  # by pip
])
def test_keeps_numpy_1_for_an_h5py_of_debian(environment, absent, folder, numpy, expected):
    environment(folder, numpy)
    absent("pandas")
    with pytest.raises(ImportError, match="tables of gxrod as DataFrames need pandas") as raised:
        tabular.import_pandas()
    assert str(raised.value).endswith(f": {expected}")


def test_without_h5py(absent):
    absent("h5py")
    assert pip_install("pandas") == ALONE


def test_h5py_next_to_a_newer_numpy(environment):
    environment("usr/lib/python3/dist-packages", "1.24.2", h5py=BROKEN)
    with pytest.raises(ImportError, match='h5py was compiled for another NumPy: python3 -m pip install "h5py" "numpy<2"'):
        source.import_h5py()
    with pytest.raises(ImportError, match="another NumPy"):
        gxrod.open_results("plank.vtkhdf")
