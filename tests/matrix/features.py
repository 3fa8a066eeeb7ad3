"""What a user can put into a deck, a feature each: a function that adds it to the cantilever of `cantilever`.

Features of one group exclude each other. `follows_load` says that the state at the end depends on the way to it (friction,
plasticity, relaxation), so that other ways need not agree but finer steps must. A feature of `time` acts only in kinds
that have time. The numbers are drawn by `draw`, a random.Random, within what makes sense."""

import dataclasses
import pathlib


@dataclasses.dataclass(frozen=True)
class Feature:
    name: str
    group: str
    add: object
    follows_load: bool = False
    by_steps: bool = False  # discretised rotations depend on steps, slightly
    kinked: bool = False  # forces with kinks: schemes lose their order
    sudden: bool = False  # acts at once, whatever P is
    timed: bool = False  # depends on the time of a stage
    damped: bool = False  # eigenvalues have a real part


FEATURES = {}


def feature(group, **traits):
    def register(add):
        name = add.__name__.strip("_").replace("_", "-")
        FEATURES[name] = Feature(name, group, add, **traits)
        return add
    return register


def cantilever():
    """One metre, clamped at its start, under its weight and a force at its end; P multiplies both."""
    return {
        "gravity": [0, 0, "-P"],
        "parameters": {"P": 1.0},
        "section": {"bar": {
            "stiffness": {"EA": 1e3, "GAy": 500.0, "GAz": 500.0, "GJ": 1.0, "EIy": 1.0, "EIz": 1.5},
            "inertia": {"rhoA": 1.0, "rhoJ": 0.02, "rhoIy": 0.01, "rhoIz": 0.01},
        }},
        "rod": {"beam": {"section": "bar", "line": {"from": [0, 0, 0], "to": [1, 0, 0]}, "elements": 6, "order": 2,
                         "y_axis": [0, 1, 0]}},
        "support": [{"at": "beam.start", "fix": "all"}],
        "load": [{"at": "beam.end", "force": [0, "0.1*P", "0.05*P"]}],
        "history": [{"name": "tip", "at": "beam.end", "quantities": ["position", "displacement", "rotation_vector"]},
                    {"name": "middle", "at": "beam@0.5", "quantities": ["displacement", "moment"]}],
    }


def section(deck):
    return deck["section"]["bar"]


def add_load(deck, **entries):
    deck["load"].append(entries)


# Elements and shapes


@feature("none")
def plain(deck, draw):
    pass


@feature("element", by_steps=True)
def simo(deck, draw):
    deck["rod"]["beam"] |= {"element": "simo", "order": draw.choice([1, 2])}


@feature("element")
def order_1(deck, draw):
    deck["rod"]["beam"] |= {"order": 1, "elements": 12}


@feature("element")
def order_3(deck, draw):
    deck["rod"]["beam"] |= {"order": 3, "elements": 3}


@feature("element")
def order_4(deck, draw):
    deck["rod"]["beam"] |= {"order": 4, "elements": 3, "spacing": [[0, 1], [1, draw.uniform(1, 3)]]}


def replace_line(deck, **line):
    beam = deck["rod"]["beam"]
    del beam["line"], beam["y_axis"]
    beam |= line


@feature("shape")
def arc(deck, draw):
    replace_line(deck, arc={"from": [0, 0, 0], "through": [0.5, draw.uniform(0.1, 0.3), 0.1], "to": [1, 0, 0]})


@feature("shape")
def helix(deck, draw):
    replace_line(deck, helix={"centre": [0, 0.2, 0], "axis": [1, 0, 0], "from": [0, 0, 0], "turns": 0.75, "pitch": 1.0})


@feature("shape")
def corner(deck, draw):
    replace_line(deck, polyline=[[0, 0, 0], [0.5, 0, 0.2], [1, draw.uniform(0.1, 0.4), 0]])


@feature("rest", sudden=True)
def rest_curvature(deck, draw):
    deck["rod"]["beam"]["rest"] = {"curvature": ["0.2", draw.uniform(0.1, 0.4), "0.3*s"]}


@feature("twist")
def twist(deck, draw):
    deck["rod"]["beam"]["twist"] = draw.uniform(0.3, 1.5)


@feature("plane")
def plane(deck, draw):
    deck["plane"] = "xz"
    deck["load"][0]["force"] = [0, 0, "0.05*P"]


# Sections and their laws


@feature("matrix")
def offset_section(deck, draw):
    section(deck)["at"] = [draw.uniform(-0.05, 0.05), 0.03]


@feature("taper")
def taper(deck, draw):
    section(deck)["stiffness"] |= {"EIy": "1.2 - 0.5*s", "EIz": "1.8 - 0.7*s", "EA": "1000 - 400*s"}
    section(deck)["inertia"]["rhoA"] = "1.1 - 0.3*s"


def cut(deck, shape, **tables):
    """A shape that is cut into cells in place of the numbers of the section, about as stiff and as heavy."""
    bar = section(deck)
    for key in ("stiffness", "inertia", "material"):
        bar.pop(key, None)
    bar["shape"] = shape
    if not tables:
        bar["material"] = {"E": 2.5e5, "nu": 0.3, "density": 340}
    deck |= tables


@feature("taper")
def box(deck, draw):
    cut(deck, {"box": {"height": draw.uniform(0.09, 0.11), "width": 0.08, "wall": 0.01, "outer_radius": 0.012, "inner_radius": 0.004}})


@feature("taper")
def tapered_box(deck, draw):
    cut(deck, {"box": {"height": "0.11 - 0.03*s", "width": 0.08, "wall": 0.01, "outer_radius": 0.012, "inner_radius": 0.004}})


@feature("taper")
def plies(deck, draw):
    corners = [[-0.04, -0.05], [0.04, -0.05], [0.04, 0.05], [-0.04, 0.05]]
    cut(deck, {"walls": {"corners": corners, "closed": True, "line": "right", "layup": "skin"}},
        material={"ply": {"E": [4e5, 1e5], "G": 1.5e5, "nu": 0.3, "density": 340}},
        layup={"skin": {"plies": [["ply", 0.005, draw.uniform(0.2, 0.6)], ["ply", 0.005, -0.3]]}})


def with_stresses(deck, shape, point):
    cut(deck, shape)
    deck["output"] = {"stresses": "von-mises"}
    deck["history"] += [{"name": "root", "at": "beam.start", "quantities": ["von_mises"]},
                        {"name": "edge", "at": "beam@0.5", "point": point, "quantities": ["stress", "principal_stress"]}]


@feature("taper")
def stresses(deck, draw):
    height = draw.uniform(0.09, 0.11)
    with_stresses(deck, {"rectangle": {"width_y": 0.08, "height_z": height}}, [0.04, height / 2])


@feature("taper")
def tapered_stresses(deck, draw):
    with_stresses(deck, {"rectangle": {"width_y": 0.08, "height_z": "0.11 - 0.03*s"}}, [0.04, 0.0475])


@feature("taper")
def material_by_name(deck, draw):
    cut(deck, {"box": {"height": draw.uniform(0.09, 0.11), "width": 0.08, "wall": 0.01, "outer_radius": 0.012, "inner_radius": 0.004}},
        material={"metal": {"E": 2.5e5, "nu": 0.3, "density": 340}})
    section(deck)["material"] = "metal"


@feature("law")
def trapeze(deck, draw):
    section(deck)["trapeze"] = True


@feature("damping", damped=True)
def kelvin_voigt(deck, draw):
    section(deck)["damping"] = {"kelvin_voigt": draw.uniform(5e-3, 3e-2)}


@feature("damping", damped=True)
def mass_damping(deck, draw):
    section(deck)["damping"] = {"mass_proportional": draw.uniform(0.2, 1)}


@feature("law", follows_load=True, damped=True)
def viscoelastic(deck, draw):
    section(deck)["law"] = {"viscoelastic": {"prony": [[draw.uniform(0.2, 0.6), 0.1], [0.3, 0.5]]}}


@feature("law", follows_load=True, kinked=True)
def plastic(deck, draw):
    section(deck)["law"] = {"plastic": {"yield": {"My": draw.uniform(0.2, 0.6), "Mz": 0.5}, "kinematic": 0.5}}


@feature("law", follows_load=True, kinked=True)
def layers(deck, draw):
    section(deck)["law"] = {"layers": [{"on": "bending", "stiffness": 0.5, "limit": draw.uniform(0.05, 0.2)}]}


@feature("law", kinked=True)
def moment_table(deck, draw):
    section(deck)["law"] = {"moment_curvature": {"table": [[0, 0], [0.2, 0.3], [0.6, 0.6]]}}


@feature("law", kinked=True)
def tension_table(deck, draw):
    section(deck)["law"] = {"tension_strain": {"table": [[0, 0], [0.01, draw.uniform(5, 20)], [0.03, 60]]}}


@feature("law", follows_load=True, kinked=True)
def stretched_rope(deck, draw):
    section(deck)["law"] = {"tension_strain": {"table": [[0, 0], [0.01, draw.uniform(5, 20)], [0.03, 60]], "unloading_stiffness": 5000}}


@feature("law", follows_load=True, kinked=True, damped=True)
def fibre_rope(deck, draw):
    section(deck)["law"] = {"syrope": {"original": [[0, 0], [0.01, draw.uniform(5, 20)], [0.03, 60]], "k1": 0.2, "k2": 0.5,
                                       "dynamic_stiffness": 8000, "per_tension": 20, "damping": 3000}}


@feature("law", follows_load=True, kinked=True)
def hysteresis(deck, draw):
    section(deck)["law"] = {"moment_curvature": {"table": [[0, 0], [0.2, 0.3], [0.6, 0.6]], "hysteresis": "kinematic"}}


@feature("law", follows_load=True, kinked=True)
def yield_stress(deck, draw):
    bar = section(deck)
    for key in ("stiffness", "inertia"):
        bar.pop(key, None)
    bar |= {"shape": {"rectangle": {"width_y": 0.11, "height_z": 0.1}},
            "material": {"E": 1e5, "nu": 0.3, "density": 100, "yield_stress": draw.uniform(2000, 4000)}}


@feature("law", follows_load=True, kinked=True)
def fibres_of_cells(deck, draw):
    cut(deck, {"I": {"height": 0.1, "width": 0.08, "web": 0.008, "flange": 0.01, "fillet": 0.008}})
    section(deck)["material"] |= {"yield_stress": draw.uniform(8000, 11000), "interaction": True}


# Loads


@feature("load-follower")
def follower(deck, draw):
    add_load(deck, at="beam.end", force=[0, 0, f"{draw.uniform(-0.5, 0.5)}*P"], frame="follower")


@feature("load-moment")
def moment(deck, draw):
    add_load(deck, at="beam.end", moment=["0.1*P", f"{draw.uniform(-0.6, 0.6)}*P", 0])


@feature("load-line")
def line_load(deck, draw):
    add_load(deck, on="beam", force_per_length=["0.2*P*s", 0, f"{draw.uniform(-1, 1)}*P"])


@feature("load-file")
def loads_of_a_file(deck, draw):
    """At stations, over time in kinds that have it."""
    file = pathlib.Path(__file__).with_name("stations.csv")
    add_load(deck, on="beam", file=str(file), frame=draw.choice(["body", "spatial", "follower"]), factor="P")


@feature("load-place")
def load_by_place(deck, draw):
    add_load(deck, at="beam.end", force=["-0.5*P*(x - 1)", "-0.3*P*y", 0])


@feature("load-rate", damped=True)
def load_by_rate(deck, draw):
    add_load(deck, at="beam.end", force=["-0.2*vx", "-0.2*vy", "-0.2*vz"])


@feature("load-turn", damped=True)
def load_by_turn(deck, draw):
    add_load(deck, at="beam.end", moment=["-0.05*P*rx - 0.01*wx", "-0.04*P*ry", f"{draw.uniform(0.1, 0.5)}*P - 0.02*wz"])


@feature("load-line-motion", damped=True)
def line_load_by_motion(deck, draw):
    add_load(deck, on="beam", force_per_length=["-0.1*vx", "-0.3*P*y*s", f"{draw.uniform(-1, 1)}*P - 0.2*vz"],
             moment_per_length=["-0.03*P*rx", 0, "-0.01*wz"])


@feature("load-time", timed=True)
def load_by_time(deck, draw):
    deck["function"] = deck.get("function", {}) | {"ramp": {"table": [[0, 0], [0.25, 1], [5, 1]]}}
    add_load(deck, at="beam.end", force=[0, "0.3*P*ramp(t)", 0])


@feature("heat")
def heat(deck, draw):
    section(deck)["expansion"] = 1e-3
    deck["actuation"] = deck.get("actuation", []) + [
        {"on": "beam", "temperature": f"{draw.uniform(5, 20)}*P", "temperature_gradient": [0, "30*P"]}]


@feature("heat")
def bimetal(deck, draw):
    cut(deck, {"walls": {"corners": [[-0.05, 0], [0.05, 0]], "layup": "both"}},
        material={"lower": {"E": 1.5e5, "nu": 0.3, "density": 100, "expansion": 1e-3},
                  "upper": {"E": 1e5, "nu": 0.3, "density": 100, "expansion": 2e-3}},
        layup={"both": {"plies": [["lower", 0.05], ["upper", 0.05]]}})
    deck["actuation"] = deck.get("actuation", []) + [
        {"on": "beam", "temperature": f"{draw.uniform(5, 20)}*P", "temperature_gradient": [0, "30*P"]}]


@feature("actuation")
def actuation(deck, draw):
    deck["actuation"] = deck.get("actuation", []) + [
        {"on": "beam", "curvature": ["0.2*P", f"{draw.uniform(-0.5, 0.5)}*P", "0.3*P*s"], "stretch": "0.01*P"}]


@feature("tendon")
def tendon(deck, draw):
    deck["tendon"] = {"pull": {"on": "beam", "offset": [0, 0.05], "tension": f"{draw.uniform(0.5, 3)}*P"}}


@feature("chamber")
def chamber(deck, draw):
    deck["chamber"] = {"bellows": {"on": "beam", "offset": [0, 0.05], "area": 0.01, "pressure": f"{draw.uniform(50, 300)}*P"}}


@feature("chamber")
def gas_chamber(deck, draw):
    deck["chamber"] = {"bellows": {"on": "beam", "offset": [0, 0.05], "area": 0.01,
                                   "gas": {"pressure": f"{draw.uniform(50, 300)}*P", "ambient": 1000.0, "exponent": 1.4}}}


@feature("tendon", kinked=True)
def winch(deck, draw):
    deck["tendon"] = {"winch": {"on": "beam", "offset": [0, 0.05], "shortening": f"{draw.uniform(0.005, 0.02)}*P",
                                "stiffness": 50.0}}


@feature("tendon", follows_load=True, kinked=True)
def tendon_friction(deck, draw):
    deck["tendon"] = {"pull": {"on": "beam", "offset": [0, 0.05], "tension": "2*P", "friction": draw.uniform(0.1, 0.4),
                               "stiffness": 200.0}}


@feature("magnet")
def magnetic(deck, draw):
    deck["magnetic"] = [{"on": "beam", "moment": [0.5, 0, 0], "field": [0, "0.3*P", f"{draw.uniform(0.1, 0.6)}*P*(1 + x)"]}]


# Bodies, springs, joints, supports


def add_mass(deck, **entries):
    deck["body"] = deck.get("body", {}) | {"weight": {"mass": 0.3, "inertia": [0.01, 0.01, 0.01], "at": "beam.end", **entries}}


@feature("body")
def body(deck, draw):
    add_mass(deck, centre_of_mass=[0.05, 0, draw.uniform(-0.05, 0.05)])


@feature("body")
def drawn_body(deck, draw):
    add_mass(deck, looks=[{"box": {"size": [0.1, 0.1, draw.uniform(0.05, 0.2)]}}, {"arms": 0}])


@feature("spring", damped=True)
def spring(deck, draw):
    deck["spring"] = {"guy": {"between": ["beam.end", "ground"], "at_b": [1, 0, draw.uniform(0.3, 1)], "stiffness": 2.0,
                              "damping": 0.05}}


@feature("spring", sudden=True)
def taut_spring(deck, draw):
    deck["spring"] = {"guy": {"between": ["beam.end", "ground"], "at_b": [1, 0, 0.5], "stiffness": 2.0,
                              "length": draw.uniform(0.2, 0.45)}}


@feature("spring", kinked=True)
def kinked_spring(deck, draw):
    free = draw.uniform(0.9, 0.97)
    deck["spring"] = {"stop": {"between": ["beam.end", "ground"], "at_b": [1, 0, -1],
                               "force": f"length < {free} ? 50*(length - {free}) : 0"}}


@feature("spring", kinked=True)
def jumping_spring(deck, draw):
    deck["spring"] = {"stop": {"between": ["beam.end", "ground"], "at_b": [1, 0, -1],
                               "force": f"length < {draw.uniform(0.9, 0.97)} ? 50*(length - 0.95) : 0"}}


@feature("bushing", damped=True)
def bushing(deck, draw):
    deck["bushing"] = {"mount": {"between": ["ground", "beam.end"], "at": [1, 0, 0],
                                 "stiffness": {"y": 1.0, "z": 2.0, "rx": 0.2, "ry": draw.uniform(0.1, 0.5)},
                                 "damping": {"z": 0.05}}}


@feature("bushing", damped=True)
def bearing(deck, draw):
    """Alike to all sides of the x axis, which the ground carries: it lets the beam turn."""
    stiffness = draw.uniform(1, 4)
    deck["bushing"] = {"mount": {"between": ["ground", "beam.end"], "at": [1, 0, 0], "axes": "ground",
                                 "stiffness": {"y": stiffness, "z": stiffness, "ry": 0.3, "rz": 0.3},
                                 "damping": {"y": 0.05, "z": 0.05}}}


@feature("ball-bearing")
def ball_bearing(deck, draw):
    """A joint to a point of the x axis, in which the end of the beam slides and turns."""
    deck["joint"] = deck.get("joint", {}) | {"tail": {"type": "cylinder", "between": ["ground", "beam.end"], "at": [1, 0, 0],
                                                      "axis": [1, 0, 0], "spring": {"slide": {"stiffness": draw.uniform(5, 50)}}}}


@feature("copies")
def copies(deck, draw):
    """Three arms at the end of the beam, written once."""
    deck["rod"]["arm"] = {"section": "bar", "line": {"from": [1, 0, 0], "to": [1, draw.uniform(0.2, 0.4), 0]}, "elements": 2, "order": 2,
                          "y_axis": [1, 0, 0], "copies": {"count": 3, "about": [1, 0, 0]}}
    deck["connect"] = deck.get("connect", []) + [{"points": ["beam.end", "arm.start"], "copies": "arm"}]


@feature("brace")
def hinged_brace(deck, draw):
    """A prop with hinges at both ends, from the middle of the beam to a post beneath it."""
    foot = [0.3, 0, draw.uniform(-0.4, -0.2)]
    deck["rod"]["prop"] = {"section": "bar", "line": {"from": foot, "to": [0.5, 0, 0]}, "elements": 2, "order": 2, "y_axis": [0, 1, 0],
                           "hinges": ["start", "end"]}
    deck["rod"]["post"] = {"section": "bar", "line": {"from": [0.3, 0, -0.6], "to": foot}, "elements": 1, "order": 2, "y_axis": [0, 1, 0]}
    deck["support"].append({"at": "post.start", "fix": "all"})
    deck["connect"] = deck.get("connect", []) + [{"points": "coincident", "on": ["beam", "p*"]}]


@feature("part")
def part_load(deck, draw):
    """A load along the second half of the beam, by its elements."""
    add_load(deck, on="b*", where="x > 0.5", force_per_length=[0, f"{draw.uniform(0.05, 0.2)}*P", 0])


def put_on_joint(deck, **joint):
    deck["support"] = [support for support in deck["support"] if support["at"] != "beam.start"]
    deck["joint"] = {"root": {"between": ["ground", "beam.start"], **joint}}


@feature("root")
def hinge_spring(deck, draw):
    put_on_joint(deck, type="hinge", axis=[0, 1, 0], spring={"stiffness": draw.uniform(2, 10)})
    deck["history"].append({"name": "root", "at": "root", "quantities": ["angle"]})


@feature("root")
def weld(deck, draw):
    put_on_joint(deck, type="weld")


@feature("root", timed=True)
def motor(deck, draw):
    put_on_joint(deck, type="hinge", axis=[0, 1, 0], move=f"{draw.uniform(0.1, 0.4)}*P*sin(pi*t/2)^2")
    deck["history"].append({"name": "root", "at": "root", "quantities": ["angle", "drive"]})


@feature("root", follows_load=True, kinked=True)
def hinge_friction(deck, draw):
    put_on_joint(deck, type="hinge", axis=[0, 1, 0], spring={"stiffness": 3.0},
                 friction={"moment": draw.uniform(0.05, 0.3)})


@feature("root", kinked=True)
def hinge_limits(deck, draw):
    put_on_joint(deck, type="hinge", axis=[0, 1, 0], spring={"stiffness": 1.0},
                 limits={"lower": -0.3, "upper": draw.uniform(0.05, 0.2), "stiffness": 50.0})


@feature("root", follows_load=True, kinked=True)
def stops(deck, draw):
    put_on_joint(deck, type="hinge", axis=[0, 1, 0], spring={"stiffness": 1.0},
                 limits={"lower": -0.3, "upper": draw.uniform(0.05, 0.2)})


@feature("root", kinked=True)
def clearance(deck, draw):
    put_on_joint(deck, type="hinge", axis=[0, 1, 0], spring={"stiffness": 3.0},
                 clearance={"gap": draw.uniform(1e-3, 4e-3), "stiffness": 400.0})
    deck["bushing"] = deck.get("bushing", {}) | {"soft": {"between": ["ground", "beam.start"], "at": [0, 0, 0],
                                                          "stiffness": {"x": 40.0, "z": 40.0}}}
    deck["history"].append({"name": "root", "at": "root", "quantities": ["play", "force"]})


@feature("root", kinked=True)
def backlash(deck, draw):
    put_on_joint(deck, type="hinge", axis=[0, 1, 0], spring={"stiffness": 3.0})
    deck["body"] = deck.get("body", {}) | {"wheel": {"mass": 0.1, "inertia": [0.01, 0.01, 0.01], "at": [0, 0.5, 0]}}
    deck["joint"]["axle"] = {"type": "hinge", "between": ["ground", "wheel"], "axis": [0, 1, 0], "spring": {"stiffness": 1.0}}
    deck["gear"] = {"pair": {"joints": ["root", "axle"], "ratio": 1.5, "backlash": draw.uniform(0.01, 0.03), "stiffness": 50.0}}
    deck["history"].append({"name": "pair", "at": "pair", "quantities": ["play", "drive"]})


@feature("rope", follows_load=True, kinked=True)
def rope(deck, draw):
    deck["joint"] = deck.get("joint", {}) | {"rope": {"type": "distance", "between": ["ground", "beam.end"], "at_a": [1, 0, 1],
                                                      "length": draw.uniform(1.01, 1.05), "slack": True}}
    deck["history"].append({"name": "rope", "at": "rope", "quantities": ["force"]})


def put_on_cam(deck, **joint):
    """The end of the beam rides on a hump above the ground."""
    deck["joint"] = deck.get("joint", {}) | {"cam": {
        "type": "cam", "between": ["ground", "beam.end"], "at_a": [1, 0, -0.3], "axis": [0, 1, 0], "x_axis": [0, 0, 1],
        "curve": {"radius": "0.2 + 0.03*sin(angle)^2 + 0.01*sin(angle)^3"}, "roller": 0.1, **joint}}
    deck["history"].append({"name": "cam", "at": "cam", "quantities": ["normal_force", "curve_place"]})


@feature("rope")
def cam(deck, draw):
    put_on_cam(deck)


@feature("rope", follows_load=True, kinked=True)
def lifting_cam(deck, draw):
    put_on_cam(deck, lifts=True)


@feature("root")
def universal(deck, draw):
    put_on_joint(deck, type="universal", axis=[0, 1, 0], axis_b=[0, 0, 1])
    deck["bushing"] = deck.get("bushing", {}) | {"soft": {"between": ["ground", "beam.start"], "at": [0, 0, 0], "stiffness": {"ry": 4.0, "rz": 5.0}}}


@feature("root")
def generic_joint(deck, draw):
    put_on_joint(deck, type="generic", axis=[1, 0, 0], y_axis=[0, 1, 0], holds=["position", "rx", "rz"])
    deck["bushing"] = deck.get("bushing", {}) | {"soft": {"between": ["ground", "beam.start"], "at": [0, 0, 0],
                                                          "stiffness": {"ry": draw.uniform(3, 5)}}}


@feature("root", follows_load=True, kinked=True, sudden=True)
def breaking_joint(deck, draw):
    deck["joint"] = deck.get("joint", {}) | {"prop": {"type": "generic", "between": ["ground", "beam.end"], "axis": [0, 0, 1],
                                                      "holds": "x", "breaks": {"force": draw.uniform(0.1, 0.2)}}}
    deck["history"].append({"name": "prop", "at": "prop", "quantities": ["force", "holds"]})


@feature("root", follows_load=True, timed=True, sudden=True)
def timed_break(deck, draw):
    deck["joint"] = deck.get("joint", {}) | {"prop": {"type": "generic", "between": ["ground", "beam.end"], "axis": [0, 0, 1],
                                                      "holds": "x", "breaks": {"time": draw.uniform(0.1, 0.2)}}}
    deck["history"].append({"name": "prop", "at": "prop", "quantities": ["force", "holds"]})


@feature("root")
def slider(deck, draw):
    put_on_joint(deck, type="slider", axis=[0, 0, 1], spring={"stiffness": draw.uniform(10, 40)})


@feature("root", timed=True)
def moved_support(deck, draw):
    deck["support"] = [{"at": "beam.start", "fix": ["x", "y", "rotation"],
                        "move": {"z": f"{draw.uniform(0.05, 0.15)}*P*sin(pi*t/2)^2"}}]
    deck["history"].append({"name": "root", "at": "beam.start", "quantities": ["reaction_force"]})


@feature("root")
def turned_support(deck, draw):
    deck["support"] = [{"at": "beam.start", "fix": ["position", "rx", "rz"]},
                       {"at": "beam.end", "fix": ["z"], "axes": [[0.8, 0, 0.6], [0, 1, 0], [-0.6, 0, 0.8]]}]


@feature("root", damped=True)
def yielding_support(deck, draw):
    deck["support"] = [{"at": "beam.start", "fix": ["x", "y", "rx", "rz"],
                        "stiffness": {"z": draw.uniform(10, 40), "ry": draw.uniform(2, 10)}, "damping": {"ry": 0.05}}]
    deck["history"].append({"name": "root", "at": "beam.start", "quantities": ["reaction_force", "reaction_moment"]})


@feature("imperfection")
def imperfection(deck, draw):
    deck["imperfection"] = [{"bow": draw.uniform(0.01, 0.05), "direction": [0, 1, draw.uniform(-1, 1)]},
                            {"sway": 0.02, "direction": [0, 1, 0]}]


@feature("combination")
def combination(deck, draw):
    deck["load"][0]["case"] = "live"
    deck["combination"] = {"sls": {"factors": {"live": 1.0}},
                           "uls": {"factors": {"gravity": draw.uniform(0.8, 1.4), "live": draw.uniform(0.5, 1.5)}}}
    deck["apply"] = "uls"


@feature("second-rod")
def second_rod(deck, draw):
    deck["rod"]["side"] = {"section": "bar", "line": {"from": [1, 0, 0], "to": [1, 0.5, 0]}, "elements": 3, "order": 2}
    deck["connect"] = [{"points": ["beam.end", "side.start"]}]


@feature("second-rod")
def pendulum(deck, draw):
    deck["rod"]["side"] = {"section": "bar", "line": {"from": [1, 0, 0], "to": [1, 0, -0.4]}, "elements": 3, "order": 2}
    deck["joint"] = deck.get("joint", {}) | {"knee": {"type": "ball", "between": ["beam.end", "side.start"]}}


@feature("second-rod")
def collar(deck, draw):
    """Slides along the beam and does not turn against it."""
    deck["rod"]["side"] = {"section": "bar", "line": {"from": [0.6, 0, 0], "to": [0.6, 0.2, 0.2]}, "elements": 2, "order": 2}
    deck["joint"] = deck.get("joint", {}) | {"collar": {"type": "sleeve", "between": ["beam", "side.start"], "turn": False,
                                                        "spring": {"stiffness": draw.uniform(10, 40)}}}
    deck["history"].append({"name": "collar", "at": "collar", "quantities": ["slide", "moment"]})


# Water, air, ground, contact


def wet(deck, **entries):
    section(deck)["fluid"] = {"outer_diameter": 0.04} | section(deck).get("fluid", {}) | entries


@feature("fluid", damped=True)
def current(deck, draw):
    wet(deck)
    deck["fluid"] = {"density": 100.0, "current": {"velocity": [0, f"{draw.uniform(0.1, 0.5)}*P", 0]}}


@feature("fluid", damped=True)
def turning_current(deck, draw):
    wet(deck)
    rows = [[-1, draw.uniform(0.1, 0.5), 0], [1, 0.2, draw.uniform(30, 200)]]
    deck["fluid"] = {"density": 100.0, "current": {"table": rows, "factor": "P"}}
    deck.setdefault("output", {})["line_ends"] = next(iter(deck["rod"]))


@feature("fluid", damped=True, timed=True)
def wave(deck, draw):
    wet(deck)
    deck["fluid"] = {"density": 100.0, "surface": 0.5, "depth": 10}
    deck["gravity"] = [0, 0, -1]
    deck["wave"] = [{"airy": {"height": draw.uniform(0.05, 0.2), "period": 1.0}}]


@feature("fluid", damped=True, timed=True)
def vessel(deck, draw):
    """The end of the beam follows the waves."""
    wave(deck, draw)
    deck["fluid"]["ramp"] = 0.5
    raos = pathlib.Path(__file__).with_name("raos.csv")
    deck["vessel"] = {"ship": {"rao": str(raos), "at": [1, 0, 0], "heading": draw.uniform(0, 3), "phases": "lag"}}
    deck["support"].append({"at": "beam.end", "vessel": "ship"})


@feature("fluid", damped=True)
def partial_water(deck, draw):
    """Without added mass, as water that comes and goes must be where things move."""
    wet(deck, added_mass=0)
    deck["fluid"] = {"density": 50.0, "factor": draw.uniform(0.2, 1.5)}


@feature("contents", sudden=True)
def flowing_contents(deck, draw):
    wet(deck, contents={"density": 500, "inner_diameter": 0.02, "velocity": draw.uniform(-2, 2)})


@feature("contents", sudden=True)
def contents(deck, draw):
    wet(deck, contents={"density": 500, "pressure": draw.uniform(0, 10), "inner_diameter": 0.02})
    deck.setdefault("fluid", {"density": 100.0})


@feature("air", damped=True)
def wind(deck, draw):
    wet(deck)
    deck["air"] = {"density": 1.2, "wind": {"velocity": [0, f"{draw.uniform(1, 3)}*P", 0]}}


@feature("ground", kinked=True, damped=True)
def seabed(deck, draw):
    wet(deck)
    deck["seabed"] = {"z": -0.05, "stiffness": draw.uniform(200, 1000), "damping": 1.0}


@feature("ground", follows_load=True, kinked=True, damped=True)
def seabed_friction(deck, draw):
    wet(deck)
    deck["seabed"] = {"z": -0.05, "stiffness": 500.0, "friction": draw.uniform(0.1, 0.5)}


@feature("ground", kinked=True, damped=True)
def soft_ground(deck, draw):
    wet(deck)
    deck["seabed"] = {"z": -0.05, "stiffness": 500.0, "damping": 1.0, "factor": f"{draw.uniform(0.3, 1.5)}*P"}


@feature("contact", kinked=True)
def floor(deck, draw):
    section(deck)["radius"] = 0.02
    deck["obstacle"] = {"floor": {"plane": {"point": [0, 0, -draw.uniform(0.05, 0.1)], "normal": [0, 0, 1]}}}


@feature("contact", kinked=True, timed=True)
def moved_ball(deck, draw):
    section(deck)["radius"] = 0.02
    deck["obstacle"] = {"ball": {"sphere": {"centre": [0.7, 0.01, -0.2], "radius": 0.1},
                                 "move": {"z": f"{draw.uniform(0.05, 0.15)}*t"}}}


@feature("contact", kinked=True, follows_load=True)
def rough_floor(deck, draw):
    section(deck)["radius"] = 0.02
    deck["obstacle"] = {"floor": {"plane": {"point": [0, 0, -0.07], "normal": [0, 0, 1]}, "friction": draw.uniform(0.1, 0.4)}}


@feature("contact", kinked=True, follows_load=True)
def scaly_floor(deck, draw):
    rough_floor(deck, draw)
    deck["obstacle"]["floor"]["friction"] = {"forward": draw.uniform(0.1, 0.2), "backward": draw.uniform(0.2, 0.4), "across": draw.uniform(0.1, 0.4)}


@feature("contact", kinked=True, follows_load=True)
def weakening_floor(deck, draw):
    rough_floor(deck, draw)
    deck["obstacle"]["floor"]["friction"] = {"static": draw.uniform(0.3, 0.4), "kinetic": draw.uniform(0.1, 0.2), "stribeck_speed": draw.uniform(0.05, 0.5)}


@feature("contact", kinked=True)
def bouncing_floor(deck, draw):
    section(deck)["radius"] = 0.02
    deck["obstacle"] = {"floor": {"plane": {"point": [0, 0, -0.07], "normal": [0, 0, 1]}, "restitution": draw.uniform(0.3, 0.9)}}


@feature("contact", kinked=True)
def feet(deck, draw):
    section(deck)["radius"] = 0.02
    deck["body"] = deck.get("body", {}) | {"feet": {
        "mass": 0.1, "inertia": [0.01, 0.01, 0.01], "at": "beam.end",
        "sphere": [{"radius": 0.02, "centre": [0, y, -0.03]} for y in (-0.1, draw.uniform(0.05, 0.15))],
        "capsule": {"from": [0.05, -0.1, 0], "to": [0.05, 0.1, 0], "radius": 0.02}}}
    deck["obstacle"] = {"floor": {"plane": {"point": [0, 0, -0.07], "normal": [0, 0, 1]}}}


@feature("contact", kinked=True)
def rods_touch(deck, draw):
    section(deck)["radius"] = 0.02
    deck["rod"]["lower"] = {"section": "bar", "line": {"from": [0.7, -0.4, -0.08], "to": [0.7, 0.4, -0.08]}, "elements": 6}
    deck["support"] = deck["support"] + [{"at": "lower.start", "fix": "all"}, {"at": "lower.end", "fix": "all"}]
    deck["contact"] = {"skin": 0.1}


@feature("contact", kinked=True, follows_load=True)
def scaly_rods_touch(deck, draw):
    rods_touch(deck, draw)
    deck["contact"]["friction"] = {"forward": draw.uniform(0.05, 0.1), "backward": draw.uniform(0.1, 0.2), "across": draw.uniform(0.2, 0.3),
                                   "kinetic": draw.uniform(0.1, 0.2), "stribeck_speed": draw.uniform(0.05, 0.5)}


# What drives a motion


@feature("start", sudden=True)
def initial_velocity(deck, draw):
    speed = draw.uniform(0.2, 1)
    deck["initial"] = [{"on": "beam", "velocity": [0, 0, f"{speed}*x^2"],
                        "angular_velocity": [0, f"-{2 * speed}*x", 0]}]


@feature("input", follows_load=True, timed=True, kinked=True, damped=True)
def signal(deck, draw):
    deck["signal"] = {"height": {"measure": "tip.displacement.z"},
                      "pull": {"value": "-height", "hold": "linear", "pid": {"proportional": draw.uniform(0.5, 2)}}}
    add_load(deck, at="beam.end", force=[0, 0, "pull"])


@feature("input", sudden=True)
def unset_input(deck, draw):
    deck["input"] = {"push": {"value": draw.uniform(0.05, 0.2)}}
    add_load(deck, at="beam.end", force=[0, "push", 0])
