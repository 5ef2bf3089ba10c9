"""The picture of a duty cycle: three panels, bands that hold the nominal curve, and a word where nothing settles."""

from __future__ import annotations

from functools import cache

import numpy as np

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.reporting.sizing.duty_figure import duty_figure
from torquerig.thermal.motor_duty import MotorDuty
from torquerig.thermal.motor_variants import thermal_variants
from torquerig.thermal.temperature_bands import settled_band, warm_up


@cache
def copies():
    return thermal_variants(load_catalog(shipped_folder()).motor("HDS6A-0104A"))


def on_and_off(torque: float) -> MotorDuty:
    return MotorDuty(duration=np.array([60.0, 120.0]), torque_square=np.array([torque**2, 0.0]),
                     speed=np.array([100.0, 0.0]), speed_square=np.array([1e4, 0.0]), peak_torque=torque)  # fmt: skip


def test_bands_hold_the_nominal_motor_and_the_way_ends_in_the_settled_cycle():
    duty = on_and_off(1.0)
    settled, way = settled_band(duty, copies(), ambient=40.0), warm_up(duty, copies(), ambient=40.0)
    for band in (settled, way):
        assert np.all(band.low <= band.winding)
        assert np.all(band.winding <= band.high)
    # after four slow time constants of the slowest copy e^-4 of the way is left at most
    left = settled.winding.max() - way.winding[-1]
    assert 0 <= left <= np.exp(-4) * (settled.winding.max() - 40.0)


def test_the_picture_has_three_panels_and_says_runaway():
    figure = duty_figure(on_and_off(1.0), copies(), ambient=40.0, title="on and off")
    assert [axes.get_xlabel().split(" [")[0] for axes in figure.axes if axes.get_xlabel()] == [
        "time within the cycle", "time within the settled cycle", "time from a cold start",
    ]  # fmt: skip
    hot = duty_figure(on_and_off(9.0), copies(), ambient=40.0, title="too hot")
    assert any("thermal runaway" in text.get_text() for axes in hot.axes for text in axes.texts)
