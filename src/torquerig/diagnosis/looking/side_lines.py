"""Which peaks are only the side lines that an uneven speed gives to the lines of a shaft."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import SHIFTED, Peak
from torquerig.inference.places import SAME_ORDER, Place
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of

Floats = NDArray[np.float64]

REACH = 16.0  # orders of the motor: what strays faster moves no shaft far
_PASSED = 1.3  # times as large as its source may a side line be read: it passes a shaft that rings, its carrier less
_FOLLOWED = 2.0  # the same for an angle that was followed in the torque, and is known less well
_OF_SECOND_ORDER = 0.015  # of a new line's size
_MAY_STAND = np.linspace(0.94, 1.06, 13)  # [1] of its nominal frequency may a mode stand
_POINTS = 16_384  # that an angle's straying is looked at
_OWN_BINS = 3  # of a line under a Hann window
_WIDTH = 1.5  # bins over which the straying at an offset is sought


def without_side_lines(
    peaks: Sequence[Peak], runs: Sequence[Observed], known: Sequence[Place], *, rig: Rig
) -> tuple[Peak, ...]:
    """Return the peaks that stand out in some run beyond what the speed's own unevenness puts there.

    An angle that strays by ``Re(c exp(i m theta))`` gives a line ``A`` of order n side lines of ``J_k(n |c|) A`` at
    n + k m and n - k m, J being Bessel's functions: ``n |c| A / 2`` at the first. Where the shafts pass those otherwise
    than the line itself, they are left even when the angle is known, and no model of lines has them. A slow line of
    torque T also twists the sensor, of stiffness k, by T / k, and with it the teeth that make faster lines. Carriers
    are ``known`` and the peaks that are clearer; of these, which may be far stronger than any known line, side lines of
    second order are reckoned with as a share of their size.
    """
    twin = Twin(rig)
    spring = twin.springs.get(rig.measured)
    twist = 0.0 if spring is None else kinematics_of(rig).ratio / spring.stiffness
    kept: list[Peak] = []
    steady = {run.name: _Straying(run, twin, twist=twist) for run in runs if run.steady}
    for peak in sorted(peaks, key=lambda each: -each.excess):
        new = [other.place for other in kept]
        carriers = [*known, *new]
        shown = [steady[name] for name in peak.runs if name in steady]
        if not shown or any(run.beyond(peak.place, carriers, new) for run in shown):
            kept.append(peak)
    return tuple(kept)


class _Straying:
    """One run's angle, and how far it strays at each offset."""

    def __init__(self, run: Observed, twin: Twin, *, twist: float) -> None:
        self.passed = twin.torque_on(twin.drives[0].on) if twin.drives else None
        part = run.seen
        self.angle, torque = run.angle[part], run.torque[part]
        self.time = np.arange(part.start, part.stop) / run.rate
        self.window = np.hanning(self.angle.size)
        self.torque = (torque - torque.mean()) * self.window
        turned = np.linspace(self.angle[0], self.angle[-1], self.angle.size)
        self.speed = float(np.ptp(turned)) / (self.time[-1] - self.time[0])
        along = np.linspace(-1.0, 1.0, turned.size)
        strayed = self.angle - turned
        strayed = strayed - np.polynomial.polynomial.polyval(along, np.polynomial.polynomial.polyfit(along, strayed, 2))
        thinned = max(1, strayed.size // _POINTS)
        self.strayed, self.thin_window = strayed[::thinned], self.window[::thinned]
        self.per_bin = 2 * np.pi / float(np.ptp(turned))  # [1/rev of the motor]
        self.smearing = run.smearing
        self.margin = _PASSED if run.angle_measured else _FOLLOWED
        self.twist = twist  # [rad of the motor per N m]
        self.sizes: dict[Place, float] = {}
        self.spreads: dict[float, Floats] = {}

    def beyond(self, place: Place, carriers: Sequence[Place], new: Sequence[Place]) -> bool:
        """Whether the line at ``place`` is larger than all side lines of the carriers could make it there."""
        at, bound = self._order(place), 0.0
        for carrier in carriers:
            order = self._order(carrier)
            if SAME_ORDER < abs(at - order) < REACH:
                share = self._spread(order, at - order, shifted=SHIFTED * self.smearing * at)
                share += 0.5 * order * self._twists(abs(at - order), carriers)
                bound += share * self._size(carrier) * self._rings(at, order)
        near = (self._size(other) for other in new if abs(self._order(other) - at) < REACH)
        return self._size(place) > self.margin * bound + _OF_SECOND_ORDER * max(near, default=0.0)

    def _rings(self, at: float, carrier: float) -> float:
        """By what the shafts pass the side line more than its carrier, their modes being where they may be; 1 if less.

        Both come of the motor's torque; where a carrier does not, its source passes no better near the same mode.
        """
        if self.passed is None:
            return 1.0
        hertz = self.speed / (2 * np.pi)
        side = np.abs(self.passed(at * hertz * _MAY_STAND)).max()
        return max(1.0, float(side / np.abs(self.passed(np.array([carrier * hertz])))[0]))

    def _twists(self, offset: float, carriers: Sequence[Place]) -> float:
        slow = (carrier for carrier in carriers if abs(self._order(carrier) - offset) < SAME_ORDER)
        return sum(self._size(carrier) for carrier in slow) * self.twist

    def _order(self, place: Place) -> float:
        return place.at if place.domain == "order" else place.at * 2 * np.pi / self.speed

    def _spread(self, order: float, offset: float, *, shifted: float) -> float:
        """Return the share of a line's size that straying puts at an offset [1/rev of the motor] from it."""
        if order not in self.spreads:
            waves = np.fft.fft(np.exp(1j * order * self.strayed) * self.thin_window)
            self.spreads[order] = np.abs(waves) / self.thin_window.sum()
        width = _WIDTH + shifted / self.per_bin
        low, high = int(np.floor(offset / self.per_bin - width)), int(np.ceil(offset / self.per_bin + width)) + 1
        bins = np.arange(low, high)
        clear = bins[np.abs(bins) > _OWN_BINS] % self.strayed.size
        return float(self.spreads[order][clear].max(initial=0.0))

    def _size(self, place: Place) -> float:
        if place not in self.sizes:
            taken = self.torque @ np.exp(-1j * place.phase(self.angle, self.time))
            self.sizes[place] = float(2 * abs(taken) / self.window.sum())
        return self.sizes[place]
