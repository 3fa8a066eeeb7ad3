"""The package as a whole: what importing costs, what it offers, what it says without its compiled part."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys

import gxrod
import pytest
from conftest import SOURCE

PACKAGE = pathlib.Path(gxrod.__file__).parent
HAS_CORE = importlib.util.find_spec("gxrod._core") is not None


def test_the_version_is_that_of_the_project():
    [version] = re.findall(r"project\(gxrod VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())
    assert gxrod.__version__ == version


def test_importing_it_loads_nothing_large():
    heavy = "{'h5py', 'pandas', 'xarray', 'matplotlib', 'gymnasium', 'numpy'}"
    code = f"import sys; sys.path.insert(0, {str(PACKAGE.parent)!r}); import gxrod; print(sorted({heavy} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-B", "-c", code], text=True, capture_output=True, check=True).stdout == "[]\n"


def test_names_are_completed():
    assert {"open_results", "batch", "read_batch", "map", "gym", "Error", "__version__"} <= set(dir(gxrod))
    assert ("Simulation" in dir(gxrod)) == HAS_CORE
    for name in ("open_results", "batch", "read_batch", "map"):
        assert getattr(gxrod, name).__doc__
    with pytest.raises(AttributeError, match="no attribute 'open_result'"):
        gxrod.open_result


@pytest.mark.skipif(HAS_CORE, reason="the compiled part is there")
def test_without_the_compiled_part():
    for name in ("Deck", "Model", "Simulation"):
        with pytest.raises(ImportError, match=f"gxrod.{name} needs the compiled part .*pip install ."):
            getattr(gxrod, name)
    with pytest.raises(ImportError, match="compiled part"):
        gxrod.map(None, [], {}, as_arrays=True)


def test_every_public_name_is_described():
    for name in ("Results", "errors", "results.records", "results.frames", "results.stages", "results.tables", "batches", "mapping", "page", "program"):
        part = gxrod.Results if name == "Results" else importlib.import_module(f"gxrod.{name}")
        assert part.__doc__
        for key, value in vars(part).items():
            if not key.startswith("_") and isinstance(value, (property, type)) and getattr(value, "__module__", part.__name__) == part.__name__:
                assert value.__doc__, f"{name}.{key}"


@pytest.mark.parametrize("package, program", [("python", "."), ("share/gxrod/python", "bin")], ids=["build tree", "installed"])
def test_where_it_is_put(package, program, tmp_path):
    """The package finds the program, and gxrod-plot and gxrod-import the package, in a build tree as in an installed one."""
    shutil.copytree(PACKAGE, tmp_path / package / "gxrod", ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    (tmp_path / program).mkdir(exist_ok=True)
    (tmp_path / program / "gxrod").write_text("#!/bin/sh\n")
    (tmp_path / program / "gxrod").chmod(0o755)
    plot = shutil.copy(SOURCE / "apps" / "gxrod-plot", tmp_path / program)
    importer = shutil.copy(SOURCE / "apps" / "gxrod-import", tmp_path / program)
    environment = {key: value for key, value in os.environ.items() if key not in ("GXROD_PROGRAM", "PYTHONPATH")} | {"PYTHONPATH": str(tmp_path / package)}
    run = lambda *command: subprocess.run([sys.executable, "-B", *command], text=True, capture_output=True, check=True, env=environment).stdout
    code = "import gxrod; print(gxrod.program.find_program())"
    assert run("-c", code).strip() == str((tmp_path / program / "gxrod").resolve())
    del environment["PYTHONPATH"]
    assert "usage: gxrod-import" in run(importer, "--help")
    if importlib.util.find_spec("matplotlib"):
        assert "usage: gxrod-plot" in run(plot, "--help")
