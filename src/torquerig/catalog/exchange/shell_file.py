"""A shell with one submodel as JSON, or as an AASX package (an archive of the Open Packaging Conventions)."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

from torquerig.errors import InputError
from torquerig.whole_file import whole_file

ORIGIN = "http://admin-shell.io/aasx/relationships/aasx-origin"
SPECIFICATION = "http://admin-shell.io/aasx/relationships/aas-spec"
SUPPLEMENT = "http://admin-shell.io/aasx/relationships/aas-suppl"
FIXED = (1980, 1, 1, 0, 0, 0)  # so that the same content gives the same bytes
_RELATIONS = "http://schemas.openxmlformats.org/package/2006/relationships"
_TYPES = "http://schemas.openxmlformats.org/package/2006/content-types"


def write_shell(path: Path, environment: Mapping[str, Any], files: Mapping[str, bytes]) -> None:
    """Write an environment of shells and submodels, ``files`` by their absolute names in the package.

    Raises
    ------
    InputError
        Where the ending is neither ``.json`` nor ``.aasx``, or JSON would lose the files.
    """
    text = json.dumps(environment, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
    if path.suffix == ".json":
        if files:
            raise InputError(f"{path}: JSON cannot hold {', '.join(files)}; write an .aasx package")
        with whole_file(path) as partial:
            partial.write_text(text, encoding="utf-8")
        return
    if path.suffix != ".aasx":
        raise InputError(f"{path}: a shell is written as .json or .aasx; choose one of them")
    with whole_file(path) as partial, zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in _parts(text, files).items():
            archive.writestr(zipfile.ZipInfo(name.lstrip("/"), FIXED), content, zipfile.ZIP_DEFLATED)


def _parts(text: str, files: Mapping[str, bytes]) -> dict[str, bytes]:
    endings = {"rels": "application/vnd.openxmlformats-package.relationships+xml", "json": "application/json",
               "csv": "text/csv"}  # fmt: skip
    defaults = "".join(f'<Default Extension="{one}" ContentType="{kind}"/>' for one, kind in endings.items())
    types = (
        f'<Types xmlns="{_TYPES}">{defaults}<Override PartName="/aasx/aasx-origin" ContentType="text/plain"/></Types>'
    )
    return {
        "/[Content_Types].xml": _document(types),
        "/_rels/.rels": _document(_relations([(ORIGIN, "/aasx/aasx-origin")])),
        "/aasx/aasx-origin": b"Intentionally empty.",
        "/aasx/_rels/aasx-origin.rels": _document(_relations([(SPECIFICATION, "/aasx/shell.aas.json")])),
        "/aasx/shell.aas.json": text.encode(),
        "/aasx/_rels/shell.aas.json.rels": _document(_relations([(SUPPLEMENT, name) for name in files])),
        **files,
    }


def _relations(targets: list[tuple[str, str]]) -> str:
    rows = "".join(f'<Relationship Id="R{number}" Type={quoteattr(kind)} Target={quoteattr(target)}/>'
                   for number, (kind, target) in enumerate(targets, start=1))  # fmt: skip
    return f'<Relationships xmlns="{_RELATIONS}">{rows}</Relationships>'


def _document(body: str) -> bytes:
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{body}\n'.encode()
