"""Real recordings with known answers: what the diagnosis names, and how far the held-out error falls.

They are not in the repository; without the folder ``shared/real-data`` beside it these tests are skipped.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from proof.real import brfd, emps, laas
from proof.real.figures import ERROR_MEASURES, diagnosed, error, figures, scenario_of
from proof.real.public import VARIABLE
from torquerig.diagnosis.motion.fitted import FittedMotion, fitted
from torquerig.diagnosis.motion.moved import moved_runs
from torquerig.mechanisms import Backlash, LugreFriction, StribeckFriction
from torquerig.rig.assembly import Part

REAL = Path(__file__).resolve().parents[2] / ".." / "shared" / "real-data"

recorded = pytest.mark.skipif(not REAL.is_dir(), reason="the real recordings (shared/real-data) are missing")


@pytest.fixture(autouse=True)
def _beside(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, str(REAL))


@pytest.mark.full
@recorded
def test_emps_friction_by_direction_is_named_and_its_ripple_left_unexplained() -> None:
    """Janot, Gautier & Brunot 2019: Fv 166.7 and 240.4 N s/m, Fc 20.1 and 20.6 N; nobody published the ripple."""
    outcome = diagnosed("emps")
    assert outcome.diagnosis.verdict == "unexplained"
    (finding,) = outcome.diagnosis.findings
    assert (finding.mechanism, finding.variant) == ("stribeck_friction", "by_direction")
    values = {name: each.value for name, each in finding.parameters.items()}
    assert values["viscous_Nms_forward"] == pytest.approx(166.7, rel=0.03)
    assert values["viscous_Nms_backward"] == pytest.approx(240.4, rel=0.03)
    assert values["coulomb_Nm_forward"] == pytest.approx(20.1, rel=0.1)
    assert values["coulomb_Nm_backward"] == pytest.approx(20.6, rel=0.1)
    held = {figure.model: figure.held_out for figure in figures("emps", outcome)}
    assert held["baseline"] > 65
    assert held["stribeck_friction"] < 5.1
    assert held["stribeck_friction (by_direction)"] < 4.35
    assert any(m.domain == "order" and abs(m.at - 400) < m.width for m in outcome.diagnosis.mismatch)
    line = outcome.neutrals[0]
    assert line.line.at == pytest.approx(400, abs=2)
    assert line.after < 0.8 * line.before


@pytest.mark.long
@recorded
def test_laas_cogging_is_named_at_order_72_with_its_tolerance_orders() -> None:
    outcome = diagnosed("laas")
    (finding,) = outcome.diagnosis.findings
    assert (finding.mechanism, finding.variant) == ("cogging", "tolerances")
    assert finding.parameters["order_motor"].value == 72
    assert finding.parameters["amplitude_A"].value == pytest.approx(0.185, rel=0.03)
    held = {figure.model: figure.held_out for figure in figures("laas", outcome)}
    assert held["baseline"] == pytest.approx(0.1395, rel=0.02)
    assert held["cogging (native)"] < 0.0525
    assert held["cogging (tolerances)"] < 0.042
    assert {18, 36} <= set(outcome.after.rig.part("cogging").amplitudes())


@pytest.mark.long
@recorded
def test_brfd_presliding_and_play_predict_runs_that_their_numbers_never_saw() -> None:
    """Numbers as ``python -m proof.real brfd`` fitted them to the first run; here nothing but the zero is fitted."""
    dry = {"coulomb": 12640.0, "static": 12640.0, "coulomb_backward": 9870.0, "static_backward": 9870.0}
    sliding = StribeckFriction(name="friction", at="drum", **dry, stribeck_speed=1e-7, smoothing=5e-3)
    bending = LugreFriction(name="friction", at="drum", **dry, stribeck_speed=1e-7, stiffness=3.2e6, damping=6e3)
    stiffer = LugreFriction(name="friction", at="drum", **dry, stribeck_speed=1e-7, stiffness=5.2e6, damping=1e4)
    play = Backlash(name="play", gear="bands", gap=3.16e-3)
    assert held_out_of_brfd(sliding) > 1.0
    assert held_out_of_brfd(bending) < 0.45
    assert held_out_of_brfd(stiffer, play) < 0.32


def held_out_of_brfd(*parts: Part) -> float:
    rig = scenario_of("brfd").rig
    runs = moved_runs(brfd.recordings(), rig, held_out=brfd.HELD)
    for part in parts:
        rig = rig + part
    model: FittedMotion = fitted(rig, runs, ())
    return error(model, runs, ERROR_MEASURES["brfd"])


@pytest.mark.parametrize("module", [emps, laas, brfd])
def test_each_source_is_named_by_revision_and_sha256(module: object) -> None:
    source = module.SOURCE  # type: ignore[attr-defined]
    assert set(source.paths) == set(source.sha256)
    assert all(len(digest) == 64 for digest in source.sha256.values())
    for name in source.paths:
        address = source.address(name)
        assert address.startswith(f"https://raw.githubusercontent.com/{source.repository}/{source.revision}/")
        assert " " not in address


def test_a_file_that_is_another_one_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    folder = tmp_path / laas.SOURCE.folder
    folder.mkdir()
    with pytest.raises(FileNotFoundError, match=f"there is no such file; set {VARIABLE}"):
        laas.recordings()
    np.savetxt(folder / laas.MAPPING, np.zeros((3, 7)), delimiter=",", header="odd")
    with pytest.raises(ValueError, match=r"its SHA-256 is [0-9a-f]{64}, not "):
        laas.recordings()
