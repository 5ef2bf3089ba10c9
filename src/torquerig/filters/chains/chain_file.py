"""Reading of the filter chains of a YAML file, for one motor and gearbox."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.document import Document, read_document, validated
from torquerig.errors import InputError
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.chains.renamed_chains import current_chain

if TYPE_CHECKING:
    from torquerig.filters.chains.stage_form import StageForm
    from torquerig.filters.load_response import LoadResponse
    from torquerig.orders.kinematics.kinematic_lines import Kinematics

    Stages = tuple[StageForm, ...]


def read_chains(
    source: Document | Path,
    *,
    kinematics: Kinematics,
    response: LoadResponse | None = None,
    within: tuple[str, ...] = ("filters",),
) -> Mapping[str, Chain]:
    """Return the chains under the key ``filters`` by name, in the order of the file, for one drive.

    Parameters
    ----------
    source : Document or Path
        ``filters: {NAME: [{type: ideal_bandstop, lines: {motor: 1..4}, half_width: 0.5 Hz}, ...], ...}``
    kinematics : Kinematics
        Poles, slots, ratio and teeth, which determine the lines' orders.
    response : LoadResponse, optional
        The rig's response from load to sensor; without it, ``load_inverse`` stages are left out.
    within : tuple of str
        The keys under which the chains are in the document.

    Raises
    ------
    InputError
        With file, line, key and remedy for everything that cannot be read.
    """
    texts = chain_texts(source, within=within)
    return {name: made_chain(name, stages, kinematics=kinematics, response=response) for name, stages in texts.items()}


def chain_texts(source: Document | Path, *, within: tuple[str, ...] = ("filters",)) -> Mapping[str, Stages]:
    """Return the stages of each chain as they are stated, for any drive; InputError as :func:`read_chains`."""
    from torquerig.filters.chains.chain_schema import CHAINS

    document = source if isinstance(source, Document) else read_document(source)
    data = document.data
    for depth, key in enumerate(within):
        if not isinstance(data, Mapping) or key not in data:
            raise InputError(f"{document.place(within[:depth])}: the key {key!r} is missing; add it with the chains")
        data = data[key]
    texts = {}
    for written, stages in validated(document, CHAINS, within=within).items():
        name = current_chain(written)
        if name != written and name in data:
            raise InputError(f"{document.place(within)}: {written} is the old name of {name}; keep one of them")
        texts[name] = tuple(stages)
    return texts


def made_chain(name: str, texts: Stages, *, kinematics: Kinematics, response: LoadResponse | None = None) -> Chain:
    """Return a chain for one drive; see :func:`read_chains` for the parameters."""
    made = [text.made_for(kinematics, response) for text in texts]
    left_out = dict.fromkeys(word for _, words in made for word in words)
    return Chain(name=name, stages=tuple(stage for stage, _ in made), left_out=tuple(left_out))


def needs_response(document: Document, names: Iterable[str], *, within: tuple[str, ...] = ("filters",)) -> bool:
    """Return whether any of the named chains needs the rig's response, whose computation takes half a second."""
    data = document.data
    for key in within:
        data = data.get(key) if isinstance(data, Mapping) else None
    return isinstance(data, Mapping) and any("load_inverse" in str(data.get(name)) for name in names)
