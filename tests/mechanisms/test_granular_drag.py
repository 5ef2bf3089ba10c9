"""Granular drag: rate-invariant, with the spectrum and the spread that it states."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.mechanisms import GranularDrag, LugreFriction
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body, Coupling, ImposedMotion
from torquerig.rig.terms import AngleLoad
from torquerig.simulation.simulator import simulate

BED = GranularDrag(name="bed", mean_by_occupancy_percent={0.0: 0.1, 20.0: 4.0}, rms=0.15, correlation_angle=0.08)


def rig(speed: float, *effects: GranularDrag | LugreFriction, occupancy: float = 10.0) -> Rig:
    return Rig(
        (
            Body(name="hub", inertia=1e-3),
            Coupling(name="sensor", after="hub", stiffness=1e5, damping=1.0),
            Body(name="wear_part", after="sensor", inertia=1e-3),
            ImposedMotion(name="turn", at="wear_part"),
            *effects,
        ),
        Run(speed=speed, occupancy_percent=occupancy, particle_size=0.5e-3),
        measured="sensor",
    )


def test_energy_per_turn_and_trace_do_not_depend_on_the_speed() -> None:
    """Miller, O'Hern & Behringer 1996: rate-invariant. 5 and 15 rad/s over the same four turns."""
    energies, traces = [], []
    for speed in (5.0, 15.0):
        made = simulate(rig(speed, BED), duration=8 * pi / speed, seed=2, settling=0.0, substeps=1)
        load, angle = (made.channels[f"true_{name}"].values for name in ("load_Nm", "motor_angle_rad"))
        energies.append(np.trapezoid(load, angle))
        traces.append(np.interp(np.linspace(0.1, 25.0, 2000), angle, load))
    assert energies[0] == pytest.approx(energies[1], rel=1e-4)
    assert traces[0] == pytest.approx(traces[1], abs=0.01)  # straight between points that lie 0.6 mrad apart
    assert energies[0] == pytest.approx(8 * pi * 2.05, rel=0.05)  # the mean at 10 %, of four turns


def test_spectrum_over_the_angle_falls_with_the_square_behind_its_corner() -> None:
    (term,) = BED.terms(rig(1.0))
    assert isinstance(term, AngleLoad)
    trace = term.process.sample(np.random.default_rng(0))
    assert trace.mean() == pytest.approx(2.05, rel=2e-3)
    assert trace.std() == pytest.approx(0.15 * 2.05, rel=0.05)
    power = np.abs(np.fft.rfft(trace - trace.mean())) ** 2
    k = 2 * pi * np.fft.rfftfreq(trace.size, 2 * pi / 2048)
    level = {at: power[(k > 0.8 * at) & (k < 1.25 * at)].mean() for at in (1.0, 12.5, 125.0, 500.0)}
    assert level[1.0] / level[12.5] == pytest.approx(2.0, rel=0.3)  # the corner 1/c
    assert level[125.0] / level[500.0] == pytest.approx(16.0, rel=0.1)


def test_larger_grains_make_longer_chains_and_unknown_occupancy_is_refused() -> None:
    coarse = Run(speed=1.0, occupancy_percent=10.0, particle_size=2e-3)
    (term,) = BED.terms(rig(1.0).at(coarse))
    assert isinstance(term, AngleLoad)
    assert getattr(term.process, "correlation_angle", None) == pytest.approx(4 * 0.08)
    with pytest.raises(InputError, match="bed: occupancy 30 % is outside"):
        BED.terms(rig(1.0, occupancy=30.0))


def test_lugre_at_steady_speed_is_the_stribeck_curve_of_its_direction() -> None:
    friction = LugreFriction(name="it", coulomb=0.2, static=0.5, stribeck_speed=1.0, stiffness=200.0, damping=0.1,
                             coulomb_backward=0.3, static_backward=0.3)  # fmt: skip
    for speed, torque in ((1.0, 0.2 + 0.3 * np.exp(-1.0)), (-1.0, -0.3)):
        made = simulate(rig(speed, friction), duration=0.01, seed=0, settling=0.5)
        assert made.channels["true_load_Nm"].values == pytest.approx(torque, rel=1e-6)
