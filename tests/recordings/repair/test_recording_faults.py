"""One recording by itself: each detector of the tuple finds its fault, in any unit and of either sign, and no other."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.signal import butter, sosfilt

from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.repair.detectors import DETECTORS
from torquerig.recordings.repair.recording_faults import recording_faults
from torquerig.recordings.run import Run

RATE, LENGTH = 5_000.0, 12.0  # [Hz], [s]
CODE = 3e-4  # [V] of the converter
TIME = np.arange(int(RATE * LENGTH)) / RATE

Floats = NDArray[np.float64]


def torque() -> Floats:
    """A load of 1 V that wanders by 5 %, three orders of a shaft at 11 Hz, noise of the sensor, without codes."""
    rng = np.random.default_rng(7)
    slow = sosfilt(butter(2, 2.0, fs=RATE, output="sos"), rng.standard_normal(TIME.size))
    fast = sosfilt(butter(2, 1500.0, fs=RATE, output="sos"), rng.standard_normal(TIME.size))
    orders = sum(
        size * np.sin(2 * np.pi * 11.0 * order * TIME + order) for order, size in ((1, 0.05), (4, 0.03), (12, 0.02))
    )
    return np.asarray(1.0 + 0.05 * slow / slow.std() + 0.01 * fast / fast.std() + orders)


def between(*moments: tuple[float, float]) -> NDArray[np.bool_]:
    answer = np.zeros(TIME.size, dtype=bool)
    for start, stop in moments:
        answer |= (start <= TIME) & (stop > TIME)
    return answer


def clean(volts: Floats) -> Floats:
    return volts


def held(volts: Floats) -> Floats:
    return volts[np.arange(volts.size) // 4 * 4]


def lost_at_once(volts: Floats) -> Floats:
    return np.where(between(*((at, at + 0.006) for at in np.arange(0.5, 11.5, 0.9))), -0.4, volts)


def lost_before_the_amplifier(volts: Floats) -> Floats:
    lost = np.where(between(*((at, at + 0.006) for at in np.arange(0.5, 11.5, 0.6))), 0.0, volts)
    noise = 0.005 * np.random.default_rng(8).standard_normal(volts.size)
    return np.asarray(sosfilt(butter(2, 300.0, fs=RATE, output="sos"), lost - lost[0]) + lost[0] + noise)


def stopped(volts: Floats) -> Floats:
    return np.minimum(volts, 1.1)


def stopped_behind_noise(volts: Floats) -> Floats:
    smooth = sosfilt(butter(2, 100.0, fs=RATE, output="sos"), volts - volts[0]) + volts[0]
    return np.asarray(np.minimum(smooth, 1.03) + 0.002 * np.random.default_rng(9).standard_normal(volts.size))


def written_twice(volts: Floats) -> Floats:
    source = np.arange(volts.size)
    source[20_000:] -= 200
    return volts[source]


def gripping(volts: Floats) -> Floats:
    answer = volts.copy()
    for at in (1.3, 4.9, 7.4, 10.1):
        since = np.maximum(TIME - at, 0.0)
        answer += 4.0 * np.exp(-40 * since) * np.sin(2 * np.pi * 60.0 * since)
    return answer


def telegraph(volts: Floats) -> Floats:
    return volts + 0.4 * between((1.1, 2.0), (3.7, 3.9), (5.0, 7.7), (9.1, 10.0))


def other_gain(volts: Floats) -> Floats:
    return np.where(between((5.0, 5.6)), 1.7 * volts, volts)


def stepping(volts: Floats) -> Floats:
    return volts + 0.6 * (TIME > 6.2)


def jumping(volts: Floats) -> Floats:
    return volts + sum(size * (at < TIME) for at, size in ((2.0, 0.5), (2.02, -0.8), (2.05, 0.7), (2.07, -0.4)))


def sweeping(volts: Floats) -> Floats:
    return np.asarray(volts + 0.02 * np.cos(2 * np.pi * (300.0 * TIME + 0.5 * 30.0 * TIME**2)))


SPOILT: dict[Callable[[Floats], Floats], set[str]] = {
    clean: set(),
    held: {"held samples"},
    lost_at_once: {"dropouts"},
    lost_before_the_amplifier: {"dropouts"},
    stopped: {"clipping"},
    stopped_behind_noise: {"clipping"},
    written_twice: {"repeated samples"},
    gripping: {"slips"},
    telegraph: {"telegraph noise"},
    other_gain: {"gain change"},
    stepping: {"mean step"},
    jumping: {"jumps"},
    sweeping: {"sweep"},
}
WITHOUT_A_CONVERTER = {"of_codes"}  # coarse codes are told by the converter's step, which one recording does not state


def recording(volts: Floats, *, code: float = CODE, unit: str = "V", quantity: str = "torque") -> Recording:
    channel = Channel(values=code * np.round(volts / code), quantity=quantity, unit=unit)
    return Recording(name="run", sample_rate=RATE, channels={"reading": channel}, run=Run(speed=70.0))


@pytest.mark.long
@pytest.mark.parametrize("spoil", SPOILT, ids=lambda each: each.__name__)
def test_each_fault_is_found_alike_in_any_unit(spoil: Callable[[Floats], Floats]) -> None:
    volts = spoil(torque())
    found = recording_faults(recording(volts))
    assert {fault.kind for fault in found} == SPOILT[spoil]
    for scale in (-1e-3, 1e3):
        other = recording_faults(recording(scale * volts, code=abs(scale) * CODE))
        assert [(each.kind, each.place.at, each.place.width) for each in other] == [
            (each.kind, pytest.approx(each.place.at), pytest.approx(each.place.width)) for each in found
        ]


def test_every_detector_has_a_fault_here() -> None:
    """A detector that is added needs a signal above, or a reason why one recording cannot show its fault."""
    kinds = set().union(*SPOILT.values())
    assert len(DETECTORS) == len(kinds) + len(WITHOUT_A_CONVERTER)


def test_sentences_hold_the_unit_as_recorded() -> None:
    (fault,) = recording_faults(recording(1e3 * telegraph(torque()), code=1e3 * CODE, unit="mV"))
    assert re.search(r"levels (39|40)\d mV apart", fault.seen)
    assert "judged" not in fault.seen
    assert fault.channel == "reading"


def test_a_force_is_examined_as_a_torque_is() -> None:
    (fault,) = recording_faults(recording(telegraph(torque()), unit="N", quantity="force"))
    assert re.search(r"levels 0\.(39|40)\d? N apart", fault.seen)


@pytest.mark.parametrize("low_pass", [1500.0, 3000.0])
@pytest.mark.parametrize("spoil", [telegraph, jumping], ids=lambda each: each.__name__)
def test_edges_may_be_rounded_and_noise_goes_on(spoil: Callable[[Floats], Floats], low_pass: float) -> None:
    """The amplifier comes behind the fault and adds noise."""
    amplifier = butter(2, low_pass, fs=20_000.0, output="sos")
    fine = np.interp(np.arange(4 * TIME.size) / 4, np.arange(TIME.size), torque())
    sharp = np.repeat(spoil(torque()) - torque(), 4)
    volts = sosfilt(amplifier, fine + sharp - 1.0) + 1.0
    volts += 0.005 * np.random.default_rng(4).standard_normal(volts.size)
    (fault,) = recording_faults(replace(recording(volts), sample_rate=20_000.0))
    assert {fault.kind} == SPOILT[spoil]
    assert fault.place.at == pytest.approx(1.1 if spoil is telegraph else 2.0, abs=0.003)


@pytest.mark.parametrize("spoil", [stepping, sweeping, gripping], ids=lambda each: each.__name__)
def test_what_a_motion_may_do_is_no_fault_where_nobody_states_a_speed(spoil: Callable[[Floats], Floats]) -> None:
    assert recording_faults(replace(recording(spoil(torque())), run=Run())) == ()


@pytest.mark.parametrize("rate", [0.5, 10.0, 440.0, 1e5])
@pytest.mark.parametrize("samples", [2, 9, 80, 512, 2000])
def test_short_and_slow_recordings_have_none(rate: float, samples: int) -> None:
    values = 1.0 + 0.1 * np.random.default_rng(1).standard_normal(samples)
    channel = Channel(values=values, quantity="torque", unit="N*m")
    given = Recording(name="short", sample_rate=rate, channels={"torque": channel}, run=Run(speed=1.0))
    assert recording_faults(given) == ()
