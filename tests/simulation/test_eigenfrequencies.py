"""Eigenfrequencies F and G of the simulator survey 6.1, and A to G beside openTorsion; A to E alone: test_integrator.

Sources as the survey cites them: Friswell, Penny, Garvey & Lees, Dynamics of Rotating Machines, examples 9.6.3 and
9.7.1 and the geared branch; 10.1109/TIE.2010.2087301 (wind turbine); 10.1109/TIA.2015.2416128 (two-mass IPMSM).
"""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest

from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import Body, Coupling, Gear
from torquerig.simulation.linear import matrices
from torquerig.simulation.lower import lower
from torquerig.simulation.twin.linear_twin import twin_of


def case_f() -> Rig:
    """openTorsion's transient example: J .5 .1 .5 | .1 1, i = 8, k 5000 500 1000, c 10 .8 5, discs .2 .2 5."""
    i = 8.0
    return Rig(
        (
            Body(name="i1", inertia=0.5),
            Coupling(name="k1", after="i1", stiffness=5000, damping=10.0),
            Body(name="i2", after="k1", inertia=0.1),
            Coupling(name="k2", after="k1", stiffness=500, damping=0.8),
            # both gears in one rigid mesh: one node, the slow one's inertia and damping over i^2
            Body(name="gears", after="k2", inertia=0.5 + 0.1 / i**2, viscous=0.2 + 0.2 / i**2),
            Gear(name="k3", after="k2", ratio=i, stiffness=1000, damping=5.0),
            Body(name="i5", after="k3", inertia=1.0, viscous=5.0),
        ),
        measured="k3",
    )


def test_case_f_undamped_frequencies_are_not_the_magnitudes_of_the_damped_roots() -> None:
    """The trap: 5.0097, 6.6550, 40.3541 Hz undamped; |lambda| / 2 pi of the damped system 5.0186, 6.6420, 40.3538."""
    found = twin_of(case_f()).modes()
    assert [mode.undamped for mode in found] == pytest.approx([5.0097, 6.6550, 40.3541], abs=6e-5)
    assert [mode.magnitude for mode in found] == pytest.approx([5.0186, 6.6420, 40.3538], abs=6e-5)


def shaft(length: float, diameter: float) -> float:
    """Stiffness of a round steel shaft [N m/rad], G = 68e9 Pa."""
    return 68e9 * pi * diameter**4 / 32 / length


def case_g() -> Rig:
    """Friswell 9.6.3: disc 3200 on a shaft to two gears of R 0.5, each drives a gear of R 0.8 and a disc 450."""
    ratio = 0.8 / 0.5
    gears = 200 + 200 + 2 * 800 / ratio**2  # four rigid meshes turn as one
    return Rig(
        (
            Body(name="disc", inertia=3200),
            Coupling(name="input", after="disc", stiffness=shaft(2.5, 0.20), damping=0.0),
            Body(name="gears", after="input", inertia=gears),
            Gear(name="left", after="input", ratio=-ratio, stiffness=shaft(3.5, 0.25), damping=0.0, output_inertia=450),
            Gear(name="right", after="input", ratio=ratio, stiffness=shaft(3.5, 0.25), damping=0.0, output_inertia=450),
        ),
        measured="input",
    )


def test_case_g_friswell_9_6_3() -> None:
    assert [mode.undamped for mode in twin_of(case_g()).modes()] == pytest.approx([10.304, 20.479, 24.423], abs=6e-4)


def test_case_g_shapes_are_told() -> None:
    """The second mode is the two equal branches against each other, the gears still: clamped at the gears."""
    second = twin_of(case_g()).modes()[1]
    assert second.undamped == pytest.approx(sqrt(shaft(3.5, 0.25) / 450) / (2 * pi), rel=1e-9)
    assert "left against right" in second.words or "right against left" in second.words
    assert "disc and input + gears nearly still" in second.words


def test_case_d_anti_resonance_seen_from_the_motor() -> None:
    """J 0.005 twice, k 700: mode at 84.217 Hz, anti-resonance of the motor's speed at sqrt(k/J2) = 59.550 Hz."""
    rig = Rig(
        (
            Body(name="motor", inertia=0.005),
            Coupling(name="shaft", after="motor", stiffness=700, damping=0.0),
            Body(name="load", after="shaft", inertia=0.005),
        ),
        measured="shaft",
    )
    twin = twin_of(rig)
    assert [mode.undamped for mode in twin.modes()] == pytest.approx([84.217], abs=6e-4)
    frequency = np.linspace(59.0, 60.0, 2001)
    speed = np.abs(twin.open_loop.transfer("torque on motor", "speed of motor", frequency))
    assert frequency[speed.argmin()] == pytest.approx(59.550, abs=6e-4)


CHAINS = {
    "A": ((211.4, 8.3), (9.775e6,)),
    "B": ((3.5e-3, 3.5e-3, 3.5e-3, 0.15, 0.05), (12e3, 12e3, 14e3, 10e3)),
    "C": ((1e7, 5770, 97030), (3.67e8, 5.496e9)),
    "D": ((0.005, 0.005), (700,)),
}


@pytest.mark.parametrize("case", CHAINS)
def test_chains_beside_opentorsion(case: str) -> None:
    ot = pytest.importorskip("opentorsion", reason="openTorsion is not installed (pip install opentorsion)")
    inertias, stiffnesses = CHAINS[case]
    parts: list[Part] = [Body(name="j0", inertia=inertias[0])]
    for row, (k, inertia) in enumerate(zip(stiffnesses, inertias[1:], strict=True), start=1):
        parts += [
            Coupling(name=f"k{row}", after=parts[-1].name, stiffness=k, damping=1e-6 * k),
            Body(name=f"j{row}", after=f"k{row}", inertia=inertia),
        ]
    ours = twin_of(Rig(tuple(parts), measured="k1"))
    discs = [ot.Disk(row, inertia) for row, inertia in enumerate(inertias)]
    shafts = [ot.Shaft(row, row + 1, k=k, c=1e-6 * k) for row, k in enumerate(stiffnesses)]
    theirs = ot.Assembly(shafts, disk_elements=discs)
    system = matrices(ours.lowered)
    assert system.mass == pytest.approx(theirs.M)
    assert system.damping == pytest.approx(theirs.C)
    assert system.stiffness == pytest.approx(theirs.K)
    undamped = np.sqrt(np.sort(theirs.undamped_modal_analysis()[0].real)[1:]) / (2 * pi)
    assert [mode.undamped for mode in ours.modes()] == pytest.approx(undamped, rel=1e-9)
    with np.errstate(invalid="ignore"):  # it divides 0 by 0 for the damping ratio of free turning
        magnitude = theirs.modal_analysis()[0][2::2] / (2 * pi)
    assert [mode.magnitude for mode in ours.modes()] == pytest.approx(magnitude, rel=1e-9)


def test_cases_f_and_g_beside_opentorsion() -> None:
    """Like with like: its modal_analysis gives |lambda| of the damped rig, undamped_modal_analysis M and K alone."""
    ot = pytest.importorskip("opentorsion", reason="openTorsion is not installed (pip install opentorsion)")
    fast = ot.Gear(2, I=0, R=10)
    theirs = ot.Assembly(
        [ot.Shaft(0, 1, k=5000, c=10), ot.Shaft(1, 2, k=500, c=0.8), ot.Shaft(3, 4, k=1000, c=5)],
        disk_elements=[ot.Disk(0, 0.5), ot.Disk(1, 0.1), ot.Disk(2, 0.5, c=0.2), ot.Disk(3, 0.1, c=0.2),
                       ot.Disk(4, 1, c=5)],
        gear_elements=[fast, ot.Gear(3, I=0, R=80, parent=fast)],
    )  # fmt: skip
    ours = twin_of(case_f()).modes()
    with np.errstate(invalid="ignore"):
        damped = np.sort(theirs.modal_analysis()[0])[2:]  # a root of free turning and one of the bearings' drag
    assert sorted(mode.magnitude for mode in ours for _ in range(2)) == pytest.approx(damped / (2 * pi), rel=1e-6)
    undamped = np.sqrt(np.sort(theirs.undamped_modal_analysis()[0].real)[1:]) / (2 * pi)
    assert [mode.undamped for mode in ours] == pytest.approx(undamped, rel=1e-6)
    first = ot.Gear(1, 200, 0.5)
    second = ot.Gear(2, 200, 0.5, parent=first)
    steel = {"G": 68e9, "rho": 0}
    nine = ot.Assembly(
        [ot.Shaft(0, 1, 2.5e3, 200, **steel), ot.Shaft(3, 5, 3.5e3, 250, **steel), ot.Shaft(4, 6, 3.5e3, 250, **steel)],
        disk_elements=[ot.Disk(0, 3200), ot.Disk(5, 450), ot.Disk(6, 450)],
        gear_elements=[first, second, ot.Gear(3, 800, 0.8, parent=first), ot.Gear(4, 800, 0.8, parent=second)],
    )
    undamped = np.sqrt(np.sort(nine.undamped_modal_analysis()[0].real)[1:]) / (2 * pi)
    assert [mode.undamped for mode in twin_of(case_g()).modes()] == pytest.approx(undamped, rel=1e-6)


def test_geared_branch_e_beside_opentorsion() -> None:
    ot = pytest.importorskip("opentorsion", reason="openTorsion is not installed (pip install opentorsion)")
    gear = ot.Gear(1, 25e-6, 1)
    theirs = ot.Assembly(
        [ot.Shaft(0, 1, k=1e4), ot.Shaft(2, 3, k=5e3), ot.Shaft(1, 4, k=5e3)],
        disk_elements=[ot.Disk(0, 400e-6), ot.Disk(3, 700e-6), ot.Disk(4, 700e-6)],
        gear_elements=[gear, ot.Gear(2, 25e-6, 1, parent=gear)],
    )
    parts = (
        Body(name="motor", inertia=400e-6),
        Coupling(name="shaft", after="motor", stiffness=1e4, damping=0.0),
        Body(name="gears", after="shaft", inertia=50e-6),
        Gear(name="right", after="shaft", ratio=-1.0, stiffness=5e3, damping=0.0, output_inertia=700e-6),
        Coupling(name="left", after="shaft", stiffness=5e3, damping=0.0),
        Body(name="disc", after="left", inertia=700e-6),
    )
    undamped = np.sqrt(np.sort(theirs.undamped_modal_analysis()[0].real)[1:]) / (2 * pi)
    found = matrices(lower(Rig(parts, measured="shaft"), 0)).undamped_frequencies()[1:]
    assert found == pytest.approx(undamped, rel=1e-6)
    assert undamped == pytest.approx([425.4, 634.1, 3247.2], abs=0.06)
