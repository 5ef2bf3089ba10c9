"""Lines of a wandering speed near a sharp resonance, against the simulation of the rig."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.pump_bench import SCENARIO
from torquerig import mechanisms
from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import edited
from torquerig.inference.features.run_features import run_features
from torquerig.inference.measured_run import measured_runs
from torquerig.inference.places import order
from torquerig.inference.prediction import swayed_response
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.linear_twin.twin import Twin, passed
from torquerig.recordings.recording import Channel
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

ORDER, RATE = 7.0, 2000.0
LINE = mechanisms.TorqueRipple(name="line", at="pump", group="mechanical", amplitudes={ORDER: 0.1})


def resonant(folder, *, wander, is_sharp=True):
    """Return the pump bench, the features of a run whose wandering line is at its mode, and the mode [Hz]."""
    path = folder / "scenario.yaml"
    sharp = SCENARIO.replace("damping: 0.5 N*m*s/rad", "damping: 0.03 N*m*s/rad").replace("kp: 0.4", "kp: 0.04")
    path.write_text(sharp if is_sharp else SCENARIO, encoding="utf-8")
    rig = read_scenario(edited(path, ()), catalog_for(path, ()), seed=0).rig + LINE
    grid = np.linspace(60.0, 300.0, 4801)
    (line,) = [each for each in Twin(rig).lines() if each.order == ORDER]
    mode = float(grid[np.argmax(np.abs(passed([line.transfer], grid[None])[0]))])
    run = replace(rig.run, speed=2 * np.pi * mode / ORDER)
    made = simulate(rig.at(run), duration=30.0, seed=3, sample_rate=RATE, wander=wander)
    angle = Channel(values=made.channels["true_motor_angle_rad"].values, quantity="motor_angle", unit="rad")
    channels = {"torque_V": made.channels["torque_V"], "angle_rad": angle}
    recording = replace(made, name="run1.parquet", run=run, channels=channels)
    return rig, run_features(measured_runs([recording], rig)[0], [order(1.0), order(ORDER)]), mode


@pytest.mark.parametrize("wander", [0.004, 0.015])
def test_what_a_wander_takes_from_a_line_stands_about_it(tmp_path, wander):
    rig, seen, mode = resonant(tmp_path, wander=wander)
    expected = expected_run(rig, seen)
    constant = expected_run(rig, replace(seen, run=replace(seen.run, has_encoder=False, followed=np.inf)))
    assert expected.line_power[0, 1] < 0.95 * constant.line_power[0, 1]
    assert seen.lines.power[0, 1] == pytest.approx(expected.line_power[0, 1], rel=0.15)
    near = np.abs(np.log(seen.bands.middle / mode)) < 0.2
    shown = near & np.isfinite(seen.band_power[0])
    assert shown.sum() >= 2
    assert np.log(expected.density[0, shown] / constant.density[0, shown]).max() > 1.0
    assert np.log(seen.band_power[0, shown]) == pytest.approx(np.log(expected.density[0, shown]), abs=0.5)


def test_a_wander_below_a_flat_response_changes_nothing(tmp_path):
    rig, seen, _ = resonant(tmp_path, wander=0.004, is_sharp=False)
    constant = replace(seen, run=replace(seen.run, has_encoder=False, followed=np.inf))
    assert expected_run(rig, seen).line_power == pytest.approx(expected_run(rig, constant).line_power, rel=0.03)
    assert seen.lines.power[0, 1] == pytest.approx(expected_run(rig, seen).line_power[0, 1], rel=0.15)


def test_what_is_kept_of_a_wandering_line_follows_the_response_and_not_its_size(tmp_path, monkeypatch):
    rig, seen, _ = resonant(tmp_path, wander=0.004)
    made, behind = list[object](), swayed_response._behind
    monkeypatch.setattr(swayed_response, "_behind", lambda *args: made.append(args) or behind(*args))
    first = expected_run(rig, seen)
    stronger = expected_run(rig.changed(replace(LINE, amplitudes={ORDER: 0.2})), seen)
    assert len(made) == 1
    assert stronger.line_power[0, 1] == pytest.approx(4 * first.line_power[0, 1])
    heavier = rig.changed(replace(rig.part("pump"), inertia=1.1 * rig.part("pump").inertia))
    assert expected_run(heavier, seen).line_power == pytest.approx(expected_run(heavier, replace(seen)).line_power)
    assert len(made) > 1
