"""Sets of the referee: repeatable cases, wrong data sheets, changes that do not matter, a program without a file."""

import json
from dataclasses import replace

import numpy as np
import pyarrow.parquet as pq
import pytest
import yaml

from proof.__main__ import main
from proof.errors import ProofError
from proof.fleet.recording import write_recordings
from proof.fleet.rig import draw_rig
from proof.referee.diagnosing import DiagnoseJob, diagnosed, is_diagnosed, reduced_checkout
from proof.referee.edits import apply, number_of, times
from proof.referee.invariance import CHANGES, KEPT_UNITS, POWERS, similar
from proof.referee.making import MakeJob, made
from proof.referee.running import Round, make, numbers, quick_sizes, selected, verdicts_of, written
from proof.referee.sets import SETS, drawn
from proof.referee.setup_faults import FAULTS, fault_case
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder
from torquerig.document import read_document
from torquerig.recordings.files import read_recording
from torquerig.reporting.diagnosis.run_check import run_check
from torquerig.scenario.reading import read_scenario


def quiet(_name):
    return lambda _done, _total, _case: None


@pytest.fixture(scope="module")
def case_files(tmp_path_factory):
    rigs = (
        draw_rig("rig", (6, seed), plans=("reversal",), motors=("servo",), drives=("one_stage",)) for seed in range(50)
    )
    rig = next(one for one in rigs if one.design.angle == "encoder" and one.design.sample_rate == 4000.0)
    rig = replace(rig, runs=tuple(replace(run, duration=10.0) for run in rig.runs[:1]))

    def fresh():
        folder = tmp_path_factory.mktemp("case")
        write_recordings(rig, folder)
        return rig, folder

    return fresh


def read(folder):
    table = pq.read_table(folder / "run1.parquet")
    return (
        yaml.safe_load((folder / "scenario.yaml").read_text()), yaml.safe_load((folder / "run1.yaml").read_text()),
        {name: table[name].to_numpy() for name in table.column_names},
    )  # fmt: skip


def checked(folder):
    scenario = read_scenario(read_document(folder / "scenario.yaml"), load_catalog(shipped_folder()), seed=0)
    return run_check(scenario, [read_recording(folder / "run1.parquet")]).text()


@pytest.mark.parametrize("change", [name for name in CHANGES if name != "speed_x4"])
def test_a_changed_case_can_be_read_and_its_torque_is_the_same(change, case_files):
    rig, folder = case_files()
    _, facts, columns = read(folder)
    plain = columns["torque_V"] * facts["channels"]["torque_V"]["Nm_per_V"]
    apply(CHANGES[change](), folder)
    checked(folder)
    _, facts, columns = read(folder)
    (name,) = [one for one in columns if one.startswith("torque")]
    (scale,) = [value for key, value in facts["channels"][name].items() if key.startswith("Nm_per")]
    factor = {"torque_x0.01": 0.01, "torque_x100": 100.0}.get(change, 1.0)
    rms = np.sqrt(np.mean((columns[name] * scale / factor) ** 2))
    assert rms == pytest.approx(np.sqrt(np.mean(plain**2)), rel=0.02)  # a cut or a lower rate changes it a little
    if change in ("sign", "millivolts", "order_of_files", "torque_x100"):
        assert columns[name] * scale / factor == pytest.approx(plain, rel=1e-5, abs=1e-7 * float(np.abs(plain).max()))
    assert rig.design.sample_rate == 4000.0


def test_speeds_times_four_keep_every_number_without_a_dimension_of_time():
    tree = {"a": "3 kg*m^2", "b": {"value": "8 N*m*s/rad", "rel_sd": 0.1}, "c": ["100 Hz"], "d": "5 mm", "e": 7}
    assert similar(tree, 1.0, 4.0) == {
        "a": "0.1875 kg*m^2", "b": {"value": "2 N*m*s/rad", "rel_sd": 0.1}, "c": ["400 Hz"], "d": "5 mm", "e": 7,
    }  # fmt: skip
    assert similar("2 N*m", 100.0, 1.0) == "200 N*m"
    assert similar("2 V/(N*m)", 100.0, 1.0) == "0.02 V/(N*m)"


def test_every_unit_of_a_scenario_has_its_power():
    units = set()

    def walk(node):
        if isinstance(node, dict):
            for value in node.values():
                walk(value)
        elif isinstance(node, list):
            for value in node:
                walk(value)
        elif isinstance(node, str) and len(node.split()) == 2 and node.split()[0][:1].isdigit():
            units.add(node.split()[1])

    for seed in range(40):
        walk(draw_rig("rig", (13, seed)).scenario())
    assert units <= {*POWERS, *KEPT_UNITS}


@pytest.mark.parametrize("kind", sorted(FAULTS))
def test_a_set_up_fault_is_in_the_files_and_they_can_still_be_read(kind, tmp_path):
    case, fault = fault_case("case", (3, 1), kind)
    rig = replace(case.rig, runs=tuple(replace(run, duration=2.2) for run in case.rig.runs[:1]))
    write_recordings(rig, tmp_path)
    before = [str(part) for part in read(tmp_path)[:2]] + [read(tmp_path)[2]["torque_V"].sum()]
    apply(fault.edit, tmp_path)
    after = [str(part) for part in read(tmp_path)[:2]] + [read(tmp_path)[2]["torque_V"].sum()]
    assert before != after
    assert fault.stated != fault.true
    read_scenario(read_document(tmp_path / "scenario.yaml"), load_catalog(shipped_folder()), seed=0)
    checked(tmp_path)


def test_a_stated_value_keeps_unit_and_spread():
    assert times({"value": "2 N*m", "rel_sd": 0.1}, 1.5) == {"value": "3 N*m", "rel_sd": 0.1}
    assert number_of({"value": "2 N*m", "rel_sd": 0.1}) == 2.0
    assert times(0.5, -1.0) == -0.5


def test_the_program_without_a_file_lacks_the_mechanism_and_still_reads(tmp_path):
    where = reduced_checkout(tmp_path, "blade_pass")
    assert not (where / "src" / "torquerig" / "mechanisms" / "blade_pass.py").exists()
    assert (where / "src" / "torquerig" / "mechanisms" / "gear_mesh.py").is_file()
    assert (where / "catalogs").is_dir()
    assert reduced_checkout(tmp_path, "blade_pass") == where
    left = reduced_checkout(tmp_path, "gear_mesh") / "src" / "torquerig" / "mechanisms"
    assert not {"gear_mesh.py", "tooth_mesh.py"} & {each.name for each in left.iterdir()}


def test_parts_of_sets_are_stratified_and_nested():
    for name, one in SETS.items():
        whole = numbers(name, one.size)
        assert sorted(whole) == list(range(one.size))
        assert numbers(name, 5) == whole[:5]
    kinds = {number % 16 for number in numbers("FLEET", 16)}
    assert len(kinds) == 16
    assert quick_sizes()["FLEET"] == 20
    assert quick_sizes()["INVARIANCE"] == len(CHANGES)


def test_a_wrong_choice_of_sets_is_refused():
    assert selected(["CLEAN:3"], quick=False) == {"CLEAN": 3}
    for wrong, why in (
        ("CLAEN", "is no set"),
        ("CLEAN:x", "no number"),
        ("CLEAN:101", "has 100 cases"),
        ("CLEAN:0", "no number"),
    ):
        with pytest.raises(ProofError, match=why):
            selected([wrong], quick=False)
    with pytest.raises(ProofError, match="no set of the fleet"):
        drawn("WEAR", 1, 0)


def test_a_round_is_made_once_sealed_and_resumed(tmp_path):
    plan = Round({"CLEAN": 2}, 7001, tmp_path)
    seal = make(plan, stage=quiet)
    files = sorted(path for path in tmp_path.rglob("*") if path.is_file())
    times_of = [path.stat().st_mtime_ns for path in files if path.suffix == ".parquet"]
    assert make(plan, stage=quiet) == seal
    assert [path.stat().st_mtime_ns for path in files if path.suffix == ".parquet"] == times_of
    answer = next((tmp_path / "answers").glob("*.json"))
    answer.write_text(answer.read_text().replace('"adequate"', '"unexplained"'))
    with pytest.raises(ProofError, match="changed after they were sealed"):
        make(plan, stage=quiet)


def test_verdicts_and_page_of_hand_written_diagnoses(tmp_path):
    plan = Round({"CLEAN": 2}, 7002, tmp_path)
    seal = make(plan, stage=quiet)
    names = [job.marker.read_text().strip() for job in plan.jobs()]
    (tmp_path / "diagnoses").mkdir()
    fit = {"before": {"heldout_misfit": 0.9}, "after": {"heldout_misfit": 0.9}}
    (tmp_path / "diagnoses" / f"{names[0]}.json").write_text(
        json.dumps({"verdict": "adequate", "findings": [], "fit": fit})
    )
    verdicts, files = written(plan, seal)
    assert [one.exact for one in verdicts] == [True, False]
    assert verdicts[1].why_not == "not diagnosed yet"
    assert seal in files.markdown.read_text()
    assert verdicts_of(plan)[0].clean_chi_square == 0.9


def test_a_diagnosis_that_is_refused_keeps_its_sentence(tmp_path):
    folder = tmp_path / "recordings" / "broken"
    folder.mkdir(parents=True)
    (folder / "scenario.yaml").write_text("scenario: broken\nrig: {}\n")
    (folder / "run1.parquet").write_bytes(b"no table")
    job = DiagnoseJob("broken", tmp_path, limit=120.0)
    assert not is_diagnosed(job)
    assert diagnosed(job) == "broken"
    assert is_diagnosed(job)
    assert "torquerig" in (tmp_path / "refused" / "broken.txt").read_text()
    assert json.loads((tmp_path / "costs" / "broken.json").read_text())["exit"] == 2


def test_versions_share_recordings_and_keep_their_results_apart(tmp_path):
    first, second = (
        Round({"CLEAN": 1}, 7004, tmp_path),
        Round({"CLEAN": 1}, 7004, tmp_path, label="second", options=("-x",)),
    )
    assert make(first, stage=quiet) == make(second, stage=quiet)
    (name,) = [job.marker.read_text().strip() for job in second.jobs()]
    (tmp_path / "second" / "diagnoses").mkdir(parents=True)
    said = json.dumps({"verdict": "adequate", "findings": [], "fit": {}})
    (tmp_path / "second" / "diagnoses" / f"{name}.json").write_text(said)
    assert [one.exact for one in verdicts_of(second)] == [True]
    assert [one.exact for one in verdicts_of(first)] == [False]
    assert second.command == "python -m proof fleet --seed 7004 --set CLEAN:1 --label second --option=-x"


def test_a_diagnosis_beyond_its_limit_is_stopped(tmp_path):
    job = DiagnoseJob("slow", tmp_path, limit=0.05)
    (tmp_path / "recordings" / "slow").mkdir(parents=True)
    diagnosed(job)
    assert "limit of 0.05 s" in (tmp_path / "refused" / "slow.txt").read_text()


def test_a_wear_case_has_the_shipped_scenario_and_an_answer(tmp_path):
    name = made(MakeJob("WEAR", 7001, 3, tmp_path))
    assert (tmp_path / "recordings" / name / "scenario.yaml").read_text().count("wear_rig")
    answer = json.loads((tmp_path / "answers" / f"{name}.json").read_text())
    assert answer["set"] == "WEAR"
    assert len(list((tmp_path / "recordings" / name).glob("run*.parquet"))) >= 1


def test_the_command_makes_a_round_and_refuses_a_missing_folder(tmp_path, capsys):
    with pytest.raises(SystemExit) as ended:
        main(
            [
                "fleet",
                "--seed",
                "7003",
                "--set",
                "CLEAN:1",
                "--out",
                str(tmp_path / "out"),
                "--real",
                str(tmp_path / "none"),
            ]
        )
    assert ended.value.code == 2
    assert "no such folder" in capsys.readouterr().err
    main(["fleet", "--seed", "7003", "--set", "CLEAN:1", "--out", str(tmp_path / "out"), "--make-only"])
    assert "answers sealed, SHA-256" in capsys.readouterr().out
