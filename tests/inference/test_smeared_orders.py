"""Lines of the rig's counts that no search can find are hypotheses without a found line."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from torquerig.inference import context


@pytest.mark.parametrize(("spread", "smeared"), [((True, True), [84.0]), ((False, True), [84.0]), ((False, False), [])])
def test_a_line_that_one_run_smears_and_others_show_too_weakly_is_a_hypothesis(monkeypatch, spread, smeared):
    lines = [SimpleNamespace(order=7.0)]
    monkeypatch.setattr(context, "Twin", lambda _: SimpleNamespace(lines=lambda: lines))
    monkeypatch.setattr(context, "skirts_of", lambda _, run, __: run)
    monkeypatch.setattr(context, "smears", lambda run, _, __: run.spreads)
    seen = [SimpleNamespace(run=SimpleNamespace(run=None, spreads=one, has_encoder=True)) for one in spread]
    fit = SimpleNamespace(fitted_rig=SimpleNamespace(at=lambda _: None))
    assert context.Context(fit, SimpleNamespace(seen=seen), ()).smeared([7.0, 84.0]) == smeared
