"""Small rigs and their simulated runs, with effects that their scenarios leave out."""

from __future__ import annotations

from collections.abc import Sequence
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

_MOTOR = """\
  motor: {kind: motor, inertia: {value: 0.002 kg*m^2, rel_sd: 0.1}, pole_pairs: 4, slots: 12,
          current_loop_bandwidth: 500 Hz, torque_limit: 20 N*m}
  phases: {kind: motor_phases, motor: motor, pole_pairs: 4, phase_resistance: 0.3 ohm, phase_inductance: 0.5 mH,
           flux_linkage: 0.02 V*s, dc_link: 48 V}
  controller: {kind: speed_controller, motor: motor, kp: 0.4 N*m*s/rad, ki: 1 N*m/rad}
"""
FREE = f"""\
scenario: direct bench without a load
operating_point: {{motor_speed: 1200 rpm}}
measured: sensor
rig:
{_MOTOR}\
  sensor: {{kind: torque_sensor, stiffness: {{value: 3000 N*m/rad, rel_sd: 0.05}}, damping: 0.5 N*m*s/rad,
           inertia: 0.0005 kg*m^2, sensitivity: 0.5 V/(N*m), bandwidth: 500 Hz, noise_rms: 0.002 V}}
  shaft: {{kind: coupling, stiffness: {{value: 2000 N*m/rad, rel_sd: 0.1}}, damping: 0.5 N*m*s/rad}}
  pump: {{kind: body, inertia: {{value: 0.01 kg*m^2, rel_sd: 0.1}}, viscous: {{value: 0.003 N*m*s/rad, rel_sd: 0.2}}}}
"""
PUMP = f"""\
{FREE}\
  load: {{kind: particle_load, at: pump, mean_by_occupancy_percent: {{0: 1 N*m, 100: 2 N*m}}, hit_rms: 0.02}}
"""
RIPPLED = f"""\
{PUMP}\
  motor_lines: {{kind: torque_ripple, at: motor, group: mechanical, amplitudes: {{24: 0.02 N*m}},
                amplitude_rel_sd: 0.25}}
"""
GEARED = f"""\
scenario: bench with belt and gearbox
operating_point: {{motor_speed: 1200 rpm}}
measured: sensor
rig:
{_MOTOR}\
  belt: {{kind: belt, pinion_teeth: 20, wheel_teeth: 34, belt_teeth: 90, pitch: 5 mm, wheel_inertia: 0.002 kg*m^2,
         belt_stiffness: 2e5 N, strand_damping: 20 N*s/m}}
  gearbox: {{kind: planetary_gear, teeth: {{sun: 24, ring: 72, planets: 4}}, stiffness: 8000 N*m/rad,
            damping: 4 N*m*s/rad, efficiency: 0.97, output_inertia: 0.01 kg*m^2}}
  sensor: {{kind: torque_sensor, stiffness: {{value: 6000 N*m/rad, rel_sd: 0.05}}, damping: 1.5 N*m*s/rad,
           inertia: 0.002 kg*m^2, sensitivity: 0.1 V/(N*m), bandwidth: 500 Hz, noise_rms: 0.002 V}}
  shaft: {{kind: coupling, stiffness: {{value: 4000 N*m/rad, rel_sd: 0.1}}, damping: 1.5 N*m*s/rad}}
  pump: {{kind: body, inertia: {{value: 0.1 kg*m^2, rel_sd: 0.1}}, viscous: {{value: 0.1 N*m*s/rad, rel_sd: 0.2}}}}
  load: {{kind: particle_load, at: pump, mean_by_occupancy_percent: {{0: 2 N*m, 100: 8 N*m}}, hit_rms: 0.02}}
"""
RATE, DURATION = 2000.0, 8.0  # [Hz], [s]


def bench(text: str, folder: Path) -> Scenario:
    """Return the scenario of a text."""
    path = folder / "scenario.yaml"
    path.write_text(text, encoding="utf-8")
    return read_scenario(edited(path, ()), catalog_for(path, ()), seed=0)


def recorded(
    scenario: Scenario, added: Sequence[Part] = (), *, runs: Sequence[tuple[float, float]] = ((800, 100), (1200, 0)),
    profile: str = "steady",
) -> list[Recording]:  # fmt: skip
    """Return runs at speeds [rpm] and occupancies [%], with parts that the scenario lacks."""
    rig, made = scenario.rig, list[Recording]()
    for part in added:
        rig = rig + part
    for index, (rpm, occupancy) in enumerate(runs):
        run = replace(rig.run, speed=rpm * np.pi / 30, occupancy_percent=occupancy, profile=profile)
        one = simulate(rig.at(run), duration=DURATION, seed=10 + index, sample_rate=RATE, wander=2e-4)
        made.append(replace(one, name=f"run{index + 1}.parquet", run=run).without_truth())
    return made
