"""``torquerig filter --judge``: what the chains are worth, and the four panels of each."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from torquerig.errors import InputError
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.evaluation.inserted import HIT_DECAY, StepShown
from torquerig.filters.evaluation.placebo import Placebo
from torquerig.metrics.filter_evaluation import FilterEvaluation, evaluate_filter
from torquerig.metrics.load_error import LoadError
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.plain_table import grid, wrapped
from torquerig.recordings.recording import Recording

KNOWN_HARMONICS = 30  # of each family, that a placebo keeps clear of


def judged_pictures(path: Path, names: Sequence[str], picture: Path | None, *, force: bool) -> dict[str, Path]:
    """Return where each chain's four panels are to be written, checked before any work is done.

    Raises
    ------
    InputError
        For several chains and one picture, or a picture that is there already.
    """
    from torquerig.reporting.figures.picture import check_picture

    if picture is not None and len(names) != 1:
        raise InputError("--picture takes one chain; leave it out, and each chain's panels get a name of their own")
    targets = {name: picture or Path(f"{path.stem}.{name}.judged.svg") for name in names}
    for target in targets.values():
        check_picture(target, overwrite=force)
    return targets


def judge_chains(
    recording: Recording,
    chains: Sequence[Chain],
    kinematics: Kinematics,
    targets: dict[str, Path],
    *,
    where: str,
    force: bool,
) -> None:
    """Judge each chain on ``recording``, tell it and ``where`` in its file that is, and draw the panels."""
    from torquerig.reporting.figures.judged_figure import judged_figure
    from torquerig.reporting.figures.picture import write_picture

    known = kinematics.lines(KNOWN_HARMONICS)
    for chain in chains:
        made = evaluate_filter(chain, recording, ratio=kinematics.ratio, known=known)
        click.echo(f"{chain.name}, judged on {recording.duration:.4g} s{where}:")
        for part in (told_placebo(made), told_step(made.step), told_truth(made)):
            click.echo(part + "\n")
        write_picture(judged_figure(made), targets[chain.name], overwrite=force)
        click.echo(f"wrote {targets[chain.name]}\n")


def told_placebo(made: FilterEvaluation) -> str:
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


def told_truth(made: FilterEvaluation) -> str:
    """Return the table of errors to the true load before and after, or that it is not known."""
    before, after = made.error_before, made.error_after
    if before is None or after is None:
        late = f" The filtered reading comes {_milli(made.delay.seconds)} behind the raw one." if made.delay else ""
        return wrapped("The true load is not known here, so that no error can be stated." + late)
    perfect = made.error_perfect
    all_of = (before, after) if perfect is None else (before, after, perfect)
    head = ["error to the true load", "before", "after", *(["lines taken exactly"] if perfect else [])]
    rows = [[*head, "the load itself"]]
    rows.append(["rms N*m", *(f"{one.rms:.5f}" for one in all_of), ""])
    rows.append(["mean N*m", *(f"{one.mean:.5f}" for one in all_of), ""])
    for place, (low, high) in enumerate(before.bands):
        figures = (one.in_band[place] for one in all_of)
        rows.append(
            [f"{low:g}-{high:g} Hz N*m", *(f"{one:.5f}" for one in figures), f"{before.load_in_band[place]:.5f}"]
        )
    rows.append(["energy %", *(_percent(one.energy_percent) for one in all_of), ""])
    rows.append(["delay ms", *(_delay(one) for one in all_of), ""])
    rows += _hits(all_of)
    return grid(rows) + ("" if perfect is None else _beside_perfect(before, after, perfect))


def _beside_perfect(before: LoadError, after: LoadError, perfect: LoadError) -> str:
    """Return the error as a share of perfect line removal's; what is left of that is the load ringing the shaft."""
    if not perfect.rms:
        return ""
    return "\n" + wrapped(
        f"The error is {after.rms / perfect.rms:.3f} times that of perfect line removal (raw: "
        f"{before.rms / perfect.rms:.3f} times)."
    )


def _hits(errors: Sequence[LoadError]) -> list[list[str]]:
    hits = [one.hits for one in errors if one.hits is not None]
    if len(hits) < len(errors):
        return []
    return [
        [f"peak of {hits[0].count} largest hits %", *(f"{100 * one.peak:.0f}" for one in hits), "100"],
        [
            "a tenth under, a tenth over %",
            *(f"{100 * one.peak_low:.0f}..{100 * one.peak_high:.0f}" for one in hits),
            "",
        ],
        ["rise of these, 10 to 90 %, ms", *(f"{1e3 * one.rise:.2f}" for one in hits), f"{1e3 * hits[0].true_rise:.2f}"],
    ]


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
