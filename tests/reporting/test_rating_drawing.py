"""The S-diagram: well-formed, each dot at its ratings, names as text and never as elements."""

from __future__ import annotations

from types import SimpleNamespace
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from torquerig.reporting.figures.rating_drawing import BOTTOM, LEFT, RIGHT, TOP, rating_drawing

SVG = "{http://www.w3.org/2000/svg}"
NAMES = ("a <b> & c", "second", "third\x1b[2J")


def result(shares):
    values = np.array(shares)
    return SimpleNamespace(
        alternatives=NAMES, share=values, total_low=5 * (values - 0.05), total_high=5 * (values + 0.05), ideal=5.0
    )


def drawn(technical, economic):
    return ET.fromstring(rating_drawing(result(technical), result(economic), named=NAMES[:2]))


def test_dots_are_at_their_ratings_and_a_better_one_is_further_up_and_right():
    root = drawn([0.4, 0.6, 0.8], [0.5, 0.7, 0.9])
    dots = [(float(one.get("cx")), float(one.get("cy"))) for one in root.iter(f"{SVG}circle")]
    assert len(dots) == 5  # each, and the two that are named
    x, y = zip(*dots[:3], strict=True)
    assert x[1] - x[0] == pytest.approx(x[2] - x[1], abs=0.02)
    assert y[0] - y[1] == pytest.approx(y[1] - y[2], abs=0.02)
    assert x[0] < x[1] < x[2]
    assert y[0] > y[1] > y[2]
    assert all(LEFT <= one <= RIGHT for one in x)
    assert all(TOP <= one <= BOTTOM for one in y)
    assert (x[1] - x[0]) / (RIGHT - LEFT) == pytest.approx(0.2 / (1.02 - 0.32), rel=1e-3)
    assert dots[3:] == dots[:2]


def test_names_are_text_and_close_dots_share_a_label():
    root = drawn([0.60, 0.605, 0.8], [0.5, 0.5, 0.9])
    texts = [one.text for one in root.iter(f"{SVG}text")]
    assert "1  a <b> & c" in texts
    assert "1, 2" in texts
    assert "technical rating x = T/T_max without the price" in texts


def test_the_same_ratings_give_the_same_bytes():
    first, second = (rating_drawing(result([0.4, 0.6, 0.8]), result([0.5] * 3), named=NAMES) for _ in range(2))
    assert first == second
    assert b"\x1b" not in first
