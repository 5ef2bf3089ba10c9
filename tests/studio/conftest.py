"""A studio for tests in the browser: a process with a folder of scenarios, and pages in Chromium."""

import os
import re
import shutil
import subprocess
import sys
import time
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import urlsplit

import pytest

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
START = 60.0  # [s] on a busy machine; an idle one needs some two
ANSWERED = 30_000  # [ms]
FILES = ("wear_rig.yaml", "filters.yaml", "two_stage_branch.yaml")


@pytest.fixture(scope="session")
def start_studio():
    """Start a studio of a folder or scenario; its address is what it prints first."""
    if find_spec("nicegui") is None:
        reason = "the extra studio is not installed: pip install 'torquerig[studio]'"
        pytest.fail(reason) if os.environ.get("TORQUERIG_BROWSER") == "required" else pytest.skip(reason)
    started = []
    # NiceGUI looks for variables of pytest
    inherited = {name: one for name, one in os.environ.items() if not name.startswith("PYTEST")}

    def start(where, *options, **variables):
        env = {**inherited, "PYTHONUNBUFFERED": "1", **variables}
        command = [sys.executable, "-m", "torquerig", "studio", str(where), "--no-browser", *options]
        printed = (where.parent if where.is_file() else where) / "studio.log"
        log = printed.open("w+")
        process = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, env=env)
        started.append((process, log))
        end = time.monotonic() + START
        while time.monotonic() < end and process.poll() is None:
            if found := re.search(r"http://\S+", printed.read_text(encoding="utf-8")):
                return found[0]
            time.sleep(0.05)
        raise AssertionError(f"the studio did not start: {printed.read_text(encoding='utf-8')}")

    yield start
    for process, log in started:
        process.terminate()
        process.wait(20)
        log.close()


def filled_folder(folder):
    for name in FILES:
        shutil.copy(SCENARIOS / name, folder)
    return folder


@pytest.fixture(scope="session")
def shared_studio(start_studio, tmp_path_factory):
    """The address of one studio for all tests that save nothing."""
    return start_studio(filled_folder(tmp_path_factory.mktemp("studio")) / "wear_rig.yaml")


@pytest.fixture
def own_folder(tmp_path):
    return filled_folder(tmp_path)


class StudioPage:
    """A tab in a separate browser context: what it logged as an error, and which hosts it asked."""

    def __init__(self, browser, address, *, step="what_if", width=1280, dark=False):
        self.context = browser.new_context(
            viewport={"width": width, "height": 900}, color_scheme="dark" if dark else "light"
        )
        self.page, self.errors, self.hosts, self.address = self.context.new_page(), [], set(), address
        self.page.set_default_timeout(ANSWERED)
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("console", lambda line: self.errors.append(line.text) if line.type == "error" else None)
        self.page.on("request", self._asked)
        self.page.goto(f"{address}&step={step}")
        if step == "what_if":
            self.wait_for_answer()
        else:
            self.page.wait_for_selector("main section:not(.hidden) h2")

    def _asked(self, request):
        if not request.url.startswith(("data:", "blob:")):
            self.hosts.add(urlsplit(request.url).netloc)

    def js(self, expression, argument=None):
        return self.page.evaluate(expression, argument)

    def text(self, place):
        return self.page.locator(place).inner_text()

    def drawn(self):
        return int(self.js("(document.querySelector('.plot')?.dataset.drawn) || '0'"))

    def wait_for_answer(self, after=0):
        """Wait until the plots were drawn once more than ``after`` times and the sizing is there."""
        self.page.wait_for_function(
            """(after) => {
                const plots = [...document.querySelectorAll('.plot')];
                const sized = document.querySelector('#what-if-sizing');
                return plots.length === 2 && plots.every((one) => Number(one.dataset.drawn || 0) > after)
                  && sized && sized.innerText.length > 1;
            }""",
            arg=after,
        )

    def change(self, label, text):
        """Write into a field and leave it; wait for the answer."""
        before = self.drawn()
        field = self.page.get_by_label(label, exact=True)
        field.select_option(text) if label == "filter" else field.fill(text)
        field.press("Tab")
        self.wait_for_answer(before)

    def open_step(self, title):
        self.page.get_by_role("button", name=title, exact=True).click()


@pytest.fixture
def open_studio(chromium):
    opened = []

    def opening(address, **how):
        opened.append(StudioPage(chromium, address, **how))
        return opened[-1]

    yield opening
    for one in opened:
        one.context.close()
