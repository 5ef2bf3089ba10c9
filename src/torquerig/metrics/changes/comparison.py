"""All changes between two recordings of one rig, and what of them cannot be compared."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from torquerig.errors import InputError
from torquerig.metrics.changes.level_changes import band_changes, mean_change
from torquerig.metrics.changes.line_changes import LOWEST, line_changes, merged
from torquerig.metrics.changes.segments import finest_place
from torquerig.metrics.changes.side import Side, side_of
from torquerig.orders.analysis.labels import label_of

if TYPE_CHECKING:
    from torquerig.metrics.changes.change import Change
    from torquerig.orders.kinematics.kinematic_lines import Kinematics
    from torquerig.recordings.recording import Recording

TOP = 0.4
"""Share of the lower sample rate up to which is compared: above, converters and their filters differ."""
_SAME_SPEED = 0.02  # [1] relative difference of the speeds that no resonance of usual damping makes visible
_MAINS_MULTIPLES = 10  # that are tested in every comparison
_MAINS = "x mains"  # end of the label of a line that no shaft has


@dataclass(frozen=True, kw_only=True)
class Changes:
    """The comparison of two recordings.

    Parameters
    ----------
    before, after : Side
    unit : str
        Of all sizes: N*m or N.
    tested : tuple of Change
        Every line, level and band that was tested.
    remarks : tuple of str
        What differs in the conditions, and what could not be compared.
    """

    before: Side
    after: Side
    unit: str
    tested: tuple[Change, ...]
    remarks: tuple[str, ...]

    @property
    def changed(self) -> tuple[Change, ...]:
        """The changes that exceed the random error, the largest first."""
        return tuple(sorted((one for one in self.tested if one.is_change), key=lambda one: -abs(one.difference)))

    def unseen(self, kind: str) -> float | None:
        """Return the smallest change that every test of a kind without a change would have shown; None without one."""
        return max((one.smallest_seen for one in self.tested if one.kind == kind and not one.is_change), default=None)


def changes(
    before: Recording, after: Recording, kinematics: Kinematics, *, harmonics: int = 4, mains: float = 50.0
) -> Changes:
    """Return what changed from one recording to another of the same rig.

    Parameters
    ----------
    before, after : Recording
        Of the same measured channel.
    kinematics : Kinematics
        The shafts of the rig and their lines.
    harmonics : int
        Of each family of lines that are tested.
    mains : float
        Frequency of the grid [Hz], whose multiples are tested.

    Raises
    ------
    InputError
        Where one measures a torque and the other a force.
    RecordingError
        For a recording that is too short or has samples that are not numbers.
    """
    unit = before.torque_unit()
    if after.torque_unit() != unit:
        raise InputError(f"{before.name} measures in {unit}, {after.name} in {after.torque_unit()}; compare two "
                         "recordings of one channel")  # fmt: skip
    first, second = (side_of(one, kinematics, harmonics=harmonics, mains=mains) for one in (before, after))
    top = TOP * min(before.sample_rate, after.sample_rate)
    orders = _order_changes(first, second, kinematics, harmonics=harmonics, top=top)
    fixed = _frequency_changes(first, second, mains=mains, top=top)
    orders, fixed = _each_once(orders, fixed, (first, second))
    lines = [one.at for one in fixed]
    for side in (first, second):
        if side.is_steady:
            lines += [one.at * side.turns_per_second for one in orders]
    levels = (mean_change(first.segment_means, second.segment_means),
              *band_changes(first.over_time, second.over_time, lines, highest=top))  # fmt: skip
    return Changes(
        before=first, after=second, unit=unit, tested=(*orders, *fixed, *levels), remarks=tuple(_remarks(first, second))
    )


def _order_changes(
    first: Side, second: Side, kinematics: Kinematics, *, harmonics: int, top: float
) -> tuple[Change, ...]:
    if first.over_turns is None or second.over_turns is None:
        return ()
    width = max(first.over_turns.bin, second.over_turns.bin)
    known = [(one.output_order, label_of([one])) for one in kinematics.lines(harmonics)]
    highest = top / max(first.speeds[1], second.speeds[1])
    places = merged([*known, *first.orders, *second.orders], width=2 * width, lowest=LOWEST * width, highest=highest)
    found = line_changes(first.over_turns, second.over_turns, places, kind="order")
    turns = _one_speed(first, second)
    return found if turns is None else tuple(replace(one, frequency=one.at * turns) for one in found)


def _one_speed(first: Side, second: Side) -> float | None:
    """Return the turns per second of both recordings where they have one constant speed; None where not."""
    if not (first.is_steady and second.is_steady):
        return None
    turns = [side.turns_per_second for side in (first, second)]
    return sum(turns) / 2 if abs(turns[1] / turns[0] - 1) <= _SAME_SPEED else None


def _frequency_changes(first: Side, second: Side, *, mains: float, top: float) -> tuple[Change, ...]:
    width = max(first.over_time.bin, second.over_time.bin)
    grid = [(mains * multiple, f"{multiple} x mains") for multiple in range(1, _MAINS_MULTIPLES + 1)]
    found = [*grid, *first.frequencies, *second.frequencies, *_perhaps_fixed(first), *_perhaps_fixed(second)]
    places = merged(found, width=2 * width, lowest=LOWEST * width, highest=top)
    both = (first.over_time, second.over_time)
    exact = {place if cause else finest_place(both, place): cause for place, cause in places.items()}
    return line_changes(first.over_time, second.over_time, dict(sorted(exact.items())), kind="frequency")


def _perhaps_fixed(side: Side) -> Iterator[tuple[float, str]]:
    """Yield the frequencies of lines over the order without a cause on a shaft: at one speed they may be fixed."""
    for order, label in side.orders if side.is_steady else ():
        if not label:
            yield order * side.turns_per_second, label


def _each_once(
    orders: tuple[Change, ...], fixed: tuple[Change, ...], sides: tuple[Side, Side]
) -> tuple[tuple[Change, ...], tuple[Change, ...]]:
    """Return both without the lines that are in the other: at one speed a line has an order and a frequency.

    An order with a cause on a shaft stays. Else the larger change stays: on the wrong axis, the wander of the speed
    smears a line.
    """
    gone: set[int] = set()
    for side in sides:
        if not side.is_steady:
            continue
        turns, width = side.turns_per_second, 2 * side.over_time.bin
        for order in orders:
            known = bool(order.cause) and not order.cause.endswith(_MAINS)
            for one in fixed:
                if abs(order.at * turns - one.at) < width:
                    gone.add(id(one if known or abs(order.difference) >= abs(one.difference) else order))
    return tuple(one for one in orders if id(one) not in gone), tuple(one for one in fixed if id(one) not in gone)


def _remarks(first: Side, second: Side) -> Iterator[str]:
    for side in (first, second):
        if side.no_angle:
            yield f"no orders are compared: {side.no_angle}"
    one, other = first.recording, second.recording
    if one.sample_rate != other.sample_rate:
        low = min(one.sample_rate, other.sample_rate)
        yield (
            f"the sample rates differ ({one.sample_rate:g} and {other.sample_rate:g} Hz): compared up to "
            f"{TOP * low:g} Hz"
        )
    yield from _motion_remarks(first, second)
    stated = (one.run.occupancy_percent, other.run.occupancy_percent)
    if None not in stated and stated[0] != stated[1]:
        yield (
            f"the stated loads differ ({stated[0]:g} and {stated[1]:g} % occupancy): mean, bands and lines of the load "
            "change with it"
        )


def _motion_remarks(first: Side, second: Side) -> Iterator[str]:
    if first.turns is None or second.turns is None:
        return
    if first.is_steady != second.is_steady:
        yield (
            "one recording is at constant speed, the other is not: orders are compared over the turns, but a resonance "
            "that one of them passes changes its lines and bands"
        )
    means = [side.turns_per_second for side in (first, second)]
    apart = abs(means[1] / means[0] - 1)
    if apart > _SAME_SPEED:
        yield (
            f"the mean speeds differ by {100 * apart:.3g} %: orders are compared with orders; a line near a resonance "
            "changes with the speed without a change of the rig, and so do bands"
        )
    elif first.is_steady and second.is_steady:
        yield (
            "both speeds are constant and equal, so that an order and a fixed frequency cannot be distinguished: "
            "compare ramps to know which one changed"
        )
    else:
        yield "the speed changes within the recordings: bands hold lines that pass through them"
