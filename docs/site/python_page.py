"""Writes the page of the Python package from its docstrings: python3 docs/site/python_page.py > docs/python.md.

It reads the sources and imports none, so that it needs neither the compiled part nor any package.
"""

import ast
import inspect
import pathlib
import re
import sys
import textwrap

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "apps" / "python" / "gxrod"

HEAD = """# Every name in Python

`import gxrod` has these names; [Python](guide/python.md) shows how they are used. Written from their docstrings.

Numbers are in the deck's units, angles in rad, vectors x y z in global axes, quaternions w x y z, where nothing else is said. Shapes of arrays: N nodes, E elements, S steps with the state
at t = 0, F frames; n and e are the nodes and elements of one rod.
"""

# As a user thinks of them: title, an introduction, and the names by their modules.
GROUPS = [
    ("Decks and models", "", {"decks": ["Deck", "Model", "Section", "RodPlaces", "schema"]}),
    ("Simulations", "", {"simulation": ["Simulation", "Step", "Summary", "State", "Elements", "Values", "Records", "Inputs"], "_core": ["Checkpoint"]}),
    ("Derivatives", "Derivatives by the `sensitivities` of a `Simulation` are carried along with it; `sim[\"tip\"].derivative` of `Values` reads them "
                    "([theory](theory/sensitivities.md)).", {"gradients": ["check_gradient"]}),
    ("Functions of PyTorch and JAX", "Each needs the package of its name.", {"torch": ["torch_run"], "jax": ["jax_run"]}),
    ("Many runs", "", {"mapping": ["map"], "batches": ["batch", "read_batch"]}),
    ("Results of runs", "", {"results": ["open_results", "Results"], "results/records": ["Record", "History", "SampledHistory", "Quantity", "Named"],
                     "results/frames": ["Frames", "Frame", "Fields", "Rod"], "results/ranges": ["Range"], "results/stresses": ["SectionStress", "Envelope", "ResultSection"], "results/contacts": ["Contacts", "ContactFrame"], "results/tables": ["Table"], "results/outlines": ["Outline"],
                     "results/stages": ["Stage", "ShapesStage", "Sweep", "Response", "Answers", "PathStage", "Shapes", "SweepShapes"], "plot": ["draw"], "page": ["Page"]}),
    ("Fatigue", "", {"fatigue": ["rainflow", "Cycles", "SNCurve", "damage", "equivalent_range"]}),
    ("Blades, turbines and sections of other programs", "", {"importers/formats": ["read_blade", "read_section_mesh"], "importers/writing": ["write_deck"], "importers/blade": ["Blade"],
                                                      "importers/openfast": ["read_turbine"], "importers/turbine_deck": ["write_turbine"], "importers/turbine": ["Turbine"],
                                                      "importers/section_writing": ["write_section_mesh"], "importers/windio_layup": ["read_windio_layup"], "importers/section_mesh": ["SectionMesh", "SectionLayer", "SectionMaterial"],
                                                      "importers/sections": ["from_sectionproperties"]}),
    ("Mooring lines of other programs", "", {"importers/moordyn": ["read_moordyn"], "importers/mooring_deck": ["write_mooring"], "importers/mooring": ["Mooring", "Line", "LineType", "Place", "Body"],
                                             "importers/moorprops": ["read_moorprops", "write_section"]}),
    ("Environments to learn in", "Needs gymnasium.", {"gym": ["RodEnv", "RodVectorEnv"]}),
    ("Errors", "", {"errors": ["Error", "DeckError", "Fault", "ConvergenceError", "EvaluationError", "FileError", "UnknownNameError"]}),
]
CONSTRUCTED = {"Deck": "gxrod.Deck", "SNCurve": "gxrod.fatigue.SNCurve", "Simulation": "gxrod.Simulation", "RodEnv": "gxrod.gym.RodEnv", "RodVectorEnv": "gxrod.gym.RodVectorEnv"}  # by users; others are handed out
PREFIXES = {"gym": "gxrod.gym.", "torch": "gxrod.torch.", "jax": "gxrod.jax.", "fatigue": "gxrod.fatigue.", "plot": "gxrod.plot.", **dict.fromkeys(("importers/formats", "importers/openfast", "importers/turbine_deck", "importers/writing", "importers/section_writing", "importers/windio_layup", "importers/sections", "importers/moordyn", "importers/mooring_deck", "importers/moorprops"), "gxrod.importers.")}
NAMES = {name for _, _, modules in GROUPS for names in modules.values() for name in names}
TYPES = {"Array": "array", "WholeArray": "array of int", "NDArray[np.complex128]": "complex array"}


def read_module(name):
    """{name: class or function} of a module, of functions with overloads the last one."""
    path = next(path for path in (PACKAGE / f"{name}.py", PACKAGE / f"{name}.pyi", PACKAGE / name / "__init__.py") if path.exists())
    return {node.name: node for node in ast.parse(path.read_text(encoding="utf-8")).body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}


def has_decorator(node, name):
    return any(isinstance(each, ast.Name) and each.id == name for each in node.decorator_list)


def arguments_of(node, skip_first):
    """[(name, as in a signature)], without types."""
    args = node.args
    write = lambda each, default: (each.arg, each.arg + (f"={ast.unparse(default)}" if default else ""))
    defaults = [None] * (len(args.args) - len(args.defaults)) + args.defaults
    found = [*map(write, args.args, defaults)][skip_first:] + ([("", "*")] if args.kwonlyargs and not args.vararg else [])
    return found + [*map(write, args.kwonlyargs, args.kw_defaults)] + [(each.arg, star + each.arg) for each, star in ((args.vararg, "*"), (args.kwarg, "**")) if each]


def describe(node, where, arguments=()):
    """The docstring as Markdown: names of arguments as code, three or more as a list; other names of this page as links."""
    text = ast.get_docstring(node)
    if not text:
        sys.exit(f"{where} has no docstring")
    return "\n\n".join(describe_paragraph(each, [name for name, _ in arguments if name]) for each in inspect.cleandoc(text).split("\n\n"))


def describe_paragraph(text, arguments):
    if text.startswith("    "):
        return "```python\n" + textwrap.dedent(text) + "\n```"
    if text.startswith("|"):
        return link(text)
    text = " ".join(text.split())
    for name in arguments:
        text = re.sub(rf"(^|[.;] ){name}: ", rf"\1`{name}`: ", text)
    described = re.compile(r"(?:^|[.;] )(`\w+`(?: \[[^]]*\])?: )")
    if len(described.findall(text)) > 2:
        text = re.sub(r"(?<![.:])\n", ".\n", described.sub(r"\n- \1", text)).replace("\n", "\n\n", 1).strip(".\n ") + "."
    return link(text)


def link(text):
    """Links to the names of this page: in code, and of errors."""
    text = re.sub(r"(?<![\w`.])\w*Error(?![\w`])", lambda m: f"`{m[0]}`" if m[0] in NAMES else m[0], text)
    return re.sub(r"`(?:gxrod\.)?(\w+)`(?!\]|:)", lambda m: f"[{m[0]}](#{m[1].lower()})" if m[1] in NAMES else m[0], text)


def type_of(node):
    text = ast.unparse(node.returns) if node.returns else "None"
    if text == "None":
        return ""
    text = TYPES.get(text, text).replace("NDArray[Any]", "array").replace("Array", "array")
    return link(" or ".join(f"`{each}`" for each in text.split(" | "))) if text[0].isupper() or "[" in text else text


def member_lines(name, node):
    """Attributes as a table, methods as a list."""
    members = [each for each in node.body if isinstance(each, ast.FunctionDef) and not has_decorator(each, "overload")
               and (each.name[0] != "_" or each.name == "__getitem__" and ast.get_docstring(each))]
    properties = [each for each in members if has_decorator(each, "property")]
    lines = ["\n| attribute | type | |\n|---|---|---|"] if properties else []
    for each in properties:
        text = " ".join(describe(each, f"{name}.{each.name}").split()).replace("|", "\\|")
        lines.append(f"| `{each.name}` | {type_of(each)} | {text} |")
    methods = [each for each in members if each not in properties]
    lines += [""] if methods else []
    for each in methods:
        arguments = arguments_of(each, 0 if has_decorator(each, "staticmethod") else 1)
        signature = ", ".join(text for _, text in arguments)
        call = f"{name.lower()}[{signature}]" if each.name == "__getitem__" else f"{name if has_decorator(each, 'classmethod') else ''}.{each.name}({signature})"
        returns = type_of(each)
        text = describe(each, f"{name}.{each.name}", arguments).replace("\n", "\n    ").replace("\n    \n", "\n\n")
        lines.append(f"- **`{call}`**" + (f" → {returns}" if returns else "") + f"\n\n    {text}\n")
    return lines


def name_lines(module, name, node):
    """The section of one name."""
    lines = [f"\n### {name}\n"]
    if isinstance(node, ast.FunctionDef):
        arguments = arguments_of(node, 0)
        returns = type_of(node)
        call = f"**`{PREFIXES.get(module, 'gxrod.')}{name}({', '.join(text for _, text in arguments)})`**"
        return [*lines, call + (f" → {returns}" if returns else "") + "\n", describe(node, name, arguments)]
    start = next((each for each in node.body if isinstance(each, ast.FunctionDef) and each.name == "__init__"), None)
    arguments = arguments_of(start, 1) if start else []
    if name in CONSTRUCTED:
        lines.append(f"**`{CONSTRUCTED[name]}({', '.join(text for _, text in arguments)})`**\n")
    lines.append(describe(node, name, arguments))
    bases = [each.id for each in node.bases if isinstance(each, ast.Name) and (each.id in NAMES or each.id.endswith("Error"))]
    if bases:
        lines.append("\nA kind of " + ", ".join(link(f"`{each}`") for each in bases) + ".")
    return lines + member_lines(name, node)


def write_page():
    lines = [HEAD]
    for title, introduction, modules in GROUPS:
        lines.append(f"\n## {title}\n" + (f"\n{link(introduction)}\n" if introduction else ""))
        for module, names in modules.items():
            nodes = read_module(module)
            lines += [line for name in names for line in name_lines(module, name, nodes[name])]
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).strip() + "\n"


if __name__ == "__main__":
    sys.stdout.write(write_page())
