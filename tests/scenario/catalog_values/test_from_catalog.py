"""What the catalog gives a part."""

from __future__ import annotations

from math import log, sqrt
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.parameter import Estimate
from torquerig.rig.parts import Coupling, Gear, Motor, TorqueSensor
from torquerig.scenario.catalog_values.from_catalog import FIELDS, filled_from_catalog
from torquerig.scenario.reading import KINDS

CATALOG = load_catalog(shipped_folder())
SHELVES = {
    "motor": CATALOG.motors,
    "gear": CATALOG.gearboxes,
    "torque_sensor": CATALOG.sensors,
    "coupling": CATALOG.couplings,
}
ENTRIES = [(kind, name) for kind, shelf in SHELVES.items() for name in shelf]


@pytest.mark.parametrize(("kind", "name"), ENTRIES, ids=[name for _, name in ENTRIES])
def test_every_entry_makes_a_part(kind: str, name: str) -> None:
    from pydantic import TypeAdapter

    filled = filled_from_catalog(CATALOG, name, kind=kind, name="p", seed=3, place="here")
    part = TypeAdapter(KINDS[kind]).validate_python({"name": "p", **filled.values})
    assert isinstance(part, Motor | Gear | TorqueSensor | Coupling)
    for effect in filled.effects:
        TypeAdapter(KINDS[effect.values["kind"]]).validate_python({"name": effect.name, **effect.values})


def test_a_damping_ratio_is_half_a_loss_factor() -> None:
    filled = filled_from_catalog(CATALOG, "bellows-10nm", kind="coupling", name="c", seed=1, place="here")
    low, high = CATALOG.coupling("bellows-10nm").damping_ratio.bounds
    assert 2 * low <= filled.values["loss_factor"] <= 2 * high
    assert "damping ratio" in filled.assumed["loss_factor"]


@pytest.mark.parametrize("stated", [{"damping": "1 N*m*s/rad"}, {"loss_factor": 0.1}])
def test_what_the_scenario_states_replaces_the_other_form_of_the_catalog(stated: dict[str, object]) -> None:
    for entry in ("bellows-10nm", "reference-coupling"):
        filled = filled_from_catalog(CATALOG, entry, kind="coupling", name="c", seed=1, place="here")
        assert not {"damping", "loss_factor"} & set(filled.without(stated).values)


def test_every_mapped_field_exists_on_both_sides() -> None:
    for kind, rows in FIELDS.items():
        # the drive and its motor are one entry, and a worm is a gearbox
        shelf = {"induction_drive": "motor", "worm_gear": "gear"}.get(kind, kind)
        entry = type(next(iter(SHELVES[shelf].values())))
        for target, source, _ in rows:
            assert target in KINDS[kind].__dataclass_fields__, (kind, target)
            assert source.split(".")[0] in entry.model_fields, (kind, source)


def test_reference_sensor_brings_its_converter() -> None:
    filled = filled_from_catalog(CATALOG, "reference-10nm", kind="torque_sensor", name="s", seed=1, place="here")
    assert filled.values["converter_bits"] == 16
    assert filled.values["converter_range"] == "10.0 V"


def test_shipped_folder_is_the_checkouts() -> None:
    assert shipped_folder() == Path(__file__).resolve().parents[3] / "catalogs"


def test_what_is_drawn_from_an_interval_may_be_turned_by_a_calibration() -> None:
    """Two draws of 0.01 to 0.04 N m, log-uniform, differ by ln 4 / sqrt 6 rms."""
    filled = filled_from_catalog(CATALOG, "HDS6A-0104A", kind="motor", name="m", seed=1, place="here")
    assert filled.uncertainties["coulomb"] == pytest.approx(log(4) / sqrt(6))
    assert "torque_limit" not in filled.uncertainties  # the end of a range
    by_name = {effect.name: effect for effect in filled.effects}
    assert by_name["m.cogging"].values["amplitude_rel_sd"] == pytest.approx(log(4 / 0.2) / sqrt(6))
    (six_pulse,) = (one for name, one in by_name.items() if name in {"m.ripple_24", "m.ripple_30"})
    assert six_pulse.uncertainties == {"depth": pytest.approx(log(10) / sqrt(6))}
    loss = filled_from_catalog(CATALOG, "jaw-14-19", kind="coupling", name="c", seed=1, place="here")
    low, high = CATALOG.coupling("jaw-14-19").loss_factor.bounds
    assert loss.uncertainties["loss_factor"] == pytest.approx(log(high / low) / sqrt(6))


def test_what_is_stated_keeps_its_own_spread() -> None:
    filled = filled_from_catalog(CATALOG, "bldc-12n14p", kind="motor", name="m", seed=1, place="here")
    assert filled.uncertainties == {"inertia": 0.08, "viscous": 0.3, "coulomb": 0.3}
    assert all(effect.values["amplitude_rel_sd"] == 0.25 for effect in filled.effects)


def test_the_spread_of_two_draws_is_what_their_logarithms_differ_by() -> None:
    rng = np.random.default_rng(1)
    known = Estimate(low=0.2, high=4.0)
    draws = np.log([[known.draw(rng) for _ in range(4000)] for _ in range(2)])
    assert known.part_rel_sd == pytest.approx(float(np.sqrt(np.mean((draws[0] - draws[1]) ** 2))), rel=0.03)
    assert Estimate(1.0).part_rel_sd == 0.0
