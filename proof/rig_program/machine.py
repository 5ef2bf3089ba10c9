"""Parameters of the compiled loop, from a rig and its laws."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.laws import Laws
from proof.rig_program.true_rig import TrueRig
from proof.rig_program.waves import MOTOR_POINTS, OUTPUT_POINTS, sum_of

Floats = NDArray[np.float64]
MOTOR, GEAR, SENSOR, WEAR, BRANCH, FOURTH = range(6)
RING_AT_SENSOR = -1


class Machine(NamedTuple):
    """The rig in output coordinates: angles of the motor are divided by the ratio, its inertia times the ratio squared.

    Six masses: motor, gear output, sensor output side, wear part, and two branches that hang on the wear part (a branch
    without inertia is not there). Tables go over one turn of their shaft.
    """

    ratio: float
    inertia: Floats  # (6,) [kg m2]
    motor_viscous: float  # at the motor
    motor_coulomb: float
    motor_coulomb_width: float
    loss: float  # 1 / efficiency - 1
    gear_stiffness: float
    gear_damping: float
    half_gap: float  # [rad]
    contact: int
    contact_exponent: float
    contact_torque: float  # [Nm] at which the flank's stiffness is the gear's
    sensor_stiffness: float
    sensor_damping: float
    sensor_cubic: float  # [1/rad2]: stiffness times 1 + this * twist^2
    coupling_stiffness: float
    coupling_damping: float
    branch_stiffness: Floats  # (2,)
    branch_damping: Floats  # (2,)
    wear_viscous: float
    drag: float  # [Nms2]
    dry: Floats  # (6,) Tc, Ts, ws forwards, then backwards
    friction: int
    friction_width: float
    motor_table: Floats  # [Nm] at the motor, over its turn
    drive_table: Floats  # share of the motor's torque, over its turn
    wear_table: Floats  # [Nm] at the wear part, over the output's turn
    blade_table: Floats  # [Nm] of load, over the output's turn
    twist_table: Floats  # [rad] at the output
    twist_slope: Floats  # [rad/rad]
    amplifier: float  # [rad/s]
    amplifier_damping: float
    ring: float  # [rad/s] of a bearing's local mode; 0: none
    ring_damping: float
    ring_node: int
    impact_travel: Floats  # [rad] turned at the output until each impact
    impact_size: Floats  # [Nm]
    line_order: float  # of a line at the wear part whose order is not whole
    line_torque: float  # [Nm]
    kp: float
    ki: float
    limit: float
    lag: float  # [rad/s] of the current loop
    tustin: bool
    delay: int


def machine_of(rig: TrueRig, laws: Laws) -> Machine:
    """Return the machine of a rig with nothing left out; the wear part's table holds its lines at idle."""
    inertia = np.zeros(6)
    inertia[MOTOR] = rig["rotor_inertia"] * nominal.RATIO**2
    inertia[GEAR], inertia[SENSOR], inertia[WEAR] = rig["gear_inertia"], rig["sensor_inertia"], rig["wear_inertia"]
    branch_stiffness, branch_damping = np.zeros(2), np.zeros(2)
    if laws.fourth_mass is not None:
        share, frequency, damping = laws.fourth_mass
        inertia[FOURTH] = share * rig["wear_inertia"]
        branch_stiffness[1], branch_damping[1] = branch(inertia[FOURTH], frequency, damping)
    return Machine(
        ratio=nominal.RATIO,
        inertia=inertia,
        motor_viscous=rig["motor_viscous"],
        motor_coulomb=rig["motor_coulomb"],
        motor_coulomb_width=nominal.MOTOR_COULOMB_WIDTH,
        loss=1.0 / nominal.EFFICIENCY - 1.0,
        gear_stiffness=rig["gear_stiffness"],
        gear_damping=rig["gear_damping"],
        half_gap=0.0,
        contact=int(laws.contact),
        contact_exponent=laws.contact_exponent,
        contact_torque=1.0,
        sensor_stiffness=rig["sensor_stiffness"],
        sensor_damping=rig["sensor_damping"],
        sensor_cubic=0.0,
        coupling_stiffness=rig["coupling_stiffness"],
        coupling_damping=rig["coupling_damping"],
        branch_stiffness=branch_stiffness,
        branch_damping=branch_damping,
        wear_viscous=rig["wear_viscous"],
        drag=0.0,
        dry=np.array([0.0, 0.0, 1.0, 0.0, 0.0, 1.0]),
        friction=int(laws.friction),
        friction_width=laws.friction_width,
        motor_table=sum_of(rig.motor_lines, points=MOTOR_POINTS),
        drive_table=np.zeros(1),
        wear_table=sum_of(rig.wear_lines, points=OUTPUT_POINTS),
        blade_table=np.zeros(1),
        twist_table=np.zeros(1),
        twist_slope=np.zeros(1),
        amplifier=2.0 * np.pi * nominal.SENSOR_BANDWIDTH,
        amplifier_damping=float(np.sqrt(0.5)),
        ring=0.0,
        ring_damping=0.05,
        ring_node=RING_AT_SENSOR,
        impact_travel=np.zeros(0),
        impact_size=np.zeros(0),
        line_order=0.0,
        line_torque=0.0,
        kp=rig["kp"],
        ki=rig["ki"],
        limit=nominal.TORQUE_LIMIT,
        lag=2.0 * np.pi * nominal.CURRENT_LOOP,
        tustin=laws.tustin,
        delay=laws.delay,
    )


def branch(inertia: float, frequency: float, damping: float) -> tuple[float, float]:
    """Stiffness [Nm/rad] and damping [Nms/rad] of a branch with this frequency [Hz] while its root is clamped."""
    omega = 2.0 * np.pi * frequency
    return float(inertia * omega**2), float(2.0 * damping * inertia * omega)
