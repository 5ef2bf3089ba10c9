"""Gear and belt stages by their teeth: ratios of handbook 4.2, belts by closed forms, what is refused at reading."""

from __future__ import annotations

from math import asin, cos, pi, sqrt
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.mechanisms import QuadraticDrag
from torquerig.orders.kinematics.belt import Belt
from torquerig.orders.kinematics.teeth import Planetary, Spur
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.parts import BeltStage, Body, Gear, Motor, SpeedController
from torquerig.rig.terms import Inertia
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

CATALOG = load_catalog(shipped_folder())


def scenario(gear: str) -> Scenario:
    text = f"""\
measured: gearbox
operating_point: {{motor_speed: 1000 rpm}}
rig:
  motor: {{kind: motor, inertia: 1.5e-4 kg*m^2, torque_limit: 10 N*m}}
  gearbox: {gear}
  drum: {{kind: body, inertia: 20 kg*cm^2}}
  loop: {{kind: speed_controller, kp: 0.05 N*m*s/rad, ki: 1 N*m/rad}}
"""
    return read_scenario(parse_document(text, Path("bench.yaml")), CATALOG, seed=1)


STRAND = "belt_stiffness: 100 kN, strand_damping: 1 N*s/m"
SPRING = "stiffness: 5 kN*m/rad, damping: 2 N*m*s/rad, output_inertia: 10 kg*cm^2"


@pytest.mark.parametrize(
    ("teeth", "ratio"),
    [
        ("kind: planetary_gear, teeth: {sun: 21, ring: 84, planets: 3}", 5.0),
        ("kind: planetary_gear, teeth: {sun: 21, ring: 84, planets: 3, planet: 31}", 5.0),
        ("kind: planetary_gear, teeth: {sun: 21, ring: 84, planets: 3, fixed: carrier}", -4.0),
        ("kind: planetary_gear, teeth: {sun: 21, ring: 84, planets: 3, fixed: sun}", 1.25),
        ("kind: fixed_axis_gear, teeth: {pinion: 20, wheel: 50}", -2.5),
        ("kind: fixed_axis_gear, teeth: {pinion: 20, wheel: 50, internal: true}", 2.5),
        ("kind: gear, teeth: [{sun: 21, ring: 84, planets: 3}, {sun: 24, ring: 72, planets: 3}]", 20.0),
        ("kind: gear, teeth: [{pinion: 20, wheel: 50}, {pinion: 21, wheel: 42}]", 5.0),
        ("kind: gear, ratio: 2.5, teeth: {pinion: 20, wheel: 50}", 2.5),
    ],
)
def test_the_ratio_follows_from_the_teeth_and_a_stated_one_keeps_its_sign(teeth: str, ratio: float) -> None:
    """Willis 1841: 1 + zr/zs, -zr/zs, 1 + zs/zr by what is fixed; each outer pair turns back."""
    rig = scenario(f"{{{teeth}, {SPRING}}}").rig
    assert rig.part("gearbox").ratio == pytest.approx(ratio, rel=1e-12)  # type: ignore[attr-defined]
    assert kinematics_of(rig).ratio == pytest.approx(abs(ratio))
    assert rig.speed_ratios("motor")["gearbox"] == pytest.approx(1 / ratio)


@pytest.mark.parametrize("fixed", ["ring", "carrier", "sun"])
def test_the_mesh_order_follows_the_speeds_of_sun_and_ring_against_the_carrier(fixed: str) -> None:
    """f_mesh = zs |w_s - w_c| = zr |w_r - w_c| (handbook 4.2), whichever member stands still."""
    stage = Planetary(24, 72, 3, fixed=fixed)  # type: ignore[arg-type]
    sun, carrier, ring = {"ring": (4.0, 1.0, 0.0), "carrier": (-3.0, 0.0, 1.0), "sun": (0.0, 1.0, 4 / 3)}[fixed]
    assert stage.mesh_order_out == pytest.approx(24 * abs(sun - carrier))
    assert stage.mesh_order_out == pytest.approx(72 * abs(ring - carrier))
    assert stage.mesh_order_in * stage.ratio == pytest.approx(stage.mesh_order_out)


@pytest.mark.parametrize(
    ("gear", "told"),
    [
        (
            f"{{kind: planetary_gear, teeth: {{sun: 21, ring: 85, planets: 3}}, {SPRING}}}",
            r"rig\.gearbox\.teeth: 3 equal planets do not fit between sun 21 and ring 85: .* whole; the .* 21/84 \(5\)",
        ),
        (
            f"{{kind: planetary_gear, teeth: {{sun: 12, ring: 108, planets: 4}}, {SPRING}}}",
            "neighbouring planets of 48 teeth would collide; the nearest",
        ),
        (
            f"{{kind: planetary_gear, teeth: {{sun: 21, ring: 84, planets: 3, planet: 28}}, {SPRING}}}",
            r"ring = sun \+ 2 planet requires planets of 31.5 teeth, not 28",
        ),
        (
            f"{{kind: gear, ratio: 4, teeth: {{sun: 21, ring: 84, planets: 3}}, {SPRING}}}",
            r"the teeth give a ratio of 5, but ratio is 4; correct one of them; the nearest .* 27/81 \(4\)",
        ),
        (f"{{kind: planetary_gear, teeth: {{sun: 84, ring: 21}}, {SPRING}}}", "the ring must have more teeth"),
        (f"{{kind: planetary_gear, teeth: {{pinion: 20, wheel: 50}}, {SPRING}}}", "a planetary_gear needs its tooth"),
        (f"{{kind: fixed_axis_gear, {SPRING}}}", "a fixed_axis_gear needs its tooth counts; write for example"),
        (f"{{kind: gear, {SPRING}}}", "a gear of ratio 0 transmits nothing; write the input turns"),
        (f"{{kind: gear, teeth: {{sun: 21, rnig: 84}}, {SPRING}}}", "'rnig' is no key .*did you mean 'ring'"),
        (f"{{kind: gear, teeth: {{sun: 21.5, ring: 84}}, {SPRING}}}", "21.5 is no tooth count; write a whole number"),
        (f"{{kind: gear, teeth: {{sun: 21}}, {SPRING}}}", "has no ring; write for example"),
        (f"{{kind: gear, teeth: {{sun: 21, ring: 84, fixed: planet}}, {SPRING}}}", "not a member of a planetary stage"),
        (f"{{kind: gear, teeth: {{pinion: 50, wheel: 20, internal: true}}, {SPRING}}}", "does not fit into a ring"),
        (
            f"{{kind: belt, pinion_teeth: 20, wheel_teeth: 100, belt_teeth: 60, pitch: 5 mm, {STRAND}}}",
            "does not go round pulleys .* it needs at least 108 teeth",
        ),
        (
            f"{{kind: belt, pinion_teeth: 20, wheel_teeth: 100, belt_length: 1 m, {STRAND}}}",
            "a belt needs either pinion_teeth, .* state all of one kind",
        ),
    ],
    ids=lambda value: value[:50] if value.startswith("{") else "",
)
def test_teeth_that_cannot_be_are_refused_at_reading_with_their_place_and_the_nearest_that_can(
    gear: str, told: str
) -> None:
    with pytest.raises(InputError, match=told) as refused:
        scenario(gear)
    assert str(refused.value).startswith("bench.yaml:5: rig.gearbox")


def stage_rig(stage: Part, ratio: float, speed: float = 40.0) -> Rig:
    motor = Motor(name="motor", inertia=1.5e-4, torque_limit=50.0)
    body = Body(name="wear_part", after="stage", inertia=2e-3)
    drag = QuadraticDrag(name="drag", coefficient=2.0 / (speed / ratio) ** 2)
    parts = (motor, stage, body, drag, SpeedController(name="loop", kp=0.05, ki=1.0))
    return Rig(parts, Run(speed=speed), measured="stage")


TOOTHED = BeltStage(
    name="stage", after="motor", pinion_teeth=20, wheel_teeth=50, belt_teeth=120, pitch=5e-3, belt_stiffness=1e5,
    strand_damping=200.0, efficiency=0.96, pinion_inertia=1e-5, wheel_inertia=1e-3,
)  # fmt: skip


def test_a_belt_stage_transmits_torque_by_its_teeth_and_losses() -> None:
    made = simulate(stage_rig(TOOTHED, 2.5), duration=0.2, seed=1, settling=6.0)
    assert made.torque().mean() / made.channels["true_motor_torque_Nm"].values.mean() == pytest.approx(
        2.5 * 0.96, rel=1e-3
    )
    assert kinematics_of(stage_rig(TOOTHED, 2.5)).teeth == (Belt(20, 50, 120),)


def test_a_belts_stiffness_is_that_of_both_strands_at_the_output_pulley() -> None:
    """Equal pulleys: the strand is (L - rim)/2 long; else sqrt(C^2 - (R2 - R1)^2) at the C that gives the length."""
    even = BeltStage(
        name="b", pinion_diameter=0.1, wheel_diameter=0.1, belt_length=1.0, belt_stiffness=1e5, strand_damping=200.0
    )
    assert even.stiffness == pytest.approx(2 * 1e5 / ((1.0 - 0.1 * pi) / 2) * 0.05**2, rel=1e-9)
    assert even.damping == pytest.approx(2 * 200.0 * 0.05**2)
    apart, r1, r2 = 0.3, 0.03, 0.07
    slant = (r2 - r1) / apart  # sin of the slant
    strand = sqrt(apart**2 - (r2 - r1) ** 2)

    length = 2 * apart * cos(asin(slant)) + pi * (r1 + r2) + 2 * asin(slant) * (r2 - r1)
    assert Belt(2 * pi * r1, 2 * pi * r2, length, toothed=False).strand() == pytest.approx(strand, rel=1e-9)


def test_each_pulley_sits_on_its_own_shaft() -> None:
    inertias = [term for term in stage_rig(TOOTHED, 2.5).terms() if isinstance(term, Inertia)]
    assert {(term.node, term.inertia) for term in inertias} >= {("motor", 1e-5), ("stage", 1e-3)}


def test_handbook_4_2_phasing_cancels_what_it_says() -> None:
    """Every 5:1 set is in phase; 24/78/4 is not, and only its even harmonics are left in torque."""
    for sun, ring, planets in ((12, 48, 3), (12, 48, 4), (16, 64, 4), (21, 84, 3), (30, 120, 3)):
        assert Planetary(sun, ring, planets).torque_harmonics(6) == (1, 2, 3, 4, 5, 6)
    assert Planetary(26, 78, 4).torque_harmonics(6) == (2, 4, 6)
    assert Planetary(22, 62, 3).torque_harmonics(6) == (3, 6)
    phased = Planetary(22, 62, 3)
    assert [phased.torque_share(62 * h) > 0.5 for h in (1, 2, 3)] == [False, False, True]
    assert phased.torque_share(62, (1.0, 0.0, 0.0)) == pytest.approx(1.0)  # one planet carries all: nothing cancels


def test_handbook_4_2_orders_of_single_tooth_faults_and_hunting() -> None:
    """Sun n (f_m - f_o) = 3 x 4, ring n f_o = 3, planet 2 f_mesh / zp; a pair 20/50 hunts 10/(20 x 50) of its mesh."""
    assert Planetary(21, 84, 3, 31).fault_orders() == pytest.approx({"sun": 12.0, "ring": 3.0, "planet": 168 / 31})
    assert Planetary(21, 84).fault_orders() == {}
    assert Spur(20, 50).hunting_order_out == pytest.approx(50 * 10 / (20 * 50))


def test_a_gear_of_stated_teeth_is_the_same_spring_as_one_of_stated_ratio() -> None:
    """One equation for all kinds: the same bytes."""
    common = {"name": "stage", "after": "motor", "stiffness": 5000.0, "damping": 2.0, "output_inertia": 1e-3}
    plain = Gear(ratio=5.0, **common)  # type: ignore[arg-type]
    toothed = Gear(kind="planetary_gear", teeth=(Planetary(21, 84, 3),), **common)  # type: ignore[arg-type]
    first, second = (simulate(stage_rig(gear, 5.0), duration=0.1, seed=1, settling=0.1) for gear in (plain, toothed))
    assert first.torque().tobytes() == second.torque().tobytes()
