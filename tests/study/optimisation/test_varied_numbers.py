"""Numbers of filters that vary: read with their unit, within their limits, and the same when written into the file."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import parse_document, read_document
from torquerig.errors import InputError
from torquerig.scenario.overrides import overridden
from torquerig.study.candidates import candidates
from torquerig.study.definition import Study, open_study
from torquerig.study.optimisation.bounds import Bounds
from torquerig.study.optimisation.search import Optimum, optimised
from torquerig.study.optimisation.tried import front
from torquerig.study.optimisation.varied_number import varied_number, varied_texts
from torquerig.study.run_study import run_drive

FILTERS = """\
filters:
  live:
    - {type: butterworth_low_pass, cutoff: 50 Hz, order: 2, causal: true}
  two:
    - {type: butterworth_low_pass, cutoff: 50 Hz}
    - {type: fir_low_pass, cutoff: 40 Hz, transition: 20 Hz}
  window: [{type: hampel}]
"""
SMALL = (
    "study.motors=[bldc-12n14p]", "study.gearboxes=[reference-5-1]", "study.draws=0", "study.duration=1 s",
    "study.filters.names=[live, two, window]", "study.present.filter=live", "recording.settling=2.5 s",
)  # fmt: skip


def study(*further: str, filters: str = FILTERS) -> Study:
    document = read_document(shipped_scenarios() / "wear_rig.yaml")
    made = open_study(overridden(document, (*SMALL, *further)), load_catalog(shipped_folder()))
    return replace(made, filters=parse_document(filters, Path("filters.yaml")))


def test_both_ends_are_read_in_one_unit_or_two() -> None:
    for text in ("live.cutoff=5..60 Hz", "live.cutoff=5 Hz..60Hz", "live.cutoff=5 Hz..0.06 kHz"):
        made = varied_number(text, study())
        assert (made.low, made.high, made.unit, made.whole) == (5.0, pytest.approx(60.0), "Hz", False)
    order = varied_number("live.order=2..6", study())
    assert (order.low, order.high, order.whole) == (2, 6, True)
    assert [order.at(share) for share in (0.0, 0.5, 1.0)] == [2, 4, 6]
    assert varied_number("live.cutoff=4..64 Hz", study()).at(0.5) == pytest.approx(16.0)
    assert varied_number("two.2.cutoff=5..6 Hz", study()).stage == 1


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("live.cutoff", "not of the form FILTER.KEY=LOW..HIGH"),
        ("live.cutoff=5 Hz", "not of the form"),
        ("liv.cutoff=5..6 Hz", "the study has no filter 'liv'; did you mean 'live'"),
        ("live.cutof=5..6 Hz", "has no number 'cutof'; did you mean 'cutoff'"),
        ("live.causal=0..1", "has no number 'causal'"),
        ("live.cutoff=5..6", "'5' has no unit; write '5 Hz'"),
        ("live.cutoff=6..5 Hz", "is no range; write the lower end first"),
        ("live.cutoff=-1..5 Hz", "must be more than 0"),
        ("live.cutoff=5..6 V", "is a voltage"),
        ("live.order=2..80", "is out of range; it must be at most 10"),
        ("live.order=2.5..8", "no whole number"),
        ("two.cutoff=5..6 Hz", "several stages have 'cutoff'; write one of two.1.cutoff, two.2.cutoff"),
        ("two.3.cutoff=5..6 Hz", "stage 3 has no number 'cutoff'; stages that have one: 1, 2"),
    ],
)
def test_what_cannot_vary_is_said_in_one_sentence(text: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        varied_number(text, study())
    assert said in str(caught.value)
    assert str(caught.value).startswith(f"--vary {text}: ")
    assert "\n" not in str(caught.value)


def test_a_number_varies_once() -> None:
    one = varied_number("live.order=2..6", study())
    with pytest.raises(InputError, match=r"--vary names live\.order twice"):
        Bounds(gearboxes=(), crossover=(5.0, 60.0), integral_corner=(0.3, 5.0), numbers=(one, one))


def test_only_the_named_number_changes() -> None:
    asked = study()
    numbers = [varied_number("two.2.cutoff=5..60 Hz", asked), varied_number("two.1.order=2..6", asked)]
    made = varied_texts(asked, numbers, [33.0, 5.0])
    assert list(made) == ["two"]
    first, second = made["two"]
    assert (first.order, first.cutoff, second.cutoff, second.transition) == (5, 50.0, 33.0, 20.0)  # type: ignore[attr-defined]
    assert asked.filter_texts["two"][1].cutoff == 40.0  # type: ignore[attr-defined]


@cache
def optimum() -> Optimum:
    asked = study("study.filters.names=[live]")
    bounds = Bounds(
        gearboxes=("reference-5-1",), crossover=(8.0, 40.0), integral_corner=(0.5, 3.0), evaluations=32,
        numbers=(varied_number("live.cutoff=5..200 Hz", asked),),
    )  # fmt: skip
    return optimised(asked, "bldc-12n14p", bounds)


@pytest.mark.long
def test_the_front_shows_delay_against_error_and_each_setting_reads_the_same_from_the_file() -> None:
    best = front(optimum().tried)
    assert len(best) > 4
    delays = [one.delay for one in best if one.delay is not None]
    assert delays == sorted(delays, reverse=True)  # by rising error
    assert max(delays) > 3 * min(delays)
    one = best[0]
    (setting,) = one.settings
    assert setting.startswith("cutoff ")
    # the cutoff of the table has three digits: a thousandth of it moves the error by less than that
    text = FILTERS.replace("cutoff: 50 Hz, order: 2", f"{setting.replace('cutoff ', 'cutoff: ')}, order: 2")
    asked = study(
        "study.filters.names=[live]", f"study.speed_loop.crossover={one.crossover!r} Hz",
        f"study.speed_loop.integral_corner={one.integral_corner!r} Hz", filters=text,
    )  # fmt: skip
    alone = run_drive(candidates(asked)[0], asked)
    assert alone.chains["live"].truth_error.value == pytest.approx(one.error, rel=5e-3)


@pytest.mark.long
def test_the_rule_is_shown_with_the_filter_as_stated() -> None:
    (rule,) = optimum().by_rule
    assert rule.settings == ()
    asked = study("study.filters.names=[live]")
    alone = run_drive(candidates(asked)[0], asked)
    assert alone.chains["live"].truth_error.value == pytest.approx(rule.error, rel=1e-9)


@pytest.mark.long
def test_a_cutoff_beyond_the_sample_rate_is_one_sentence() -> None:
    asked = study("study.filters.names=[live]")
    bounds = Bounds(
        gearboxes=("reference-5-1",), crossover=(8.0, 40.0), integral_corner=(0.5, 3.0), evaluations=16,
        numbers=(varied_number("live.cutoff=13000..20000 Hz", asked),),
    )  # fmt: skip
    with pytest.raises(InputError, match=r"--vary: .*needs a sample rate above .*lower the cutoff"):
        optimised(asked, "bldc-12n14p", bounds)
