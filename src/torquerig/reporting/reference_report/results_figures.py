"""Figures 4.1 to 4.12 of the reference report, drawn from simulated readings."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np
from matplotlib.figure import Figure

from torquerig.filters.filter_effect import chain_effect
from torquerig.orders.kinematics.kinematic_lines import KinematicLine
from torquerig.recordings.recording import Recording, random_for
from torquerig.recordings.spectrum import amplitude_spectrum
from torquerig.reporting.figures.envelope import envelope
from torquerig.reporting.figures.evaluation_figure import four_panels
from torquerig.reporting.figures.families import COLOURS
from torquerig.reporting.figures.page_picture import Picture
from torquerig.reporting.figures.picture import new_figure, picture
from torquerig.reporting.figures.signal_figure import signal_figure
from torquerig.reporting.figures.spectrum_figure import AFTER, spectrum_figure
from torquerig.study.reference_report.filter_steps import report_filter_steps
from torquerig.study.reference_report.half_power import half_power_frequency
from torquerig.study.reference_report.mechanical import HIGH, LOW
from torquerig.study.reference_report.results import ReportResults
from torquerig.synthetic.control_signal import control_signal

_TOP = 620.0  # [Hz]
_SHOWN = 3.0  # [s] of the readings over time
_NOTHING = 0.5  # percentage points
_CONTROL = 0.01  # [N m] amplitude of every sine of the control signal


def results_pictures(results: ReportResults) -> tuple[Picture, ...]:
    """Return all pictures, in the order of the report."""
    low, speed, ratio = results.low, results.rig.scenario.rig.run.speed or 0.0, results.rig.kinematics.ratio
    lines = results.chain.lines
    pair = partial(pair_figure, lines=lines, motor_speed=speed)
    first = spectrum_figure(low, low, lines=lines, motor_speed=speed, ratio=ratio, highest=1600.0)
    return (
        picture(first, caption=f"Figure 4.1: spectrum of the unfiltered torque at {LOW:g} % occupancy, with the "
                "report's lines, each at the frequency of the report's equations.",
                alt_text="amplitude spectrum of the torque with its lines"),
        picture(pair((f"{HIGH:g} % occupancy", results.high), (f"{LOW:g} % occupancy", low)),
                caption="Figures 4.2 and 4.3: spectrum at high and low load. The report reads a drop of 59 % of the "
                f"mechanical noise; the first line of the output shaft falls here by {results.drop.percent:.1f} %.",
                alt_text="amplitude spectra at high and at low load"),
        _control(results, speed),
        _sizes(results, speed),
        *_steps(results),
        *_reading(results),
    )  # fmt: skip


def pair_figure(
    upper: tuple[str, Recording], lower: tuple[str, Recording], *, lines: tuple[KinematicLine, ...], motor_speed: float,
    logarithmic: bool = True,
) -> Figure:  # fmt: skip
    """Return two amplitude spectra on the same axes, without a window as in the report, lines marked by their cause."""
    figure = new_figure(10.5, 4.8)
    panels = figure.subplots(2, 1, sharex=True, sharey=True)
    peak, floor = 0.0, np.inf
    for axes, (name, recording) in zip(panels, (upper, lower), strict=True):
        frequencies, amplitudes = amplitude_spectrum(recording.torque(), recording.sample_rate)
        kept = (frequencies >= 1.0) & (frequencies <= _TOP)
        axes.plot(*envelope(frequencies[kept], amplitudes[kept], columns=900), color=AFTER, linewidth=0.6)
        peak, floor = max(peak, float(amplitudes[kept].max())), min(floor, float(np.median(amplitudes[kept])))
        axes.set_ylabel(f"{name}\namplitude [N m]", fontsize=8)
        axes.grid(axis="y", color="#e3e7eb", linewidth=0.6)
        for line in lines:
            if line.frequency(motor_speed) <= _TOP:
                axes.axvline(
                    line.frequency(motor_speed), color=COLOURS[line.family], linewidth=0.7, alpha=0.5, zorder=0.5
                )
    if logarithmic:
        panels[0].set_yscale("log")
        panels[0].set_ylim(floor / 30, peak * 2)
    panels[1].set_xlim(0, _TOP)
    panels[1].set_xlabel("frequency [Hz]")
    return figure


def _control(results: ReportResults, speed: float) -> Picture:
    low = results.low
    values = control_signal(low.samples, amplitude=_CONTROL, rng=random_for(results.rig.seed, "control signal"))
    before = low.with_values(low.torque_name(), values / low.channels[low.torque_name()].si_per_unit)
    figure = pair_figure(("control signal", before), ("filtered", results.chain.apply(before)),
                         lines=results.chain.lines, motor_speed=speed, logarithmic=False)  # fmt: skip
    return picture(figure, alt_text="spectrum of the control signal before and after the filter",
                   caption="Figures 4.4 and 4.5: the control signal, all frequencies at equal amplitude, before and "
                   "after the filter: no signal remains in the bands, and the signal outside them is "
                   "unchanged.")  # fmt: skip


def _sizes(results: ReportResults, speed: float) -> Picture:
    chain, lines = results.chain, results.chain.lines
    names = [f"{1e3 * (one.run.particle_size or 0):g} mm" for one in (results.small, results.large)]
    bulk = [half_power_frequency(chain.apply(one)) for one in (results.small, results.large)]
    figure = pair_figure((names[0], results.small), (names[1], results.large), lines=lines, motor_speed=speed)
    return picture(figure, alt_text="amplitude spectra with small and with large particles",
                   caption=f"Figures 4.6 and 4.7: spectrum with the smallest and the largest particles at "
                   f"{results.fit.occupancy:g} % occupancy. The report expected higher frequencies with small "
                   f"particles "
                   "and found no clear change. Here half of the power after the filter lies below "
                   f"{bulk[0]:.1f} Hz with {names[0]} and below {bulk[1]:.1f} Hz with {names[1]}.")  # fmt: skip


def _steps(results: ReportResults) -> list[Picture]:
    made: list[Picture] = []
    before = 0.0
    for number, chain in zip((8, 9, 10), report_filter_steps(results.rig.kinematics), strict=True):
        after = chain.apply(results.low)
        cut = chain_effect(results.low, after, ratio=results.rig.kinematics.ratio).std_reduction_percent
        caption = (
            f"Figure 4.{number}: {chain.name} removed, {len(chain.lines)} bands: the standard deviation falls by "
            f"{cut:.1f} % "
            f"over the whole recording ({_SHOWN:g} s are drawn)."
        )
        if made and cut - before < _NOTHING:
            caption += " The last bands have no effect: this rig has no line there, but the report has."
        figure = four_panels(_start(results.low), _start(after))
        made.append(picture(figure, alt_text="original, filtered, both, and their rolling means", caption=caption))
        before = cut
    return made


def _reading(results: ReportResults) -> tuple[Picture, ...]:
    low, after, cell = results.low, results.chain.apply(results.low), results.cells[0]
    raw = f"Figure 4.11: the torque at {LOW:g} % occupancy without filter, and the true load."
    filtered = (
        f"Figure 4.12: the same filtered; the standard deviation falls by {cell.cell.cut:g} % in the report and by "
        f"{cell.cut:.1f} % here ({cell.lowest:.1f} to {cell.highest:.1f} % over several runs)."
    )
    first, last = (signal_figure(low, one, start=1.0, duration=_SHOWN) for one in (low, after))
    return (
        picture(first, alt_text="the torque and the true load over time", caption=raw),
        picture(last, alt_text="the torque before and after the filter", caption=filtered),
    )


def _start(recording: Recording) -> Recording:
    """Return the first seconds of a recording."""
    count = round(_SHOWN * recording.sample_rate)
    channels = {name: replace(one, values=one.values[:count]) for name, one in recording.channels.items()}
    return replace(recording, channels=channels)
