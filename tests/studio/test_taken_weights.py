"""Numbers that were moved on the page go to their place in the file, and no other."""

from __future__ import annotations

import json
import shutil

import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.reporting.moving.matrix_model import case_model
from torquerig.studio.comparing.taken_weights import moved_values
from torquerig.studio.session.tab_session import Session


@pytest.fixture
def session(tmp_path):
    for name in ("wear_rig.yaml", "filters.yaml", "matrix_example.yaml"):
        shutil.copy(shipped_scenarios() / name, tmp_path)
    return Session(tmp_path)


def test_what_was_not_moved_is_no_edit(session):
    document = session.open("matrix_example.yaml")
    model = json.loads(json.dumps(case_model(document.good)))  # as a page holds it
    assert moved_values(document, model) == ()


def test_weight_points_and_limit_of_a_matrix(session):
    document = session.open("matrix_example.yaml")
    model = json.loads(json.dumps(case_model(document.good)))
    criterion = next(one for one in model["criteria"] if one["knots"])
    criterion["weight"] += 0.25
    criterion["knots"][0][1] = model["profile"]["min"]
    limit = next(one for one in model["requirements"] if one["high"] is not None or one["low"] is not None)
    end, key = ("low", "min") if limit["low"] is not None else ("high", "max")
    limit[end] = 12.5
    moved = dict(moved_values(document, model))
    assert moved["criteria", criterion["name"], "weight"] == criterion["weight"]
    assert moved["criteria", limit["name"], "requirement", key] == 12.5
    for keys, number in moved.items():
        document = session.edit("matrix_example.yaml", keys, number)
    assert moved_values(document, model) == ()


def test_numbers_of_a_study(session):
    document = session.open("wear_rig.yaml")
    moved = {
        "criteria": [
            {"name": "price", "weight": 0.5, "knots": [[0, 5], [500, 4.5]]},
            {"name": "unknown", "weight": 1.0, "knots": None},
        ],
        "requirements": [{"name": "sensor torque", "low": None, "high": 9.0}],
    }  # fmt: skip
    assert moved_values(document, moved) == (
        (("study", "criteria", "price", "weight"), 0.5),
        (("study", "criteria", "price", "points", 500), 4.5),
        (("study", "requirements", "sensor torque", "max"), 9.0),
    )
