"""The Python of docs/guide/python.md runs as it stands; what needs the compiled part, on the models of fakes.py."""

import re
import shutil

import gxrod
import pytest
from conftest import EXAMPLES, PLANK, SOURCE
from conftest import gxrod as run_gxrod
from fakes import Deck, Simulation

pyplot = pytest.importorskip("matplotlib.pyplot")

BLOCKS = re.findall(r"^```python\n(.*?)^```", (SOURCE / "docs" / "guide" / "python.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
ARM = """[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.arm]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 4
[[support]]
at = "arm.start"
fix = "all"
[input.tendon]
[[load]]
at = "arm.end"
moment = [0, "tendon", 0]
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.02
[[history]]
name = "tip"
at = "arm.end"
quantities = ["position", "velocity"]
"""
SWEEP = """deck = "plank.toml"
[vary]
"parameters.height" = [0.04, 0.05]
[collect]
lowest = { history = "tip", quantity = "displacement", component = "z", take = "min" }
"""


@pytest.mark.filterwarnings("error:.*cases failed")
@pytest.mark.parametrize("number", range(len(BLOCKS)))
def test_blocks(number, runs, tmp_path, monkeypatch, capsys):
    block = BLOCKS[number]
    for module in ("pandas", "gymnasium", "torch"):
        if {"pandas": "table", "gymnasium": "gym", "torch": "gxrod.torch"}[module] in block:
            pytest.importorskip(module)
    monkeypatch.chdir(tmp_path)
    shutil.copy(runs("robot_arm"), tmp_path)
    (tmp_path / "plank.toml").write_text(PLANK.replace('["displacement", "orientation"]', '["position", "displacement"]'))
    (tmp_path / "sweep.toml").write_text(SWEEP)
    (tmp_path / "arm.toml").write_text(ARM)
    if not gxrod._has_core():
        if any(word in block for word in ("sim.summary", "sensitivities", "adjoint", "torch_run", "RodVectorEnv")):
            pytest.skip("needs the compiled part")
        monkeypatch.setitem(vars(gxrod), "Deck", lambda path: Deck(**{"parameters.height": 0.05}))
        monkeypatch.setitem(vars(gxrod), "Simulation", Simulation)
    exec(compile(block, f"block {number} of python.md", "exec"), {})
    said = capsys.readouterr().out
    pyplot.close("all")
    if "energy balances" in block:
        assert said.splitlines()[-1].startswith("the energy balances to ") and len(said.splitlines()) == 11
    if "sim.summary" in block:
        assert said.startswith("50 steps; the tip is at z = ")
    if "sweep.toml" in block:
        assert "0.04" in said


def test_every_block_is_seen():
    assert len(BLOCKS) == 11


STRESSED = """[section.post]
shape = { tube = { outer_radius = 0.03, inner_radius = 0.025 } }
material = { E = 2.1e11, nu = 0.3, density = 7850, yield_stress = 235e6, elastic = true }
[rod.beam]
section = "post"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 2
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam.end"
force = [0, 0, -100]
[analysis]
kind = "static"
[output]
stresses = "von-mises"
"""


def test_expressions_of_the_table(runs, tmp_path):
    """Each expression of the table of results can be evaluated."""
    (tmp_path / "post.toml").write_text(STRESSED)
    run_gxrod("run", "post.toml", folder=tmp_path)
    stressed = gxrod.open_results(tmp_path / "post.vtkhdf")
    page = (SOURCE / "docs" / "guide" / "python.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (`r[.\[].*?) \|", page, re.MULTILINE)
    expressions = [text for row in rows for text in re.findall(r"`([^`]*)`", row)]
    assert len(expressions) > 25
    robot, modes = (gxrod.open_results(runs(name)) for name in ("robot_arm", "modes"))
    for text in expressions:
        text = f"r.rod('arm'){text}" if text.startswith(".") else text
        if not any(word in text for word in ("inputs", "elbow", "joints.type", "line_ends", "outlines")):
            has_stress = any(word in text for word in ("stress", "envelope", "sections"))
            eval(text, {"r": stressed if has_stress else modes if "stages" in text else robot})


def test_the_command_is_that_of_the_example(tmp_path):
    page = (SOURCE / "docs" / "guide" / "python.md").read_text(encoding="utf-8")
    assert f"gxrod run {(EXAMPLES / 'robot_arm' / 'robot_arm.toml').relative_to(SOURCE)}" in page
    run_gxrod("check", EXAMPLES / "robot_arm" / "robot_arm.toml", folder=tmp_path)
