"""Features of runs whose lines, tones and noise are known."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from torquerig.diagnosis.looking.places import frequency, order
from torquerig.inference.features.line_search import search_lines
from torquerig.inference.features.run_features import run_features

NOISE, RATE = 0.1, 2000.0
DENSITY = 2 * NOISE**2 / RATE  # one-sided density of white noise


def nothing(at):
    return np.zeros_like(at)


@pytest.mark.parametrize("speed", [steady(1000), ramp(3000)], ids=["steady", "ramp"])
def test_the_power_of_lines_is_the_square_of_their_amplitudes(speed):
    run = drawn_run(1, speed=speed, orders={7.0: 0.5}, tones={90.0: 0.2}, noise=NOISE)
    seen = run_features(run, [order(7.0), frequency(90.0)])
    table = seen.lines
    noise = table.noise_bandwidth * DENSITY
    for column, amplitude in enumerate((0.5, 0.2)):
        shown = table.count[:, column] > 0
        power = (table.power - noise)[shown, column]
        sd = np.sqrt(2 * amplitude**2 * noise[shown, column] / table.count[shown, column])
        assert shown.any()
        assert np.abs(power - amplitude**2).max() < 4.5 * sd.max()  # some 20 segments: 4.5 sd by chance in 1e-4


def test_bands_have_the_density_of_white_noise_beside_a_strong_line():
    seen = run_features(drawn_run(2, speed=steady(1000), orders={7.0: 30.0}, noise=NOISE), [order(7.0)])
    enough = seen.band_count[0] > 30
    ratio = seen.band_power[0][enough] / DENSITY
    assert np.abs(np.log(ratio) * np.sqrt(seen.band_count[0][enough])).max() < 4.5


def test_levels_are_mean_torques_without_lines():
    seen = run_features(drawn_run(3, speed=steady(1000), orders={3.0: 2.0}, level=4.0, noise=NOISE), [order(3.0)])
    length = seen.level_duration[0] * RATE
    assert np.abs(seen.level - 4.0).max() < 5 * NOISE / np.sqrt(length)


def test_lines_are_found_at_orders_and_tones_at_frequencies():
    given = {"orders": {7.0: 0.05, 14.0: 0.03}, "tones": {50.0: 0.04}}
    runs = [drawn_run(seed, speed=steady(rpm), **given) for seed, rpm in ((4, 900), (5, 1400))]
    found = {line.place.domain: [] for line in search_lines(runs, [], [nothing] * 2)}
    for line in search_lines(runs, [], [nothing] * 2):
        found[line.place.domain].append(line.place.at)
    assert sorted(found["order"]) == pytest.approx([7.0, 14.0], abs=0.01)
    assert found["frequency"] == pytest.approx([50.0], abs=0.1)


def test_a_run_up_alone_shows_an_order():
    run = drawn_run(6, speed=ramp(3000), orders={12.0: 0.1})
    assert [line.place.at for line in search_lines([run], [], [nothing])] == pytest.approx([12.0], abs=0.05)
    assert not search_lines([run], [order(12.0)], [nothing])


def test_noise_has_no_lines():
    # p-value 0.001 a search: more than one of 40 finds something by chance with a probability of 8e-4
    runs = [[drawn_run(seed, speed=steady(1000))] for seed in range(100, 140)]
    assert sum(bool(search_lines(run, [], [nothing])) for run in runs) <= 1
