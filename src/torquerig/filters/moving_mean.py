"""Moving mean: other stages are applied to the deviation from it, and it is added again."""

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
    """Subtracts the centred moving mean, applies ``around`` to the deviation, and adds the moving mean again.

    Parameters
    ----------
    samples : int
        Length of the mean [samples], >= 1; the reference report takes 1000 (40 ms at 25 kHz).
    around : tuple of Stage
        The stages that are applied to the deviation, in order.

    Notes
    -----
    Source: the text of the reference report (its code computes the mean and does not use it). A line at f is kept by
    sin(pi f n / rate) / (n sin(pi f / rate)): 97 % of the shaft line at 3.33 Hz are kept (report audit B3).
    """

    samples: int
    around: tuple[Stage, ...]

    def __post_init__(self) -> None:
        if self.samples < 1:
            raise InputError(f"a moving mean over {self.samples} samples is not possible; write at least 1")

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
        deviation = recording.with_values(name, values - slow)
        for stage in self.around:
            deviation = stage.apply(deviation)
        return deviation.with_values(name, deviation.channels[name].values + slow)


def moving_mean(values: NDArray[np.float64], samples: int) -> NDArray[np.float64]:
    """Return the centred mean over ``samples`` samples, over fewer at the ends (as MATLAB's ``movmean``).

    An even window reaches one sample further back than forward.
    """
    size = values.size
    if size == 0:
        return values
    back, ahead = min(samples // 2, size), min((samples - 1) // 2 + 1, size)
    offset = values.mean()  # subtracted to reduce rounding errors of the sums
    sums = np.empty(size + 1)
    sums[0] = 0.0
    np.cumsum(values - offset, out=sums[1:])
    # sums up to the last sample of each window, less those before its first; windows are cut at the ends
    means = np.empty(size)
    means[: size - ahead] = sums[ahead:size]
    means[size - ahead :] = sums[size]
    means[back:] -= sums[: size - back]
    means[:back] /= np.minimum(np.arange(back) + ahead, size)
    if size - back > 0:
        later = np.arange(max(size - ahead, back), size)
        means[back : later[0] if later.size else size] /= samples
        means[later] /= size - later + back
    means += offset
    return means
