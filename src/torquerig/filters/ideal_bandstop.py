"""Ideal band-stop: narrow bands around the lines are set to zero in the spectrum (the reference report's filter)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError
from torquerig.filters.selected_bins import bins_at, bins_within, signal_of
from torquerig.recordings.set_point import set_point_speed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

Bands = tuple[tuple[float, float], ...]


@dataclass(frozen=True, kw_only=True)
class IdealBandstop:
    """Removes the bins within ``half_width`` of each line's frequency at the set-point speed; the mean is kept.

    Parameters
    ----------
    lines : tuple of KinematicLine
        The lines to remove; their frequencies follow from the motor's set-point in the recording's run.
    half_width : float
        Half of each band [Hz], > 0; the reference report takes 0.5 Hz.

    Notes
    -----
    Source: reference report, Appendix A (MATLAB's ``idealfilter(..., 'notch')`` on data without their mean, band by
    band; the bands commute, so all are cut in one transform). Limits: the filter is not causal, rings for about
    1 / (2 half_width) around a step, wraps around at the ends of the record, misses a line whose speed is off by more
    than half_width / frequency (0.18 % at 280 Hz), and takes the load within the bands along (report audit B5, B6).
    """

    lines: tuple[KinematicLine, ...]
    half_width: float = 0.5

    def __post_init__(self) -> None:
        if not self.half_width > 0:
            raise InputError(f"a band-stop of half-width {self.half_width} Hz removes nothing; write more than 0 Hz")

    def bands(self, motor_speed: float) -> Bands:
        """Return the bands (low, high) [Hz] at a motor speed [rad/s], line by line."""
        centres = (line.frequency(motor_speed) for line in self.lines)
        return tuple((centre - self.half_width, centre + self.half_width) for centre in centres)

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the bands; RecordingError where the run states no speed."""
        if not self.lines:
            return recording
        bands = self.bands(set_point_speed(recording, "the band-stops"))
        name = recording.torque_name()
        return recording.with_values(name, without_bands(recording.channels[name].values, recording.sample_rate, bands))


def without_bands(
    values: NDArray[np.float64], rate: float, bands: Iterable[tuple[float, float]]
) -> NDArray[np.float64]:
    """Return ``values`` without the bins of its transform from low to high, edges included; the mean is kept.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Any unit.
    rate : float
        Sample rate [Hz].
    bands : iterable of (low, high)
        [Hz]; the part above half the rate is ignored.
    """
    if values.size == 0:
        return values
    wanted = bins_within(values.size, rate, bands)
    cut = signal_of(bins_at(values, wanted), wanted, values.size)
    # in place, for long recordings
    return np.subtract(values, cut, out=cut)
