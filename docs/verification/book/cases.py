"""The cases of `gxrod verify` and where their decks and pages are."""

import pathlib
import subprocess
import tomllib

PAGES = pathlib.Path(__file__).resolve().parents[1]
SOURCE = PAGES.parents[1]
EXAMPLES = PAGES.parent / "examples"
KEPT = SOURCE / "tests" / "data" / "results.json"

# In the order of the index.
KINDS = {"rigid body": "Rigid bodies", "mechanism": "Mechanisms", "statics": "Statics", "vibrations": "Vibrations", "stability": "Stability",
         "materials": "Materials and forces within", "surroundings": "Water, wind and ground", "contact": "Contact", "dynamics": "Dynamics", "objectivity": "Objectivity",
         "conservation": "Conservation", "order": "Order of the schemes"}


def find_program(given=None):
    """The program as given, or that of a build in Release."""
    return str(given or SOURCE / "build" / "release" / "gxrod")


def list_cases(program):
    """{name: sentence}, as the program lists them."""
    listed = subprocess.run([program, "verify", "--list"], check=True, text=True, stdout=subprocess.PIPE).stdout
    return dict(line.split(maxsplit=1) for line in listed.splitlines())


def deck_of(name):
    """The deck of a case, or None where it has several."""
    path = EXAMPLES / name / f"{name}.toml"
    return path if path.exists() else None


def figure_of(name, kind):
    return PAGES / "figures" / f"{name}_{kind}.png"


def reference_of(name):
    """What reference.toml says, of a case that has one."""
    path = EXAMPLES / name / "reference.toml"
    return tomllib.loads(path.read_text(encoding="utf-8")) if path.exists() else {"value": [], "refinement": []}


def refinements_of(name):
    """{name of a refinement: its table of reference.toml}."""
    return {each["name"]: each for each in reference_of(name)["refinement"]}


def points_compared(name):
    """The histories whose values are compared."""
    return {each["history"] for each in reference_of(name)["value"] if "history" in each}
