"""Random mechanisms: that they are the same again and use every type of joint, that the judge sees what is wrong, and some of
them."""

import os
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import mechanism_deck  # noqa: E402  pylint: disable=wrong-import-position
import mechanisms  # noqa: E402  pylint: disable=wrong-import-position
from mechanism_runs import Runner  # noqa: E402  pylint: disable=wrong-import-position
from mechanism_verdict import MechanismJudge, are_equal, check_gap, compare, judge_fall  # noqa: E402  pylint: disable=wrong-import-position
from mobility import Mobility  # noqa: E402  pylint: disable=wrong-import-position
from toml_text import toml_text  # noqa: E402  pylint: disable=wrong-import-position

GXROD = pathlib.Path(os.environ["GXROD"])
SEED = 1
SOME = (2, 4) if os.environ.get("GXROD_SANITIZED") == "1" else (1, 2, 4, 5)


def text_of(index):
    return toml_text(mechanism_deck.deck_of(mechanisms.make_mechanism(SEED, index)))


def make_crank():
    """A crank on the ground and a block that it drives along x, as random mechanisms are written."""
    body = {"mass": 1.0, "inertia": np.array([0.1, 0.1, 0.1]), "rotation_vector": np.zeros(3)}
    crank, block = {**body, "at": np.zeros(3)}, {**body, "at": np.array([3.0, 0.0, 0.0])}
    z, x = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])
    knee = np.array([0.6, 0.8, 0.0])
    joints = {
        "shaft": {"type": "hinge", "between": ["ground", "crank"], "at": np.zeros(3), "axis": z,
                  "coordinates": {"turn": {"drive": mechanisms.Times(2.0, "sin(t)")}}},
        "bar": {"type": "distance", "between": ["crank", "block"], "at_a": knee, "at_b": np.array([3.0, 0.0, 0.0]), "coordinates": {}},
        "guide": {"type": "slider", "between": ["ground", "block"], "at": np.array([3.0, 0.0, 0.0]), "axis": x, "coordinates": {}}}
    return {"rod": {}, "body": {"crank": crank, "block": block}, "joint": joints, "section": {}, "spring": {}, "bushing": {}, "gear": {},
            "load": [], "analysis": {"kind": "dynamic", "end_time": 1.0, "steps": 16, "integrator": "sdirk-4"}}


class Mechanisms(unittest.TestCase):
    def test_are_the_same_again(self):
        for index in range(10):
            self.assertEqual(text_of(index), text_of(index))
        self.assertNotEqual(text_of(0), text_of(1))

    def test_use_every_type_and_all_that_acts(self):
        types, keys, schemes, tables = set(), set(), set(), set()
        for index in range(200):
            mechanism = mechanisms.make_mechanism(SEED, index)
            schemes.add(mechanism["analysis"]["integrator"])
            tables |= {key for key, entries in mechanism.items() if entries}
            for joint in mechanism["joint"].values():
                types.add(joint["type"])
                keys |= {key for laws in joint["coordinates"].values() for key in laws}
        self.assertEqual(types, {*mechanisms.TYPES, "sleeve"})
        self.assertEqual(keys, {"move", "drive", "spring", "friction", "limits"})
        self.assertEqual(len(schemes), 5)
        self.assertLessEqual({"rod", "body", "spring", "bushing", "gear", "load", "gravity", "spin"}, tables)

    def test_rotation_vectors_are_those_of_their_matrices(self):
        random = np.random.default_rng(3)
        for angle in (0.0, 1e-9, 1.0, 3.0, np.pi - 1e-9):
            axis = random.normal(size=3)
            vector = angle * axis / np.linalg.norm(axis)
            matrix = mechanism_deck.rotation_matrix(vector)
            again = mechanism_deck.rotation_matrix(mechanism_deck.rotation_vector(matrix))
            self.assertLess(np.abs(again - matrix).max(), 1e-12)

    def test_mobility_is_that_of_a_slider_crank(self):
        mobility = Mobility(make_crank(), 1.0)
        self.assertEqual((mobility.free_motions(), mobility.redundant()), (1, 0))
        self.assertTrue(mobility.can_move("shaft", "turn"))
        mobility.add_motor("shaft", "turn")
        self.assertFalse(mobility.can_move("guide", "slide"))


class Judgement(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.judge = MechanismJudge(GXROD, SEED, pathlib.Path(folder.name))
        self.runner = Runner(GXROD, pathlib.Path(folder.name))
        self.crank = make_crank()

    def missed(self, mechanism):
        return {check.name for check in self.judge.judge_mechanism(mechanism, 1.0, 0) if not check.is_met}

    def test_sees_nothing_in_a_sound_mechanism(self):
        self.assertEqual(self.missed(self.crank), set())

    def test_sees_that_a_mechanism_does_not_run(self):
        self.crank["joint"]["shaft"]["type"] = "hinges"
        self.assertEqual(self.missed(self.crank), {"complete"})

    def test_sees_motions_that_differ(self):
        there = mechanism_deck.in_other_units(self.crank, 2.0)
        there["joint"]["shaft"]["coordinates"]["turn"]["drive"].size *= 1.01
        here, there = self.runner.run(self.crank), self.runner.run(there)
        there.points = there.points / 2.0
        self.assertGreater(compare(here, there, 1.0), 1e-4)
        self.assertFalse(are_equal(here, there))

    def test_sees_an_open_joint(self):
        results = self.runner.run(self.crank)
        self.assertTrue(check_gap(results, 3.0).is_met)
        results.histories["bar"]["gap"][5] = 1e-11
        self.assertFalse(check_gap(results, 3.0).is_met)

    def test_sees_errors_that_do_not_fall(self):
        self.assertTrue(judge_fall("energy", lambda finer: 1e-2 / finer**2, 2, 1e-9).is_met)
        self.assertFalse(judge_fall("energy", lambda finer: 1e-2 / finer, 2, 1e-9).is_met)
        self.assertFalse(judge_fall("energy", lambda finer: 1e-2 / finer**2, 4, 1e-9).is_met)
        self.assertTrue(judge_fall("energy", lambda finer: 1e-10, 4, 1e-9).is_met)


class Some(unittest.TestCase):
    def test_keep_what_must_hold(self):
        with tempfile.TemporaryDirectory() as folder:
            judge = MechanismJudge(GXROD, SEED, pathlib.Path(folder))
            for index in SOME:
                with self.subTest(index):
                    verdict = judge.verdict(index)
                    self.assertEqual(verdict.message, "")


if __name__ == "__main__":
    unittest.main()
