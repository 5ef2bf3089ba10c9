"""A motor file with figures as printed is read with its fields in SI, and contradictions name file, line and key."""

from math import pi, sqrt

import pytest

from torquerig.catalog.motor import Motor
from torquerig.catalog.phases import sample_phases
from torquerig.catalog.reading import read_entry
from torquerig.catalog.sampling import nominal, sample_entry
from torquerig.errors import InputError

HEAD = """name: printed
title: "motor as printed"
kind: pmsm
peak_torque: {value: 2.84 N*m, evidence: DOC, source: "p. 30"}
rated_speed: {value: 3000 rpm, evidence: DOC, source: "p. 30"}
max_speed: {value: 6000 rpm, evidence: DOC, source: "p. 30"}
current_loop_bandwidth: {low: 500 Hz, high: 2000 Hz, evidence: RT, source: "rule of thumb"}
pole_pairs: {value: 4, evidence: DOC, source: "p. 30"}
slots: {value: 12, evidence: DOC, source: "p. 30"}
rotor_inertia: {value: 0.35 kg*cm^2, evidence: DOC, source: "p. 30"}
"""
TORQUE = 'rated_torque: {value: 1.17 N*m, evidence: DOC, source: "p. 30"}\n'
FRICTION = """coulomb_friction: {value: 0.02 N*m, evidence: DOC, source: "p. 30"}
viscous_friction: {value: 2e-5 N*m*s/rad, evidence: DOC, source: "p. 30"}
"""
RIPPLE = 'ripple:\n  cogging_native: {low: 0.2 %, high: 2 %, evidence: RT, source: "rule of thumb"}\n'
RPM = 2 * pi / 60


def text_of(*lines, head=HEAD + TORQUE + FRICTION + RIPPLE):
    printed = "".join(f"  {line}\n" for line in lines)
    return f'{head}as_printed:\n  evidence: DOC\n  source: "p. 31"\n{printed}'


def read(tmp_path, *lines, head=HEAD + TORQUE + FRICTION + RIPPLE):
    path = tmp_path / "printed.yaml"
    path.write_text(text_of(*lines, head=head), encoding="utf-8")
    return read_entry(path, Motor)


def refused(tmp_path, *lines, head=HEAD + TORQUE + FRICTION + RIPPLE):
    with pytest.raises(InputError) as caught:
        read(tmp_path, *lines, head=head)
    return str(caught.value)


def test_a_makers_table_as_printed(tmp_path):
    """Wittenstein premo 2C [W1]: Ke 23.7 V/krpm, 5.70 ohm and 6.12 mH between terminals, 0.39 N m/A."""
    motor = read(
        tmp_path, "voltage_constant: 23.7 V/krpm line-to-line rms", "torque_constant: 0.39 N*m/A",
        "resistance: 5.70 ohm line-to-line", "inductance: 6.12 mH line-to-line", "rated_current: 2.96 A rms",
    )  # fmt: skip
    values = nominal(motor).values
    assert values["torque_constant"] == pytest.approx(0.39)
    assert values["phase_resistance"] == pytest.approx(2.85)
    assert values["phase_inductance"] == pytest.approx(3.06e-3)
    assert values["rated_current"] == pytest.approx(2.96)
    assert all(getattr(motor, key).documented for key in ("torque_constant", "phase_resistance", "rated_current"))
    assert motor.torque_constant.source == "p. 31"
    assert motor.torque_constant.note.startswith("as printed: Kt 0.39 N*m/A, taken as rms")


@pytest.mark.parametrize(
    ("kt", "ke"), [(0.35, 21.0), (0.39, 23.7), (0.41, 25.0), (0.52, 31.6), (0.51, 31.1), (0.54, 32.5)]
)
def test_six_motors_of_a_table_agree_as_printed(tmp_path, kt, ke):
    """Wittenstein premo 320 V, p. 30 [W1]: Kt in Nm/A_eff, Ke in V_eff/krpm without a word on phase or line."""
    head = HEAD.replace("2.84 N*m", "20 N*m") + TORQUE + FRICTION + RIPPLE
    motor = read(tmp_path, f"torque_constant: {kt} Nm/A_eff", f"voltage_constant: {ke} V_eff/krpm", head=head)
    assert motor.torque_constant.value == pytest.approx(kt)


@pytest.mark.parametrize(
    ("kind", "torque", "current", "constant"),
    [("SGM7J-01A", 0.318, 0.85, 0.413), ("SGM7J-02A", 0.637, 1.6, 0.444), ("SGM7J-04A", 1.27, 2.5, 0.544),
     ("SGM7J-08A", 2.39, 4.4, 0.584), ("SGMAH-01A", 0.318, 0.91, 0.378), ("SGMSH-15A", 4.90, 9.7, 0.561)],
)  # fmt: skip
def test_ratings_of_real_motors_are_no_contradiction(tmp_path, kind, torque, current, constant):
    """Yaskawa's tables [Y1, Y2, Y5]: Kt is up to 12 % above rated torque over rated current."""
    head = HEAD.replace("2.84 N*m", "20 N*m") + FRICTION + RIPPLE
    motor = read(
        tmp_path, f"rated_torque: {torque} N*m", f"rated_current: {current} A rms",
        f"torque_constant: {constant} N*m/A rms", head=head,
    )  # fmt: skip
    assert motor.torque_constant.value == pytest.approx(constant), kind


def test_a_constant_per_peak_ampere_that_is_called_rms_is_refused(tmp_path):
    said = refused(tmp_path, "rated_current: 2.96 A rms", f"torque_constant: {0.39 / sqrt(2):.4g} N*m/A rms")
    assert "printed.yaml:20: torque_constant: 0.2758 N*m/Arms does not agree" in said


@pytest.mark.parametrize(
    ("figure", "low", "high"),
    [
        ("6 ohm line-to-line", 3, 3),
        ("6 ohm line-to-line delta", 3, 3),
        ("6 ohm per phase star", 6, 6),
        ("6 ohm per phase delta", 2, 2),
        ("6 ohm per phase", 2, 6),
        ("6 ohm", 2, 6),
        ("6 ohm line-to-line ± 10 %", 2.7, 3.3),
        ("6 ohm line-to-line @ 25 °C", 3 / (1 + 5 * 0.00393), 3 / (1 + 5 * 0.00393)),
    ],
)
def test_resistance_by_terminals_and_winding(tmp_path, figure, low, high):
    motor = read(tmp_path, f"resistance: {figure}")
    assert motor.phase_resistance.bounds == pytest.approx((low, high))
    assert motor.phase_resistance.documented is (low == high)


def test_a_delta_of_three_branches_measures_between_terminals_what_its_star_does():
    branch = 6.0
    terminals = branch * 2 * branch / (3 * branch)
    assert terminals / 2 == pytest.approx(branch / 3)


def test_the_winding_of_the_sheet_decides_a_value_per_phase(tmp_path):
    motor = read(tmp_path, "winding: delta", "resistance: 6 ohm per phase", "inductance: 9 mH")
    assert motor.phase_resistance.value == pytest.approx(2)
    assert motor.phase_inductance.bounds == pytest.approx((3e-3, 4.5e-3))


def test_the_electrical_time_constant_gives_the_inductance(tmp_path):
    motor = read(tmp_path, "resistance: 6 ohm line-to-line", "electrical_time_constant: 2 ms")
    assert motor.phase_inductance.value == pytest.approx(6e-3)


def test_a_no_load_current_gives_frictions_with_the_printed_sum(tmp_path):
    head = HEAD + TORQUE + RIPPLE
    motor = read(
        tmp_path, "torque_constant: 0.4 N*m/A rms", "no_load_current: 0.1 A rms", "no_load_speed: 6000 rpm", head=head
    )
    dry = []
    for seed in range(200):
        values = sample_entry(motor, seed).values
        total = values["coulomb_friction"] + values["viscous_friction"] * 6000 * RPM
        assert total == pytest.approx(0.04)
        dry.append(values["coulomb_friction"] / 0.04)
    assert min(dry) < 0.05
    assert max(dry) > 0.95
    middle = nominal(motor).values
    assert middle["coulomb_friction"] == pytest.approx(0.02)
    assert middle["coulomb_friction"] + middle["viscous_friction"] * 6000 * RPM == pytest.approx(0.04)
    assert motor.coulomb_friction.bounds == pytest.approx((0, 0.04))


@pytest.mark.parametrize(
    ("figure", "low", "high"),
    [
        ("1.17 N*m", 1.17, 1.17),
        ("1.17 N*m S1", 1.17, 1.17),
        ("165.7 oz in", 1.17, 1.17),
        ("2 N*m S3 25 %", 1.0, 2.0),
    ],
)
def test_a_rated_torque_of_s1_or_s3(tmp_path, figure, low, high):
    motor = read(tmp_path, f"rated_torque: {figure}", head=HEAD + FRICTION + RIPPLE)
    assert motor.rated_torque.bounds == pytest.approx((low, high), rel=1e-3)


def test_rated_power_gives_the_torque_that_is_not_printed(tmp_path):
    motor = read(tmp_path, "rated_power: 0.5 HP", head=HEAD + FRICTION + RIPPLE)
    assert motor.rated_torque.value == pytest.approx(0.5 * 745.69987 / (3000 * RPM))
    assert motor.rated_power.value == pytest.approx(0.5 * 745.69987)


def test_an_s3_rating_must_fit_the_s1_rating(tmp_path):
    assert read(tmp_path, "intermittent_torque: 1.8 N*m S3 40 %").rated_torque.value == 1.17
    said = refused(tmp_path, "intermittent_torque: 2.4 N*m S3 40 %")
    assert "printed.yaml:19: as_printed.intermittent_torque: 2.4 N*m S3 40 % contradicts the S1 torque 1.17 N*m" in said


@pytest.mark.parametrize(
    ("figure", "low", "high"),
    [
        ("2 % of rated torque peak-to-peak", 0.01, 0.01),
        ("2 % of rated torque amplitude", 0.02, 0.02),
        ("2 % of rated torque", 0.01, 0.02),
        ("23.4 mN*m peak-to-peak", 0.01, 0.01),
    ],
)
def test_cogging_as_a_share_zero_to_peak(tmp_path, figure, low, high):
    motor = read(tmp_path, f"cogging: {figure}", head=HEAD + TORQUE + FRICTION)
    assert motor.ripple.cogging_native.bounds == pytest.approx((low, high))
    assert motor.ripple.cogging_tolerance.bounds == pytest.approx((0, high))


def test_a_maxon_sheet_as_printed(tmp_path):
    """EC-i style: Kt 36.9 mNm/A, 259 rpm/V, 0.386 ohm phase to phase, 133 mA at 6110 rpm (six-step)."""
    head = (HEAD + TORQUE + RIPPLE).replace("kind: pmsm", "kind: bldc")
    motor = read(
        tmp_path, "torque_constant: 36.9 mNm/A", "speed_constant: 259 rpm/V", "resistance: 0.386 Ω phase to phase",
        "inductance: 0.065 mH phase to phase", "no_load_current: 133 mA dc", "no_load_speed: 6110 rpm", head=head,
    )  # fmt: skip
    assert motor.torque_constant.value == pytest.approx(0.0369)
    assert motor.phase_resistance.value == pytest.approx(0.193)
    assert motor.no_load_torque.value == pytest.approx(0.0369 * 0.133)


def test_flywheel_effect_is_four_times_the_inertia(tmp_path):
    head = HEAD.replace("rotor_inertia", "#") + TORQUE + FRICTION + RIPPLE
    assert read(tmp_path, "flywheel_effect: 1.4e-4 kgf*m^2", head=head).rotor_inertia.value == pytest.approx(0.35e-4)


def test_printed_values_drive_the_phase_level_machine(tmp_path):
    """lambda = Ke phase peak / pole pairs."""
    motor = read(
        tmp_path, "voltage_constant: 0.1 V*s/rad phase peak", "resistance: 2 ohm line-to-line",
        "inductance: 4 mH line-to-line",
    )  # fmt: skip
    phases = sample_phases(nominal(motor), 1).values
    assert phases["flux_linkage"] == pytest.approx(0.1 / 4)
    assert phases["phase_resistance"] == pytest.approx(1.0)


REFUSED = {
    "a figure outside the block": (
        (), HEAD + TORQUE + FRICTION + RIPPLE + "voltage_constant: 23.7 V/krpm\n",
        "printed.yaml:16: voltage_constant: is a figure of a data sheet; write it under as_printed:",
    ),
    "an unknown figure": (("voltage_constnt: 23.7 V/krpm",), None,
        "19: as_printed.voltage_constnt: unknown key; did you mean"),
    "a word that does not fit": (("resistance: 5.7 ohm rms",), None,
        "19: as_printed.resistance: '5.7 ohm rms': 'rms' does not fit here; fitting words are line-to-line, per phase"),
    "a word at the second constant": (("torque_constant: 0.39 N*m/A", "voltage_constant: 2 V/krpm peak-to-peak"), None,
        "20: as_printed.voltage_constant: '2 V/krpm peak-to-peak': 'peak-to-peak' does not fit here"),
    "a bare number": (("resistance: 5.7",), None, "19: as_printed.resistance: 5.7 is no figure with a unit"),
    "another unit": (("resistance: 5.7 mH line-to-line",), None,
        "as_printed.resistance: '5.7 mH' is an inductance; a resistance is wanted"),
    "stated twice": (("rated_torque: 1.2 N*m",), None,
        "printed.yaml:11: rated_torque: is also in as_printed (rated_torque); keep one of them"),
    "ke and kt": (("torque_constant: 0.39 N*m/A rms", "voltage_constant: 16.8 V/krpm line-to-line rms"), None,
        "but Ke 16.8 V/krpm line-to-line rms gives 0.278 N*m/A; they differ by a factor of 1.4, about sqrt(2): peak"),
    "a no-load current alone": (("no_load_current: 0.1 A rms",), None,
        "as_printed.no_load_current: gives the friction only with no_load_speed; add it"),
    "a no-load current without a constant": (("no_load_current: 0.1 A rms", "no_load_speed: 6000 rpm"), None,
        "as_printed.no_load_current: gives a torque only with Kt or Ke"),
    "a duty of a resistance": (("resistance: 5 ohm S3 40 %",), None, "which only torque and power have"),
    "cogging in peak": (("cogging: 2 % peak",), None, "peak-to-peak or amplitude?"),
    "no source": (None, None, "as_printed: the key 'source' is missing; add it"),
}  # fmt: skip


@pytest.mark.parametrize(("lines", "head", "sentence"), REFUSED.values(), ids=REFUSED)
def test_a_bad_sheet_is_refused_with_file_line_and_key(tmp_path, lines, head, sentence):
    if lines is None:
        path = tmp_path / "printed.yaml"
        path.write_text(HEAD + TORQUE + FRICTION + RIPPLE + "as_printed:\n  evidence: DOC\n", encoding="utf-8")
        with pytest.raises(InputError) as caught:
            read_entry(path, Motor)
        assert sentence in str(caught.value)
        return
    said = refused(tmp_path, *lines, head=head or HEAD + TORQUE + FRICTION + RIPPLE)
    assert sentence in said
    assert len(said.splitlines()) == 1


def test_a_constant_of_the_entry_and_ke_of_the_sheet_must_agree(tmp_path):
    own = 'torque_constant: {value: 0.39 N*m/Arms, evidence: DOC, source: "p. 2"}\n'
    head = HEAD + TORQUE + FRICTION + RIPPLE + own
    assert read(tmp_path, "voltage_constant: 23.7 V/krpm line-to-line rms", head=head).torque_constant.value == 0.39
    assert "sqrt(3)" in refused(tmp_path, "voltage_constant: 41 V/krpm line-to-line rms", head=head)


def test_an_induction_motor_has_no_constant_of_magnets(tmp_path):
    head = (HEAD + TORQUE + FRICTION + RIPPLE).replace("kind: pmsm", "kind: induction").replace("slots", "rotor_bars")
    assert "has no magnets" in refused(tmp_path, "voltage_constant: 23.7 V/krpm", head=head)
