"""Two recordings of one rig: no change without a cause, an added line with the truth inside its interval."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.errors import InputError, RecordingError
from torquerig.metrics.changes.change import Change
from torquerig.metrics.changes.comparison import Changes, changes
from torquerig.metrics.changes.intervals import line_square, sure_difference_of_roots
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Recording
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

RATE = 5000.0  # [Hz]
FLOATS = NDArray[np.float64]


@cache
def wear_rig() -> Scenario:
    document = read_document(shipped_scenarios() / "wear_rig.yaml")
    return read_scenario(document, load_catalog(shipped_folder()), seed=1)


@cache
def kinematics() -> Kinematics:
    return kinematics_of(wear_rig().rig)


@cache
def run(seed: int, *, duration: float = 6.0, rpm: float = 1000.0, rate: float = RATE) -> Recording:
    rig = wear_rig().rig
    rig = rig.at(replace(rig.run, speed=rpm * pi / 30))
    wander = wear_rig().operating_point.slow_speed_wander
    made = simulate(rig, duration=duration, seed=seed, sample_rate=rate, settling=1.0, wander=wander).without_truth()
    return replace(made, name=f"run{seed}.parquet")


def plus(recording: Recording, added: FLOATS) -> Recording:
    """Return the recording with a torque [N m] added to the compared channel."""
    name = recording.torque_name()
    channel = recording.channels[name]
    changed = replace(channel, values=channel.values + added / channel.si_per_unit)
    return replace(recording, channels={**recording.channels, name: changed})


def times(recording: Recording) -> FLOATS:
    return np.arange(recording.samples) / recording.sample_rate


def turns(recording: Recording) -> FLOATS:
    """Return the turns of the output shaft by the encoder."""
    name = recording.find("motor_angle")
    assert name is not None
    return np.unwrap(recording.channels[name].in_si()) / (2 * pi * kinematics().ratio)


def compared(before: Recording, after: Recording) -> Changes:
    return changes(before, after, kinematics())


def only(found: Changes) -> Change:
    """Return the one change of a comparison; what is smaller than 5 % of it is its image beside it."""
    first, *others = found.changed
    assert all(abs(one.difference) < 0.05 * abs(first.difference) for one in others)
    return first


@pytest.mark.parametrize("pair", range(6))
def test_the_same_rig_with_other_random_numbers_has_no_change(pair: int) -> None:
    found = compared(run(2 * pair + 1), run(2 * pair + 2))
    assert found.changed == ()
    assert len(found.tested) > 20
    assert len(found.remarks) == 1  # constant speed


@pytest.mark.long
def test_the_rates_of_false_alarms_and_of_intervals_are_those_that_are_stated() -> None:
    """At most 1 % a kind, so 4 % a pair; 30 pairs without a change have more than 4 alarms with less than 1 %."""
    pairs = [compared(run(2 * one + 1), run(2 * one + 2)) for one in range(30)]
    assert sum(bool(found.changed) for found in pairs) <= 4
    held = [one.low <= 0 <= one.high for found in pairs for one in found.tested]
    assert np.mean(held) >= 0.93  # 95 % are stated; the tests of one pair are not independent


@pytest.mark.parametrize("frequency", [77.0, 413.0])
def test_an_added_line_of_fixed_frequency_is_found_with_the_truth_in_its_interval(frequency: float) -> None:
    after = run(2)
    found = compared(run(1), plus(after, 0.04 * np.cos(2 * pi * frequency * times(after))))
    one = only(found)
    assert (one.frequency or one.at) == pytest.approx(frequency, abs=0.2)  # a quarter of a bin, in noise
    assert any("cannot be distinguished" in remark for remark in found.remarks)
    assert one.low <= 0.04 <= one.high
    assert one.high - one.low < 0.03
    assert one.percent is None  # there was nothing before


def test_a_grown_order_is_found_at_its_order_with_its_cause() -> None:
    """The order of the motor's shaft grows by a part that is in phase with nothing: compared as amplitudes."""
    before, after = run(1), run(2)
    added = [plus(one, size * np.cos(2 * pi * 23.0 * turns(one))) for one, size in ((before, 0.05), (after, 0.11))]
    found = compared(*added)
    one = only(found)
    assert (one.kind, one.at) == ("order", pytest.approx(23.0, abs=0.05))
    assert one.low <= 0.06 <= one.high
    assert one.percent == pytest.approx(120.0, abs=25.0)
    back = only(compared(*reversed(added)))
    assert back.difference == pytest.approx(-one.difference, rel=1e-9)
    assert (back.low, back.high) == pytest.approx((-one.high, -one.low), rel=1e-9)


def test_a_changed_mean_is_found_with_its_interval() -> None:
    found = compared(run(1), plus(run(2), np.full(run(2).samples, 0.2)))
    one = only(found)
    assert one.kind == "mean"
    assert one.low <= 0.2 <= one.high


def test_noise_in_a_band_is_found_in_that_band() -> None:
    after = run(2)
    spectrum = np.fft.rfft(np.random.default_rng(4).standard_normal(after.samples))
    places = np.fft.rfftfreq(after.samples, 1 / RATE)
    noise = np.fft.irfft(np.where((places > 300) & (places < 450), spectrum, 0.0), after.samples)
    noise *= 0.05 / noise.std()
    found = compared(run(1), plus(after, noise))
    bands = [one for one in found.changed if one.kind == "band"]
    assert bands
    assert all(one.until > 300 and one.at < 450 for one in bands)
    truth = np.sqrt(sum(one.before**2 for one in bands) + 0.05**2)
    assert np.sqrt(sum(one.after**2 for one in bands)) == pytest.approx(truth, rel=0.1)


def test_a_line_of_the_smallest_size_is_seen() -> None:
    """The size that is stated for a pair without a change; three of three."""
    for seed in (1, 3, 5):
        before, after = run(seed), run(seed + 1)
        (tested,) = (one for one in compared(before, after).tested if one.cause == "5 x mains")
        found = compared(before, plus(after, tested.smallest_seen * np.cos(2 * pi * 250.0 * times(after))))
        assert any((one.frequency or one.at) == pytest.approx(250.0, abs=1.0) for one in found.changed)


def test_a_ramp_tells_an_order_from_a_fixed_frequency() -> None:
    rig = wear_rig().rig
    rig = rig.at(replace(rig.run, profile="ramp"))
    ramps = [replace(simulate(rig, duration=12.0, seed=seed, sample_rate=RATE).without_truth(), name=f"ramp{seed}")
             for seed in (1, 2)]  # fmt: skip
    found = compared(ramps[0], plus(ramps[1], 0.05 * np.cos(2 * pi * 413.0 * times(ramps[1]))))
    first = found.changed[0]
    assert (first.kind, first.at) == ("frequency", pytest.approx(413.0, abs=0.2))
    assert first.low <= 0.05 <= first.high


def test_another_speed_is_said_and_orders_are_compared_with_orders() -> None:
    before, after = run(1), run(2, rpm=800.0)
    added = plus(after, 0.2 * np.cos(2 * pi * 23.0 * turns(after)))
    found = compared(before, added)
    assert any("mean speeds differ by 20 %" in one for one in found.remarks)
    assert any(one.kind == "order" and one.at == pytest.approx(23.0, abs=0.05) for one in found.changed)


def test_another_sample_rate_limits_what_is_compared() -> None:
    found = compared(run(1), run(2, rate=2000.0))
    assert any("sample rates differ (5000 and 2000 Hz): compared up to 800 Hz" in one for one in found.remarks)
    assert max(one.until for one in found.tested if one.kind != "order") <= 800.0
    speed = found.before.speeds[1]
    assert max(one.at * speed for one in found.tested if one.kind == "order") <= 801.0


def test_another_load_is_said() -> None:
    after = replace(run(2), run=replace(run(2).run, occupancy_percent=20.0))
    assert any("the stated loads differ (5 and 20 % occupancy)" in one for one in compared(run(1), after).remarks)


def test_without_an_angle_only_frequencies_and_levels_are_compared() -> None:
    noise = [0.1 * np.random.default_rng(seed).standard_normal(30_000) for seed in (1, 2)]
    pair = [replace(run(1), channels={run(1).torque_name(): replace(run(1).channels[run(1).torque_name()], values=one)},
                    run=replace(run(1).run, speed=None)) for one in noise]  # fmt: skip
    found = compared(*pair)
    assert any(one.startswith("no orders are compared: ") for one in found.remarks)
    assert {one.kind for one in found.tested} == {"frequency", "band", "mean"}


def test_bad_pairs_are_refused() -> None:
    short = run(1, duration=1.0)
    with pytest.raises(RecordingError, match="too short to compare; record at least 2 s"):
        compared(short, run(2))
    name = run(1).torque_name()
    force = replace(run(1), channels={**run(1).channels, name: replace(run(1).channels[name], quantity="force")})
    with pytest.raises(InputError, match="compare two recordings of one channel"):
        compared(force, run(2))
    gone = run(2).channels[name].values.copy()
    gone[100] = np.nan
    broken = replace(run(2), channels={**run(2).channels, name: replace(run(2).channels[name], values=gone)})
    with pytest.raises(RecordingError, match="samples that are not numbers"):
        compared(run(1), broken)


@pytest.mark.parametrize("amplitude", [0.0, 0.3, 1.0, 5.0])
def test_intervals_of_lines_hold_the_truth_as_often_as_stated(amplitude: float) -> None:
    """Complex Gaussian noise of variance 1 in 12 segments; the standard error of 400 trials at 95 % is 1.1 %."""
    rng = np.random.default_rng(7)

    def powers(size: float) -> FLOATS:
        noise = (rng.standard_normal(12) + 1j * rng.standard_normal(12)) / np.sqrt(2)
        return np.asarray(np.abs(size + noise) ** 2)

    hits = 0
    for _ in range(400):
        squares = [line_square(powers(size), 1.0) for size in (amplitude, amplitude + 0.5)]
        _, low, high = sure_difference_of_roots(*squares, level=0.05)
        hits += low <= 0.5 <= high
    assert hits / 400 >= 0.92
