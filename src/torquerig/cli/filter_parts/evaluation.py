"""``torquerig filter --evaluate``: placebo test, step response, error to the true load, and a figure per chain."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot
from pathlib import Path

import click

from torquerig.cli.common_options import quantity_in
from torquerig.errors import InputError, UnitError
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.evaluation.load_scale import WEAR_PART, LoadScale
from torquerig.filters.evaluation.placebo import Placebo
from torquerig.filters.evaluation.step_response import StepResponse
from torquerig.metrics.filter_evaluation import FilterEvaluation, evaluate_filter
from torquerig.metrics.load_error import LoadError
from torquerig.metrics.measured_load import measured_load
from torquerig.metrics.truth_error import TRUE_LOADS
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.plain_table import fixed, grid, wrapped
from torquerig.recordings.recording import Recording
from torquerig.reporting.json_results.filter import ChainEvaluation, chain_evaluation
from torquerig.units import parse_quantity


def _edges(_: click.Context, option: click.Parameter, written: str | None) -> tuple[float, ...] | None:
    """Return the band edges [Hz] of a text such as ``10 Hz, 1 kHz``, with 0 before them."""
    if written is None:
        return None
    try:
        edges = tuple(parse_quantity(one.strip(), "Hz") for one in written.split(","))
    except UnitError as error:
        raise UnitError(f"{option.opts[0]}: {error}; write for example '10 Hz, 100 Hz, 1 kHz'") from None
    return edges if edges[0] == 0 else (0.0, *edges)


hit_decay_option = click.option(
    "--hit-decay", default=None, callback=quantity_in("s"), metavar="TIME",
    help="For --evaluate: decay time of a hit of the load, the scale of windows and lags. Default: 4 ms.",
)  # fmt: skip
bands_option = click.option(
    "--bands", default=None, callback=_edges, metavar="EDGES",
    help="For --evaluate: edges of the frequency bands, such as '10 Hz, 100 Hz, 1 kHz'.",
)  # fmt: skip
KNOWN_HARMONICS = 30  # harmonics of each family that a placebo must not touch


def stated_scale(hit_decay: float | None, bands: tuple[float, ...] | None) -> LoadScale:
    """Return the scale of an evaluation by the options; what is not stated is that of the reference rig."""
    return LoadScale(
        WEAR_PART.hit_decay if hit_decay is None else hit_decay, WEAR_PART.edges if bands is None else bands
    )


def evaluation_pictures(path: Path, names: Sequence[str], picture: Path | None, *, force: bool) -> dict[str, Path]:
    """Return the path of each chain's figure, checked before the calculation.

    Raises
    ------
    InputError
        For several chains and one picture, or a picture that exists already.
    """
    from torquerig.reporting.figures.picture import check_picture

    if picture is not None and len(names) != 1:
        raise InputError("--picture needs exactly one --chain; without --picture each chain gets its own file name")
    targets = {name: picture or Path(f"{path.stem}.{name}.evaluation.svg") for name in names}
    for target in targets.values():
        check_picture(target, overwrite=force)
    return targets


def print_evaluations(
    recording: Recording,
    chains: Sequence[Chain],
    kinematics: Kinematics,
    targets: dict[str, Path],
    *,
    where: str,
    force: bool,
    scale: LoadScale,
) -> tuple[ChainEvaluation, ...]:
    """Print, draw and return the evaluation of each chain on ``recording``; ``where`` is its place in the file."""
    from torquerig.reporting.figures.evaluation_figure import evaluation_figure
    from torquerig.reporting.figures.picture import write_picture

    known, evaluations = kinematics.lines(KNOWN_HARMONICS), []
    for chain in chains:
        made = evaluate_filter(chain, recording, ratio=kinematics.ratio, known=known, scale=scale)
        click.echo(f"{chain.name}, evaluated on {recording.duration:.4g} s{where}:")
        for part in (placebo_text(made), step_text(made.step), truth_text(made)):
            click.echo(part + "\n")
        write_picture(evaluation_figure(made), targets[chain.name], overwrite=force)
        click.echo(f"wrote {targets[chain.name]}\n")
        evaluations.append(chain_evaluation(made))
    return tuple(evaluations)


def placebo_text(made: FilterEvaluation) -> str:
    """Return the text of the placebo test: the reduction at orders without lines, and at the lines."""
    placebo, effect = made.placebo, made.effect
    if placebo is None:
        return wrapped("No placebo test: the chain removes no lines that could be moved to other orders.")
    low, high = min(placebo.std_cuts), max(placebo.std_cuts)
    first = (
        f"Placebo test: at {len(placebo.shifts)} positions without lines, {_span(placebo)} output orders away, the "
        f"chain reduces the standard deviation by {100 * low:.1f} to {100 * high:.1f} % (median "
        f"{100 * _median(placebo):.1f} %). At its lines it reduces it by {effect.std_reduction_percent:.1f} %. "
    )
    if placebo.cut <= max(placebo.cuts):
        return wrapped(
            first + f"{sum(one >= placebo.cut for one in placebo.cuts)} of {len(placebo.cuts)} moved chains reduce "
            "it as much: the test does not show that the removed part is noise and not load."
        )
    return wrapped(
        first + f"The chain removes {100 * placebo.cut:.1f} % of the variance; as many bands at other orders remove "
        f"{100 * placebo.median:.1f} %. The difference of {100 * placebo.beyond:.1f} % is at its lines (rank test, "
        f"p = {placebo.p_value:.2g})."
    )


def step_text(step: StepResponse | None) -> str:
    """Return the text of the chain's response to a step and to a hit that are added to the recording."""
    if step is None:
        return "No step or hit could be added: the torque is constant or the recording too short."
    return wrapped(
        f"Step response: rise time {_milli(step.rise)} (10 to 90 %), delay {_milli(step.late)}, overshoot "
        f"{100 * step.overshoot:.1f} %, pre-ringing {100 * step.pre_ringing:.1f} %. A hit with "
        f"{1e3 * step.hit_decay:g} ms decay keeps {100 * step.hit_peak:.1f} % of its peak."
    )


def truth_text(made: FilterEvaluation) -> str:
    """Return the table of errors to the true load before and after, or a sentence that it is unknown."""
    before, after = made.error_before, made.error_after
    if before is None or after is None:
        late = f" The delay to the raw reading is {_milli(made.delay.seconds)}." if made.delay else ""
        return wrapped("The true load is unknown, so no error is computed." + late)
    perfect = made.error_perfect
    errors = (before, after) if perfect is None else (before, after, perfect)
    head = ["error to the true load", "before", "after", *(["perfect line removal"] if perfect else [])]
    rows = [[*head, "true load"]]
    size, unit = hypot(*before.load_in_band), made.before.torque_unit()

    def number(value: float) -> str:
        return fixed(value, scale=size, digits=6)

    rows.append([f"rms {unit}", *(number(one.rms) for one in errors), ""])
    rows.append([f"mean {unit}", *(number(one.mean) for one in errors), ""])
    for place, (low, high) in enumerate(before.bands):
        figures = (one.in_band[place] for one in errors)
        rows.append(
            [f"{low:g}-{high:g} Hz {unit}", *(number(one) for one in figures), number(before.load_in_band[place])]
        )
    rows.append(["energy %", *(_percent(one.energy_percent) for one in errors), ""])
    rows.append(["delay ms", *(_delay(one) for one in errors), ""])
    rows += _hits(errors)
    return (
        _measured(made)
        + grid(rows)
        + _shares(made)
        + ("" if perfect is None else _ratio_to_perfect(before, after, perfect))
    )


def _measured(made: FilterEvaluation) -> str:
    """Return which channel is taken for the load; empty where a simulation knows it."""
    load = None if any(name in made.before.channels for name in TRUE_LOADS) else measured_load(made.before)
    if load is None:
        return ""
    turned = ", with the other sign, so that it agrees with the reading" if load.is_turned else ""
    return wrapped(f"The true load is the measured one of the channel {load.channel}{turned}.") + "\n"


def _shares(made: FilterEvaluation) -> str:
    """Return how much of the variance before, after and between is load."""
    shares = made.load_shares
    if shares is None:
        return ""
    parts = {"the reading": shares.before, "what remains": shares.after, "what is removed": shares.removed}
    said = [f"{100 * share:.1f} % of {part}" for part, share in parts.items() if share is not None]
    return "\n" + wrapped(f"Of the variance, the load is {', '.join(said)} (squared correlation).") if said else ""


def _ratio_to_perfect(before: LoadError, after: LoadError, perfect: LoadError) -> str:
    """Return the error as a multiple of that of perfect line removal, which is the load's excitation of the shaft."""
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
            "10 % and 90 % quantile of peak %",
            *(f"{100 * one.peak_low:.0f}..{100 * one.peak_high:.0f}" for one in hits),
            "",
        ],
        [
            "rise time of these hits, 10 to 90 %, ms",
            *(f"{1e3 * one.rise:.2f}" for one in hits),
            f"{1e3 * hits[0].true_rise:.2f}",
        ],
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
