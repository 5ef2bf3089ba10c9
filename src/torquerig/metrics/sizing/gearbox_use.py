"""Use of the gearbox's limits: torque for life, peak, jam, input speed, with the maker's service factor."""

from __future__ import annotations

from collections.abc import Mapping

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.open_data import Values, over_intervals
from torquerig.metrics.sizing.output_torque import OutputTorque, output_torque
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.parameter import Estimate
from torquerig.rig.parts import Gear, Motor

FACTORS = "operating factors of IMS NEMA 23 planetary gearboxes, low shock: 3 h to 24 h a day"
ONE_WAY = Estimate(low=1.0, high=1.3, evidence="SC", source=FACTORS)
BOTH_WAYS = Estimate(low=1.3, high=1.6, evidence="SC", source=FACTORS)
ONE_WAY_STEPS = Estimate(low=1.2, high=1.5, evidence="SC", source=FACTORS.replace("low", "medium"))
BOTH_WAYS_STEPS = Estimate(low=1.6, high=1.9, evidence="SC", source=FACTORS.replace("low", "medium"))


def gearbox_use(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return shares of the gearbox's limits [1].

    ``gearbox_life_use``: cubic mean of the output torque times the service factor over T2N; ``gearbox_peak_use``:
    largest output torque of the cycle over T2a; ``gearbox_jam_use``: the drive's limit at the output over T2a;
    ``gearbox_speed_use``: top input speed over the largest; ``gearbox_no_load_use``: its no-load torque, which the
    required torque does not include, over the motor's rated torque. Empty where the rig has no gear of the catalog.

    The service factor depends on the hours of operation a day, on reversals of load or motion, and on steps of the
    set-point. Makers state different tables, hence an interval.
    """
    box = drive.gearbox
    if box is None:
        return {}
    life, peak = f"nominal torque (T2N) of {box.name}", f"peak torque (T2a) of {box.name}"
    speed, hours = f"largest input speed of {box.name}", "hours of running a day (service factor)"
    idle, rated = f"no load torque of {box.name}", f"rated torque of {drive.motor_name}"
    requirement, motor = drive.requirement(), drive.motor
    return {
        "gearbox_life_use": over_intervals(
            {**drive.data, life: box.nominal_torque, hours: service_factor(drive)},
            lambda v: behind_gear(drive, v).cubic_mean * v[hours] / v[life],
            source="cubic mean x service factor / T2N",
        ),
        "gearbox_peak_use": over_intervals(
            {**drive.data, peak: box.peak_torque}, lambda v: behind_gear(drive, v).peak / v[peak],
            source="largest output torque of the cycle / T2a",
        ),
        "gearbox_jam_use": over_intervals(
            {**drive.data, peak: box.peak_torque}, lambda v: drive.part.torque_limit * drive.gain(v) / v[peak],
            source="drive's limit x ratio x efficiency / T2a",
        ),
        "gearbox_speed_use": over_intervals(
            {speed: box.max_input_speed}, lambda v: requirement.top_speed / v[speed], source="top speed / largest"
        ),
        "gearbox_no_load_use": over_intervals(
            {idle: box.no_load_torque, rated: motor.rated_torque}, lambda v: v[idle] / v[rated],
            source="no-load torque at the input / rated torque; not in the required torque",
        ),
    }  # fmt: skip


def service_factor(drive: SizedDrive) -> Estimate:
    """Return the service factor of the life torque, from the reversals and steps of the cycle [1]."""
    behind, steps = behind_gear(drive, {}), bool(drive.requirement().step.any())
    if behind.alternates or behind.reverses:
        return BOTH_WAYS_STEPS if steps else BOTH_WAYS
    return ONE_WAY_STEPS if steps else ONE_WAY


def behind_gear(drive: SizedDrive, values: Values) -> OutputTorque:
    """Return the torque at the output shaft for one set of values."""
    rig = drive.with_values(values)
    motor = rig.part(drive.part.name)
    gears = tuple(part for gear in drive.gears if isinstance(part := rig.part(gear.name), Gear))
    assert isinstance(motor, Motor)
    return output_torque(drive.requirement(values), rig, motor=motor, gears=gears)
