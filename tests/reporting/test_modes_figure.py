"""The picture of modes, lines and loop: what must stand in it."""

from __future__ import annotations

from math import pi

import pytest

from torquerig.mechanisms import GearMesh, TorqueRipple
from torquerig.recordings.run import Run
from torquerig.reporting.figures.modes_figure import modes_figure
from torquerig.reporting.figures.picture import svg
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear, Motor, SpeedController
from torquerig.simulation.twin.linear_twin import Twin, twin_of


def twin(*effects: Part) -> Twin:
    parts = (
        Motor(name="motor", inertia=1.5e-4, viscous=1e-3, torque_limit=5.0),
        Gear(name="gear", after="motor", ratio=4.0, stiffness=9e3, damping=2.0, output_inertia=6e-4),
        Coupling(name="sensor", after="gear", stiffness=1100, damping=0.3, inertia=1e-4),
        Body(name="wheel", after="sensor", inertia=2e-3, viscous=0.02),
        *effects,
    )
    return twin_of(Rig(parts, Run(speed=800 * pi / 30), measured="sensor"))


@pytest.mark.long
def test_modes_set_point_and_numbered_crossings_stand_in_the_campbell_diagram() -> None:
    made = twin(
        SpeedController(name="controller", kp=0.05, ki=0.5),
        TorqueRipple(name="cogging", at="motor", group="cogging", amplitudes={6: 0.02, 12: 0.001}),
        GearMesh(name="mesh", gear="gear", order_output=84, transmission_error=(1e-5,)),
    )
    lines = made.order_lines()
    found = made.crossings(lines, top_speed=200.0)
    figure = modes_figure(made, lines, found, top_speed=200.0)
    campbell, transfers, gain, phase = figure.axes
    words = [text.get_text() for text in campbell.texts]
    assert {"1", "2", " set-point", "M6", "M12", "M21"} <= set(words)
    assert sum(word.startswith("mode ") for word in words) == len(made.modes())
    assert [text.get_text() for text in campbell.get_legend().get_texts()] == ["cogging", "mesh"]
    assert len(transfers.lines) == 4
    assert gain.get_ylabel() == "loop gain [1]"
    assert phase.get_xlabel() == "frequency [Hz]"
    assert svg(figure) == svg(modes_figure(made, lines, found, top_speed=200.0))


def test_a_rig_without_loop_and_lines_has_modes_and_transfers_alone() -> None:
    made = twin()
    figure = modes_figure(made, (), (), top_speed=200.0)
    assert len(figure.axes) == 2
