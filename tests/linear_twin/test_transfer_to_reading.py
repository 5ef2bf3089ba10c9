"""The grid of transfers against the state equations of ``simulate.twin``, another way to the same rig."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from torquerig.linear_twin.transfer import on_grid
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import ToothMesh, TorsionalMode
from torquerig.orders.kinematics.teeth import Planetary
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body, Gear
from torquerig.scenario.model import Scenario
from torquerig.simulation.twin.linear_twin import twin_of

PROBED = np.geomspace(0.5, 2000.0, 60)


def branched(wear_rig: Scenario) -> Rig:
    return wear_rig.rig + TorsionalMode(
        name="branch", after="wear_part", frequency=90.0, inertia=8e-4, damping_ratio=0.03
    )


@pytest.mark.parametrize("more", [False, True])
def test_a_torque_on_each_node_reads_as_the_state_equations_say(*, more: bool, wear_rig: Scenario) -> None:
    """With the losses of the gear, which a motor's ripple passes: 3 % on this rig, 20 % behind a worm."""
    rig = branched(wear_rig) if more else wear_rig.rig
    system = twin_of(rig).closed_loop
    found = on_grid(rig, rig.terms())
    near = np.array([found.frequency[np.argmin(np.abs(found.frequency - probed))] for probed in PROBED])
    for node, response in found.reading.items():
        exact = system.transfer(f"torque on {node}", f"torque in {rig.measured}", near)
        assert found.at(response, near) == pytest.approx(exact, rel=1e-8), node


def test_between_the_points_of_the_grid_a_resonance_is_kept(wear_rig: Scenario) -> None:
    rig = wear_rig.rig
    fine = np.linspace(100.0, 200.0, 4001)
    exact = np.abs(twin_of(rig).closed_loop.transfer("torque on coupling", f"torque in {rig.measured}", fine))
    shafts = on_grid(rig, rig.terms())
    response = np.abs(shafts.at(shafts.reading["coupling"], fine))
    assert response.max() == pytest.approx(exact.max(), rel=0.02)
    assert fine[response.argmax()] == pytest.approx(fine[exact.argmax()], rel=0.01)


@pytest.mark.long
@pytest.mark.parametrize("damping", [0.002, 0.01])
def test_a_sharp_mode_keeps_its_height_and_its_power(damping: float, wear_rig: Scenario) -> None:
    """Peak within 3 % of the state equations', and the mean power of a band 8 to the octave within 3 %."""
    rig = wear_rig.rig + TorsionalMode(
        name="branch", after="wear_part", frequency=90.0, inertia=4e-4, damping_ratio=damping
    )
    shafts, twin = on_grid(rig, rig.terms()), Twin(rig)
    fine = np.geomspace(80.0, 130.0, 40_001)
    exact = np.abs(
        twin_of(rig).closed_loop.transfer(f"torque on {rig.node('wear_part')}", f"torque in {rig.measured}", fine)
    )
    found = np.abs(shafts.at(shafts.reading[rig.node("wear_part")], fine))
    assert found.max() == pytest.approx(exact.max(), rel=0.03)
    low = 90.0 * 2 ** (np.arange(-1, 4) / 8)
    high = low * 2 ** (1 / 8)
    means = twin.load_power_between(low, high)
    for start, stop, mean in zip(low, high, means, strict=True):
        inside = np.linspace(start, stop, 20_001)
        assert mean == pytest.approx(twin.load_power(inside).mean(), rel=0.03)


def test_the_speed_loop_answers_as_the_state_equations_say(wear_rig: Scenario) -> None:
    """The drive's torque to a torque on the wear part: -C(s) times the motor's angle."""
    rig = wear_rig.rig
    shafts, drive = on_grid(rig, rig.terms()), Twin(rig).drives[0]
    near = shafts.frequency[(shafts.frequency > 0.2) & (shafts.frequency < 300)]
    s = 2j * np.pi * near
    speed = twin_of(rig).closed_loop.transfer(f"torque on {rig.node('wear_part')}", f"speed of {drive.on}", near)
    exact = -(drive.kp + drive.ki / s) / (1 + s * drive.lag) * speed
    assert shafts.at(shafts.drive[rig.node("wear_part")], near) == pytest.approx(exact, rel=1e-6, abs=1e-9)


def test_what_no_transfer_depends_on_is_not_solved_again(wear_rig: Scenario) -> None:
    rig = wear_rig.rig
    wear_part = rig.part("wear_part")
    assert isinstance(wear_part, Body)
    first = on_grid(rig, rig.terms())
    assert on_grid(rig.at(replace(rig.run, occupancy_percent=15.0)), rig.terms()) is first
    heavier = rig.changed(replace(wear_part, inertia=1.1 * wear_part.inertia))
    assert on_grid(heavier, heavier.terms()) is not first


def test_a_kinematic_error_reads_as_the_state_equations_say(wear_rig: Scenario) -> None:
    rig = wear_rig.rig
    system, twin = twin_of(rig).closed_loop, Twin(rig)
    near = twin.shafts.frequency[(twin.shafts.frequency > 1) & (twin.shafts.frequency < 2000)]
    for spring in ("gearbox", "torque_sensor", "coupling"):
        exact = system.transfer(f"error of {spring}", f"torque in {rig.measured}", near) * twin.amplifier(near)
        # where the poles stand is the same; rounding differs by the size of the largest
        assert twin.error_in(spring)(near) == pytest.approx(exact, rel=1e-8, abs=1e-6), spring


def test_the_amplifier_is_a_second_order_butterworth(wear_rig: Scenario) -> None:
    twin = Twin(wear_rig.rig)
    f = np.array([30.0, 3000.0, 12_000.0])
    assert np.abs(twin.amplifier(f)) == pytest.approx(1 / np.sqrt(1 + (f / 3000.0) ** 4), rel=1e-12)


def test_a_torque_pair_is_the_difference_of_its_ends(wear_rig: Scenario) -> None:
    twin = Twin(wear_rig.rig)
    pair = twin.torque_on("motor", "coupling")(PROBED)
    assert pair == pytest.approx(twin.torque_on("motor")(PROBED) - twin.torque_on("coupling")(PROBED), abs=1e-9)


def test_a_varying_mesh_stiffness_is_the_line_that_its_load_makes(wear_rig: Scenario) -> None:
    """To first order the error s T/k; the torque T once from the steady run, once from the state equations' point."""
    gearbox = wear_rig.rig.part("gearbox")
    assert isinstance(gearbox, Gear)
    rig = wear_rig.rig.changed(replace(gearbox, teeth=(Planetary(21, 84, 3),)))
    rig += ToothMesh(name="mesh", module=1e-3, stiffness_variation=(0.05,))
    (found,) = (line for line in Twin(rig).lines() if line.owner == "gearbox")
    (expected,) = (line for line in twin_of(rig).order_lines() if line.cause == "mesh")
    assert found.order == pytest.approx(expected.order, rel=1e-12)
    assert found.amplitude == pytest.approx(expected.amplitude, rel=0.02)
    assert found.amplitude > 0


def test_what_the_amplifier_leaves_of_a_density_is_the_square_of_what_it_leaves_of_a_line(wear_rig: Scenario) -> None:
    twin = Twin(wear_rig.rig)
    np.testing.assert_allclose(twin.amplifier_power(PROBED), np.abs(twin.amplifier(PROBED)) ** 2, rtol=1e-12)
