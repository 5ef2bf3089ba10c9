"""Figures of a motor or gearbox that decide, computed from its values: what an open value costs is seen in them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import sqrt

from torquerig.catalog.entry import Entry
from torquerig.catalog.gearbox import Gearbox
from torquerig.catalog.lines import ripple_lines
from torquerig.catalog.motor import Motor
from torquerig.catalog.sampling import Sample

HOT = 1 + 0.0039 * 100  # [1] copper at 120 C over copper at 20 C
Values = Mapping[str, float]


@dataclass(frozen=True)
class DecisiveFigure:
    """One figure.

    Parameters
    ----------
    name, unit : str
        Name, and unit in which it is shown.
    decides : str
        The criterion or command that needs it.
    needs : tuple of str
        Dotted fields without which it cannot be computed.
    compute : callable
        From a sample of the entry [SI] to the figure [SI].
    """

    name: str
    unit: str
    decides: str
    needs: tuple[str, ...]
    compute: Callable[[Sample[Entry]], float]


def _of_values(function: Callable[[Values], float]) -> Callable[[Sample[Entry]], float]:
    return lambda sample: function(sample.values)


def _lines(sample: Sample[Entry]) -> float:
    """Return the rms of all torque lines of the motor at its rated torque [N m]."""
    assert isinstance(sample.entry, Motor)
    rated = sample.values["rated_torque"]
    motor = Sample(sample.entry, sample.values, sample.assumed)
    return sqrt(sum(0.5 * (line.torque + line.share * rated) ** 2 for line in ripple_lines(motor)))


def copper_loss(sample: Sample[Entry]) -> float:
    """Return the copper loss at rated torque, winding warm [W]: three phases of a sine, two of a six-step motor."""
    assert isinstance(sample.entry, Motor)
    values, phases = sample.values, 2 if sample.entry.kind == "bldc" else 3
    return phases * values["phase_resistance"] * HOT * (values["rated_torque"] / values["torque_constant"]) ** 2


def back_emf(sample: Sample[Entry]) -> float:
    """Return the line-to-line voltage at the largest speed [V], rms of a sine, peak of a six-step motor."""
    assert isinstance(sample.entry, Motor)
    per_ampere = 1.0 if sample.entry.kind == "bldc" else sqrt(3)
    return sample.values["torque_constant"] * sample.values["max_speed"] / per_ampere


MOTOR = (
    DecisiveFigure(
        "torque lines at rated torque, rms at the motor's shaft", "N*m",
        "criteria disturbance, line margin and reading error (compare)", ("rated_torque", "ripple"), _lines,
    ),
    DecisiveFigure(
        "friction at rated speed", "N*m", "rms torque and efficiency (size, duty)",
        ("coulomb_friction", "viscous_friction"),
        _of_values(lambda v: v["coulomb_friction"] + v["viscous_friction"] * v["rated_speed"]),
    ),
    DecisiveFigure(
        "peak torque over rotor inertia", "rad/s^2", "acceleration, ratio and modes (size, modes)",
        ("peak_torque", "rotor_inertia"), _of_values(lambda v: v["peak_torque"] / v["rotor_inertia"]),
    ),
    DecisiveFigure(
        "current at rated torque", "A", "currents and drive (size)", ("torque_constant",),
        _of_values(lambda v: v["rated_torque"] / v["torque_constant"]),
    ),
    DecisiveFigure(
        "copper loss at rated torque", "W", "temperature (duty)", ("torque_constant", "phase_resistance"), copper_loss
    ),
    DecisiveFigure(
        "winding over ambient at rated torque", "K", "temperature (duty)",
        ("torque_constant", "phase_resistance", "thermal_resistance"),
        lambda sample: copper_loss(sample) * sample.values["thermal_resistance"],
    ),
    DecisiveFigure("time constant of the winding", "min", "temperature (duty)", ("thermal_time_constant",),
                   _of_values(lambda v: v["thermal_time_constant"])),
    DecisiveFigure("voltage at largest speed", "V", "supply (size)", ("torque_constant",), back_emf),
    DecisiveFigure("lag of the torque loop", "Hz", "reading error, loop and modes (simulate)",
                   ("current_loop_bandwidth",), _of_values(lambda v: v["current_loop_bandwidth"])),
    DecisiveFigure("price with drive", "EUR", "criterion price (compare)", ("price", "drive_price"),
                   _of_values(lambda v: v["price"] + v["drive_price"])),
)  # fmt: skip
GEARBOX = (
    DecisiveFigure("angle of the gap", "arcmin", "contact loss and shocks (simulate)", ("backlash",),
                   _of_values(lambda v: v["backlash"])),
    DecisiveFigure("stiffness at the output", "N*m/arcmin", "modes and reading error (modes, compare)", ("stiffness",),
                   _of_values(lambda v: v["stiffness"])),
    DecisiveFigure("torque of the transmission error, rms at a locked output", "N*m",
                   "criterion disturbance (compare)", ("transmission_error", "stiffness"),
                   _of_values(lambda v: v["transmission_error"] / 2 / sqrt(2) * v["stiffness"])),
    DecisiveFigure("losses at nominal torque", "N*m", "rms torque and efficiency (size, duty)",
                   ("nominal_torque", "efficiency"), _of_values(lambda v: v["nominal_torque"] * (1 - v["efficiency"]))),
    DecisiveFigure("inertia at the input", "kg*cm^2", "acceleration and ratio (size)", ("input_inertia",),
                   _of_values(lambda v: v["input_inertia"])),
    DecisiveFigure("continuous torque", "N*m", "requirement of the rating (size)", ("nominal_torque",),
                   _of_values(lambda v: v["nominal_torque"])),
    DecisiveFigure("price", "EUR", "criterion price (compare)", ("price",), _of_values(lambda v: v["price"])),
)  # fmt: skip


def figures_of(entry: Entry) -> tuple[DecisiveFigure, ...]:
    """Return the figures that decide about an entry; empty for a kind that has none."""
    if isinstance(entry, Motor):
        return MOTOR if entry.kind != "induction" else tuple(one for one in MOTOR if "torque_constant" not in one.needs)
    return GEARBOX if isinstance(entry, Gearbox) else ()


def with_value(sample: Sample[Entry], field: str, value: float) -> Sample[Entry]:
    """Return the sample with one value exchanged [SI]."""
    return replace(sample, values={**sample.values, field: value})
