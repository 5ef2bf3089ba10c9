"""Laws of every drawn fault: zero size changes nothing, the truth is the undisturbed signal, the mark fits."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest

import torquerig.synthetic.faults as package
from torquerig.errors import InputError
from torquerig.recordings.recording import Channel, Recording
from torquerig.synthetic.base_signal import base_signal
from torquerig.synthetic.faults.drawn_fault import AFFECTED, UNDISTURBED, DrawnFault
from torquerig.synthetic.faults.measured import SAMPLE_NUMBER, STAMPS, measured_names
from torquerig.synthetic.faults.registry import BY_NAME, FAULTS, with_faults
from torquerig.synthetic.mixture import mixed

every_fault = pytest.mark.parametrize("fault", FAULTS, ids=list(BY_NAME))


@pytest.fixture(scope="module")
def base() -> Recording:
    return mixed(base_signal())


def disturbed(base: Recording, fault: DrawnFault, *, seed: int = 1) -> Recording:
    return with_faults(base, [fault], seed=seed)


def same(one: Channel, other: Channel | None) -> bool:
    return (
        other is not None
        and one.si_per_unit == other.si_per_unit
        and one.unit == other.unit
        and np.array_equal(one.values, other.values)
    )


@every_fault
def test_zero_size_changes_nothing(base: Recording, fault: type[DrawnFault]) -> None:
    made = disturbed(base, fault.without_effect())
    assert made.sample_rate == base.sample_rate
    assert measured_names(made) == measured_names(base)
    for name in base.channels:
        assert same(base.channels[name], made.channels[name]), name
    marks = [one.values for name, one in made.channels.items() if name.startswith(AFFECTED)]
    assert not np.any(marks)
    if STAMPS in made.channels:
        assert np.array_equal(made.channels[STAMPS].values, base.time())


@every_fault
def test_the_truth_is_the_undisturbed_signal(base: Recording, fault: type[DrawnFault]) -> None:
    made = disturbed(base, fault())
    kept = np.arange(base.samples)
    if fault.acts_on == "rows":
        kept = made.channels[SAMPLE_NUMBER].values.astype(int)
    truths = {name.removeprefix(UNDISTURBED) for name in made.channels if name.startswith(UNDISTURBED)}
    changed = {
        name
        for name in measured_names(base)
        if fault.acts_on != "rows" and not same(base.channels[name], made.channels.get(name))
    }
    assert truths == changed | {"torque_V"}
    for name in truths:
        truth, before = made.channels[UNDISTURBED + name], base.channels[name]
        assert truth.truth
        assert (truth.unit, truth.si_per_unit, truth.quantity) == (before.unit, before.si_per_unit, before.quantity)
        assert np.array_equal(truth.values, before.values[kept])
    for name, one in base.channels.items():
        if one.truth:
            assert np.array_equal(made.channels[name].values, one.values[kept]), name


@every_fault
def test_the_default_size_disturbs_something(base: Recording, fault: type[DrawnFault]) -> None:
    made = disturbed(base, fault())
    stamps = made.channels.get(STAMPS)
    assert (
        made.sample_rate != base.sample_rate
        or made.samples != base.samples
        or any(not same(base.channels[name], made.channels.get(name)) for name in measured_names(base))
        or (stamps is not None and not np.array_equal(stamps.values, base.time()))
    )


@every_fault
def test_the_mark_matches_the_changed_samples(base: Recording, fault: type[DrawnFault]) -> None:
    made = disturbed(base, fault())
    marks = [one.values for name, one in made.channels.items() if name.startswith(AFFECTED)]
    if fault.acts_on == "whole":
        assert marks == []
        return
    mark = marks[0].astype(bool)
    assert 0 < mark.sum() < made.samples
    if fault.acts_on == "rows":
        assert np.array_equal(mark[1:], np.diff(made.channels[SAMPLE_NUMBER].values) != 1)
    elif fault.acts_on == "stamps":
        late = made.channels[STAMPS].values - base.time()
        assert np.array_equal(mark, late > 1 / base.sample_rate)
    elif fault.acts_on == "steps":
        off = made.channels["encoder_count"].values - base.channels["encoder_count"].values
        assert np.array_equal(mark[1:], np.diff(off) != 0)
    else:
        changed = _changed(base, made)
        assert not np.any(changed & ~mark)
        # within a moment the disturbed signal may cross the true one
        assert changed[mark].mean() > 0.95


def _changed(base: Recording, made: Recording) -> np.ndarray:
    names = {base.channels[name].quantity: name for name in measured_names(base)}
    others = {made.channels[name].quantity: name for name in measured_names(made)}
    off = [
        np.abs(made.channels[others[each]].in_si() - base.channels[names[each]].in_si()) > 1e-9 * np.ptp(base.torque())
        for each in names
    ]
    return np.logical_or.reduce(off)


@every_fault
def test_the_seed_alone_decides(base: Recording, fault: type[DrawnFault]) -> None:
    one, again, other = (disturbed(base, fault(), seed=seed) for seed in (3, 3, 4))
    assert list(one.channels) == list(again.channels)
    assert all(np.array_equal(one.channels[name].values, again.channels[name].values) for name in one.channels)
    drawn = any(declared.unit == "1/s" for declared, _ in fault.parameters().values() if hasattr(declared, "unit"))
    if drawn:
        assert any(not np.array_equal(one.channels[name].values, other.channels[name].values) for name in one.channels)


@every_fault
def test_each_is_described(fault: type[DrawnFault]) -> None:
    """Every parameter has a unit or a meaning; a command names the fault, or the registry says why none does."""
    declared = set(fault.parameters())
    assert declared == {one.name for one in fields(fault)} - {"type"}
    assert all(each.meaning for each, _ in fault.parameters().values())
    assert bool(fault.named_by) != bool(fault.unnamed)
    assert bool(fault.named_by) == bool(fault.named_as)
    assert set(fault.zero) <= declared


def test_every_module_of_a_fault_is_in_the_registry() -> None:
    shared = {"__init__", "registry", "counter_steps", "drawn_fault", "measured", "moments", "parameter_table"}
    modules = {path.stem for path in Path(str(package.__file__)).parent.glob("*.py")} - shared
    assert modules == {each.__module__.rpartition(".")[2] for each in FAULTS}
    assert len(BY_NAME) == len(FAULTS)


def test_faults_add_up_and_the_truth_is_before_all_of_them(base: Recording) -> None:
    made = with_faults(base, [BY_NAME["drift"](span=0.3), BY_NAME["spikes"](), BY_NAME["spikes"]()], seed=1)
    assert np.array_equal(made.channels["undisturbed_torque_V"].values, base.torque_values())
    assert {"affected_by_spikes", "affected_by_spikes_2"} < set(made.channels)
    assert [one["type"] for one in made.origin["faults"]] == ["drift", "spikes", "spikes"]


def test_sizes_are_in_newton_metres_whatever_the_unit_of_the_channel(base: Recording) -> None:
    scaled = base.with_channel(
        "torque_V", Channel(values=2.0 * base.torque_values(), quantity="torque", unit="V", si_per_unit=0.5)
    )
    for name in ("spikes", "dropouts", "hum", "mean_steps", "quantised"):
        one, other = (disturbed(each, BY_NAME[name]()).torque() for each in (base, scaled))
        assert np.allclose(one, other, rtol=0, atol=1e-12), name


@pytest.mark.parametrize(
    ("name", "parameters", "told"),
    [
        ("spikes", {"rate": 1e-3}, "is none in 12 s; write a rate of at least 5 per minute"),
        ("dropouts", {"rate": 200.0}, "do not fit into 60000 samples"),
        ("dropouts", {"length": 1e-6}, "is less than half a sample"),
        ("dropouts", {"cutoff": 3e3}, "not below half the sample rate"),
        ("spikes", {"rate": 1e9}, "do not fit into 60000 samples"),
        ("wrapped_angle", {"unit": "count", "bits": 5000}, "write a whole number from 0 to 64"),
        ("alias", {"order": 12.0}, "write an order above"),
        ("sweep", {"stop": 3e3}, "not below half the sample rate"),
        ("clipping", {"share": -0.1}, "must be at least 0"),
        ("held_samples", {"every": 0}, "write a whole number from 1 to 1000000"),
    ],
)
def test_what_cannot_be_drawn_is_one_sentence(base: Recording, name: str, parameters: dict, told: str) -> None:
    with pytest.raises(InputError, match=told):
        disturbed(base, BY_NAME[name](**parameters))


@pytest.mark.parametrize("name", ["lost_counts", "doubled_counts", "wrapped_angle", "wrong_counts_per_turn", "alias"])
def test_a_recording_without_an_angle_is_refused(base: Recording, name: str) -> None:
    without = Recording(sample_rate=base.sample_rate, channels={"torque_V": base.channels["torque_V"]})
    with pytest.raises(InputError, match="the angle of an encoder, and there is none"):
        disturbed(without, BY_NAME[name]())
