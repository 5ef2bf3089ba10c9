"""Cogging and torque ripple as shares of the torque, zero to peak, from what is printed."""

from __future__ import annotations

from torquerig.catalog.printed.converted import Converted
from torquerig.catalog.printed.figure import Figure
from torquerig.catalog.printed.reading_of import factor, readings, span
from torquerig.errors import UnitError
from torquerig.units import meanings

SWINGS = (factor("peak-to-peak", 0.5, "1/2"), factor("amplitude", 1.0, "1"))


def share_of_torque(key: str, figure: Figure, field: str, *, rated_torque: tuple[float, float] | None) -> Converted:
    """Return the share, zero to peak, of a printed cogging or ripple.

    Parameters
    ----------
    key, figure : str, Figure
        ``cogging`` or ``torque_ripple``, in per cent of rated torque or as a torque.
    field : str
        ``ripple.cogging_native``.
    rated_torque : tuple of float or None
        Range [N m], to which a printed torque is referred.

    Raises
    ------
    UnitError
        Where a torque is printed and the rated torque is not known, or the unit is another.
    """
    printed, reference = _as_share(figure, rated_torque)
    if "peak" in figure.words:
        raise UnitError(f"{figure.text!r}: peak-to-peak or amplitude? write 'peak-to-peak' or 'amplitude'")
    found = readings(figure, printed, SWINGS)
    how = " or ".join(one.conversion for one in found)
    said = f"{key.replace('_', ' ')} {figure.text}{reference}, {how}"
    if len(found) > 1:
        said += "; the sheet does not say which, so the interval covers both"
    return Converted(field, *span(found), "1", said, key)


def _as_share(figure: Figure, rated_torque: tuple[float, float] | None) -> tuple[tuple[float, float], str]:
    unit = figure.low.lstrip("+-.0123456789eE ").strip()
    if any(one.kind == "torque" for one in meanings(unit)):
        if rated_torque is None:
            raise UnitError(f"{figure.text!r} is referred to the rated torque, which is not stated; add rated_torque")
        low, high = figure.quantity("N*m")
        return (low / rated_torque[1], high / rated_torque[0]), " over the rated torque"
    return figure.quantity("1"), ""
