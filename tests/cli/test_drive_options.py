"""``filter``, ``ordermap`` and ``orders`` with a scenario or a gearbox of the catalog."""

from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.cli import main
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
RATE, SECONDS, MESH = 2000.0, 20.0, 84.0


def recorded(
    folder: Path, *, gear_ratio: float | None = 5.0, mesh: float = MESH, name: str = "run.parquet",
    motor: dict[str, int] | None = None,
) -> Path:  # fmt: skip
    """Write a recording at 600 rpm of the motor with a line at ``mesh`` fifths of the motor's order."""
    time = np.arange(int(RATE * SECONDS)) / RATE
    turned = 10.0 * (time + 0.02 * np.sin(2 * pi * 0.1 * time))
    torque = 1 + 0.2 * np.cos(2 * pi * mesh / 5 * turned) + 0.01 * np.random.default_rng(3).normal(size=time.size)
    channels = {
        "torque_Nm": Channel(values=torque, quantity="torque", unit="N*m"),
        "motor_angle_rad": Channel(values=2 * pi * turned, quantity="motor_angle", unit="rad"),
    }
    run = Run(gear_ratio=gear_ratio, speed=20 * pi, motor=None if motor else "bldc-12n14p", others=dict(motor or {}))
    write_recording(Recording(sample_rate=RATE, channels=channels, run=run), folder / name)
    return folder / name


@pytest.fixture
def run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)

    def told(*arguments: str) -> str:
        main(arguments)
        return capsys.readouterr().out

    return told


def std_cut(told: str, chain: str = "order_lines") -> float:
    return float(next(row for row in told.splitlines() if row.startswith(chain + " ")).split()[2])


def test_a_gearbox_of_known_teeth_is_notched_and_one_without_teeth_is_not(run, tmp_path):
    path = str(recorded(tmp_path))
    known = run("filter", path, "--chain", "order_lines", "--gearbox", "ZLS160-5")
    assert "gear_mesh" in known
    assert std_cut(known) > 90
    unknown = run("filter", path, "--chain", "order_lines", "--gearbox", "NP025-5")
    assert "not removed: gear_mesh: tooth counts unknown" in unknown
    several = run("filter", path, "--chain", "order_lines", "--gearbox", "economy-5-1")
    assert "sets of teeth is possible" in several


def test_a_scenario_gives_the_meshes_of_all_its_stages(run, tmp_path):
    path = str(recorded(tmp_path, gear_ratio=10.0, mesh=90.0))  # 90 at 5:1 is 18 on the motor: its planetary stage
    chosen = ("--scenario", str(SCENARIOS / "two_stage_branch.yaml"), "--chain", "order_lines")
    told = run("filter", path, *chosen)
    assert "gear mesh of planetary" in told
    assert std_cut(told) > 90
    mapped = " ".join(run("ordermap", path, "--scenario", str(SCENARIOS / "two_stage_branch.yaml")).split())
    assert "turns per output turn: motor 10, planetary 2.5, belt 1" in mapped
    assert "gear mesh of planetary x1" in mapped


def test_python_takes_the_same_drive(tmp_path):
    import torquerig as tr

    path = recorded(tmp_path)
    clean = tr.filter(path, "order_lines", gearbox="ZLS160-5")
    assert clean.torque().std() < 0.1 * tr.read(path).torque().std()
    other = recorded(tmp_path, gear_ratio=10.0, mesh=90.0, name="other.parquet")
    clean = tr.filter(other, "order_lines", scenario=SCENARIOS / "two_stage_branch.yaml")
    assert clean.torque().std() < 0.1 * tr.read(other).torque().std()


MOVED = """
operating_point: {}
measured: motion
rig:
  rotor: {kind: body, inertia: 1 kg*cm^2}
  motion: {kind: imposed_motion, at: rotor, channel: angle}
"""


def test_orders_of_a_scenario_list_its_shafts(run):
    told = run("orders", "--scenario", str(SCENARIOS / "two_stage_branch.yaml"))
    assert "two_stage_branch, 10:1, motor at 600 rpm" in told
    assert any(row.split()[:3] == ["planetary", "4", "150"] for row in told.splitlines())


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("filter", "run.parquet", "--scenario", "wear.yaml", "--ratio", "5"), "remove --motor, --ratio and --gearbox"),
        (("filter", "run.parquet", "--scenario", str(SCENARIOS / "two_stage_branch.yaml")), "states gear_ratio: 5"),
        (("filter", "run.parquet", "--gearbox", "ZLS160"), "ZLS160-5"),
        (("orders", "--scenario", "wear.yaml", "--sun", "21"), "remove --sun"),
        (("orders", "--scenario", "moved.yaml"), "states no set-point of the speed; write --speed"),
    ],
)
def test_what_contradicts_is_refused(tmp_path, monkeypatch, capsys, arguments, said):
    monkeypatch.chdir(tmp_path)
    recorded(tmp_path)
    Path("moved.yaml").write_text(MOVED, encoding="utf-8")
    with pytest.raises(SystemExit) as left:
        main(arguments)
    assert left.value.code == 2
    assert said in " ".join(capsys.readouterr().err.split())


def test_a_gearbox_of_another_ratio_than_the_sidecar_states_is_said(run, tmp_path):
    told = run("filter", str(recorded(tmp_path, gear_ratio=3.0)), "--chain", "none", "--gearbox", "ZLS160-5")
    assert "the sidecar states a gear ratio of 3; the lines are those of 5:1" in " ".join(told.split())


@pytest.mark.parametrize(
    ("gear_ratio", "named"),
    [(3.0, "or mesh with 72 or 216 teeth"), (None, "or mesh with 72 teeth"), (1.0, "cogging x1 ")],
)
def test_a_line_that_may_be_a_mesh_of_unknown_teeth_is_not_called_cogging_alone(run, tmp_path, gear_ratio, named):
    # 9 slots and 8 poles have cogging at 72 per motor turn; a direct drive has no mesh
    path = recorded(tmp_path, gear_ratio=gear_ratio, mesh=72 * 5, motor={"pole_pairs": 4, "slots": 9})
    told = run("ordermap", str(path))
    found = next(row for row in told[told.index("constant  ") :].splitlines() if "cogging" in row)
    assert named in found + " "
    assert ("mesh" in found) == (gear_ratio != 1.0)
