"""The phase-level machine beside motulator's synchronous machine: torque of given currents, and a short circuit."""

from math import pi

import numpy as np
import pytest

from tests.motulator_peer import Machine
from torquerig.machines.demand import TorqueDemand
from torquerig.machines.drive_run import run_drive
from torquerig.machines.field_oriented import FieldOriented
from torquerig.machines.permanent_magnet import PHASE_LAG, PermanentMagnetMachine
from torquerig.machines.shaft import ImposedSpeed

PAIRS, R, L, FLUX, SPEED = 7, 0.2, 0.6e-3, 0.02, 60.0
MACHINE = PermanentMagnetMachine(pole_pairs=PAIRS, phase_resistance=R, phase_inductance=L, flux_linkage=FLUX)


def peer():
    return Machine(pole_pairs=PAIRS, resistance=R, inductance=L, flux=FLUX)


def in_rotor_frame(run):
    """Our currents as motulator's vector: its magnet's axis stands half an electrical turn before our angle."""
    phases = run.currents @ np.exp(1j * PHASE_LAG) * 2 / 3
    return phases * np.exp(-1j * (PAIRS * run.angle + pi))


def short_circuit():
    """Terminals held at no voltage by a DC link that has none, at an imposed speed."""
    dead = FieldOriented(dc_link=1e-12, period=20e-6, bandwidth=100.0)
    return run_drive(
        MACHINE, dead, shaft=ImposedSpeed(speed=SPEED), demand=TorqueDemand(torque=0.1), duration=0.03, substeps=4
    )


def test_torque_of_the_same_currents_is_the_same():
    run, other = short_circuit(), peer()
    for current, torque in zip(in_rotor_frame(run)[::100], run.torque[::100], strict=True):
        assert other.torque(L * current + FLUX) == pytest.approx(torque, abs=1e-12)


def test_a_short_circuit_runs_the_same_course():
    """Motulator's own equations by Runge-Kutta 4 at no voltage, from our second sample on: within 1e-8 of the peak."""
    run, other = short_circuit(), peer()
    ours = in_rotor_frame(run)
    flux = L * ours[1] + FLUX

    def slope(state):
        return other.slope_without_voltage(state, SPEED)

    for sample in range(1, ours.size - 1):
        for _ in range(4):
            h = run.period / 4
            first = slope(flux)
            second = slope(flux + 0.5 * h * first)
            third = slope(flux + 0.5 * h * second)
            flux += h / 6 * (first + 2 * second + 2 * third + slope(flux + h * third))
        assert abs((flux - FLUX) / L - ours[sample + 1]) < 1e-8 * np.abs(ours).max()
    assert np.abs(ours).max() > 10
    steady = -1j * PAIRS * SPEED * FLUX / (R + 1j * PAIRS * SPEED * L)
    assert abs(ours[-1] - steady) < 1e-3 * abs(steady)
