"""Data, Check, Compare and Diagnose in a real browser: files dropped, a study taken up again, a diagnosis shown."""

import json
import re
import shutil
from pathlib import Path
from urllib.parse import urlsplit

import pytest
import yaml

import torquerig as tr
from torquerig.recordings.files import read_recording

pytestmark = pytest.mark.long  # each drives a studio; a study and a diagnosis are computed

SCENARIOS = Path(__file__).resolve().parents[3] / "scenarios"
TABLE = "time_s,u [V],enc\n" + "".join(f"{at / 1000},{at % 7},{at}\n" for at in range(400))
SOON, LONG = 30_000, 240_000  # [ms] a page, and a computation, on a busy machine
SMALL = {
    "duration": "10 s", "draws": 2, "motors": ["bldc-12n14p", "HDS5C-102A"],
    "gearboxes": ["reference-5-1", "economy-20-1"],
}  # fmt: skip
"""Drives with one gearbox are ready together, so two gearboxes give a moment in which half is done."""
STEPS = ("data", "check", "compare", "diagnose")


@pytest.fixture(scope="module")
def recordings(tmp_path_factory):
    """Two runs of the wear rig with a hum that the scenario lacks."""
    folder = tmp_path_factory.mktemp("runs")
    hum = tr.mechanisms.MainsInterference(name="hum", amplitudes=(0.3,), phases=(0.0,))
    for rpm in (140, 200):
        rig = tr.read_scenario("wear_rig.yaml", changes={"operating_point.output_speed": f"{rpm} rpm"})
        tr.write(tr.simulate(rig + hum, duration=3.0, truth=False), folder / f"run{rpm}.csv")
    return folder


@pytest.fixture
def folder(tmp_path, recordings):
    """A scenario with a small study, its filters and the two runs."""
    text = (SCENARIOS / "wear_rig.yaml").read_text(encoding="utf-8")
    data = yaml.safe_load(text)
    data["study"] |= SMALL
    (tmp_path / "wear_rig.yaml").write_text(yaml.safe_dump(data, sort_keys=False), encoding="utf-8")
    shutil.copy(SCENARIOS / "filters.yaml", tmp_path)
    for file in recordings.iterdir():
        shutil.copy(file, tmp_path)
    return tmp_path


@pytest.fixture
def opened(folder, start_studio, open_studio):
    """Open a step of a studio on the folder; a second call opens a second tab."""
    address = start_studio(folder / "wear_rig.yaml", TORQUERIG_CACHE=str(folder / "kept"))

    def opening(step, **how):
        shown = open_studio(address, step=step, **how)
        shown.page.set_default_timeout(SOON)
        return shown

    return opening


def wait_for(page, text, *, timeout=SOON):
    page.get_by_text(text).locator("visible=true").first.wait_for(timeout=timeout)


def drop(page, name, content):
    page.set_input_files("input[type=file]", files=[{"name": name, "mimeType": "text/csv", "buffer": content.encode()}])


def clicked(page, name):
    page.get_by_role("button", name=name, exact=True).locator("visible=true").last.click()


def test_a_dropped_file_is_completed_in_its_form_and_opens(opened, folder):
    page = opened("data").page
    wait_for(page, "run140.csv can be used.")
    drop(page, "mine.csv", TABLE)
    wait_for(page, "mine.csv: received")
    wait_for(page, "mine.yaml: not saved yet")
    group = page.get_by_role("group", name="channel u", exact=True)
    group.get_by_label("quantity").select_option("torque")
    group.get_by_label("scale Nm_per_V").fill("5.0")
    group.get_by_label("scale Nm_per_V").press("Tab")
    page.get_by_label("speed of the motor [rpm]").fill("1000")
    page.get_by_label("speed of the motor [rpm]").press("Tab")
    clicked(page, "Save the sidecar")
    wait_for(page, "mine.yaml: saved.")
    read = read_recording(folder / "mine.csv")
    assert read.torque()[6] == 30.0
    assert read.run.speed_rpm == pytest.approx(1000)
    drop(page, "mine.csv", "other")
    wait_for(page, "mine.csv: is there already")
    assert (folder / "mine.csv").read_text() == TABLE


def test_an_error_is_at_its_field_and_undo_takes_it_back(opened, folder):
    page = opened("data").page
    wait_for(page, "run140.csv can be used.")
    before = (folder / "run140.yaml").read_bytes()
    field = page.get_by_label("occupancy [%]")
    stated = field.input_value()
    field.fill("500")
    field.press("Tab")
    wait_for(page, "must be at most 100")
    assert field.get_attribute("aria-invalid") == "true"
    assert page.locator("table").locator("visible=true").count() == 1  # what was read stays
    page.get_by_role("button", name="Undo in the sidecar").click()
    page.wait_for_function("() => !document.querySelector('[aria-invalid=true]')")
    assert field.input_value() == stated
    assert (folder / "run140.yaml").read_bytes() == before


def test_two_tabs_do_not_mix(opened, folder):
    one, two = opened("data").page, opened("data").page
    for page in (one, two):
        wait_for(page, "run140.csv can be used.")
    for page, occupancy in ((one, "7"), (two, "9")):
        page.get_by_label("occupancy [%]").fill(occupancy)
        page.get_by_label("occupancy [%]").press("Tab")
        wait_for(page, "run140.yaml: not saved yet")
    assert one.get_by_label("occupancy [%]").input_value() == "7"
    one.get_by_role("button", name="Check", exact=True).click()
    clicked(one, "Check the recordings")
    wait_for(one, "run140.yaml: has edits that are not saved")
    one.get_by_role("button", name="Data", exact=True).click()
    clicked(one, "Save the sidecar")
    wait_for(one, "run140.yaml: saved")
    clicked(two, "Save the sidecar")
    wait_for(two, "has changed on disk since it was read")
    assert yaml.safe_load((folder / "run140.yaml").read_text())["run"]["occupancy_percent"] == 7
    assert two.get_by_label("occupancy [%]").input_value() == "9"


def test_the_check_says_what_the_runs_tell_apart(opened):
    page = opened("check").page
    clicked(page, "Check the recordings")
    wait_for(page, "Scenario and recordings match.", timeout=LONG)  # behind what the first page computes
    wait_for(page, "These runs can tell apart")
    wait_for(page, "all runs have one load; add an idle run")
    page.get_by_label("run140.csv").uncheck()
    clicked(page, "Check the recordings")
    wait_for(page, "all runs have one speed; add a run at another speed")


def test_a_study_is_cancelled_and_taken_up_again(opened, folder):
    shown = opened("compare")
    page = shown.page
    clicked(page, "Compare the drives")
    wait_for(page, re.compile("^[0-3] of 4"), timeout=LONG)  # a batch of drives ends as one
    page.get_by_role("button", name="Cancel: Compare the drives").click()
    wait_for(page, "Cancelled. What is done is kept.")
    page.reload()
    wait_for(page, "Cancelled. What is done is kept.")
    clicked(page, "Compare the drives")
    wait_for(page, re.compile("^4 drives"), timeout=LONG)
    page.wait_for_function("() => document.getElementById('matrix-winner')?.innerText.startsWith('First')")
    stated = page.inner_text("#matrix-winner")
    page.get_by_label("weight of price, number").fill("0.5")
    assert page.inner_text("#matrix-winner") != stated
    clicked(page, "Take these numbers into the file")
    wait_for(page, "1 number taken into wear_rig.yaml.")
    page.get_by_role("button", name="Save", exact=True).click()
    wait_for(page, "wear_rig.yaml: saved")
    assert yaml.safe_load((folder / "wear_rig.yaml").read_text())["study"]["criteria"]["price"]["weight"] == 0.5
    assert shown.errors == []


def test_the_numbers_of_a_matrix_file_are_moved_and_saved(opened, folder):
    shutil.copy(SCENARIOS / "matrix_example.yaml", folder)
    before = (folder / "matrix_example.yaml").read_text(encoding="utf-8")
    page = opened("compare").page
    page.get_by_label("matrices of").select_option("matrix_example.yaml")
    page.wait_for_function("() => document.getElementById('matrix-winner')?.innerText.startsWith('First')")
    name = next(key for key, one in yaml.safe_load(before)["criteria"].items() if one.get("weight"))
    page.get_by_label(f"weight of {name}, number").fill("0.77")
    clicked(page, "Take these numbers into the file")
    wait_for(page, "1 number taken into matrix_example.yaml.")
    page.get_by_role("button", name="Save the file of the matrices").click()
    wait_for(page, "matrix_example.yaml: saved")
    after = (folder / "matrix_example.yaml").read_text(encoding="utf-8")
    changed = [line for line in after.splitlines() if line not in before.splitlines()]
    assert len(changed) == 1
    assert yaml.safe_load(after)["criteria"][name]["weight"] == 0.77


def test_a_diagnosis_is_shown(opened, folder):
    shown = opened("diagnose")
    page = shown.page
    clicked(page, "Diagnose")
    wait_for(page, "Done.", timeout=LONG)
    assert len(page.inner_text(".answer .sentence")) > 10
    assert page.locator("figure img").first.evaluate("(image) => image.naturalWidth") > 100
    with page.expect_download() as saved:
        clicked(page, "Save the JSON")
    data = json.loads(Path(saved.value.path()).read_text())
    assert data["schema"] == "torquerig.diagnosis/1"
    assert set(data["provenance"]["inputs_sha256"]) >= {"run140.csv", "run200.csv", "wear_rig.yaml"}
    for one in data["findings"]:
        wait_for(page, one["explanation"])
    if page.get_by_role("button", name="Save the completed scenario").is_enabled():
        clicked(page, "Save the completed scenario")
        wait_for(page, "diagnosed.yaml: saved")
        assert len(yaml.safe_load((folder / "diagnosed.yaml").read_text())["rig"]) > 9
    assert data["verdict"] != "adequate"
    assert shown.errors == []


@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
def test_axe_finds_no_serious_fault_and_nothing_is_loaded_from_elsewhere(opened, dark):
    from axe_playwright_python.sync_playwright import Axe

    shown = opened("data", dark=dark)
    for step in STEPS:
        shown.open_step(step.capitalize())
        shown.page.get_by_role("heading", name=step.capitalize(), exact=True).wait_for()
        shown.page.wait_for_timeout(500)
        found = Axe().run(shown.page).response["violations"]
        bad = [one for one in found if one["impact"] in ("serious", "critical")]
        assert {one["id"]: one["nodes"][0]["html"][:200] for one in bad} == {}, step
    assert shown.hosts == {urlsplit(shown.address).netloc}
    assert shown.errors == []


@pytest.mark.parametrize("step", STEPS)
def test_a_phone_scrolls_in_one_direction_only(opened, step):
    shown = opened(step, width=390)
    shown.page.wait_for_timeout(1000)
    assert shown.js("document.documentElement.scrollWidth") <= 390


def test_the_what_if_of_an_empty_folder_asks_for_a_scenario(open_studio, start_studio, tmp_path):
    shown = open_studio(start_studio(tmp_path), step="rig")
    shown.open_step("What-if")
    shown.page.wait_for_selector("#what-if-title:has-text('Open a scenario first')")
    shown.open_step("Rig")
    shown.page.get_by_role("button", name="Copy it").click()
    shown.open_step("What-if")
    shown.wait_for_answer()  # with the filter chains that the copied scenario names
    assert "motor at 1000 rpm" in shown.text("#what-if-title")
    assert (tmp_path / "filters.yaml").is_file()
