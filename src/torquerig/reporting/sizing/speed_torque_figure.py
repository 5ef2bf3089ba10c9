"""A sizing in one figure: operating regions with the duty cycle, and torque over gear ratio."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from torquerig.metrics.sizing.required_torque import mean_speed
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.metrics.sizing.speed_torque import SpeedTorque, speed_torque
from torquerig.reporting.figures.picture import new_figure
from torquerig.scenario.drive_requirement import DriveRequirement
from torquerig.study.ratio_sweep import RatioSweep, SweptGearbox, middle

CONTINUOUS, INTERMITTENT, CYCLE, LIMIT, BARRED = "#2a9d8f", "#e9a23b", "#1f4e79", "#d1495b", "#9aa5b1"
RPM = 30 / np.pi


def sizing_figure(drive: SizedDrive, sweep: RatioSweep | None, *, title: str) -> Figure:
    """Return speed against torque, and, with a ratio sweep, the rms torque against the ratio."""
    figure = new_figure(13.0 if sweep else 7.6, 6.2)
    figure.suptitle(title, x=0.01, ha="left")
    panels = figure.subplots(1, 2 if sweep else 1, squeeze=False)[0]
    draw_regions(panels[0], speed_torque(drive), drive.requirement())
    if sweep is not None:
        draw_ratios(panels[1], sweep)
    return figure


def draw_regions(axes: Axes, regions: SpeedTorque, requirement: DriveRequirement) -> None:
    """Draw both regions with what the catalog leaves open hatched, and the operating points of the cycle."""
    speed = regions.speed * RPM
    low, high = regions.intermittent.T
    axes.fill_between(speed, low, color=INTERMITTENT, alpha=0.22, linewidth=0, label="intermittent, surely")
    axes.fill_between(speed, low, high, facecolor="none", edgecolor=INTERMITTENT, hatch="////", linewidth=0, alpha=0.7,
                      label="intermittent, not known")  # fmt: skip
    low, high = regions.continuous.T
    axes.fill_between(speed, low, color=CONTINUOUS, alpha=0.40, linewidth=0, label="continuous, surely")
    axes.fill_between(speed, low, high, facecolor="none", edgecolor=CONTINUOUS, hatch="\\\\\\\\", linewidth=0,
                      label="continuous, not known")  # fmt: skip
    axes.axhline(regions.drive_limit, color=LIMIT, linewidth=1.1, linestyle="--")
    axes.annotate(f"drive's limit {regions.drive_limit:.3g} N m", (speed[-1], regions.drive_limit), ha="right",
                  va="bottom", color=LIMIT, fontsize=8)  # fmt: skip
    for row, (turned, torque) in enumerate(
        zip(np.abs(requirement.speed) * RPM, np.abs(requirement.torque), strict=True)
    ):
        axes.plot(
            turned, torque, color=CYCLE, linewidth=1.4, marker="o", markersize=4, label="" if row else "the cycle"
        )
    rms = requirement.rms_torque
    axes.plot([mean_speed(requirement) * RPM], [rms], color=CYCLE, marker="D", markersize=8,
              linestyle="", markerfacecolor="white", label=f"rms {rms:.3g} N m at the mean speed")  # fmt: skip
    axes.set(xlabel="motor speed [rpm]", ylabel="motor torque [N m]", xlim=(0, speed[-1]), ylim=(0, None))
    axes.grid(color="#e3e7eb", linewidth=0.6)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=2, fontsize=8, frameon=False)


def draw_ratios(axes: Axes, sweep: RatioSweep) -> None:
    """Draw the closed form over the ratio, and every gearbox of the catalog with its interval."""
    boxes = [one for one in sweep.swept if np.isfinite(middle(one.rms_torque))]
    top = max([one.ratio for one in boxes] + [2.0])
    edge = min(sweep.ideal.best, 10 * top)
    ratios = np.geomspace(1.0, max(1.5 * top, min(1.5 * edge, 8 * top)), 300)
    axes.plot(ratios, [sweep.ideal.rms_torque(one) for one in ratios], color=CYCLE, linewidth=1.5,
              label="alpha-beta: no gearbox inertia, no motor friction")  # fmt: skip
    if ratios[0] <= sweep.ideal.best <= ratios[-1]:
        axes.axvline(sweep.ideal.best, color=CYCLE, linewidth=0.9, linestyle=":")
        axes.annotate(f" ideal {sweep.ideal.best:.3g}:1", (sweep.ideal.best, 0.02), xycoords=("data", "axes fraction"),
                      color=CYCLE, fontsize=8)  # fmt: skip
    _speed_bound(axes, sweep, ratios[-1])
    for exceeds, colour, label in ((False, CONTINUOUS, "gearbox of the catalog"), (True, BARRED, "exceeds a limit")):
        _boxes(axes, [one for one in boxes if bool(one.exceeded) is exceeds], colour=colour, label=label)
    if sweep.best is not None:
        axes.plot([sweep.best.ratio], [middle(sweep.best.rms_torque)], marker="o", markersize=13, linestyle="",
                  markerfacecolor="none", markeredgecolor=LIMIT, label=f"least: {sweep.best.gearbox}")  # fmt: skip
    axes.set(xscale="log", yscale="log", xlim=(0.9, ratios[-1]))
    axes.set(xlabel="ratio, motor turns per output turn", ylabel="rms motor torque [N m]")
    ticks = sorted({1.0, *(one.ratio for one in boxes)} - {21.0})
    axes.set_xticks(ticks, [f"{one:g}" for one in ticks])
    axes.minorticks_off()
    low, high = axes.get_ylim()
    marks = [one for power in range(-4, 4) for one in (10.0**power, 2 * 10.0**power, 5 * 10.0**power)]
    kept = [one for one in marks if low <= one <= high]
    axes.set_yticks(kept, [f"{one:g}" for one in kept])
    axes.grid(color="#e3e7eb", linewidth=0.6)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=2, fontsize=8, frameon=False)


def _speed_bound(axes: Axes, sweep: RatioSweep, edge: float) -> None:
    top = sweep.drive.requirement().top_speed / sweep.drive.ratio
    low, high = (end / top for end in sweep.drive.motor.max_speed.bounds)
    if low < edge:
        axes.axvspan(low, edge, color=LIMIT, alpha=0.10, linewidth=0)
        text = f" too fast from {low:.3g}:1" if high <= low * 1.001 else f" too fast from {low:.3g}..{high:.3g}:1"
        axes.annotate(text, (low, 0.97), xycoords=("data", "axes fraction"), va="top", color=LIMIT, fontsize=8)


def _boxes(axes: Axes, boxes: list[SweptGearbox], *, colour: str, label: str) -> None:
    if not boxes:
        return
    middles = np.array([middle(one.rms_torque) for one in boxes])
    lows = np.array([one.rms_torque.value if one.rms_torque.low is None else one.rms_torque.low for one in boxes])
    highs = np.array([one.rms_torque.value if one.rms_torque.high is None else one.rms_torque.high for one in boxes])
    axes.errorbar([one.ratio for one in boxes], middles, yerr=[middles - lows, highs - middles], fmt="o", color=colour,
                  markersize=5, capsize=3, linewidth=1, label=label)  # fmt: skip
