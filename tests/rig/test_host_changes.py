"""What effects change inside their hosts: each kind is used, each host collects what it takes and refuses the rest."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, get_args

import pytest

from tests.mechanisms.test_every_mechanism_obeys_its_laws import IDS, ROWS, Row
from tests.mechanisms.test_every_mechanism_obeys_its_laws import rig as lawful
from torquerig.errors import InputError
from torquerig.mechanisms import GearMesh
from torquerig.recordings.run import Run
from torquerig.rig import parts
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import (
    AmplifierCutoff,
    DriveRipple,
    EncoderAngleError,
    ExtraGap,
    HostChange,
    KinematicError,
    StiffnessVariation,
)
from torquerig.rig.parts import (
    BeltStage,
    Body,
    Coupling,
    ForceSensor,
    Gear,
    InductionDrive,
    LinearDrive,
    Link,
    Motor,
    MotorEncoder,
    ReactionTorqueSensor,
    Slide,
    SpeedController,
    TorqueController,
    TorqueSensor,
    WormGear,
)
from torquerig.rig.terms import Wave

WAVES = (Wave(order=3.0, amplitude=0.01, phase=0.2),)
CHANGES: tuple[HostChange, ...] = (
    DriveRipple(WAVES),
    EncoderAngleError(WAVES),
    KinematicError(WAVES),
    StiffnessVariation(WAVES),
    ExtraGap(1e-3),
    AmplifierCutoff(10.0),
)
KINDS = set(get_args(HostChange))
SPRING: dict[str, Any] = {"stiffness": 100.0, "damping": 0.1}
SENSOR: dict[str, Any] = {**SPRING, "bandwidth": 1000.0}
RIGS: dict[str, tuple[Part, ...]] = {  # each part named host is one of those that take changes
    "motor, speed controller": (
        Motor(name="host", inertia=1e-3, torque_limit=1.0), SpeedController(name="loop", motor="host", kp=0.1, ki=0.1),
    ),
    "motor, torque controller": (
        Motor(name="host", inertia=1e-3, torque_limit=1.0), TorqueController(name="loop", motor="host", torque=0.1),
    ),
    "motor, encoder": (
        Motor(name="host", inertia=1e-3, torque_limit=1.0), SpeedController(name="loop", motor="host", kp=0.1, ki=0.1),
        MotorEncoder(name="encoder", controller="loop"),
    ),
    "gear": (Gear(name="host", after="root", ratio=3.0, **SPRING, output_inertia=1e-3),),
    "belt": (
        BeltStage(name="host", after="root", pinion_teeth=20, wheel_teeth=40, belt_teeth=100, pitch=5e-3,
                  belt_stiffness=1e5, strand_damping=1.0, wheel_inertia=1e-3),
    ),
    "worm gear": (
        WormGear(name="host", after="root", starts=2, wheel_teeth=40, lead_angle=0.3, friction=0.05, **SPRING,
                 wheel_inertia=1e-3),
    ),
    "linear drive": (LinearDrive(name="host", after="root", lead=0.01, **SPRING, mass=1.0),),
    "coupling": (Coupling(name="host", after="root", **SPRING, inertia=1e-3),),
    "torque sensor": (TorqueSensor(name="host", after="root", **SENSOR, inertia=1e-3),),
    "reaction torque sensor": (
        Motor(name="motor", inertia=1e-3, torque_limit=1.0),
        ReactionTorqueSensor(name="host", motor="motor", **SENSOR, housing_inertia=1e-3),
    ),
    "link": (Link(name="host", after="table", **SPRING, mass=1.0),),
    "force sensor": (ForceSensor(name="host", after="table", **SENSOR, mass=1.0),),
}  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Effect(Part):
    """It changes one thing inside its host."""

    at: str | None = "host"
    change: HostChange

    def changes_in_host(self, rig: Rig) -> tuple[HostChange, ...]:
        """Return it."""
        return (self.change,)


def machine(name: str, *effects: Part) -> Rig:
    """Return a rig around one host, standing on a shaft or a table."""
    return Rig((Body(name="root", inertia=1e-2), Slide(name="table", mass=2.0), *RIGS[name], *effects), Run(speed=10.0))


def host_in(name: str) -> Part:
    return machine(name).part("host")


def test_the_examples_hold_every_kind_of_change_and_every_host() -> None:
    assert {type(change) for change in CHANGES} == KINDS
    taking = {cls for name in parts.__all__ if (cls := getattr(parts, name)).takes}
    assert {type(host_in(name)) for name in RIGS} == taking


@pytest.mark.parametrize("kind", sorted(KINDS, key=lambda kind: kind.__name__), ids=lambda kind: kind.__name__)
def test_each_kind_is_used_by_a_mechanism_and_taken_by_a_host(kind: type) -> None:
    used = [
        row.effect.kind
        for row in ROWS
        for change in row.effect.changes_in_host(lawful(row.effect, speed_rpm=600.0))
        if isinstance(change, kind)
    ]
    assert used, "no mechanism changes this in its host: drop the kind"
    assert any(kind in host_in(name).takes for name in RIGS)


@pytest.mark.parametrize("name", RIGS)
@pytest.mark.parametrize("change", CHANGES, ids=lambda change: type(change).__name__)
def test_a_host_collects_what_it_takes_and_refuses_the_rest(name: str, change: HostChange) -> None:
    """What is taken is seen in the physics or in the measuring chain; the same on another host is not."""
    plain, changed = machine(name), machine(name, Effect(name="it", change=change))
    if not isinstance(change, host_in(name).takes):
        with pytest.raises(InputError, match=r"it: .* has no place in 'host'"):
            changed.terms()
        return
    assert (changed.terms(), changed.stages("host")) != (plain.terms(), plain.stages("host"))


def test_an_induction_drive_collects_the_ripple() -> None:
    motor = Motor(name="host", inertia=1e-3, torque_limit=1.0)
    drive = InductionDrive(name="mains", motor="host", pole_pairs=2, rated_torque=1.0, rated_speed=149.0,
                           breakdown_torque=3.0)  # fmt: skip
    plain, changed = (Rig((motor, drive, *more)) for more in ((), (Effect(name="it", change=DriveRipple(WAVES)),)))
    assert plain.terms() != changed.terms()


def test_an_effect_without_a_host_is_refused() -> None:
    with pytest.raises(InputError, match="it: a gap has no place in no part; name one of host"):
        machine("gear", Effect(name="it", at=None, change=ExtraGap(1e-3))).terms()


@pytest.mark.parametrize("row", ROWS, ids=IDS)
def test_every_mechanism_changes_the_terms_or_the_stages_of_a_rig(row: Row) -> None:
    """A question that a host forgot to ask would leave both as they are."""
    plain, with_it = lawful(*row.others, speed_rpm=600.0), lawful(*row.others, row.effect, speed_rpm=600.0)
    before, after = ((repr(rig.terms()), repr(rig.stages())) for rig in (plain, with_it))
    assert before != after


def test_changes_come_in_the_order_of_the_effects_and_add_up() -> None:
    first, second = (Effect(name=name, change=ExtraGap(gap)) for name, gap in (("first", 1e-3), ("second", 2e-3)))
    rig = machine("gear", first, second)
    assert rig.changes_in("host") == (ExtraGap(1e-3), ExtraGap(2e-3))
    assert [term.gap for term in rig.terms() if getattr(term, "name", "") == "host"] == [1e-3 + 2e-3]


def test_a_host_sees_the_effects_of_no_other_part() -> None:
    mesh = GearMesh(name="mesh", gear="gearbox", order_output=84, transmission_error=(1e-5,))
    rig = lawful(mesh, replace(mesh, name="other", gear="coupling"), speed_rpm=600.0)
    assert len(rig.changes_in("gearbox")) == len(rig.changes_in("coupling")) == 1
    assert rig.changes_in("torque_sensor") == ()
