"""The effect of a filter chain: standard deviation, mean, energy and the level of each line, before and after."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError
from torquerig.filters.selected_bins import bins_at, bins_within
from torquerig.orders.angle.tacho import recorded_motor_angle
from torquerig.recordings.set_point import set_point_profile

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

LINE_HALF_WIDTH = 0.5  # Hz, as wide as the reference report's band-stops
ROUNDING = 1e-9  # [1] of the standard deviation: lines subtracted and added again sum a million samples at 1e-15 each
SEEN_IN_MEAN = 0.05  # [1] of the standard deviation: the standard error of a mean of 400 independent values


@dataclass(frozen=True, kw_only=True)
class LineLevel:
    """The amplitude of one line before and after [N m], from the power within 0.5 Hz of ``frequency`` [Hz]."""

    line: KinematicLine
    frequency: float
    before: float
    after: float


@dataclass(frozen=True, kw_only=True)
class FilterEffect:
    """The difference between two recordings of the same torque.

    Parameters
    ----------
    std_before, std_after : float
        Standard deviation of the torque [N m].
    mean_before, mean_after : float
        [N m].
    energy_before, energy_after : float or None
        Integral of torque times output speed [J], of force times velocity; None where neither a channel nor the
        set-point gives a speed, or the travel per turn is not stated.
    speed_origin : str
        The source of the speed for energy and lines, in words.
    levels : tuple of LineLevel
        Empty for a run that is not steady, whose lines have no constant frequency.
    motor_turns : float or None
        Turns of the motor in either direction [rev]; None where no speed is known.
    change_rms : float
        Root of the mean square of what the chain took away or added [N m].
    """

    std_before: float
    std_after: float
    mean_before: float
    mean_after: float
    energy_before: float | None
    energy_after: float | None
    speed_origin: str
    levels: tuple[LineLevel, ...]
    motor_turns: float | None = None
    change_rms: float = 0.0

    @property
    def std_reduction_percent(self) -> float:
        """The reduction of the standard deviation [%]."""
        return _reduction(self.std_before, self.std_after, of=self.std_before)

    @property
    def variance_reduction_percent(self) -> float:
        """The reduction of the variance [%]."""
        return _reduction(self.std_before**2, self.std_after**2, of=self.std_before**2)

    @property
    def mean_change_percent(self) -> float:
        """The increase of the mean [%]; 0 by construction for a chain that keeps the mean."""
        return _reduction(self.mean_after, self.mean_before, of=self.mean_before)

    @property
    def changes_nothing(self) -> bool:
        """Whether torque before and after differ by rounding errors only: 1e-9 of the standard deviation."""
        return self.change_rms <= ROUNDING * self.std_before

    @property
    def moves_mean(self) -> bool:
        """Whether the mean changed by more than 5 % of the standard deviation before.

        Every shipped chain keeps the mean of a long recording. 5 % is the standard error of the mean of 400 independent
        values: a smaller change is within what the random load does to the mean of a short recording.
        """
        return abs(self.mean_after - self.mean_before) > SEEN_IN_MEAN * self.std_before

    @property
    def energy_change_percent(self) -> float | None:
        """The increase of the energy [%], or None where no speed is known."""
        if self.energy_before is None or self.energy_after is None:
            return None
        return _reduction(self.energy_after, self.energy_before, of=self.energy_before)

    def family_levels(self) -> dict[str, tuple[float, float]]:
        """Return the amplitude of each cause before and after: root of the summed squares of its lines [N m].

        A cause is the family of its lines, or their name where they are named by a part of the rig.
        """
        sums: dict[str, tuple[float, float]] = {}
        for level in self.levels:
            cause = level.line.name or level.line.family
            was, now = sums.get(cause, (0.0, 0.0))
            sums[cause] = (was + level.before**2, now + level.after**2)
        return {cause: (float(np.sqrt(was)), float(np.sqrt(now))) for cause, (was, now) in sums.items()}


def chain_effect(
    before: Recording, after: Recording, *, ratio: float, lines: Sequence[KinematicLine] = ()
) -> FilterEffect:
    """Return the effect of a filter chain on the torque, from the recordings ``before`` and ``after`` it.

    Parameters
    ----------
    before, after : Recording
        Of equal length and rate.
    ratio : float
        Motor turns per output turn [1].
    lines : sequence of KinematicLine
        The lines whose levels are returned, for example ``chain.lines``.

    Raises
    ------
    RecordingError
        For fewer than two samples, or recordings of different length.

    Notes
    -----
    A lower standard deviation is no proof of less noise: any notches lower it (report audit A, "std as merit").
    """
    return chain_effects(before, (after,), ratio=ratio, lines=(lines,))[0]


def chain_effects(
    before: Recording, after: Sequence[Recording], *, ratio: float, lines: Sequence[Sequence[KinematicLine]]
) -> tuple[FilterEffect, ...]:
    """Return :func:`chain_effect` of several chains on one recording, whose speed is determined once."""
    for made in after:
        if made.samples != before.samples or before.samples < 2:
            raise RecordingError(
                f"{before.name}: {before.samples} samples before and {made.samples} after a chain cannot be compared; "
                "both must be of the same run and have two samples or more"
            )
    speed, origin = _motor_speed(before, ratio)
    per_motor_angle = _motion_per_motor_angle(before, ratio)
    return tuple(
        _effect(before, made, speed=speed, origin=origin, per_motor_angle=per_motor_angle, lines=named)
        for made, named in zip(after, lines, strict=True)
    )


def _effect(
    before: Recording, after: Recording, *, speed: NDArray[np.float64] | None, origin: str,
    per_motor_angle: float | None, lines: Sequence[KinematicLine],
) -> FilterEffect:  # fmt: skip
    first, last = before.torque(), after.torque()
    energies: tuple[float | None, ...] = (None, None)
    if speed is not None and per_motor_angle is not None:
        energies = tuple(_energy(each, speed * per_motor_angle, before) for each in (first, last))
    steady = speed is not None and before.run.profile == "steady"
    levels = (
        _levels(first, last, before.sample_rate, float(np.mean(speed)), lines) if steady and speed is not None else ()
    )
    return FilterEffect(
        std_before=float(first.std()),
        std_after=float(last.std()),
        mean_before=float(first.mean()),
        mean_after=float(last.mean()),
        energy_before=energies[0],
        energy_after=energies[1],
        speed_origin=origin,
        levels=levels,
        motor_turns=None if speed is None else float(np.abs(speed).sum() / before.sample_rate / (2 * np.pi)),
        change_rms=float(np.sqrt(np.mean((last - first) ** 2))),
    )


def _motor_speed(recording: Recording, ratio: float) -> tuple[NDArray[np.float64] | None, str]:
    """Return the motor speed at each sample [rad/s] and its source."""
    without = "neither a channel nor a set-point"
    try:
        angle = recorded_motor_angle(recording, ratio=ratio)
    except RecordingError as error:  # of a tacho, which the chain may not need
        angle, without = None, str(error)
    if angle is not None:
        return np.gradient(angle.values) * recording.sample_rate, angle.origin
    if recording.run.speed:
        return set_point_profile(recording, "energies"), "from the set-point; the real speed may differ"
    return None, f"no speed: {without}"


def _motion_per_motor_angle(recording: Recording, ratio: float) -> float | None:
    """Return the output's angle [rad], or under a force its travel [m], per angle of the motor; None if not stated."""
    if recording.channels[recording.torque_name()].quantity != "force":
        return 1 / ratio
    travel = recording.run.travel_per_turn
    return None if travel is None else travel / (2 * np.pi * ratio)


def _energy(torque: NDArray[np.float64], output_speed: NDArray[np.float64], recording: Recording) -> float:
    power = torque * output_speed
    return float((power.sum() - 0.5 * (power[0] + power[-1])) / recording.sample_rate)


def _levels(
    first: NDArray[np.float64], last: NDArray[np.float64], rate: float, speed: float, lines: Sequence[KinematicLine]
) -> tuple[LineLevel, ...]:
    if not lines:  # a transform for no bin takes as long as for all
        return ()
    centres = [line.frequency(speed) for line in lines]
    bins = [bins_within(first.size, rate, [(at - LINE_HALF_WIDTH, at + LINE_HALF_WIDTH)]) for at in centres]
    wanted = np.unique(np.concatenate([np.empty(0, dtype=np.int64), *bins]))
    powers = [np.abs(bins_at(each, wanted) * 2 / each.size) ** 2 for each in (first, last)]
    levels = []
    for line, centre, within in zip(lines, centres, bins, strict=True):
        before, after = (float(np.sqrt(power[np.searchsorted(wanted, within)].sum())) for power in powers)
        levels.append(LineLevel(line=line, frequency=centre, before=before, after=after))
    return tuple(levels)


def _reduction(larger: float, smaller: float, *, of: float) -> float:
    """Return the difference as a share ``of`` [%]; 0 where ``of`` is 0."""
    return 100 * (larger - smaller) / of if of else 0.0
