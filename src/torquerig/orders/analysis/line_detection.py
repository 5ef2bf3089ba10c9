"""Detection of the lines of a recording, each with its domain; decided lines are subtracted before the next pass."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

import numpy as np

from torquerig.orders.analysis.aliases import alias_of
from torquerig.orders.analysis.angle_resampling import FEWEST_TURNS, over_angle
from torquerig.orders.analysis.labels import LineNames, label_of
from torquerig.orders.analysis.line_domain import Domain, DomainTest, LineDomain
from torquerig.orders.analysis.order_envelope import (
    HOPS_PER_TURN,
    envelope,
    hop_sums,
    hops_of,
    resolved_orders,
    without_lines,
)
from torquerig.orders.analysis.order_spectrum import frequency_spectrum, line_amplitude, order_spectrum
from torquerig.orders.analysis.peaks import NEIGHBOURS, Peak, peaks_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine, Kinematics
    from torquerig.recordings.recording import Recording

    Floats = NDArray[np.float64]

PASSES = 3
_LOWEST_BINS = 8  # periods of a line in the recording, at least, to be distinguished from drift
_ENVELOPE = 6.0  # [turns or periods of _SECONDS] over which an amplitude is averaged when a line is subtracted
_SECONDS = 1.0  # [s] the period of time that corresponds to one turn
_HUMS = 20  # multiples of the mains that are expected
_ONE_SPEED = 0.02  # [1] largest relative change of one speed: that of a speed channel's or an estimated angle's error
_WINDOWS = 20  # pieces of the recording whose mean speeds are compared: noise of the angle averages out in each
_HIGHEST_SHARE = 0.4  # highest order of a line, as a share of the sample rate: above it the resampled angle smears it


@dataclass(frozen=True, kw_only=True)
class DetectedLine:
    """A line above the noise floor.

    Parameters
    ----------
    detected_over : {"order", "frequency"}
        The axis on which it was detected.
    place : float
        Order of the output shaft [1/rev], or frequency [Hz], by ``detected_over``.
    amplitude : float
        Zero-to-peak amplitude, mean over the recording [N m].
    above_dB : float
        Level above the local noise floor [dB].
    domain : LineDomain
        How narrow it is on each axis.
    causes : tuple of KinematicLine
        The kinematic lines of its order.
    label : str
        Its causes or its multiple of the mains in words; empty where neither is known.
    at_one_speed : bool
        True for a line at an order of a shaft in a run whose speed changes too little to separate the two.
    """

    detected_over: Literal["order", "frequency"]
    place: float
    amplitude: float
    above_dB: float  # noqa: N815  (decibel is written dB)
    domain: LineDomain
    causes: tuple[KinematicLine, ...] = ()
    label: str = ""
    at_one_speed: bool = False

    @property
    def axis(self) -> Domain:
        """The axis on which it is narrower, or ``either`` where that is undecided."""
        return "either" if self.at_one_speed else self.domain.domain


def detected_lines(
    recording: Recording, turns: Floats, kinematics: Kinematics, *, harmonics: int = 4, mains: float = 50.0,
    passes: int = PASSES,
) -> tuple[DetectedLine, ...]:  # fmt: skip
    """Return the lines of the torque above the noise floor: orders, then fixed frequencies, then undecided ones.

    In each pass the peaks over order and over frequency are tested (``line_domain``). A line that belongs to the axis
    on which it was detected is kept and subtracted, which also removes its smeared image on the other axis. The
    undecided lines of the last pass are added.

    Parameters
    ----------
    turns : ndarray, shape (samples,)
        Of the output shaft.
    kinematics : Kinematics
        The shafts and lines of the rig, for the names of the orders.
    harmonics : int
        Lines of each cause that are looked up.
    mains : float
        [Hz].

    Notes
    -----
    Where the output shaft turns fewer than two times, amplitudes are averaged over turns of the fastest shaft.

    In a run at nearly constant speed every line is undecided, because order and frequency are proportional (handbook,
    signatures 0, "speed rule"). A line that is sharper over time is undecided too where it is at an order of a shaft
    in a run at one speed (less than 2 % change): an error of the angle smears an order as well. Source for the need of
    the angle: Fyfe & Munck 1997, MSSP 11(2).
    """
    lines = kinematics.lines(harmonics)
    names = LineNames(kinematics=kinematics, lines=lines, turned=float(turns[-1] - turns[0]), mains=mains)
    values = recording.torque()
    kept: list[DetectedLine] = []
    open_: list[DetectedLine] = []
    for _ in range(passes):
        seen = [_at_one_speed(one, recording, turns, names) for one in _tested_peaks(recording, turns, values, names)]
        seen = [one for one in seen if not any(_residual_of(one, other, turns, recording.duration) for other in kept)]
        decided = [one for one in seen if one.axis == one.detected_over]
        open_ = [one for one in seen if one.axis == "either"]
        kept += decided
        if not decided:
            break
        values = _without(values, turns, recording.sample_rate, decided, counted=_counted(turns, kinematics))
    named = [_named(one, recording, turns, names) for one in (*kept, *_once(open_, recording, turns))]
    rank = {"order": 0, "frequency": 1, "either": 2}
    return tuple(sorted(named, key=lambda one: (rank[one.axis], one.place)))


def _residual_of(one: DetectedLine, other: DetectedLine, turns: Floats, duration: float) -> bool:
    """Return whether a line is only the residual of a kept line that was subtracted."""
    if one.detected_over != other.detected_over:
        return False
    length = float(turns[-1] - turns[0]) if one.detected_over == "order" else duration
    return abs(one.place - other.place) <= max(NEIGHBOURS / length, 1.5 / _ENVELOPE)


def _at_one_speed(one: DetectedLine, recording: Recording, turns: Floats, names: LineNames) -> DetectedLine:
    """Return the line, marked where it is at an order of a shaft at the only speed of the run."""
    if one.axis != "frequency":
        return one
    ends = turns[np.linspace(0, turns.size - 1, min(_WINDOWS, turns.size - 1) + 1).astype(np.intp)]
    speeds = np.diff(ends)  # equal times: in proportion to the mean speed of each window
    moved = float(np.ptp(speeds) / np.mean(speeds))
    mean_speed = names.turned * recording.sample_rate / (recording.samples - 1)
    frequency = one.place if one.detected_over == "frequency" else one.place * mean_speed
    return (
        one if moved > _ONE_SPEED or not names.is_an_order(frequency / mean_speed) else replace(one, at_one_speed=True)
    )


def _tested_peaks(recording: Recording, turns: Floats, values: Floats, names: LineNames) -> list[DetectedLine]:
    rate = recording.sample_rate
    even = over_angle(recording, turns, values, fastest=names.kinematics.fastest_shaft[1])
    top = _HIGHEST_SHARE * rate
    by_order = order_spectrum(even, highest=min(top / (float(np.max(np.diff(turns))) * rate), 0.4 * even.per_turn))
    by_frequency = frequency_spectrum(values, rate)
    test = DomainTest(values, turns, even.values)
    seconds = values.size / rate
    orders = sorted({line.output_order for line in names.lines})
    hum = [multiple * names.mains for multiple in range(1, _HUMS + 1)]
    return [
        *(_found("order", one, test.of_order(one.place))
          for one in peaks_of(by_order, lowest=_LOWEST_BINS * by_order.width, expected=orders)),
        *(_found("frequency", one, test.of_periods(one.place * seconds))
          for one in peaks_of(by_frequency, lowest=_LOWEST_BINS * by_frequency.width, expected=hum)),
    ]  # fmt: skip


def _found(over: Literal["order", "frequency"], peak: Peak, domain: LineDomain) -> DetectedLine:
    return DetectedLine(
        detected_over=over, place=peak.place, amplitude=peak.amplitude, above_dB=peak.above_dB, domain=domain
    )


def _counted(turns: Floats, kinematics: Kinematics) -> float:
    """Return the turns per output turn of the shaft over whose turns amplitudes are averaged [1]."""
    return 1.0 if turns[-1] - turns[0] >= FEWEST_TURNS else kinematics.fastest_shaft[1]


def _without(values: Floats, turns: Floats, rate: float, decided: Sequence[DetectedLine], *, counted: float) -> Floats:
    """Return the values less the lines, whose amplitudes may change over a few turns or seconds."""
    time = np.arange(values.size) / rate / _SECONDS
    for over, axis, per in (("order", counted * (turns - turns[0]), counted), ("frequency", time, 1.0)):
        hops = hops_of(2 * np.pi * axis, ratio=1.0)
        places = [one.place / per for one in decided if one.detected_over == over]
        if hops is None or not places:
            continue
        orders = resolved_orders(places, hops.fastest)
        # lines are subtracted one by one: lines nearer than a window would be subtracted twice
        for some in _apart(orders, 1 / _ENVELOPE):
            sums = hop_sums(values, hops, some)
            window = max(2 * round(0.5 * HOPS_PER_TURN * _ENVELOPE), 2)
            values = without_lines(values, hops, some, envelope(sums, hops.samples, window))
    return values


def _apart(orders: Floats, least: float) -> list[Floats]:
    """Return the orders in groups whose members differ by ``least`` or more."""
    groups: list[list[float]] = []
    for order in orders:
        for group in groups:
            if order - group[-1] >= least:
                group.append(float(order))
                break
        else:
            groups.append([float(order)])
    return [np.array(group) for group in groups]


def _once(found: Sequence[DetectedLine], recording: Recording, turns: Floats) -> list[DetectedLine]:
    """Return the undecided lines without duplicates: of a line detected on both axes the one over order is kept."""
    mean_speed = float(turns[-1] - turns[0]) / recording.duration
    width = 3 / recording.duration
    orders = [one for one in found if one.detected_over == "order"]
    places = [one.place * mean_speed for one in orders]
    others = [
        one for one in found
        if one.detected_over == "frequency" and all(abs(one.place - place) > width for place in places)
    ]  # fmt: skip
    return [*orders, *others]


def _named(one: DetectedLine, recording: Recording, turns: Floats, names: LineNames) -> DetectedLine:
    mean_speed = names.turned * recording.sample_rate / (recording.samples - 1)
    over = recording.time() if one.detected_over == "frequency" else turns
    amplitude = line_amplitude(recording.torque(), over, one.place)
    order = one.place / mean_speed if one.detected_over == "frequency" else one.place
    # at one speed an order is also a frequency, and the mains are an alternative cause
    is_fixed = one.detected_over == "frequency" or one.axis == "either"
    is_order = one.detected_over == "order" or one.axis == "either"
    causes = names.causes(order) if is_order else ()
    words = [names.of_order(order, causes) if is_order else ""]
    if is_fixed:
        frequency = order * mean_speed
        width = 1.5 / recording.duration
        words.append(names.of_mains(frequency, width=width))
        alias = alias_of(frequency, names.lines, turns_per_second=mean_speed, rate=recording.sample_rate, width=width)
        words.append(
            "" if alias is None else f"alias of {label_of([alias])} at {alias.output_order * mean_speed:.6g} Hz"
        )
    return replace(one, amplitude=amplitude, causes=causes, label=" or ".join(word for word in words if word))
