"""Mechanisms, filters, readers and catalogs of other installed packages: by entry points, like the built-in ones."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]

EFFECT = """
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from torquerig.filters.chains.stage_form import StageForm
from torquerig.mechanisms.mains_interference import MainsInterference
from torquerig.recordings.files.number_table import Table


@dataclass(frozen=True, kw_only=True)
class TramLine(MainsInterference):
    kind: Literal["tram_line"] = "tram_line"


@dataclass(frozen=True)
class Halved:
    def apply(self, recording):
        name = recording.torque_name()
        return recording.with_values(name, 0.5 * recording.channels[name].values)


class HalvedText(StageForm):
    type: Literal["halved"]

    def made_for(self, kinematics, response=None):
        return Halved(), ()


def read_abc(path: Path) -> Table:
    values = np.array([float(word) for word in path.read_text().split()])
    return Table(columns={"torque_V": values}, rates={"torque_V": 1000.0})


FOLDER = Path(__file__).parent / "shelf"
"""

SCRIPT = """
import sys
from dataclasses import replace
from pathlib import Path
import numpy as np
from torquerig.catalog.search import catalog_for
from torquerig.document import read_document
from torquerig.filters.chains.chain_file import read_chains
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.files import open_stream, read_recording
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

folder = Path(sys.argv[1])
catalog = catalog_for(None)
assert "tram-motor" in catalog.motors, "catalog"
made = read_scenario(read_document(folder / "rig.yaml"), catalog, seed=1)
assert type(made.rig.part("hum")).__name__ == "TramLine", "mechanism"
# the laws of tests/mechanisms: zero size changes nothing to the bit, and a real size shows at its frequency
plain = simulate(made.rig.without("hum"), duration=1.0, seed=1).torque_values()
nothing = made.rig.changed(replace(made.rig.part("hum"), amplitudes=(0.0,)))
assert simulate(nothing, duration=1.0, seed=1).torque_values().tobytes() == plain.tobytes(), "zero size"
rest = simulate(made.rig, duration=1.0, seed=1).torque_values() - plain
tone = abs(np.exp(-2j * np.pi * 16.7 * np.arange(rest.size) / 25e3) @ rest) * 2 / rest.size
assert abs(tone - 0.1) < 2e-3, tone
recording = read_recording(folder / "run.abc")
assert recording.samples == 4 and recording.sample_rate == 1000.0, "reader"
assert open_stream(folder / "run.abc").samples == 4, "stream"
chain = read_chains(folder / "chains.yaml", kinematics=Kinematics(pole_pairs=7, slots=12, ratio=5.0))["half"]
assert chain.apply(recording).torque_values().max() == 2.0, "filter"
print("all four")
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """Return a folder that holds an installed package with one entry point of each group."""
    (tmp_path / "extra_effects.py").write_text(EFFECT)
    info = tmp_path / "extra_effects-0.1.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: extra-effects\nVersion: 0.1\n")
    (info / "entry_points.txt").write_text(
        "[torquerig.mechanisms]\ntram_line = extra_effects:TramLine\n"
        "[torquerig.filters]\nhalved = extra_effects:HalvedText\n"
        "[torquerig.readers]\nabc = extra_effects:read_abc\n"
        "[torquerig.catalogs]\nshelf = extra_effects:FOLDER\n"
    )
    motors = tmp_path / "shelf" / "motors"
    motors.mkdir(parents=True)
    shipped = (ROOT / "catalogs" / "motors" / "bldc-12n14p.yaml").read_text()
    (motors / "tram-motor.yaml").write_text(
        shipped.replace("name: bldc-12n14p", "name: tram-motor").replace('"REF"', '"TRAM"')
    )
    scenario = (ROOT / "scenarios" / "two_stage_branch.yaml").read_text().rstrip()
    (tmp_path / "rig.yaml").write_text(
        scenario + "\n  hum: {kind: tram_line, frequency: 16.7 Hz, amplitudes: [0.1 V], phases: [0]}\n"
    )
    (tmp_path / "run.abc").write_text("1 2 3 4")
    (tmp_path / "chains.yaml").write_text("filters:\n  half: [{type: halved}]\n")
    return tmp_path


def run(package: Path, script: str) -> subprocess.CompletedProcess[str]:
    path = os.pathsep.join([str(package), str(ROOT / "src")])
    return subprocess.run([sys.executable, "-c", script, str(package)], cwd=package, capture_output=True, text=True,
                          env=os.environ | {"PYTHONPATH": path}, check=False)  # fmt: skip


@pytest.mark.long
def test_an_installed_package_adds_a_mechanism_a_filter_a_reader_and_a_catalog(package):
    done = run(package, SCRIPT)
    assert done.stdout == "all four\n", done.stderr


@pytest.mark.long
def test_a_broken_package_is_named_in_one_sentence(package):
    points = package / "extra_effects-0.1.dist-info" / "entry_points.txt"
    points.write_text("[torquerig.mechanisms]\ntram_line = extra_effects:NotThere\n")
    done = run(package, "from torquerig.cli import main; main(['catalog'])")
    ends = run(package, "from torquerig.cli import main; main(['simulate', 'rig.yaml'])")
    assert done.returncode == 0, done.stderr
    assert ends.returncode == 2
    assert ends.stderr.count("\n") == 1
    assert "extra-effects" in ends.stderr
    assert "correct or uninstall" in ends.stderr
