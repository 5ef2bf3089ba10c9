"""Closed forms of the machine itself: torque of given currents, shapes, and the conventions of data sheets."""

from math import pi, sqrt

import numpy as np
import pytest

from torquerig.machines.back_emf import HarmonicEmf, TrapezoidalEmf
from torquerig.machines.permanent_magnet import (
    PHASE_LAG,
    PermanentMagnetMachine,
    flux_from_torque_constant,
    flux_from_voltage_constant,
)
from torquerig.machines.six_step import ideal_six_step_currents

SAMPLES = 23040  # divisible by six, so that troughs at the edges and peaks between them are met


def machine(back_emf=None):
    return PermanentMagnetMachine(
        pole_pairs=7,
        phase_resistance=0.2,
        phase_inductance=0.3e-3,
        flux_linkage=0.01,
        back_emf=back_emf or HarmonicEmf(),
    )


def one_electrical_turn(made, currents_of):
    electrical = np.arange(SAMPLES) / SAMPLES * 2 * pi
    return made.torque(electrical / made.pole_pairs, currents_of(electrical))


def relative_orders(torque):
    spectrum = np.abs(np.fft.rfft(torque)) / len(torque)
    return 2 * spectrum / spectrum[0]


def test_six_step_on_sinusoidal_emf_simulators_6_4():
    made = machine()
    torque = one_electrical_turn(made, lambda angle: ideal_six_step_currents(angle, current=4.0))
    peak = sqrt(3) * made.pole_pairs * made.flux_linkage * 4.0
    assert torque.mean() / peak == pytest.approx(3 / pi, abs=1e-6)
    assert np.ptp(torque) / torque.mean() == pytest.approx(0.140298, abs=1e-5)
    for order, percent in ((6, 5.7143), (12, 1.3986), (18, 0.6192), (24, 0.3478)):
        assert relative_orders(torque)[order] == pytest.approx(percent / 100, abs=1e-6)
        assert relative_orders(torque)[order] == pytest.approx(2 / (order**2 - 1), rel=1e-4)


def test_ideal_trapezoid_with_ideal_six_step_is_constant_simulators_6_4():
    made = machine(TrapezoidalEmf(2 * pi / 3))
    torque = one_electrical_turn(made, lambda angle: ideal_six_step_currents(angle, current=4.0))
    np.testing.assert_allclose(torque, 2 * made.pole_pairs * made.flux_linkage * 4.0, rtol=1e-12)


@pytest.mark.parametrize(("fifth", "seventh"), [(0.04, 0.015), (0.02, 0.05), (-0.03, 0.02)])
def test_sinusoidal_current_on_harmonic_emf_simulators_6_4(fifth, seventh):
    made = machine(HarmonicEmf({1: 1.0, 5: fifth, 7: seventh}))
    torque = one_electrical_turn(made, lambda angle: np.sin(angle[:, None] - PHASE_LAG))
    assert relative_orders(torque)[6] == pytest.approx(abs(seventh - fifth), rel=1e-9)
    assert torque.mean() == pytest.approx(1.5 * made.pole_pairs * made.flux_linkage)


def test_third_harmonic_of_the_emf_makes_no_torque():
    plain, third = machine(), machine(HarmonicEmf({1: 1.0, 3: 0.2}))
    for currents in (
        lambda angle: np.sin(angle[:, None] - PHASE_LAG),
        lambda angle: ideal_six_step_currents(angle, current=1.0),
    ):
        np.testing.assert_allclose(
            one_electrical_turn(third, currents), one_electrical_turn(plain, currents), atol=1e-15
        )


def test_fundamental_of_a_trapezoid_is_its_fourier_coefficient():
    shape = TrapezoidalEmf(2.0)
    angle = (np.arange(SAMPLES) + 0.5) / SAMPLES * 2 * pi
    assert shape.fundamental == pytest.approx(2 * np.mean(shape.shape(angle) * np.sin(angle)), rel=1e-7)


def test_torque_and_voltage_constants_state_the_same_flux():
    """A servo sheet states both; at equal flux Kt [N*m/Arms] is sqrt(3) times Ke [V s/rad, rms line to line]."""
    flux = flux_from_torque_constant(0.9, pole_pairs=5)
    volts_per_krpm = 0.9 / sqrt(3) * 1000 * pi / 30
    assert flux_from_voltage_constant(volts_per_krpm, pole_pairs=5) == pytest.approx(flux, rel=1e-12)
    made = PermanentMagnetMachine(pole_pairs=5, phase_resistance=1.0, phase_inductance=1e-3, flux_linkage=flux)
    torque = one_electrical_turn(made, lambda angle: 2.0 * sqrt(2) * np.sin(angle[:, None] - PHASE_LAG))
    assert torque.mean() == pytest.approx(0.9 * 2.0, rel=1e-12)


@pytest.mark.parametrize(
    ("make", "told"),
    [
        (lambda: HarmonicEmf({5: 0.1}), "fundamental"),
        (lambda: HarmonicEmf({1: 1.0, 4: 0.1}), "odd orders only"),
        (lambda: TrapezoidalEmf(3.2), "flat top must be at most"),
        (
            lambda: PermanentMagnetMachine(pole_pairs=0, phase_resistance=1, phase_inductance=1, flux_linkage=1),
            "at least 1",
        ),
        (
            lambda: PermanentMagnetMachine(pole_pairs=2, phase_resistance=1, phase_inductance=0, flux_linkage=1),
            "more than 0",
        ),
    ],
)
def test_bad_machines_are_refused_in_one_sentence(make, told):
    with pytest.raises(ValueError, match=told):
        make()
