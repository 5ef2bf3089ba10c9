"""The pages in a real browser: alone in a folder, without the net, on a phone, printed, read aloud, and moved."""

import re
from pathlib import Path

import numpy as np
import pytest

from torquerig.decide.matrix_analysis import analyse_matrix
from torquerig.decide.matrix_io.matrix_file import read_matrix
from torquerig.reporting.matrix.page import matrix_page

EXAMPLE = Path(__file__).resolve().parents[3] / "scenarios" / "matrix_example.yaml"
LONGEST = 25  # words of a sentence on the first screen
PAGES = ("study", "matrix")


@pytest.fixture(scope="module")
def matrix_file(tmp_path_factory):
    file = tmp_path_factory.mktemp("mailed") / "matrix.html"
    file.write_text(matrix_page(analyse_matrix(read_matrix(EXAMPLE))), encoding="utf-8")
    return file


@pytest.fixture
def file(request, study_file, matrix_file):
    return {"study": study_file, "matrix": matrix_file}[request.param]


everywhere = pytest.mark.parametrize("file", PAGES, indirect=True)


@everywhere
def test_a_page_opens_alone_without_a_request_or_an_error(open_page, file):
    shown = open_page(file)
    shown.unfold()
    assert shown.requests == [file.as_uri()]
    assert shown.errors == []
    assert file.stat().st_size < 10e6


@pytest.mark.long
@everywhere
@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
def test_axe_finds_no_serious_fault(open_page, file, dark):
    from axe_playwright_python.sync_playwright import Axe

    shown = open_page(file, dark=dark)
    shown.unfold("section > details, section > details details:first-of-type")  # the others are alike
    contrast = {"runOnly": ["color-contrast"]}  # all that the colours of the dark page can change
    found = Axe().run(shown.page, options=contrast if dark else None).response["violations"]
    serious = {one["id"]: one["nodes"][0]["html"][:200] for one in found if one["impact"] in ("serious", "critical")}
    assert serious == {}


@everywhere
def test_a_phone_scrolls_in_one_direction_only(open_page, file):
    shown = open_page(file, width=390, height=844)
    shown.unfold()
    assert shown.js("document.documentElement.scrollWidth") <= 390


@everywhere
def test_the_first_screen_has_the_answer_three_figures_and_a_picture_in_short_sentences(open_page, file):
    shown = open_page(file)
    top = shown.js(
        """() => [...document.querySelectorAll('.answer p, .figures dd, figcaption')]
            .filter((one) => one.getBoundingClientRect().top < innerHeight).map((one) => one.innerText)"""
    )
    sentences = [one for text in top for one in re.split(r"(?<=[.?!])\s", text)]
    assert max(len(one.split()) for one in sentences) <= LONGEST
    assert shown.js("document.querySelectorAll('.figures > div').length") == 3
    assert shown.js("document.querySelector('figure').getBoundingClientRect().top") < 600


@everywhere
def test_every_link_of_the_page_leads_into_it_and_opens_what_is_folded(open_page, file):
    shown = open_page(file)
    targets = shown.js("[...document.querySelectorAll('a')].map((one) => one.getAttribute('href'))")
    assert all(one.startswith(("#", "data:")) for one in targets)
    for target in dict.fromkeys(one for one in targets if one.startswith("#")):
        shown.js("(target) => { location.hash = target; }", target)
        shown.page.wait_for_function("(target) => document.querySelector(target).checkVisibility()", arg=target)


@everywhere
def test_print_shows_what_is_folded_and_no_control(open_page, file):
    shown = open_page(file)
    shown.page.emulate_media(media="print")
    assert shown.js("getComputedStyle(document.querySelector('nav')).display") == "none"
    assert shown.js("getComputedStyle(document.querySelector('#try')).display") == "none"
    assert shown.js("document.querySelector('#elimination table, #matrices table').getBoundingClientRect().height") > 0
    assert shown.page.pdf().startswith(b"%PDF")


def test_every_picture_has_its_data_and_gives_png_and_svg(open_page, study_file):
    shown = open_page(study_file)
    shown.unfold()
    names = shown.js("[...document.querySelectorAll('figure:has(img)')].map((one) => one.id)")
    assert len(names) > 4
    for name in names:
        lines = shown.js(
            "(name) => csvOf(document.getElementById(name)).then((text) => text.split('\\n').length)", name
        )
        assert lines > 2
    for name in ("reading", "s_diagram"):
        for kind, start in (("png", b"\x89PNG"), ("svg", b"<?xml")):
            with shown.page.expect_download() as saved:
                shown.page.click(f"#{name} [data-save={kind}]")
            assert saved.value.suggested_filename == f"{name}.{kind}"
            assert Path(saved.value.path()).read_bytes().startswith(start)


def test_the_saved_samples_are_those_of_the_recording(open_page, study_file, runs):
    shown = open_page(study_file)
    with shown.page.expect_download() as saved:
        shown.page.click("#reading [data-save=csv]")
    table = np.genfromtxt(saved.value.path(), delimiter=",", names=True)
    first = table[table.dtype.names[1]]
    known = [one.recording.torque() for one in runs.drives if one.recording is not None]
    assert min(np.abs(first - one).max() / np.ptp(one) for one in known) < 1e-5  # half a step of 16 bit is 0.8e-5


def test_the_files_inside_the_page_can_be_saved(open_page, study_file, runs):
    shown = open_page(study_file)
    shown.unfold()
    for name, start in (("combinations.csv", b"rank,"), ("shares.csv", b"motor,"), ("matrices.xlsx", b"PK")):
        with shown.page.expect_download() as saved:
            shown.page.click(f"a[download='{name}']")
        assert Path(saved.value.path()).read_bytes().startswith(start)


PEAKS = """() => {
  let state = 1;
  const noise = () => { state = (48271 * state) % 2147483647; return state / 2147483647; };
  const values = new Float64Array(1000003).map((_, at) => Math.sin(at / 1000) + noise());
  for (let at = 17; at < values.length; at += 99991) { values[at] = 5 + at / 1e6; values[at + 1] = -5 - at / 1e6; }
  const pyramid = makePyramid({ values, start: 2, step: 0.5 });
  const ends = (part) => part.reduce(([low, high], one) => [Math.min(low, one), Math.max(high, one)], [9, -9]);
  const few = [[49990, 50030], [7, 9]], many = [[2, 500003], [100, 4e4], [1.1e5, 1.4e5], [2, 5e4], [499900, 600000]];
  return [...few, ...many].map(([from, to]) => {
    const view = pyramidView(pyramid, from, to, 1000);
    const first = Math.max(Math.floor((from - 2) / 0.5), 0);
    const last = Math.min(Math.ceil((to - 2) / 0.5), values.length - 1);
    return [view.y.length, ends(view.y), ends(Array.from(values.subarray(first, last + 1)))];
  });
}"""


def test_no_view_of_a_million_samples_loses_a_peak(open_page, study_file):
    for points, (least, most), (lowest, highest) in open_page(study_file).js(PEAKS):
        assert points <= 3100
        assert most >= highest  # a block at the edge may reach further
        assert least <= lowest


ZOOM = """async () => {
  const plot = await openPlot('plot-reading');
  plot.range.setv({ start: 0.5, end: 0.6 });
  await new Promise((done) => setTimeout(done, 200));
  const { x } = plot.document.get_model_by_name('before').data;
  const other = plot.document.get_model_by_name('error before').data.x;
  const at = Math.round(0.55 / plot.curves.before.step);
  const [error, before, load] = ['error before', 'before', 'load'].map((name) => plot.curves[name].values[at]);
  const ends = (one) => [one[0], one.at(-1)];
  return { x: ends(x), errorX: ends(other), count: x.length, difference: error - (before - load) };
}"""


def test_a_zoom_moves_both_axes_and_draws_the_samples_of_the_view(open_page, study_file, runs):
    shown = open_page(study_file)
    shown.js("openPlot('plot-reading').then(() => null)")
    found = shown.js(ZOOM)
    step = 1 / next(one.recording for one in runs.drives if one.recording is not None).sample_rate
    assert found["x"] == pytest.approx([0.5 - step, 0.6 + step], abs=2 * step)
    assert found["errorX"] == found["x"]
    assert found["count"] == pytest.approx(0.1 / step, abs=5)
    assert found["difference"] == 0


SWITCH = """async () => {
  const plot = await openPlot('plot-reading'), shown = (name) => plot.document.get_model_by_name(name).visible;
  const names = ['reading before the filter', 'error before the filter', 'reading after the filter'];
  const button = document.querySelector('#reading .curves button'), widths = [];
  for (const [start, end] of [[0.5, 0.52], plot.data.range]) {
    plot.range.setv({ start, end });
    await new Promise((done) => setTimeout(done, 200));
    widths.push(plot.document.get_model_by_name('reading before the filter').glyph.line_width.value);
  }
  button.focus();
  button.click();
  return { pressed: button.getAttribute('aria-pressed'), text: button.innerText, shown: names.map(shown), widths };
}"""


def test_a_button_hides_a_curve_in_both_plots_and_crowded_curves_are_thin(open_page, study_file):
    found = open_page(study_file).js(SWITCH)
    assert found["text"] == "before the filter"
    assert found["pressed"] == "false"
    assert found["shown"] == [False, False, True]
    assert found["widths"] == [1.3, 1]


RUSH = """async () => {
  const plot = await openPlot('plot-reading'), source = plot.document.get_model_by_name('before');
  let updates = 0;
  source.properties.data.change.connect(() => { updates += 1; });
  for (let at = 1; at <= 20; at += 1) {
    plot.range.setv({ start: 0.01 * at, end: 0.01 * at + 0.3 });
    await Promise.resolve();
  }
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  return { updates, first: source.data.x[0], start: plot.range.start };
}"""


def test_many_changes_within_a_frame_draw_the_first_and_the_last_view(open_page, study_file):
    found = open_page(study_file).js(RUSH)
    assert found["updates"] <= 3  # a busy browser may begin a frame between them
    assert found["first"] == pytest.approx(found["start"], abs=1e-3)


def test_a_table_sorts_and_filters(open_page, study_file):
    shown = open_page(study_file)
    shown.unfold()
    column = "[...document.querySelectorAll('#ranking tbody tr')].map((row) => parseFloat(row.cells[5].innerText))"
    stated = shown.js(column)
    shown.page.click("#ranking thead th:nth-child(6) button")
    assert shown.js(column) == sorted(stated)
    shown.page.click("#ranking thead th:nth-child(6) button")
    assert shown.js(column) == sorted(stated, reverse=True)
    shown.page.fill("#ranking input.filter", "low_pass_20Hz")
    seen = shown.js(
        "[...document.querySelectorAll('#ranking tbody tr')].filter((row) => !row.hidden).map((row) => row.innerText)"
    )
    assert seen
    assert all("low_pass_20Hz" in row for row in seen)


@everywhere
def test_a_matrix_cell_shows_its_calculation_to_mouse_and_keyboard(open_page, file):
    shown = open_page(file)
    shown.unfold()
    link = shown.page.locator("#kesselring + .scroll td a, #kesselring td a").first
    link.hover()
    shown_calculation = shown.page.locator("#calculation")
    assert shown_calculation.is_visible()
    assert "points" in shown_calculation.inner_text()
    shown.page.keyboard.press("Escape")
    assert not shown_calculation.is_visible()
    link.focus()
    assert shown_calculation.is_visible()
