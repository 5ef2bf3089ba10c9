"""A recording that a study replays is part of its identity, and may not change while it runs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from torquerig.cases import Failed
from torquerig.cases.identity import refuse_other
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import open_study
from torquerig.study.monte_carlo.drawn_case import drawn_rows
from torquerig.study.monte_carlo.drawn_study import DrawnStudy, cases_of_draws, drawn_study

EDITS = (
    "study.motors=[HDS6A-0104A]", "study.gearboxes=[reference-5-1]", "study.present.motor=HDS6A-0104A",
    "study.duration=0.2 s", "study.filters.names=[none]", "study.present.filter=none",
)  # fmt: skip


def written(path: Path, amplitude: float) -> Path:
    """Write a torque of 4 s, which is longer than settling and record."""
    time = np.arange(4000) / 1000
    torque = amplitude * np.sin(2 * np.pi * 3 * time)
    np.savetxt(path, np.column_stack([time, torque]), delimiter=",", header="time_s,torque_Nm", comments="")
    return path


def replaying(path: Path) -> DrawnStudy:
    """Return the draws of a wear rig on which a recorded torque acts as well."""
    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), EDITS)
    data: dict[str, Any] = document.data
    data["rig"]["push"] = {
        "kind": "replayed_torque", "at": "wear_part", "recording": str(path), "channel": "torque_Nm",
    }  # fmt: skip
    return drawn_study(open_study(document, load_catalog(shipped_folder())))


@pytest.mark.long
def test_a_changed_recording_is_another_study_and_no_row_of_this_one(tmp_path: Path) -> None:
    path = written(tmp_path / "push.csv", 0.1)
    drawn = replaying(path)
    cases = cases_of_draws(drawn, 1)
    (row,) = drawn_rows(drawn, cases)
    assert isinstance(row, dict)
    identity = drawn.identity("draws")
    written(path, 0.2)
    (changed,) = drawn_rows(drawn, cases)
    assert isinstance(changed, Failed)
    assert changed.error == f"{path} changed while the study ran; delete the store and run the study again"
    with pytest.raises(InputError, match=r"holds another study: its recording .*push\.csv is"):
        refuse_other(identity.as_json(), replaying(path).identity("draws"), folder=tmp_path)
    (other,) = drawn_rows(replaying(path), cases)
    assert isinstance(other, dict)
    assert other["reading_error_none"] != row["reading_error_none"]
