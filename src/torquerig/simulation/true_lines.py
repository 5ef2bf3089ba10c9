"""The disturbance lines in a reading: the difference to a second run with the same random numbers and without them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from torquerig.recordings.recording import EFFORTS, Channel, Recording
from torquerig.simulation.measured_places import what_is_read
from torquerig.simulation.sampling import SETTLING
from torquerig.simulation.simulator import simulate

if TYPE_CHECKING:
    from torquerig.rig.assembly import Rig

TRUE_LINES = "true_lines_Nm"
_NAMES = {"true_load_Nm": TRUE_LINES, "true_load_N": "true_lines_N"}
"""Channel of the lines by that of the load, of a rig that turns and of one that moves in a line."""
_LINE_GROUPS = ("mechanical", "cogging", "electrical")


def without_lines(rig: Rig) -> Rig:
    """Return the rig without its mechanical, cogging and electrical mechanisms; loads and the sensor's stay."""
    return replace(rig, parts=tuple(part for part in rig.parts if part.group not in _LINE_GROUPS))


def with_true_lines(
    recording: Recording, rig: Rig, *, seed: int, wander: float = 0.0, settling: float = SETTLING
) -> Recording:
    """Return a simulated recording with what its lines add to the reading, as the channel ``true_lines_Nm`` [N m].

    In a line it is ``true_lines_N`` [N].

    The reading less this channel is perfect line removal: what a filter could reach that knew every line and nothing
    else.

    Parameters
    ----------
    recording : Recording
        Of ``rig``, by ``simulate`` with this seed, wander and settling time. Where the true load is
        not known, or no torque is measured, it comes back as it is.

    Notes
    -----
    Phases, load and noise are drawn by their own names, so that both runs have the same. Without lines the shaft
    turns a little differently and meets the load a little elsewhere; so the channel is the difference of the two
    readings' errors, each to the load of its own run.
    """
    load = next((one for one in _NAMES if one in recording.channels), None)
    if load is None or what_is_read(rig, rig.measured)[0] not in EFFORTS:
        return recording
    clean = simulate(
        without_lines(rig), duration=recording.duration, seed=seed, sample_rate=recording.sample_rate, wander=wander,
        settling=settling, substeps=recording.origin.get("substeps"),
    )  # fmt: skip
    wrong, left = (one.torque() - one.channels[load].in_si() for one in (recording, clean))
    of_load = recording.channels[load]
    lines = Channel(values=wrong - left, quantity=of_load.quantity, unit=of_load.unit, truth=True)
    return recording.with_channel(_NAMES[load], lines)


def true_lines(recording: Recording) -> Channel | None:
    """Return the channel of the lines; None where they are not known."""
    return next((recording.channels[one] for one in _NAMES.values() if one in recording.channels), None)
