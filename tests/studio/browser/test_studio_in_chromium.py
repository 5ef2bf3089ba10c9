"""The studio in a real browser: its numbers, errors at their field, two tabs, undo, keyboard, phone, dark, axe."""

import urllib.error
import urllib.request
from pathlib import Path
from urllib.parse import urlsplit

import pytest
import yaml

from torquerig.studio.what_if.engine import WhatIf
from torquerig.studio.what_if.question import Question

pytestmark = pytest.mark.long  # each starts or drives a studio with the integrator

STEPS = ("rig", "what_if")
CATALOG = Path(__file__).resolve().parents[3] / "catalogs" / "motors"
LARGE = "#what-if-error"


def error_of(folder, **changes):
    path = Path(folder) / "wear_rig.yaml"
    found = WhatIf().simulated(Question(path=path, text=path.read_text(encoding="utf-8"), **changes))
    return found.error_after


def shown_error(shown):
    return float(shown.text(LARGE).removesuffix(" N m"))


def test_the_page_asks_no_other_host_and_logs_no_error(open_studio, shared_studio):
    shown = open_studio(shared_studio)
    shown.open_step("Rig")
    shown.open_step("What-if")
    assert shown.hosts == {urlsplit(shared_studio).netloc}
    assert shown.errors == []
    assert shown.hosts == {f"127.0.0.1:{urlsplit(shared_studio).port}"}


@pytest.mark.parametrize("path", ["/", "/?token=wrong", "/studio/page/studio.css", "/_nicegui_ws/socket.io/?EIO=4"])
def test_a_request_without_the_token_is_refused(shared_studio, path):
    port = urlsplit(shared_studio).port
    with pytest.raises(urllib.error.HTTPError, match="403") as refused:
        urllib.request.urlopen(f"http://127.0.0.1:{port}{path}", timeout=10)
    assert b"token" in refused.value.read()


def test_changes_show_the_numbers_of_the_integrator(open_studio, shared_studio, own_folder):
    shown = open_studio(shared_studio)
    assert shown_error(shown) == pytest.approx(error_of(own_folder), abs=5e-4)  # three digits are shown
    shown.change("motor", "HDS6A-0104A")
    shown.change("output speed", "250 rpm")
    shown.change("filter", "order_lines_low_pass")
    changes = {"motor": "HDS6A-0104A", "settings": ((("operating_point", "output_speed"), "250 rpm"),)}
    expected = error_of(own_folder, chain="order_lines_low_pass", **changes)
    assert shown_error(shown) == pytest.approx(expected, abs=5e-4)
    assert "HDS6A-0104A, 5:1, motor at 1250 rpm" in shown.text("#what-if-title")
    assert "cogging" in shown.text("[aria-label='lines']")
    before = shown.drawn()
    shown.page.get_by_role("button", name="Undo last value").click()
    shown.wait_for_answer(before)
    assert shown.page.get_by_label("filter", exact=True).input_value() == "none"
    assert shown_error(shown) > expected


def test_an_error_is_at_its_field_and_the_last_answer_stays(open_studio, shared_studio):
    shown = open_studio(shared_studio)
    before, field = shown.text(LARGE), shown.page.get_by_label("output speed", exact=True)
    field.fill("200 N")
    field.press("Enter")
    shown.page.wait_for_selector("[aria-invalid='true']")
    assert field.get_attribute("aria-invalid") == "true"
    said = shown.text(f"#{field.get_attribute('aria-describedby')}")
    assert said.startswith("'200 N' is a force; a speed is wanted")
    assert shown.text(LARGE) == before
    assert shown.page.locator(".stale").count() == 1
    shown.change("output speed", "210 rpm")
    assert field.get_attribute("aria-invalid") is None
    assert shown.page.locator(".stale").count() == 0
    motor = shown.page.get_by_label("motor", exact=True)
    motor.fill("nope")
    motor.press("Tab")
    shown.page.wait_for_selector("[aria-invalid='true']")
    said = shown.text(f"#{motor.get_attribute('aria-describedby')}")
    assert said.startswith("there is no motor 'nope' in the catalog")  # no option of the command line


def test_the_keyboard_alone_changes_the_motor(open_studio, shared_studio):
    shown, before = open_studio(shared_studio), 0
    label = "document.activeElement.labels?.[0]?.innerText"
    for _ in range(30):
        shown.page.keyboard.press("Tab")
        if shown.js(label) == "motor":
            break
    assert shown.js(label) == "motor"
    before = shown.drawn()
    shown.page.keyboard.type("HDS60-0104A")
    shown.page.keyboard.press("Enter")
    shown.wait_for_answer(before)
    assert "HDS60-0104A" in shown.text("#what-if-title")


def test_two_tabs_do_not_mix(open_studio, shared_studio):
    one, other = open_studio(shared_studio, step="rig"), open_studio(shared_studio, step="rig")
    field = one.page.get_by_label("output speed", exact=True)
    field.fill("123 rpm")
    field.press("Tab")
    one.page.wait_for_selector("button:text-is('Undo'):not([disabled])")
    other.page.wait_for_timeout(2500)  # longer than the studio looks at the disk
    assert other.page.get_by_label("output speed", exact=True).input_value() == "200 rpm"
    assert other.page.locator("button:text-is('Undo')").is_disabled()
    one.page.reload()
    one.page.wait_for_selector("main section:not(.hidden) h2")
    assert one.page.get_by_label("output speed", exact=True).input_value() == "123 rpm"  # nothing is lost


def test_two_tabs_of_one_browser_have_their_values(open_studio, shared_studio):
    shown = open_studio(shared_studio)
    other = shown.context.new_page()
    other.goto(f"{shared_studio}&step=what_if")
    other.wait_for_selector("#what-if-title")
    shown.change("output speed", "240 rpm")
    other.wait_for_function("document.querySelector('#what-if-title').innerText.includes('1000 rpm')")
    assert other.get_by_label("output speed", exact=True).input_value() == "200 rpm"
    assert "motor at 1200 rpm" in shown.text("#what-if-title")


def test_the_file_is_saved_under_another_name(open_studio, start_studio, own_folder):
    shown = open_studio(start_studio(own_folder / "wear_rig.yaml"), step="rig")
    field = shown.page.get_by_label("output speed", exact=True)
    field.fill("150 rpm")
    field.press("Tab")
    shown.page.get_by_role("button", name="Save as").click()
    name = shown.page.get_by_label("new file name", exact=True)
    for text, problem in (("mine", "ends in .yaml"), ("two_stage_branch.yaml", "is there already")):
        name.fill(text)
        shown.page.get_by_role("button", name="Write the new file").click()
        shown.page.wait_for_selector(f".bar .problem:has-text('{problem}')")
    name.fill("mine.yaml")
    shown.page.get_by_role("button", name="Write the new file").click()
    shown.page.wait_for_function("document.querySelector('.bar select').value === 'mine.yaml'")
    assert yaml.safe_load((own_folder / "mine.yaml").read_text())["operating_point"]["output_speed"] == "150 rpm"
    assert yaml.safe_load((own_folder / "wear_rig.yaml").read_text())["operating_point"]["output_speed"] == "200 rpm"


def test_a_catalog_edited_to_nonsense_is_said_and_the_last_answer_stays(open_studio, start_studio, own_folder):
    motors = own_folder / "catalogs" / "motors"
    motors.mkdir(parents=True)
    (motors / "mine.yaml").write_text((CATALOG / "HDS6A-0104A.yaml").read_text().replace("HDS6A-0104A", "mine"))
    shown = open_studio(start_studio(own_folder / "wear_rig.yaml"))
    shown.change("motor", "mine")
    before = shown.text(LARGE)
    (motors / "mine.yaml").write_text("name: mine\nnonsense: 3\n")
    shown.page.wait_for_selector(".steps-shown > [role=alert] >> text=mine.yaml")
    field = shown.page.get_by_label("output speed", exact=True)
    field.fill("210 rpm")
    field.press("Enter")
    shown.page.wait_for_selector(".stale")
    assert shown.text(LARGE) == before


def test_a_problem_is_at_its_part_and_undo_takes_it_back(open_studio, shared_studio):
    shown = open_studio(shared_studio, step="rig")
    box = shown.page.locator("[data-part='gearbox']")
    box.focus()
    shown.page.keyboard.press("Enter")
    shown.page.wait_for_selector("h3:text('gearbox: gear')")
    entry = shown.page.get_by_label("catalog entry", exact=True)
    entry.fill("no-such-box")
    entry.press("Tab")
    shown.page.wait_for_selector("[data-part='gearbox'].wrong")
    assert "1 problem" in box.get_attribute("aria-label")
    assert "no-such-box" in shown.text("section:not(.hidden) .two .problem >> nth=0")
    shown.page.locator("button:text-is('Undo')").click()
    shown.page.wait_for_selector("[data-part='gearbox']:not(.wrong)")
    assert entry.input_value() == "reference-5-1"


def test_values_are_taken_over_saved_with_comments_and_undone(open_studio, start_studio, own_folder):
    file = own_folder / "wear_rig.yaml"
    stated = file.read_text(encoding="utf-8")
    shown = open_studio(start_studio(file))
    shown.change("motor", "HDS6A-0104A")
    shown.change("occupancy", "11 %")
    changed = shown_error(shown)
    before = shown.drawn()
    shown.page.get_by_role("button", name="Take over into the scenario").click()
    shown.wait_for_answer(before)
    assert shown_error(shown) == changed
    assert file.read_text(encoding="utf-8") == stated
    shown.page.keyboard.press("Control+s")
    shown.page.wait_for_function("document.querySelector('[role=status].status').innerText.includes('wear_rig.yaml')")
    saved = file.read_text(encoding="utf-8")
    data = yaml.safe_load(saved)
    assert data["rig"]["motor"]["catalog"] == "HDS6A-0104A"
    assert data["operating_point"]["load"]["occupancy"] == "11 %"
    assert "# runs with `profile: duty_cycle`" in saved
    assert error_of(own_folder) == pytest.approx(changed, abs=5e-4)
    undo = shown.page.locator("button:text-is('Undo'):not([disabled])")
    while undo.count():
        undo.click()
        shown.page.wait_for_timeout(300)
    shown.page.locator("button:text-is('Save'):not([disabled])").click()
    shown.page.wait_for_selector("button:text-is('Save')[disabled]")
    assert file.read_text(encoding="utf-8") == stated
    file.write_text(stated.replace("200 rpm ", "190 rpm "), encoding="utf-8")
    shown.page.wait_for_function("document.querySelector('.status').innerText.includes('changed on the disk')")


def test_an_empty_folder_offers_a_shipped_scenario(open_studio, start_studio, tmp_path):
    shown = open_studio(start_studio(tmp_path), step="rig")
    shown.page.get_by_role("button", name="Copy it").click()
    shown.page.wait_for_selector("[data-part='gearbox']")
    shown.page.locator("button:text-is('Save'):not([disabled])").click()
    shown.page.wait_for_selector("button:text-is('Save')[disabled]")
    assert (tmp_path / "wear_rig.yaml").exists()


@pytest.mark.parametrize("step", STEPS)
def test_a_phone_scrolls_in_one_direction_only(open_studio, shared_studio, step):
    shown = open_studio(shared_studio, step=step, width=390)
    shown.js("document.querySelectorAll('details').forEach((one) => { one.open = true; })")
    assert shown.js("document.documentElement.scrollWidth") <= 390


@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
@pytest.mark.parametrize("step", STEPS)
def test_axe_finds_no_serious_fault(open_studio, shared_studio, step, dark):
    from axe_playwright_python.sync_playwright import Axe

    shown = open_studio(shared_studio, step=step, dark=dark)
    shown.js("document.querySelectorAll('details').forEach((one) => { one.open = true; })")
    found = Axe().run(shown.page).response["violations"]
    serious = {one["id"]: one["nodes"][0]["html"][:300] for one in found if one["impact"] in ("serious", "critical")}
    assert serious == {}


def test_a_curve_is_hidden_by_its_button(open_studio, shared_studio):
    shown = open_studio(shared_studio)
    visible = "Bokeh.documents.map((one) => one.get_model_by_name('true load')).find(Boolean).visible"
    button = shown.page.get_by_role("button", name="true load")
    assert shown.js(visible) is True
    button.focus()
    shown.page.keyboard.press("Enter")
    assert button.get_attribute("aria-pressed") == "false"
    assert shown.js(visible) is False
    shown.change("output speed", "220 rpm")
    assert shown.js(visible) is False  # the next answer keeps what was chosen
