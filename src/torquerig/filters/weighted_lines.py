"""Weighted lines: each line is subtracted with a weight by its power above the load near it."""

from __future__ import annotations

from dataclasses import dataclass
from math import isnan, pi
from typing import TYPE_CHECKING

from torquerig.errors import InputError, RecordingError
from torquerig.filters.block_regression import at_edges, block_amplitudes, blocks_of
from torquerig.filters.counted_periods import separable_lines
from torquerig.filters.line_weights import weights
from torquerig.orders.analysis.order_envelope import hops_of, resolved_orders, without_lines
from torquerig.orders.angle.best_angle import best_motor_angle
from torquerig.orders.line_sums.sums import put_in

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording

_PLACED = 0.25  # [periods] largest standard deviation of a fitted line's phase over the record


@dataclass(frozen=True, kw_only=True)
class WeightedLines:
    """Subtracts the least-squares sines of ``lines``, each times 1 - (power of the load near it) / (its power).

    A strong line is removed completely. A line with less than four times the power of the load near it is not
    removed, so that little load is removed where the lines are weak; nor is a line whose phase the angle does not
    determine. Everything else is kept, including the mean.

    Parameters
    ----------
    lines : tuple of KinematicLine
        The lines to subtract; the angle is the recording's best one.
    block : float
        Length over which a line's amplitude and phase are constant [s], > 0; blocks overlap by half, and a shorter
        recording is one block. Load in a band of about 1 / block is removed with a line.
    changing_block : float
        The same for runs that are not steady [s], > 0, in which lines pass resonances and change.

    Notes
    -----
    The weight is that of James & Stein 1961 (Proc. 4th Berkeley Symp. 1, 361-379), cut off at four. The load's power
    is estimated from the bins 2 to 12 / block near the line in the residual. Limits: amplitudes that change within a
    block, load that is a line at that order.
    """

    lines: tuple[KinematicLine, ...]
    block: float = 30.0
    changing_block: float = 4.0

    def __post_init__(self) -> None:
        if not (self.block > 0 and self.changing_block > 0):
            shorter = min(self.block, self.changing_block)
            raise InputError(f"blocks of {shorter} s cannot be fitted; write for example 30 s")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` without the lines; RecordingError where there is no angle or the shaft does not turn."""
        if not self.lines:
            return recording
        angle = best_motor_angle(recording, self.lines)
        hops = hops_of(angle.values, ratio=self.lines[0].output_order / self.lines[0].motor_order)
        ends_sd = angle.ends_sd
        del angle  # frees an array as long as the recording
        if hops is None:
            raise RecordingError(
                f"{recording.name}: the shaft does not turn in this recording, so that no line can be fitted"
            )
        name = recording.torque_name()
        values = recording.channels[name].values
        lines = separable_lines(self.lines, hops.turned, name=recording.name)
        orders = resolved_orders([line.motor_order for line in lines], hops.fastest)
        if not isnan(ends_sd):  # where the uncertainty of the angle is known
            orders = orders[orders * ends_sd < 2 * pi * _PLACED]
        length = self.block if recording.run.profile == "steady" else self.changing_block
        blocks = blocks_of(hops, length=max(round(length * recording.sample_rate), 4))
        fitted = block_amplitudes(values, hops, orders, blocks)
        residual = without_lines(values, hops, orders, at_edges(fitted, hops, blocks))
        kept = fitted * (1 - weights(residual, fitted, hops, orders, blocks))
        put_in(residual, hops.turns, orders, hops.edges, at_edges(kept, hops, blocks), gain=1.0)
        return recording.with_values(name, residual)

    def reach(self, head: Recording) -> float:
        """Return half a block [s]: with this overlap the amplitudes are fitted to as many samples as elsewhere.

        The blocks start elsewhere, so that amplitudes differ by the standard deviation of the fit: 0.3 mN*m on twelve
        lines of 50 mN*m in 50 mN*m of noise, for an overlap of 5 s as of 45 s.
        """
        return 0.5 * self.block
