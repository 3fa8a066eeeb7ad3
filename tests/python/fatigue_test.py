"""gxrod.fatigue: rainflow counting, Miner's damage, equivalent loads."""

import numpy as np
import pytest

import gxrod

if not gxrod._has_core():
    pytest.skip("gxrod has no compiled part here: it is built with -DGXROD_PYTHON_MODULE=ON", allow_module_level=True)

from gxrod import fatigue

ASTM = [-2, 1, -3, 5, -1, 3, -4, 4, -2]  # ASTM E1049-85, figure 6


def total(cycles):
    return {size: float(cycles.count[cycles.range == size].sum()) for size in np.unique(cycles.range)}


def test_the_example_of_the_standard():
    assert total(fatigue.rainflow(ASTM)) == {3: 0.5, 4: 1.5, 6: 0.5, 8: 1.0, 9: 0.5}


def test_points_between_turns_and_repeated_ones_do_not_count():
    finer = np.interp(np.linspace(0, 8, 81), np.arange(9), ASTM)
    assert total(fatigue.rainflow(np.repeat(finer, 2))) == total(fatigue.rainflow(ASTM))


def test_a_sine_has_full_cycles_and_its_mean():
    t = np.linspace(0, 10, 10 * 64 + 1)
    cycles = fatigue.rainflow(5 + 2 * np.sin(2 * np.pi * t))
    assert cycles.count.sum() == pytest.approx(10, abs=0.5)
    assert cycles.range.max() == 4
    assert cycles.mean[cycles.range == 4] == pytest.approx(5)


def test_short_series_and_bad_ones():
    assert len(fatigue.rainflow([]).range) == len(fatigue.rainflow([3.0, 3.0]).range) == 0
    assert total(fatigue.rainflow([0, 1])) == {1: 0.5}
    with pytest.raises(gxrod.Error, match="not numbers"):
        fatigue.rainflow([0, np.nan, 1])
    with pytest.raises(gxrod.Error, match="shape"):
        fatigue.rainflow([[0, 1]])


def test_the_curve_of_a_detail_category():
    curve = fatigue.SNCurve.eurocode(71e6)
    constant = 71e6 * 0.4 ** (1 / 3)
    np.testing.assert_allclose(curve.cycles([71e6, 142e6, constant]), [2e6, 2.5e5, 5e6], rtol=1e-12)
    assert curve.cycles(constant * (0.05) ** 0.2 * 1.0001) == pytest.approx(1e8, rel=1e-3)
    assert np.isinf(curve.cycles(constant * 0.05**0.2))
    assert fatigue.SNCurve.eurocode(71e6, factor=2).cycles(35.5e6) == pytest.approx(2e6)
    with pytest.raises(gxrod.Error, match="smaller and smaller"):
        fatigue.SNCurve([(3, 2e6, 50), (5, 5e6, 40), (5, 5e6, 60)])


def test_damage_and_the_equivalent_range():
    curve = fatigue.SNCurve([(4, 1e6, 100.0)])
    series = [0, 100] * 50 + [0]
    assert fatigue.damage(series, curve) == pytest.approx(50e-6)
    assert fatigue.equivalent_range(series, 4, 50) == pytest.approx(100)
    assert fatigue.damage(series, curve, ultimate=100) == pytest.approx(50e-6 * 2**4)
    assert fatigue.damage(ASTM, fatigue.SNCurve([(3, 1.0, 1.0)])) == pytest.approx(0.5 * 27 + 1.5 * 64 + 0.5 * 216 + 512 + 0.5 * 729)
    with pytest.raises(gxrod.Error, match="ultimate"):
        fatigue.damage([0, 300, 0], curve, ultimate=100)


def count_plainly(series):
    """Rainflow counting as the standard words it, step by step on the list of turning points, and nothing of the package."""
    points = [series[0]]
    for value in series[1:]:
        if value == points[-1]:
            continue
        if len(points) > 1 and (points[-1] - points[-2]) * (value - points[-1]) > 0:
            points[-1] = value
        else:
            points.append(value)
    found, read = [], []
    for point in points:
        read.append(point)
        while len(read) >= 3:
            X, Y = abs(read[-1] - read[-2]), abs(read[-2] - read[-3])
            if X < Y:
                break
            if len(read) == 3:
                found.append((Y, 0.5))
                read.pop(0)
            else:
                found.append((Y, 1.0))
                del read[-3:-1]
    return found + [(abs(b - a), 0.5) for a, b in zip(read, read[1:])]


@pytest.mark.parametrize("seed", range(10))
def test_random_series_are_counted_as_the_standard_words_it(seed):
    random = np.random.default_rng(seed)
    series = np.round(random.normal(size=400), 1 + seed % 3)
    cycles = fatigue.rainflow(series)
    assert list(zip(cycles.range, cycles.count)) == count_plainly(series.tolist())
