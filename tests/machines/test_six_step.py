"""The ripple of a brushless DC motor, which nobody puts in: commutation, Hall sensors, DC link."""

import numpy as np
import pytest

from torquerig.machines.back_emf import HarmonicEmf, TrapezoidalEmf
from torquerig.machines.demand import TorqueDemand
from torquerig.machines.drive_run import run_drive
from torquerig.machines.permanent_magnet import PermanentMagnetMachine
from torquerig.machines.ripple_orders import ripple_orders
from torquerig.machines.shaft import ImposedSpeed
from torquerig.machines.six_step import SixStep

EMF = 10.0  # V flat, of the commutation bench below


def machine(back_emf, inductance=0.3e-3):
    return PermanentMagnetMachine(
        pole_pairs=7, phase_resistance=0.2, phase_inductance=inductance, flux_linkage=0.01, back_emf=back_emf
    )


def commutation_extremes(link_over_emf):
    """Return lowest and highest torque over the median, of a flat EMF commutated with little resistance."""
    bench = PermanentMagnetMachine(
        pole_pairs=1, phase_resistance=0.005, phase_inductance=2e-3, flux_linkage=0.1, back_emf=TrapezoidalEmf(2.618)
    )
    run = run_drive(
        bench,
        SixStep(dc_link=link_over_emf * EMF, period=2e-6, bandwidth=20e3),
        shaft=ImposedSpeed(speed=EMF / 0.1),
        demand=TorqueDemand(torque=1.0),
        duration=0.5,
    )
    last_turn = run.torque[-31416:]
    return last_turn.min() / np.median(last_turn), last_turn.max() / np.median(last_turn)


@pytest.mark.long
def test_small_inductance_meets_the_closed_form_simulators_6_4():
    """On a sinusoidal EMF with currents that commutate in no time: 5.7143, 1.3986, 0.6192 % at 6, 12, 18."""
    found = ripple_orders(
        machine(HarmonicEmf(), 5e-6),
        SixStep(dc_link=4.0, period=2e-6, bandwidth=30e3),
        speed=10.0,
        torque=0.1,
        substeps=1,
    )
    for order, percent in ((6, 5.7143), (12, 1.3986), (18, 0.6192)):
        assert 100 * found.depth(7 * order) == pytest.approx(percent, abs=0.15)


def test_six_step_ripples_where_field_orientation_does_not():
    """BLDC against PMSM, out of the model: 6p and its multiples, 5 to 25 % in practice (Carlson et al. 1992)."""
    found = ripple_orders(machine(TrapezoidalEmf()), SixStep(dc_link=48.0), speed=1000 * np.pi / 30, torque=0.5)
    assert 0.05 < found.depth(42) < 0.25
    assert {line.order_motor % 42 for line in found.above(1e-3)} == {0}


@pytest.mark.long
@pytest.mark.parametrize("link_over_emf", [2.5, 3.0, 3.5])
def test_torque_dips_by_the_closed_form_above_the_speed_where_the_link_is_4e_carlson_1992(link_over_emf):
    """(4E - U) / (U + 2E): what the resting pair loses until the leaving phase is empty."""
    lowest, highest = commutation_extremes(link_over_emf)
    assert 1 - lowest == pytest.approx((4 - link_over_emf) / (link_over_emf + 2), abs=0.01)
    assert highest < 1.01


def test_no_net_dip_where_the_link_is_4e_carlson_1992():
    lowest, highest = commutation_extremes(4.0)
    assert lowest > 0.97  # what is left is the two periods of the loop's delay
    assert highest < 1.01


@pytest.mark.long
@pytest.mark.parametrize("link_over_emf", [6.0, 8.0])
def test_torque_spikes_below_the_speed_where_the_link_is_4e_carlson_1992(link_over_emf):
    """At most (U - 4E) / (3 (U - 2E)), where the link is fully applied until half the difference is back."""
    lowest, highest = commutation_extremes(link_over_emf)
    bound = (link_over_emf - 4) / (3 * (link_over_emf - 2))
    assert 0.6 * bound < highest - 1 < bound
    assert lowest > 0.95


def test_shifted_hall_sensors_give_2p_and_4p_signatures_1_5():
    """A shift moves both edges of a sensor, so that opposite half turns stay alike and odd orders stay away."""
    made = SixStep(dc_link=48.0, hall_shift=(0.1, -0.05, 0.0))
    found = ripple_orders(machine(HarmonicEmf()), made, speed=50.0, torque=0.5)
    assert min(found.depth(14), found.depth(28)) > 2e-3
    assert max(found.depth(7), found.depth(21)) < 0.1 * found.depth(14)


def test_unequal_hall_widths_give_p_2p_and_3p_signatures_1_5():
    made = SixStep(dc_link=48.0, hall_width=(0.1, 0.0, 0.0))
    found = ripple_orders(machine(HarmonicEmf()), made, speed=50.0, torque=0.5)
    right = ripple_orders(machine(HarmonicEmf()), SixStep(dc_link=48.0), speed=50.0, torque=0.5)
    for order in (7, 14, 21):
        assert found.depth(order) > 5e-4
        assert right.depth(order) < 0.3 * found.depth(order)  # what the sampling, not locked to the turn, makes


@pytest.mark.parametrize("back_emf", [HarmonicEmf(), TrapezoidalEmf()])
def test_reversed_motor_is_the_mirror_image(back_emf):
    forward = ripple_orders(machine(back_emf), SixStep(dc_link=48.0), speed=100.0, torque=0.5)
    backward = ripple_orders(machine(back_emf), SixStep(dc_link=48.0), speed=-100.0, torque=-0.5)
    assert backward.mean_torque == pytest.approx(-forward.mean_torque, rel=1e-9)
    assert backward.depth(42) == pytest.approx(forward.depth(42), rel=1e-6)


def test_resting_phase_carries_no_current_and_the_star_point_stays_free():
    run = run_drive(
        machine(TrapezoidalEmf()),
        SixStep(dc_link=48.0),
        shaft=ImposedSpeed(speed=20.0),
        demand=TorqueDemand(torque=0.5),
        duration=0.2,
    )
    assert np.abs(run.currents.sum(axis=1)).max() < 1e-12
    resting = np.min(np.abs(run.currents[2500:]), axis=1)
    assert np.mean(resting == 0.0) > 0.9


def test_halving_the_period_converges():
    depths = [
        ripple_orders(machine(TrapezoidalEmf()), SixStep(dc_link=48.0, period=period), speed=100.0, torque=0.5).depth(
            42
        )
        for period in (40e-6, 20e-6, 10e-6, 5e-6)
    ]
    assert abs(depths[3] - depths[2]) < abs(depths[2] - depths[1]) < abs(depths[1] - depths[0])
    assert depths[3] == pytest.approx(depths[2], rel=0.02)


def test_steps_inside_the_period_do_not_matter():
    """Hall edges and the end of a current are met exactly, so that the step is only Runge-Kutta's."""
    made = machine(HarmonicEmf()), SixStep(dc_link=48.0)
    coarse, fine = (ripple_orders(*made, speed=50.0, torque=0.5, substeps=count) for count in (1, 8))
    assert coarse.depth(42) == pytest.approx(fine.depth(42), rel=1e-4)


def test_hall_edges_that_change_places_are_refused():
    with pytest.raises(ValueError, match="write smaller ones"):
        SixStep(dc_link=48.0, hall_shift=(0.5, 0.0, -0.5), hall_width=(-0.2, 0.0, 0.0))
