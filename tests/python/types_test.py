"""What editors and type checkers know of the package."""

import ast
import os
import pathlib
import re
import subprocess
import sys

import gxrod
import pytest
from conftest import SOURCE

PACKAGE = pathlib.Path(gxrod.__file__).parent
WRITTEN = SOURCE / "apps" / "python" / "gxrod"

SCRIPT = """import gxrod
deck = gxrod.Deck("arm.toml")
with gxrod.Simulation(deck.build({"parameters.EI": 0.05}), sensitivities=["EI"], points={"quarter": "arm@0.25"}) as sim:
    while not sim.finished:
        sim.inputs["tendon"] = 2.0 * (0.3 - sim["tip"].position[2])
        count: int = sim.advance(until=sim.time + 0.02).newton_iterations
    heights = sim.state.position[:, 2] + sim.elements.moment[0, 0]
table = gxrod.map(deck, [{"parameters.EI": 3.0}], {"tip": "tip.position"})["tip[0]"]
r = gxrod.open_results("arm.vtkhdf")
tip = r["tip"].position[:, 0] + r.frames[-1].position[0, 0] + r.rod("arm").moment(frame=-1)[0, 0]
"""


def test_the_stub_is_what_nanobind_makes(tmp_path):
    """Renew it: build/nanobind/bin/python -m nanobind.stubgen --exclude-values -i build/checked/python -m gxrod._core -o apps/python/gxrod/_core.pyi"""
    if not gxrod._has_core():
        pytest.skip("gxrod has no compiled part here: it is built with -DGXROD_PYTHON_MODULE=ON")
    python = os.environ.get("GXROD_NANOBIND_PYTHON") or sys.executable
    asked = subprocess.run([python, "-c", "import nanobind.stubgen; print(nanobind.__version__)"], text=True, capture_output=True, check=False)
    [wanted] = re.findall(r'wanted="nanobind==(.*)"', (SOURCE / "tests" / "nanobind-python").read_text())
    if asked.stdout.strip() != wanted:
        pytest.skip(f"the stub is compared with what nanobind {wanted} makes; {python} has " + (asked.stdout.strip() or "none"))
    stub = tmp_path / "_core.pyi"
    subprocess.run([python, "-B", "-m", "nanobind.stubgen", "-q", "--exclude-values", "-i", PACKAGE.parent, "-m", "gxrod._core", "-o", stub], check=True)
    assert stub.read_text(encoding="utf-8") == (WRITTEN / "_core.pyi").read_text(encoding="utf-8")


def test_type_checkers_see_every_public_name():
    tree = ast.parse((WRITTEN / "__init__.py").read_text(encoding="utf-8"))
    [block] = [node for node in tree.body if isinstance(node, ast.If) and any(isinstance(each, ast.ImportFrom) for each in node.body)]
    seen = {name.asname for each in block.body for name in each.names}
    assert seen >= {*gxrod._HOMES, *gxrod._COMPILED, *gxrod._MODULES}
    assert (WRITTEN / "py.typed").exists()


WRONG = {"sim.advance(untl=0.2)": "until", "sim.state.positoin": "position", "gxrod.Simulatoin(deck)": "Simulatoin", "deck.build('EI')": "build",
         "sim.time = 0.0": "read-only", "sim.inputs['tendon'] = 'full'": "float", "gxrod.Simulation(3)": "Model"}


def test_wrong_calls_are_found_and_no_others(tmp_path):
    pytest.importorskip("mypy", reason="mypy is not installed")
    (tmp_path / "script.py").write_text(SCRIPT + "\n".join(WRONG) + "\n")
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", "--ignore-missing-imports", "script.py"], cwd=tmp_path, text=True,
                          capture_output=True, check=False, env={**os.environ, "MYPYPATH": str(WRITTEN.parent)})
    found = [line for line in done.stdout.splitlines() if line.startswith("script") and "error" in line]
    first = SCRIPT.count("\n") + 1
    for line, said in zip(found, WRONG.values()):
        assert said in line
    assert [int(line.split(":")[1]) for line in found] == list(range(first, first + len(WRONG))), done.stdout
