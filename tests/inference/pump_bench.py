"""A small rig, simulated: motor, torque sensor, pump."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import edited
from torquerig.recordings.recording import Recording
from torquerig.rig.assembly import Part
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

SCENARIO = """\
scenario: pump bench
operating_point: {motor_speed: 1200 rpm}
measured: sensor
rig:
  motor: {kind: motor, inertia: {value: 0.002 kg*m^2, rel_sd: 0.1}, pole_pairs: 4, slots: 12,
          current_loop_bandwidth: 500 Hz, torque_limit: 20 N*m}
  sensor: {kind: torque_sensor, stiffness: {value: 3000 N*m/rad, rel_sd: 0.05}, damping: 0.5 N*m*s/rad,
           inertia: 0.0005 kg*m^2, sensitivity: 0.5 V/(N*m), bandwidth: 500 Hz, noise_rms: 0.002 V}
  shaft: {kind: coupling, stiffness: {value: 2000 N*m/rad, rel_sd: 0.1}, damping: 0.5 N*m*s/rad}
  pump: {kind: body, inertia: {value: 0.01 kg*m^2, rel_sd: 0.1}, viscous: {value: 0.003 N*m*s/rad, rel_sd: 0.2}}
  controller: {kind: speed_controller, motor: motor, kp: 0.4 N*m*s/rad, ki: 1 N*m/rad}
  lines: {kind: torque_ripple, at: pump, group: mechanical, amplitudes: {1: 0.05 N*m}, amplitude_rel_sd: 0.2}
  load: {kind: particle_load, at: pump, mean_by_occupancy_percent: {0: 2 N*m, 100: 2 N*m}, hit_rms: 0.02}
"""


def pump_scenario(folder: Path, more: str = "", *, before_sensor: str = "") -> Scenario:
    """Return the scenario, written into a folder, with ``more`` lines of its rig; parts on the shaft follow each other.

    ``before_sensor`` are lines of parts between motor and sensor.
    """
    path = folder / "scenario.yaml"
    text = SCENARIO.replace("  sensor:", f"{before_sensor}  sensor:") + more
    path.write_text(text, encoding="utf-8")
    return read_scenario(edited(path, ()), catalog_for(path, ()), seed=0)


def simulated(scenario: Scenario, *added: Part, speeds: tuple[float, ...] = (800.0, 1200.0)) -> Iterator[Recording]:
    """Yield runs of 6 s at speeds of the motor [rpm], with some effects added."""
    rig = scenario.rig
    for part in added:
        rig = rig + part
    for index, rpm in enumerate(speeds):
        run = replace(rig.run, speed=rpm * np.pi / 30)
        made = simulate(rig.at(run), duration=6.0, seed=10 + index, sample_rate=2000.0, wander=1e-3)
        yield replace(made, name=f"run{index + 1}.parquet", run=run)


def recorded(scenario: Scenario, *added: Part, speeds: tuple[float, ...] = (800.0, 1200.0)) -> list[Recording]:
    """Return them as a user has them."""
    return [made.without_truth() for made in simulated(scenario, *added, speeds=speeds)]
