"""``measured:`` as one name or a list: read, written, refused with file and line."""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig.catalog.reading import Catalog
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario

RIG = """
operating_point: {{motor_speed: 600 rpm}}
measured: {measured}
rig:
  motor: {{kind: motor, inertia: 1.5 kg*cm^2, torque_limit: 5 N*m}}
  inner: {{kind: torque_sensor, stiffness: 1 kN*m/rad, damping: 0.1 N*m*s/rad, inertia: 1 kg*cm^2, bandwidth: 1 kHz,
          scale: {{value: 1, rel_sd: 0.01}}, zero: 20 mN*m, mounting: reversed}}
  outer: {{kind: torque_sensor, stiffness: 1 kN*m/rad, damping: 0.1 N*m*s/rad, inertia: 1 kg*cm^2, bandwidth: 1 kHz,
          tare: true, gain_tolerance: 0.2 %}}
  wheel: {{kind: body, inertia: 20 kg*cm^2, viscous: 0.02 N*m*s/rad}}
  controller: {{kind: speed_controller, kp: 0.05 N*m*s/rad, ki: 0.5 N*m/rad}}
  tacho: {{kind: speed_sensor, at: wheel, zero: 0.1 rad/s}}
  twist: {{kind: probe, quantity: torque, at: inner}}
"""


def scenario(measured: str, rig: str = RIG) -> Scenario:
    return read_scenario(parse_document(rig.format(measured=measured), Path("rig.yaml")), Catalog(), seed=1)


@pytest.mark.parametrize(
    ("measured", "places"),
    [
        ("outer", ("outer",)), ("[outer]", ("outer",)), ("[outer, inner]", ("outer", "inner")),
        ("[tacho, inner, outer]", ("inner", "tacho", "outer")), ("tacho", ("tacho",)),
        ("[outer, twist]", ("outer", "twist")),
    ],
)  # fmt: skip
def test_the_first_torque_is_the_one_that_is_compared(measured: str, places: tuple[str, ...]) -> None:
    assert scenario(measured).rig.places == places


def test_places_and_sensors_go_through_a_written_scenario() -> None:
    made = scenario("[outer, inner, tacho]")
    again = read_scenario(parse_document(made.text(), Path("rig.yaml")), Catalog(), seed=1)
    assert again.rig == made.rig
    assert "measured: outer\n" in scenario("[outer]").text()


@pytest.mark.parametrize(
    ("measured", "said"),
    [
        ("inne", "rig.yaml:3: measured: the rig has no part 'inne'; did you mean 'inner'"),
        ("[outer, inne]", "rig.yaml:3: measured.1: the rig has no part 'inne'; did you mean 'inner'"),
        ("[]", "rig.yaml:3: measured: no place is named"),
        ("[outer, outer]", "'outer' is named twice"),
        ("wheel", "'wheel' has no spring whose torque could be read; name a sensor"),
        ("twist", "'twist' is a probe, which has no measuring chain; write measured: inner"),
        ("{a: b}", "name one of inner, outer, tacho"),
    ],
)
def test_a_place_that_cannot_be_read_is_one_sentence(measured: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        scenario(measured)
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("before", "after", "said"),
    [
        ("tare: true", "tare: true, zero: 0.1 N*m", "tare: true says that the zero was set"),
        ("mounting: reversed", "mounting: backward", "rig.inner.mounting"),
        ("scale: {{value: 1, rel_sd: 0.01}}", "scale: -1", "scale"),
    ],
)
def test_a_sensor_that_contradicts_itself_is_refused(before: str, after: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        scenario("outer", RIG.replace(before, after))
