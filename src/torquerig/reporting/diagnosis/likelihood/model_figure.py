"""Recording, nominal model and completed model in one picture: spectrum with its lines, and mean torques."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from torquerig.inference.answer.curves import LevelCurves, RunCurves, SpectrumCurves
from torquerig.reporting.diagnosis.curve_colours import AFTER, BEFORE, RECORDED
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.picture import new_figure

_DECADES = 5.5  # below the highest peak
_COLUMNS = 600  # of pixels that a spectrum is drawn in
_FOUND = "#b3261e"
_MOST_NAMES = 12


def model_figure(one: RunCurves, *, alone: bool, unit: str) -> Figure:
    """Return the spectrum above the mean torques of one run; ``alone`` where nothing was added to the model."""
    panels = 1 if one.spectrum is None else 2
    figure = new_figure(10.5, 3.0 * panels + 0.4)
    axes = figure.subplots(panels, 1, squeeze=False, height_ratios=[2.0, 1.0][-panels:])[:, 0]
    if one.spectrum is not None:
        _draw_spectrum(axes[0], one.spectrum, alone=alone, unit=unit)
    _draw_levels(axes[-1], one.levels, alone=alone, unit=unit)
    for each in axes:
        each.grid(color="#e3e7eb", linewidth=0.6)
        each.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, frameon=False)
    return figure


def csv_of(one: RunCurves, *, unit: str) -> str:
    """Return the numbers of the picture as CSV text: the spectrum's bands and lines, then the mean torques."""
    rows = ["kind,at,at_unit,recording,nominal,completed,unit"]
    spectrum, levels, name = one.spectrum, one.levels, unit.replace("*", " ")
    if spectrum is not None:
        for at, measured, low, high in zip(
            spectrum.line, spectrum.line_measured, spectrum.line_nominal, spectrum.line_completed, strict=True
        ):
            rows.append(f"line amplitude,{at:.6g},Hz,{measured:.6g},{low:.6g},{high:.6g},{name}")
        for at, low, high in zip(spectrum.band, spectrum.band_nominal, spectrum.band_completed, strict=True):
            rows.append(f"amplitude in a bin,{at:.6g},Hz,,{low:.6g},{high:.6g},{name}")
    for at, measured, low, high in zip(levels.time, levels.measured, levels.nominal, levels.completed, strict=True):
        rows.append(f"mean torque,{at:.6g},s,{measured:.6g},{low:.6g},{high:.6g},{name}")
    return "\n".join(rows) + "\n"


def _draw_spectrum(axes: Axes, shown: SpectrumCurves, *, alone: bool, unit: str) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    drawn = envelope(shown.frequency, shown.measured, columns=_COLUMNS, logarithmic=True)
    axes.plot(*drawn, color=RECORDED, linewidth=0.8, label="recording")
    seen = shown.line_measured > 0
    axes.plot(shown.line[seen], shown.line_measured[seen], "o", color="#5d6b78", markersize=5, fillstyle="none",
              label="recording: lines")  # fmt: skip
    nominal = "calibrated model" if alone else "nominal, calibrated"
    axes.plot(shown.band, shown.band_nominal, color=BEFORE, linewidth=1.4, label=f"{nominal}: noise")
    axes.plot(shown.line, shown.line_nominal, "x", color=BEFORE, markersize=6, label=f"{nominal}: lines")
    if not alone:
        axes.plot(shown.band, shown.band_completed, color=AFTER, linewidth=1.0, label="completed: noise")
        axes.plot(shown.line, shown.line_completed, "+", color=AFTER, markersize=8, label="completed: lines")
    top = float(shown.measured.max())
    axes.set_ylim(top * 10**-_DECADES, top * 30)
    axes.set_xlim(float(shown.frequency[0]), float(shown.frequency[-1]))
    axes.set_xlabel("frequency [Hz]")
    axes.set_ylabel(f"amplitude [{unit.replace('*', ' ')}]")
    axes.set_title(f"{shown.name}, motor at {shown.rpm:.0f} rpm", loc="left", fontsize=8)
    named = [(at, name) for at, name in zip(shown.line.tolist(), shown.line_names, strict=True) if name]
    for at, name in named[:_MOST_NAMES]:
        axes.axvline(at, color=_FOUND, linewidth=0.6, alpha=0.4)
        axes.text(at, top * 25, f"{name}  {at:.4g} Hz", rotation=90, va="top", ha="right", fontsize=7, color=_FOUND)


def _draw_levels(axes: Axes, shown: LevelCurves, *, alone: bool, unit: str) -> None:
    label = "_"
    for at, held in zip(shown.time.tolist(), shown.held_out.tolist(), strict=True):
        if held:
            half = 0.5 * float(shown.time[-1] - shown.time[0]) / max(shown.time.size - 1, 1)
            label = "held out" if label == "_" else "_held out"
            axes.axvspan(at - half, at + half, color="#fff4d6", zorder=0, label=label)
    axes.plot(shown.time, shown.measured, "o", color=RECORDED, markersize=4, label="recording, means")
    axes.plot(shown.time, shown.nominal, color=BEFORE, linewidth=1.4, label="calibrated model")
    low, high = shown.completed - 2 * shown.scatter, shown.completed + 2 * shown.scatter
    axes.fill_between(shown.time, low, high, color=AFTER, alpha=0.12, linewidth=0, label="95 % of a true model")
    if not alone:
        axes.plot(shown.time, shown.completed, color=AFTER, linewidth=1.0, label="completed model")
    axes.set_xlabel("time [s]")
    axes.set_ylabel(f"mean [{unit.replace('*', ' ')}]")
