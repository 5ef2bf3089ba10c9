"""Lines of one order of the motor: one phase between them in all runs."""

from __future__ import annotations

from math import pi
from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.benches import FREE, GEARED, bench
from torquerig.inference.prediction.rig_lines import _together
from torquerig.inference.shared_orders import phases, with_phases
from torquerig.mechanisms import TorqueRipple


@pytest.fixture
def rig(tmp_path):
    motor = TorqueRipple(name="motor_lines", at="motor", group="mechanical", amplitudes={1: 0.01, 2: 0.02, 4: 0.01})
    pump = TorqueRipple(name="pump_lines", at="pump", group="mechanical", amplitudes={2: 0.03, 3: 0.01, 4: 0.01})
    return bench(FREE, tmp_path).rig + motor + pump


def test_lines_that_share_order_and_shaft_have_a_phase_between_them(rig):
    free = with_phases(rig)
    assert free.part("motor_lines").phases == {2: 0.0, 4: 0.0}
    assert [knob.name for knob in phases(free)] == ["pump_lines.phases.2", "pump_lines.phases.4"]
    assert not [*phases(rig)]


def test_a_gear_holds_the_phase_between_lines_of_two_shafts(tmp_path):
    motor = TorqueRipple(name="motor_lines", at="motor", group="mechanical", amplitudes={5: 0.01, 6: 0.01})
    pump = TorqueRipple(name="pump_lines", at="pump", group="mechanical", amplitudes={5: 0.03, 34: 0.02})
    free = with_phases(bench(GEARED, tmp_path).rig + motor + pump)  # the pump turns once in 6.8 turns of the motor
    assert free.part("motor_lines").phases == {5: 0.0}
    assert free.part("pump_lines").phases == {34: pytest.approx(0.5 * pi)}
    assert [knob.name for knob in phases(free)] == ["pump_lines.phases.34"]


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_waves_of_known_phases_are_summed(direction):
    lines = [SimpleNamespace(order=order, phase=phase) for order, phase in ((2.0, 0.0), (2.0, 0.6), (2.0, None))]
    passed = np.array([[1.0 + 1.0j], [0.5j], [0.3]])
    sums = _together(lines, passed, np.full(1, direction))
    assert np.abs(sums[:, 0]) == pytest.approx([abs(1 + 1j + 0.5j * np.exp(0.6j * direction)), 0.0, 0.3])


def test_lines_that_oppose_each_other_cancel():
    lines = [SimpleNamespace(order=2.0, phase=phase) for phase in (0.0, pi)]
    assert np.abs(_together(lines, np.ones((2, 3), dtype=complex), np.ones(3))).max() < 1e-12
