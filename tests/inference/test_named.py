"""Mechanisms that a scenario leaves out are named, with sizes whose 95 % interval holds the truth."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.benches import FREE, GEARED, PUMP, RIPPLED, bench, recorded
from torquerig import mechanisms
from torquerig.inference import sample_faults
from torquerig.inference.answer import as_json
from torquerig.inference.engine import diagnose
from torquerig.sensor_stages.clip import Clip

BENCHES = {"free": FREE, "pump": PUMP, "geared": GEARED, "rippled": RIPPLED}

# bench, what it lacks, the name (with its variant), parameters of the answer and their true values
HIDDEN = {
    "imbalance": (
        "pump", mechanisms.Imbalance(name="x", at="pump", mass=1.0, eccentricity=0.02), "imbalance",
        {"unbalance_kgm": 0.02},
    ),
    "bending_crosstalk": (
        "pump", mechanisms.BendingCrosstalk(name="x", sensor="sensor", once=0.1, twice=0.05), "bending_crosstalk",
        {"once_Nm": 0.1, "twice_Nm": 0.05},
    ),
    "misalignment": (
        "pump", mechanisms.Misalignment(name="x", coupling="shaft", angle=0.03), "misalignment", {"angle_rad": 0.03},
    ),
    "parallel_offset": (
        "pump",
        mechanisms.ParallelOffset(name="x", coupling="shaft", offset=0.0005, radius=0.02, unequal_share=0.02),
        "parallel_offset", {"offset_over_radius": 0.025, "unequal_share": 0.02},
    ),
    "jaw_coupling": (
        "pump", mechanisms.JawCoupling(name="x", coupling="shaft", jaws=5, jaw_error=2e-4, leg_error=1e-4),
        "jaw_coupling", {"jaws": 5, "jaw_error_rad": 2e-4},
    ),
    "belt_lines": (
        "geared", mechanisms.BeltLines(name="x", gear="belt", belt_error=(2e-2, 1e-2)), "belt_lines",
        {"order_output": 34 / 90},
    ),
    "tooth_mesh": (
        "geared", mechanisms.GearMesh(name="x", gear="gearbox", order_output=72.0, transmission_error=(5e-5, 2e-5)),
        "gear_mesh", {"order_output": 72.0, "transmission_error_rad": 5e-5},
    ),
    "current_offset": (
        "pump", mechanisms.CurrentOffset(name="x", at="motor", pole_pairs=4, torque_constant=0.5, offset_a=0.2),
        "current_offset", {"order_motor": 4, "offset_times_constant_Nm": 0.1},
    ),
    "current_gain": (
        "pump", mechanisms.CurrentGain(name="x", at="motor", pole_pairs=4, mismatch=0.1), "commutation_ripple",
        {"order_motor": 8},
    ),
    "phase_unbalance": (
        "pump", mechanisms.PhaseUnbalance(name="x", at="motor", extra_resistance=(0.3, 0.0, 0.0)),
        "commutation_ripple", {"order_motor": 8},
    ),
    "back_emf_harmonics": (
        "pump", mechanisms.BackEmfHarmonics(name="x", at="motor", shares={7: 0.08}), "commutation_ripple",
        {"order_motor": 24},
    ),
    "commutation_ripple": (
        "rippled",
        mechanisms.CommutationRipple(name="x", at="motor", order_motor=24.0, depth=0.05, harmonics=(0.02,)),
        "commutation_ripple", {"order_motor": 24, "depth": 0.05},
    ),
    "encoder_error": (
        "pump", mechanisms.EncoderError(name="x", at="motor", amplitudes={1: 0.01}), "encoder_error",
        {"angle_error_rad": 0.01},
    ),
    "eccentricity": (
        "pump",
        mechanisms.Eccentricity(
            name="x", at="motor", slots=12, pole_pairs=4, tooth_torque=0.5, static=0.3, dynamic=0.2
        ),
        "cogging eccentricity", {},
    ),
    "flicker_noise": (
        "free", mechanisms.FlickerNoise(name="x", sensor="sensor", corner=400.0), "flicker_noise", {"corner_Hz": 400.0},
    ),
    "pwm_aliasing": (
        "pump", mechanisms.PwmAliasing(name="x", frequency=730.0, amplitude=0.004), "pwm_aliasing",
        {"frequency_Hz": 730.0, "amplitude_V": 0.004},
    ),
    "quantization": (
        "pump", mechanisms.Quantization(name="x", step=0.01), "quantization", {"step_V": 0.01},
    ),
    "signal_dropout": (
        "pump", mechanisms.SignalDropout(name="x", duration=0.012, rate=0.7), "signal_dropout",
        {"duration_ms": 12.0, "rate_per_minute": 42.0},
    ),
    "turbulent_load": (
        "free",
        mechanisms.TurbulentLoad(name="x", at="pump", quadratic=1e-4, turbulence=0.1, turbulence_cutoff=4.0),
        "turbulent_load", {"coefficient_Nms2": 1e-4, "turbulence": 0.1, "turbulence_cutoff_Hz": 4.0},
    ),
}  # fmt: skip


@pytest.fixture(scope="module")
def benches(tmp_path_factory):
    return {name: bench(text, tmp_path_factory.mktemp(name)) for name, text in BENCHES.items()}


def answered(scenario, recordings):
    return as_json(diagnose(scenario, recordings))


@pytest.mark.long
@pytest.mark.parametrize("hidden", HIDDEN)
def test_a_mechanism_is_named_with_its_sizes(benches, hidden):
    name, part, wanted, true = HIDDEN[hidden]
    data = answered(benches[name], recorded(benches[name], [part]))
    first = data["findings"][0]
    mechanism, _, variant = wanted.partition(" ")
    assert first["mechanism"] == mechanism or mechanism in first["equivalent_to"], data["findings"]
    assert not variant or first["variant"] == variant
    assert len(data["findings"]) == 1
    if first["mechanism"] == mechanism:
        for parameter, value in true.items():
            low, high = first["parameters"][parameter]["ci95"]
            assert low * (1 - 1e-4) <= value <= high * (1 + 1e-4), parameter
    before, after = (data["fit"][when]["heldout_misfit"] for when in ("before", "after"))
    assert after < max(0.8 * before, 1.5) or mechanism in sample_faults.NAMES  # repaired before both


@pytest.mark.long
def test_nothing_but_the_limit_is_named_where_all_of_a_signal_is_cut(benches):
    plain = recorded(benches["pump"])
    limit = float(np.median(np.abs(plain[1].torque_values())))
    data = answered(benches["pump"], [Clip(limit=limit).apply(each) for each in plain])
    assert [finding["mechanism"] for finding in data["findings"]] == ["clipping"]
    assert (data["verdict"], data["setup"], data["unnamed"]) == ("missing_physics", [], [])


@pytest.mark.long
def test_a_limit_that_few_samples_reach_is_named_and_the_rest_explained(benches):
    plain = recorded(benches["pump"])
    largest = np.sort(np.abs(plain[0].torque_values()))
    limit = float(largest[round(0.995 * largest.size)])
    data = answered(benches["pump"], [Clip(limit=limit).apply(each) for each in plain])
    (finding,) = data["findings"]
    assert finding["mechanism"] == "clipping"
    low, high = finding["parameters"]["limit_V"]["ci95"]
    assert low <= limit <= high
    assert data["verdict"] == "missing_physics"


@pytest.mark.long
def test_a_low_pass_of_the_logger_is_named(benches):
    part = mechanisms.LoggerLowPass(name="x", cutoff=400.0, order=4)
    (finding,) = answered(benches["pump"], recorded(benches["pump"], [part]))["findings"]
    assert finding["mechanism"] == "logger_low_pass"
    assert finding["parameters"]["order"]["value"] == 4
    # the simulation's two sections also lose sinc^2(f / rate) each: 2.3 dB together at 400 Hz of 2 kHz, 5.3 dB in all
    cutoff = 400.0 / (10**0.53 - 1) ** (1 / 8)
    assert finding["parameters"]["cutoff_Hz"]["value"] == pytest.approx(cutoff, rel=0.05)


@pytest.mark.long
def test_impacts_that_ring_are_named(benches):
    part = mechanisms.BearingDefect(
        name="x", at="pump", order_output=3.57, ring_frequency=420.0, damping=0.03, amplitude=0.1, slip=0.005
    )
    data = answered(benches["pump"], recorded(benches["pump"], [part]))
    (finding,) = data["findings"]
    assert finding["mechanism"] == "bearing_defect"
    assert finding["parameters"]["order_output"]["value"] == pytest.approx(3.57, rel=0.005)
    assert finding["parameters"]["ring_frequency_Hz"]["value"] == pytest.approx(420.0, rel=0.02)


@pytest.mark.long
def test_a_random_load_that_no_scenario_states_is_named(benches):
    part = mechanisms.ParticleLoad(name="x", at="pump", mean_by_occupancy_percent={0: 1.0}, hit_rms=0.1)
    data = answered(benches["free"], recorded(benches["free"], [part], runs=((800, 0), (1200, 0))))
    (finding,) = data["findings"]
    assert finding["mechanism"] == "particle_load"
    low, high = finding["parameters"]["mean_Nm"]["ci95"]
    assert low < 1.0 < high


@pytest.mark.long
def test_friction_that_differs_by_direction_has_sizes_of_both(tmp_path):
    tared = bench(FREE.replace("noise_rms", "zero_tolerance: 0.01 N*m, noise_rms"), tmp_path)  # a zero looks alike
    part = mechanisms.StribeckFriction(
        name="x", at="pump", coulomb=0.3, static=0.3, stribeck_speed=5.0, coulomb_backward=0.6, static_backward=0.6
    )
    data = answered(tared, recorded(tared, [part], runs=((1200, 0),), profile="reversal"))
    finding = data["findings"][0]
    assert (finding["mechanism"], finding["variant"]) == ("stribeck_friction", "by_direction")
    for side, true in (("forward", 0.3), ("backward", 0.6)):
        low, high = finding["parameters"][f"coulomb_Nm_{side}"]["ci95"]
        assert low < true < high


@pytest.mark.long
def test_friction_is_named_where_the_load_could_be_several_times_the_stated_one(tmp_path):
    stated = "{0: {value: 0.3 N*m, rel_sd: 0.05}, 100: {value: 2 N*m, rel_sd: 0.05}}"
    scenario = bench(PUMP.replace("{0: 1 N*m, 100: 2 N*m}", stated), tmp_path)
    part = mechanisms.StribeckFriction(name="x", at="pump", coulomb=0.7, static=1.0, stribeck_speed=3.0)
    data = answered(scenario, recorded(scenario, [part], runs=((1200, 100), (800, 0)), profile="reversal"))
    assert data["setup"] == []
    assert [finding["mechanism"] for finding in data["findings"]] == ["stribeck_friction"]
    low, high = data["findings"][0]["parameters"]["coulomb_Nm"]["ci95"]
    assert low < 0.7 < high


@pytest.mark.long
@pytest.mark.parametrize("name", BENCHES)
def test_nothing_is_named_where_nothing_is_missing(benches, name):
    assert answered(benches[name], recorded(benches[name]))["findings"] == []


@pytest.mark.long
def test_an_inertia_that_is_far_from_its_stated_value_is_a_fault_of_the_set_up(benches, tmp_path):
    stated = bench(FREE.replace("inertia: {value: 0.01 ", "inertia: {value: 0.03 "), tmp_path)
    data = answered(stated, recorded(benches["free"], runs=((1200, 0), (900, 0)), profile="ramp"))
    assert data["findings"] == []
    (fault,) = data["setup"]
    assert (fault["kind"], fault["of"], fault["stated"]) == ("parameter", "pump.inertia", 0.03)
    low, high = fault["estimated"]["ci95"]
    assert low < 0.01 < high
