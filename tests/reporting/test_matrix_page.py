"""The page, the Markdown and the pictures of a matrix."""

import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

from torquerig.decide.cell import Cell, Override
from torquerig.decide.kesselring import VDI_2225, kesselring_from_points
from torquerig.decide.matrix_analysis import analyse_matrix
from torquerig.decide.matrix_io.matrix_file import read_matrix
from torquerig.decide.strength import Rating, Strength
from torquerig.reporting.figures.strength_figure import strength_figure
from torquerig.reporting.figures.value_profile import WEAK, value_profile
from torquerig.reporting.matrix.files import write_matrix
from torquerig.reporting.matrix.markdown import matrix_markdown
from torquerig.reporting.matrix.page import matrix_page

EXAMPLE = read_matrix(Path(__file__).resolve().parents[2] / "scenarios" / "matrix_example.yaml")
HAND = {("servo A", "speed reserve"): Cell(value=2.1, by_hand=Override(points=4.0, reason="<hot> & | dusty"))}
CASE = replace(EXAMPLE, draws=300, matrix=replace(EXAMPLE.matrix, cells={**EXAMPLE.matrix.cells, **HAND}))


@pytest.fixture(scope="module")
def worked():
    return analyse_matrix(CASE)


@pytest.fixture(scope="module")
def page(worked):
    return matrix_page(worked)


class Links(HTMLParser):
    def __init__(self):
        super().__init__()
        self.targets, self.ids, self.sources, self.open = [], [], [], []

    def handle_starttag(self, tag, attrs):
        held = dict(attrs)
        self.targets += [held["href"]] if "href" in held else []
        self.ids += [held["id"]] if "id" in held else []
        self.sources += [held["src"]] if "src" in held else []
        if tag not in ("meta", "img"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def test_the_page_needs_nothing_beside_it_and_every_link_has_its_place(page, worked):
    links = Links()
    links.feed(page)
    assert links.open == []
    assert {one.removeprefix("#") for one in links.targets} <= set(links.ids)
    assert len(links.ids) == len(set(links.ids))
    assert len([one for one in links.ids if one.startswith("cell-")]) == 3 * 6
    assert all(one.startswith("data:image/svg+xml") for one in links.sources)
    assert len(links.sources) == 2
    assert not re.search(r"<script src|https?://(?!www.w3.org)", page)


def test_the_page_says_verdict_override_and_what_to_ask(page, worked):
    assert worked.verdict.certainty in page
    assert "set by hand: &lt;hot&gt; &amp; | dusty" in page
    assert "ask the maker for the gearbox efficiency at peak torque of servo A" in page
    assert "takes" not in page[: page.index("<h2")]


def test_the_same_case_gives_the_same_page_and_markdown(page, worked):
    assert matrix_page(analyse_matrix(CASE)) == page
    assert matrix_markdown(analyse_matrix(CASE)) == matrix_markdown(worked)


def test_every_row_of_a_markdown_table_has_as_many_cells_as_its_head(worked):
    text = matrix_markdown(worked)
    width = None
    for line in text.splitlines():
        cells = len(re.findall(r"(?<!\\)\|", line)) if line.startswith("|") else None
        assert cells is None or width in (None, cells)
        width = cells
    assert r"\<hot\> & \| dusty" in text


@pytest.mark.parametrize("ending", [".html", ".md", ".xlsx", ".yaml"])
def test_a_file_is_replaced_whole(worked, tmp_path, ending):
    path = tmp_path / f"drives{ending}"
    path.write_text("old", encoding="utf-8")
    write_matrix(worked, path)
    assert path.stat().st_size > 1000
    assert [one.name for one in tmp_path.iterdir()] == [path.name]


def test_the_s_diagram_shows_each_alternative_where_its_ratings_are():
    def rating(*values):
        ends = np.array(values)
        return Rating(value=ends, low=ends - 0.1, high=ends + 0.1)

    found = Strength(alternatives=("a", "b"), technical=rating(0.4, 0.8), economic=rating(0.7, 0.6))
    axes = strength_figure(found, winners=("b",)).axes[0]
    dots = {tuple(np.ravel(line.get_xydata()).round(3)) for line in axes.lines if len(line.get_xydata()) == 1}
    assert {(0.4, 0.7), (0.8, 0.6), (1.0, 1.0)} <= dots
    curves = [line.get_xydata() for line in axes.lines if len(line.get_xydata()) == 200]
    for curve in curves:
        assert np.sqrt(curve[:, 0] * curve[:, 1]) == pytest.approx(np.sqrt(curve[0].prod()))  # one strength each
    assert len(curves) == 4


def test_the_value_profile_is_as_large_as_the_share_and_weak_spots_are_orange():
    result = kesselring_from_points(
        {"a": [4.0, 4.0, 1.0], "b": [2.0, None, 3.0]}, weights={"x": 0.5, "y": 0.3, "z": 0.2}, profile=VDI_2225
    )
    figure = value_profile(result)
    for axes, row in zip(figure.axes, (0, 1), strict=True):
        area = sum(bar.get_width() * bar.get_height() for bar in axes.patches) / 0.9  # bars leave a tenth between them
        assert area / 4 == pytest.approx(result.share[row])
    colours = [bar.get_facecolor()[:3] for bar in figure.axes[0].patches]
    assert [tuple(round(255 * part) for part in one) for one in colours].count(
        tuple(int(WEAK[at : at + 2], 16) for at in (1, 3, 5))
    ) == 1
