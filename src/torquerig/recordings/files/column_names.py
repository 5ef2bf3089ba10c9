"""Quantity and unit from a column's name, where there is no sidecar: ``torque_V``, ``speed_rpm``, ``angle_rad``."""

from __future__ import annotations

from difflib import get_close_matches

from torquerig.errors import RecordingError
from torquerig.recordings.files.scale import known_si_per_unit, scale_key
from torquerig.recordings.files.sidecar import ChannelEntry
from torquerig.recordings.recording import QUANTITIES

_STEMS = {**{quantity: quantity for quantity in QUANTITIES}, "encoder": "motor_angle"}
_UNIT_SYMBOLS = {"volt": "V", "volts": "V", "amp": "A", "amps": "A", "amperes": "A", "newton": "N", "celsius": "degC"}


def entry_by_name(name: str, *, unit: str | None, where: str) -> ChannelEntry:
    """Return quantity, unit and scale of a column called ``<quantity>_<unit>``, or of one whose file states the unit.

    A ``torque_V`` is read as 1 V = 1 N m.

    Parameters
    ----------
    name : str
        Name of the column; ``/`` in a unit is written ``_`` (``speed_rad_s``).
    unit : str or None
        The unit that the file states (TDMS, LVM), for a column whose name is only a quantity.
    where : str
        The file, for the message.

    Raises
    ------
    RecordingError
        When the name does not determine quantity and unit, or the unit needs a scale.

    Source: the scale of the bare volts is from the reference report, Appendix A, line 2. Another sensor needs a
    sidecar.
    """
    quantity, found = _split(name, unit)
    if quantity is None or found is None:
        raise RecordingError(
            f"{where}: the quantity of the column {name!r} is not known{_hint(name)}; name it for example torque_V, "
            f"torque_Nm, speed_rpm or angle_rad, or describe it in a sidecar: {_example(name, 'torque', unit or 'V')}"
        )
    si_per_unit = 1.0 if (quantity, found) == ("torque", "V") else known_si_per_unit(quantity, found)
    if si_per_unit is None:
        raise RecordingError(
            f"{where}: the column {name!r} is a {quantity} in {found}, whose scale to SI is not known; "
            f"describe it in a sidecar: {_example(name, quantity, found)}"
        )
    return ChannelEntry(quantity=quantity, unit=found, si_per_unit=si_per_unit)


def _split(name: str, unit: str | None) -> tuple[str | None, str | None]:
    for stem in sorted(_STEMS, key=len, reverse=True):
        if name.lower() == stem:
            stated = unit.strip() if unit else None
            return _STEMS[stem], _UNIT_SYMBOLS.get(stated.lower(), stated) if stated else None
        if name.lower().startswith(f"{stem}_"):
            written = name[len(stem) + 1 :]
            sliced = written.replace("_", "/")
            return _STEMS[stem], sliced if known_si_per_unit(_STEMS[stem], sliced) is not None else written
    return None, None


def _hint(name: str) -> str:
    close = get_close_matches(name.lower().rpartition("_")[0], _STEMS, n=1, cutoff=0.7)
    return f" (did you mean {close[0]}_{name.rpartition('_')[2]}?)" if close else ""


def _example(name: str, quantity: str, unit: str) -> str:
    number = "NUMBER" if unit != "V" else "1.0"
    return f"channels: {{{name}: {{quantity: {quantity}, unit: {unit}, {scale_key(quantity, unit)}: {number}}}}}"
