"""A mixture's YAML file."""

from __future__ import annotations

from pathlib import Path

from pydantic import TypeAdapter

from torquerig.document import Document, read_document, validated
from torquerig.errors import InputError
from torquerig.synthetic.mixture import Mixture

MIXTURE: TypeAdapter[Mixture] = TypeAdapter(Mixture)


def read_mixture(source: Document | Path) -> Mixture:
    """Return the mixture that a file describes.

    Raises
    ------
    InputError
        With file, line and key for everything that cannot be read.
    """
    document = source if isinstance(source, Document) else read_document(source)
    if not isinstance(document.data, dict) or "components" not in document.data:
        raise InputError(
            f"{document.place()}: is no mixture; write synthetic: NAME, duration: 10 s, and components: with one entry "
            "each, such as mains: {type: sine, frequency: 50 Hz, amplitude: 10 mN*m}"
        )
    return validated(document, MIXTURE)
