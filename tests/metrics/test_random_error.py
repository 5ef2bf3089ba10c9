"""Standard errors of an rms by batch means, and the way of a load to the sensor, against closed forms."""

from __future__ import annotations

from math import sqrt
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import read_document
from torquerig.metrics.load_path import load_path
from torquerig.metrics.random_error import length_for, rms_standard_error
from torquerig.metrics.sizing.load_fidelity import rigid_fidelity
from torquerig.scenario.reading import read_scenario


def test_white_noise_has_the_textbook_standard_error() -> None:
    """sd / sqrt(2 n) of n independent normal values; 400 records, each of which estimates it within 25 %."""
    rng, count = np.random.default_rng(1), 2000
    found = [rms_standard_error(rng.normal(0.0, 2.0, count), rate=1000.0) or 0.0 for _ in range(400)]
    assert np.sqrt(np.mean(np.square(found))) == pytest.approx(2.0 / sqrt(2 * count), rel=0.05)


def test_it_is_the_scatter_of_repeated_records_of_a_slow_load() -> None:
    """A first-order process of 0.05 s: records of 10 s scatter as each predicts of itself (their rms within 20 %)."""
    rng, rate, tau = np.random.default_rng(2), 500.0, 0.05
    keep = np.exp(-1 / (rate * tau))
    rms, told = [], []
    for _ in range(120):
        kicks = rng.normal(0.0, sqrt(1 - keep**2), 5000)
        values = np.empty(5000)
        last = rng.normal()
        for step, kick in enumerate(kicks):
            last = keep * last + kick
            values[step] = last
        rms.append(float(np.sqrt(np.mean(values**2))))
        told.append(rms_standard_error(values, rate=rate) or 0.0)
    assert sqrt(float(np.mean(np.square(told)))) == pytest.approx(float(np.std(rms)), rel=0.2)


def test_a_short_record_tells_nothing_and_a_quiet_one_is_certain() -> None:
    assert rms_standard_error(np.ones(400), rate=1000.0) is None
    assert rms_standard_error(np.zeros(1000), rate=1000.0) == 0.0
    assert length_for(0.01, now=0.05, length=10.0) == pytest.approx(250.0)


def test_the_way_of_the_load_has_the_share_of_the_inertias_and_its_mode() -> None:
    catalog = load_catalog(shipped_folder())
    rig = read_scenario(
        read_document(Path(shipped_folder()).parent / "scenarios" / "wear_rig.yaml"), catalog, seed=1
    ).rig
    path = load_path(rig)
    assert path is not None
    assert path.inertia_share == rigid_fidelity(rig)
    assert path.largest > 1
    assert load_path(rig.without("load")) is None
