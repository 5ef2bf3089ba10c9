"""What moves slowly is kept aside while other stages work on the rest, and then put back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError, RecordingError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording
    from torquerig.recordings.stage import Stage


@dataclass(frozen=True, kw_only=True)
class MovingMeanKept:
    """Takes the centred moving mean off, lets ``around`` work on what remains, and puts the moving mean back.

    Parameters
    ----------
    samples : int
        Length of the mean [samples], >= 1; the reference report takes 1000 (40 ms at 25 kHz).
    around : tuple of Stage
        What works on the rest, in order.

    Notes
    -----
    Source: the text of the reference report (its code computes the mean and does not use it). A line at f is kept by
    sin(pi f n / rate) / (n sin(pi f / rate)): 97 % of the shaft line at 3.33 Hz comes back (report audit B3).
    """

    samples: int
    around: tuple[Stage, ...]

    def __post_init__(self) -> None:
        if self.samples < 1:
            raise InputError(f"a moving mean over {self.samples} samples cannot be; write at least 1")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with ``around`` applied to its torque less the moving mean."""
        name = recording.torque_name()
        values = recording.channels[name].values
        if values.size < self.samples:
            raise RecordingError(
                f"{recording.name}: {values.size} samples are too few for a moving mean of {self.samples}; "
                "take a longer recording or a shorter mean"
            )
        slow = moving_mean(values, self.samples)
        rest = recording.with_values(name, values - slow)
        for stage in self.around:
            rest = stage.apply(rest)
        return rest.with_values(name, rest.channels[name].values + slow)


def moving_mean(values: NDArray[np.float64], samples: int) -> NDArray[np.float64]:
    """Return the centred mean over ``samples`` samples, over fewer at the ends (as MATLAB's ``movmean``).

    An even window reaches one sample further back than forward.
    """
    size = values.size
    if size == 0:
        return values
    back, ahead = min(samples // 2, size), min((samples - 1) // 2 + 1, size)
    offset = values.mean()  # sums of small numbers lose fewer digits
    sums = np.empty(size + 1)
    sums[0] = 0.0
    np.cumsum(values - offset, out=sums[1:])
    # sums up to the last sample of each window, less those before its first; windows are cut at the ends
    answer = np.empty(size)
    answer[: size - ahead] = sums[ahead:size]
    answer[size - ahead :] = sums[size]
    answer[back:] -= sums[: size - back]
    answer[:back] /= np.minimum(np.arange(back) + ahead, size)
    if size - back > 0:
        later = np.arange(max(size - ahead, back), size)
        answer[back : later[0] if later.size else size] /= samples
        answer[later] /= size - later + back
    answer += offset
    return answer
