"""The same rig in other units of torque and time gives the same answers in compare, size, duty, modes and info."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

import torquerig as tr
from tests.scaled_documents import factor, write_twin
from tests.scaled_rigs import Scale, scaled_rig
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.metrics.sizing.drive_sizing import SIZING_UNITS
from torquerig.recordings.inspection.recording_info import recording_info
from torquerig.recordings.recording import Recording
from torquerig.simulation.simulator import simulate
from torquerig.simulation.twin.linear_twin import Twin, twin_of

PLAIN = Scale(1.0, 1.0)
SCALES = [Scale(0.01, 1.0), Scale(100.0, 1.0), Scale(1.0, 0.2), Scale(1.0, 4.0), Scale(100.0, 0.2)]
SCENARIOS = ["wear_rig.yaml", "belt_servo_axis.yaml", "spur_gearbox_mixer.yaml", "linear_axis.yaml"]
ENTRIES = ("bldc-12n14p", "HDS6A-0104A", "reference-5-1", "economy-5-1", "reference-10nm", "reference-coupling")
WEAR_RIG = shipped_scenarios() / "wear_rig.yaml"


def cases(names: list[str]) -> list[object]:
    """Return each name with every scale; all but one torque, one speed and both together only in .ci/full."""
    quick = (SCALES[1], SCALES[3], SCALES[4])
    return [
        pytest.param(name, scale, marks=() if scale in quick[-1 if name != names[0] else 0 :] else pytest.mark.full)
        for name in names
        for scale in SCALES
    ]


def same(found: float | None, expected: float | None, *, by: float = 1.0, rel: float = 1e-6) -> bool:
    if found is None or expected is None:
        return found is expected
    return found == pytest.approx(expected * by, rel=rel, abs=1e-300)


def numberless(text: str) -> str:
    return re.sub(r"-?\d[\d.e+-]*", "#", text)


# modes


@cache
def linear(scenario: str, scale: Scale) -> Twin:
    made = tr.read_scenario(shipped_scenarios() / scenario)
    return twin_of(scaled_rig(made.rig, scale), rate=made.recording.sample_rate * scale.speed, seed=1)


@pytest.mark.parametrize(("scenario", "scale"), cases(SCENARIOS))
def test_modes_and_margins_scale(scenario: str, scale: Scale) -> None:
    plain, twin = linear(scenario, PLAIN), linear(scenario, scale)
    assert len(twin.modes()) == len(plain.modes()) > 0
    for one, other in zip(plain.modes(), twin.modes(), strict=True):
        assert same(other.undamped, one.undamped, by=scale.speed)
        assert same(other.damped, one.damped, by=scale.speed)
        assert same(other.damping, one.damping)
        assert other.words == one.words
    assert twin.stable == plain.stable
    for loop, scaled in zip(plain.margins(), twin.margins(), strict=True):
        assert scaled.crossovers == pytest.approx([one * scale.speed for one in loop.crossovers], rel=1e-4)
        assert same(scaled.phase_margin, loop.phase_margin, rel=1e-3)
        assert same(scaled.modulus_margin, loop.modulus_margin, rel=1e-3)


# info


@cache
def recorded(scenario: str, scale: Scale) -> Recording:
    made = tr.read_scenario(shipped_scenarios() / scenario)
    return simulate(
        scaled_rig(made.rig, scale), duration=1.0 / scale.speed, seed=3, sample_rate=2000.0 * scale.speed,
        settling=0.2 / scale.speed,
    ).without_truth()  # fmt: skip


@pytest.mark.parametrize("scale", SCALES)
def test_levels_and_suspicions_of_a_recording_scale(scale: Scale) -> None:
    plain, twin = (recording_info(recorded("wear_rig.yaml", one)) for one in (PLAIN, scale))
    assert twin.samples == plain.samples
    assert same(twin.duration, plain.duration, by=1 / scale.speed)
    for name, one in plain.channels.items():
        other = twin.channels[name]  # volts and counts, which are kept
        for level in ("minimum", "mean", "maximum", "std"):
            assert getattr(other, level) == pytest.approx(getattr(one, level), rel=1e-6, abs=1e-9), (name, level)
    assert [*map(numberless, twin.suspicions())] == [*map(numberless, plain.suspicions())]


# size and duty


def scaled_files(folder: Path, scale: Scale) -> tuple[Path, list[Path]]:
    """The wear rig with the motor of a data sheet, whose ratings and thermal data are known."""
    path = write_twin(folder, WEAR_RIG, shipped_folder(), scale, entries=ENTRIES)
    return path, [folder / "catalogs"]


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[Scale, tuple[Path, list[Path]]]:
    return {scale: scaled_files(tmp_path_factory.mktemp("twin"), scale) for scale in (PLAIN, *SCALES)}


@pytest.mark.parametrize(("motor", "scale"), cases(["HDS6A-0104A", "bldc-12n14p"]))
def test_a_sizing_scales(files: dict[Scale, tuple[Path, list[Path]]], motor: str, scale: Scale) -> None:
    plain, twin = (
        tr.size(files[one][0], motor=motor, gearbox="reference-5-1", catalogs=files[one][1]).sizing
        for one in (PLAIN, scale)
    )
    assert twin.figures.keys() == plain.figures.keys()
    for name, one in plain.figures.items():
        other, by = twin.figures[name], factor(SIZING_UNITS[name], scale)
        if name.startswith("thermal"):
            if motor == "bldc-12n14p":
                continue  # no document states its thermal data, which are those of motors of its size
            rel = 1e-3  # a cycle is cut into stretches of half a second at least
        else:
            rel = 1e-6
        for end in ("value", "low", "high"):
            assert same(getattr(other, end), getattr(one, end), by=by, rel=rel), (name, end)
        assert twin.word(name) == plain.word(name), name
    if motor != "bldc-12n14p":
        assert twin.verdict == plain.verdict


@pytest.mark.parametrize("scale", SCALES)
def test_a_duty_scales(files: dict[Scale, tuple[Path, list[Path]]], scale: Scale) -> None:
    plain, twin = (
        tr.duty(
            tr.read_scenario(files[one][0], motor="HDS6A-0104A", gearbox="reference-5-1", catalogs=files[one][1]),
            duration=20.0 / one.speed,
        )
        for one in (PLAIN, scale)
    )
    assert twin.verdict == plain.verdict
    left, right = plain.to_frame(), twin.to_frame()
    assert list(right.index) == list(left.index)
    for figure in left.index:
        unit = str(left.loc[figure, "unit"])
        by = factor(unit, scale)
        for end in ("value", "low", "high"):
            one, other = float(left.loc[figure, end]), float(right.loc[figure, end])
            # a cycle is cut into stretches of half a second at least
            assert other == pytest.approx(one * by, rel=1e-3 if unit in ("C", "K") else 1e-6, nan_ok=True), figure


# compare


@pytest.mark.long
def test_a_comparison_scales(tmp_path: Path) -> None:
    """Torque alone: settings of a study that a scenario leaves out, such as the wander's cut-off, are in seconds."""
    changes = {"study.motors": ["bldc-12n14p"], "study.gearboxes": ["reference-5-1"],
               "study.draws": 0, "study.duration": "1 s", "study.filters.names": ["none", "order_lines"]}  # fmt: skip
    made = []
    for scale in (PLAIN, Scale(100.0, 1.0)):
        path, catalogs = scaled_files(tmp_path / f"{scale.torque:g}", scale)
        made.append(tr.compare(path, changes=changes, catalogs=catalogs))
    plain, twin = made
    assert list(twin.ranking["motor"]) == list(plain.ranking["motor"])
    assert list(twin.ranking["filter"]) == list(plain.ranking["filter"])
    for one, other in zip(plain.runs.drives, twin.runs.drives, strict=True):
        assert same(other.disturbance.value, one.disturbance.value, by=100.0, rel=1e-5)
        for name, result in one.chains.items():
            assert same(other.chains[name].truth_error.value, result.truth_error.value, by=100.0, rel=1e-5)
        assert {key: figure.missing for key, figure in other.margins.items()}.keys() == one.margins.keys()
    assert numberless(twin.verdict.sentence) == numberless(plain.verdict.sentence)
