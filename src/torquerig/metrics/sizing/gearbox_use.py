"""Use of the gearbox's limits: torque for life, peak, jam, input speed, with the maker's service factor."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf, prod

from torquerig.catalog.gearbox import Gearbox
from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.chain_torque import torque_at_sensor, torque_of_motor, torque_of_stage
from torquerig.metrics.sizing.open_data import Values, over_intervals
from torquerig.metrics.sizing.output_torque import OutputTorque
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.parameter import Estimate
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Motor
from torquerig.scenario.kinematics import gears_to_sensor, stages_to, turns_to

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
    required torque does not include, at the motor over its rated torque. Of several gearboxes of the catalog in a
    chain, each figure is that of the gearbox that uses most of its limit, or whose limit is unknown. Empty where the
    chain has no gearbox of the catalog.

    The service factor depends on the hours of operation a day, on reversals of load or motion, and on steps of the
    set-point. Makers state different tables, hence an interval.
    """
    uses = [_use_of(drive, part, box) for part, box in drive.gearboxes.items()]
    return {name: max((use[name] for use in uses), key=_used) for name in (uses[0] if uses else ())}


def _used(figure: Figure) -> float:
    """Return the largest possible share; infinite where it is unknown."""
    ends = [end for end in (figure.high, figure.value) if end is not None]
    return max(ends, default=inf)


def _use_of(drive: SizedDrive, part: str, box: Gearbox) -> Mapping[str, Figure]:
    """Return the shares of one gearbox of the chain, the part called ``part``."""
    life, peak = f"nominal torque (T2N) of {box.name}", f"peak torque (T2a) of {box.name}"
    speed, hours = f"largest input speed of {box.name}", "hours of running a day (service factor)"
    idle, rated = f"no load torque of {box.name}", f"rated torque of {drive.motor_name}"
    requirement, motor = drive.requirement(), drive.motor
    before = turns_to(drive.rig, part) / abs(getattr(drive.rig.part(part), "ratio", 1.0))

    def jam(values: Values) -> float:
        stages = stages_to(drive.with_values(values), part)
        return drive.part.torque_limit * prod(abs(stage.turns) * stage.efficiency for stage in stages)

    return {
        "gearbox_life_use": over_intervals(
            {**drive.data, life: box.nominal_torque, hours: service_factor(drive, part)},
            lambda v: behind_stage(drive, v, part).cubic_mean * v[hours] / v[life],
            source="cubic mean x service factor / T2N",
        ),
        "gearbox_peak_use": over_intervals(
            {**drive.data, peak: box.peak_torque}, lambda v: behind_stage(drive, v, part).peak / v[peak],
            source="largest output torque of the cycle / T2a",
        ),
        "gearbox_jam_use": over_intervals(
            {**drive.data, peak: box.peak_torque}, lambda v: jam(v) / v[peak],
            source="drive's limit x ratio x efficiency / T2a",
        ),
        "gearbox_speed_use": over_intervals(
            {speed: box.max_input_speed}, lambda v: requirement.top_speed / before / v[speed],
            source="top speed / largest",
        ),
        "gearbox_no_load_use": over_intervals(
            {idle: box.no_load_torque, rated: motor.rated_torque}, lambda v: v[idle] / before / v[rated],
            source="no-load torque at the input / rated torque; not in the required torque",
        ),
    }  # fmt: skip


def service_factor(drive: SizedDrive, part: str) -> Estimate:
    """Return the service factor of the life torque, from the reversals and steps of the cycle [1]."""
    behind, steps = behind_stage(drive, {}, part), bool(drive.requirement().step.any())
    if behind.alternates or behind.reverses:
        return BOTH_WAYS_STEPS if steps else BOTH_WAYS
    return ONE_WAY_STEPS if steps else ONE_WAY


def behind_stage(drive: SizedDrive, values: Values, part: str) -> OutputTorque:
    """Return the torque at the output shaft of the stage ``part`` for one set of values."""
    rig = drive.with_values(values)
    return torque_of_stage(drive.requirement(values), rig, motor=_motor(drive, rig), stage=part)


def behind_chain(drive: SizedDrive, values: Values) -> OutputTorque:
    """Return the torque behind the last stage before the sensor, at the motor's shaft without one."""
    rig, stages = drive.with_values(values), gears_to_sensor(drive.rig)
    if stages:
        return behind_stage(drive, values, stages[-1].name)
    return torque_of_motor(drive.requirement(values), rig, motor=_motor(drive, rig))


def before_sensor(drive: SizedDrive, values: Values) -> OutputTorque:
    """Return the torque at the shaft before the sensor for one set of values."""
    rig = drive.with_values(values)
    return torque_at_sensor(drive.requirement(values), rig, motor=_motor(drive, rig))


def _motor(drive: SizedDrive, rig: Rig) -> Motor:
    motor = rig.part(drive.part.name)
    assert isinstance(motor, Motor)
    return motor
