"""A what-if has the numbers of the command line: simulate, filter and size with the same changes."""

import json
import math
from base64 import b64decode
from pathlib import Path

import numpy as np
import pytest
import yaml

import torquerig as tr
from torquerig.catalog.search import catalog_for
from torquerig.cli import main
from torquerig.errors import InputError
from torquerig.studio.what_if.changeable import changeable
from torquerig.studio.what_if.engine import WhatIf
from torquerig.studio.what_if.question import LENGTH, Question
from torquerig.studio.what_if.quick_curve import quick_curve
from torquerig.studio.what_if.taken_over import taken_over

ROOT = Path(__file__).resolve().parents[3]
SCENARIO = ROOT / "scenarios" / "wear_rig.yaml"
TEXT = SCENARIO.read_text(encoding="utf-8")
SAME = 1e-9  # [1] relative: digits of a double after the sums of 50 000 samples
LINES = 1e-7  # [1] relative: of a small rest behind a filter that subtracts, from a file with 12 digits
CHANGED = {
    "motor": "HDS6A-0104A", "gearbox": "spur-2.5-1", "chain": "order_lines_low_pass",
    "settings": ((("operating_point", "output_speed"), "250 rpm"), (("operating_point", "load", "occupancy"), "11 %")),
}  # fmt: skip


@pytest.fixture(scope="module")
def engine():
    return WhatIf()


def question(**changes):
    return Question(path=SCENARIO, text=TEXT, **changes)


def options(asked):
    found = ["--seed", str(asked.seed)]
    for name, value in (("--motor", asked.motor), ("--gearbox", asked.gearbox)):
        found += [name, value] if value else []
    return [*found, *(word for one in asked.written_settings() for word in ("--set", one))]


def command(folder, *words):
    file = folder / f"{words[0]}.json"
    main([str(word) for word in (*words, "--json", file)])
    return json.loads(file.read_text(encoding="utf-8"))


@pytest.mark.long
@pytest.mark.parametrize("changes", [{"chain": "low_pass_20Hz"}, CHANGED], ids=["as stated", "changed"])
def test_the_numbers_are_those_of_simulate_filter_and_size(tmp_path, engine, changes):
    asked = question(**changes)
    recording = tmp_path / "run.parquet"
    command(tmp_path, "simulate", SCENARIO, "--duration", f"{LENGTH:g} s", "--truth", "--out", recording,
            *options(asked))  # fmt: skip
    filtered = command(tmp_path, "filter", recording, "--chain", asked.chain)
    found, chain = engine.simulated(asked), filtered["chains"][0]
    assert found.mean == pytest.approx(filtered["mean"]["value"], rel=SAME)
    assert found.std == pytest.approx(filtered["std"]["value"], rel=SAME)
    assert found.error_after == pytest.approx(chain["error_to_true_load"]["value"], rel=SAME)
    for one in chain["lines"]:
        if one["cause"] in ("shaft", "motor", "electrical"):  # the chain has four harmonics of these, as the rows
            rows = [row for row in found.lines if row.family == one["cause"]]
            assert math.hypot(*(row.before for row in rows)) == pytest.approx(one["before"]["value"], rel=LINES)
            assert math.hypot(*(row.after for row in rows)) == pytest.approx(one["after"]["value"], rel=LINES)


@pytest.mark.parametrize("changes", [{}, CHANGED], ids=["as stated", "changed"])
def test_the_sizing_is_that_of_size(engine, changes):
    asked = question(**changes)
    sized = tr.size(
        SCENARIO, motor=asked.motor or None, gearbox=asked.gearbox or None,
        changes={".".join(keys): text for keys, text in asked.settings},
    )  # fmt: skip
    found = engine.sized(asked)
    assert found.verdict == sized.verdict
    assert found.sentence in sized.summary()
    assert found.values == {name: one.value for name, one in sized.sizing.figures.items() if one.value is not None}


def test_another_chain_filters_the_same_recording(engine, monkeypatch):
    first = engine.simulated(question(chain="none"))
    monkeypatch.setattr("torquerig.studio.what_if.engine.simulate", None)  # a second simulation would fail
    second = engine.simulated(question(chain="low_pass_20Hz"))
    assert second.std == first.std
    assert second.error_after < first.error_after == first.error_before


def test_changes_taken_over_give_the_same_numbers_without_an_option(tmp_path, engine):
    asked = question(**CHANGED)
    data = yaml.safe_load(TEXT)
    for edit in taken_over(asked, catalog_for(SCENARIO)):
        holder = data
        for key in edit.keys[:-1]:
            holder = holder[key]
        if edit.value is None:
            del holder[edit.keys[-1]]
        else:
            holder[edit.keys[-1]] = edit.value
    saved = Question(path=SCENARIO, text=yaml.safe_dump(data, sort_keys=False), chain=asked.chain)
    one, other = engine.simulated(asked), engine.simulated(saved)
    assert other.error_after == pytest.approx(one.error_after, rel=SAME)
    assert other.std == pytest.approx(one.std, rel=SAME)
    assert engine.sized(saved).values == pytest.approx(engine.sized(asked).values, rel=SAME)


def test_what_can_be_changed_is_what_the_scenario_states():
    found = changeable(TEXT, SCENARIO, catalog_for(SCENARIO))
    assert (found.motor, found.gearbox, found.chain) == ("bldc-12n14p", "reference-5-1", "none")
    assert {one.label: one.written for one in found.numbers} == {
        "ratio of gearbox": "", "output speed": "200 rpm", "occupancy": "5 %", "particle size": "0.5 mm",
    }  # fmt: skip
    assert "order_lines_low_pass" in found.chains
    assert "HDS6A-0104A" in found.motors


@pytest.mark.parametrize("name", ["two_stage_branch.yaml", "linear_axis.yaml", "belt_servo_axis.yaml"])
def test_other_rigs_answer_too(engine, name):
    path = SCENARIO.parent / name
    found = changeable(path.read_text(encoding="utf-8"), path, catalog_for(path))
    asked = Question(path=path, text=path.read_text(encoding="utf-8"), chain=found.chain)
    answer = engine.simulated(asked)
    assert answer.std > 0
    assert answer.signal["curves"]["before"]["samples"] > 1000


def test_a_wrong_number_is_said_with_its_key_and_the_next_question_is_answered(engine):
    wrong = question(settings=((("operating_point", "output_speed"), "200 N"),))
    with pytest.raises(InputError, match=r"operating_point\.output_speed.*200 N"):
        engine.simulated(wrong)
    assert engine.simulated(question()).std > 0


def test_an_edited_catalog_is_read_again(tmp_path):
    folder = tmp_path / "catalogs" / "motors"
    folder.mkdir(parents=True)
    shipped = (ROOT / "catalogs" / "motors" / "HDS6A-0104A.yaml").read_text(encoding="utf-8")
    file = folder / "mine.yaml"
    file.write_text(shipped.replace("HDS6A-0104A", "mine"), encoding="utf-8")
    asked, engine = Question(path=SCENARIO, text=TEXT, motor="mine", catalogs=(tmp_path / "catalogs",)), WhatIf()
    before = engine.simulated(asked).std
    file.write_text("name: mine\nnonsense: 3\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"mine\.yaml"):
        engine.simulated(asked)
    file.write_text(shipped.replace("HDS6A-0104A", "mine"), encoding="utf-8")
    assert engine.simulated(asked).std == before


def test_the_commands_are_those_that_give_the_numbers():
    found = question(**CHANGED).commands()
    assert found["simulate"] == (
        "torquerig simulate wear_rig.yaml --duration '2 s' --truth --seed 1 --motor HDS6A-0104A --gearbox spur-2.5-1 "
        "--set 'operating_point.output_speed=250 rpm' --set 'operating_point.load.occupancy=11 %' --out what_if.parquet"
    )
    assert found["filter"] == "torquerig filter what_if.parquet --chain order_lines_low_pass"


def test_a_quick_curve_keeps_its_values_to_half_a_step():
    values = np.random.default_rng(1).normal(size=1000)
    packed = quick_curve(values, start=0.0, step=1.0)
    codes = np.frombuffer(b64decode(packed["codes"]), dtype="<u2")
    assert packed["low"] + codes * packed["size"] == pytest.approx(values, abs=0.5001 * packed["size"])
    assert packed["size"] == pytest.approx(np.ptp(values) / 65535)
