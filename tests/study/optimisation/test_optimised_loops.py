"""The best speed loop of a motor: better than the rule of the study, within its margin, and the same when run alone."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.filters.butterworth import ButterworthLowPass, CausalButterworthLowPass
from torquerig.filters.chains.filter_chain import Chain
from torquerig.recordings.recording import Recording
from torquerig.reporting.study.optimum_text import front_text, optimum_text
from torquerig.scenario.overrides import overridden
from torquerig.study.candidates import candidates
from torquerig.study.definition import Study, open_study
from torquerig.study.optimisation.bounds import Bounds
from torquerig.study.optimisation.search import Optimum, delay_of, optimised
from torquerig.study.optimisation.tried import Tried, front
from torquerig.study.run_study import run_drive

SMALL = (
    "study.motors=[bldc-12n14p]", "study.gearboxes=[reference-5-1]", "study.draws=0", "study.duration=1 s",
    "study.filters.names=[none, order_lines_low_pass]", "study.present.filter=none",
    "recording.settling=2.5 s",
)  # fmt: skip


def study(*further: str) -> Study:
    document = read_document(shipped_folder().parent / "scenarios" / "wear_rig.yaml")
    return open_study(overridden(document, (*SMALL, *further)), load_catalog(shipped_folder()))


@cache
def optimum() -> Optimum:
    bounds = Bounds(
        gearboxes=("reference-5-1",), crossover=(8.0, 40.0), integral_corner=(0.5, 3.0), evaluations=32
    )  # fmt: skip
    return optimised(study(), "bldc-12n14p", bounds)


@pytest.mark.long
def test_the_best_loop_reads_better_than_the_rule_and_the_same_when_run_alone() -> None:
    best = min(optimum().tried, key=lambda one: one.error)
    rule = next(one for one in optimum().by_rule if one.filtering == best.filtering)
    assert best.error < 0.99 * rule.error
    present = run_drive(candidates(study())[0], study())
    assert present.chains[rule.filtering].truth_error.value == pytest.approx(rule.error, rel=1e-9)
    asked = study(
        f"study.speed_loop.crossover={best.crossover!r} Hz",
        f"study.speed_loop.integral_corner={best.integral_corner!r} Hz",
    )
    alone = run_drive(candidates(asked)[0], asked)
    assert alone.chains[best.filtering].truth_error.value == pytest.approx(best.error, rel=1e-9)


@pytest.mark.long
def test_every_loop_is_within_the_bounds_and_has_the_margin() -> None:
    assert all(8 <= one.crossover <= 40 and 0.5 <= one.integral_corner <= 3 for one in optimum().tried)
    assert all(one.margin >= 0.5 for one in optimum().tried)
    assert {one.filtering for one in optimum().tried} == {"none", "order_lines_low_pass"}
    best = front(optimum().tried)
    text = optimum_text(best, optimum().by_rule, unit="N*m")
    assert text.startswith(f"The least reading error is {best[0].error:.4g} N m: bldc-12n14p")
    assert "While the rig runs, none on" in text
    assert "whole recording" in front_text(best, unit="N*m")


@pytest.mark.long
def test_bounds_without_any_loop_are_said() -> None:
    bounds = Bounds(
        gearboxes=("reference-5-1",), crossover=(300.0, 400.0), integral_corner=(50.0, 60.0), margin=0.99,
        evaluations=16
    )  # fmt: skip
    with pytest.raises(InputError, match="no speed loop within the bounds has the margin"):
        optimised(study(), "bldc-12n14p", bounds)


def made(**figures: float | None) -> Tried:
    plain = Tried(
        drive="d", filtering="f", crossover=1.0, integral_corner=1.0, error=1.0, delay=0.0, price=0.0, margin=1.0
    )  # fmt: skip
    return replace(plain, **figures)  # type: ignore[arg-type]


def test_the_front_has_what_no_other_beats() -> None:
    live, exact, late, dear, worse = (
        made(error=2.0), made(error=1.0, delay=None), made(error=1.5, delay=0.01), made(error=1.2, price=500.0),
        made(error=2.5),
    )  # fmt: skip
    assert front([worse, dear, late, exact, live]) == (exact, dear, late, live)
    assert front([exact, made(error=1.0)]) == (made(error=1.0),)
    assert front([made(error=0.995, price=900.0), made(error=1.0)]) == (made(error=1.0),)
    assert front([]) == ()


@pytest.mark.parametrize(
    ("limits", "said"),
    [
        ({"crossover": (60.0, 5.0)}, "crossover from 60 to 5 Hz is no range"),
        ({"integral_corner": (0.0, 5.0)}, "integral corner from 0 to 5 Hz"),
        ({"crossover": (5.0, float("inf"))}, "is no range"),
        ({"margin": 1.5}, "a margin of 1.5 cannot be"),
    ],
)
def test_bounds_that_are_none_are_refused(limits: dict[str, object], said: str) -> None:
    given = {"gearboxes": (), "crossover": (5.0, 60.0), "integral_corner": (0.3, 5.0)} | limits
    with pytest.raises(InputError, match=said):
        Bounds(**given)  # type: ignore[arg-type]


def test_a_filter_that_needs_the_whole_recording_has_no_delay() -> None:
    from torquerig.simulation.simulator import simulate
    from torquerig.study.candidates import scenario_of

    asked = study()
    rig = scenario_of(candidates(asked)[0], asked, seed=1).rig
    recording: Recording = simulate(rig, duration=0.05, seed=1, settling=0.0)
    live = CausalButterworthLowPass(cutoff=50.0)
    assert delay_of(Chain(name="none", stages=()), recording) == 0
    assert delay_of(Chain(name="live", stages=(live, live)), recording) == pytest.approx(2 * live.delay(recording))
    assert delay_of(Chain(name="both", stages=(live, ButterworthLowPass(cutoff=50.0))), recording) is None
