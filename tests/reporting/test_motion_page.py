"""The page of a rig under measured motion says what the diagnosis says; warnings of matplotlib are errors here."""

from __future__ import annotations

import re
from base64 import b64decode
from dataclasses import replace
from html import unescape
from pathlib import Path

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tests.moved_rigs import CARRIAGE, RATE, ROTOR, Floats, diagnosed, recorded
from torquerig.cli import main
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.diagnosis.motion.set_aside import CLASSES
from torquerig.diagnosis.showing.motion_comparison import IN_A_LINE, TURNING, motion_compared
from torquerig.diagnosis.showing.motion_curves import level_over_speed, telling_window
from torquerig.diagnosis.showing.motion_lines import lines_compared
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.reporting.diagnosis.parameter_tables import added_parameters_table, fitted_parameters_table
from torquerig.reporting.diagnosis.rules.motion_lines_figure import motion_lines_figure
from torquerig.reporting.diagnosis.rules.motion_page import motion_page
from torquerig.reporting.diagnosis.rules.motion_position_figure import motion_position_figure
from torquerig.reporting.diagnosis.rules.motion_residual_figure import motion_residual_figure
from torquerig.reporting.diagnosis.rules.motion_speed_figure import motion_speed_figure
from torquerig.reporting.diagnosis.rules.motion_window_figure import motion_window_figure
from torquerig.reporting.figures.picture import svg

pytestmark = pytest.mark.long  # one whole diagnosis for the file


def uneven(time: Floats, position: Floats, speed: Floats) -> Floats:
    """6 N of dry friction, viscous friction, and 1 N at 150 per m."""
    return 6.0 * np.sign(speed) + 8.0 * speed + np.cos(2 * np.pi * 150.0 * position + 0.4)


def carriage(*, rough: bool) -> Recording:
    if rough:
        return recorded(uneven, name="rough.csv")
    return recorded(lambda time, *_: np.zeros(time.size), name="smooth.csv")


def rotor() -> Recording:
    """Two and a half turns of 12 slots and 14 poles: 0.02 N m at order 84."""
    time = np.arange(6000) / 100.0
    angle = 0.25 * time + 0.02 * np.sin(0.5 * time)
    torque = 0.02 * np.cos(84 * angle + 0.3) + 5e-4 * np.random.default_rng(3).standard_normal(time.size)
    channels = {
        "torque_Nm": Channel(values=torque, quantity="torque", unit="N*m"),
        "angle_rad": Channel(values=angle, quantity="angle", unit="rad"),
    }
    return Recording(sample_rate=100.0, channels=channels, name="turn.csv")


def paged(outcome: MotionOutcome) -> str:
    return motion_page(outcome, title="test_rig", command="torquerig diagnose a", model="m.yaml", seed=0)


def words_of(page: str) -> str:
    return unescape(re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", page.split("<body>")[1])))


def curve(axes: Axes, label: str) -> tuple[np.ndarray, np.ndarray]:
    """Return all lines of one colour in a panel, joined: those of the line that carries the label."""
    named = next(line for line in axes.get_lines() if line.get_label() == label)
    alike = [line for line in axes.get_lines() if line.get_color() == named.get_color()]
    return np.concatenate([line.get_xdata() for line in alike]), np.concatenate([line.get_ydata() for line in alike])


@pytest.fixture(scope="module")
def found() -> MotionOutcome:
    return diagnosed(carriage(rough=True))


@pytest.fixture(scope="module")
def fine() -> MotionOutcome:
    return diagnosed(carriage(rough=False))


@pytest.fixture(scope="module")
def turned() -> MotionOutcome:
    return diagnosed(rotor(), ROTOR)


@pytest.fixture(scope="module")
def page(found: MotionOutcome) -> str:
    return paged(found)


def test_the_page_needs_nothing_from_elsewhere(page: str) -> None:
    assert "<script src" not in page
    assert not re.search(r'(src|href)="(?!data:|#)', page)
    assert "@import" not in page
    assert "url(" not in page
    drawn = re.findall(r'<img src="data:image/svg\+xml;base64,([^"]+)"', page)
    assert len(drawn) == 6  # places, window, place, speed, lines, course
    assert all(b64decode(one).startswith(b"<?xml") for one in drawn)


def test_the_page_says_what_the_diagnosis_says(page: str, found: MotionOutcome) -> None:
    text, diagnosis = words_of(page), found.diagnosis
    (finding,) = diagnosis.findings
    assert (finding.mechanism, diagnosis.verdict) == ("stribeck_friction", "unexplained")
    before, after = (f"{100 * value:.3g} %" for value in (diagnosis.fit.before, diagnosis.fit.after))
    assert f"The model lacks stribeck friction. With it, the rms residual on held-out data falls from {before}" in text
    assert f"to {after} of the measured torque or force." in text
    assert f"confidence {100 * finding.confidence:.0f} %" in text
    assert finding.explanation in text
    assert all(name in text for name in finding.parameters)
    assert all(name.replace("_", " ") in text for name, _ in finding.alternatives)
    assert all(remark in text for remark in diagnosis.remarks)
    assert "torquerig diagnose a" in text
    assert "m.yaml" in text
    assert "fit and held out, alternating" in text


def test_every_rival_stands_with_its_scores(page: str, found: MotionOutcome) -> None:
    text, (step,) = words_of(page), found.steps
    assert len(step.tried) >= 5
    for one in step.tried:
        variant = f" ({one.candidate.variant.replace('_', ' ')})" if one.candidate.variant else ""
        assert re.search(re.escape(one.candidate.mechanism.replace("_", " ") + variant) + r" +-?[\d.]+ ", text)
    assert "accepted" in text
    assert "model without it" in text


def test_places_are_told_before_and_after(page: str, found: MotionOutcome) -> None:
    text = words_of(page)
    assert any(one.domain == "speed" for one in found.missed)
    assert not any(one.domain == "speed" for one in found.left)
    assert re.search(r"in the mean force at -?[\d.]+ m/s depends on the speed", text)
    assert re.search(r"at 1(49|50)[\d.]* cycles/m of the motion periodic in the position", text)
    assert "Differences that remain with the findings in the model" in text


def test_what_was_set_aside_stands_with_its_reason(page: str, found: MotionOutcome) -> None:
    aside = found.diagnosis.set_aside
    assert set(aside) == set(CLASSES) - {"stribeck_friction"}
    assert all(why in words_of(page) for why in aside.values())


def test_the_next_experiment_is_told_where_there_is_one(found: MotionOutcome) -> None:
    (finding,) = found.diagnosis.findings
    asked = replace(finding, next_experiment="Turn it slowly.", equivalent_to=("quadratic_drag",))
    text = words_of(paged(replace(found, diagnosis=replace(found.diagnosis, findings=(asked,)))))
    assert "Next run: Turn it slowly." in text
    assert "do not distinguish it from quadratic drag" in text
    assert re.search(r"quadratic drag [^a-z]+ not distinguished by these recordings", text)


def test_the_same_outcome_gives_the_same_page(page: str, found: MotionOutcome) -> None:
    assert paged(found) == page


def test_the_numbers_of_a_line_have_its_units(found: MotionOutcome) -> None:
    (row,) = fitted_parameters_table(found.nominal, found.before, found.after, unit_names=IN_A_LINE.called).rows
    assert [row[0].text, row[1].text, row[-1].text] == ["carriage.mass", "11.5", "kg"]
    assert float(row[4].text) == pytest.approx(10.0, rel=0.01)
    added = added_parameters_table(found.before, found.after, unit_names=IN_A_LINE.called)
    assert added is not None
    rows = {each[0].text: each for each in added.rows}
    assert float(rows["stribeck friction.coulomb"][1].text) == pytest.approx(6.0, rel=0.1)
    assert rows["stribeck friction.coulomb"][-1].text == "N"


def test_the_window_shows_measured_effort_and_both_models(found: MotionOutcome) -> None:
    (run,) = motion_compared(found)
    above, below = motion_window_figure(run, scale=IN_A_LINE).axes
    window = telling_window(run)
    time, effort = curve(above, "recording")
    assert effort == pytest.approx(run.run.effort[window])
    assert time[0] == pytest.approx(window.start / RATE)
    assert curve(above, "calibrated model")[1] == pytest.approx(run.before[window])
    assert curve(above, "with findings")[1] == pytest.approx(run.after[window])
    left = [line.get_ydata() for line in below.get_lines() if len(line.get_ydata()) == effort.size]
    assert left[0] == pytest.approx(effort - run.before[window])
    assert left[1] == pytest.approx(effort - run.after[window])
    assert above.get_ylabel() == "force [N]"


def test_only_held_out_samples_stand_over_place_and_time(found: MotionOutcome) -> None:
    (run,) = motion_compared(found)
    above, below = motion_position_figure(run, scale=IN_A_LINE).axes
    place, effort = curve(above, "recording")
    assert place == pytest.approx(run.run.position[run.run.held])
    assert effort == pytest.approx(run.run.effort[run.run.held])
    (course,) = motion_residual_figure([run], scale=IN_A_LINE).axes
    time, left = curve(course, "residual, with findings")
    held = run.run.held[np.rint(time * RATE).astype(int)]
    assert held.all()
    assert np.abs(left).max() == pytest.approx(np.abs((run.run.effort - run.after)[run.run.held]).max())
    assert below.get_xlabel() == "position [m]"


def test_the_speed_picture_shows_what_friction_adds(found: MotionOutcome) -> None:
    (run,) = motion_compared(found)
    left, right = motion_speed_figure(run, level_over_speed([run]), scale=IN_A_LINE).axes
    speed, added = curve(left, "effect of the findings")
    fast = np.abs(speed) > 0.1
    assert np.abs(added - (6.0 * np.sign(speed) + 8.0 * speed))[fast].max() < 1.5
    assert np.abs(curve(right, "with findings")[1]).max() < 0.2 * np.abs(curve(right, "calibrated model")[1]).max()


def test_lines_are_marked_at_their_place_and_in_turns_where_it_turns(turned: MotionOutcome) -> None:
    assert [one.mechanism for one in turned.diagnosis.findings] == ["cogging"]
    figure = motion_lines_figure(lines_compared(turned), scale=TURNING)
    axes = figure.axes[0]
    at, size = curve(axes, "calibrated model")
    strongest = at[int(np.argmax(size))]
    assert strongest == pytest.approx(84, abs=0.5)
    assert size.max() == pytest.approx(0.02, rel=0.1)
    assert axes.get_xlabel() == "cycles over position [cycles/turn]"
    assert next(float(text.get_text()) for text in axes.texts) == pytest.approx(84, abs=0.5)
    text = words_of(paged(turned))
    assert "at its native order 84" in text
    assert "No figure over speed" in text


def test_nothing_missing_is_said_in_words_without_a_picture_of_places(fine: MotionOutcome) -> None:
    assert fine.diagnosis.verdict == "adequate"
    page = paged(fine)
    text = words_of(page)
    assert (
        "No physics is missing that these recordings can show. With the scenario's parameters fitted, the rms residual"
        in text
    )
    assert "No difference is significant, so there is no figure of it." in text
    assert "No figure over speed: no finding and no residual depends on the speed." in text
    assert "with findings" not in "".join(re.findall(r"<th[^>]*>[^<]*\[N\]</th>", page))
    assert page.count("<img ") == 4


def test_places_without_a_share_are_told_and_not_drawn(found: MotionOutcome) -> None:
    bare = tuple(replace(one, share_of_misfit=0.0) for one in found.missed)
    page = paged(replace(found, missed=bare))
    assert page.count("<img ") == 5
    assert "No figure: no place has a visible share of the squared residual." in page


def test_too_short_a_way_for_lines_is_said(found: MotionOutcome) -> None:
    (run,) = found.runs
    still = replace(run, held=run.held & (np.arange(run.held.size) < 640))
    text = words_of(paged(replace(found, runs=(still,))))
    assert "No spectrum of the residual." in text


def test_no_picture_is_squeezed_by_a_run_that_stands_still_where_it_was_held_out(found: MotionOutcome) -> None:
    (run,) = motion_compared(found)
    rest = np.flatnonzero(run.run.held)[:30]
    held = np.zeros_like(run.run.held)
    held[rest] = True
    position, speed = run.run.position.copy(), run.run.speed.copy()
    position[rest], speed[rest] = 0.1, 0.0
    still = replace(run, run=replace(run.run, held=held, position=position, speed=speed))
    figures: tuple[Figure, ...] = (
        motion_position_figure(still, scale=IN_A_LINE),
        motion_window_figure(still, scale=IN_A_LINE),
        motion_speed_figure(still, level_over_speed([still]), scale=IN_A_LINE),
        motion_residual_figure([still], scale=IN_A_LINE),
    )
    assert all(svg(figure) for figure in figures)


def test_the_command_writes_the_page_and_nothing_else_on_standard_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, found: MotionOutcome, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    write_recording(carriage(rough=True), tmp_path / "rough.csv")
    (tmp_path / "rig.yaml").write_text(CARRIAGE, encoding="utf-8")
    monkeypatch.setattr("torquerig.diagnosis.motion.diagnose_motion.diagnose_motion", lambda *_, **__: found)
    main(["diagnose", "rough.csv", "--scenario", "rig.yaml", "--json", "out.json", "--report", "out.html"])
    assert capfd.readouterr().err == ""
    page = (tmp_path / "out.html").read_text(encoding="utf-8")
    assert "torquerig diagnose rough.csv --scenario rig.yaml --json diagnosis.json --report diagnosis.html" in page
    assert "out.model.yaml" in page
    assert str(tmp_path) not in page


@pytest.mark.parametrize("friction", [0.0, 12.0])
def test_what_the_samples_show_stands_on_the_page_without_rivals(friction: float) -> None:
    made = recorded(lambda time, position, speed: friction * np.tanh(speed / 1e-3))
    limit = 18.0 if friction == 0 else 25.0
    outcome = diagnosed(made.with_values("force_N", np.clip(made.channels["force_N"].values, -limit, limit)))
    text = unescape(paged(outcome))
    assert f"clipping of the reading at {limit:g} N, below what the motion requires" in text
    assert ("Alternative hypotheses" in text) == (friction > 0)
    assert "excluded from fits and held-out data" in text
