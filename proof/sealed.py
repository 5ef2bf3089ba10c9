"""How are answers kept until the diagnoses are in? Written apart, their hash printed first and checked when opened."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

from proof.errors import ProofError

SEAL = "seal.txt"
ANSWERS = "sealed/answers.json"


def seal(answers: dict[str, Any], folder: Path, *, apart: Path | None = None) -> str:
    """Write the answers and their seal, and give the seal: the SHA-256 of the file of answers.

    Parameters
    ----------
    answers : dict
        One entry per case.
    folder : Path
        Of the trials; the seal is written here.
    apart : Path, optional
        File to write the answers to; without it they go into the folder's ``sealed/``.
    """
    path = folder / ANSWERS if apart is None else apart
    if path.exists() or (folder / SEAL).exists():
        raise ProofError(f"{folder}: there are sealed answers already; choose another folder")
    path.parent.mkdir(parents=True, exist_ok=True)
    folder.mkdir(parents=True, exist_ok=True)
    written = _text(answers)
    path.write_bytes(written)
    digest = hashlib.sha256(written).hexdigest()
    (folder / SEAL).write_text(digest + "\n", encoding="ascii")
    return digest


def seal_of(answers: dict[str, Any]) -> str:
    """Give the seal that these answers would have, without writing anything."""
    return hashlib.sha256(_text(answers)).hexdigest()


def _text(answers: dict[str, Any]) -> bytes:
    """Give the file of answers, the same bytes for the same answers."""
    return json.dumps(answers, indent=1, sort_keys=True).encode()


def unseal(folder: Path, *, apart: Path | None = None) -> dict[str, Any]:
    """Open the answers, if they are still those that were sealed.

    Raises
    ------
    ProofError
        If there are none, or if they were changed after they had been sealed.
    """
    path = folder / ANSWERS if apart is None else apart
    for needed in (path, folder / SEAL):
        if not needed.is_file():
            raise ProofError(f"{needed}: not found; make the trials first with python -m proof.make")
    written = path.read_bytes()
    digest, sealed = hashlib.sha256(written).hexdigest(), (folder / SEAL).read_text(encoding="ascii").strip()
    if digest != sealed:
        raise ProofError(f"{path}: changed after it was sealed (SHA-256 {digest[:12]}..., sealed {sealed[:12]}...)")
    answers: dict[str, Any] = json.loads(written)
    return answers
