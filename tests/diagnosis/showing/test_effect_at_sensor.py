"""How much the findings change the reading, against closed forms; no diagnosis is run."""

from dataclasses import replace
from math import pi, sqrt
from types import SimpleNamespace

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.diagnosis.showing.effect_at_sensor import effect_at_sensor
from torquerig.document import read_document
from torquerig.mechanisms import MainsInterference, NoiseHump, QuadraticDrag
from torquerig.scenario.reading import read_scenario

SPEED = 1000 * pi / 30
MAINS = MainsInterference(name="found", frequency=50.0, amplitudes=(0.05,))
DRAG = QuadraticDrag(name="found", at="wear_part", coefficient=0.002)


@pytest.fixture(scope="module")
def rig():
    made = read_scenario(read_document(shipped_scenarios() / "wear_rig.yaml"), load_catalog(shipped_folder()), seed=1)
    return made.rig.at(replace(made.rig.run, speed=SPEED, occupancy_percent=5.0))


def found_in(rig, *parts, speeds=(SPEED,), described=()):
    """An outcome whose calibrated model has other ripple and stiffness than the completed one, as fits give it."""
    completed = rig
    for part in (*parts, *described):
        completed = completed + part
    ripple = rig.part("motor.mechanical")
    bent = rig.changed(replace(ripple, amplitudes={order: 3 * size for order, size in ripple.amplitudes.items()}))
    runs = [
        SimpleNamespace(
            name=f"run{number}.parquet",
            recording=SimpleNamespace(duration=2.0, sample_rate=5000.0, run=replace(rig.run, speed=speed)),
        )
        for number, speed in enumerate(speeds, start=1)
    ]
    accepted = tuple(SimpleNamespace(description="a hump of noise", parts=(one,)) for one in described)
    return SimpleNamespace(
        diagnosis=SimpleNamespace(findings=("found",), fit=SimpleNamespace(by_twin=False)), completed=completed,
        after=SimpleNamespace(accepted=accepted),
        before=SimpleNamespace(runs=runs, model=SimpleNamespace(rig=bent)),
    )  # fmt: skip


def test_a_sine_on_the_signal_changes_it_by_its_amplitude_over_root_two_whatever_the_calibration(rig):
    effect = effect_at_sensor(found_in(rig, MAINS), nominal=rig, seed=0)
    assert effect.rms == pytest.approx(0.05 / sqrt(2), rel=0.01)
    assert effect.sentence == f"The findings change the reading by {effect.rms:.3g} N m rms (simulated)."


def test_a_drag_changes_the_mean_by_coefficient_times_square_of_the_speed_in_the_fastest_run(rig):
    effect = effect_at_sensor(found_in(rig, DRAG, speeds=(SPEED / 2, SPEED)), nominal=rig, seed=0)
    assert effect.rms == pytest.approx(0.002 * (SPEED / 5) ** 2, rel=0.05)  # the lines shift in time by some degrees
    assert "rms in run2.parquet (simulated)" in effect.sentence


def test_an_effect_without_a_name_is_no_finding(rig):
    hump = NoiseHump(name="nameless", frequency=400.0, rms=0.3)
    effect = effect_at_sensor(found_in(rig, MAINS, described=(hump,)), nominal=rig, seed=0)
    assert effect.rms == pytest.approx(0.05 / sqrt(2), rel=0.01)
