"""The axes of figures show the unit of what is measured: N m of a torque, N of a force."""

from math import pi

import numpy as np
import pytest

from torquerig.filters.filter_effect import chain_effect
from torquerig.orders.analysis.angle_resampling import output_turns
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.reporting.figures.evaluation_figure import four_panels
from torquerig.reporting.figures.notch_figure import notch_figure
from torquerig.reporting.figures.order_figure import order_figure, order_picture
from torquerig.reporting.figures.signal_figure import signal_figure
from torquerig.reporting.figures.spectrum_figure import spectrum_figure

RATE, SPEED = 1000.0, 20 * pi
LINES = Kinematics(ratio=1.0).lines()
UNITS = {"torque": ("N*m", "N m"), "force": ("N", "N")}


def recorded(quantity, *, sign=1):
    time = np.arange(4000) / RATE
    values = 2 + np.cos(SPEED * time) + 0.1 * np.random.default_rng(1).normal(size=time.size)
    channels = {"measured": Channel(values=values, quantity=quantity, unit=UNITS[quantity][0])}
    return Recording(sample_rate=RATE, channels=channels, run=Run(speed=sign * SPEED, gear_ratio=1.0))


def labels(figure):
    return [label for axes in figure.axes for label in (axes.get_xlabel(), axes.get_ylabel())]


@pytest.mark.parametrize("quantity", UNITS)
def test_figures_of_recordings_show_the_unit_of_what_is_measured(quantity):
    run = recorded(quantity)
    turns = output_turns(SPEED * run.time(), ratio=1.0)
    figures = [
        four_panels(run, run),
        notch_figure(run, run, levels=chain_effect(run, run, ratio=1, lines=LINES).levels, motor_speed=SPEED),
        spectrum_figure(run, run, lines=LINES, motor_speed=SPEED, ratio=1),
        order_figure(order_picture(run, turns, lines=LINES, found=(), ratio=1.0)),
        signal_figure(run, run, start=0.0, duration=1.0),
    ]
    for figure in figures:
        shown = [label for label in labels(figure) if "[N" in label]
        assert shown
        assert all(label.endswith(f"[{UNITS[quantity][1]}]") for label in shown)


@pytest.mark.parametrize("sign", [1, -1])
def test_a_negative_set_point_keeps_the_axis_of_orders(sign):
    run = recorded("torque", sign=sign)
    figure = spectrum_figure(run, run, lines=LINES, motor_speed=sign * SPEED, ratio=1)
    assert any(child.get_xlabel().startswith("order") for child in figure.axes[0].child_axes)
