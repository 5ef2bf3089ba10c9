"""Which meshes are proposed from found lines."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from torquerig import mechanisms
from torquerig.inference.additions import gear_mesh
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.places import order


def context_of(*orders: float) -> SimpleNamespace:
    return SimpleNamespace(lines=[FoundLine(order(at), -50.0, 0.0) for at in orders], order_step=1e-3)


@pytest.mark.parametrize("angle", [1.0, 0.9997])
def test_side_lines_are_measured_from_the_found_mesh(angle):
    lines = [turns * angle for turns in (77 / 5, 16.0, 83 / 5, 32.0, 48.0)]
    mesh = {1: order(lines[1]), 2: order(lines[3]), 3: order(lines[4])}
    found = gear_mesh._side_lines(context_of(*lines), 0.2, 80.0, mesh)
    assert found == (3, (order(lines[0]), order(lines[2])))


def test_the_third_multiple_of_a_mesh_is_no_side_line_of_it():
    lines = (15.9982, 31.9929, 47.9894)  # without an angle, 240 - 1 teeth are within the error of an order
    mesh = {multiple: order(at) for multiple, at in enumerate(lines, start=1)}
    assert gear_mesh._side_lines(context_of(*lines), 0.2, 80.0, mesh) == (0, ())


def test_a_gear_has_one_number_of_teeth(monkeypatch):
    gear = SimpleNamespace(name="gearbox", kind="gear", teeth=())
    monkeypatch.setattr(gear_mesh, "gear_stages", lambda _: (gear,))
    monkeypatch.setattr(gear_mesh, "Twin", lambda _: SimpleNamespace(turns={"out": 0.2}))
    monkeypatch.setattr(gear_mesh, "_mesh", lambda *_, log_odds: [log_odds])
    known = mechanisms.GearMesh(name="m", order_output=80.0, transmission_error=(1e-5,))
    counts = []
    for meshes in ([], [known]):
        context = context_of(16.6)
        context.rig = SimpleNamespace(node=lambda _: "out", parts_of=lambda _, meshes=meshes: meshes)
        context.whole = lambda place, turns: round(place.at / turns)
        counts.append(len(list(gear_mesh.propose(context))))
    assert counts == [1, 0]
