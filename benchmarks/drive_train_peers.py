"""The same drive train and the same steps in torquerig and MuJoCo; the same drive in torquerig and motulator.

Each function returns the processor time of a run and the end speed, so that a reader sees that the job is the same.
Run: python benchmarks/costs.py
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from math import pi
from pathlib import Path

import numpy as np

RATE, STEPS = 25_000, 4  # samples per second [Hz]; Runge-Kutta steps per sample
INERTIAS = (1.5e-4, 7.0e-4, 2.0e-3)  # [kg m2] motor, middle, load
SPRINGS = ((450.0, 0.08), (940.0, 0.1))  # [N m/rad], [N m s/rad]
VISCOUS, TORQUE, BANDWIDTH = 0.01, 0.2, 500.0  # [N m s/rad] at the load, [N m] at the motor, [Hz] of its lag
MACHINE = {"pole_pairs": 3, "resistance": 3.6, "inductance": 0.036, "flux": 0.545}  # [ohm], [H], [V s]
MASSES = {"rotor": 0.005, "load": 0.005, "stiffness": 700.0, "damping": 0.5}  # [kg m2], [N m/rad], [N m s/rad]
SPEED, DC_LINK, PERIOD = 100.0, 540.0, 40e-6  # [rad/s], [V], [s]


@dataclass(frozen=True)
class Run:
    """Processor time [s], speed of the load at the end [rad/s], and what was simulated."""

    seconds: float
    end: float
    words: str


def torquerig_train(count: int, seconds: float, *, workers: int) -> Run:
    """Step so many equal rigs in the compiled batch, every sample recorded."""
    from torquerig.catalog.reading import Catalog
    from torquerig.document import parse_document
    from torquerig.scenario.reading import read_scenario
    from torquerig.simulation.batch import simulate_batch

    (k1, d1), (k2, d2) = SPRINGS
    motor, middle, load = INERTIAS
    text = f"""
measured: shaft
rig:
  motor: {{kind: motor, inertia: {motor!r} kg*m^2, torque_limit: 5 N*m, current_loop_bandwidth: {BANDWIDTH!r} Hz}}
  gap: {{kind: gear, ratio: 1, stiffness: {k1!r} N*m/rad, damping: {d1!r} N*m*s/rad, output_inertia: {middle!r} kg*m^2}}
  shaft: {{kind: coupling, stiffness: {k2!r} N*m/rad, damping: {d2!r} N*m*s/rad}}
  load: {{kind: body, inertia: {load!r} kg*m^2, viscous: {VISCOUS!r} N*m*s/rad}}
  push: {{kind: torque_controller, motor: motor, torque: {TORQUE!r} N*m}}
"""
    rig = read_scenario(parse_document(text, Path("peers.yaml")), Catalog(), seed=1).rig
    given = {"duration": seconds + 1 / RATE, "settling": 0.0, "substeps": STEPS, "sample_rate": float(RATE)}
    simulate_batch([rig] * 8, seeds=range(8), **given | {"duration": 0.01}, workers=1)
    start = time.process_time()
    made = simulate_batch([rig] * count, seeds=range(count), **given, workers=workers)
    spent = time.process_time() - start
    end = float(made[0].channels["true_output_speed_rad_s"].values[-1])
    return Run(spent, end, f"torquerig, compiled batch of {count}")


def mujoco_train(count: int, seconds: float, *, workers: int) -> Run:
    """Roll the same drive train out: hinges on one axis, springs as tendons, the lag as the actuator's filter."""
    import mujoco
    from mujoco import rollout

    bodies = "".join(
        f'<body pos="{at} 0 0"><joint name="j{at}" type="hinge" axis="1 0 0" damping="{VISCOUS if at == 2 else 0}"/>'
        f'<inertial pos="0 0 0" mass="1" diaginertia="{inertia} 1 1"/></body>'
        for at, inertia in enumerate(INERTIAS)
    )
    tendons = "".join(
        f'<fixed stiffness="{stiffness}" damping="{damping}" springlength="0">'
        f'<joint joint="j{at}" coef="1"/><joint joint="j{at + 1}" coef="-1"/></fixed>'
        for at, (stiffness, damping) in enumerate(SPRINGS)
    )
    lag = 1 / (2 * pi * BANDWIDTH)
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><compiler inertiafromgeom="false" balanceinertia="false" boundmass="0"/>'
        f'<option timestep="{1 / (RATE * STEPS)!r}" integrator="RK4" gravity="0 0 0">'
        '<flag contact="disable" constraint="disable"/></option>'
        f"<worldbody>{bodies}</worldbody><tendon>{tendons}</tendon>"
        f'<actuator><general joint="j0" dyntype="filter" dynprm="{lag!r}" gainprm="1"/></actuator></mujoco>'
    )
    data = [mujoco.MjData(model) for _ in range(workers)]
    size = mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS)
    initial, steps = np.zeros((count, size)), round(seconds * RATE) * STEPS
    start = time.process_time()
    # the rollout records every step; pieces of a sample second keep its memory like that of the recordings
    piece, done = RATE, 0
    while done < steps:
        now = min(piece, steps - done)
        states, _ = rollout.rollout(model, data, initial, control=np.full((count, 1, 1), TORQUE), nstep=now)
        initial, done = states[:, -1, :].copy(), done + now
    spent = time.process_time() - start
    speeds = initial[0, 1 + model.nq : 1 + model.nq + model.nv]
    return Run(spent, float(speeds[2]), f"MuJoCo {mujoco.__version__}, batched rollout of {count}")


def torquerig_drive(seconds: float) -> Run:
    """Run a permanent-magnet motor under field-oriented control on two masses."""
    from torquerig.machines.back_emf import HarmonicEmf
    from torquerig.machines.demand import SpeedDemand
    from torquerig.machines.drive_run import run_drive
    from torquerig.machines.field_oriented import FieldOriented
    from torquerig.machines.permanent_magnet import PermanentMagnetMachine
    from torquerig.machines.shaft import TwoMasses

    machine = PermanentMagnetMachine(
        pole_pairs=MACHINE["pole_pairs"], phase_resistance=MACHINE["resistance"],
        phase_inductance=MACHINE["inductance"], flux_linkage=MACHINE["flux"], back_emf=HarmonicEmf({1: 1.0}),
    )  # fmt: skip
    shaft = TwoMasses(
        rotor_inertia=MASSES["rotor"], load_inertia=MASSES["load"], stiffness=MASSES["stiffness"],
        damping=MASSES["damping"], load_torque=0.0,
    )  # fmt: skip
    demand = SpeedDemand(speed=SPEED, proportional=0.25, integral=1.0, torque_limit=10.0)
    control = FieldOriented(dc_link=DC_LINK, period=PERIOD)
    run_drive(machine, control, shaft=shaft, demand=demand, duration=0.01)
    start = time.process_time()
    made = run_drive(machine, control, shaft=shaft, demand=demand, duration=seconds)
    return Run(time.process_time() - start, float(made.load_speed[-1]), "torquerig, phase level, inverter switched")


def motulator_drive(seconds: float) -> Run:
    """Run the same motor under the same control in motulator, with an averaged inverter.

    Release 0.5 has both masses as one: under its control its two-mass system swings and does not settle.
    """
    from importlib.metadata import version

    from motulator.drive import model

    newer = hasattr(model, "SynchronousMachinePars")  # release 0.18; 0.5 is the last one for Python 3.11
    simulation, speed = (_motulator_0_18 if newer else _motulator_0_5)(model)
    start = time.process_time()
    simulation.simulate(t_stop=seconds)
    return Run(time.process_time() - start, speed(), f"motulator {version('motulator')}, averaged inverter")


def _motor() -> dict[str, float]:
    inductance = MACHINE["inductance"]
    return {
        "n_p": int(MACHINE["pole_pairs"]), "R_s": MACHINE["resistance"], "L_d": inductance, "L_q": inductance,
        "psi_f": MACHINE["flux"],
    }  # fmt: skip


def _masses() -> dict[str, float]:
    return {"J_M": MASSES["rotor"], "J_L": MASSES["load"], "K_S": MASSES["stiffness"], "C_S": MASSES["damping"]}


def _motulator_0_5(model):
    from motulator.drive import utils
    from motulator.drive.control import sm

    par = utils.SynchronousMachinePars(**_motor())
    mechanics = model.StiffMechanicalSystem(J=MASSES["rotor"] + MASSES["load"])
    system = model.Drive(model.VoltageSourceConverter(u_dc=DC_LINK), model.SynchronousMachine(par), mechanics)
    references = sm.CurrentReferenceCfg(par, nom_w_m=471.0, max_i_s=10.0)
    loop = sm.CurrentVectorControl(par, references, J=0.01, T_s=PERIOD, sensorless=False)
    loop.ref.w_m = lambda t: MACHINE["pole_pairs"] * SPEED
    return model.Simulation(system, loop), lambda: float(mechanics.data.w_M[-1])


def _motulator_0_18(model):
    from motulator.drive.control import sm

    par = model.SynchronousMachinePars(**_motor())
    mechanics = model.TwoMassMechanicalSystem(**_masses())
    system = model.Drive(model.SynchronousMachine(par), mechanics, model.VoltageSourceConverter(u_dc=DC_LINK))
    settings = sm.CurrentVectorControllerCfg(i_s_max=10.0, J=0.01, T_s=PERIOD, sensorless=False)
    loop = sm.VectorControlSystem(sm.CurrentVectorController(par, settings), sm.SpeedController(J=0.01, alpha_s=25.0))
    loop.set_speed_ref(lambda t: SPEED)
    return model.Simulation(system, loop, show_progress=False), lambda: float(mechanics.state.w_L)
