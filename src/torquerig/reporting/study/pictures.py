"""The figures of a study's page."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.filters.chains.filter_chain import Chain, report_filter_code_chain
from torquerig.filters.filter_effect import FilterEffect, chain_effect
from torquerig.orders.angle.tacho import recorded_motor_angle
from torquerig.orders.kinematics.order_report_text import name_of
from torquerig.reporting.figures.error_figure import error_figure
from torquerig.reporting.figures.notch_figure import notch_figure
from torquerig.reporting.figures.page_picture import Picture, plot_name
from torquerig.reporting.figures.picture import picture
from torquerig.reporting.figures.shares_figure import shares_figure
from torquerig.reporting.figures.signal_figure import signal_figure
from torquerig.reporting.figures.spectrum_figure import spectrum_figure
from torquerig.reporting.layout import Table, number, words
from torquerig.reporting.moving.signal_plot import signal_plot
from torquerig.reporting.moving.spectrum_plot import spectrum_plot
from torquerig.reporting.study.csv_tables import shares_csv
from torquerig.reporting.study.picture_csv import errors_csv, levels_csv
from torquerig.reporting.study.tables import effort_text
from torquerig.scenario.kinematics import kinematics_of
from torquerig.study.candidates import scenario_of

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import Kinematics
    from torquerig.recordings.recording import Recording
    from torquerig.study.results import DriveResult, StudyRuns

HARMONICS = 2  # of each family, marked in the spectra: more would hide the curves


@dataclass(frozen=True)
class Filtered:
    """The reading of one drive before and after a chain."""

    drive: DriveResult
    chain: Chain
    kinematics: Kinematics
    before: Recording
    after: Recording

    @property
    def motor_speed(self) -> float:
        """The mean measured motor speed [rad/s]; the set-point where no channel has it."""
        angle = recorded_motor_angle(self.before, ratio=self.kinematics.ratio)
        if angle is None:
            return self.drive.motor_speed
        return float(abs(angle.values[-1] - angle.values[0]) / (self.before.duration - 1 / self.before.sample_rate))


def filtered(drive: DriveResult, chain: str, runs: StudyRuns) -> Filtered | None:
    """Return the kept reading of a drive through one chain of the study; None where it was not simulated."""
    if drive.recording is None:
        return None
    scenario = scenario_of(drive.candidate, runs.study, seed=runs.study.settings.seed)
    made = runs.study.chains(scenario)[chain]
    return Filtered(drive, made, kinematics_of(scenario.rig), drive.recording, made.apply(drive.recording))


def error_picture(runs: StudyRuns, *, present: str) -> Picture | None:
    """Return the dots of the reading errors; None where nothing was simulated."""
    if not any(drive.chains for drive in runs.drives):
        return None
    return picture(
        error_figure(runs.drives, present=present),
        caption="Reading error of each drive with each filter, bars over the Monte Carlo samples; the present "
        "drive is bold",
        alt_text="Dots of the reading error, a row per drive and a colour per filter; the next table has the numbers.",
        name="reading_errors", csv=errors_csv(runs),
    )  # fmt: skip


def shares_picture(runs: StudyRuns) -> Picture | None:
    """Return the stacked bars of the shares; None where nothing was simulated."""
    if not any(drive.shares for drive in runs.drives):
        return None
    return picture(
        shares_figure(runs.drives), caption="Shares of the sensor's reading, unfiltered",
        alt_text="Stacked bars of load, cogging, electrical and mechanical share; the tables above have the numbers.",
        name="shares", csv=shares_csv(runs),
    )  # fmt: skip


def first_picture(shown: Filtered) -> Picture:
    """Return the picture of the first screen: 0.3 s of the reading before and after the filter, and the true load."""
    after = shown.after if shown.chain.stages else shown.before
    start = min(1.0, shown.before.duration / 2)
    return picture(
        signal_figure(shown.before, after, start=start),
        caption=f"{shown.drive.candidate.name} with the filter {shown.chain.name}: reading before and after, and the "
        "true load.",
        alt_text="Torque over time before and after the filter, and the true load.",
        name="reading", plot=signal_plot(shown.before, after, target=plot_name("reading"), start=start),
    )  # fmt: skip


def reading_pictures(
    shown: Filtered, *, role: str, number: int, with_signal: bool, moves: bool
) -> Iterator[Picture]:  # fmt: skip
    """Yield time signal (where it is not the first picture) and spectrum of one drive, before and after its chain.

    The time signal is a plot to zoom where ``moves`` is true, else a fixed picture.
    """
    name = f"{shown.drive.candidate.name}, {role}, filter {shown.chain.name}"
    after = shown.after if shown.chain.stages else shown.before
    start = min(1.0, shown.before.duration / 2)
    if with_signal:
        signal = f"reading_{number}"
        yield picture(
            signal_figure(shown.before, after, start=start), caption=f"{name}: 0.3 s of the reading",
            alt_text="Torque over time before and after the filter, and the true load.",
            name=signal,
            plot=signal_plot(shown.before, after, target=plot_name(signal), start=start) if moves else None,
        )  # fmt: skip
    lines = [line for line in shown.kinematics.lines(4) if line.harmonic <= HARMONICS]
    spectrum, speed = f"spectrum_{number}", shown.motor_speed
    highest = 1.3 * max((line.frequency(speed) for line in lines), default=2000.0)
    yield picture(
        spectrum_figure(shown.before, after, lines=lines, motor_speed=speed, ratio=shown.kinematics.ratio),
        caption=f"{name}: amplitude spectrum (Hann window) over frequency, lines with their causes",
        alt_text="Spectrum before and after the filter; thin lines mark shaft, motor, cogging and electrical lines.",
        name=spectrum, plot=spectrum_plot(
            shown.before, after, target=plot_name(spectrum), lines=lines, motor_speed=speed, highest=highest,
        ),
    )  # fmt: skip


def report_filter(drive: DriveResult, runs: StudyRuns) -> tuple[Picture, Table] | None:
    """Return the spectrum before and after the report's filter with its lines marked, and their levels.

    None where the study does not compare this filter or the drive was not simulated.
    """
    if drive.recording is None or "report_filter_code" not in runs.study.settings.filters.names:
        return None
    scenario = scenario_of(drive.candidate, runs.study, seed=runs.study.settings.seed)
    kinematics = kinematics_of(scenario.rig)
    chain = report_filter_code_chain(kinematics)
    shown = Filtered(drive, chain, kinematics, drive.recording, chain.apply(drive.recording))
    effect = chain_effect(shown.before, shown.after, ratio=kinematics.ratio, lines=chain.lines)
    made = picture(
        notch_figure(shown.before, shown.after, levels=effect.levels, motor_speed=shown.motor_speed),
        caption=f"{drive.candidate.name}: spectrum before and after the filter; triangles mark its "
        f"{len(effect.levels)} notched lines",
        alt_text="Spectra before and after the filter; the amplitude at each marked line is near zero after it.",
        name="notched_lines",
        csv=levels_csv(effect, unit=drive.disturbance.unit),
    )
    return made, levels_table(effect, unit=effort_text(drive))


def levels_table(effect: FilterEffect, *, unit: str = "N m") -> Table:
    """Return the amplitude of each line before and after a chain."""
    rows = tuple(
        (*words(name_of(level.line)), number(f"{level.frequency:.2f}"), number(f"{1e3 * level.before:.3f}"),
         number(f"{1e3 * level.after:.3f}"))
        for level in sorted(effect.levels, key=lambda level: level.frequency)
    )  # fmt: skip
    return Table(
        caption="Amplitude of each notched line, the power within 0.5 Hz of it",
        head=("line", "frequency [Hz]", f"before [m{unit}]", f"after [m{unit}]"), rows=rows,
        note=f"The frequencies of the lines follow the speed {effect.speed_origin}. The load is broadband: each band "
        "contains a part of the load, which the filter removes too.",
    )  # fmt: skip
