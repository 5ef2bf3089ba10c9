"""The words of a column's name, and the quantity that they state."""

from __future__ import annotations

import re
from collections.abc import Mapping
from difflib import get_close_matches

from torquerig.recordings.quantities import OTHER, QUANTITIES

# words of names, English and German -> what is measured
_QUANTITY_OF = {
    **dict.fromkeys(("torque", "torq", "trq", "tq", "drehmoment", "moment", "md", "torsion"), "torque"),
    **dict.fromkeys(("force", "kraft", "load cell", "loadcell", "wägezelle"), "force"),
    **dict.fromkeys(("speed", "drehzahl", "rpm", "revs", "geschwindigkeit", "omega", "rotational speed"), "speed"),
    **dict.fromkeys(("angle", "winkel", "drehwinkel", "theta", "phi", "encoder", "resolver"), "angle"),
    **dict.fromkeys(("position", "weg", "displacement", "stroke", "hub", "travel", "auslenkung"), "position"),
    **dict.fromkeys(("velocity", "vel"), "velocity"),
    **dict.fromkeys(("current", "strom", "amperage"), "current"),
    **dict.fromkeys(("voltage", "spannung", "volt", "volts", "volt in"), "voltage"),
    **dict.fromkeys(("temperature", "temp", "temperatur"), "temperature"),
    **dict.fromkeys(("acceleration", "accel", "acc", "beschleunigung", "vibration", "schwingung"), "acceleration"),
    **dict.fromkeys(("pressure", "druck"), "pressure"),
    **dict.fromkeys(("power", "leistung"), "power"),
    **dict.fromkeys(("tacho", "tach", "tachometer", "hall pulse", "keyphasor", "index pulse"), "tacho"),
}
TIME_WORDS = (
    "time", "zeit", "timestamp", "zeitstempel", "uhrzeit", "messzeit", "elapsed", "clock", "temps", "tiempo", "tempo",
    "時間", "时间", "время",
)  # fmt: skip
"""Words of the name of a column of times."""
NOT_MEASURED = (
    "set", "setpoint", "setp", "sp", "sv", "soll", "sollwert", "target", "ziel", "goal", "command", "commanded",
    "cmd", "demand", "dem", "desired", "des", "request", "requested", "req", "vorgabe", "reference", "ref",
    "wanted", "preset", "programmed", "feedforward", "ff", "nominal", "nenn", "rated", "limit", "grenzwert",
    "threshold", "alarm", "tolerance", "capacity", "range", "scale", "available", "breakaway", "error", "deviation",
    "regelabweichung", "residual", "noise", "offset", "zero", "bias", "tare", "correction", "estimated", "estimate",
    "est", "model", "simulated", "sim", "expected", "theoretical", "derivative", "fft", "max", "maximum", "min",
    "minimum", "peak", "hold", "mean", "average", "avg", "mittelwert", "std", "rms",
    "quality", "status",
)  # fmt: skip
"""Words of a name by which a column is a set-point, a limit, a model or a figure, and not the measured signal."""
_COMPOUNDS = ("soll", "nenn", "grenz", "ziel", "vorgabe", "regelabweichung")  # German: Sollmoment, Nenndrehzahl
ELSEWHERE: Mapping[str, tuple[str, ...]] = {
    "torque": ("bending", "biege", "bend", "mx", "my", "work", "arbeit", "energy", "energie", "inertia"),
    "speed": (
        "fan", "lüfter", "luefter", "pump", "pumpe", "pumpen", "wind", "vehicle", "fahrzeug", "slip", "schlupf",
        "critical", "kritische", "cooling", "electrical", "elektrische",
    ),
    "angle": ("twist", "torsion", "verdreh", "verdrehung", "electrical", "elektrischer", "phase", "advance"),
}  # fmt: skip
"""Words by which a torque, speed or angle is not that of the shaft: another load, another machine, a twist."""


def not_measured(name: str) -> str | None:
    """Return the word by which the column is not the measured signal of the shaft, or None."""
    words = words_of(name)
    quantity = (quantity_by_words(name) or "").removeprefix("motor_")
    for word in words:
        if word in NOT_MEASURED or word.startswith(_COMPOUNDS):
            return word
        for kind, others in ELSEWHERE.items():
            if (quantity == kind or not quantity) and (word in others or word.startswith(("biege", "verdreh"))):
                return word
    return None


_OF_MOTOR = ("motor", "mot", "antrieb", "drive", "actuator", "servo", "rotor")
_MOTOR_FORM = {"torque": "motor_torque", "speed": "motor_speed", "angle": "motor_angle", "position": "motor_angle"}


def words_of(name: str) -> list[str]:
    """Return the words of a name in lower case: ``"MotorSpeed_2"`` gives ``["motor", "speed", "2"]``."""
    spaced = re.sub(r"(?<=[a-zäöüß])(?=[A-ZÄÖÜ])", " ", name)
    return re.findall(r"[^\W\d_]+|\d+", spaced.lower())


def quantity_by_words(name: str) -> str | None:
    """Return the quantity that the words of ``name`` state, or None.

    A quantity's own name counts first (``motor_torque``). Of several words the last one counts: ``load cell torque``
    is a torque. A word for the motor makes a torque, speed or angle the motor's.
    """
    words = words_of(name)
    plain = "_".join(words)
    for quantity in sorted((one for one in QUANTITIES if one not in (OTHER, "time")), key=len, reverse=True):
        if plain == quantity or plain.startswith(f"{quantity}_") or plain.endswith(f"_{quantity}"):
            return _of_its_shaft(quantity, words)
    found = None
    for size in (1, 2):
        for first in range(len(words) - size + 1):
            found = _QUANTITY_OF.get(" ".join(words[first : first + size]), found)
    if found is None:
        found = next((stem for word in words for stem in [_compound(word)] if stem), None)
    if found is None:
        return None
    return _of_its_shaft("motor_angle" if found == "angle" and words[0] == "encoder" else found, words)


def close_quantity(name: str) -> str | None:
    """Return the quantity that a word of ``name`` seems to misspell, or None: ``"torqe"`` is close to a torque."""
    for word in words_of(name):
        close = get_close_matches(word, [known for known in _QUANTITY_OF if len(known) > 4], n=1, cutoff=0.85)
        if close and len(word) > 4:
            return _QUANTITY_OF[close[0]]
    return None


def _compound(word: str) -> str | None:
    """Return the quantity of a German compound word, by its end: ``wellendrehmoment`` is a torque."""
    return next((quantity for known, quantity in _QUANTITY_OF.items() if len(known) > 5 and word.endswith(known)), None)


def _of_its_shaft(quantity: str, words: list[str]) -> str:
    is_motors = any(word in _OF_MOTOR or word.startswith("motor") for word in words)
    return _MOTOR_FORM.get(quantity, quantity) if is_motors else quantity
