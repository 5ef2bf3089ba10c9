"""What a column is, from its header and the unit of its file."""

from __future__ import annotations

import pytest

from torquerig.recordings.names.interpretation import interpret
from torquerig.recordings.names.time_column import time_column


@pytest.mark.parametrize(
    ("cell", "stated", "name", "quantity", "unit"),
    [
        ("Torque [Nm]", None, "Torque", "torque", "Nm"),
        ("Torque (Nm)", None, "Torque", "torque", "Nm"),
        ("Torque/Nm", None, "Torque", "torque", "Nm"),
        ("Torque, Nm", None, "Torque", "torque", "Nm"),
        ("Drehmoment in Nm", None, "Drehmoment", "torque", "Nm"),
        ("Wellendrehmoment [N·m]", None, "Wellendrehmoment", "torque", "N*m"),
        ("torque_Nm", None, "torque_Nm", "torque", "Nm"),
        ("torque_mNm", None, "torque_mNm", "torque", "mNm"),
        ("torque", "NM", "torque", "torque", "N*m"),
        ("torque sensor 1", "N-m", "torque sensor 1", "torque", "N*m"),
        ("Motor Torque [Nm]", None, "Motor Torque", "motor_torque", "Nm"),
        ("MD", "Nm", "MD", "torque", "Nm"),
        ("Sample", "FTLB", "Sample", "torque", "lbf*ft"),
        ("Load [Nm]", None, "Load", "torque", "Nm"),
        ("Load [N]", None, "Load", "force", "N"),
        ("n", "1/min", "n", "speed", "1/min"),
        ("Drehzahl U/min", None, "Drehzahl", "speed", "rev/min"),
        ("Motor speed (RPM)", None, "Motor speed", "motor_speed", "rpm"),
        ("MotorSpeed", "rpm", "MotorSpeed", "motor_speed", "rpm"),
        ("RPM", None, "RPM", "speed", "rpm"),
        ("speed_rad_s", None, "speed_rad_s", "speed", "rad/s"),
        ("Winkel [°]", None, "Winkel", "angle", "deg"),
        ("motor_angle", "rev", "motor_angle", "motor_angle", "rev"),
        ("Position (mm)", None, "Position", "position", "mm"),
        ("acc_x", "g", "acc_x", "acceleration", "g0"),
        ("p", "bar", "p", "pressure", "bar"),
        ("P [kW]", None, "P", "power", "kW"),
        ("T [°C]", None, "T", "temperature", "degC"),
        ("I_motor [A]", None, "I_motor", "current", "A"),
        ("tacho", None, "tacho", "tacho", "1"),
        ("torque_V", None, "torque_V", "torque", "V"),
        ("[Nm] Torque", None, "Torque", "torque", "Nm"),
        ("Torque [Nm] (filtered 1 kHz)", None, "Torque (filtered 1 kHz)", "torque", "Nm"),
        ("Torque [µNm]", None, "Torque", "torque", "uN*m"),
        ("Torque [N・m]", None, "Torque", "torque", "N*m"),
        ("Torque [kpcm]", None, "Torque", "torque", "kgf*cm"),
        ("Drehzahl [tr/mn]", None, "Drehzahl", "speed", "rev/min"),
        ("Speed [r.p.m.]", None, "Speed", "speed", "rpm"),
        ("Istdrehzahl [1/min]", None, "Istdrehzahl", "speed", "1/min"),
    ],
)
def test_name_and_unit_are_read(cell: str, stated: str | None, name: str, quantity: str, unit: str) -> None:
    found = interpret(cell, stated)
    assert (found.name, found.quantity, found.unit, found.missing) == (name, quantity, unit, "")


@pytest.mark.parametrize(
    ("cell", "stated", "quantity", "unit", "missing"),
    [
        ("Torque [V]", None, "voltage", "V", "the scale, if it is the torque"),
        ("torqe_V", None, "voltage", "V", "the scale, if it is the torque"),
        ("Torque", None, "other", "", "quantity: torque, with its unit"),
        ("Torque (filtered)", None, "other", "", "with its unit"),
        ("Torque", "mV/V", "other", "mV/V", "its quantity"),
        ("Torque setpoint [Nm]", None, "other", "Nm", "if it is the measured signal"),
        ("Drehmoment Soll [Nm]", None, "other", "Nm", "if it is the measured signal"),
        ("encoder_count", None, "other", "count", "counts_per_rev"),
        ("Voltage_0", None, "voltage", "V", "what the voltage measures"),
        ("Dev1/ai0", None, "voltage", "V", "what the voltage measures"),
        ("cDAQ1Mod1/ai3", "", "voltage", "V", "what the voltage measures"),
        ("weight [kg]", None, "other", "kg", "its quantity"),
        ("Temperature [°F]", None, "other", "degF", "its quantity"),
        ("state", None, "other", "", "its quantity and unit"),
        ("Speed", "Hz", "other", "Hz", "its quantity"),
        ("Channel A", None, "other", "", "its quantity and unit"),
        ("Sollmoment [Nm]", None, "other", "Nm", "if it is the measured signal"),
        ("Torque_SP", "Nm", "other", "Nm", "if it is the measured signal"),
        ("Torque request [Nm]", None, "other", "Nm", "if it is the measured signal"),
        ("Nenndrehzahl [1/min]", None, "other", "1/min", "if it is the measured signal"),
        ("Bending moment [Nm]", None, "other", "Nm", "if it is the measured signal"),
        ("Biegemoment [Nm]", None, "other", "Nm", "if it is the measured signal"),
        ("Energie [Nm]", None, "other", "Nm", "if it is the measured signal"),
        ("Fan speed [rpm]", None, "other", "rpm", "if it is the measured signal"),
        ("Twist angle [deg]", None, "other", "deg", "if it is the measured signal"),
        ("Electrical angle [deg]", None, "other", "deg", "if it is the measured signal"),
        ("Torque RMS [Nm]", None, "other", "Nm", "if it is the measured signal"),
        ("Torque*100 [Nm]", None, "other", "Nm", "its quantity and scale"),
        ("Speed x10 [rpm]", None, "other", "rpm", "its quantity and scale"),
        ("Phase A", None, "other", "", "its quantity and unit"),
        ("Motor m", None, "other", "", "its quantity and unit"),
        ("phase_A", None, "other", "", "its quantity and unit"),
    ],
)
def test_nothing_is_guessed(cell: str, stated: str | None, quantity: str, unit: str, missing: str) -> None:
    found = interpret(cell, stated)
    assert (found.quantity, found.unit) == (quantity, unit)
    assert missing in found.missing


@pytest.mark.parametrize(
    ("names", "time", "seconds"),
    [
        (["Torque", "Time"], "Time", 1.0),
        (["Zeit [ms]", "x"], "Zeit [ms]", 1e-3),
        (["Abs. Zeit [min]"], "Abs. Zeit [min]", 60.0),
        (["Time/ms"], "Time/ms", 1e-3),
        (["time", "time_s"], "time_s", 1.0),
        (["Time_s"], "Time_s", 1.0),
        (["TIME(MS)"], "TIME(MS)", 1e-3),
        (["millis", "x"], "millis", 1e-3),
        (["ms", "x"], "ms", 1e-3),
        (["時間[s]"], "時間[s]", 1.0),
        (["Zeit_h"], "Zeit_h", 3600.0),
    ],
)
def test_the_column_of_times_is_found(names: list[str], time: str, seconds: float) -> None:
    found = time_column(names)
    assert found is not None
    assert (found.name, found.seconds) == (time, seconds)
    assert found.stated is (time not in ("Time",))


@pytest.mark.parametrize("name", ["t [degC]", "torque time constant [s]", "cycle time [s]", "Torque [Nm]"])
def test_other_columns_are_no_times(name: str) -> None:
    assert time_column([name]) is None
