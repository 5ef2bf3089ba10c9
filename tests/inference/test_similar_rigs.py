"""A rig in other units of torque and time has the same residuals: no number of the engine carries N m, Hz or s."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.pump_bench import pump_scenario
from tests.scaled_rigs import Scale, scaled_rig
from torquerig.inference.additions import proposals
from torquerig.inference.context import Context
from torquerig.inference.engine import prepared
from torquerig.inference.features.line_search import FoundLine, search_lines
from torquerig.inference.model_density import model_densities
from torquerig.inference.places import order
from torquerig.simulation.simulator import simulate


def scaled(recording, scale):
    """Return the recording of the similar rig: the same samples at another rate, with another factor."""
    channels = {
        name: replace(one, si_per_unit=one.si_per_unit * (scale.torque if one.quantity == "torque" else 1.0))
        for name, one in recording.channels.items()
    }
    run = replace(recording.run, speed=recording.run.speed * scale.speed)
    return replace(recording, sample_rate=recording.sample_rate * scale.speed, channels=channels, run=run)


@pytest.fixture(scope="module")
def bench(tmp_path_factory):
    scenario = pump_scenario(tmp_path_factory.mktemp("pump"))
    return scenario, [*recorded(scenario)]


def recorded(scenario):
    for index, profile in enumerate(("steady", "ramp")):
        run = replace(scenario.rig.run, speed=1200 * np.pi / 30, profile=profile)
        made = simulate(scenario.rig.at(run), duration=6.0, seed=10 + index, sample_rate=1000.0)
        angle = replace(made.channels["true_motor_angle_rad"], truth=False)
        torque = made.channels["torque_V"]
        yield replace(made, name=f"run{index + 1}", run=run, channels={"torque_V": torque, "angle": angle})


def read(bench, scale):
    scenario, runs = bench
    ready = prepared(replace(scenario, rig=scaled_rig(scenario.rig, scale)), [scaled(one, scale) for one in runs])
    lines = search_lines(ready.runs, ready.known, model_densities(ready.nominal, ready.data))
    return ready, lines


@pytest.fixture(scope="module")
def as_is(bench):
    return read(bench, Scale(1.0, 1.0))


@pytest.mark.parametrize("scale", [Scale(100.0, 1.0), Scale(0.01, 1.0), Scale(1.0, 3.0), Scale(1.0, 0.2)])
def test_a_similar_rig_has_the_same_residuals_and_evidence(bench, as_is, scale):
    one, lines = as_is
    other, found = read(bench, scale)
    assert [run.blocks for run in one.runs] == [run.blocks for run in other.runs]
    assert other.nominal.value.size == one.nominal.value.size
    # a fit ends where a step gains less than 0.02 nats, and sizes of the discrepancy are found on a grid
    assert other.nominal.log_evidence == pytest.approx(one.nominal.log_evidence, abs=0.5)
    factor = {"order": 1.0, "frequency": scale.speed}
    assert [line.place.at for line in found] == pytest.approx(
        [line.place.at * factor[line.place.domain] for line in lines], rel=1e-6
    )
    kinds = [
        sorted((each.mechanism, each.variant, each.kind) for each in proposals(Context(
            ready.nominal, ready.data, (FoundLine(order(1.0), -20.0, 0.0),)
        ))) for ready in (one, other)
    ]  # fmt: skip
    assert kinds[0] == kinds[1]
