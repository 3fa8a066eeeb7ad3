"""Judges random mechanisms by what must hold of every one."""

import dataclasses
import re

import numpy as np

import mechanism_deck
import mechanisms
from draw import Draw
from mechanism_runs import Runner, RunFailed
from mobility import Mobility
from verdict import Verdict, processor_time

CLOSED = 1e-12  # of the model's length
TOLERANCE_LEAVES = 1e-6  # of the energy, where forces of joints are a thousand times those that move: 1e-10 of them
SMALL = 1e-7    # differences by Newton's tolerance, of the model's length
FALL = {1: 0.75, 2: 0.35, 4: 0.15}  # of an error, at most, by its order
UNIT = 1024.0
LEAST_ENERGY = 1e-9  # of what bodies would have that cross the model in the time of the run; below, there is round-off alone
ORDERS = {"sdirk-4": 4, "runge-kutta-4": 4}


@dataclasses.dataclass
class Check:
    name: str
    value: float  # what was measured
    is_met: bool
    note: str = ""


class MechanismJudge:
    def __init__(self, program, seed, folder):
        self.seed, self.runner = seed, Runner(program, folder)

    def judge(self, index):
        """All checks of a mechanism; the first one alone if it does not run."""
        maker = mechanisms.Maker(self.seed, index)
        return self.judge_mechanism(maker.make(), maker.size, index)

    def judge_mechanism(self, mechanism, length, index):
        """`length`: about that of its parts."""
        draw = Draw(self.seed + 2 * mechanisms.STREAM, index)
        try:
            results = self.runner.run(mechanism)
        except RunFailed as failure:
            return [Check("complete", 0.0, False, str(failure))]
        size = extent(results, mechanism)
        known = {1: results}

        def runs(finer):
            """With so many times the steps."""
            if finer not in known:
                known[finer] = self.runner.run(mechanism, steps=finer * mechanism["analysis"]["steps"])
            return known[finer]

        checks = [Check("complete", 0.0, True), check_gap(results, size), self.check_count(mechanism, length)]
        for check in (self.check_resume, self.check_exchanged, self.check_moved, self.check_units, self.check_energy,
                      self.check_momentum, self.check_scheme):
            try:
                checks += check(mechanism, runs, size, draw)
            except RunFailed as failure:
                checks.append(Check(check.__name__, np.inf, False, str(failure)))
        return checks

    def verdict(self, index):
        """Sound, or a finding with the checks that are not met."""
        before = processor_time()
        missed = [check for check in self.judge(index) if not check.is_met]
        self.runner.write(mechanisms.make_mechanism(self.seed, index))
        return Verdict(index, "finding" if missed else "sound", ", ".join(check.name for check in missed),
                       seconds=processor_time() - before,
                       message="; ".join(f"{check.name}: {check.value:.3g} {check.note}".strip() for check in missed))

    def check_count(self, mechanism, size):
        """The free motions that gxrod check counts, of bodies alone."""
        if mechanism["rod"]:
            return Check("count", 0.0, True, "with rods")
        mobility = Mobility(mechanism, size)
        self.runner.write(mechanism)
        said = self.runner.call("check", "deck.toml").stdout
        free = sum(int(count) for count in re.findall(r"^mechanism.*: (\d+) free motions?", said, re.MULTILINE))
        alone = 6 * sum(is_alone(name, mechanism) for name in mechanism["body"])
        return Check("count", free + alone - mobility.free_motions(), free + alone == mobility.free_motions(),
                     "; ".join(re.findall(r"^mechanism.*", said, re.MULTILINE)))

    def check_resume(self, mechanism, runs, size, draw):
        analysis = mechanism["analysis"]
        step = analysis["end_time"] / analysis["steps"]
        whole = self.runner.run(mechanism, time_step=step, steps=None)
        half = step * draw.integer(1, analysis["steps"] - 1)
        self.runner.run(mechanism, time_step=step, steps=None, end_time=half)
        end = analysis["end_time"]
        resumed = self.runner.results(self.runner.call("resume", "deck.vtkhdf", "--set", f"analysis.end_time={end!r}", "--quiet"))
        return [Check("resume", 0.0, are_equal(whole, resumed))]

    def check_exchanged(self, mechanism, runs, size, draw):
        """But for what the projection of velocities leaves between them, of a higher order than the scheme's error."""
        other, names = mechanism_deck.exchanged(mechanism)
        if not names:
            return []
        signs = {name: -1.0 if name in names else 1.0 for name in mechanism["joint"]}

        def difference(finer):
            here, there = runs(finer), self.runner.run(other, steps=finer * mechanism["analysis"]["steps"])
            return max(compare(here, there, size), compare_coordinates(mechanism, here, there, size, signs))

        return [judge_fall("exchanged", difference, 2 if is_smooth(mechanism) else 1, SMALL)]

    def check_moved(self, mechanism, runs, size, draw):
        """The turn of a free joint is that of a direction which depends on the axes of the deck."""
        if any(joint["type"] == "free" and "turn" in joint["coordinates"] for joint in mechanism["joint"].values()):
            return []
        rotation, shift = draw.rotation(), draw.vector(size)
        other = mechanism_deck.moved(mechanism, rotation, shift)

        def difference(finer):
            here, there = runs(finer), self.runner.run(other, steps=finer * mechanism["analysis"]["steps"])
            there.points = (there.points - shift) @ rotation
            there.axes = there.axes @ rotation
            return max(compare(here, there, size), compare_coordinates(mechanism, here, there, size, {}))

        if Mobility(mechanism, size).redundant() > 0:
            return [judge_fall("moved, redundant", difference, order_of(mechanism) // 2 or 1, SMALL)]
        first = difference(1)
        return [Check("moved", first, first < SMALL)]

    def check_units(self, mechanism, runs, size, draw):
        """By a power of two, so that numbers are the same but for their exponents, almost everywhere."""
        newton = {} if mechanism["analysis"]["integrator"] == "runge-kutta-4" else {"newton": {"tolerance": 1e-8}}
        here = self.runner.run(mechanism, **newton)
        there = self.runner.run(mechanism_deck.in_other_units(mechanism, UNIT), **newton)
        there.points = there.points / UNIT
        difference = compare(here, there, size)
        same_steps = len(there.times) == len(here.times)
        iterations = int(np.abs(there.iterations - here.iterations).sum()) if same_steps else len(there.times)
        return [Check("units", difference, difference < SMALL), Check("units iterations", iterations, iterations == 0)]

    def check_energy(self, mechanism, runs, size, draw):
        def error(finer):
            return imbalance(runs(finer), least)

        mass = total_mass(mechanism)
        least = LEAST_ENERGY * mass * (size / mechanism["analysis"]["end_time"])**2
        return [judge_fall("energy", error, order_of(mechanism), TOLERANCE_LEAVES)]

    def check_momentum(self, mechanism, runs, size, draw):
        """Without ground and loads it stays, by the order of the scheme."""
        if "spin" not in mechanism:
            return []

        def error_of(which):
            def error(finer):
                return drift(runs(finer), which)
            return error

        return [judge_fall(which, error_of(which), order_of(mechanism), 1e-9) for which in ("linear_momentum", "angular_momentum")]

    def check_scheme(self, mechanism, runs, size, draw):
        """newmark and sdirk-4 come together as the square of the step."""
        steps = mechanism["analysis"]["steps"]
        exact = self.runner.run(mechanism, integrator="sdirk-4", steps=8 * steps)

        def difference(finer):
            return distance(self.runner.run(mechanism, integrator="newmark-simplified", steps=2 * finer * steps), exact, size)

        return [judge_fall("schemes", difference, 2 if is_smooth(mechanism) else 1, 1e-5)]


def total_mass(mechanism):
    rods = sum(mechanism["section"][rod["section"]]["inertia"]["rhoA"] * np.linalg.norm(rod["line"]["to"] - rod["line"]["from"])
               for rod in mechanism["rod"].values())
    return rods + sum(body["mass"] for body in mechanism["body"].values())


def is_smooth(mechanism):
    """Without what changes at a point: friction and limits."""
    return not any(key in keys for joint in mechanism["joint"].values() for keys in joint["coordinates"].values()
                   for key in ("friction", "limits"))


def order_of(mechanism):
    return ORDERS.get(mechanism["analysis"]["integrator"], 2) if is_smooth(mechanism) else 1


def judge_fall(name, measure, order, small):
    """Whether an error falls, with steps of a half, by what its order says, or becomes small."""
    errors = []
    for finer in (1, 2, 4, 8, 16):
        errors.append(measure(finer))
        if errors[-1] < small or len(errors) > 1 and errors[-1] < errors[-2] * FALL[order]:
            return Check(name, errors[0], True)
    return Check(name, errors[0], False, f"order {order}: {errors}")


def is_alone(name, mechanism):
    return all(name not in [point.split(".")[0] for point in joint["between"]] for joint in mechanism["joint"].values())


def extent(results, mechanism):
    """The model's length, as gxrod measures it."""
    ties = [tie for kind in ("joint", "spring", "bushing") for tie in mechanism[kind].values()]
    places = np.vstack([results.points[0], *(tie[key][None] for tie in ties for key in ("at", "at_a", "at_b") if key in tie)])
    sizes = [np.sqrt(body["inertia"].sum() / body["mass"]) for body in mechanism["body"].values()]
    return float(max(np.linalg.norm(places.max(axis=0) - places.min(axis=0)), *sizes, 0.0))


def check_gap(results, size):
    farthest = np.linalg.norm(results.points, axis=-1).max()
    gap = max((history["gap"].max() for history in results.histories.values() if "gap" in history), default=0.0)
    gap /= max(size, farthest)
    return Check("gap", float(gap), gap <= CLOSED)


def imbalance(results, least):
    return float(np.abs(results.ledger["energy_error"]).max() / max(results.energy(), least))


def drift(results, which):
    values = results.ledger[which]
    return float(np.linalg.norm(values - values[0], axis=1).max() / np.linalg.norm(values[0]))


def compare(here, there, size):
    if not np.array_equal(here.frames, there.frames):
        return distance(here, there, size)
    return float(max(np.abs(here.points - there.points).max() / size, np.abs(here.axes - there.axes).max()))


def distance(here, there, size):
    """At the last step."""
    return float(max(np.abs(here.points[-1] - there.points[-1]).max() / size, np.abs(here.axes[-1] - there.axes[-1]).max()))


def compare_coordinates(mechanism, here, there, size, signs):
    """Turns of universal joints are about A's axis."""
    largest = 0.0
    if len(here.times) != len(there.times):
        return largest
    for name, history in here.histories.items():
        for quantity, scale in (("angle", 1.0), ("slide", size)):
            if quantity in history and not (mechanism["joint"][name]["type"] == "universal" and signs):
                difference = history[quantity] - signs.get(name, 1.0) * there.histories[name][quantity]
                largest = max(largest, float(np.abs(difference).max() / scale))
    return largest


def are_equal(here, there):
    same = np.array_equal(here.points, there.points) and np.array_equal(here.axes, there.axes)
    return same and all(np.array_equal(rows, there.histories[name][quantity], equal_nan=True)
                        for name, history in here.histories.items() for quantity, rows in history.items())
