"""Every page says for whom it is, its links lead somewhere, and the reference has every part and effect."""

from __future__ import annotations

import re
from importlib import import_module
from pathlib import Path

import pytest

from torquerig import mechanisms
from torquerig.rig import parts

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
RECORDS = sorted((DOCS / "decisions").glob("0*.md"))
PAGES = sorted(DOCS.glob("*.md"))
LINKED = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *PAGES, DOCS / "decisions" / "index.md", *RECORDS]
LINK = re.compile(r"\]\((?!https?:)([^)#\s]*)(#[^)\s]*)?\)")


def anchors(page: Path) -> set[str]:
    """Return the anchors that a code host and Sphinx make of the headings of a page."""
    heads = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {"#" + re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


@pytest.mark.parametrize("page", [page for page in PAGES if page.name != "index.md"], ids=lambda page: page.name)
def test_a_page_starts_with_its_reader(page: Path) -> None:
    title, _, reader = page.read_text(encoding="utf-8").split("\n")[:3]
    assert title.startswith("# ")
    assert re.match(r"\*For (those|everyone|new users|a |the )", reader)


@pytest.mark.parametrize("page", LINKED, ids=lambda page: page.name)
def test_links_lead_to_a_file_and_a_heading(page: Path) -> None:
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    for target, anchor in LINK.findall(text):
        file = (page.parent / target).resolve() if target else page
        built = file.name == "index.rst" and file.parent.name == "gallery"  # made by the build
        assert built or file.exists(), f"{page.name}: {target}"
        assert not anchor or anchor in anchors(file), f"{page.name}: {target}{anchor}"


@pytest.mark.parametrize("record", RECORDS, ids=lambda record: record.stem)
def test_a_decision_record_has_its_three_parts_and_its_row(record: Path) -> None:
    lines = record.read_text(encoding="utf-8").splitlines()
    assert lines[0].startswith(f"# {record.stem[:4]}: ")
    heads = [line.split(".**")[0] for line in lines if line.startswith("**")]
    assert heads == ["**Context", "**Decision", "**Consequence"]
    assert len(lines) <= 25
    row = f"| {record.stem[:4]} | [{lines[0][8:]}]({record.name}) |"
    assert row in (DOCS / "decisions" / "index.md").read_text(encoding="utf-8").splitlines()


def test_there_are_records() -> None:
    assert [record.stem[:4] for record in RECORDS] == [f"{number:04d}" for number in range(1, len(RECORDS) + 1)]
    assert len(RECORDS) >= 25


def test_the_reference_lists_every_part_and_mechanism() -> None:
    listed = set((DOCS / "api.rst").read_text(encoding="utf-8").split())
    classes = [getattr(package, name) for package in (parts, mechanisms) for name in package.__all__]
    assert [name for name in (f"{one.__module__}.{one.__name__}" for one in classes) if name not in listed] == []


def test_the_index_leads_to_every_page() -> None:
    index = (DOCS / "README.md").read_text(encoding="utf-8")
    tree = (DOCS / "index.md").read_text(encoding="utf-8").splitlines()
    names = [page.name for page in PAGES if page.name not in ("README.md", "index.md")]
    assert [name for name in names if f"({name})" not in index] == []
    assert [name for name in names if name.removesuffix(".md") not in tree] == []


def test_every_name_of_the_reference_exists() -> None:
    names = re.findall(r"^   (torquerig\.\S+)$", (DOCS / "api.rst").read_text(encoding="utf-8"), re.MULTILINE)
    gone = []
    for home, _, name in (one.rpartition(".") for one in names):
        try:
            if not hasattr(import_module(home), name):
                gone.append(f"{home}.{name}")
        except ModuleNotFoundError:
            gone.append(home)
    assert gone == []
    assert len(names) > 200


def test_the_architecture_names_every_package_and_only_what_exists() -> None:
    page = (DOCS / "architecture.md").read_text(encoding="utf-8")
    package = ROOT / "src" / "torquerig"
    folders = [one.name for one in package.iterdir() if (one / "__init__.py").exists()]
    assert [name for name in folders if f"| `{name}/` |" not in page] == []
    modules = [one.stem for one in package.glob("*.py") if not one.stem.startswith("__")]
    assert [name for name in modules if f"`{name}`" not in page] == []
    texts = [page, *(record.read_text(encoding="utf-8") for record in RECORDS)]
    named = {name for text in texts for name in re.findall(r"`([a-z_]+/[a-z_/]*(?:\.py|\.yaml)?)`", text)}
    former = {"signals/"}  # what record 0011 divided
    gone = [one for one in named - former if not ((package / one).exists() or (ROOT / one).exists())]
    assert [one for one in gone if not list(package.glob(f"*/{one.rstrip('/')}"))] == []
