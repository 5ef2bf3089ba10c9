"""The torque constant from Kt, Ke and kV: all readings of a machine give one value; contradictions are named."""

from math import pi, sqrt

import numpy as np
import pytest

from torquerig.catalog.printed.emf import NAMES, current_factors, factors_of, torque_constant
from torquerig.catalog.printed.figure import read_figure
from torquerig.catalog.printed.reading_of import readings, spoken
from torquerig.errors import UnitError

PSI = 0.0213  # [V s/rad] phase peak of Ke: pole pairs times flux linkage
ANGLE = np.linspace(0, 2 * pi, 720_000, endpoint=False)


def trapezoid(angle, flat):
    """Phase EMF per rad/s with this flat top [deg], peak 1, one period of 2 pi."""
    ramp = np.radians(180 - flat) / 2
    return np.clip(np.arcsin(np.sin(angle)) / ramp, -1, 1)


def measured(wave):
    """Return what a maker measures on a machine of this phase EMF: Ke by its words [V s/rad]."""
    phase, line = wave(ANGLE), wave(ANGLE) - wave(ANGLE - 2 * pi / 3)
    return {
        "phase peak": np.max(phase), "phase rms": sqrt(np.mean(phase**2)),
        "line peak": np.max(line), "line rms": sqrt(np.mean(line**2)), "line dc": np.max(line),
    }  # fmt: skip


def factor_of(words, key, *, six_step):
    return next(one for one in factors_of(key, six_step=six_step) if one.words == set(words.split()))


def test_a_sine_gives_one_torque_constant_from_every_reading_of_ke():
    """Mechanical power 3/2 psi I w of three sines, per rms ampere of a phase."""
    truth = 1.5 * PSI * sqrt(2)
    for words, ke in measured(lambda angle: PSI * np.sin(angle)).items():
        factor = factor_of(words, "voltage_constant", six_step=False)
        assert ke * factor.low == pytest.approx(truth, rel=1e-6), words
        assert factor.low == factor.high
    assert factor_of("peak", "torque_constant", six_step=False).low * 1.5 * PSI == pytest.approx(truth)


@pytest.mark.parametrize("flat", [1, 60, 90, 119.999])
def test_six_step_factors_cover_every_shape_up_to_the_trapezoid_of_120_degrees(flat):
    """Torque per DC ampere at the middle of the 60 degrees in which two phases conduct."""
    for wave in (lambda angle: PSI * np.sin(angle), lambda angle: PSI * trapezoid(angle, 120.0)):
        found = measured(wave)
        for words, ke in found.items():
            factor = factor_of(words, "voltage_constant", six_step=True)
            assert ke * factor.low <= found["line peak"] * (1 + 1e-4), words
            assert ke * factor.high >= found["line peak"] * (1 - 1e-4), words


def test_both_ends_of_a_six_step_factor_are_a_sine_and_the_ideal_trapezoid():
    sine, trap = measured(np.sin), measured(lambda angle: trapezoid(angle, 120.0))
    for words in ("line rms", "phase peak", "phase rms"):
        factor = factor_of(words, "voltage_constant", six_step=True)
        ends = sorted(found["line peak"] / found[words] for found in (sine, trap))
        assert (factor.low, factor.high) == pytest.approx(tuple(ends), rel=1e-4)


def test_a_printed_ampere_times_the_constant_is_the_same_torque():
    for six_step in (False, True):
        for current, constant in zip(
            current_factors(six_step=six_step), factors_of("torque_constant", six_step=six_step), strict=True
        ):
            assert current.words == constant.words
            assert current.low * constant.high == pytest.approx(1.0)
            assert current.high * constant.low == pytest.approx(1.0)


def test_mean_torque_of_six_step_current_in_a_sine_is_within_the_dc_factor():
    middle = np.linspace(-pi / 6, pi / 6, 100_001)
    mean = np.mean(sqrt(3) * PSI * np.cos(middle))  # two phases carry 1 A around the crest of their voltage
    factor = factor_of("dc", "torque_constant", six_step=False)
    truth = 1.5 * PSI * sqrt(2)
    assert mean * factor.high == pytest.approx(truth, rel=1e-6)
    assert sqrt(3) * PSI * factor.low == pytest.approx(truth)


def found(six_step=False, pole_pairs=(), **figures):
    return torque_constant(
        {key: read_figure(text) for key, text in figures.items()}, six_step=six_step, pole_pairs=pole_pairs
    )


def test_the_conversion_of_the_manual():
    """27.8 V/krpm line-to-line rms of a servo motor is 0.46 N m/A per rms ampere."""
    made = found(voltage_constant="27.8 V/krpm line-to-line rms")
    assert (round(made.low, 4), made.low) == (0.4598, made.high)
    assert made.words == "Ke 27.8 V/krpm line-to-line rms, times sqrt(3) (line-to-line rms)"


def test_kv_of_a_six_step_motor():
    """D6374-150KV: 0.0637 N m/A ideal; ODrive's 8.27 / KV per peak ampere of a phase is the same machine [G3]."""
    assert found(six_step=True, speed_constant="150 rpm/V dc").low == pytest.approx(60 / (2 * pi * 150))
    sine = found(speed_constant="150 rpm/V dc")
    assert sine.low / sqrt(2) == pytest.approx(8.27 / 150, rel=1e-3)


def test_a_voltage_of_a_delta_branch_may_be_either():
    """In delta a branch has the voltage between two lines; a sheet may also mean the equivalent star."""
    branch = found(voltage_constant="27.8 V/krpm per phase rms delta")
    assert branch.low == pytest.approx(found(voltage_constant="27.8 V/krpm line-to-line rms").low)
    assert branch.high == pytest.approx(found(voltage_constant="27.8 V/krpm per phase rms star").low)


def test_the_name_of_a_model_motor_and_an_amplitude_are_read():
    assert found(six_step=True, speed_constant="190 KV").low <= 60 / (2 * pi * 190)
    assert found(torque_constant="0.46 N*m/A0-pk").low == pytest.approx(0.46 * sqrt(2))


@pytest.mark.parametrize("text", ["0.46 N*m/A peak-to-peak", "0.46 N*m/A line-to-line rms"])
def test_a_word_that_does_not_fit_is_refused(text):
    with pytest.raises(UnitError, match="does not fit here; fitting words are rms, peak, dc"):
        found(torque_constant=text)


def test_a_constant_without_peak_or_rms_is_an_interval_that_covers_both():
    made = found(torque_constant="0.46 N*m/A")
    assert (made.low, made.high) == pytest.approx((0.46, 0.46 * sqrt(2)))
    assert "the interval covers all" in made.words
    all_four = found(voltage_constant="27.8 V/krpm")
    for words in ("line-to-line rms", "line-to-line peak", "phase rms", "phase peak"):
        one = found(voltage_constant=f"27.8 V/krpm {words}")
        assert all_four.low <= one.low <= one.high <= all_four.high


def test_the_other_constant_decides_an_ambiguous_one():
    for words, low in (("rms", 0.46), ("peak", 0.46 * sqrt(2))):
        ke = low / sqrt(3) * 1000 * 2 * pi / 60
        made = found(torque_constant="0.46 N*m/A", voltage_constant=f"{ke:.4g} V/krpm line-to-line rms")
        assert made.low == made.high == pytest.approx(low, rel=1e-3), words
        assert "agrees within 10 %" in made.words


@pytest.mark.parametrize(
    ("kt", "ke", "cause"),
    [
        ("0.46 N*m/A rms", "19.7 V/krpm line-to-line rms", r"sqrt\(2\): peak against rms"),
        ("0.46 N*m/A rms", "48.1 V/krpm line-to-line rms", r"sqrt\(3\): line-to-line against one phase"),
        ("0.46 N*m/A rms", "0.265 V/rpm line-to-line rms", r"60/\(2 pi\)"),
        ("0.46 N*m/A rms", "27.8 V/rpm line-to-line rms", "1000"),
        ("0.46 N*m/A rms", "110.9 V/krpm line-to-line rms", "4: per electrical against per mechanical"),
        ("0.46 N*m/A rms", "150 V/krpm line-to-line rms", "no mix-up of units explains"),
    ],
)
def test_constants_that_contradict_give_both_values_and_the_likely_cause(kt, ke, cause):
    made = found(torque_constant=kt, voltage_constant=ke, pole_pairs=(4,))
    assert kt in made.contradiction
    assert ke in made.contradiction
    assert "\n" not in made.contradiction
    with pytest.raises(AssertionError, match=cause):
        raise AssertionError(made.contradiction)


@pytest.mark.parametrize(("ratio", "agrees"), [(0.92, True), (1.08, True), (0.88, False), (1.12, False)])
def test_ten_per_cent_is_the_limit_of_agreement(ratio, agrees):
    made = found(torque_constant=f"{0.4598 * ratio} N*m/A rms", voltage_constant="27.8 V/krpm line-to-line rms")
    assert (made.contradiction == "") is agrees


def test_every_reading_is_spoken_in_words_that_are_read_back():
    for key in NAMES:
        for six_step in (False, True):
            for one in factors_of(key, six_step=six_step):
                text = f"1 V/krpm {spoken(one.words)}"
                assert [again.factor for again in readings(read_figure(text), (1.0, 1.0), [one])] == [one]
