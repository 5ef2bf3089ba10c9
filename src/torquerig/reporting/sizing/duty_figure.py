"""A duty cycle: speed and torque, temperatures of the settled cycle, and warm-up from cold."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from torquerig.reporting.figures.picture import new_figure
from torquerig.thermal.motor_duty import MotorDuty
from torquerig.thermal.motor_variants import ThermalVariants
from torquerig.thermal.temperature_bands import Band, settled_band, warm_up

SPEED, TORQUE, WINDING, HOUSING, LIMIT = "#5b6b7a", "#1f77b4", "#d1495b", "#7a5195", "#333333"


def duty_figure(duty: MotorDuty, copies: ThermalVariants, *, ambient: float, title: str) -> Figure:
    """Return three panels, the lower two with bands over the range of the data, and the limit hatched."""
    figure = new_figure(10.5, 7.6)
    cycle, settled, warming = figure.subplots(3, 1)
    _speed_and_torque(cycle, duty)
    cycle.set_title(title, loc="left")
    band = settled_band(duty, copies, ambient=ambient)
    if band is None:
        settled.text(0.5, 0.5, "no settled cycle: thermal runaway", transform=settled.transAxes, ha="center")
        settled.set_axis_off()
    else:
        _temperatures(settled, band, copies, unit=1.0)
        settled.set_xlabel("time within the settled cycle [s]")
        settled.set_xlim(0, duty.length)
    _temperatures(warming, warm_up(duty, copies, ambient=ambient), copies, unit=60.0)
    warming.set_xlabel("time from a cold start [min], highest of each cycle")
    warming.set_xlim(left=0)
    return figure


def _speed_and_torque(axes: Axes, duty: MotorDuty) -> None:
    edges = np.concatenate([[0.0], np.cumsum(duty.duration)])
    axes.stairs(np.sqrt(duty.torque_square), edges, color=TORQUE, linewidth=1.4, label="torque, rms")
    axes.axhline(duty.rms_torque, color=TORQUE, linewidth=0.9, linestyle="--", label="rms of the cycle")
    axes.set_ylabel("motor torque [N m]")
    axes.set_ylim(bottom=0)
    axes.set_xlim(0, duty.length)
    axes.set_xlabel("time within the cycle [s]")
    axes.grid(color="#e3e7eb", linewidth=0.6)
    speed = axes.twinx()
    speed.stairs(duty.speed * 30 / np.pi, edges, color=SPEED, linewidth=1.0, label="speed")
    speed.set_ylabel("motor speed [rpm]", color=SPEED)
    speed.set_ylim(bottom=0)
    handles = [one for part in (axes, speed) for one in part.get_legend_handles_labels()[0]]
    axes.legend(handles=handles, loc="center left", bbox_to_anchor=(1.1, 0.5), fontsize=8, frameon=False)


def _temperatures(axes: Axes, band: Band, copies: ThermalVariants, *, unit: float) -> None:
    limits = [one.limit for one in copies.corners]
    top = 1.6 * max(limits)  # temperatures beyond are not drawn, to keep the scale readable
    time = band.time / unit
    axes.fill_between(time, np.minimum(band.low, top), np.minimum(band.high, top), color=WINDING, alpha=0.18,
                      linewidth=0, label="winding, range of the data")  # fmt: skip
    axes.plot(time, np.where(band.winding < top, band.winding, np.nan), color=WINDING, linewidth=1.6,
              label="winding, nominal")  # fmt: skip
    axes.plot(time, np.where(band.housing < top, band.housing, np.nan), color=HOUSING, linewidth=1.1,
              label="housing, nominal")  # fmt: skip
    axes.axhspan(min(limits), max(limits), facecolor="none", edgecolor=LIMIT, hatch="////", linewidth=0, alpha=0.35,
                 label="limit of the winding")  # fmt: skip
    axes.set_ylabel("temperature [°C]")
    axes.set_ylim(top=min(top, max(1.06 * max(limits), float(np.nanmax(np.minimum(band.high, top))) * 1.03)))
    axes.grid(color="#e3e7eb", linewidth=0.6)
    axes.legend(loc="center left", bbox_to_anchor=(1.1, 0.5), fontsize=8, frameon=False)
