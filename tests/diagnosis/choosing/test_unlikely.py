"""A name that is likelier wrong than right is given up, and what it was to explain stays unexplained."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing import chain
from torquerig.diagnosis.choosing import confidence as judged
from torquerig.diagnosis.choosing.confidence import LEAST, confidence


def accepted(description: str = "") -> Any:
    candidate = SimpleNamespace(mechanism="gear_mesh", description=description, place=None)
    return SimpleNamespace(before=None, trial=SimpleNamespace(candidate=candidate))


@pytest.mark.parametrize(("rival", "stands"), [(0.0, True), (2000.0, False)])
def test_an_unlikely_name_falls(rival: float, stands: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    likely = confidence(gain=1000.0, share=0.7, rival=rival)
    assert (likely > LEAST) is stands
    monkeypatch.setattr(chain, "confidence_of", lambda final, each: likely)
    monkeypatch.setattr(chain, "can_be", lambda candidate, model: True)
    monkeypatch.setattr(chain, "rest_of", lambda final, each: 0.0)
    case: Any = SimpleNamespace(model=SimpleNamespace(rig=None))
    assert chain._stands(case, accepted()) is stands
    assert chain._stands(case, accepted("noise in one band")), "a description claims no cause"


@pytest.mark.parametrize(("missed", "stands"), [(20.0, False), (1000.0, True)])
def test_a_rest_is_hardly_any_beside_what_was_missed(
    missed: float, *, stands: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A stand-in of a large effect leaves more than some hundredths of it."""
    case: Any = SimpleNamespace(model=SimpleNamespace(rig=None))
    monkeypatch.setattr(chain, "confidence_of", lambda final, each: 0.99)
    monkeypatch.setattr(chain, "can_be", lambda candidate, model: True)
    monkeypatch.setattr(chain, "rest_of", lambda at, each: 10.0 if at is case else missed)
    assert chain._stands(case, accepted()) is stands


@pytest.mark.parametrize(("beside", "likely"), [(None, 0.3), (0.9, 0.9), (0.1, 0.3)])
def test_a_rival_that_another_effect_explains_away_is_none(
    beside: float | None, *, likely: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Blades came near a mesh while a low-pass was missing that bent the model, and do not beside it."""
    monkeypatch.setattr(judged, "_confidence", lambda final, each: each.told)
    again = None if beside is None else SimpleNamespace(told=beside, again=None)
    taken: Any = SimpleNamespace(told=0.3, again=again)
    assert judged.confidence_of(cast("Case", None), taken) == likely
