"""A page as PDF, printed by a headless Chromium or by WeasyPrint, whichever is installed."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from importlib.util import find_spec
from pathlib import Path

from torquerig.errors import InputError
from torquerig.whole_file import whole_file

CHROMIUM = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "msedge")
LONGEST = 180  # [s] a report of 10 MB takes some seconds; more means that the browser hangs


def check_pdf_printer() -> None:
    """Raise InputError where nothing here can print a page, before a long calculation."""
    if _chromium() is None and find_spec("weasyprint") is None:
        raise InputError(
            "--pdf: neither Chromium (or Chrome) is in PATH nor WeasyPrint is installed; install one of them, or leave "
            "out --pdf and print the page from a browser"
        )


def write_pdf(page: Path, path: Path) -> None:
    """Print an HTML page of this package into ``path``; an old file is replaced when the new one is complete.

    Raises
    ------
    InputError
        Where nothing here can print, or the browser wrote no PDF.
    """
    check_pdf_printer()
    browser = _chromium()
    with whole_file(path) as partial:
        if browser is None:
            from weasyprint import HTML

            HTML(filename=str(page)).write_pdf(str(partial))
            return
        _print_with(browser, page, partial)


def _chromium() -> str | None:
    return next((found for name in CHROMIUM if (found := shutil.which(name))), None)


def _print_with(browser: str, page: Path, path: Path) -> None:
    # root may not start Chromium's sandbox; the page is ours, and its content policy refuses every request
    as_root = ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
    with tempfile.TemporaryDirectory() as profile:
        command = [
            browser, "--headless", "--disable-gpu", "--no-first-run", f"--user-data-dir={profile}", *as_root,
            "--no-pdf-header-footer", "--virtual-time-budget=20000", f"--print-to-pdf={path}", page.resolve().as_uri(),
        ]  # fmt: skip
        try:
            done = subprocess.run(command, capture_output=True, timeout=LONGEST, check=False)  # noqa: S603 (no shell)
        except subprocess.TimeoutExpired:
            raise InputError(
                f"--pdf: {browser} did not finish within {LONGEST} s; leave out --pdf and print {page} from a browser"
            ) from None
    if not path.is_file() or not path.read_bytes().startswith(b"%PDF"):
        last = done.stderr.decode(errors="replace").strip().splitlines()[-1:] or ["no message"]
        raise InputError(f"--pdf: {browser} wrote no PDF ({last[0]}); leave out --pdf and print {page} from a browser")
