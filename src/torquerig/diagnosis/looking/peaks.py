"""Lines that no model was asked for: peaks of what is left, sorted into orders of the shaft and fixed frequencies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.stretch_lines import shown_places
from torquerig.inference.features.regression import regressed
from torquerig.inference.features.waves import Waves
from torquerig.inference.places import RESOLVED_WELL, Place, frequency, order
from torquerig.parallel import parallel_map
from torquerig.recordings.spectrum import between_bins

Floats = NDArray[np.float64]

# power over the local floor; an exponential variate exceeds 22 with 3e-10, and some 1e5 places are looked at
CLEAR, SUPPORTING = 22.0, 9.0
LEADING = 150.0  # power over the floor of a line that a shaft is better followed by, or without
_NEIGHBOURS, _NEAREST = 60, 15  # bins either way that make the local floor, and that of a resonance
_MOST = 40
SHIFTED = 0.25  # of the width over which an unmeasured angle smears a line: how far off its peak may stand
_TWICE = 2.0  # the power of a side line
_LOWEST = 3.0  # [Hz] slower than this the load's own drift rules
# of half the sample rate: an alias may stand anywhere below it; an order so high is made by the resampling
_TOP_FREQUENCY, TOP_ORDER = 0.995, 0.92


@dataclass(frozen=True)
class Peak:
    """A line that stands out of what is left.

    Parameters
    ----------
    place : Place
        Where, in the domain in which it stands in more runs.
    excess : float
        Largest power over the local floor [1].
    runs : tuple of str
        Names of the recordings that show it.
    speeds : int
        In how many different speeds it stands.
    either : bool
        Whether these runs leave open if it stands at an order or at a fixed frequency.
    """

    place: Place
    excess: float
    runs: tuple[str, ...]
    speeds: int
    either: bool = False


@dataclass(frozen=True)
class _Spectrum:
    """Power over the local floor of one run, over motor orders and over frequency, and the powers themselves."""

    observed: Observed
    by_order: Floats
    order_step: float
    by_frequency: Floats
    frequency_step: float
    turned: Floats
    direct: Floats

    def excess(self, place: Place) -> float:
        """Largest excess within a bin of the place, or within what an unmeasured angle shifts it; 0 outside."""
        return self._largest(place, self.by_order if place.domain == "order" else self.by_frequency)

    def power(self, place: Place) -> float:
        """Largest power there."""
        return self._largest(place, self.turned if place.domain == "order" else self.direct)

    def _largest(self, place: Place, values: Floats) -> float:
        step = self.order_step if place.domain == "order" else self.frequency_step
        at = round(place.at / step)
        reach = max(1, round(SHIFTED * self.observed.smearing * at)) if place.domain == "order" else 1
        return float(values[max(at - reach, 0) : at + reach + 1].max(initial=0.0)) if 0 < at < values.size else 0.0


def peaks(runs: Sequence[Observed], known: Sequence[Place]) -> tuple[Peak, ...]:
    """Return the lines beside ``known`` in the stretches of steady runs that fits may see, clearest first.

    A line of an order and a line of a fixed frequency look alike at one speed; each is taken as that which stands in
    runs of more different speeds, an order where both do.
    """
    steady = [run for run in runs if run.steady]
    pairs = zip(parallel_map(lambda run: _spectrum(run, known), steady), steady, strict=True)
    spectra = [replace(spectrum, observed=run) for spectrum, run in pairs]  # one run, not copies
    candidates: dict[Place, None] = {}
    for spectrum in spectra:
        speed = spectrum.observed.mean_speed
        found = [order(between_bins(spectrum.by_order, at) * spectrum.order_step) for at in _tops(spectrum.by_order)]
        found += [frequency(between_bins(spectrum.by_frequency, at) * spectrum.frequency_step)
                  for at in _tops(spectrum.by_frequency)]  # fmt: skip
        candidates.update((place, None) for place in found if place.frequency(speed) > _LOWEST)
    judged = [_judged(place, spectra) for place in candidates]
    judged = [replace(peak, excess=_as_a_whole(peak, judged, spectra)) for peak in judged]
    judged.sort(key=lambda peak: (-peak.speeds, -round(peak.excess, 1), peak.place.domain == "frequency"))
    accepted: list[Peak] = []
    tones = [place for place in known if place.domain == "frequency"]
    for peak in judged:
        if len(accepted) >= _MOST or _skirt(peak, known, accepted, spectra):
            continue
        if not any(_same(peak, place, spectra) for place in (*tones, *(other.place for other in accepted))):
            accepted.append(peak)
    return tuple(sorted(accepted, key=lambda peak: -peak.excess))


def beside_lines(run: Observed, known: Sequence[Place]) -> Floats:
    """Return what the lines at ``known`` leave of the torque in the stretches that fits may see, one after another."""
    seen = [stretch for stretch in run.stretches if not stretch.held]
    return np.concatenate([_rest(run, stretch.start, stretch.stop, known) for stretch in seen])


def _spectrum(run: Observed, known: Sequence[Place]) -> _Spectrum:
    rest = beside_lines(run, known)
    angle = run.angle[run.seen.start : run.seen.start + rest.size]
    window = np.hanning(rest.size)
    direct = np.abs(np.fft.rfft(rest * window)) ** 2
    even = np.linspace(angle[0], angle[-1], rest.size)
    resampled = np.interp(even, angle, rest) if angle[-1] > angle[0] else rest
    turned = np.abs(np.fft.rfft(resampled * window)) ** 2
    return _Spectrum(
        run,
        over_floor(turned, below=TOP_ORDER),
        2 * pi / abs(float(angle[-1] - angle[0])) * (rest.size - 1) / rest.size,
        over_floor(direct, below=_TOP_FREQUENCY),
        run.rate / rest.size,
        turned,
        direct,
    )


def _rest(run: Observed, start: int, stop: int, known: Sequence[Place]) -> Floats:
    from torquerig.diagnosis.looking.observed import Stretch

    shown = [known[index] for index in shown_places(run, Stretch(start, stop, False), known, apart=RESOLVED_WELL)]
    time = np.arange(start, stop) / run.rate
    return regressed(run.torque[start:stop], Waves(shown, run.angle[start:stop], time)).rest


def over_floor(power: Floats, *, below: float) -> Floats:
    """Power over the local mean that its median stands for; 0 from the share ``below`` of the bins on.

    Of two medians the larger counts: what a lightly damped mode leaves is as narrow as some bins, and no line.
    """
    from scipy.ndimage import median_filter

    wide, near = (median_filter(power, size=2 * reach + 1, mode="nearest") for reach in (_NEIGHBOURS, _NEAREST))
    answer = power / np.maximum(np.maximum(wide, near) / np.log(2), 1e-30)
    answer[int(below * answer.size) :] = 0.0
    return np.asarray(answer)


def _tops(excess: Floats) -> list[int]:
    above = np.flatnonzero(excess > CLEAR)
    return [int(at) for at in above if excess[at] == excess[max(at - 2, 0) : at + 3].max()]


def _judged(place: Place, spectra: Sequence[_Spectrum]) -> Peak:
    shown = [spectrum for spectrum in spectra if spectrum.excess(place) > SUPPORTING]
    speeds: list[float] = []
    for spectrum in shown:
        speed = spectrum.observed.mean_speed
        if not any(abs(speed / other - 1) < 0.03 for other in speeds):
            speeds.append(speed)
    top = max((spectrum.excess(place) for spectrum in spectra), default=0.0)
    return Peak(place, top, tuple(spectrum.observed.name for spectrum in shown), len(speeds))


def _as_a_whole(peak: Peak, others: Sequence[Peak], spectra: Sequence[_Spectrum]) -> float:
    """Return the excess of an order, no less than that of a side line at a fixed frequency, of which it is the whole.

    An angle that was followed in the torque gathers what an uneven speed scatters over time, and stands in a floor that
    it has raised itself: in time a single side line may stand out further, of less than half the power.
    """
    if peak.place.domain != "order" or peak.excess < LEADING:
        return peak.excess
    whole = peak.excess
    for other in others:
        if other.place.domain == "frequency" and other.excess > whole and other.speeds <= peak.speeds:
            shown = [each for each in spectra if each.observed.name in other.runs and each.observed.smearing]
            if len(shown) == len(other.runs) and all(_scattered(other.place, peak.place, each) for each in shown):
                whole = other.excess
    return whole


def _scattered(tone: Place, turning: Place, spectrum: _Spectrum) -> bool:
    """Whether a tone stands where an unmeasured angle spreads an order, with less than half of its power."""
    speed, smearing = spectrum.observed.mean_speed, spectrum.observed.smearing
    at = turning.frequency(speed)
    near = abs(tone.frequency(speed) - at) < smearing * at
    return near and spectrum.power(turning) > _TWICE * spectrum.power(tone)


def _skirt(peak: Peak, known: Sequence[Place], accepted: Sequence[Peak], spectra: Sequence[_Spectrum]) -> bool:
    """Whether the peak stands, in every run that shows it, where an unmeasured angle spreads a stronger line."""
    stronger = [*known, *(other.place for other in accepted if other.excess >= peak.excess)]
    for spectrum in spectra:
        if spectrum.observed.name not in peak.runs:
            continue
        speed, smearing = spectrum.observed.mean_speed, spectrum.observed.smearing
        at = peak.place.frequency(speed)
        if not any(abs(at - line.frequency(speed)) < smearing * at for line in stronger):
            return False
    return bool(peak.runs)


def _same(peak: Peak, other: Place, spectra: Sequence[_Spectrum]) -> bool:
    """Whether both stand at one frequency in every run that shows ``peak``: a line has a width of some bins.

    A known tone that wanders leaves that much of itself beside where it was taken out.
    """
    near = []
    for spectrum in spectra:
        if spectrum.observed.name not in peak.runs:
            continue
        speed = spectrum.observed.mean_speed
        apart = abs(peak.place.frequency(speed) - other.frequency(speed))
        smeared = SHIFTED * spectrum.observed.smearing * other.frequency(speed)
        near.append(apart < max(3.0 * spectrum.frequency_step, smeared))
    return bool(near) and all(near)
