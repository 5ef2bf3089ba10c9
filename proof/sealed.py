"""Sealed answers: written with a SHA-256 that is printed before any diagnosis and checked when they are opened."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

from proof.errors import ProofError

SEAL = "seal.txt"
ANSWERS = "sealed/answers.json"


def seal(answers: dict[str, Any], folder: Path, *, apart: Path | None = None) -> str:
    """Write the answers and return their seal, the SHA-256 of the file.

    Parameters
    ----------
    answers : dict
        One entry per case.
    folder : Path
        Folder of the trials; the seal is written here.
    apart : Path, optional
        File of the answers; default: in ``sealed/`` of the folder.
    """
    path = folder / ANSWERS if apart is None else apart
    if path.exists() or (folder / SEAL).exists():
        raise ProofError(f"{folder}: the folder already holds sealed answers; choose another folder")
    path.parent.mkdir(parents=True, exist_ok=True)
    folder.mkdir(parents=True, exist_ok=True)
    written = _text(answers)
    path.write_bytes(written)
    digest = hashlib.sha256(written).hexdigest()
    (folder / SEAL).write_text(digest + "\n", encoding="ascii")
    return digest


def seal_of(answers: dict[str, Any]) -> str:
    """Return the seal of the answers without writing them."""
    return hashlib.sha256(_text(answers)).hexdigest()


def _text(answers: dict[str, Any]) -> bytes:
    """Return the bytes of the answers; the same answers give the same bytes."""
    return json.dumps(answers, indent=1, sort_keys=True).encode()


def unseal(folder: Path, *, apart: Path | None = None) -> dict[str, Any]:
    """Return the answers after a check against their seal.

    Raises
    ------
    ProofError
        If there are none, or if they were changed after sealing.
    """
    path = folder / ANSWERS if apart is None else apart
    for needed in (path, folder / SEAL):
        if not needed.is_file():
            raise ProofError(f"{needed}: not found; make the trials first with python -m proof.make")
    written = path.read_bytes()
    digest, sealed = hashlib.sha256(written).hexdigest(), (folder / SEAL).read_text(encoding="ascii").strip()
    if digest != sealed:
        raise ProofError(
            f"{path}: the file changed after it was sealed (SHA-256 {digest[:12]}..., sealed {sealed[:12]}...)"
        )
    answers: dict[str, Any] = json.loads(written)
    return answers
