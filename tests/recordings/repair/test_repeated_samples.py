"""Samples written twice: found to the sample, and never where a signal repeats by itself."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.repeated_samples import copied
from torquerig.scenario.model import Scenario

CODE = 20.0 / 2**16  # [V] of the converter


@pytest.fixture(scope="module")
def clean(wear_rig: Scenario, record: Callable[..., Recording]) -> Recording:
    return record(wear_rig.rig, 3, duration=4.0)


def with_volts(recording: Recording, volts: np.ndarray, step: float = CODE) -> Recording:
    return recording.with_values("torque_V", step * np.round(volts / step))


@pytest.mark.parametrize("length", [60, 400])
def test_a_copy_is_found_to_the_sample(length: int, clean: Recording) -> None:
    volts = clean.channels["torque_V"].values.copy()
    volts[9000 : 9000 + length] = volts[4000 : 4000 + length]
    (found,) = copied(with_volts(clean, volts))
    # beside the copy a step may be the same by chance
    assert found.source - 4000 == pytest.approx(0, abs=2)
    assert (found.start - 9000, found.stop - 9000 - length) == pytest.approx((0, 0), abs=2)
    assert found.start - found.source == 5000


def test_a_buffer_that_is_written_twice_moves_all_that_follows(clean: Recording) -> None:
    volts = clean.channels["torque_V"].values
    late = np.concatenate([volts[:8000], volts[7700:-300]])
    (found,) = copied(with_volts(clean, late))
    assert found.start - found.source == 300
    assert found.stop - found.start == pytest.approx(300, abs=2)


def test_nothing_repeats_in_a_clean_run_whatever_its_codes(clean: Recording) -> None:
    volts = clean.channels["torque_V"].values
    for step in (CODE, 0.005, 0.05):
        assert copied(with_volts(clean, volts, step)) == ()


def test_what_stands_still_or_turns_without_noise_is_no_copy(clean: Recording) -> None:
    volts, time = clean.channels["torque_V"].values.copy(), np.arange(clean.samples) / clean.sample_rate
    assert copied(with_volts(clean, np.sin(2 * np.pi * 50 * time))) == ()
    volts[3000:3200] = volts[9000:9200] = 1.0
    assert copied(with_volts(clean, volts)) == ()


def test_a_hum_over_a_flat_top_repeats_without_a_copy(clean: Recording) -> None:
    """Above its limit an amplifier has no noise, and a hum that comes behind it has the same codes in many periods."""
    volts, time = clean.channels["torque_V"].values, np.arange(clean.samples) / clean.sample_rate
    limited = np.minimum(volts, float(np.quantile(volts, 0.6)))
    assert copied(with_volts(clean, limited + 0.4 * np.cos(2 * np.pi * 50.0 * time))) == ()


def test_an_alias_that_goes_on_while_the_signal_is_lost_is_no_copy(clean: Recording) -> None:
    """Behind the loss nothing is left but the tone, whose samples come again after some whole number of its periods."""
    lost = clean.channels["torque_V"].values.copy()
    lost[9000:9400] = lost[14000:14400] = 0.0
    tone = 0.04 * np.cos(2 * np.pi * 1148.6 * np.arange(lost.size) / clean.sample_rate)
    assert copied(with_volts(clean, lost + tone)) == ()


def test_a_flat_top_under_an_alias_is_no_copy(clean: Recording) -> None:
    tone = 0.2 * np.sin(2 * np.pi * 6682.3 * clean.time())
    volts = clean.channels["torque_V"].values + tone
    top = float(np.quantile(volts, 0.75))
    assert copied(with_volts(clean, np.minimum(volts, top))) == ()
