"""A page as PDF: printed by the browser that is there, refused with a remedy where none is."""

import shutil

import pytest

from torquerig.errors import InputError
from torquerig.reporting import pdf
from torquerig.reporting.pdf import CHROMIUM, check_pdf_printer, write_pdf


def test_without_a_printer_the_command_is_refused_before_it_computes(monkeypatch):
    monkeypatch.setenv("PATH", "")
    monkeypatch.setattr(pdf, "find_spec", lambda name: None)
    with pytest.raises(InputError, match=r"neither Chromium .* leave out --pdf and print the page from a browser"):
        check_pdf_printer()


def test_a_browser_that_writes_nothing_is_named_and_no_file_is_left(tmp_path, monkeypatch):
    broken = tmp_path / "bin" / "chromium"
    broken.parent.mkdir()
    broken.write_text("#!/bin/sh\necho cannot start >&2\n")
    broken.chmod(0o755)
    monkeypatch.setenv("PATH", str(broken.parent))
    page, path = tmp_path / "a.html", tmp_path / "a.pdf"
    page.write_text("<p>page</p>")
    with pytest.raises(InputError, match=r"wrote no PDF \(cannot start\)"):
        write_pdf(page, path)
    assert sorted(one.name for one in tmp_path.iterdir()) == ["a.html", "bin"]


@pytest.mark.skipif(not any(map(shutil.which, CHROMIUM)), reason="no Chromium in PATH")
def test_a_page_is_printed_whole(tmp_path):
    page, path = tmp_path / "a.html", tmp_path / "a.pdf"
    page.write_text("<h1>first</h1><h1 style='break-before:page'>second</h1>", encoding="utf-8")
    write_pdf(page, path)
    data = path.read_bytes()
    assert data.startswith(b"%PDF")
    assert data.count(b"/Type /Page\n") == 2
