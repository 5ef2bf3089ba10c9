"""What is known of the scale and the zero of every measured place before a recording is seen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, sqrt

from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Part
from torquerig.rig.sensor_reading import mounting_sign
from torquerig.scenario.model import Scenario

RECTANGULAR = sqrt(3)
"""Half-width over standard deviation of a tolerance, within which every error is as likely (JCGM 100:2008, 4.3.7)."""


@dataclass(frozen=True, kw_only=True)
class SensorPrior:
    """Scale, zero and sense of one measured place: ``reading = sign scale x + zero``, x in the sense of the rig.

    Parameters
    ----------
    place : str
        As ``measured:`` names it.
    sign : float
        -1 where it is mounted the other way round.
    scale, scale_sd : float
        True over stated sensitivity [1] and its standard deviation; 0 where the scenario states no uncertainty.
    zero, zero_sd : float
        In the SI unit of its quantity; infinite where nothing is known of the zero, 0 where it was set.
    tare : bool
        The scenario says that the zero was set.
    states_something : bool
        Whether the scenario states anything of them.
    """

    place: str
    sign: float = 1.0
    scale: float = 1.0
    scale_sd: float = 0.0
    zero: float = 0.0
    zero_sd: float = inf
    tare: bool = False
    states_something: bool = False

    def sentence(self) -> str:
        """Return the prior in words."""
        sense = "" if self.sign > 0 else ", mounted the other way round"
        scale = f"scale {self.scale:.5g}" + (f" +- {self.scale_sd:.2g}" if self.scale_sd else "")
        zero = (
            "free" if self.zero_sd == inf else f"{self.zero:.4g}" + (f" +- {self.zero_sd:.2g}" if self.zero_sd else "")
        )
        return f"sensor {self.place}: {scale}, zero {zero}{' (tare)' if self.tare else ''}{sense}"


def sensor_priors(scenario: Scenario, recordings: Sequence[Recording] = ()) -> tuple[SensorPrior, ...]:
    """Return the prior of every measured place of a scenario, in the order of ``measured:``.

    A ``rel_sd`` of the scale goes before the data sheet's ``gain_tolerance``. A tolerance t is a standard deviation of
    t / sqrt(3). What is no sensor (a coupling, a probe) is taken to read exactly. A zero was set where the scenario
    says so, or the sidecars of all ``recordings`` do.
    """
    return tuple(
        _prior(scenario, scenario.rig.part(place), tared=_tared(place, recordings)) for place in scenario.rig.places
    )


def _tared(place: str, recordings: Sequence[Recording]) -> bool:
    read = [[one.tare for one in each.channels.values() if one.of == place] for each in recordings]
    return bool(read) and all(each and all(each) for each in read)


def _prior(scenario: Scenario, part: Part, *, tared: bool) -> SensorPrior:
    if not part.is_sensor:
        return SensorPrior(place=part.name, zero_sd=0.0)
    known = scenario.uncertainties.get(f"{part.name}.scale")
    scale, tolerance = getattr(part, "scale", 1.0), getattr(part, "gain_tolerance", 0.0)
    zero, within = getattr(part, "zero", 0.0), getattr(part, "zero_tolerance", None)
    tare = tared or bool(getattr(part, "tare", False))
    spread = known.rel_sd if known is not None else tolerance / RECTANGULAR
    sign = mounting_sign(part)
    return SensorPrior(
        place=part.name, sign=sign, scale=scale, scale_sd=scale * spread, zero=zero,
        zero_sd=0.0 if tare else inf if within is None else within / RECTANGULAR, tare=tare,
        states_something=bool(spread or tare or zero or within is not None or sign < 0 or scale != 1.0),
    )  # fmt: skip
