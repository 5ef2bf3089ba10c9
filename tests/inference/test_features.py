"""Features of runs whose lines, tones and noise are known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from torquerig.inference.features.bands import bands
from torquerig.inference.features.line_places import shown_places
from torquerig.inference.features.line_search import search_lines
from torquerig.inference.features.line_skirts import exceeds_surroundings
from torquerig.inference.features.run_features import features_like, run_features
from torquerig.inference.places import frequency, order

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


def test_a_tone_of_a_part_of_one_run_up_is_found():
    runs = [drawn_run(seed, speed=ramp(3000, duration=20.0)) for seed in range(6, 12)]
    time = np.arange(runs[0].torque.size) / RATE
    tone = 0.1 * np.cos(2 * np.pi * 41.5 * time) * (time > 12.0)
    runs[0] = replace(runs[0], torque=runs[0].torque + tone)
    (found,) = search_lines(runs, [], [nothing] * 6)
    assert found.place.domain == "frequency"
    assert found.place.at == pytest.approx(41.5, abs=0.1)


def test_noise_has_no_lines():
    # p-value 0.001 a search: more than one of 40 finds something by chance with a probability of 8e-4
    runs = [[drawn_run(seed, speed=steady(1000))] for seed in range(100, 140)]
    assert sum(bool(search_lines(run, [], [nothing])) for run in runs) <= 1


def smeared(seed, width):
    """Return a run with a tone of 300 Hz whose phase walks at random, as wide as ``width`` [Hz], and order 7."""
    run = drawn_run(seed, speed=steady(1000), orders={7.0: 0.05}, noise=NOISE)
    walk = np.cumsum(np.sqrt(2 * np.pi * width / RATE) * np.random.default_rng(seed).standard_normal(run.torque.size))
    time = np.arange(run.torque.size) / RATE
    torque = run.torque + np.cos(2 * np.pi * 300 * time + walk)
    return replace(run, torque=torque)


@pytest.mark.parametrize("width", [0.5, 2.0])
def test_a_line_that_is_wider_than_a_bin_is_few_lines(width):
    for seed in (7, 8, 9):
        found = [line.place for line in search_lines([smeared(seed, width)], [], [nothing])]
        turning = steady(1000)[0] / (2 * np.pi)
        tones = [place.at * turning if place.domain == "order" else place.at for place in found]
        assert any(at == pytest.approx(7 * turning, abs=0.2) for at in tones)
        assert len(found) <= 6  # as many as blocks may have a peak of their own; bins that exceed the noise: some 50


def test_a_line_on_top_of_a_wider_one_stands_out():
    bins = np.arange(400)
    ratios = np.random.default_rng(1).exponential(size=400) * np.where(abs(bins - 200) < 40, 20.0, 1.0)
    ratios[215:218] = 20.0 * np.array([10.0, 40.0, 10.0])
    peak = 170 + int(np.argmax(ratios[170:200]))  # the highest of the wide one's peaks there
    assert exceeds_surroundings(ratios, 216, level=1e-3)
    assert not exceeds_surroundings(ratios, peak, level=1e-3)
    ratios[214:219] = np.nan  # removed: nothing else in the range is a line
    assert not exceeds_surroundings(ratios, peak, level=1e-3)


def test_a_line_next_to_a_removed_one_stands_out():
    ratios = np.random.default_rng(2).exponential(size=400)
    ratios[195:206], ratios[207:210] = np.nan, (30.0, 90.0, 30.0)
    assert exceeds_surroundings(ratios, 208, level=1e-3)


@pytest.mark.parametrize("offset", [0.0, 0.3, 0.5])
@pytest.mark.parametrize("low", [0.3, 12.0])
def test_a_strong_line_is_placed_between_the_bins(low, offset):
    duration = 12.0
    turned = duration * 1000 / 60  # one bin of the whole run is 1 / turned; that of its blocks is wider
    place = (round(low * turned) + offset) / turned
    runs = [drawn_run(seed, speed=steady(1000, duration=duration), orders={place: 0.5}, noise=NOISE) for seed in (1, 2)]
    (found,) = search_lines(runs, [], [nothing] * 2)[:1]
    at = found.place.at if found.place.domain == "order" else found.place.at * 60 / 1000
    assert at == pytest.approx(place, abs=0.15 * 3 / turned)  # bins of the longest blocks in a row, a third of the run


def test_blocks_of_a_segment_show_the_same_lines():
    # slow blocks of a reversal whose angle was not measured smear an order over a tenth of its frequency or more
    turning = 150 * np.sin(4 * np.pi * np.arange(24000) / 24000)
    run = replace(drawn_run(9, speed=turning, orders={18.0: 0.3}, noise=NOISE), has_encoder=False)
    recording = replace(run.recording, run=replace(run.recording.run, profile="reversal"))
    seen = run_features(replace(run, recording=recording), [order(18.0)], held_out=True)
    shown = [(segment.line_count[0], len(segment.blocks)) for segment in seen.segments]
    assert any(count == 0 for count, _ in shown)
    assert all(count in (0, blocks) for count, blocks in shown)


def test_a_tone_is_seen_up_to_half_the_sample_rate_but_for_a_hundredth():
    speed = np.full(2000, 100.0)
    places = [order(0.46 * RATE / (100.0 / (2 * np.pi))), frequency(0.46 * RATE), frequency(0.495 * RATE)]
    assert shown_places(places, speed, RATE) == [1]


def test_a_simulated_run_has_the_segments_of_the_one_that_it_repeats():
    # reversed a little sooner, its blocks show other lines
    turning = 150 * np.sin(4 * np.pi * np.arange(24000) / 24000)

    def reversal(speed):
        run = replace(drawn_run(9, speed=speed, orders={18.0: 0.3}, noise=NOISE), has_encoder=False)
        return replace(run, recording=replace(run.recording, run=replace(run.recording.run, profile="reversal")))

    seen = run_features(reversal(turning), [order(18.0), order(1.0)])
    other = features_like(seen, reversal(np.roll(0.6 * turning, 800)))
    assert [segment.blocks for segment in other.segments] == [
        tuple(replace(block, held_out=False) for block in segment.blocks) for segment in seen.segments
    ]


def test_the_count_of_a_band_is_the_inverse_of_its_relative_variance():
    rng, none = np.random.default_rng(3), (np.zeros(0), np.zeros(0))
    drawn = [bands([*rng.standard_normal((2, 1000))], [none, none], RATE, slowest=4.0) for _ in range(600)]
    power = np.array([each.power for each in drawn])
    ratio = power.var(axis=0) / power.mean(axis=0) ** 2 * drawn[0].count
    # a variance of 600 values scatters by 6 %, its mean over neighbouring bands by some 2 %
    assert np.mean(ratio[power.mean(axis=0) > 0]) == pytest.approx(1.0, abs=0.08)


def test_a_strong_tone_that_was_found_not_quite_leaves_nothing_in_the_bands():
    run = drawn_run(11, speed=steady(1000), tones={60.0: 30.0}, noise=NOISE)
    bands = run_features(run, [frequency(60.03)]).bands  # 0.06 bins of a block off
    beside = (bands.high > 50) & (bands.low < 75) & np.isfinite(bands.power)
    assert (bands.power[beside] < 2 * NOISE**2 / (0.5 * RATE)).all()
