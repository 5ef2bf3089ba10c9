"""Loads that only a simulation knows: refused where the required torque of a motor would leave them out."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.errors import InputError
from torquerig.metrics.sizing.sized_drive import sized_drive
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.scenario.checks.recorded_load import refuse_unstated_load
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import read_scenario

CATALOG = load_catalog(shipped_folder())
FROM_CHANNEL = "rig.weight={kind: replayed_torque, at: wear_part, from: channel weight, factor: -1}"
FROM_FILE = "rig.weight={kind: replayed_torque, at: wear_part, recording: %s, channel: weight}"
BRAKE = "rig.brake={kind: motor, after: wear_part, inertia: 1 kg*cm^2, torque_limit: 5 N*m}"
BRAKED = "rig.weight={kind: torque_controller, motor: brake, torque: -1 N*m}"
CYCLE = "operating_point.duty_cycle={segments: [{duration: 1 s, output_speed: 60 rpm, load_torque: 1 N*m}%s]}"
SELECTED = "operating_point.profile=duty_cycle"
REFUSED = {
    "channel": (FROM_CHANNEL,),
    "second drive": (BRAKE, BRAKED),
    "half a cycle": (FROM_CHANNEL, CYCLE % ", {duration: 1 s, output_speed: 0 rpm}", SELECTED),
    "cycle not selected": (FROM_CHANNEL, CYCLE % ""),
}


def wear_rig(*settings: str):
    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), settings)
    return read_scenario(document, CATALOG, seed=1)


@pytest.mark.parametrize("settings", REFUSED.values(), ids=REFUSED)
def test_an_unstated_load_is_refused_with_its_place_and_remedy(settings):
    made = wear_rig(*settings)
    with pytest.raises(InputError, match=r"rig\.weight: weight is .* a particle_load .*, or state load_torque"):
        refuse_unstated_load(made)
    with pytest.raises(InputError, match="weight is"):
        sized_drive(made, CATALOG)


def test_a_load_from_a_file_is_refused_too(tmp_path):
    weight = Channel(values=np.full(8, 0.4), quantity="torque", unit="N*m")
    write_recording(Recording(sample_rate=100.0, channels={"weight": weight}), tmp_path / "weight.parquet")
    with pytest.raises(InputError, match=r"rig\.weight: weight is a recorded load"):
        refuse_unstated_load(wear_rig(FROM_FILE % (tmp_path / "weight.parquet")))


@pytest.mark.parametrize("settings", [(), (FROM_CHANNEL, CYCLE % "", SELECTED)], ids=["particle load", "cycle"])
def test_a_stated_load_passes(settings):
    refuse_unstated_load(wear_rig(*settings))
