"""Lines above half the sample rate appear below it."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.orders.analysis.aliases import alias_of, appears_at
from torquerig.orders.analysis.frequency_lines import frequency_lines, possible_aliases
from torquerig.orders.analysis.line_detection import detected_lines
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording


@pytest.mark.parametrize(("frequency", "seen"), [(300.0, 300.0), (700.0, 300.0), (1000.0, 0.0), (1400.0, 400.0)])
def test_a_line_appears_where_sampling_puts_it(frequency: float, seen: float) -> None:
    times = np.arange(1000) / 1000
    assert np.cos(2 * np.pi * frequency * times) == pytest.approx(np.cos(2 * np.pi * seen * times), abs=1e-9)
    assert appears_at(frequency, 1000.0) == pytest.approx(seen)


def made(frequency: float, *, rate: float = 1000.0, seconds: float = 10.0) -> Recording:
    times = np.arange(round(rate * seconds)) / rate
    noise = 0.01 * np.random.default_rng(2).standard_normal(times.size)
    torque = Channel(values=np.cos(2 * np.pi * frequency * times) + noise, quantity="torque", unit="N*m")
    return Recording(sample_rate=rate, channels={"torque": torque})


def test_cogging_above_half_the_rate_is_listed_as_a_possible_alias() -> None:
    drive = Kinematics(pole_pairs=7, slots=12, ratio=1.0)  # cogging at 84 a turn: 840 Hz at 10 turns a second
    recording = made(840.0)
    found = detected_lines(recording, 10.0 * recording.time(), drive)
    (line,) = [one for one in found if one.amplitude > 0.5]
    assert "alias of cogging x1 at 840 Hz" in line.label


def test_a_line_of_no_order_is_no_alias() -> None:
    lines = Kinematics(pole_pairs=7, slots=12, ratio=1.0).lines()
    assert alias_of(163.7, lines, turns_per_second=10.0, rate=1000.0, width=0.15) is None


@pytest.mark.parametrize("share", [0.05, 0.43, 0.49])
def test_lines_are_found_up_to_half_the_rate(share: float) -> None:
    (line,) = frequency_lines(made(1000.0 * share))
    assert line.frequency == pytest.approx(1000.0 * share, abs=0.02)
    assert line.amplitude == pytest.approx(1.0, rel=0.01)


def test_aliases_are_found_where_the_speed_is_sharp_and_left_out_where_it_is_not() -> None:
    lines = Kinematics(pole_pairs=7, slots=12, ratio=1.0).lines()
    recording = made(840.0)
    ((line, cause),) = possible_aliases(recording, lines, turns_per_second=10.0, half_width=1e-5)
    assert (line.frequency, cause.family) == (pytest.approx(160.0, abs=0.02), "cogging")
    assert possible_aliases(recording, lines, turns_per_second=10.0, half_width=0.01) == []
    assert possible_aliases(made(163.7), lines, turns_per_second=10.0, half_width=1e-5) == []
