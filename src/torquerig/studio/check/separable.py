"""Which causes the conditions of the runs separate, and which they do not.

A line that keeps its order over several speeds comes from the drive, one that keeps its frequency does not: at one
speed both look alike. Lines of equal order need another load or current. These are the rules that the order report
uses, over all runs together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

from torquerig.orders.kinematics.coincidences import coincidences
from torquerig.orders.kinematics.kinematic_lines import KinematicLine, Kinematics
from torquerig.orders.kinematics.order_report_text import name_of
from torquerig.recordings.recording import Recording

HARMONICS = 4  # per family, as in the order report
APART = 0.02  # [1] two set-points within it are one speed: real speeds scatter by 1 %
MAINS = 50.0  # [Hz]
ANGLES = ("motor_angle", "angle", "tacho")


@dataclass(frozen=True)
class Separable:
    """What these runs can tell apart, and what they cannot, each with the remedy."""

    can: tuple[str, ...]
    cannot: tuple[str, ...]


def separable(kinematics: Kinematics, recordings: Sequence[Recording]) -> Separable:
    """Return what recordings of one rig can tell apart, by their speeds, loads, profiles and channels.

    Parameters
    ----------
    kinematics : Kinematics
        Poles, slots, ratio and teeth of the rig.
    recordings : sequence of Recording
    """
    found = [
        _by_speed(recordings), _by_load(recordings), _by_profile(recordings), _by_angle(recordings),
        *_by_lines(kinematics.lines(HARMONICS), recordings),
    ]  # fmt: skip
    return Separable(
        can=tuple(text for is_good, text in found if is_good),
        cannot=tuple(text for is_good, text in found if not is_good),
    )


def _by_speed(recordings: Sequence[Recording]) -> tuple[bool, str]:
    speeds = _distinct([abs(one.run.speed) for one in recordings if one.run.speed])
    what = "lines of the drive, which keep their order, from resonances and mains lines, which keep their frequency"
    if len(speeds) > 1 or any(one.run.profile != "steady" for one in recordings):
        return True, what
    return False, f"{what}: all runs have one speed; add a run at another speed"


def _by_load(recordings: Sequence[Recording]) -> tuple[bool, str]:
    loads = {one.run.occupancy_percent for one in recordings if one.run.occupancy_percent is not None}
    if len(loads) > 1:
        return True, "effects that grow with the load from those that do not"
    return False, "effects that grow with the load from those that do not: all runs have one load; add an idle run"


def _by_profile(recordings: Sequence[Recording]) -> tuple[bool, str]:
    if any(one.run.profile == "reversal" for one in recordings):
        return True, "friction, backlash and hysteresis, which show where the speed changes its sign"
    return False, "friction, backlash and hysteresis: no run changes its direction; add one with profile reversal"


def _by_angle(recordings: Sequence[Recording]) -> tuple[bool, str]:
    measured = [one for one in recordings if any(one.find(quantity) for quantity in ANGLES)]
    if len(measured) == len(recordings):
        return True, "neighbouring orders, because the angle was measured"
    return False, (
        "neighbouring orders as finely as with an angle: the speed of "
        f"{_listed([one.name for one in recordings if one not in measured])} comes from the torque's lines alone"
    )


def _by_lines(lines: Sequence[KinematicLine], recordings: Sequence[Recording]) -> list[tuple[bool, str]]:
    """Return what equal orders, the mains and half the sample rate hide, over all runs."""
    speeds = _distinct([abs(one.run.speed) for one in recordings if one.run.speed])
    if not speeds or not lines:
        return []
    found: list[tuple[bool, str]] = []
    for group in coincidences(lines, speeds[0], mains=MAINS).equal_orders:
        names = _listed(list(dict.fromkeys(name_of(line) for line in group.lines)))
        found.append((False, f"{names}: equal orders, which no speed separates; another load or current may"))
    hidden = [{hit.line for hit in coincidences(lines, speed, mains=MAINS).on_mains} for speed in speeds]
    everywhere, somewhere = set.intersection(*hidden), set.union(*hidden)
    if everywhere:
        where = f"on a multiple of {MAINS:g} Hz in each run; choose another speed"
        found.append((False, f"{_names(lines, everywhere)} from the mains: {where}"))
    if moved := somewhere - everywhere:
        found.append((True, f"{_names(lines, moved)} from the mains, because another speed moves it"))
    highest = max(one.sample_rate for one in recordings) / 2
    above = {line for line in lines if min(line.frequency(speed) for speed in speeds) > highest}
    if above:
        found.append((False, f"{_names(lines, above)}: above half the sample rate, {highest:g} Hz, in each run"))
    return found


def _distinct(speeds: Sequence[float]) -> list[float]:
    """Return the speeds [rad/s] that differ by more than the scatter of a set-point, rising."""
    found: list[float] = []
    for speed in sorted(speeds):
        if not found or speed > found[-1] * (1 + APART):
            found.append(speed)
    return found


def _names(lines: Sequence[KinematicLine], chosen: set[KinematicLine]) -> str:
    return _listed(list(dict.fromkeys(name_of(line) for line in lines if line in chosen)))


def _listed(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def speeds_shown(recordings: Sequence[Recording]) -> str:
    """Return the distinct speeds of the runs [rpm] as text."""
    speeds = _distinct([abs(one.run.speed) for one in recordings if one.run.speed])
    return ", ".join(f"{speed * 30 / pi:.4g}" for speed in speeds) + " rpm" if speeds else "no speed is stated"
