"""Progress without a terminal: a line at each ten, at the end and after ten seconds, with the remaining time."""

from __future__ import annotations

from torquerig.cli.progress import PlainLines


def test_lines_come_at_tens_and_at_the_end_with_the_remaining_time() -> None:
    lines = PlainLines("study")
    said = [lines.line(done, 25, "drive", now=0.5 * done) for done in range(1, 26)]
    assert [place for place, line in enumerate(said, start=1) if line] == [10, 20, 25]
    assert said[9] == "study: 10/25, some 8 s remain, drive"
    assert said[24] == "study: 25/25 drive"


def test_a_slow_work_shows_that_it_goes_on() -> None:
    lines = PlainLines("study")
    said = [lines.line(done, 9, "", now=100.0 * done) for done in range(1, 5)]
    assert said == ["", "study: 2/9, some 12 min remain,", "study: 3/9, some 10 min remain,",
                    "study: 4/9, some 8 min remain,"]  # fmt: skip


def test_what_was_done_before_does_not_count_as_fast() -> None:
    lines = PlainLines("study")
    lines.line(1000, 1100, "", now=0.0)
    assert lines.line(1010, 1100, "", now=10.0) == "study: 1010/1100, some 90 s remain,"


def test_foreign_names_cannot_act_on_the_terminal() -> None:
    assert "\x1b" not in PlainLines("x").line(1, 1, "\x1b[2J", now=0.0)
