"""Encoder error: an angle that is read wrong once or twice a turn makes the speed loop excite the motor."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi
from typing import Annotated, Literal

import numpy as np

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import DriveRipple, EncoderAngleError, HostChange
from torquerig.rig.parts import Motor
from torquerig.rig.terms import Term, Wave

Angle = Annotated[float, Parameter("rad", "amplitude of the angle error, mechanical", low=0)]
STEPS = 8192  # angles of a turn at which the remaining torque is evaluated
HIGHEST_ORDER = STEPS // 16
SMALLEST_DEPTH = 1e-7


@dataclass(frozen=True, kw_only=True)
class EncoderError(Part):
    """The reading is ``theta + e``, ``e = offset + sum_k a_k sin(k theta + phi_k)``, on the motor's shaft.

    Two effects. The speed loop sees the speed by differences of the reading, so that its answer to ``de/dt`` shakes the
    motor at order k: in proportion to speed and gain, absent without a speed loop. And the current vector stands wrong
    by p e, which leaves ``cos(p e)`` of the torque: orders 2k, k too where there is an offset, in proportion to the
    load. k is 1 where the magnet sits off the centre, 2 where it is oval, a resolver's pole number, an interpolator's
    lines. Phases that are not stated are 0. A motor_encoder on the motor counts the same error and states none itself.

    Source: signatures.md 2.5 (Hanselman 1990, IEEE Trans. Industrial Electronics 37). Not valid for the cosine where
    the current loop is slow against k turns.
    """

    kind: Literal["encoder_error"] = "encoder_error"
    group: Literal["electrical"] = "electrical"
    at: str = "motor"
    amplitudes: dict[int, Angle]
    phases: dict[int, float] = field(default_factory=dict)
    offset: Annotated[float, Parameter("rad", "error of the encoder's zero, mechanical")] = 0.0

    def __post_init__(self) -> None:
        for order in self.amplitudes:
            if not 1 <= order <= HIGHEST_ORDER:
                raise ValueError(f"{order} is no order of an encoder's error; write 1..{HIGHEST_ORDER}")

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return none, the drive senses the error; InputError where ``at`` is no motor."""
        self._motor(rig)
        return ()

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return the error of the reading and the ripple of the misplaced current vector."""
        return EncoderAngleError(self._error()), DriveRipple(self._ripple(self._motor(rig).pole_pairs))

    def _error(self) -> tuple[Wave, ...]:
        """Return the error waves [rad]; the constant offset moves no speed."""
        return tuple(
            Wave(order=float(order), amplitude=angle, phase=self.phases.get(order, 0.0) - pi / 2)
            for order, angle in self.amplitudes.items()
            if angle
        )

    def _ripple(self, pairs: int | None) -> tuple[Wave, ...]:
        """Return what the misplaced current vector leaves, relative to its mean; none where no pole pairs are known."""
        if not pairs or not any(self.amplitudes.values()):
            return ()
        theta = 2 * pi * np.arange(STEPS) / STEPS
        waves = [a * np.sin(k * theta + self.phases.get(k, 0.0)) for k, a in self.amplitudes.items()]
        lines = np.fft.rfft(np.cos(pairs * (self.offset + np.sum(waves, axis=0)))) / STEPS
        found = 2 * lines / lines[0].real
        return tuple(
            Wave(order=float(order), amplitude=float(abs(found[order])), phase=float(np.angle(found[order])))
            for order in range(1, 4 * HIGHEST_ORDER)
            if abs(found[order]) > SMALLEST_DEPTH
        )

    def _motor(self, rig: Rig) -> Motor:
        motor = rig.part(self.at)
        if not isinstance(motor, Motor):
            raise InputError(f"{self.name}: at: {self.at!r} is no motor; name one")
        return motor
