"""Reads results files of gxrod: `gxrod.open_results(path)`. Needs h5py and NumPy."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import FileError, UnknownNameError
from ..typed import AnyPath, Array
from . import frames
from .contacts import Contacts
from .display import Shown
from .frames import STILL, Frames, Rod, find_rod, read_rod_table
from .ranges import line_end_rows
from .records import History, Named, Record, SampledHistory, attributes_of
from .source import Source, plain
from .stages import Stage, read_stages
from .stresses import Envelope, ResultSection, SectionStress, read_envelope, read_sections, read_stress
from .outlines import Outline, read_outlines
from .tables import Table, parts_of_deck, read_table, table_of_deck
from .tabular import import_xarray

if TYPE_CHECKING:
    import matplotlib.figure
    import xarray
    from numpy.typing import NDArray

    from ..page import Page

COLUMNS = ("stage", "load_factor", "limit_load_factor", "branch")  # of all histories


def open_results(path: AnyPath) -> Results:
    """The results of a run, also of one that is running or was killed, up to its last complete step.

    path: a `.vtkhdf` file that `gxrod run` wrote. Nothing but the times is read until it is asked for. What a run adds
    afterwards is seen after `refresh()`. The file is open only while something is read.

    Raises FileError if it cannot be read as results.
    """
    return Results(path)


class Results(Shown):
    """An opened results file: `r["tip"].position`, `r.ledger.energy_error`, `r.frames[-1].position`, `r.rod("arm").moment()`.

    S is the number of steps, the state at t = 0 included, F of frames, N of nodes, E of elements and bodies. Numbers are
    in the deck's units, angles in rad. Vectors have the components x, y, z; quaternions are w, x, y, z.
    """

    def __init__(self, path: AnyPath) -> None:
        self._source = Source(path)

    @property
    def path(self) -> Path:
        """Of the file."""
        return self._source.path

    def refresh(self) -> Results:
        """Sees the steps and frames that the file has now; returns itself."""
        self._source.refresh()
        return self

    # What kind of run it is, and what became of it.

    @property
    def status(self) -> str:
        """"complete", "failed", "interrupted", or "running", also after a kill."""
        return self._source.attributes["status"]

    @property
    def reason(self) -> str:
        """Why it failed, or where it was interrupted; else "" or what ended it."""
        return self._source.attributes.get("reason", "")

    @property
    def warnings(self) -> list[str]:
        """All that is to be known before the results are trusted: what `gxrod check` warns of, and the run itself."""
        return self._source.attributes.get("warnings", "").splitlines()

    @property
    def title(self) -> str:
        """Of the deck; the deck's name if it has none."""
        return self._source.attributes.get("title") or self.deck_name

    @property
    def units(self) -> str:
        """The deck's label, as "m kg s"; "" without one."""
        return self._source.attributes.get("units", "")

    @property
    def analysis(self) -> str:
        """"static", "dynamic" or "static and dynamic"."""
        return self._source.attributes.get("analysis", "")

    @property
    def version(self) -> str:
        """Of the gxrod that wrote it."""
        return self._source.attributes["gxrod_version"]

    @property
    def attributes(self) -> dict[str, Any]:
        """All attributes of the file: a dict."""
        return dict(self._source.attributes)

    @property
    def deck_name(self) -> str:
        """Of the deck's file, as run last."""
        return self._source.attributes.get("deck_name", "")

    @property
    def deck_text(self) -> str:
        """The deck as run last, after `--set`."""
        def read(file):
            texts = file["deck"]
            count = sum(1 for name in texts if name.startswith("text"))
            return plain(texts["text" if count < 2 else f"text_{count}"][()])

        return self._source.once("deck", read)

    @property
    def deck(self) -> dict[str, Any]:
        """The deck as a dict, its keys and values as written."""
        import tomllib

        try:
            return tomllib.loads(self.deck_text)
        except tomllib.TOMLDecodeError as error:
            raise FileError(f"{self.path}: its deck cannot be read: {error}") from error

    def doubt(self) -> str:
        """Why the file is not trusted: a clause, or "" if its bytes are those that were written, or a run writes it. Reads all of it."""
        from ..seal import doubt_of

        return doubt_of(self.path)

    # Over the steps.

    @property
    def time(self) -> Array:
        """Time at the end of each accepted step [S]; in statics the load factor, along a path its arc length: see `time_name`."""
        return self._source.times

    @property
    def time_name(self) -> str:
        """"time", "load_factor" or "arc_length"."""
        return self._source.time_name

    @property
    def load_factor(self) -> Array:
        """[S]: of runs along paths their load factor; of others the time, which in statics is the load factor."""
        return self.columns["load_factor"] if "load_factor" in self.columns else self.time

    @property
    def columns(self) -> dict[str, NDArray[Any]]:
        """What files of stages and paths have for each step: `stage`, `load_factor`, `branch`, `limit_load_factor` [S]."""
        there = [name for name in COLUMNS if name in self._source.columns]
        read = lambda name: self._source.read(lambda file: file["histories"][name][: len(self.time)])
        return {name: read(name) for name in there}

    @property
    def histories(self) -> Named[History]:
        """All histories by their names, as the deck's `[[history]]` has them."""
        names = self._source.once("histories", lambda file: [name for name, entry in file["histories"].items()
                                                             if not hasattr(entry, "shape")])
        return Named("history", names, lambda name: History(self._source, name))

    @property
    def sampled(self) -> Named[SampledHistory]:
        """Histories at the multiples of `output.history_interval`: `r.sampled["tip"].position` [T,3], at `r.sampled["tip"].time` [T]. Empty if the deck does not have it."""
        names = self._source.once("sampled", lambda file: [name for name, entry in file["sampled"].items() if not hasattr(entry, "shape")]
                                  if "sampled" in file else [])
        return Named("history", names, lambda name: SampledHistory(self._source, name))

    def __getitem__(self, name: str) -> History:
        """The history of this name: `r["tip"].position` [S,3]."""
        return self.histories[name]

    def __contains__(self, name: object) -> bool:
        return name in self.histories

    def _ipython_key_completions_(self):
        return list(self.histories)

    @property
    def ledger(self) -> Record:
        """Energies and momenta of the whole model, and `energy_error`, what no term explains: [S] and [S,3]."""
        return Record(self._source, "ledger", "ledger")

    @property
    def solver(self) -> Record:
        """What each step took: `time_step`, `newton_iterations`, `residual`, `rejected_steps` [S]."""
        return Record(self._source, "solver", "solver")

    @property
    def inputs(self) -> Record:
        """What the deck's inputs were: `r.inputs["tendon"]` [S]."""
        if not self._source.once("has inputs", lambda file: "inputs" in file):
            raise UnknownNameError(f"{self.path.name} has no inputs: the deck has no [input.NAME]")
        return Record(self._source, "inputs", "inputs")

    # The motion.

    @property
    def frames(self) -> Frames:
        """The motion: `r.frames.time` [F], `r.frames[-1].position` [N,3], `r.frames.nearest(2.5).elements.moment` [E,3]."""
        return Frames(self._source)

    @property
    def contacts(self) -> Contacts:
        """What touches, frame by frame: `r.contacts[-1].force` [K,3] at `r.contacts[-1].point`, `r.contacts[-1].of("rope")` the sum [3]."""
        return Contacts(self._source)

    @property
    def rods(self) -> Named[Rod]:
        """All rods by their names."""
        return Named("rod", read_rod_table(self._source)["name"], lambda name: Rod(self._source, name))

    def rod(self, name: str) -> Rod:
        """The rod of this name: `r.rod("arm").moment(frame=-1)` [e,3], at the middles of its elements from start to end."""
        return find_rod(self._source, name)

    def line_ends(self, start: float | None = None, end: float | None = None, stage: str | None = None) -> Table:
        """A table of the ends of lines that the deck's `output.line_ends` names: a row for each end and quantity.

        Columns: `name` (the point), `quantity` (tensions, shear force, bending moment; declination and azimuth of the axis from start to end,
        in degrees), `unit`, `static` (before time begins), `least`, `time_of_least`, `largest`, `time_of_largest`, `mean` over
        the times from start to end, or of a stage; by default all stages with time.
        """
        return line_end_rows(self._source, dict(self.histories.items()), start, end, stage)

    # Stresses, of decks with `stresses` in [output].

    @property
    def sections(self) -> Named[ResultSection]:
        """Sections on cells with the operators of their stresses: `r.sections["post"].points` [p,2]. Empty without `stresses` in the deck's [output]."""
        return read_sections(self._source)

    def stress(self, rod: str, s: float, t: float | None = None) -> SectionStress:
        """Stresses at all points of the section of a rod: `r.stress("beam", s=0.3, t=2.0).von_mises` [p], `.worst`.

        s: arc length, from the start of the rod. t: time, in statics a load factor; the nearest frame is taken, by default the last. Force and
        moment are linear between the middles of the elements on both sides of s, before the first and behind the last middle
        they go on along the line through the nearest two; so they are smeared where a point load acts or rods meet between two middles. The section is that of
        the element in which s is. In water the pressure p on a solid section, which adds -p to xx, yy and zz, is left out. UnknownNameError without stresses there, ValueError if s is not on the rod.
        """
        return read_stress(self._source, rod, s, t)

    def envelope(self, rod: str) -> Envelope:
        """The largest stresses of all steps along a rod: `r.envelope("beam").von_mises.value` [n] at `.arc_length` [n], `.worst("exposure")`."""
        return read_envelope(self._source, rod)

    # What joins things.

    @property
    def joints(self) -> Table:
        """A table: `name`, `type`, `point_a`, `point_b` (rows of frames; -1: the ground), `arm_a`, `arm_b` from there to the ends, `axis_a`, `axis_b` at t = 0 [n,3], in global axes."""
        return read_table(self._source, "joints", "joints")

    @property
    def springs(self) -> Table:
        """A table: `name`, `point_a`, `point_b`, `arm_a`, `arm_b`, as of joints."""
        return read_table(self._source, "springs", "springs")

    @property
    def bushings(self) -> Table:
        """A table: `name`, `point_a`, `point_b`, `arm_a`, `arm_b`, as of joints."""
        return read_table(self._source, "bushings", "bushings")

    @property
    def gears(self) -> Table:
        """A table of the deck's `[gear.NAME]`: `name` and its keys, as the deck writes them."""
        return self._table_of_deck("gears", parts_of_deck(self.deck, "gear"))

    @property
    def sleeves(self) -> Table:
        """A table: `name`, `rod` (row of `rods`), `place` (arc length at t = 0) and the point that slides: `point_b`, `arm_b`."""
        return read_table(self._source, "sleeves", "sleeves")

    @property
    def outlines(self) -> dict[str, Outline]:
        """What bodies look like, by their names: `r.outlines["crank"].corners`, `.triangles`, `.lines`, and `.in_frame(r.frames[-1])`, the corners there."""
        return read_outlines(self._source)

    def _table_of_deck(self, name: str, parts: dict[str, Any]) -> Table:
        table = read_table(self._source, name, name)
        return table if len(table) else table_of_deck(name, parts)

    @property
    def stages(self) -> Named[Stage]:
        """Stages by their names, in their order: `r.stages["tones"].frequencies`. Empty if the deck has none."""
        return read_stages(self._source)

    # Other forms.

    def to_xarray(self, frames: bool = False) -> xarray.DataTree:
        """An xarray.DataTree: `tree["histories/tip"].position`, `tree["ledger"]`, `tree["solver"]`, with the dimensions time and component.

        frames: also `tree["frames"]`, all nodes at all frames, and `tree["frames/elements"]`, which takes memory.
        """
        xarray = import_xarray()
        if not hasattr(xarray, "DataTree"):
            raise ImportError(f"all results as one tree need xarray 2024.10 or newer, not {xarray.__version__}; to_xarray() of a history does not")
        nodes = {"/": xarray.Dataset(attrs={key: value for key, value in self.attributes.items() if isinstance(value, (str, int, float))})}
        nodes.update({f"histories/{name}": history.to_xarray() for name, history in self.histories.items()})
        nodes.update({f"sampled/{name}": history.to_xarray() for name, history in self.sampled.items()})
        nodes.update({record._path: record.to_xarray() for record in (self.ledger, self.solver)})
        if self._source.once("has inputs", lambda file: "inputs" in file):
            nodes["inputs"] = self.inputs.to_xarray()
        if frames:
            nodes["frames"] = self._frames_to_xarray(self.frames, "node")
            nodes["frames/elements"] = self._frames_to_xarray(self.frames.elements, "element")
        return xarray.DataTree.from_dict(nodes)

    def _frames_to_xarray(self, fields, row):
        xarray = import_xarray()
        arrays = {}
        for name in fields.names:
            quantity, values = fields.describe(name), fields[name]
            # Of what does not move, one row for all frames.
            dims = (row,) if name in STILL else (self.time_name, row, "component")[: values.ndim]
            arrays[f"{name}_number" if name == row else name] = (dims, values, attributes_of(quantity))
        return xarray.Dataset(arrays, {self.time_name: self.frames.time, "component": list("xyz")})

    def plot(self, what: str = "shapes", **options: Any) -> matplotlib.figure.Figure:
        """A matplotlib Figure, as gxrod-plot draws it: see `gxrod.plot.draw`.

        what: "shapes", "histories", "ledger", "found" (modes, buckling, answers), "stress", "section", "range" or "all".
        """
        from ..plot import draw

        return draw(self, what, **options)

    def show(self, height: int = 720) -> Page:
        """The page of `gxrod report`, with the motion in 3D and all charts: shown in a notebook as the last line of a cell,
        elsewhere `.open()` shows it in the browser. height: in pixels, in a notebook. Needs the program gxrod."""
        from ..page import make_page

        return make_page(self.path, height)

    def _headline(self):
        count = max(len(self.time) - 1, 0)
        until = f" to {self.time_name} {self.time[-1]:g}" if count else ""
        return f"{self.title}: {self.path.name}, {self.status}, {count} steps{until}"

    def _rows(self):
        rows = [("status", self.status + (f": {self.reason}" if self.reason else "")), ("deck", f"{self.deck_name}, {self.analysis}"),
                ("units", self.units), ("histories", ", ".join(f"{name} ({', '.join(each.names)})" for name, each in self.histories.items())),
                ("frames", self.frames._headline()), ("rods", ", ".join(self.rods)),
                *((name, ", ".join(map(str, getattr(self, name).name))) for name in ("joints", "springs", "bushings") if len(getattr(self, name))),
                ("stages", ", ".join(f"{name} ({stage.kind})" for name, stage in self.stages.items())),
                *(("warning", text) for text in self.warnings)]
        return [row for row in rows if row[1]]


def read_cells(results):
    """Which nodes the cells have: `gxrod.results.frames.Cells`."""
    return frames.read_cells(results._source)


__all__ = ["Results", "open_results", "read_cells"]
