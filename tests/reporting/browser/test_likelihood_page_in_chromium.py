"""The page of a diagnosis in a real browser: alone, without an error, on a phone, in short sentences."""

import re

import pytest

from tests.inference.pump_bench import pump_scenario, recorded
from torquerig import mechanisms
from torquerig.inference.answer import as_json
from torquerig.inference.engine import diagnose
from torquerig.reporting.diagnosis.likelihood.page import likelihood_page

LONGEST = 25  # words of a sentence on the first screen

pytestmark = pytest.mark.long


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pump")
    scenario = pump_scenario(folder)
    hum = mechanisms.MainsInterference(name="hum", frequency=50.0, amplitudes=(0.02,))
    outcome = diagnose(scenario, recorded(scenario, hum))
    page = folder / "page.html"
    made = likelihood_page(outcome, as_json(outcome), title="pump", command="torquerig diagnose", model=None, seed=0)
    page.write_text(made, encoding="utf-8")
    return page


def test_it_opens_alone_without_a_request_or_an_error(open_page, file):
    shown = open_page(file)
    shown.unfold()
    assert shown.requests == [file.as_uri()]
    assert shown.errors == []


def test_a_phone_scrolls_in_one_direction_only(open_page, file):
    shown = open_page(file, width=390, height=844)
    shown.unfold()
    assert shown.js("document.documentElement.scrollWidth") <= 390


def test_the_first_screen_says_it_in_short_sentences(open_page, file):
    shown = open_page(file)
    top = shown.js("[...document.querySelectorAll('.answer p, .figures dd')].map((one) => one.innerText)")
    sentences = [one for text in top for one in re.split(r"(?<=[.?!])\s", text)]
    assert any(one.startswith("The model lacks mains interference") for one in sentences)
    assert max(len(one.split()) for one in sentences) <= LONGEST
    assert shown.js("document.querySelector('figure').getBoundingClientRect().top") < 600


def test_the_numbers_of_the_picture_can_be_saved(open_page, file):
    shown = open_page(file)
    text = shown.js("JSON.parse(document.querySelector('script.csv').textContent)")
    head, *rows = text.strip().split("\n")
    assert head == "kind,at,at_unit,recording,nominal,completed,unit"
    lines = [row.split(",") for row in rows if row.startswith("line amplitude,")]
    (hum,) = [row for row in lines if abs(float(row[1]) - 50) < 0.2]  # [Hz] half a bin of a run of 6 s
    assert float(hum[4]) == 0
    assert float(hum[3]) == pytest.approx(float(hum[5]), rel=0.2)  # of one run; the model is fitted to both
