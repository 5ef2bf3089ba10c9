"""A draft of a sidecar from the contents of a file: what is known is written, what is missing is a commented line."""

from __future__ import annotations

import re

import yaml

from torquerig.recordings.files.scale import known_si_per_unit, scale_key
from torquerig.recordings.inspection.file_contents import ColumnContents, FileContents
from torquerig.recordings.names.words import close_quantity, quantity_by_words
from torquerig.recordings.quantities import OTHER, QUANTITIES

_RUN = """\
# The conditions of the run; remove the # of "run:" and of what you know.
# run:
#   speed_rpm: NUMBER    # set-point of the motor; negative is the other direction
#   profile: steady      # steady, ramp or reversal
#   motor: NAME          # of the catalog
#   gear_ratio: NUMBER   # motor turns per output turn
#   tacho_pulses_per_motor_turn: NUMBER   # for a tacho; or pulses_per_rev: at its channel
"""


def draft_sidecar(contents: FileContents) -> str:
    """Return a sidecar as YAML text that opens as it is, with a comment for each thing that is not known.

    No scale and no rate is guessed: an encoder's counts, a sensor's sensitivity and a rate that the file does not state
    are lines to fill in. The lines with EDIT are those without which a torque or a rate is missing.
    """
    lines = [
        f"# Sidecar of {contents.path.name}, drafted by torquerig. A line with EDIT needs a value and its # removed;",
        "# it replaces the line above it where that has the same name.",
    ]
    lines.append("# quantities: " + ", ".join(quantity for quantity in QUANTITIES if quantity not in (OTHER, "time")))
    lines += [*_rate(contents), "channels:" if contents.columns else "# channels:"]
    lines += [line for one in contents.columns for line in _channel(one, contents)]
    lines += [f"# not read: {name}: {reason}" for name, reason in contents.skipped.items()]
    return "\n".join(lines) + "\n" + _RUN


def _rate(contents: FileContents) -> list[str]:
    rates = {one.rate for one in contents.columns}
    known = rates - {None}
    if not known:
        return ["# EDIT: sample_rate_Hz: NUMBER   # samples per second; the file states none"]
    if len(known) == 1 and len(rates) == 1:
        (rate,) = known
        return [f"# sample_rate_Hz: {rate:.10g}   # as the file states it"]
    listed = ", ".join(f"{one.name} {one.rate:g} Hz" if one.rate else f"{one.name} ?" for one in contents.columns)
    return [f"# the columns have several rates ({listed}); torquerig join brings them to one"]


def _channel(one: ColumnContents, contents: FileContents) -> list[str]:
    entry = {"quantity": one.quantity, "unit": one.unit}
    line = f"  {_scalar(one.name)}: {_flow(entry)}"
    torque_is_open = all(each.quantity not in ("torque", "force") for each in contents.columns)
    if not one.missing and torque_is_open and one.quantity == "voltage":
        sensor = f"{{quantity: torque, unit: {_scalar(one.unit)}, {scale_key('torque', one.unit)}: NUMBER}}"
        return [f"{line}   # {one.reason}", f"  # EDIT, if it is the torque: {_scalar(one.name)}: {sensor}"]
    if not one.missing:
        return [f"{line}   # {one.reason}"]
    return [f"{line}   # {one.reason}", f"  # {'EDIT' if torque_is_open else 'or'}: {_scalar(one.name)}: {_meant(one)}"]


def _meant(one: ColumnContents) -> str:
    """Return the entry that the column needs, with NUMBER and UNIT for what nobody but the owner knows."""
    meant = quantity_by_words(one.name) or close_quantity(one.name) or "QUANTITY"
    if meant in ("QUANTITY", one.quantity):
        unit = _scalar(one.unit) if one.unit else "UNIT"
        scale = ", Nm_per_V: NUMBER" if unit == "V" else ""
        return f"{{quantity: {'torque' if unit == 'V' else 'QUANTITY'}, unit: {unit}{scale}}}"
    if not one.unit:
        return f"{{quantity: {meant}, unit: UNIT}}"
    if known_si_per_unit(meant, one.unit) is None:
        return f"{{quantity: {meant}, unit: {_scalar(one.unit)}, {scale_key(meant, one.unit)}: NUMBER}}"
    return f"{{quantity: {meant}, unit: {_scalar(one.unit)}}}"


def _flow(entry: dict[str, str]) -> str:
    return "{" + ", ".join(f"{key}: {_scalar(value)}" for key, value in entry.items()) + "}"


def _scalar(text: str) -> str:
    """Return ``text`` as a YAML scalar inside a flow mapping."""
    if re.fullmatch(r"[^\W\d_][\w .*/^-]*(?<! )", text) and yaml.safe_load(text) == text:
        return text
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
