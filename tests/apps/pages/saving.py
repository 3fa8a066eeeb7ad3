"""What the pages of gxrod report save, for their tests."""

import re
import xml.etree.ElementTree

import numpy as np

SVG = "{http://www.w3.org/2000/svg}"
CATCH = """
    window.saved = [];
    const blobs = new Map();
    const make = URL.createObjectURL;
    URL.createObjectURL = (blob) => { const address = make.call(URL, blob); blobs.set(address, blob); return address; };
    HTMLAnchorElement.prototype.click = function () { saved.push([this.download, blobs.get(this.href)]); };"""
READ = """
    const done = arguments[0];
    const read = (blob) => new Promise((ok) => { const reader = new FileReader(); reader.onload = () => ok(reader.result.split(',')[1]); reader.readAsDataURL(blob); });
    Promise.all(saved.splice(0).map(async ([name, blob]) => [name, await read(blob)])).then(done);"""


class Picture:
    """A saved SVG: its texts, and the paths of its curves."""

    def __init__(self, data):
        self.root = xml.etree.ElementTree.fromstring(data)
        self.texts = [text.text for text in self.root.iter(f"{SVG}text")]
        self.height = float(self.root.get("height"))

    def plot(self):
        return [group for group in self.root if group.tag == f"{SVG}g" and "scale" in group.get("transform", "")][0]

    def ticks(self, anchor):
        """Places and labels of ticks: "middle" across, "end" upwards."""
        found = []
        for text in self.plot().iter(f"{SVG}text"):
            if text.get("text-anchor") != anchor or text.get("fill") is None:
                continue
            x, y = float(text.get("x")), float(text.get("y"))
            matrix = [float(part) for part in re.findall(r"[-\d.e]+", text.get("transform", "matrix(1 0 0 1 0 0)"))]
            if matrix[:4] == [1, 0, 0, 1] and (number := to_number(text.text)) is not None:
                found.append((x + matrix[4] if anchor == "middle" else y + matrix[5], number, text.text))
        return found

    def curves(self, colour):
        """Points [n,2] of each stroked path of a colour."""
        paths = [path for path in self.plot().iter(f"{SVG}path") if path.get("stroke") == colour]
        assert all(path.get("d").startswith("M") for path in paths), "a path without a start is drawn by no program"
        return [np.array([[float(part) for part in point.split()] for point in re.findall(r"[ML]([-\d.]+ [-\d.]+)", path.get("d"))]) for path in paths]


def to_number(text):
    """Of a label as the page writes it."""
    plain = text.replace("−", "-").replace("·10", "e").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    try:
        return float(plain)
    except ValueError:
        return None
