"""Errors keep what they know, also in other processes."""

import pickle

import gxrod
import pytest

ERRORS = [
    gxrod.DeckError([("arm.toml", 3, 5, "rod.arm.section", 'there is no section "a"'), ("", 0, 0, "parameters.E", "is negative"), "too large"]),
    gxrod.ConvergenceError("the step from t = 0.3 failed", time=0.3, time_step=1e-5, outcome="out of iterations", places=["arm.end (ry)"],
                           advice=["a shorter step"]),
    gxrod.FileError("arm.toml: cannot be read"),
    gxrod.EvaluationError("function push is not finite at t = 1"),
    gxrod.UnknownNameError("there is no rod 'amr'"),
]


@pytest.mark.parametrize("error", ERRORS, ids=lambda error: type(error).__name__)
def test_they_are_pickled(error):
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is type(error) and str(again) == str(error) and again.__dict__ == error.__dict__ and again.args == error.args
    assert isinstance(error, gxrod.Error)


def test_faults_read_as_the_program_writes_them():
    error = ERRORS[0]
    assert str(error) == 'arm.toml:3:5: rod.arm.section: there is no section "a"\nparameters.E: is negative\ntoo large'
    assert error.faults[0] == gxrod.Fault("arm.toml", 3, 5, "rod.arm.section", 'there is no section "a"')
    assert error.faults[2].message == "too large"


def test_failed_steps_say_where_and_what_to_try():
    error = ERRORS[1]
    assert str(error) == "the step from t = 0.3 failed"
    assert (error.time, error.time_step, error.outcome) == (0.3, 1e-5, "out of iterations")
    assert (error.places, error.advice) == (("arm.end (ry)",), ("a shorter step",))


def test_unknown_names_are_key_and_attribute_errors_and_read_plainly():
    error = gxrod.errors.unknown_name("history", "tpi", ["tip", "root"])
    assert isinstance(error, (KeyError)) and isinstance(error, AttributeError)
    assert str(error) == "there is no history 'tpi'; did you mean 'tip'? there are tip, root"
    assert str(gxrod.errors.unknown_name("history", "x", [])) == "there is no history 'x'; there are none"
    assert str(gxrod.errors.unknown_name("history", "x", ["tip"])) == "there is no history 'x'; there is tip"
    assert str(gxrod.errors.unknown_name("rod", "x", range(30))).endswith("18, 19 and 10 more")
