"""The page of a diagnosis: self-contained, and it says what the diagnosis says."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from threadpoolctl import threadpool_limits

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.cli import main
from torquerig.diagnosis.engine import Outcome, diagnose
from torquerig.diagnosis.showing.comparison import Compared, compared, most_telling
from torquerig.diagnosis.showing.comparison_curves import held_spans, line_wave, order_spectrum, window_of
from torquerig.document import read_document
from torquerig.mechanisms import GearMesh, TorqueRipple
from torquerig.recordings.recording import Recording
from torquerig.reporting.diagnosis.mismatch_figure import mismatch_picture
from torquerig.reporting.diagnosis.parameter_tables import fitted_parameters_table, unit_of
from torquerig.reporting.diagnosis.rules.line_labels import FOUND, KNOWN, line_labels
from torquerig.reporting.diagnosis.rules.page import diagnosis_page
from torquerig.reporting.diagnosis.rules.residual_figure import has_residuals
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

pytestmark = pytest.mark.long  # one whole diagnosis for the file
RATE = 5000.0
MESH = GearMesh(name="hidden", order_output=84.0, transmission_error=(5e-5,))
FREE = ("wear_part.inertia", "coupling.stiffness")


@pytest.fixture(autouse=True, scope="module")
def _one_thread() -> Iterator[None]:
    with threadpool_limits(limits=1, user_api="blas"):
        yield


@pytest.fixture(scope="module")
def scenario() -> Scenario:
    made = read_scenario(read_document(shipped_scenarios() / "wear_rig.yaml"), load_catalog(shipped_folder()), seed=1)
    rig = made.rig
    for ripple in rig.parts_of(TorqueRipple):
        rig = rig.changed(replace(ripple, amplitude_rel_sd=0.0))
    return replace(made, rig=rig, uncertainties={name: made.uncertainties[name] for name in FREE})


def recorded(scenario: Scenario, rpm: float, profile: str, seed: int) -> Recording:
    rig = scenario.rig + MESH
    speed = rpm * pi / 30
    run = replace(rig.run, speed=1.004 * speed, occupancy_percent=5.0, profile=profile)  # type: ignore[arg-type]
    made = simulate(rig.at(run), duration=5.0, seed=seed, sample_rate=RATE).without_truth()
    return replace(made, name=f"{profile}.parquet", run=replace(made.run, speed=speed))


@pytest.fixture(scope="module")
def outcome(scenario: Scenario) -> Outcome:
    return diagnose(scenario, [recorded(scenario, 1000, "steady", 3), recorded(scenario, 600, "reversal", 4)])


@pytest.fixture(scope="module")
def runs(outcome: Outcome) -> tuple[Compared, ...]:
    return compared(outcome)


@pytest.fixture(scope="module")
def page(outcome: Outcome) -> str:
    return diagnosis_page(outcome, title="wear_rig", command="torquerig diagnose a", model="m.yaml", seed=0)


def test_the_page_needs_nothing_from_elsewhere(page: str) -> None:
    assert "<script src" not in page
    assert not re.search(r'(src|href)="(?!data:|#)', page)
    assert "@import" not in page
    assert "url(" not in page
    assert page.count('<img src="data:image/svg+xml;base64,') == 5


def test_in_a_browser_the_page_is_whole_and_axe_finds_no_serious_fault(
    page: str, tmp_path: Path, open_page: Callable[..., Any]
) -> None:
    file = tmp_path / "diagnosis.html"
    file.write_text(page, encoding="utf-8")
    shown = open_page(file, width=390)
    shown.unfold()
    assert shown.requests == [file.as_uri()]
    assert shown.errors == []
    assert shown.js("document.documentElement.scrollWidth") <= 390
    from axe_playwright_python.sync_playwright import Axe  # open_page skips where it is not installed

    found = Axe().run(shown.page).response["violations"]
    assert [one["id"] for one in found if one["impact"] in ("serious", "critical")] == []
    sentences = shown.js("[...document.querySelectorAll('.answer p')].map((one) => one.innerText)")
    assert sentences[0].startswith("The model lacks gear mesh (84 per output turn, 0.05")
    assert max(len(one.split()) for text in sentences for one in text.split(". ")) <= 25


def test_the_page_says_what_the_diagnosis_says(page: str, outcome: Outcome) -> None:
    diagnosis = outcome.diagnosis
    (finding,) = diagnosis.findings
    assert finding.mechanism == "gear_mesh"
    text = re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", page))
    assert (
        "The model lacks gear mesh. With it, the mean squared standardised residual on held-out data falls from" in text
    )
    assert f"confidence {100 * finding.confidence:.0f} %" in text
    assert finding.explanation in text
    assert all(name in text for name in finding.parameters)
    assert all(name.replace("_", " ") in text for name, _ in finding.alternatives)
    assert all(reason in text.replace("&#39;", "'") for reason in diagnosis.set_aside.values())
    assert "at order 84 of the output shaft periodic in the angle of the output shaft" in text
    assert all(f"{name.split('.')[0].replace('_', ' ')}" in text for name in FREE)
    assert "steady.parquet" in text
    assert "reversal.parquet" in text
    assert "torquerig diagnose a" in text
    assert "m.yaml" in text


def test_the_same_outcome_gives_the_same_page(page: str, outcome: Outcome) -> None:
    again = diagnosis_page(outcome, title="wear_rig", command="torquerig diagnose a", model="m.yaml", seed=0)
    assert again == page


def test_a_picture_of_places_is_drawn_only_where_there_is_something_to_see(outcome: Outcome) -> None:
    """pytest turns matplotlib's complaints about an empty or squeezed picture into errors."""
    (worst, *_) = outcome.diagnosis.mismatch
    shares = ((0.0,), (1e-6,), (0.0, 0.0))
    assert mismatch_picture(()) is None
    assert all(mismatch_picture([replace(worst, share_of_misfit=one) for one in each]) is None for each in shares)
    small = mismatch_picture([replace(worst, share_of_misfit=1e-3)])
    assert small is not None
    assert small.caption.startswith("Each place")


def test_residuals_are_drawn_only_where_there_are_some(runs: tuple[Compared, ...]) -> None:
    steady = runs[0]
    bare = replace(steady, held=replace(steady.held, places=(), power=np.zeros(0)))
    assert has_residuals(steady, ())
    assert has_residuals(None, runs[1:])
    assert not has_residuals(bare, ())


def test_the_page_of_nothing_missing_says_so_in_words(outcome: Outcome) -> None:
    fine = replace(outcome.diagnosis, verdict="adequate", mismatch=(), findings=())
    told = diagnosis_page(replace(outcome, diagnosis=fine, left=()), title="a", command="b", model=None, seed=0)
    assert "No physics is missing that these recordings can show." in told
    assert "No difference is significant, so there is no figure of it." in told
    shareless = tuple(replace(one, share_of_misfit=0.0) for one in outcome.diagnosis.mismatch)
    none = replace(outcome, diagnosis=replace(fine, verdict="unexplained", mismatch=shareless))
    told = diagnosis_page(none, title="a", command="b", model=None, seed=0)
    assert "No figure: no place has a visible share of the squared residual." in told


def test_only_what_no_fit_has_seen_is_compared(runs: tuple[Compared, ...]) -> None:
    steady, turning = runs
    assert np.array(held_spans(steady.held)) == pytest.approx(np.array([[10 / 3, 25 / 6], [25 / 6, 5.0]]), abs=1e-3)
    assert turning.held.turning is not None
    assert steady.gained > 0
    assert most_telling(runs) is steady


def test_the_completed_model_takes_its_line_out_of_the_recording(runs: tuple[Compared, ...]) -> None:
    steady = runs[0]
    window = window_of(steady.held, row=0, duration=0.5)
    assert window.stop - window.start == round(0.5 * RATE)
    torque = steady.held.observed.torque[window]
    turned = np.exp(-16.8j * steady.held.observed.angle[window]) * np.hanning(torque.size)
    left = [
        abs(turned @ (torque - line_wave(steady.held, side, row=0, window=window)))
        for side in (steady.before, steady.after)
    ]
    # sizes are predicted within 4 % and more, phases are the recording's; the load is in both
    assert left[1] < 0.3 * left[0]


def test_an_order_spectrum_shows_a_line_at_its_order_with_its_size(runs: tuple[Compared, ...]) -> None:
    """84 per output turn; a Hann window between two bins shows 85 % (Harris 1978)."""
    steady = runs[0]
    orders, amplitudes = order_spectrum(steady.held.observed, steady.held, ratio=5.0)
    near = np.flatnonzero((orders > 80) & (orders < 88))
    top = near[int(np.argmax(amplitudes[near]))]
    assert orders[top] == pytest.approx(84.0, abs=2 * orders[1])
    column = [round(place.at * 5, 3) for place in steady.held.places].index(84.0)
    size = float(np.abs(steady.held.amplitude[:, column]).mean())
    assert 0.75 * size < amplitudes[top] < 1.1 * size


def test_lines_are_labelled_by_cause(outcome: Outcome, runs: tuple[Compared, ...]) -> None:
    listed = line_labels(outcome, runs[0])
    found = [cause for cause in listed if cause.colour == FOUND]
    assert [(cause.text, round(cause.order)) for cause in found] == [("gear mesh", 84)]
    known = {round(cause.order): cause.text for cause in listed if cause.colour == KNOWN}
    assert known[1] == "shaft"
    assert known[30] == "motor.cogging"


def test_the_fitted_numbers_stand_in_their_declared_units(outcome: Outcome) -> None:
    assert unit_of(outcome.completed.part("wear_part"), "inertia") == "kg*m^2"
    assert unit_of(outcome.completed.part("load"), "mean_by_occupancy_percent") == "N*m"
    table = fitted_parameters_table(outcome.before.nominal, outcome.before.model, outcome.after.model)
    rows = {row[0].text: [cell.text for cell in row] for row in table.rows}
    assert rows["wear part.inertia"][1:3] == ["0.002", "10.5 %"]
    assert rows["wear part.inertia"][-1] == "kg*m^2"


def test_the_command_writes_the_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, outcome: Outcome, capsys: pytest.CaptureFixture[str]
) -> None:
    from torquerig.recordings.files import write_recording

    monkeypatch.chdir(tmp_path)
    write_recording(outcome.held[0].observed.recording, tmp_path / "steady.parquet")
    monkeypatch.setattr("torquerig.diagnosis.engine.diagnose", lambda *_, **__: outcome)
    given = ["diagnose", "steady.parquet", "--scenario", str(shipped_scenarios() / "wear_rig.yaml")]
    main([*given, "--json", "out.json", "--report", "out.html"])
    page = (tmp_path / "out.html").read_text(encoding="utf-8")
    assert "torquerig diagnose steady.parquet --scenario wear_rig.yaml --json diagnosis.json" in page
    assert "out.model.yaml" in page
    assert str(tmp_path) not in page


def test_a_page_in_no_folder_is_refused_before_any_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    given = ["diagnose", "none.parquet", "--scenario", "none.yaml", "--json", "-", "--report", "nowhere/out.html"]
    with pytest.raises(SystemExit) as left:
        main(given)
    assert left.value.code == 2
    said = capsys.readouterr()
    assert "there is no folder nowhere" in said.err
    assert said.out == ""
