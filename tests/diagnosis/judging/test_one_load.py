"""A load of one particle size has one spectrum: what only one of its runs shows is the rig's."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.judging import band_excess, one_load
from torquerig.diagnosis.judging.one_load import load_contradictions

BAND = np.geomspace(5.0, 1000.0, 60)
COUNT = 100.0


class Run(SimpleNamespace):
    """What is asked of features here; one is like itself alone, as they are."""

    __hash__ = object.__hash__
    __eq__ = object.__eq__


def run(
    occupancy: float, seed: int, *, particles: float = 5e-4, shape: Any = 0.0, share: float = 1.0,
    lost: tuple[tuple[int, int], ...] = (),
) -> Any:  # fmt: skip
    """A run whose density lies above the model's by ``shape`` (of the logarithm), less chance."""
    chance = np.random.default_rng(seed).normal(0.0, COUNT**-0.5, BAND.size)
    half = BAND * 0.05
    return Run(
        turning=None, band=BAND, count=np.full(BAND.size, COUNT), power=np.exp(chance + shape), share=share,
        band_edges=(BAND - half, BAND + half),
        observed=SimpleNamespace(
            name=f"run{seed}", recording=lost, run=SimpleNamespace(occupancy_percent=occupancy, particle_size=particles)
        ),
    )  # fmt: skip


def found(monkeypatch: pytest.MonkeyPatch, *runs: Any, corrections: tuple[int, ...] = ()) -> list[tuple[str, float]]:
    def model(_: object, features: Any) -> Any:
        return SimpleNamespace(
            power=np.ones(BAND.size), load_share=np.full(BAND.size, features.share), power_tolerance=0.0
        )

    monkeypatch.setattr(band_excess, "expected", model)
    monkeypatch.setattr(one_load, "moments_without_signal", lambda lost: lost)
    case = SimpleNamespace(seen=runs, model=SimpleNamespace(rig=None, corrections=corrections))
    return [(left.recordings[0], left.at) for left in load_contradictions(cast("Case", case), 100.0)]


PEAK = 2.0 * np.exp(-((np.log(BAND / 190.0) / 0.15) ** 2))  # a mode that stands elsewhere under this load
NULLS = -2.0 * np.cos(BAND / 30.0) ** 8  # pulses of another shape than the model's


def test_a_mode_that_moves_with_the_load_is_left(monkeypatch: pytest.MonkeyPatch) -> None:
    left = found(monkeypatch, run(5, 1), run(15, 2, shape=PEAK), run(5, 3))
    assert {name for name, _ in left} == {"run1", "run2", "run3"}
    assert all(at == pytest.approx(190.0, rel=0.1) for _, at in left)


@pytest.mark.parametrize("seed", range(20))
def test_a_shape_that_all_runs_share_is_the_loads(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    runs = [run(load, 3 * seed + at, shape=NULLS + 0.5 * at) for at, load in enumerate((5.0, 15.0, 8.0))]
    assert found(monkeypatch, *runs) == []


def test_particles_of_another_size_hit_otherwise(monkeypatch: pytest.MonkeyPatch) -> None:
    assert found(monkeypatch, run(5, 1), run(15, 2, shape=PEAK, particles=2e-3)) == []


def test_an_idle_run_is_not_compared(monkeypatch: pytest.MonkeyPatch) -> None:
    assert found(monkeypatch, run(5, 1), run(0, 2, shape=PEAK)) == []


def test_where_the_load_does_not_rule_nothing_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    assert found(monkeypatch, run(5, 1), run(15, 2, shape=PEAK, share=0.5)) == []


def test_a_run_with_moments_without_signal_is_not_compared(monkeypatch: pytest.MonkeyPatch) -> None:
    assert found(monkeypatch, run(5, 1), run(15, 2, shape=PEAK, lost=((100, 150),))) == []


def test_what_stands_in_a_dip_fills_it_in_one_run_more_than_in_another(monkeypatch: pytest.MonkeyPatch) -> None:
    dip = -np.exp(-((np.log(BAND / 400.0) / 0.1) ** 2))
    assert found(monkeypatch, run(5, 1, shape=3.5 * dip), run(15, 2, shape=2.5 * dip)) == []
    assert found(monkeypatch, run(5, 1, shape=0.7 * PEAK), run(15, 2, shape=-0.2 * PEAK)) != []


def test_beside_a_gap_nothing_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    assert found(monkeypatch, run(5, 1), run(15, 2, shape=PEAK), corrections=(1,)) == []
