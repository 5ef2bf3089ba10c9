"""What a set of trials holds, how its answers are sealed, and the riddle of 280 Hz."""

import json
from collections import Counter
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest
import yaml
from click.testing import CliRunner

from proof.errors import ProofError
from proof.make import main as make
from proof.make import make_trials
from proof.riddle import RIDDLE, draw_riddle
from proof.rig_program.draw import answer_of
from proof.rig_program.effect_draws import IN_LIBRARY, IN_NO_LIBRARY
from proof.rig_program.effects.torsional_mode import TorsionalMode
from proof.rig_program.laws import SAME_LAWS
from proof.rig_program.machine import machine_of
from proof.rig_program.recording import record
from proof.rig_program.transfer import mode_frequencies
from proof.sealed import SEAL, seal, unseal
from proof.trials import SHARES, case_kinds, draw_trials


@pytest.mark.parametrize("cases", [10, 25, 100])
def test_four_in_ten_cases_have_nothing_that_a_library_could_name(cases):
    kinds_of_cases = case_kinds(5, cases)
    assert len(kinds_of_cases) == cases
    nameless = [kind for kind in kinds_of_cases if not set(kind.effects) & set(IN_LIBRARY)]
    assert len(nameless) >= 0.4 * cases
    assert sum(SHARES.values()) == pytest.approx(1.0)


def test_every_kind_comes_up_as_often_as_any_other():
    kinds = Counter(kind.effects[0] for kind in case_kinds(1, 300) if kind.effects)
    inside = [kinds[kind] for kind in IN_LIBRARY]
    outside = [kinds[kind] for kind in IN_NO_LIBRARY]
    assert max(inside) - min(inside) <= 1
    assert max(outside) - min(outside) <= 1
    assert len(IN_NO_LIBRARY) >= 6


def test_cases_are_drawn_from_seed_and_place():
    first, again, other = draw_trials(3, 12), draw_trials(3, 12), draw_trials(4, 12)
    assert [answer_of(case) for case in first] == [answer_of(case) for case in again]
    assert [case.rig for case in first] != [case.rig for case in other]
    assert all(case.laws == SAME_LAWS for case in draw_trials(3, 4, same_laws=True))
    assert [case.effects for case in draw_trials(3, 4, same_laws=True)] == [c.effects for c in draw_trials(3, 4)]


@pytest.mark.full
def test_answers_say_what_is_due():
    for case in draw_trials(8, 40):
        answer = answer_of(case)
        inside = [effect["in_library"] for effect in answer["effects"]]
        due = "adequate" if not inside else "missing_physics" if all(inside) else "unexplained"
        assert answer["verdict"] == due
        json.dumps(answer)


@pytest.mark.long
def test_the_command_writes_recordings_and_prints_the_seal(tmp_path):
    folder = tmp_path / "trials"
    told = CliRunner().invoke(make, ["--seed", "2", "--cases", "2", "--out", str(folder), "--duration", "1"])
    assert told.exit_code == 0, told.output
    assert (folder / SEAL).read_text().strip() in told.output
    for case in ("case-001", "case-002"):
        runs = sorted((folder / "recordings" / case).glob("*.parquet"))
        assert [run.name for run in runs] == [f"run{i}.parquet" for i in range(1, 5)]
        table, sheet = pq.read_table(runs[0]), yaml.safe_load(runs[0].with_suffix(".yaml").read_text())
        assert set(table.column_names) == set(sheet["channels"])
        assert table.num_rows == 25000
        assert table.schema.metadata is None  # nothing but the columns
        assert set(sheet["run"]) == {
            "motor", "gear_ratio", "speed_rpm", "profile", "occupancy_percent", "particle_size_mm"
        }  # fmt: skip
    again = CliRunner().invoke(make, ["--seed", "2", "--cases", "2", "--out", str(folder)])
    assert again.exit_code == 2
    assert "the folder is not empty" in again.output


def test_the_same_seed_makes_the_same_recordings(tmp_path):
    cases = draw_trials(6, 1, duration=1.0)
    seals = [make_trials(cases, tmp_path / name) for name in ("one", "two")]
    assert seals[0] == seals[1]
    files = [tmp_path / name / "recordings" / "case-001" / "run1.parquet" for name in ("one", "two")]
    assert files[0].read_bytes() == files[1].read_bytes()


def test_a_broken_seal_is_seen(tmp_path):
    apart = tmp_path / "elsewhere.json"
    seal({"case-001": {"verdict": "adequate"}}, tmp_path / "t", apart=apart)
    assert unseal(tmp_path / "t", apart=apart) == {"case-001": {"verdict": "adequate"}}
    apart.write_text(apart.read_text().replace("adequate", "unexplained"))
    with pytest.raises(ProofError, match="changed after it was sealed"):
        unseal(tmp_path / "t", apart=apart)
    with pytest.raises(ProofError, match="already holds sealed answers"):
        seal({}, tmp_path / "t")
    with pytest.raises(ProofError, match="not found"):
        unseal(tmp_path / "nowhere")


def test_the_riddle_has_its_twelve_rigs():
    cases = draw_riddle(1)
    seen = {(case.effects[0].kind, case.wanders, case.plan_kind) for case in cases}
    assert len(seen) == len(cases) == 12
    assert [case.effects for case in cases] != [case.effects for case in draw_riddle(2)]
    assert all(case.rig.speed_error == 0.0 for case in cases if not case.wanders)


@pytest.mark.long
@pytest.mark.parametrize("kind", ["gear_mesh", "pwm_aliasing", "torsional_mode"])
def test_each_rig_of_the_riddle_shows_280_hz_at_1000_rpm(kind):
    case = next(c for c in draw_riddle(3, duration=6.0) if c.effects[0].kind == kind and not c.wanders)
    effect = case.effects[0]
    if isinstance(effect, TorsionalMode):
        machine = effect.on_machine(machine_of(case.rig, SAME_LAWS), case.plan[0], np.random.default_rng(0))
        assert mode_frequencies(machine)[1] == pytest.approx(RIDDLE, abs=0.01)
        return
    volts = record(case.plan[1], case.rig, case.laws, effects=case.effects, seed=[1], wanders=False).torque
    power = np.abs(np.fft.rfft((volts - volts.mean()) * np.hanning(volts.size)))
    frequency = np.fft.rfftfreq(volts.size, 1.0 / 25000.0)
    near = (frequency > 260.0) & (frequency < 300.0)
    assert frequency[near][np.argmax(power[near])] == pytest.approx(RIDDLE, abs=0.2)
    assert {"gear_mesh": (), "pwm_aliasing": ("mains_interference",)}[kind] == effect.also_right()


@pytest.mark.long
def test_recordings_can_be_made_in_several_processes(tmp_path):
    cases = draw_trials(6, 2, duration=1.0)
    make_trials(cases, tmp_path / "two", workers=2)
    make_trials(cases, tmp_path / "one")
    for name in ("case-001", "case-002"):
        paths = [Path(tmp_path / folder / "recordings" / name / "run4.parquet") for folder in ("one", "two")]
        assert paths[0].read_bytes() == paths[1].read_bytes()
