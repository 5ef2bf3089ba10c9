"""Chromium for the tests of pages: Debian's, driven by playwright.

Without it the tests are skipped with a reason; where TORQUERIG_BROWSER is set to ``required``, as in CI, they fail.
"""

import os
import shutil

import pytest

from torquerig.reporting.study.report import write_study_report

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def _missing(reason):
    if os.environ.get("TORQUERIG_BROWSER") == "required":
        pytest.fail(reason)
    pytest.skip(reason)


@pytest.fixture(scope="session")
def chromium():
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        _missing("playwright is not installed: pip install --group browser")
    found = next((path for name in NAMES if (path := shutil.which(name))), None)
    if found is None:
        _missing("no Chromium in PATH: apt-get install chromium")
    with sync_playwright() as started:
        browser = started.chromium.launch(executable_path=found, args=["--no-sandbox"])
        yield browser
        browser.close()


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
            self.page.wait_for_function(
                "plotsOnPage.size === document.querySelectorAll('[data-plot]').length", timeout=20_000
            )
            self.js("Promise.all([...plotsOnPage.values()]).then(() => null)")


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
