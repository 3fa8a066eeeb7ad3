"""The bodies of an htc file: blocks `begin NAME; … end NAME;`, in them commands that end in a semicolon, after which comments stand."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..typed import Array
from .text import Lines, UnusedKeys

USED = ("name", "filename", "set", "sec", "concentrated_mass")
# Commands of HAWC2's mesh and output.
NOT_NEEDED = ("type", "nbodies", "node_distribution", "nsec", "fpm", "beam_output_file_name", "body_output_file_name", "body_eigenanalysis_file_name", "structure_eigenanalysis_file_name",
              "elem_eigenanalysis_file_name")


@dataclass
class Body:
    """A main_body with sections along a curve. `points` [k,3] in HAWC2's axes; `twist` [k] in rad, about z; `chosen` set and subset; `masses` and `unused`: commands that were not used."""

    lines: Lines
    name: str
    points: Array
    twist: Array
    st_name: str
    st_line: int
    chosen: tuple[int, int]
    damping: str
    masses: list[str]
    unused: UnusedKeys


@dataclass
class Command:
    line: int
    words: list[str]
    within: tuple[str, ...]  # the blocks around it, outermost first


def is_htc(text: str) -> bool:
    return "begin main_body" in " ".join(text.lower().split())


def read_commands(lines: Lines) -> Iterator[tuple[int, Command]]:
    """The commands of the file, each with the number of the main_body in which it stands, from 1."""
    blocks: list[str] = []
    body = 0
    for number, line in enumerate(lines.lines, 1):
        words = line.split(";")[0].split()
        if not words:
            continue
        if words[0].lower() == "begin" and len(words) > 1:
            body += words[1].lower() == "main_body"
            blocks.append(words[1].lower())
        elif words[0].lower() == "end" and blocks:
            blocks.pop()
        elif blocks:
            yield body, Command(number, words, tuple(blocks))


def read_body(lines: Lines, name: str | None) -> Body:
    """The body of a name, by default the first one with a blade's name, or the only one that has a curve."""
    bodies: dict[int, list[Command]] = {}
    for number, command in read_commands(lines):
        if "main_body" in command.within:
            bodies.setdefault(number, []).append(command)
    named = {word_after(commands, "name"): commands for commands in bodies.values() if any("c2_def" in command.within for command in commands)}
    if name is None:
        blades = [each for each in named if "blade" in each.lower()] or list(named)[:2]
        if not blades or len(blades) > 1 and "blade" not in blades[0].lower():
            raise lines.fault(f"which body is meant: {', '.join(named) or 'none has a c2_def'}", "name it with --body", 0)
        name = blades[0]
    if name not in named:
        raise lines.fault(f'there is no body "{name}" with a c2_def; there are {", ".join(named)}', "name one of them with --body", 0)
    return make_body(lines, name, named[name])


def word_after(commands: list[Command], key: str) -> str:
    return next((command.words[1] for command in commands if command.words[0].lower() == key and len(command.words) > 1), "")


def make_body(lines: Lines, name: str, commands: list[Command]) -> Body:
    rows = [numbers_of(lines, command, 2, 4, "x, y, z and twist") for command in commands if command.within[-1] == "c2_def" and command.words[0].lower() == "sec"]
    if len(rows) < 2:
        raise lines.fault(f"the c2_def of {name} has {len(rows)} lines sec; expected two or more", "give the curve of the body", commands[0].line)
    table = np.array(rows)
    st = [command for command in commands if command.within[-1] == "timoschenko_input"]
    named = next((command for command in st if command.words[0].lower() == "filename" and len(command.words) > 1), None)
    if named is None:
        raise lines.fault(f"the body {name} names no st file", "add timoschenko_input with filename", commands[0].line)
    chosen = next((numbers_of(lines, command, 1, 2, "set and subset") for command in st if command.words[0].lower() == "set"), [1.0, 1.0])
    damping = next((" ".join(command.words) for command in commands if command.words[0].lower().startswith("damping")), "")
    masses = [" ".join(command.words[1:]) for command in commands if command.words[0].lower() == "concentrated_mass"]
    unused = UnusedKeys("command", USED, NOT_NEEDED)
    for command in commands:
        word = command.words[0]
        if word.lower() not in USED and not word.lower().startswith("damping"):
            unused.add(word)
    return Body(lines, name, table[:, :3], np.radians(table[:, 3]), named.words[1], named.line, (int(chosen[0]), int(chosen[1])), damping, masses, unused)


def numbers_of(lines: Lines, command: Command, first: int, count: int, what: str) -> list[float]:
    """`count` numbers of a command, from its word `first` on."""
    words = command.words[first:first + count]
    lines.at = command.line + 1
    if len(words) < count:
        raise lines.fault(f"expected {count} numbers ({what}), found {len(words)}", "correct this line")
    return [lines.number(word, f"expected {count} numbers ({what})") for word in words]
