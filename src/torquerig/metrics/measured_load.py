"""The load of a recording: the true one of a simulation, else the one that a second sensor measured."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.recording import EFFORTS, Recording

LOAD = "load"
"""What ``of`` names where a channel is the load itself and not a part of the scenario."""


@dataclass(frozen=True, kw_only=True)
class MeasuredLoad:
    """A load that a second sensor measured.

    Parameters
    ----------
    channel : str
    values : ndarray, shape (samples,)
        With the sign of the reading [N m], in a line [N].
    is_turned : bool
        True where the channel has the other sign than the reading, as of a sensor mounted the other way round.
    """

    channel: str
    values: NDArray[np.float64]
    is_turned: bool


def measured_load(recording: Recording) -> MeasuredLoad | None:
    """Return the measured load; None where no channel is one.

    It is a channel of the reading's quantity that is not the reading, with the role ``input`` or ``of: load``. Its sign
    follows the reading: the mean of their product is positive.

    Raises
    ------
    RecordingError
        Where several channels may be the load.
    """
    reading = recording.torque_name()
    quantity = recording.channels[reading].quantity
    found = [
        name
        for name, one in recording.channels.items()
        if name != reading and quantity in EFFORTS and one.quantity == quantity and not one.truth
        and (one.role == "input" or one.of == LOAD)
    ]  # fmt: skip
    named = [name for name in found if recording.channels[name].of == LOAD] or found
    if len(named) > 1:
        raise RecordingError(
            f"{recording.name}: {' and '.join(named)} may be the load; write of: {LOAD} at the one that is, in the "
            "sidecar"
        )
    if not named:
        return None
    values = recording.channels[named[0]].in_si()
    is_turned = bool(np.mean(values * recording.torque()) < 0)
    return MeasuredLoad(channel=named[0], values=-values if is_turned else values, is_turned=is_turned)
