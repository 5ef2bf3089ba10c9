"""The reference report's tables beside the rig: what is published, what is fitted, and the closed forms behind it."""

import re
from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.document import read_document
from torquerig.filters.chains.filter_chain import report_filter_code_chain
from torquerig.filters.filter_effect import chain_effect
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.study.reference_report.conditions import ReportRig
from torquerig.study.reference_report.filter_steps import report_filter_steps
from torquerig.study.reference_report.fitting import fitted, place_of
from torquerig.study.reference_report.half_power import half_power_frequency
from torquerig.study.reference_report.published import CELLS, MECHANICAL_DROP, OCCUPANCIES, Cell
from torquerig.study.reference_report.superposition import Superposed, superposed

ROOT = Path(__file__).resolve().parents[2]
REPORT = ROOT.parent / "shared" / "seed"


@pytest.fixture(scope="module")
def rig():
    document = read_document(ROOT / "scenarios" / "wear_rig.yaml")
    return ReportRig(document, load_catalog(ROOT / "catalogs"), 1)


def made(lines, load, *, left=0.0, taken=0.0):
    """A reading whose filter leaves a share of the lines' variance and takes a share of the load's."""
    return Superposed(1.0, (lines**2, 0.0, load**2), (left * lines**2, 0.0, (1 - taken) * load**2))


def test_half_of_the_cells_are_fitted_and_the_others_are_not():
    assert [sum(cell.fitted for cell in CELLS if cell.table == table) for table in ("VIII", "IX")] == [2, 3]
    assert len(CELLS) == 9  # with the drop of mechanical noise, held out, ten figures: five and five


@pytest.mark.skipif(not REPORT.is_dir(), reason="the reference report is not beside this checkout")
def test_the_cells_are_those_that_the_report_prints():
    text = "\n".join(path.read_text(encoding="utf-8") for path in REPORT.glob("*.txt"))
    for cell in CELLS:
        row = f"{cell.occupancy:g}%" if cell.table == "VIII" else f"{1e3 * cell.size:g}"
        assert re.search(rf"^{re.escape(row)}\t{cell.cut:g}%\t0%\t", text, re.M), cell
    assert f"went down with {MECHANICAL_DROP:g}% by increasing the load intensity" in text


def test_the_cut_is_that_of_independent_parts():
    parts = made(0.3, 0.4)
    assert parts.cut(1.0) == pytest.approx(100 * (1 - 0.4 / 0.5))
    assert parts.cut(0.0) == pytest.approx(100.0)
    assert made(0.3, 0.4, left=0.25).cut(0.0) == pytest.approx(50.0)


def test_what_is_needed_gives_the_cut_back():
    parts = made(0.1, 0.2, taken=0.05)
    scale = parts.needed(40.0)
    assert parts.cut(scale) == pytest.approx(40.0, abs=1e-9)
    assert made(0.1, 0.2, left=0.25).needed(68.0) is None  # half of the lines stay whatever the load does


def test_the_fit_gives_back_scale_power_and_occupancy_that_made_the_cells():
    sizes = sorted({cell.size for cell in CELLS if cell.size is not None})
    places = {
        (occupancy, size): made(0.1, 0.1 + 0.02 * occupancy, taken=0.05) for occupancy in OCCUPANCIES for size in sizes
    }
    known = [
        Cell(cell.table, cell.occupancy, cell.size, float(places[at].cut(0.6 * (at[1] / 0.5e-3) ** 0.8)), cell.fitted)
        for cell in CELLS
        for at in (place_of(cell, occupancy=15.0, size=0.5e-3),)
    ]
    fit = fitted(known, places, size=0.5e-3)
    assert fit.occupancy == 15.0
    assert fit.scale == pytest.approx(0.6, rel=1e-3)
    assert fit.exponent == pytest.approx(0.8, abs=2e-3)
    assert fit.residual < 0.01
    assert fit.scale_at(1e-3) == pytest.approx(0.6 * 2**0.8, rel=3e-3)


def test_the_held_out_cells_do_not_move_the_fit():
    places = {
        (occupancy, size): made(0.1, 0.1 + 0.02 * occupancy)
        for occupancy in OCCUPANCIES
        for size in {0.5e-3, *(cell.size for cell in CELLS if cell.size)}
    }
    other = [cell if cell.fitted else Cell(cell.table, cell.occupancy, cell.size, 1.0, False) for cell in CELLS]
    assert fitted(CELLS, places, size=0.5e-3) == fitted(other, places, size=0.5e-3)


def test_what_is_superposed_is_what_is_simulated(rig):
    chain = report_filter_code_chain(rig.kinematics)
    parts = superposed(rig, chain, 11.0, size=0.5e-3)
    reading = rig.reading(11.0, 0.5e-3, scale=0.3)
    effect = chain_effect(reading, chain.apply(reading), ratio=rig.kinematics.ratio)
    # losses of the gear and dry friction bend it by less than half a point
    assert parts.cut(0.3) == pytest.approx(effect.std_reduction_percent, abs=0.5)


def test_the_last_step_is_the_whole_filter():
    drive = Kinematics(pole_pairs=7, slots=12, ratio=5.0)
    steps = report_filter_steps(drive)
    assert [len(chain.lines) for chain in steps] == [8, 16, 20]
    assert set(steps[-1].lines) == set(report_filter_code_chain(drive).lines)


def test_half_of_the_power_lies_below_the_stronger_line():
    time = np.arange(20000) / 2000.0
    torque = 2 + 0.5 * np.sin(2 * pi * 3 * time) + 0.4 * np.sin(2 * pi * 90 * time)
    channel = Channel(values=torque, quantity="torque", unit="V")
    assert half_power_frequency(Recording(sample_rate=2000.0, channels={"t": channel})) == pytest.approx(3.0)
