"""A text checked as what it is, by the checks that the commands use; each problem is a value, none a traceback."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from torquerig.catalog.reading import Catalog
from torquerig.document import Document, parse_document
from torquerig.errors import InputError, TorquerigError
from torquerig.studio.session.problem import Problem, problems_of

Kind = Literal["scenario", "sheet", "matrix", "filters", "other"]
_BY_KEY: Mapping[str, Kind] = {
    "rig": "scenario", "operating_point": "scenario", "criteria": "matrix", "alternatives": "matrix",
    "tables": "matrix", "filters": "filters", "channels": "sheet", "run": "sheet", "sample_rate_Hz": "sheet",
}  # fmt: skip


@dataclass(frozen=True)
class Checked:
    """What a text is read as, or what is wrong with it.

    Parameters
    ----------
    kind : str
    value : Scenario, Sidecar, MatrixCase, TableSet, mapping of chains, or None
        None where there are problems, and for a file of no known kind.
    problems : tuple of Problem
    """

    kind: Kind
    value: Any
    problems: tuple[Problem, ...]


def kind_of(text: str, path: Path) -> Kind:
    """Return what a YAML text is, by the keys of its top level; ``other`` where it is no YAML or has none of them."""
    try:
        data = parse_document(text, path).data
    except InputError:
        return "other"
    if not isinstance(data, dict):
        return "other"
    return next((kind for key, kind in _BY_KEY.items() if key in data), "other")


def checked(text: str, path: Path, *, catalog: Catalog, seed: int, kind: Kind | None = None) -> Checked:
    """Return what a text is read as, with all problems that the checks of the commands find.

    Parameters
    ----------
    text : str
    path : Path
        Files that it names are looked for in its folder.
    catalog : Catalog
    seed : int
        Fixes what is drawn where the catalog has only an interval.
    kind : str, optional
        What it was before, where the text does not show it any more.
    """
    found = kind_of(text, path)
    found = kind or found if found == "other" else found
    document = None
    try:
        document = parse_document(text, path)
        return Checked(found, _READERS[found](document, catalog, seed), ())
    except TorquerigError as error:
        return Checked(found, None, problems_of(error, document, path))
    except OSError as error:
        sentence = f"{error.filename}: cannot be read ({error.strerror})"
        return Checked(found, None, (Problem((), None, sentence, path),))
    except Exception as error:  # the page must stay usable, whatever a check does
        sentence = (
            f"the check failed with {type(error).__name__}: {error}; this is a fault of torquerig, please report it"
        )
        return Checked(found, None, (Problem((), None, " ".join(sentence.split()), path),))


def _scenario(document: Document, catalog: Catalog, seed: int) -> Any:
    from torquerig.scenario.reading import read_scenario
    from torquerig.study.definition import open_study

    scenario = read_scenario(document, catalog, seed=seed)
    if "study" in document.data:
        open_study(document, catalog).chains(scenario)
    return scenario


def _sheet(document: Document, _: Catalog, __: int) -> Any:
    from torquerig.recordings.files.sidecar import sidecar_from

    return sidecar_from(document)


def _matrix(document: Document, catalog: Catalog, _: int) -> Any:
    if isinstance(document.data, dict) and "tables" in document.data:
        from torquerig.decide.matrix_io.published_tables import tables_from

        return tables_from(document)
    from torquerig.decide.matrix_io.matrix_file import matrix_from

    return matrix_from(document, catalog=catalog)


def _filters(document: Document, _: Catalog, __: int) -> Any:
    from torquerig.filters.chains.chain_file import chain_texts

    return chain_texts(document)


def _other(document: Document, _: Catalog, __: int) -> Any:
    raise InputError(f"{document.path}: is no scenario, sidecar, matrix or file of filters; a scenario needs rig:, a "
                     "sidecar channels: or run:, a matrix criteria: and alternatives:")  # fmt: skip


_READERS: Mapping[Kind, Callable[[Document, Catalog, int], Any]] = {
    "scenario": _scenario, "sheet": _sheet, "matrix": _matrix, "filters": _filters, "other": _other,
}  # fmt: skip
