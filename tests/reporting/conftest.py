"""A study whose results are made by hand: three drives on a two-second recording of known sines, nothing simulated."""

from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.document import read_document
from torquerig.filters.filter_effect import chain_effect
from torquerig.metrics.figure import Figure
from torquerig.metrics.shares import Shares
from torquerig.metrics.truth_error import TRUE_LOAD, truth_error
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.reporting.study.report import write_study_report
from torquerig.scenario.kinematics import kinematics_of
from torquerig.study.candidate import Candidate
from torquerig.study.candidates import scenario_of
from torquerig.study.definition import open_study
from torquerig.study.results import ChainResult, DriveResult, StudyRuns
from torquerig.study.scoring import decide
from torquerig.study.verdict import verdict

ROOT = Path(__file__).resolve().parents[2]
OUTPUT_SPEED = 200 * pi / 30
RATE = 5000.0


@pytest.fixture(scope="session")
def study():
    opened = open_study(read_document(ROOT / "scenarios" / "wear_rig.yaml"), load_catalog(ROOT / "catalogs"))
    return replace(opened, settings=opened.settings.model_copy(update={"draws": 1}))


@pytest.fixture(scope="session")
def runs(study):
    drives = (
        _driven(study, Candidate(motor="bldc-12n14p", gearbox="reference-5-1", ratio=5.0), ripple=0.2),
        _driven(study, Candidate(motor="HDS6A-0104A", gearbox="reference-5-1", ratio=5.0), ripple=0.05),
        _out_of_reach(Candidate(motor="GP-71M", gearbox="economy-20-1", ratio=20.0)),
    )
    return StudyRuns(
        study=study, drives=drives, mean_load=1.0, occupancy_percent=5.0, particle_size=5e-4, output_speed=OUTPUT_SPEED
    )


@pytest.fixture(scope="session")
def decided(runs):
    return decide(runs)


@pytest.fixture(scope="session")
def answer(decided):
    return verdict(decided)


def _recording(ratio, ripple):
    time = np.arange(int(2 * RATE)) / RATE
    speed = OUTPUT_SPEED * ratio
    load = 1 + 0.1 * np.sin(2 * pi * 1.5 * time)
    lines = ripple * (np.sin(7 * speed * time) + 0.5 * np.sin(speed * time))
    channels = {
        "torque_V": Channel(values=load + lines, quantity="torque", unit="V"),
        TRUE_LOAD: Channel(values=load, quantity="torque", unit="N*m", truth=True),
    }
    return Recording(sample_rate=RATE, channels=channels, run=Run(speed=speed, gear_ratio=ratio), name="by hand")


def _margins(candidate):
    """All that the shipped study asks for; the price of a new motor is an interval, one fact is unknown."""
    new = candidate.motor != "bldc-12n14p"
    return {
        "speed_reserve": Figure(low=0.75, high=1.5) if candidate.ratio > 5 else Figure(value=3.0),
        "speed_use": Figure(value=0.3),
        "continuous_output_torque": Figure(value=6.0, unit="N*m"),
        "torque_reserve": Figure(low=3.0, high=6.0, missing="rated torque"),
        "sensor_peak": Figure(value=9.7, unit="N*m"),
        "servo": Figure(value=1.0) if new else Figure(missing="whether it is a servo motor"),
        "new_parts": Figure(value=3.0 * new),
        "price": Figure(low=340.0, high=1300.0, unit="EUR", missing="price") if new else Figure(value=0.0, unit="EUR"),
    }


def _driven(study, candidate, *, ripple):
    scenario = scenario_of(candidate, study, seed=1)
    reading = _recording(candidate.ratio, ripple)
    chains = {}
    for name, chain in study.chains(scenario).items():
        after = chain.apply(reading)
        error = truth_error(after, reading)
        chains[name] = ChainResult(
            chain=name,
            effect=chain_effect(reading, after, ratio=kinematics_of(scenario.rig).ratio, lines=chain.lines),
            truth_error=Figure(value=error, low=0.9 * error, high=1.1 * error, unit="N*m", source="by hand"),
            left_out=chain.left_out,
        )
    return DriveResult(
        candidate=candidate,
        margins=_margins(candidate),
        out_of_reach="",
        motor_speed=OUTPUT_SPEED * candidate.ratio,
        torque_limit=2.0,
        kp=0.05,
        assumed=scenario.assumed,
        taken=scenario.taken,
        shares=Shares(mean=1.0, load=0.3, cogging=0.4, electrical=0.0, mechanical=0.0),
        disturbance=Figure(value=ripple, low=ripple, high=2 * ripple, unit="N*m", source="by hand"),
        chains=chains,
        duration=reading.duration,
        simulated=lambda: reading,
    )


def _out_of_reach(candidate):
    reason = "needs 4000 rpm, reaches at most 3000 rpm"
    return DriveResult(
        candidate=candidate,
        margins=_margins(candidate),
        out_of_reach=reason,
        motor_speed=OUTPUT_SPEED * candidate.ratio,
        torque_limit=2.0,
        kp=0.05,
        assumed={},
        shares=None,
        disturbance=Figure(unit="N*m", missing=reason),
        chains={},
    )


class Opened:
    """A page in its own context: what it logged as an error, and what it requested from outside."""

    def __init__(self, chromium, file, *, width=1280, height=900, dark=False):
        self.context = chromium.new_context(
            viewport={"width": width, "height": height}, color_scheme="dark" if dark else "light", accept_downloads=True
        )
        self.page, self.errors, self.requests = self.context.new_page(), [], []
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("console", lambda line: self.errors.append(line.text) if line.type == "error" else None)
        self.page.on("request", self._requested)
        self.page.goto(file.as_uri())
        self.page.wait_for_function("document.documentElement.dataset.ready === 'yes'")

    def _requested(self, request):
        if not request.url.startswith(("data:", "blob:")):
            self.requests.append(request.url)

    def js(self, expression, argument=None):
        return self.page.evaluate(expression, argument)

    def unfold(self, which="details"):
        self.js("(which) => document.querySelectorAll(which).forEach((one) => { one.open = true; })", which)
        if self.js("typeof plotsOnPage !== 'undefined'"):
            # a plot is drawn when it comes near the view; here all of them are
            every = "[...document.querySelectorAll('[data-plot]')].map((one) => openPlot(one.id))"
            self.js(f"Promise.all({every}).then(() => null)")


@pytest.fixture
def open_page(chromium):
    opened = []

    def opening(file, **how):
        opened.append(Opened(chromium, file, **how))
        return opened[-1]

    yield opening
    for one in opened:
        one.context.close()


@pytest.fixture(scope="session")
def study_file(runs, decided, answer, tmp_path_factory):
    """The page of a study alone in a folder, as it is mailed."""
    folder = tmp_path_factory.mktemp("mailed")
    written = write_study_report(runs, decided, answer, folder / "report")[0]
    return written.replace(folder / "study.html")
