"""Friction of a motor from its no-load current: only the sum of dry and viscous friction at that speed is known."""

from __future__ import annotations

from torquerig.catalog.printed.converted import Converted
from torquerig.catalog.printed.emf import current_factors
from torquerig.catalog.printed.figure import Figure
from torquerig.catalog.printed.reading_of import readings, span


def current_range(figure: Figure, *, six_step: bool) -> tuple[float, float, str]:
    """Return the range of a printed current in amperes of the torque constant [A], and its readings in words."""
    found = readings(figure, figure.quantity("Arms" if _says_rms(figure) else "A"), current_factors(six_step=six_step))
    distinct = list({(one.low, one.high): one for one in found}.values())
    return *span(found), " or ".join(one.conversion for one in distinct)


def _says_rms(figure: Figure) -> bool:
    return figure.low.rstrip().endswith("Arms")


def friction(current: Figure, speed: Figure, *, constant: tuple[float, float], six_step: bool) -> list[Converted]:
    """Return no-load torque and speed, and dry and viscous friction from 0 to all of that torque.

    ``constant`` is the range of the torque constant [N m/A]. A Monte Carlo sample divides the no-load torque between
    the two, so that their sum at this speed is what was printed; iron losses are counted to them.
    """
    low, high, how = current_range(current, six_step=six_step)
    torque = (low * constant[0], high * constant[1])
    slow, fast = speed.quantity("rad/s")
    words = f"no-load current {current.text}, {how}, and the torque constant, at {speed.text}"
    share = f"{words}; the share of it is not known"
    return [
        Converted("no_load_torque", *torque, "N*m", words, "no_load_current"),
        Converted("no_load_speed", slow, fast, "rad/s", f"no-load speed {speed.text}", "no_load_speed"),
        Converted("coulomb_friction", 0.0, torque[1], "N*m", share, "no_load_current"),
        Converted("viscous_friction", 0.0, torque[1] / slow, "N*m*s/rad", share, "no_load_current"),
    ]
