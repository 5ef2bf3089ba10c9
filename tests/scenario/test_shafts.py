"""The shafts of a rig: names, ratios, and the meshes, belts and bearings on each."""

from pathlib import Path

import pytest

from torquerig.mechanisms.bearing_defect import BearingDefect
from torquerig.mechanisms.gear_mesh import GearMesh
from torquerig.orders.kinematics.teeth import Spur
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import BeltStage, Body, Coupling, Gear, ImposedMotion, Motor, TorqueSensor
from torquerig.scenario.kinematics import kinematics_of

SPRING = {"stiffness": 1e4, "damping": 1.0}
MOTOR = Motor(name="drive", inertia=1e-3, viscous=0.0, coulomb=0.0, torque_limit=5.0, pole_pairs=4, slots=9)
SENSOR = {"sensitivity": 1.0, "bandwidth": 100.0, "noise_rms": 0.0, "inertia": 1e-4}


def chain(*, second_teeth: bool = True) -> Rig:
    """Motor, pair 20:60, belt 20:40, sensor, gear 2:1 behind it, drum."""
    belt = BeltStage(
        name="belt", after="first", pinion_teeth=20, wheel_teeth=40, belt_teeth=100, pitch=5e-3, belt_stiffness=1e5,
        strand_damping=10.0,
    )  # fmt: skip
    teeth = (Spur(18, 36),) if second_teeth else ()
    return Rig(
        (
            MOTOR,
            Gear(name="first", after="drive", ratio=3.0, teeth=(Spur(20, 60),), **SPRING),
            belt,
            TorqueSensor(name="torque_sensor", after="belt", **SPRING, **SENSOR),
            Gear(name="second", after="torque_sensor", ratio=-2.0, teeth=teeth, **SPRING),
            Body(name="drum", after="second", inertia=0.01),
        )
    )


def orders(rig: Rig, family: str) -> dict[str, tuple[float, float]]:
    lines = kinematics_of(rig).lines(1)
    return {line.label: (line.motor_order, line.output_order) for line in lines if line.family == family}


def test_every_shaft_has_its_ratio_and_its_parts():
    shafts = kinematics_of(chain()).shafts
    assert [(one.name, one.ratio, one.parts) for one in shafts] == [
        ("motor", 1.0, ("drive",)),
        ("first", 3.0, ("first",)),
        ("belt", 6.0, ("belt", "torque_sensor")),
        ("second", 12.0, ("second", "drum")),
    ]


def test_meshes_and_belt_are_placed_on_their_shafts():
    # by hand: 20 teeth on the motor; the belt's 20 teeth on a third of its speed; 18 teeth at a sixth of it
    meshes = orders(chain(), "gear_mesh")
    assert meshes["gear mesh of first"] == pytest.approx((20.0, 120.0))
    assert meshes["belt mesh"] == pytest.approx((20 / 3, 40.0))
    assert meshes["gear mesh of second"] == pytest.approx((3.0, 18.0))
    assert orders(chain(), "belt")["belt"] == pytest.approx((0.4 / 6, 0.4))
    turns = orders(chain(), "intermediate")
    assert turns["first shaft"] == pytest.approx((1 / 3, 2.0))
    assert turns["second shaft"] == pytest.approx((1 / 12, 0.5))


def test_a_bearing_is_placed_on_the_shaft_of_its_part():
    rig = chain() + BearingDefect(name="worn_bearing", at="drum", order_output=4.2, ring_frequency=900.0, amplitude=0.1)
    assert orders(rig, "bearing")["worn bearing"] == pytest.approx((0.35, 2.1))


def test_a_gear_without_teeth_is_named_and_has_the_mesh_that_an_effect_states():
    rig = chain(second_teeth=False)
    assert kinematics_of(rig).left_out["gear_mesh"] == "tooth counts of second unknown"
    assert [(one.shaft, one.turns) for one in kinematics_of(rig).open_meshes] == [("belt", 1.0), ("second", 0.5)]
    stated = rig + GearMesh(name="mesh", gear="second", order_output=36.0, transmission_error=(1e-4,))
    assert orders(stated, "gear_mesh")["gear mesh of second"] == pytest.approx((3.0, 18.0))
    assert kinematics_of(stated).open_meshes == ()


def test_an_imposed_propeller_is_no_motor():
    rig = Rig(
        (
            Body(name="propeller", inertia=0.01),
            TorqueSensor(name="torque_sensor", after="propeller", **SPRING, **SENSOR),
            Coupling(name="shaft", after="torque_sensor", **SPRING),
            Body(name="rotor", after="shaft", inertia=0.01),
            ImposedMotion(name="turned", at="propeller"),
        )
    )
    known = kinematics_of(rig)
    assert {line.label for line in known.lines(1)} == {"propeller"}
    assert set(known.left_out.values()) == {"the rig has no motor", "the rig has no gear"}


def test_orders_count_from_the_part_whose_motion_is_imposed():
    rig = Rig(
        (
            Body(name="rotor", inertia=0.01),
            Gear(name="gear", after="rotor", ratio=4.0, teeth=(Spur(15, 60),), **SPRING),
            TorqueSensor(name="torque_sensor", after="gear", **SPRING, **SENSOR),
            Body(name="propeller", after="torque_sensor", inertia=0.01),
            ImposedMotion(name="turned", at="propeller"),
        )
    )
    known = kinematics_of(rig)
    assert known.ratio == 1.0
    assert [(one.name, one.ratio) for one in known.shafts] == [("rotor", 0.25), ("propeller", 1.0)]
    assert orders(rig, "gear_mesh")["gear mesh"] == pytest.approx((60.0, 60.0))
    assert orders(rig, "intermediate")["rotor shaft"] == pytest.approx((4.0, 4.0))


def test_a_motor_behind_a_gear_of_the_imposed_part_has_its_lines_on_its_own_shaft():
    rig = Rig(
        (
            Motor(name="drive", inertia=1e-3, torque_limit=5.0, pole_pairs=4, slots=9),
            Gear(name="gear", after="drive", ratio=4.0, teeth=(Spur(15, 60),), **SPRING),
            TorqueSensor(name="torque_sensor", after="gear", **SPRING, **SENSOR),
            Body(name="propeller", after="torque_sensor", inertia=0.01),
            ImposedMotion(name="turned", at="propeller"),
        )
    )
    known = kinematics_of(rig)
    # orders count from the propeller, of which the motor makes 4 turns; LCM(9, 8) = 72 per turn of the motor
    assert orders(rig, "cogging") == {"drive cogging": pytest.approx((288.0, 288.0))}
    assert orders(rig, "electrical") == {"drive electrical": pytest.approx((16.0, 16.0))}
    assert [one.name for one in known.shafts] == ["drive", "propeller"]
    assert set(known.left_out) == {"cogging_per_pole", "slots_times_pole_pairs"}


def test_the_lines_of_the_shipped_rigs_are_named_on_every_shaft():
    from torquerig.catalog.search import catalog_for
    from torquerig.document import read_document
    from torquerig.scenario.reading import read_scenario

    path = Path(__file__).resolve().parents[2] / "scenarios" / "two_stage_branch.yaml"
    rig = read_scenario(read_document(path), catalog_for(path, ()), seed=1).rig
    assert orders(rig, "gear_mesh") == {"gear mesh of planetary": (18.0, 180.0), "belt mesh": (5.0, 50.0)}
    assert kinematics_of(rig).shaft_turns == {"motor": 10.0, "planetary": 2.5, "belt": 1.0}


def dyno(**counts: int | None) -> Rig:
    """The chain with a generator on its drum, at a twelfth of the motor's speed."""
    generator = Motor(name="generator", after="drum", inertia=1e-3, torque_limit=5.0, **counts)
    return chain() + generator


def of_generator(rig: Rig) -> dict[str, tuple[float, float]]:
    return {line.label: (line.motor_order, line.output_order) for line in kinematics_of(rig).lines(1) if line.at}


def test_a_second_motor_has_its_lines_on_its_own_shaft():
    # 12 slots, 5 pole pairs: LCM(12, 10) = 60 per turn; a turn of the drum is 1/12 of the motor and 1/2 of the sensor
    assert of_generator(dyno(pole_pairs=5, slots=12)) == {
        "generator cogging": pytest.approx((60 / 12, 30.0)),
        "generator cogging tolerance slots": pytest.approx((12 / 12, 6.0)),
        "generator cogging tolerance poles": pytest.approx((10 / 12, 5.0)),
        "generator electrical": pytest.approx((5 / 12, 2.5)),
        "generator six pulse": pytest.approx((30 / 12, 15.0)),
    }
    assert orders(dyno(pole_pairs=5, slots=12), "cogging")["cogging"] == pytest.approx((72.0, 432.0))


def test_what_is_not_known_of_a_second_motor_is_named():
    rig = dyno(pole_pairs=5, slots=None)
    assert set(of_generator(rig)) == {
        "generator cogging tolerance poles", "generator electrical", "generator six pulse",
    }  # fmt: skip
    assert kinematics_of(rig).left_out == {
        "cogging": "slots of generator unknown", "cogging_tolerance_slots": "slots of generator unknown",
    }  # fmt: skip


def test_a_filter_chain_removes_the_lines_of_a_second_motor():
    from torquerig.filters.chains.filter_chain import select_lines

    rig = dyno(pole_pairs=5, slots=12)
    chosen, left_out = select_lines(kinematics_of(rig), {"cogging": (1,)})
    assert ([line.at for line in chosen], left_out) == (["", "generator"], ())
    assert {line.at for line in kinematics_of(chain()).lines()} == {""}
