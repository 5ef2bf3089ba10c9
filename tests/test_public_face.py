"""The names of ``import torquerig as tr``: lazy, documented, with examples that run, and frozen results."""

import doctest
import inspect
import json
import subprocess
import sys
from dataclasses import FrozenInstanceError, fields
from importlib import import_module
from pkgutil import iter_modules

import pytest

import torquerig as tr

FUNCTIONS = sorted(set(tr.__all__) - {"mechanisms"})
SLOW = {"diagnose", "compare"}


def test_importing_the_package_imports_no_library():
    heavy = "('numpy', 'scipy', 'pandas', 'matplotlib', 'numba')"
    script = f"import sys, torquerig; print([name for name in {heavy} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


@pytest.mark.parametrize("name", FUNCTIONS)
def test_each_function_states_parameters_result_errors_and_an_example(name):
    text = inspect.getdoc(getattr(tr, name))
    for section in ("Parameters\n", "Raises\n", "Examples\n", ">>> import "):
        assert section in text, section
    signature = inspect.signature(getattr(tr, name))
    for parameter in signature.parameters:
        assert parameter in text.split("Raises\n")[0], parameter


@pytest.mark.parametrize("name", [name for name in FUNCTIONS if name not in SLOW])
def test_the_example_of_each_function_runs(name):
    _run_examples(name)


@pytest.mark.long
@pytest.mark.parametrize("name", sorted(SLOW))
def test_the_example_of_each_slow_function_runs(name):
    _run_examples(name)


def _run_examples(name):
    function = getattr(tr, name)
    examples = doctest.DocTestFinder().find(function, name, globs={})
    assert sum(len(one.examples) for one in examples) >= 2
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    out = []
    for one in examples:
        runner.run(one, out=out.append)
    assert runner.failures == 0, "".join(out)


def test_no_public_name_is_a_package_or_module():
    modules = {found.name for found in iter_modules(tr.__path__)}
    assert modules & set(FUNCTIONS) == set()


def test_an_unknown_name_lists_what_there_is():
    with pytest.raises(AttributeError, match="read_scenario"):
        tr.simulat  # noqa: B018


def test_an_unknown_mechanism_names_close_ones():
    with pytest.raises(AttributeError, match="GearMesh"):
        tr.mechanisms.GearMash  # noqa: B018


@pytest.fixture(scope="module")
def rig():
    return tr.read_scenario("wear_rig.yaml")


@pytest.fixture(scope="module")
def recording(rig):
    return tr.simulate(rig, duration=2.0)


@pytest.fixture(scope="module")
def results(rig, recording):
    return {
        "scenario": rig,
        "recording": recording,
        "order_lines": tr.order_lines(recording),
        "modes": tr.modes(rig),
        "duty": tr.duty("wear_rig.yaml", motor="HDS6A-0104A"),
        "size": tr.size("wear_rig.yaml", motor="HDS6A-0104A", gearbox="reference-5-1"),
        "matrix": tr.matrix("matrix_example.yaml"),
    }


RESULTS = ("scenario", "recording", "order_lines", "modes", "duty", "size", "matrix")


@pytest.mark.parametrize("name", RESULTS)
def test_a_result_is_frozen_and_shows_itself(name, results):
    result = results[name]
    with pytest.raises(FrozenInstanceError):
        setattr(result, fields(result)[0].name, None)
    assert len(result.summary()) > 20
    assert "<table" in result._repr_html_()
    assert len(result.to_frame()) > 0
    assert json.loads(result.to_json())


@pytest.mark.long
@pytest.mark.parametrize("name", RESULTS)
def test_a_result_draws_itself(name, results):
    figure = results[name].plot()
    assert figure.axes
    assert figure._repr_png_().startswith(b"\x89PNG")


def test_a_result_writes_its_json(results, tmp_path):
    text = results["size"].to_json(tmp_path / "size.json")
    assert (tmp_path / "size.json").read_text() == text
    assert json.loads(text)["verdict"] == results["size"].verdict


def test_adding_an_effect_changes_what_is_simulated(rig, recording):
    wrong = rig + tr.mechanisms.MainsInterference(name="hum", amplitudes=(0.5,), phases=(0.0,))
    assert [part.name for part in wrong.added] == ["hum"]
    changed = tr.simulate(wrong, duration=2.0)
    assert abs(changed.torque() - recording.torque()).max() > 0.4
    assert rig.added == ()


def test_a_scenario_with_an_effect_is_written_and_read_again(rig, tmp_path):
    wrong = rig + tr.mechanisms.MainsInterference(name="hum", amplitudes=(0.5,), phases=(0.0,))
    again = tr.read_scenario(wrong.write(tmp_path / "wrong.yaml"))
    assert again.rig.part("hum") == wrong.rig.part("hum")


def test_an_effect_on_a_part_that_is_not_there_is_refused_at_once(rig):
    from torquerig.errors import TorquerigError

    with pytest.raises(TorquerigError, match="no_such"):
        rig + tr.mechanisms.QuadraticDrag(name="drag", at="no_such", coefficient=1e-4)


def test_a_recording_is_written_and_read_again(recording, tmp_path):
    tr.write(recording, tmp_path / "run.parquet")
    again = tr.read(tmp_path / "run.parquet")
    assert (again.torque() == recording.torque()).all()


def test_the_command_line_and_the_function_give_the_same_samples(tmp_path, monkeypatch):
    from torquerig.catalog.shipped import shipped_scenarios
    from torquerig.cli import main

    monkeypatch.chdir(tmp_path)
    main(["simulate", str(shipped_scenarios() / "wear_rig.yaml"), "--duration", "1 s", "--out", "a.parquet"])
    ours = tr.simulate("wear_rig.yaml", duration=1.0, truth=False)
    assert (tr.read("a.parquet").torque_values() == ours.torque_values()).all()


@pytest.mark.parametrize("name", sorted(set(FUNCTIONS) - {"write", "diagnose"}))  # these take a recording first
def test_a_missing_file_is_one_sentence(name, tmp_path):
    from torquerig.errors import InputError

    with pytest.raises(InputError, match="nowhere"):
        getattr(tr, name)(tmp_path / "nowhere.yaml")


def test_every_name_is_typed():
    for name in FUNCTIONS:
        function = getattr(tr, name)
        module = import_module(function.__module__)
        assert module.__name__.startswith("torquerig.api.")
        assert "return" in function.__annotations__
