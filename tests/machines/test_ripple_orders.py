"""What the torque-level model takes from the phase-level one, and that the two say the same."""

from math import pi

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.machines.back_emf import HarmonicEmf, TrapezoidalEmf
from torquerig.machines.demand import TorqueDemand
from torquerig.machines.drive_run import run_drive
from torquerig.machines.field_oriented import FieldOriented
from torquerig.machines.permanent_magnet import PermanentMagnetMachine
from torquerig.machines.ripple_orders import ripple_orders
from torquerig.machines.shaft import ImposedSpeed
from torquerig.machines.six_step import SixStep
from torquerig.mechanisms import CommutationRipple
from torquerig.rig.assembly import Rig
from torquerig.rig.host_changes import DriveRipple, waves_of


def machine(back_emf):
    return PermanentMagnetMachine(
        pole_pairs=4, phase_resistance=0.5, phase_inductance=8e-3, flux_linkage=0.05, back_emf=back_emf
    )


@pytest.mark.parametrize(
    ("back_emf", "control", "within"),
    [
        (HarmonicEmf({1: 1.0, 5: 0.05, 7: 0.02, 11: 0.01}), FieldOriented(dc_link=100.0), 1e-4),
        (TrapezoidalEmf(), SixStep(dc_link=45.0), 0.1),  # orders above 36 p are left out at the corners
    ],
)
def test_commutation_ripple_of_the_lines_is_the_phase_level_torque(back_emf, control, within):
    made = machine(back_emf)
    found = ripple_orders(made, control, speed=90.0, torque=1.0)
    run = run_drive(
        made,
        control,
        shaft=ImposedSpeed(speed=found.speed),
        demand=TorqueDemand(torque=1.0),
        duration=0.8,
        substeps=4,
    )
    waves = [
        wave
        for line in found.lines
        for wave in waves_of(
            CommutationRipple(
                name=f"order {line.order_motor}", order_motor=line.order_motor, depth=line.depth, phase=line.phase
            ).changes_in_host(Rig(())),
            DriveRipple,
        )
    ]
    angle = run.angle[-1000:]
    factor = 1 + sum(wave.amplitude * np.cos(wave.order * angle + wave.phase) for wave in waves)
    missed = run.torque[-1000:] / found.mean_torque - factor
    assert np.sqrt(np.mean(missed**2)) < within * max(line.depth for line in found.lines)


def test_result_is_computed_once():
    made = machine(HarmonicEmf({1: 1.0, 5: 0.05}))
    first = ripple_orders(made, FieldOriented(dc_link=100.0), speed=50.0, torque=1.0)
    again = machine(HarmonicEmf({5: 0.05, 1: 1.0}))
    assert ripple_orders(again, FieldOriented(dc_link=100.0), speed=50.0, torque=1.0) is first


def test_speed_is_moved_by_less_than_the_stretch_shows():
    found = ripple_orders(machine(HarmonicEmf()), FieldOriented(dc_link=100.0), speed=90.0, torque=1.0)
    assert found.speed == pytest.approx(90.0, rel=5e-4)


def test_depth_halves_at_twice_the_torque_where_the_cause_is_the_voltage():
    """Dead time: the same newton-metres whatever the load, hence half the share."""
    control = FieldOriented(dc_link=100.0, dead_time=1e-6)
    light, heavy = (ripple_orders(machine(HarmonicEmf()), control, speed=30.0, torque=torque) for torque in (3.0, 6.0))
    assert heavy.depth(24) == pytest.approx(0.5 * light.depth(24), rel=0.03)


def test_too_few_samples_or_no_speed_is_refused():
    with pytest.raises(InputError, match="shorten the period to"):
        ripple_orders(machine(HarmonicEmf()), FieldOriented(dc_link=100.0), speed=2000 * pi, torque=1.0)
    with pytest.raises(InputError, match="write both non-zero"):
        ripple_orders(machine(HarmonicEmf()), FieldOriented(dc_link=100.0), speed=0.0, torque=1.0)
