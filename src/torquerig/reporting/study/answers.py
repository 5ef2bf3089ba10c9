"""Question, operating point, rules and limits of a study, and the command that repeats it."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from math import pi
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.parameter import EVIDENCE
from torquerig.reporting.layout import listed, plain
from torquerig.reporting.study.chapters import rule_text
from torquerig.study.left_out import left_out_gearboxes
from torquerig.study.load_randomness import load_randomness
from torquerig.study.study_facts import study_facts

if TYPE_CHECKING:
    from torquerig.metrics.figure import Figure
    from torquerig.study.results import StudyRuns
    from torquerig.study.scoring import Decided
    from torquerig.study.settings import SpeedLoopRule

Facts = tuple[tuple[str, str], ...]

MESH = "Gear mesh lines are absent unless the scenario states a mesh with its teeth."
CLASS = (
    "The disturbance of a motor without a data sheet is drawn from the interval of its class. A difference between two "
    "such motors can be random, and need not be a difference between the products."
)


def question(runs: StudyRuns) -> str:
    """Return the question of the study."""
    settings = runs.study.settings
    motors, present = len({drive.candidate.motor for drive in runs.drives}), settings.present.motor
    stages = len({drive.candidate.gearbox for drive in runs.drives if drive.candidate.gearbox})
    part = runs.drives[0].candidate.parts.stage
    on, asked = (f" on {stages} {_plural(part, stages)}", f"motor, {part}") if stages else ("", "motor")
    here = f"{present} on {runs.study.present_gearbox}" if stages else present
    return (
        f"Which {asked} and filter give the smallest error of the torque reading, and at what price? The study "
        f"compares {motors} motors{on} with {len(settings.filters.names)} filters "
        f"({listed(settings.filters.names)}): {len(runs.drives) * len(settings.filters.names)} combinations. The "
        f"baseline "
        f"is the present {here} with the filter "
        f"{settings.present.filter}.{_of_a_chain(runs)}"
    )


def _plural(stage: str, count: int) -> str:
    """Return the word for the stages: gearboxes, or what the rig calls the exchanged one."""
    return ("gearboxes" if count != 1 else stage) if stage == "gearbox" else f"choices of {stage}"


def _of_a_chain(runs: StudyRuns) -> str:
    """Return what the ratios in the tables are; empty where the chain is the exchanged stage alone."""
    first = runs.drives[0].candidate
    whole = first.ratio if first.whole_ratio is None else first.whole_ratio
    if not first.gearbox or whole == first.ratio:
        return ""
    return (
        f" The exchanged stage is {first.parts.stage}. A ratio such as {first.ratio_text} is that of this stage, in "
        "a chain of the second ratio from the motor to the measured part."
    )


def operating_point(runs: StudyRuns, decided: Decided) -> Facts:
    """Return the operating point and the rules for every drive, as pairs of name and text."""
    settings = runs.study.settings
    facts = study_facts(runs)
    unit, wandering = runs.study.effort_unit.replace("*", " "), f"slow speed wander {facts.wander:g} rms (relative)"
    return (
        ("speed", _speed(runs)),
        ("occupancy", f"{runs.occupancy_percent:g} %, a mean load of {plain(runs.mean_load)} {unit}"),
        ("particle size", f"{plain(runs.particle_size * 1e3)} mm"),
        ("run", f"{settings.duration:g} s at {facts.rate / 1e3:g} kHz for each drive, {wandering}"),
        ("Monte Carlo", f"{1 + settings.draws} samples of each drive, drawn from the catalog's intervals"),
        ("speed loop", _loop_rule(settings.speed_loop)),
        ("drive limit", _limit_rule(settings.sensor_limit, unit)),
        ("requirements", "; ".join(f"{rule_text(one)} ({one.purpose})" for one in decided.requirements.criteria)),
        ("seed, version", f"seed {settings.seed}, torquerig {runs.version}"),
    )  # fmt: skip


def _speed(runs: StudyRuns) -> str:
    if runs.study.effort_unit == "N":
        return f"{plain(runs.output_speed * 1e3, 5)} mm/s of the measured part; the motor's follows from the lead"
    return f"{plain(runs.output_speed * 30 / pi, 5)} rpm at the output; the motor turns ratio times as fast"


def _loop_rule(rule: SpeedLoopRule) -> str:
    return (
        f"the same rule for all drives: crossover {rule.crossover:g} Hz, integrator corner "
        f"{rule.integral_corner:g} Hz. "
        f"With the total inertia J at the motor, kp = 2π x {rule.crossover:g} Hz x J and ki = kp x 2π x "
        f"{rule.integral_corner:g} Hz"
    )


def _limit_rule(limit: float, unit: str) -> str:
    return (
        f"the torque limit of the drive is lowered so that limit x ratio x efficiency is at most {limit:g} {unit}. The "
        "sensor then survives a jam"
    )


def limits(runs: StudyRuns) -> tuple[str, ...]:
    """Return the limits of validity of the study."""
    samples = (
        f"Simulated figures are the median of {1 + runs.study.settings.draws} Monte Carlo samples of what the catalog "
        "leaves open, all of the same length, settling and load; the intervals are their extremes, which more samples "
        "would widen."
    )
    randomness = load_randomness(runs.drives)
    load = () if randomness is None else (randomness.sentence(),)
    simulated = "All readings are simulated; none is a measurement of a real motor."
    shares = (
        "The shares are determined by omitting one group of effects at a time. Their squares need not add up to "
        "the square of the total."
    )
    rig = runs.study.document.data.get("rig", {})
    mesh = () if any(part.get("kind") == "gear_mesh" for part in rig.values()) else (MESH,)
    notes = [note for note in (left_out_gearboxes(runs.study), study_facts(runs).held) if note]
    return (
        simulated,
        *narrow_loops(runs),
        *omitted_ripple(runs),
        *mesh,
        *_left_out(runs),
        samples,
        *load,
        *notes,
        CLASS,
        shares,
    )


def _left_out(runs: StudyRuns) -> tuple[str, ...]:
    """Return the effects of the present stage that some candidates cannot have."""
    without = study_facts(runs).left_out
    return tuple(
        f"{listed(effects)} of the scenario has no place on {box} and is left out there." for box, effects in
        without.items() if effects
    )  # fmt: skip


def narrow_loops(runs: StudyRuns) -> tuple[str, ...]:
    """Return the drives whose speed loop is unstable in some samples, or nearer to instability than is usual."""
    samples = 1 + runs.study.settings.draws
    unstable = (
        f"{drive.candidate.name}: its speed loop is unstable in {drive.unstable_samples} of {samples} samples of the "
        "catalog, which have no part in its figures; lower study: speed_loop: crossover."
        for drive in runs.drives if drive.unstable_samples
    )  # fmt: skip
    near = (
        f"{drive.candidate.name}: {drive.loop.doubt}."
        for drive in runs.drives if drive.loop is not None and drive.loop.doubt
    )  # fmt: skip
    return (*unstable, *near)


def omitted_ripple(runs: StudyRuns) -> tuple[str, ...]:
    """Return the ripple of six-step commutation where a motor's known lines lack it; empty where none does."""
    sentences = []
    for motor in dict.fromkeys(drive.candidate.motor for drive in runs.drives if not drive.omitted.unknown):
        drives = [drive for drive in runs.drives if drive.candidate.motor == motor]
        added = "; ".join(f"{_millinewtonmetres(drive.omitted)} at {drive.candidate.ratio_text}" for drive in drives)
        sentences.append(
            f"The known lines of {motor} contain no six-step commutation ripple. If its drive commutates in six steps, "
            f"the reading has an additional ripple (by its class and the linearised rig): {added}."
        )
    return tuple(sentences)


def evidence() -> Facts:
    """Return the evidence tags and what they mean."""
    return tuple(EVIDENCE.items())


def assumptions(runs: StudyRuns) -> tuple[tuple[str, Facts], ...]:
    """Return for each motor and gearbox the values that no document states, with the drawn value and its interval."""
    found: dict[str, dict[str, str]] = {}
    for drive in runs.drives:
        for key, text in drive.assumed.items():
            part, _, field = key.partition(".")
            parts = drive.candidate.parts
            owner = {parts.motor: drive.candidate.motor, parts.stage: drive.candidate.gearbox}.get(part, part)
            found.setdefault(owner, {}).setdefault(field.replace("_", " ").replace(".", ": "), text)
    owners = [*dict.fromkeys(drive.candidate.motor for drive in runs.drives)]
    rest = [owner for owner in found if owner not in owners]
    return tuple((owner, tuple(found.get(owner, {}).items())) for owner in (*owners, *rest))


def command(runs: StudyRuns, edits: Sequence[str]) -> str:
    """Return the command that repeats this report, without folders of this machine."""
    path = Path(runs.study.document.path)
    shown = path.name if path.is_absolute() else path.as_posix()
    return shlex.join(["torquerig", "compare", shown, *(part for edit in edits for part in ("--set", edit))])


def _millinewtonmetres(figure: Figure) -> str:
    if figure.high is None or figure.high < 1e-6:
        return "negligible"
    return f"{1e3 * (figure.low or 0.0):.2g} to {1e3 * figure.high:.2g} mN m rms"
