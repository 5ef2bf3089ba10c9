"""The numbers of a figure as CSV: what is drawn, under the names of the legend."""

import csv
from io import StringIO

import numpy as np
import pytest

from torquerig.reporting.figures.figure_data import HEAD, figure_csv
from torquerig.reporting.figures.picture import new_figure, picture


def rows(figure):
    return list(csv.DictReader(StringIO(figure_csv(figure))))


def test_every_point_of_a_curve_is_there_with_panel_curve_and_axes():
    figure = new_figure(4, 3)
    above, below = figure.subplots(2, 1)
    above.plot([0, 1, 2], [3, np.nan, 5], color="#c8553d", label="calibrated model")
    above.plot([3, 4], [6, 7], color="#c8553d", label="_")  # a second stretch of the same curve
    above.set_title("run1.parquet", loc="left")
    below.set_xlabel("time [s]")
    above.set_ylabel("torque\n[N m]")
    below.plot([0, 1], [1, 2], color="#c8553d")
    found = rows(figure)
    assert [(row["x"], row["y"]) for row in found] == [
        ("0", "3"), ("1", "?"), ("2", "5"), ("3", "6"), ("4", "7"), ("0", "1"), ("1", "2"),
    ]  # fmt: skip
    assert {row["curve"] for row in found} == {"calibrated model"}
    assert [row["panel"] for row in found] == ["run1.parquet"] * 5 + ["panel 2"] * 2
    assert (found[0]["x axis"], found[0]["y axis"]) == ("time [s]", "torque [N m]")


def test_limits_and_shaded_areas_are_no_data():
    figure = new_figure(4, 3)
    axes = figure.subplots()
    axes.axhline(0)
    axes.axvline(5)
    axes.axhspan(-1, 1)
    assert figure_csv(figure) == ""
    axes.scatter([1, 2], [3, 4], label="dots")
    assert [(row["curve"], row["x"], row["y"]) for row in rows(figure)] == [("dots", "1", "3"), ("dots", "2", "4")]


@pytest.mark.parametrize("lies", [True, False])
def test_a_bar_has_its_label_and_length(lies):
    figure = new_figure(4, 3)
    axes = figure.subplots()
    if lies:
        axes.barh([0, 1, 2], [5, 7, 0])
        axes.set_yticks([0, 1, 2], ["=order 84", "50 Hz", "none"])
    else:
        axes.bar([0, 1, 2], [5, 7, 0])
        axes.set_xticks([0, 1, 2], ["=order 84", "50 Hz", "none"])
    name, size = ("y", "x") if lies else ("x", "y")
    found = rows(figure)
    assert [row[size] for row in found] == ["5", "7"]
    assert found[1][name] == "50 Hz"
    assert not found[0][name].startswith("=")  # no formula where a spreadsheet opens it


def test_a_picture_without_a_table_gives_what_it_draws():
    figure = new_figure(4, 3)
    figure.subplots().plot([0, 1], [2, 3], label="a")
    made = picture(figure, caption="c", alt_text="a")
    assert ",".join(HEAD) in made.csv
    assert 'class="csv"' in made.csv
