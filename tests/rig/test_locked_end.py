"""A locked end, friction at every part, and the zero of springs and gaps, against closed forms."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from math import pi, sqrt
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.catalog.search import catalog_for
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.mechanisms import Backlash
from torquerig.recordings.run import Run
from torquerig.rig import parts
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import (
    BeltStage,
    Body,
    Coupling,
    ForceSensor,
    Gear,
    Ground,
    ImposedMotion,
    LinearDrive,
    Link,
    Motor,
    SpeedController,
    TorqueController,
    TorqueSensor,
    WormGear,
)  # fmt: skip
from torquerig.rig.steady import steady_torque
from torquerig.rig.terms import GROUND, AppliedTorque, Friction, Term
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate
from torquerig.simulation.twin.linear_twin import twin_of


@dataclass(frozen=True)
class Constant:
    """One torque for all time."""

    mean: float

    def sample(self, count: int, rate: float, rng: np.random.Generator) -> NDArray[np.float64]:
        return np.full(count, self.mean)


@dataclass(frozen=True, kw_only=True)
class Push(Part):
    """A torque from outside."""

    at: str
    torque: float

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        return (AppliedTorque(name=self.name, on=rig.node(self.at), process=Constant(self.torque)),)


def locked(*more: Part, **shaft: float) -> Rig:
    bar = Coupling(name="bar", after="wheel", stiffness=400.0, damping=1.0, **shaft)
    wheel = Body(name="wheel", inertia=0.01)
    return Rig((wheel, bar, Ground(name="wall", after="bar"), *more), measured="bar")


def torque_at_end(rig: Rig, duration: float = 1.0, settling: float = 0.0) -> float:
    made = simulate(rig, duration=duration, seed=0, settling=settling, sample_rate=2000.0)
    return float(made.channels["true_sensor_torque_Nm"].values[-1])


def test_a_mass_on_a_locked_spring_has_its_textbook_frequency_and_no_rigid_motion() -> None:
    (mode,) = twin_of(locked()).modes()
    assert mode.undamped == pytest.approx(sqrt(400.0 / 0.01) / (2 * pi), rel=1e-12)


def test_a_locked_spring_bears_what_pushes_on_it() -> None:
    """3 N m against 400 N m/rad, damping ratio 0.25: at rest after 1 s to exp(-50)."""
    rig = locked(Push(name="push", at="wheel", torque=3.0))
    made = simulate(rig, duration=1.0, seed=0, settling=0.0, sample_rate=2000.0)
    assert made.channels["true_sensor_torque_Nm"].values[-1] == pytest.approx(3.0, rel=1e-9)
    assert made.channels["true_motor_angle_rad"].values[-1] == pytest.approx(3.0 / 400.0, rel=1e-9)


def test_the_frame_as_first_part_is_the_same_with_the_other_sign() -> None:
    bar = Coupling(name="bar", after="wall", stiffness=400.0, damping=1.0, inertia=0.01)
    turned = Rig((Ground(name="wall"), bar, Push(name="push", at="bar", torque=3.0)), measured="bar")
    assert torque_at_end(turned) == pytest.approx(-torque_at_end(locked(Push(name="push", at="wheel", torque=3.0))))


@pytest.mark.parametrize("settling", [0.0, 0.5])
def test_a_spring_starts_at_its_rest_angle_and_counts_from_there(settling: float) -> None:
    rig = locked(Push(name="push", at="wheel", torque=3.0), rest_angle=0.2)
    made = simulate(rig, duration=1.0, seed=0, settling=settling, sample_rate=2000.0)
    torque, angle = (made.channels[name].values for name in ("true_sensor_torque_Nm", "true_motor_angle_rad"))
    assert torque[0] == pytest.approx(0.0, abs=1e-9)
    assert angle[-1] == pytest.approx(0.2 + 3.0 / 400.0, rel=1e-9)
    assert np.allclose(torque, 400.0 * (angle - 0.2), atol=3.0)


def test_the_linear_twin_knows_the_rest_angle() -> None:
    held = TorqueController(name="drive", motor="motor", torque=0.0)
    motor = Motor(name="motor", inertia=0.01, torque_limit=5.0)
    bar = Coupling(name="bar", after="motor", stiffness=400.0, damping=1.0, rest_angle=0.2)
    rig = Rig((motor, bar, Ground(name="wall", after="bar"), held), Run(speed=0.0), measured="bar")
    # 80 N m without the rest angle; the least squares of the balance leave the torque of the drive a part in 1e5
    assert twin_of(rig).point.spring_torques == pytest.approx([0.0], abs=1e-2)


def imposed(*, middle: float, rest: float) -> NDArray[np.float64]:
    """Return the torque of a gap of 0.1 rad on 1000 N m/rad while one side is held and the other turned by 1 rad/s."""
    gear = Gear(name="gear", after="crank", ratio=1, stiffness=1000.0, damping=0.0, backlash=0.1, rest_angle=rest)
    rig = Rig(
        (
            Body(name="crank", inertia=1.0), gear, Body(name="drum", after="gear", inertia=1.0),
            ImposedMotion(name="turn", at="crank"), ImposedMotion(name="hold", at="drum", factor=1e-9),
            *([Backlash(name="play", gear="gear", gap=0.0, middle=middle)] if middle else []),
        ), Run(speed=1.0), measured="gear",
    )  # fmt: skip
    made = simulate(rig, duration=0.5, seed=0, settling=0.0, sample_rate=1000.0)
    return made.channels["true_sensor_torque_Nm"].values


@pytest.mark.parametrize(("middle", "rest"), [(0.0, 0.0), (0.2, 0.0), (0.0, 0.2), (0.15, 0.05)])
def test_a_gap_closes_where_its_middle_and_the_spring_zero_say(middle: float, rest: float) -> None:
    angle = np.arange(500) / 1000.0
    expected = 1000.0 * np.clip(angle - middle - rest - 0.05, 0.0, None)
    expected += 1000.0 * np.clip(angle - middle - rest + 0.05, None, 0.0)
    assert imposed(middle=middle, rest=rest) == pytest.approx(expected, abs=1e-5)


def test_a_rest_angle_changes_nothing_in_a_free_chain() -> None:
    """No second path and no locked end: the chain settles to the same torques."""
    one, other = (driven(rest_angle=value) for value in (0.0, 0.3))
    first, second = (simulate(rig, duration=0.2, seed=0, settling=0.2) for rig in (one, other))
    name = "true_sensor_torque_Nm"
    assert second.channels[name].values == pytest.approx(first.channels[name].values, abs=1e-9)


def driven(*more: Part, speed: float = 50.0, **shaft: float) -> Rig:
    motor = Motor(name="motor", inertia=2e-4, torque_limit=5.0)
    bar = Coupling(name="bar", after="motor", stiffness=400.0, damping=0.1, inertia=1e-4, **shaft)
    wheel = Body(name="wheel", after="bar", inertia=2e-3)
    return Rig(
        (motor, bar, wheel, SpeedController(name="loop", kp=0.05, ki=0.5), *more), Run(speed=speed), measured="bar"
    )


def test_a_set_point_on_a_locked_shaft_is_refused_with_a_remedy() -> None:
    with pytest.raises(InputError, match="set-point is 50 rad/s, but the shaft ends at a locked end"):
        driven(Ground(name="wall", after="wheel")).terms()
    driven(Ground(name="wall", after="wheel"), speed=0.0).terms()


def test_what_acts_on_a_locked_shaft_is_refused() -> None:
    with pytest.raises(InputError, match="push: it acts on a shaft that is locked"):
        locked(Push(name="push", at="wall", torque=1.0)).terms()


def test_the_name_of_the_frame_is_reserved() -> None:
    with pytest.raises(InputError, match="'ground' is the name of the frame"):
        Rig((Body(name="ground", inertia=1.0),))
    assert Rig((Ground(name="ground"),)).node("ground") == GROUND


def test_a_locked_end_is_written_and_read_in_a_scenario(tmp_path: Path) -> None:
    path = tmp_path / "locked.yaml"
    path.write_text(
        "operating_point: {}\nmeasured: bar\nrig:\n  wheel: {kind: body, inertia: 0.01 kg*m^2, coulomb: 0.2 N*m}\n"
        "  bar: {kind: coupling, stiffness: 400 N*m/rad, damping: 1 N*m*s/rad, rest_angle: 5 deg}\n"
        "  wall: {kind: ground}\n",
        encoding="utf-8",
    )
    made = read_scenario(read_document(path), catalog_for(path, ()), seed=1)
    assert made.rig.node("wall") == made.rig.node("bar") == GROUND
    path.write_text(made.text(), encoding="utf-8")
    assert read_scenario(read_document(path), catalog_for(path, ()), seed=1).rig.parts == made.rig.parts


STATED: dict[str, Part] = {
    "body": Body(name="x", after="motor", inertia=1e-3),
    "coupling": Coupling(name="x", after="motor", stiffness=500.0, damping=0.1, inertia=1e-3),
    "gear": Gear(name="x", after="motor", ratio=1.0, stiffness=500.0, damping=0.1, output_inertia=1e-3),
    "torque_sensor": TorqueSensor(name="x", after="motor", stiffness=500.0, damping=0.1, inertia=1e-3, bandwidth=1e3),
    "belt": BeltStage(
        name="x", after="motor", pinion_diameter=0.1, wheel_diameter=0.1, belt_length=1.0, belt_stiffness=1e5,
        strand_damping=100.0, wheel_inertia=1e-3,
    ),
    "worm_gear": WormGear(
        name="x", after="motor", starts=1, wheel_teeth=30, lead_angle=0.5, friction=0.0, stiffness=500.0, damping=0.1,
        wheel_inertia=1e-3,
    ),
    "linear_drive": LinearDrive(name="x", after="motor", lead=2 * pi, stiffness=500.0, damping=0.1, mass=1e-3),
    "link": Link(name="x", after="motor", stiffness=500.0, damping=0.1, mass=1e-3),
    "force_sensor": ForceSensor(name="x", after="motor", stiffness=500.0, damping=0.1, mass=1e-3, bandwidth=1e3),
}  # fmt: skip


@pytest.mark.parametrize("kind", STATED)
def test_friction_of_every_part_costs_its_torque(kind: str) -> None:
    """Coulomb 0.3 and viscous 0.01 at 20 rad/s: 0.5 N m more behind the ratio, forward and backward."""
    part = replace(STATED[kind], coulomb=0.3, viscous=0.01)  # type: ignore[call-arg]
    motor = Motor(name="motor", inertia=2e-4, torque_limit=5.0)
    loop = SpeedController(name="loop", kp=0.05, ki=0.5)
    ratio = getattr(part, "ratio", 1.0)
    for way in (1.0, -1.0):
        rig = Rig((motor, part, loop), Run(speed=20.0 * ratio * way), measured="x")
        assert steady_torque(rig, "motor") == pytest.approx(0.5 * way / ratio)


def test_every_part_that_opens_a_shaft_takes_friction_and_says_nothing_without() -> None:
    known = [getattr(parts, name) for name in parts.__all__]
    opening = [cls for cls in known if cls.opens_node and cls.on_shaft]
    assert {cls.kind for cls in opening} <= set(STATED)
    assert all({"viscous", "coulomb", "smoothing"} <= {one.name for one in fields(cls)} for cls in opening)
    motor = Motor(name="motor", inertia=2e-4, torque_limit=5.0)
    rigs = [Rig((motor, part), Run(speed=20.0), measured="x") for part in STATED.values()]
    assert not [term for rig in rigs for term in rig.part("x").terms(rig) if isinstance(term, Friction)]
