"""``torquerig filter --judge``: what the chains are worth, and the four panels of each."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from torquerig.errors import InputError
from torquerig.metrics.judgement import Judgement, judged
from torquerig.metrics.load_error import LoadError
from torquerig.plain_table import grid, wrapped
from torquerig.signals.chain import Chain
from torquerig.signals.judging.inserted import HIT_DECAY, StepShown
from torquerig.signals.judging.placebo import Placebo
from torquerig.signals.kinematics import Kinematics
from torquerig.signals.recording import Recording

KNOWN_HARMONICS = 30  # of each family, that a placebo keeps clear of


def judged_pictures(path: Path, names: Sequence[str], picture: Path | None, *, force: bool) -> dict[str, Path]:
    """Return where each chain's four panels are to be written, checked before any work is done.

    Raises
    ------
    InputError
        For several chains and one picture, or a picture that is there already.
    """
    from torquerig.report.picture import check_picture

    if picture is not None and len(names) != 1:
        raise InputError("--picture takes one chain; leave it out, and each chain's panels get a name of their own")
    targets = {name: picture or Path(f"{path.stem}.{name}.judged.svg") for name in names}
    for target in targets.values():
        check_picture(target, overwrite=force)
    return targets


def judge_chains(
    recording: Recording, chains: Sequence[Chain], kinematics: Kinematics, targets: dict[str, Path], *, force: bool
) -> None:
    """Judge each chain on ``recording``, tell it, and draw its panels."""
    from torquerig.report.judged_figure import judged_figure
    from torquerig.report.picture import write_picture

    known = kinematics.lines(KNOWN_HARMONICS)
    for chain in chains:
        made = judged(chain, recording, ratio=kinematics.ratio, known=known)
        click.echo(f"{chain.name}, judged on {recording.duration:.4g} s:")
        for part in (told_placebo(made), told_step(made.step), told_truth(made)):
            click.echo(part + "\n")
        write_picture(judged_figure(made), targets[chain.name], overwrite=force)
        click.echo(f"wrote {targets[chain.name]}\n")


def told_placebo(made: Judgement) -> str:
    """Return in words what the same chain cuts at empty orders, and what is left as noise removed."""
    placebo, effect = made.placebo, made.effect
    if placebo is None:
        return wrapped("No placebo: the chain has no lines that could be moved to empty orders.")
    low, high = min(placebo.std_cuts), max(placebo.std_cuts)
    first = (
        f"Moved to {len(placebo.shifts)} empty places {_span(placebo)} output orders beside, the chain cuts "
        f"{100 * low:.1f} to {100 * high:.1f} % of the standard deviation (median {100 * _median(placebo):.1f} %); at "
        f"its own lines it cuts {effect.std_reduction_percent:.1f} %. "
    )
    if placebo.cut <= max(placebo.cuts):
        return wrapped(
            first + f"{sum(one >= placebo.cut for one in placebo.cuts)} of {len(placebo.cuts)} moved chains cut as "
            "much: nothing shows that this is noise and not load."
        )
    return wrapped(
        first + f"Of the variance it takes {100 * placebo.cut:.1f} %, and {100 * placebo.median:.1f} % so many bands "
        f"take anywhere; the {100 * placebo.beyond:.1f} % beyond stand at its lines (rank p = {placebo.p_value:.2g})."
    )


def told_step(step: StepShown | None) -> str:
    """Return in words what the chain makes of a step and a hit put into the recording."""
    if step is None:
        return "No step or hit could be put in: the torque is constant or too short."
    return wrapped(
        f"A step put in comes out with {_milli(step.rise)} from 10 to 90 %, {_milli(step.late)} late, "
        f"{100 * step.overshoot:.1f} % over; up to {100 * step.foreseen:.1f} % show before it. A hit of "
        f"{1e3 * HIT_DECAY:g} ms decay keeps {100 * step.hit_peak:.1f} % of its peak."
    )


def told_truth(made: Judgement) -> str:
    """Return the table of errors to the true load before and after, or that it is not known."""
    before, after = made.error_before, made.error_after
    if before is None or after is None:
        late = f" The filtered reading comes {_milli(made.delay.seconds)} behind the raw one." if made.delay else ""
        return wrapped("The true load is not known here, so that no error can be stated." + late)
    rows = [["error to the true load", "before", "after", "the load itself"]]
    rows.append(["rms N*m", f"{before.rms:.5f}", f"{after.rms:.5f}", ""])
    rows.append(["mean N*m", f"{before.mean:.5f}", f"{after.mean:.5f}", ""])
    for (low, high), was, now, own in zip(
        before.bands, before.in_band, after.in_band, before.load_in_band, strict=True
    ):
        rows.append([f"{low:g}-{high:g} Hz N*m", f"{was:.5f}", f"{now:.5f}", f"{own:.5f}"])
    rows.append(["energy %", *(_percent(one.energy_percent) for one in (before, after)), ""])
    rows.append(["delay ms", *(_delay(one) for one in (before, after)), ""])
    rows += _hits(before, after)
    return grid(rows)


def _hits(before: LoadError, after: LoadError) -> list[list[str]]:
    if before.hits is None or after.hits is None:
        return []
    first, last = before.hits, after.hits
    return [
        [f"peak of {first.count} largest hits %", f"{100 * first.peak:.0f}", f"{100 * last.peak:.0f}", "100"],
        ["a tenth under, a tenth over %", *(f"{100 * one.peak_low:.0f}..{100 * one.peak_high:.0f}"
                                            for one in (first, last)), ""],
        ["rise of these, 10 to 90 %, ms", f"{1e3 * first.rise:.2f}", f"{1e3 * last.rise:.2f}",
         f"{1e3 * first.true_rise:.2f}"],
    ]  # fmt: skip


def _span(placebo: Placebo) -> str:
    away = [abs(one) for one in placebo.shifts]
    return f"{min(away):g} to {max(away):g}"


def _median(placebo: Placebo) -> float:
    ordered = sorted(placebo.std_cuts)
    middle = len(ordered) // 2
    return ordered[middle] if len(ordered) % 2 else 0.5 * (ordered[middle - 1] + ordered[middle])


def _milli(seconds: float) -> str:
    return f"{1e3 * seconds + 0.0:.3g} ms" if abs(seconds) >= 1e-5 else "0 ms"


def _percent(value: float | None) -> str:
    return "-" if value is None else f"{value:.4f}"


def _delay(error: LoadError) -> str:
    return "-" if error.delay is None else f"{1e3 * error.delay.seconds:.3f} (r {error.delay.correlation:.3f})"
