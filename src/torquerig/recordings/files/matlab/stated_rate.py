"""The sample rate that numbers and texts state by their names: ``fs``, ``sampling_rate = '2 kHz'``, ``dt_ms``."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np

from torquerig.errors import RecordingError
from torquerig.recordings.names.channel_units import unit_meanings

_RATES = (
    "sample_rate", "samplerate", "fs", "sampling_rate", "samplingrate", "sampling_frequency", "sample_frequency",
    "samplefrequency", "samplingfrequency", "abtastrate",
)  # fmt: skip
# Tinterval is PicoScope's, Ts that of MATLAB's discrete systems
_STEPS = (
    "dt", "delta", "delta_t", "sample_interval", "sampling_interval", "wf_increment", "tinterval", "sample_time",
    "sampletime",
)  # fmt: skip
# cases matter: TS and ts are as often stamps of time
_STEPS_AS_WRITTEN = ("Ts",)
_PER_SECOND = {"s/s": 1.0, "sa/s": 1.0, "samples/s": 1.0, "1/s": 1.0, "ks/s": 1e3, "ksa/s": 1e3, "ms/s": 1e6}
_NUMBER = re.compile(r"\s*(?P<number>[0-9.]+(?:[eE][+-]?[0-9]+)?)\s*(?P<unit>\S*)\s*")
# largest relative difference of two statements of one rate [1]
_CONTRADICTION = 1e-3


def rate_of(values: Mapping[str, object], *, where: str) -> float:
    """Return the rate that the values state, as a rate or as a step of time [Hz]; 0 where they state none.

    The unit is at the end of the name (``fs_kHz``), in the text (``'2 kHz'``), or a value of its own (``dt_unit``);
    without one it is Hz or s.

    Parameters
    ----------
    values : mapping of str to object
        Numbers, texts and others by name.
    where : str
        File and group, for messages.

    Raises
    ------
    RecordingError
        Where two of them contradict each other, or a unit is not one of the quantity.
    """
    lowered = {name.lower(): value for name, value in values.items()}
    found = {}
    for name, value in values.items():
        kind, unit = _kind(name)
        number = _number(value)
        if kind and number is not None:
            beside = (lowered.get(f"{name.lower()}_{end}") for end in ("unit", "units"))
            unit = number[1] or unit or next((one for one in map(_text, beside) if one), "")
            found[name] = _hertz(number[0], unit, kind, f"{where}: {name}")
    stated = {name: rate for name, rate in found.items() if rate > 0}
    first = next(iter(stated), "")
    for name, rate in stated.items():
        if abs(rate / stated[first] - 1) > _CONTRADICTION:
            raise RecordingError(
                f"{where}: {first} states a rate of {stated[first]:.10g} Hz and {name} one of {rate:.10g} Hz; correct "
                "one of them"
            )
    return stated.get(first, 0.0)


def states_rate(name: str) -> bool:
    """Return whether a single number of this name is a rate or a step."""
    return bool(_kind(name)[0])


def _kind(name: str) -> tuple[str, str]:
    """Return ``frequency`` or ``time`` for the name of a rate or a step, with the unit at its end; else nothing."""
    base, _, end = name.rpartition("_")
    for plain, unit in ((name, ""), (base, end)):
        kind = "frequency" if plain.lower() in _RATES else "time" if _is_step(plain) else ""
        if kind and (not unit or _factor(unit, kind)):
            return kind, unit
    return "", ""


def _is_step(name: str) -> bool:
    return name.lower() in _STEPS or name in _STEPS_AS_WRITTEN


def _hertz(number: float, unit: str, kind: str, where: str) -> float:
    factor = _factor(unit, kind) if unit else 1.0
    if not factor:
        raise RecordingError(
            f"{where}: {unit!r} is no unit of {'a rate' if kind == 'frequency' else 'time'}; write "
            f"{'Hz or kHz' if kind == 'frequency' else 's, ms or us'}"
        )
    return number * factor if kind == "frequency" else 1 / (number * factor)


def _factor(unit: str, kind: str) -> float:
    found = next((one.factor for one in unit_meanings(unit) if one.kind == kind), 0.0)
    return found or (_PER_SECOND.get(unit.lower(), 0.0) if kind == "frequency" else 0.0)


def _number(value: object) -> tuple[float, str] | None:
    """Return a number above 0 and the unit that a text has behind it; None for other values."""
    text = _text(value)
    if text:
        match = _NUMBER.fullmatch(text)
        try:
            number, unit = (float(match["number"]), match["unit"]) if match else (0.0, "")
        except ValueError:
            return None
    else:
        array = np.asarray(value)
        number, unit = float(array.flat[0]) if array.size == 1 and array.dtype.kind in "fiu" else 0.0, ""
    return (number, unit) if np.isfinite(number) and number > 0 else None


def _text(value: object) -> str:
    """Return a text, also one that is the only element of an array; empty for other values."""
    array = np.asarray(value, dtype=object)
    one = array.flat[0] if array.size == 1 else None
    return (
        one.decode("utf-8", errors="replace") if isinstance(one, bytes) else one if isinstance(one, str) else ""
    ).strip()
