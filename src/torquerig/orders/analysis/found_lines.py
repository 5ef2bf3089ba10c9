"""All lines of a recording that stand out, each with its domain; what is decided is taken out before the next look."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from torquerig.orders.analysis.even_angle import over_angle
from torquerig.orders.analysis.labels import causes_of, label_of, mains_multiple
from torquerig.orders.analysis.line_domain import Domain, DomainTest, LineDomain
from torquerig.orders.analysis.order_envelope import HOPS_PER_TURN, envelope, hop_sums, hops_of, less_lines, seen_orders
from torquerig.orders.analysis.order_spectrum import frequency_spectrum, line_amplitude, order_spectrum
from torquerig.orders.analysis.peaks import NEIGHBOURS, Peak, peaks_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

    Floats = NDArray[np.float64]

PASSES = 3
_LOWEST_BINS = 8  # a line must turn so often in the recording to be told from drift
_ENVELOPE = 6.0  # [periods of the axis] over which a line's amplitude is taken as one when it is subtracted
_SECONDS = 1.0  # [s] that count as a turn of the clock
_HUMS = 20  # multiples of the mains that are expected
_HIGHEST_SHARE = 0.4  # of the sample rate up to which lines are looked for


@dataclass(frozen=True, kw_only=True)
class FoundLine:
    """A line that stands out.

    Parameters
    ----------
    seen_over : {"order", "frequency"}
        The axis on which it was found.
    place : float
        Order of the output shaft [1/rev], or frequency [Hz], by ``seen_over``.
    amplitude : float
        Of the sine at that place, mean over the recording [N m].
    above_dB : float
        By how much it exceeds the floor beside it [dB].
    domain : LineDomain
        Which axis gathers it more.
    causes : tuple of KinematicLine
        Those that have its order.
    label : str
        Its causes or its multiple of the mains in words; empty where neither is known.
    """

    seen_over: Literal["order", "frequency"]
    place: float
    amplitude: float
    above_dB: float  # noqa: N815  (decibel is written dB)
    domain: LineDomain
    causes: tuple[KinematicLine, ...] = ()
    label: str = ""

    @property
    def belongs_to(self) -> Domain:
        """The axis that gathers it more, or ``either``."""
        return self.domain.domain


def found_lines(
    recording: Recording, turns: Floats, lines: Sequence[KinematicLine], *, mains: float = 50.0, passes: int = PASSES
) -> tuple[FoundLine, ...]:
    """Return the lines of the torque that stand out, orders first, then fixed frequencies, then undecided ones.

    In each pass the peaks over order and those over frequency are tested (``line_domain``); what belongs to the axis
    on which it was found is kept and subtracted, so that its shadow on the other axis goes with it. What is still
    there after the last pass and belongs to neither is listed as such.

    Parameters
    ----------
    turns : ndarray, shape (samples,)
        Of the output shaft.
    lines : sequence of KinematicLine
        The causes to name orders by.
    mains : float
        [Hz].

    Notes
    -----
    In a run whose speed hardly changes every line is undecided: no test can tell what no experiment shows (handbook,
    signatures 0, "speed rule"). Source for the need of the angle: Fyfe & Munck 1997, MSSP 11(2).
    """
    values = recording.torque()
    kept: list[FoundLine] = []
    open_: list[FoundLine] = []
    for _ in range(passes):
        seen = _look(recording, turns, values, lines, mains)
        seen = [one for one in seen if not any(_left_of(one, other, turns, recording.duration) for other in kept)]
        decided = [one for one in seen if one.belongs_to == one.seen_over]
        open_ = [one for one in seen if one.belongs_to == "either"]
        kept += decided
        if not decided:
            break
        values = _without(values, turns, recording.sample_rate, decided)
    named = [_named(one, recording, turns, lines, mains) for one in (*kept, *_once(open_, recording, turns))]
    rank = {"order": 0, "frequency": 1, "either": 2}
    return tuple(sorted(named, key=lambda one: (rank[one.belongs_to], one.place)))


def _left_of(one: FoundLine, other: FoundLine, turns: Floats, duration: float) -> bool:
    """Return whether a line is only what subtracting a kept one has left beside it."""
    if one.seen_over != other.seen_over:
        return False
    length = float(turns[-1] - turns[0]) if one.seen_over == "order" else duration
    return abs(one.place - other.place) <= max(NEIGHBOURS / length, 1.5 / _ENVELOPE)


def _look(
    recording: Recording, turns: Floats, values: Floats, lines: Sequence[KinematicLine], mains: float
) -> list[FoundLine]:
    rate = recording.sample_rate
    even = over_angle(recording, turns, values)
    top = _HIGHEST_SHARE * rate
    by_order = order_spectrum(even, highest=min(top / (float(np.max(np.diff(turns))) * rate), 0.4 * even.per_turn))
    by_frequency = frequency_spectrum(values, rate, highest=top)
    test = DomainTest(values, turns, even.values)
    seconds = values.size / rate
    orders = sorted({line.output_order for line in lines})
    hum = [multiple * mains for multiple in range(1, _HUMS + 1)]
    return [
        *(_found("order", one, test.of_order(one.place))
          for one in peaks_of(by_order, lowest=_LOWEST_BINS * by_order.width, expected=orders)),
        *(_found("frequency", one, test.of_periods(one.place * seconds))
          for one in peaks_of(by_frequency, lowest=_LOWEST_BINS * by_frequency.width, expected=hum)),
    ]  # fmt: skip


def _found(over: Literal["order", "frequency"], peak: Peak, domain: LineDomain) -> FoundLine:
    return FoundLine(seen_over=over, place=peak.place, amplitude=peak.amplitude, above_dB=peak.above_dB, domain=domain)


def _without(values: Floats, turns: Floats, rate: float, decided: Sequence[FoundLine]) -> Floats:
    """Return the values less the lines, whose amplitudes may change over a few turns, or seconds."""
    time = np.arange(values.size) / rate / _SECONDS
    for over, axis in (("order", turns - turns[0]), ("frequency", time)):
        hops = hops_of(2 * np.pi * axis, ratio=1.0)
        places = [one.place for one in decided if one.seen_over == over]
        if hops is None or not places:
            continue
        orders = seen_orders(places, hops.fastest)
        # the sums are taken line by line, so that lines nearer than a window would be subtracted twice
        for some in _apart(orders, 1 / _ENVELOPE):
            sums = hop_sums(values, hops, some)
            window = max(2 * round(0.5 * HOPS_PER_TURN * _ENVELOPE), 2)
            values = less_lines(values, hops, some, envelope(sums, hops.samples, window))
    return values


def _apart(orders: Floats, least: float) -> list[Floats]:
    """Split orders into groups whose members are ``least`` or more from each other."""
    groups: list[list[float]] = []
    for order in orders:
        for group in groups:
            if order - group[-1] >= least:
                group.append(float(order))
                break
        else:
            groups.append([float(order)])
    return [np.array(group) for group in groups]


def _once(found: Sequence[FoundLine], recording: Recording, turns: Floats) -> list[FoundLine]:
    """Undecided lines are seen on both axes: keep the one over order where both are the same line at the mean speed."""
    mean_speed = float(turns[-1] - turns[0]) / recording.duration
    width = 3 / recording.duration
    orders = [one for one in found if one.seen_over == "order"]
    places = [one.place * mean_speed for one in orders]
    rest = [
        one for one in found
        if one.seen_over == "frequency" and all(abs(one.place - place) > width for place in places)
    ]  # fmt: skip
    return [*orders, *rest]


def _named(
    one: FoundLine, recording: Recording, turns: Floats, lines: Sequence[KinematicLine], mains: float
) -> FoundLine:
    from dataclasses import replace

    if one.seen_over == "frequency":
        amplitude = line_amplitude(recording.torque(), recording.time(), one.place)
        multiple = mains_multiple(one.place, mains=mains, width=1.5 / recording.duration)
        return replace(one, amplitude=amplitude, label=f"{multiple} x mains" if multiple else "")
    amplitude = line_amplitude(recording.torque(), turns, one.place)
    causes = causes_of(one.place, lines, width=1.5 / float(turns[-1] - turns[0]))
    label = label_of(causes)
    if one.belongs_to == "either":
        # at one speed an order is a frequency too, and the mains are a rival
        frequency = one.place * float(turns[-1] - turns[0]) / recording.duration
        multiple = mains_multiple(frequency, mains=mains, width=1.5 / recording.duration)
        label = " or ".join(word for word in (label, f"{multiple} x mains" if multiple else "") if word)
    return replace(one, amplitude=amplitude, causes=causes, label=label)
