"""A sidecar is read in SI, and a slip in it is told with file, line and key."""

from math import pi
from pathlib import Path

import pytest

from torquerig.errors import InputError
from torquerig.recordings.files.sidecar import read_sidecar

CONTRACT = """\
sample_rate_Hz: 25000            # or a `time_s` column in the table
channels:
  torque_V:      {quantity: torque, unit: V, Nm_per_V: 1.0}
  encoder_count: {quantity: motor_angle, unit: count, counts_per_rev: 16384}   # optional
run:
  motor: bldc-12n14p
  gear_ratio: 5
  speed_rpm: 1000
  profile: steady
  occupancy_percent: 5
  particle_size_mm: 0.5
"""


def written(folder: Path, text: str) -> Path:
    path = folder / "run1.yaml"
    path.write_text(text, encoding="utf-8")
    return path


def test_contract_example_section_1(tmp_path: Path) -> None:
    sidecar = read_sidecar(written(tmp_path, CONTRACT))
    assert sidecar.sample_rate == 25000
    assert sidecar.channels["torque_V"].si_per_unit == 1.0
    assert sidecar.channels["encoder_count"].si_per_unit == pytest.approx(2 * pi / 16384, rel=1e-15)
    assert sidecar.run.speed == pytest.approx(104.71975511965978, rel=1e-15)
    assert sidecar.run.particle_size == pytest.approx(0.5e-3, rel=1e-15)
    assert (sidecar.run.motor, sidecar.run.gear_ratio, sidecar.run.occupancy_percent) == ("bldc-12n14p", 5, 5)


@pytest.mark.parametrize(
    ("entry", "si_per_unit"),
    [
        ("{quantity: torque, unit: N*m}", 1.0),
        ("{quantity: torque, unit: mNm}", 1e-3),
        ("{quantity: torque, unit: V, mNm_per_V: 20}", 0.02),
        ("{quantity: torque, unit: V, V_per_Nm: 0.2}", 5.0),
        ("{quantity: force, unit: V, N_per_V: 35.15}", 35.15),
        ("{quantity: current, unit: V, A_per_V: -10}", -10.0),
        ("{quantity: voltage, unit: V}", 1.0),
        ("{quantity: motor_speed, unit: V, rpm_per_V: 300}", 10 * pi),
        ("{quantity: speed, unit: rpm}", pi / 30),
        ("{quantity: speed, unit: V, rad_s_per_V: 2}", 2.0),
        ("{quantity: angle, unit: deg}", pi / 180),
        ("{quantity: angle, unit: count, rad_per_count: 0.001}", 0.001),
        ("{quantity: position, unit: count, counts_per_mm: 200}", 5e-6),
        ("{quantity: torque, unit: FS, Nm_per_FS: 20}", 20.0),
        ("{quantity: tacho, unit: V}", 1.0),
    ],
)
def test_one_unit_in_si(tmp_path: Path, entry: str, si_per_unit: float) -> None:
    sheet = read_sidecar(written(tmp_path, f"channels:\n  x: {entry}\n")).channels["x"]
    assert sheet.si_per_unit == pytest.approx(si_per_unit, rel=1e-15)


def test_further_conditions_and_notes_are_kept(tmp_path: Path) -> None:
    text = "run: {speed_rpm: 60, pole_pairs: 7, notes: [a, b], others: {operator: no, room_degC: 21.5}}\n"
    run = read_sidecar(written(tmp_path, text)).run
    assert run.others == {"pole_pairs": 7, "notes": ["a", "b"], "operator": "no", "room_degC": 21.5}
    assert read_sidecar(written(tmp_path, "notes: new belt\n")).run.others == {"notes": "new belt"}
    assert read_sidecar(written(tmp_path, "notes: a\nrun: {notes: b}\n")).run.others == {"notes": ["a", "b"]}


def test_close_matches_are_keys_of_the_same_mapping(tmp_path: Path) -> None:
    for text, said in (
        ("load: 1\n", "load: unknown key; known are channels, encoder, notes, origin, run, sample_rate_Hz, teeth"),
        ("run: {set_point: {time_s: [0], speed_rpm: [0], rate: 3}}\n", "known are load_Nm, repeats, speed_rpm, time_s"),
        (
            "channels: {a: {quantity: torque, unit: V, Nm_per_V: 1, motor: 3}}\n",
            "known are of, pulses_per_rev, quantity, role, shaft, tare, teeth, truth",
        ),
    ):
        with pytest.raises(InputError, match=said):
            read_sidecar(written(tmp_path, text))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("sample_rate_hz: 25000\n", r"run1\.yaml:1: sample_rate_hz: unknown key; did you mean 'sample_rate_Hz'\?"),
        ("sample_rate_Hz: 0\n", r"run1\.yaml:1: sample_rate_Hz: 0 is out of range; it must be at least 1e-06"),
        ("sample_rate_Hz: '25,6'\n", "sample_rate_Hz: '25,6' is no number; write one, such as 0.5"),
        ("sample_rate_Hz: true\n", "sample_rate_Hz: True is no number; write one, such as 0.5"),
        (
            "channels:\n  a:\n    quantity: torqe\n    unit: V\n    Nm_per_V: 1\n",
            r"run1\.yaml:3: channels\.a\.quantity: 'torqe' is no quantity; did you mean .*'torque'",
        ),
        (
            "channels:\n  a:\n    quantity: torque\n    unit: Nm\n    trth: true\n",
            r"run1\.yaml:5: channels\.a\.trth: unknown key; did you mean 'teeth' or 'truth'",
        ),
        ("channels:\n  a:\n    quantity: torque\n", r"run1\.yaml:2: channels\.a: the key 'unit' is missing"),
        ("channels: {a: 5}\n", r"run1\.yaml:1: channels\.a: "),
        (
            "channels:\n  a:\n    quantity: torque\n    unit: V\n",
            r"run1\.yaml:4: channels\.a\.unit: a torque in V needs its scale; add Nm_per_V: NUMBER",
        ),
        ("channels:\n  a: {quantity: angle, unit: count}\n", r"an? angle in count needs its scale; add counts_per_rev"),
        ("channels:\n  a: {quantity: torque, unit: Nmn}\n", r"add Nm_per_Nmn: NUMBER; .*did you mean .*'Nm'"),
        (
            "channels:\n  a:\n    quantity: torque\n    unit: V\n    Nm_per_mV: 1\n",
            r"run1\.yaml:5: channels\.a\.Nm_per_mV: the scale does not give a torque per 'V'; write Nm_per_V",
        ),
        ("channels:\n  a: {quantity: torque, unit: V, N_per_V: 1}\n", r"N_per_V: the scale does not give a torque"),
        (
            "channels:\n  a: {quantity: current, unit: A, Nm_per_A: 0.1}\n",
            r"Nm_per_A: .* write A_per_A: NUMBER, or quantity: motor_torque, whose scale this is",
        ),
        (
            "channels:\n  a: {quantity: position, unit: count, counts_per_rev: 4096}\n",
            r"counts_per_rev: .* write m_per_count: NUMBER, or quantity: motor_angle",
        ),
        ("channels:\n  a: {quantity: torque, unit: V, Nm_per_V: 0}\n", r"0 cannot be a scale; write a number"),
        ("channels:\n  a: {quantity: torque, unit: V, Nm_per_V: 5 Nm}\n", r"'5 Nm' cannot be a scale"),
        ("channels:\n  a: {quantity: torque, unit: V, Nm_per_V: 1, V_per_Nm: 1}\n", r"there are two scales"),
        ("run: {profile: stedy}\n", r"run1\.yaml:1: run\.profile: 'stedy' is no profile; did you mean 'steady'\?"),
        (
            "run:\n  motor: x\n  gear_rato: 5\n",
            r"run1\.yaml:3: run\.gear_rato: unknown key; did you mean 'gear_ratio'\?",
        ),
        ("run: {speed: 1000}\n", r"run\.speed: unknown key; did you mean 'speed_rpm'\?"),
        ("run: {gear_ratio: -5}\n", "run.gear_ratio: -5 is out of range; it must be at least 1e-06"),
        ("run: {motor_speed_rpm: 1000}\n", r"run\.motor_speed_rpm: unknown key; did you mean 'speed_rpm'"),
        ("run: {bench: 3}\n", r"run\.bench: unknown key; write a further condition as others: {bench: ...}; known are"),
        ("run: {rpm: 3}\n", r"run\.rpm: unknown key; did you mean 'speed_rpm'"),
        (
            "run: {others: {speed_rpm: 3}}\n",
            r"run\.others\.speed_rpm: is no further condition; write it as 'speed_rpm'",
        ),
        ("run: {others: {ratio: 3}}\n", r"run\.others\.ratio: is no further condition; write it as 'gear_ratio'"),
        ("run: {others: 3}\n", r"run\.others: 3 is no mapping; write key: value pairs"),
        ("run: {pole_pairs: 1.5}\n", r"run\.pole_pairs: 1\.5 is no whole number"),
        ("run: {slots: true}\n", r"run\.slots: True is no whole number"),
        ("run: {tacho_pulses_per_motor_turn: 0}\n", r"tacho_pulses_per_motor_turn: 0 is out of range"),
        ("run: {speed_rpm: 1e9}\n", r"run\.speed_rpm: 1000000000\.0 is out of range; it must be at most 1e\+07"),
        ("sample_rate_Hz: 1e29\n", r"sample_rate_Hz: 1e\+29 is out of range; it must be at most 1e\+09"),
        ("sample_rate_Hz: 1e300\n", r"run1\.yaml:1: 1e300 is out of range; no number may be above"),
        ("channels: {a: {quantity: torque, unit: V, Nm_per_V: 1, rol: input}}\n", r"channels\.a\.rol: unknown key"),
        ("run: {occupancy_percent: 101}\n", "run.occupancy_percent: 101 is out of range; it must be at most 100"),
        ("- 1\n", r"run1\.yaml:1: a sidecar holds the keys sample_rate_Hz, channels and run"),
    ],
)
def test_a_slip_is_told_with_its_place(tmp_path: Path, text: str, told: str) -> None:
    with pytest.raises(InputError, match=told) as caught:
        read_sidecar(written(tmp_path, text))
    assert "\n" not in str(caught.value)
