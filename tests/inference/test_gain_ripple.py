"""Lines in proportion to the torque: what a gain that varies makes of the lines."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.benches import PUMP, bench
from tests.inference.drawn_runs import drawn_run, steady
from torquerig import mechanisms
from torquerig.inference.additions.gain_ripple import _is_known
from torquerig.inference.features.run_features import run_features
from torquerig.inference.places import order
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.inference.prediction.rig_lines import gain_lines
from torquerig.linear_twin.twin import Twin


@pytest.mark.parametrize(("place", "at"), [({"order_motor": 3.3}, 66.0), ({"frequency": 17.0}, 17.0)])
@pytest.mark.parametrize(("occupancy", "load"), [(0.0, 1.0), (100.0, 2.0)])
def test_a_gain_that_varies_makes_lines_in_proportion_to_the_torque(place, at, occupancy, load, tmp_path):
    speed = steady(1200)
    rig = bench(PUMP, tmp_path).rig + mechanisms.GainRipple(name="gain", depths=(0.02, 0.01), **place)
    loaded = rig.at(replace(rig.run, speed=speed[0], occupancy_percent=occupancy))
    (lines,) = gain_lines(Twin(loaded), run_features(drawn_run(1, speed=speed), []))
    torque = load + 0.003 * speed[0]  # and the viscous drag of the pump
    assert lines.frequency[:, 0] == pytest.approx([at, 2 * at], rel=1e-3)
    assert np.sqrt(lines.square[:, 0]) == pytest.approx([0.02 * torque, 0.01 * torque], rel=0.02)


@pytest.mark.parametrize("amplitude", [0.0, 0.5])
def test_a_line_that_the_model_has_is_known(amplitude, tmp_path):
    rig = bench(PUMP, tmp_path).rig
    rig = rig + mechanisms.TorqueRipple(name="line", at="pump", group="mechanical", amplitudes={3.3: amplitude})
    seen = run_features(drawn_run(1, speed=steady(1200), orders={3.3: 0.5}), [order(3.3)])
    fit = SimpleNamespace(expected=[expected_run(rig.at(replace(rig.run, speed=40 * np.pi)), seen)])
    context = SimpleNamespace(data=SimpleNamespace(seen=[seen]), fit=fit)
    assert _is_known(context, order(3.3)) is bool(amplitude)
