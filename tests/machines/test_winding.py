"""Pairs of poles and slots that cannot be wound are refused with pairs near them that can."""

from math import gcd
from pathlib import Path

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.machines.winding import has_winding, nearest_windings, no_winding
from torquerig.scenario.reading import read_scenario


@pytest.mark.parametrize(("pole_pairs", "slots"), [(7, 14), (4, 13), (3, 12), (6, 14), (5, 10), (1, 4)])
def test_the_pairs_that_are_offered_can_be_wound_and_lie_near(pole_pairs, slots):
    near = nearest_windings(pole_pairs, slots)
    assert len(near) == 4
    assert not has_winding(pole_pairs, slots)
    for p, q in near:
        assert q % (3 * gcd(q, p)) == 0
        assert abs(p - pole_pairs) + abs(q - slots) <= 6
    # nothing that can be wound lies nearer than the first one offered
    first = abs(near[0][0] - pole_pairs) + abs(near[0][1] - slots)
    for p in range(max(1, pole_pairs - first), pole_pairs + first + 1):
        for q in range(max(3, slots - first), slots + first + 1):
            if abs(p - pole_pairs) + abs(q - slots) < first:
                assert not has_winding(p, q) or not 0.5 <= q / (2 * p) <= 6


def test_fourteen_teeth_for_seven_pole_pairs_offer_the_rig_s_own_twelve():
    assert "12 slots with 7 pole pairs" in no_winding(7, 14)


RIG = """
rig:
  motor: {kind: motor, inertia: 1.5 kg*cm^2, torque_limit: 2 N*m, pole_pairs: 7, slots: 14}
  torque_sensor: {kind: coupling, stiffness: 1000 N*m/rad, damping: 0.1 N*m*s/rad}
  wear_part: {kind: body, inertia: 2.0e-3 kg*m^2}
"""


def test_a_scenario_s_motor_without_winding_is_refused_with_line_and_remedy():
    document = parse_document(RIG, Path("own.yaml"))
    with pytest.raises(InputError, match=r"own\.yaml:3: .*14 slots and 7 pole pairs.*nearest that work: .*12 slots"):
        read_scenario(document, load_catalog(shipped_folder()), seed=1)


def test_a_catalog_s_motor_without_winding_is_refused_with_line_and_remedy(tmp_path):
    (tmp_path / "motors").mkdir()
    text = (shipped_folder() / "motors" / "bldc-12n14p.yaml").read_text(encoding="utf-8")
    own = tmp_path / "motors" / "own.yaml"
    own.write_text(text.replace("slots: {value: 12,", "slots: {value: 14,"), encoding="utf-8")
    with pytest.raises(InputError, match=r"own\.yaml:\d+: slots: .*nearest that work: 15 slots with 7 pole pairs, 12"):
        load_catalog(tmp_path)
