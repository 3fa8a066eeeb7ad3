"""Units of what the deck's label names, "m kg s", "mm N s", "m kN", in any order; as in apps/report/src/units.js."""

NAMES = {
    "length": ("m", "mm", "cm", "dm", "km", "µm", "um", "in", "ft"),
    "time": ("s", "ms", "min", "h"),
    "mass": ("kg", "g", "mg", "t", "slug", "lbm"),
    "force": ("N", "kN", "MN", "mN", "lbf", "kip", "dyn"),
}
# What mass · length / time² is called, where it has a name.
FORCES = {"kg m s": "N", "t m s": "kN", "t mm s": "N", "g mm ms": "N", "kg mm ms": "kN", "g cm s": "dyn", "slug ft s": "lbf"}
POWERS = {1: "", 2: "²", 3: "³", 4: "⁴"}


def read_units(label):
    """{of length, time, mass, force, angle as far as the label names them: a product {unit: power}}; {} if it says anything else."""
    words = {}
    for word in label.replace(",", " ").replace(";", " ").replace("·", " ").split():
        kind = next((kind for kind, names in NAMES.items() if word in names), None)
        if kind is None or kind in words:
            return {}
        words[kind] = word
    units = {kind: {word: 1} for kind, word in words.items()}
    units["angle"] = {"rad": 1}
    length, time, mass, force = (words.get(kind) for kind in ("length", "time", "mass", "force"))
    if not length or not time:
        return units
    if mass and not force:
        name = FORCES.get(f"{mass} {length} {time}")
        units["force"] = {name: 1} if name else {mass: 1, length: 1, time: -2}
    if force and not mass:
        units["mass"] = {force: 1, time: 2, length: -1}
    return units


def unit_of(dimension, units):
    """"N·m" for "force·length", "m/s²" for "length/time²"; the dimension itself where a unit of it is not known; angles are in rad."""
    if dimension in ("", "1"):
        return ""
    powers = {}
    for sign, part in zip((1, -1), dimension.split("/")):
        for factor in part.split("·"):
            kind = factor.removesuffix("²")
            if kind not in units:
                return dimension.replace("angle", "rad")
            for name, power in units[kind].items():
                powers[name] = powers.get(name, 0) + power * sign * (2 if factor.endswith("²") else 1)
    above, below = (write_product(powers, sign) for sign in (1, -1))
    return (above or "1") + (f"/{below}" if below else "")


def write_product(powers, sign):
    return "·".join(name + POWERS.get(sign * power, "") for name, power in powers.items() if sign * power > 0)
