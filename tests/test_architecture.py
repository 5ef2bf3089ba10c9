"""The structure of the source tree: no circles, no long files, no crowded folders, no name used twice."""

import ast
from collections import defaultdict
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PACKAGES = {"torquerig": ROOT / "src" / "torquerig", "proof": ROOT / "proof"}
LONGEST_FILE = 300  # lines
MOST_FILES = 40  # of a folder
LIBRARIES = {"mechanisms"}  # one effect per file, however many there are


def modules(package):
    """Return the files of a package by the dotted name of their module."""
    root = PACKAGES[package]
    found = {}
    for path in root.rglob("*.py"):
        parts = [package, *path.relative_to(root).with_suffix("").parts]
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imports(known, path):
    """Return the modules of ``known`` that a file imports, anywhere in it, for types too."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module:
            full = {f"{node.module}.{name.name}" for name in node.names}
            found |= {one if one in known else node.module for one in full}
        elif isinstance(node, ast.Import):
            found |= {name.name for name in node.names}
    return found & set(known)


@pytest.mark.parametrize("package", PACKAGES)
def test_no_modules_import_each_other_in_a_circle(package):
    known = modules(package)
    graph = {name: imports(known, path) - {name} for name, path in known.items()}
    assert sum(map(len, graph.values())) > 100
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(" -> ".join(error.args[1]))


@pytest.mark.parametrize("package", PACKAGES)
def test_no_file_is_longer_than_it_may_be(package):
    lengths = {str(path.relative_to(ROOT)): path.read_text().count("\n") for path in PACKAGES[package].rglob("*.py")}
    assert {name: lines for name, lines in lengths.items() if lines > LONGEST_FILE} == {}


@pytest.mark.parametrize("package", PACKAGES)
def test_no_folder_holds_more_files_than_it_may(package):
    folders = defaultdict(int)
    for path in PACKAGES[package].rglob("*.py"):
        folders[path.parent] += 1
    crowded = {folder.name for folder, files in folders.items() if files > MOST_FILES}
    assert crowded <= LIBRARIES


@pytest.mark.parametrize("package", PACKAGES)
def test_no_module_has_the_name_of_its_package(package):
    same = [name for name in modules(package) if name.split(".")[-1] in name.split(".")[:-1]]
    assert same == []
