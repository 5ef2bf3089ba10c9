"""The induction machine at constant supply: torque over slip, and the speed under load."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt
from typing import Annotated

from torquerig.errors import InputError
from torquerig.machines.checks import check_fields
from torquerig.parameter import Parameter


@dataclass(frozen=True, kw_only=True)
class InductionMachine:
    """``T / Tb = 2 / (s/sb + sb/s)`` (Kloss), slip s = 1 - p w / w_supply, breakdown at slip sb.

    Exact for a stator without resistance; with it, a motor breaks down and starts with less than the curve says.
    A real start is higher than the curve where the rotor's bars are deep. Source: Kloss 1909; Boldea & Nasar, The
    Induction Machine Handbook, chapter 7.
    """

    pole_pairs: Annotated[int, Parameter("1", "pole pairs", low=1)]
    supply_frequency: Annotated[float, Parameter("Hz", "frequency of the supply", above=0)] = 50.0
    breakdown_torque: Annotated[float, Parameter("N*m", "breakdown torque", above=0)]
    breakdown_slip: Annotated[float, Parameter("1", "slip at breakdown", above=0, high=1)]

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def synchronous_speed(self) -> float:
        """Speed without load [rad/s]."""
        return 2 * pi * self.supply_frequency / self.pole_pairs

    def torque(self, slip: float) -> float:
        """Return the steady torque at ``slip`` [N*m]; negative slip generates, 1 is standstill."""
        if slip == 0:
            return 0.0
        return 2 * self.breakdown_torque / (slip / self.breakdown_slip + self.breakdown_slip / slip)

    def slip(self, load_torque: float) -> float:
        """Return the slip of steady running under ``load_torque`` [N*m], on the stable side of breakdown.

        Raises
        ------
        InputError
            When the load is above the breakdown torque: the machine stalls.
        """
        share = load_torque / self.breakdown_torque
        if abs(share) > 1:
            raise InputError(
                f"a load of {load_torque:g} N*m stalls the machine, its breakdown torque is {self.breakdown_torque:g} "
                "N*m; write a smaller load or take a gear"
            )
        return self.breakdown_slip * share / (1 + sqrt(1 - share * share))

    def speed(self, load_torque: float) -> float:
        """Return the shaft speed under ``load_torque`` [rad/s]; InputError where it stalls."""
        return self.synchronous_speed * (1 - self.slip(load_torque))


def induction_from_rating(
    *,
    rated_torque: float,
    rated_speed: float,
    breakdown_ratio: float,
    pole_pairs: int,
    supply_frequency: float = 50.0,
) -> InductionMachine:
    """Return the machine whose curve passes through the name plate [N*m, rad/s] and breaks down at a multiple of it.

    ``sb = sn (m + sqrt(m^2 - 1))`` with m the breakdown over the rated torque.

    Raises
    ------
    InputError
        When the rated speed is not below the synchronous one, or the breakdown torque is not above the rated one.
    """
    synchronous = 2 * pi * supply_frequency / pole_pairs
    rated_slip = 1 - rated_speed / synchronous
    if not 0 < rated_slip < 1:
        raise InputError(
            f"a rated speed of {rated_speed * 30 / pi:.4g} rpm does not fit {pole_pairs} pole pairs at "
            f"{supply_frequency:g} Hz; it lies below {synchronous * 30 / pi:.4g} rpm"
        )
    if not breakdown_ratio > 1:
        raise InputError(f"a breakdown torque of {breakdown_ratio:g} times the rated one is none; write more than 1")
    breakdown_slip = rated_slip * (breakdown_ratio + sqrt(breakdown_ratio**2 - 1))
    return InductionMachine(
        pole_pairs=pole_pairs,
        supply_frequency=supply_frequency,
        breakdown_torque=breakdown_ratio * rated_torque,
        breakdown_slip=breakdown_slip,
    )


def frame_71m_four_pole() -> InductionMachine:
    """Return a 71M of four poles on 50 Hz, as the class has it: 1350-1420 rpm, 1.8-2.6 N*m, breakdown 2.0-2.8 times.

    The middles of the intervals; the table of the very product was not read.
    """
    return induction_from_rating(rated_torque=2.2, rated_speed=1385 * pi / 30, breakdown_ratio=2.4, pole_pairs=2)
