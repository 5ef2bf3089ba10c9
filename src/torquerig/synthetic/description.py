"""The YAML file of a mixture, and of faults that are drawn into a recording."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from pydantic import BaseModel, ConfigDict, TypeAdapter

from torquerig.document import Document, parse_document, read_document, validated
from torquerig.errors import InputError, UnknownNameError, did_you_mean
from torquerig.scenario.overrides import EditedDocument
from torquerig.synthetic.faults.drawn_fault import DrawnFault
from torquerig.synthetic.faults.registry import BY_NAME, AnyFault
from torquerig.synthetic.mixture import Mixture

MIXTURE: TypeAdapter[Mixture] = TypeAdapter(Mixture)


class FaultList(BaseModel):
    """A file that lists faults alone."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    faults: tuple[AnyFault, ...]


FAULT_LIST: TypeAdapter[FaultList] = TypeAdapter(FaultList)


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


def read_faults(path: Path, *, in_a_line: bool = False) -> tuple[DrawnFault, ...]:
    """Return the faults that a file lists under ``faults:``.

    Parameters
    ----------
    path : Path
    in_a_line : bool
        True for a rig that moves in a line: sizes in N instead of N*m.

    Raises
    ------
    InputError
        With file, line and key for everything that cannot be read.
    """
    document = read_document(path)
    if not isinstance(document.data, dict) or not document.data.get("faults"):
        raise InputError(
            f"{document.place()}: lists no faults; write faults: with one entry each, such as "
            "- {type: spikes, height: 0.5 N*m}"
        )
    if "components" in document.data:
        raise InputError(f"{document.place(('components',))}: describes a mixture; use torquerig synth mixture {path}")
    return validated(document, FAULT_LIST, context={"in_a_line": in_a_line}).faults


def named_fault(name: str, settings: Sequence[str], *, in_a_line: bool = False) -> DrawnFault:
    """Return the fault ``name`` with ``parameter=value`` for each of ``settings``.

    Raises
    ------
    UnknownNameError
        For an unknown fault.
    InputError
        For a setting that cannot be read.
    """
    if name not in BY_NAME:
        raise UnknownNameError(f"there is no fault {name!r}; {did_you_mean(name, BY_NAME)}")
    plain = parse_document(f"type: {name}", Path(name))
    data, edits = dict(plain.data), []
    for setting in settings:
        key, equals, text = (part.strip() for part in setting.partition("="))
        if not equals or not key or not text:
            example = next(iter(BY_NAME[name].parameters()))
            raise InputError(
                f"--set {setting}: not of the form parameter=value; write for example --set '{example}=...'"
            )
        data[key] = parse_document(text, Path(f"--set {setting}")).data
        edits.append(((key,), setting))
    document = EditedDocument(plain.path, data, plain.node, tuple(edits))
    return validated(document, TypeAdapter(BY_NAME[name]), context={"in_a_line": in_a_line})
